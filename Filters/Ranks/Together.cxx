// SPDX-License-Identifier: GPL-3.0-or-later
#include "Ranks/Together.h"

#include "Common/Error.h"

#include <vtkMultiProcessController.h>

#include <algorithm>
#include <exception>
#include <vector>

namespace vtkInsideOut
{
using insideout::Error;
using insideout::ErrorCode;

namespace
{
constexpr int NoError = -1;

/** Gather the value of each rank; all ranks have to call it. */
std::vector<int> AllSay(int own, vtkMultiProcessController* controller)
{
  std::vector<int> all(controller->GetNumberOfProcesses());
  controller->AllGather(&own, all.data(), 1);
  return all;
}

/** The ranks whose value satisfies `means`. */
template <typename Meaning>
std::string RanksThat(const std::vector<int>& all, const Meaning& means)
{
  std::string words;
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    if (means(all[rank]))
    {
      words += (words.empty() ? "" : ", ") + std::to_string(rank);
    }
  }
  return words;
}
} // namespace

std::string RanksThat(bool say, vtkMultiProcessController* controller)
{
  return RanksThat(AllSay(say, controller), [](int said) { return said != 0; });
}

void DoTogether(vtkMultiProcessController* controller, const std::function<void()>& work)
{
  if (!controller)
  {
    work();
    return;
  }
  std::exception_ptr thrown;
  int code = NoError;
  try
  {
    work();
  }
  catch (const Error& error)
  {
    thrown = std::current_exception();
    code = static_cast<int>(error.Code);
  }
  catch (...)
  {
    thrown = std::current_exception();
    code = static_cast<int>(ErrorCode::Inconsistent);
  }
  const std::vector<int> codes = AllSay(code, controller);
  if (thrown)
  {
    std::rethrow_exception(thrown);
  }
  // A stopped rank reports nothing; if another fails, all report that.
  const int stopped = static_cast<int>(ErrorCode::Stopped);
  const auto fails = [&](int said) { return said != NoError && said != stopped; };
  const auto failed = std::find_if(codes.begin(), codes.end(), fails);
  if (failed != codes.end())
  {
    throw Error(static_cast<ErrorCode>(*failed),
      "process " + RanksThat(codes, fails) + " fails, so that there is no output in any process");
  }
  if (std::find(codes.begin(), codes.end(), stopped) != codes.end())
  {
    throw Error(ErrorCode::Stopped, "stopped in another process");
  }
}
} // namespace vtkInsideOut

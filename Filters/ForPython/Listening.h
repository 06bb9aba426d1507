// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Error.h"
#include "Common/Monitor.h"
#include "ForPython/UpdateAlgorithm.h"

#include <exception>
#include <new>
#include <string>

namespace vtkInsideOut
{
/** Reports the progress to a listener, and stops on request. */
class ListeningMonitor : public insideout::Monitor
{
public:
  explicit ListeningMonitor(vtkInsideOutListener listener)
    : Listener(listener)
  {
  }

  bool Continue(const char* stage, double fraction) override
  {
    return this->Listener(VTK_INSIDEOUT_PROGRESS, stage, fraction) == 0;
  }

private:
  vtkInsideOutListener Listener;
};

/** Do some work, and report errors to a listener: Core's errors are complete, other messages are
 * prefixed with `culprit`. */
template <typename Work>
void TellWhatFails(vtkInsideOutListener listener, const std::string& culprit,
  const char* withoutMemory, const Work& work)
{
  const auto fail = [&](const std::string& why) { listener(VTK_INSIDEOUT_ERROR, why.c_str(), 0); };
  try
  {
    work();
  }
  catch (const insideout::Error& error)
  {
    if (error.Code != insideout::ErrorCode::Stopped)
    {
      fail(error.what());
    }
  }
  catch (const std::bad_alloc&)
  {
    fail(culprit + withoutMemory);
  }
  catch (const std::exception& error)
  {
    fail(culprit + error.what());
  }
}
} // namespace vtkInsideOut

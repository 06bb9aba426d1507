// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Stages.h"
#include "Files/SolidReaders.h"
#include "Files/TextScanner.h"

#include <algorithm>
#include <filesystem>
#include <new>

namespace insideout
{
namespace
{
struct SolidFormat
{
  const char* Ending;
  SolidContent (*Read)(const FileContent& file, Monitor& monitor);
};

constexpr SolidFormat Formats[] = {
  { ".msh", ReadMsh },
  { ".inp", ReadInp },
  { ".mesh", ReadMedit },
};
} // namespace

SolidContent ReadSolid(const std::string& path, Monitor& monitor)
{
  const std::string ending = std::filesystem::path(path).extension().string();
  const auto* const format = std::find_if(std::begin(Formats), std::end(Formats),
    [&ending](const SolidFormat& f) { return EqualsIgnoringCase(ending, f.Ending); });
  if (format == std::end(Formats))
  {
    throw Error(ErrorCode::FileUnreadable,
      path + ": the ending is none of .msh, .inp and .mesh, which can be read");
  }
  try
  {
    SolidContent solid = format->Read(LoadFile(path, monitor), monitor);
    monitor.Check(Stages::Reading, 1.0);
    return solid;
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::TooLarge, path + ": does not fit into memory");
  }
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SurfaceFile.h"

#include "Common/MachineMemory.h"
#include "Common/Stages.h"
#include "Files/Gunzip.h"
#include "Files/SurfaceReaders.h"
#include "Files/TextScanner.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <new>
#include <string_view>
#include <system_error>

namespace insideout
{
namespace
{
// Fraction of the time that loading takes; parsing takes the rest.
constexpr double LoadingShare = 0.2;

Error Unreadable(const std::string& path, const std::string& reason)
{
  return Error(ErrorCode::FileUnreadable, path + ": " + reason);
}

/** The length of a file, if it can be loaded. */
std::size_t LengthOf(const std::string& path)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (error)
  {
    throw Unreadable(path, error.message());
  }
  if (!std::filesystem::is_regular_file(status))
  {
    throw Unreadable(
      path, std::filesystem::is_directory(status) ? "is a directory" : "is not a regular file");
  }
  const std::uintmax_t length = std::filesystem::file_size(path, error);
  if (error)
  {
    throw Unreadable(path, error.message());
  }
  return static_cast<std::size_t>(length);
}

/** Fill `content` in chunks, between which the monitor may stop. */
void LoadBytes(const std::string& path, FileContent& content, Monitor& monitor)
{
  constexpr std::size_t piece = std::size_t(1) << 24;
  const std::size_t length = content.Size;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
    std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file)
  {
    throw Unreadable(path, std::generic_category().message(errno));
  }
  for (content.Size = 0; content.Size < length;)
  {
    monitor.Check(Stages::Reading, LoadingShare * double(content.Size) / double(length));
    const std::size_t wanted = std::min(piece, length - content.Size);
    const std::size_t got = std::fread(content.Bytes.get() + content.Size, 1, wanted, file.get());
    content.Size += got;
    if (got < wanted && std::ferror(file.get()))
    {
      throw Unreadable(path, std::generic_category().message(errno));
    }
    if (got < wanted)
    {
      return; // the file was truncated meanwhile
    }
  }
}

void CheckNotEmpty(const FileContent& content)
{
  if (content.Size == 0)
  {
    throw Malformed(content, "is empty");
  }
}

struct Format
{
  const char* Name;
  const char* Ending;
  bool (*HasMark)(const FileContent& file, Monitor& monitor);
  PolygonSurface (*Read)(const FileContent& file, Monitor& monitor);
};

/** Formats with the most reliable marks come first. */
constexpr Format Formats[] = {
  { "PLY", ".ply", [](const FileContent& file, Monitor&) { return IsPly(file); }, ReadPly },
  { "OFF", ".off", IsOff, ReadOff },
  { "STL", ".stl", IsStl, ReadStl },
  { "OBJ", ".obj", IsObj, ReadObj },
};

/** The format by its mark, or else by the name's ending. */
const Format& FormatOf(const FileContent& file, const std::string& ending, Monitor& monitor)
{
  const std::string_view begin(file.Begin(), std::min<std::size_t>(file.Size, 2));
  if (begin == "\xFF\xFE" || begin == "\xFE\xFF")
  {
    throw Malformed(file, "is text in UTF-16; save it in UTF-8");
  }
  for (const Format& format : Formats)
  {
    if (format.HasMark(file, monitor))
    {
      return format;
    }
  }
  for (const Format& format : Formats)
  {
    if (EqualsIgnoringCase(ending, format.Ending))
    {
      return format;
    }
  }
  if (file.TextBegin() != file.End() && *file.TextBegin() == '<')
  {
    throw Malformed(file, "is an XML file; vtkXMLPolyDataReader reads those of VTK");
  }
  std::string endings;
  for (const Format& format : Formats)
  {
    endings += std::string(" ") + format.Ending;
  }
  throw Malformed(file, "neither content nor ending is of" + endings);
}

/** Whether it is the ending of another surface format. */
bool IsOfAnother(const Format& format, const std::string& ending)
{
  const auto is = [&](const char* known) { return EqualsIgnoringCase(ending, known); };
  return !is(format.Ending) &&
    (is(".vtp") || is(".glb") || is(".3mf") ||
      std::any_of(
        std::begin(Formats), std::end(Formats), [&](const Format& f) { return is(f.Ending); }));
}

PolygonSurface ReadCompressedOrNot(
  FileContent file, const std::filesystem::path& path, Monitor& monitor)
{
  std::vector<std::string> warnings;
  const bool isCompressed = IsGzip(file);
  const bool isCalledSo = EqualsIgnoringCase(path.extension().string(), ".gz");
  if (isCompressed)
  {
    constexpr double shareOfMachine = 0.75; // limit for a small file
    file = Gunzip(file, shareOfMachine * MachineMemory(), monitor);
    CheckNotEmpty(file);
  }
  if (isCompressed != isCalledSo)
  {
    warnings.push_back(file.Name +
      (isCompressed ? ": is compressed with gzip, but its name does not end in .gz"
                    : ": is not compressed, but its name ends in .gz"));
  }
  const std::string ending = (isCalledSo ? path.stem() : path).extension().string();
  const Format& format = FormatOf(file, ending, monitor);
  if (IsOfAnother(format, ending))
  {
    warnings.push_back(
      file.Name + ": holds " + format.Name + ", not what its name says, and was read as such");
  }
  PolygonSurface surface = format.Read(file, monitor);
  surface.Warnings.insert(surface.Warnings.begin(), warnings.begin(), warnings.end());
  return surface;
}
} // namespace

PolygonSurface ReadSurface(const std::string& path, Monitor& monitor)
{
  try
  {
    PolygonSurface surface = ReadCompressedOrNot(LoadFile(path, monitor), path, monitor);
    monitor.Check(Stages::Reading, 1.0);
    return surface;
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::TooLarge, path + ": does not fit into memory");
  }
}

FileContent LoadFile(const std::string& path, Monitor& monitor)
{
  FileContent content;
  content.Name = std::filesystem::path(path).filename().string();
  content.Size = LengthOf(path);
  content.Bytes.reset(new char[content.Size]);
  LoadBytes(path, content, monitor);
  CheckNotEmpty(content);
  return content;
}

const char* FileContent::TextBegin() const
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  const bool marked = std::string_view(this->Begin(), this->Size).substr(0, mark.size()) == mark;
  return this->Begin() + (marked ? mark.size() : 0);
}

void FileContent::ReportPosition(const char* at, Monitor& monitor) const
{
  const double part = double(at - this->Begin()) / double(this->Size);
  monitor.Check(Stages::Reading, LoadingShare + (1.0 - LoadingShare) * part);
}

Error Malformed(const FileContent& file, const std::string& what)
{
  return Error(ErrorCode::FileMalformed, file.Name + ": " + what);
}

void CheckCount(const FileContent& file, std::uint64_t count, const char* things)
{
  constexpr std::uint64_t limit = std::numeric_limits<Id>::max();
  if (count > limit)
  {
    throw Error(
      ErrorCode::TooLarge, file.Name + ": has more than " + std::to_string(limit) + " " + things);
  }
}

bool ClosePolygon(const FileContent& file, PolygonSurface& surface)
{
  const auto begin = static_cast<std::size_t>(surface.Offsets.back());
  if (surface.Corners.size() - begin < 3)
  {
    surface.Corners.resize(begin);
    return false;
  }
  CheckCount(file, surface.Corners.size(), "corners of polygons");
  surface.Offsets.push_back(static_cast<Id>(surface.Corners.size()));
  return true;
}

void WarnOfDropped(const FileContent& file, std::uint64_t dropped, PolygonSurface& surface)
{
  if (dropped > 0)
  {
    surface.Warnings.push_back(
      file.Name + ": " + std::to_string(dropped) + " faces with fewer than 3 corners were skipped");
  }
}

void ColorColumn::Add(const std::vector<double>& color)
{
  this->SomeNumbers = this->SomeNumbers || !color.empty();
  this->Components = this->Components ? this->Components : color.size();
  this->Complete = this->Complete && color.size() == this->Components &&
    (this->Components == 3 || this->Components == 4);
  if (this->Complete)
  {
    this->Values.insert(this->Values.end(), color.begin(), color.end());
  }
}

std::optional<Attribute> ColorColumn::ToAttribute() const
{
  if (!this->Complete || !this->SomeNumbers)
  {
    return {};
  }
  const std::optional<std::vector<unsigned char>> bytes = ToColorBytes(this->Values);
  if (!bytes)
  {
    return {};
  }
  return Attribute{ "Colors", static_cast<int>(this->Components), *bytes };
}

std::optional<std::vector<unsigned char>> ToColorBytes(const std::vector<double>& numbers)
{
  const bool inside =
    std::all_of(numbers.begin(), numbers.end(), [](double x) { return x >= 0.0 && x <= 255.0; });
  if (!inside)
  {
    return {};
  }
  const bool unit = std::all_of(numbers.begin(), numbers.end(), [](double x) { return x <= 1.0; });
  std::vector<unsigned char> bytes;
  bytes.reserve(numbers.size());
  for (const double x : numbers)
  {
    bytes.push_back(static_cast<unsigned char>(std::lround(unit ? 255.0 * x : x)));
  }
  return bytes;
}
} // namespace insideout

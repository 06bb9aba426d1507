// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Error.h"
#include "Files/SurfaceFile.h"
#include "Support/TemporaryFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <variant>
#include <vector>

/** Surfaces read from texts as from files, and what is expected of them. */
namespace surfacefilereading
{
using namespace insideout;
using testfiles::TemporaryFile;

inline PolygonSurface Read(const std::string& name, const std::string& content)
{
  const TemporaryFile file(name, content);
  Monitor monitor;
  return ReadSurface(file.Path, monitor);
}

/** The code and message that reading ends with; the message without the file's unique prefix. */
struct Failure
{
  ErrorCode Code;
  std::string Message;
};

inline Failure FailureOf(const std::string& name, const std::string& content)
{
  const TemporaryFile file(name, content);
  Monitor monitor;
  try
  {
    ReadSurface(file.Path, monitor);
  }
  catch (const Error& error)
  {
    std::string message = error.what();
    const std::size_t at = message.find(file.Name);
    return { error.Code,
      at == 0 ? message.substr(file.Name.size() - name.size()) : "no file name: " + message };
  }
  ADD_FAILURE() << name << " was read";
  return { ErrorCode::Inconsistent, "" };
}

inline void ExpectMalformed(
  const std::string& name, const std::string& content, const std::string& message)
{
  const Failure failure = FailureOf(name, content);
  EXPECT_EQ(failure.Code, ErrorCode::FileMalformed) << failure.Message;
  EXPECT_EQ(failure.Message, name + message);
}

inline std::uint64_t Bits(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(x));
  return bits;
}

inline void ExpectSamePoints(const std::vector<Point>& points, const std::vector<Point>& expected)
{
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(Bits(points[p][axis]), Bits(expected[p][axis])) << "point " << p;
    }
  }
}

template <typename T>
const std::vector<T>& ValuesOf(
  const std::vector<Attribute>& attributes, const std::string& name, int components)
{
  static const std::vector<T> none;
  for (const Attribute& attribute : attributes)
  {
    if (attribute.Name == name)
    {
      EXPECT_EQ(attribute.Components, components) << name;
      const std::vector<T>* const values = std::get_if<std::vector<T>>(&attribute.Values);
      EXPECT_NE(values, nullptr) << name << " has another type";
      return values ? *values : none;
    }
  }
  ADD_FAILURE() << "no attribute " << name;
  return none;
}

using Words = std::vector<std::string>;

inline Words NamesOf(const PolygonSurface& surface, const std::string& name)
{
  for (const AttributeNames& names : surface.Names)
  {
    if (names.Name == name)
    {
      return names.Values;
    }
  }
  return {};
}

inline bool HasAttribute(const std::vector<Attribute>& attributes, const std::string& name)
{
  return std::any_of(attributes.begin(), attributes.end(),
    [&name](const Attribute& attribute) { return attribute.Name == name; });
}

inline bool HasWarning(const PolygonSurface& surface, const std::string& text)
{
  return std::any_of(surface.Warnings.begin(), surface.Warnings.end(),
    [&text](const std::string& warning) { return warning.find(text) != std::string::npos; });
}
} // namespace surfacefilereading

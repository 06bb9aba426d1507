// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"
#include "Defects/SurfaceDefects.h"
#include "Output/BoundaryTriangles.h"
#include "Output/MassProperties.h"
#include "Output/Outliers.h"
#include "Output/Topology.h"
#include "Planar/CurveDefects.h"
#include "Planar/PlanarOutputs.h"
#include "Support/StageHashes.h"

#include <cstring>

/** A hash of bytes (FNV-1a); numbers go in one by one, for structs have gaps. */
class Hash
{
public:
  template <typename Number>
  auto operator<<(Number number)
    -> std::enable_if_t<std::is_arithmetic_v<Number> || std::is_enum_v<Number>, Hash&>
  {
    unsigned char bytes[sizeof(number)];
    std::memcpy(bytes, &number, sizeof(number));
    for (const unsigned char byte : bytes)
    {
      this->Value = (this->Value ^ byte) * 0x100000001b3;
    }
    return *this;
  }

  template <typename T, std::size_t N>
  Hash& operator<<(const std::array<T, N>& array)
  {
    for (const T& item : array)
    {
      *this << item;
    }
    return *this;
  }

  template <typename T>
  Hash& operator<<(const std::vector<T>& array)
  {
    *this << array.size();
    for (const T& item : array)
    {
      *this << item;
    }
    return *this;
  }

  Hash& operator<<(const std::string& text)
  {
    return *this << std::vector(text.begin(), text.end());
  }

  /** A figure, unless it is a time. */
  Hash& operator<<(const std::pair<std::string, double>& figure)
  {
    return figure.first.rfind("Seconds", 0) == 0 ? *this : *this << figure.first << figure.second;
  }

  Hash& operator<<(const insideout::FacetSource& source)
  {
    return *this << source.Triangle << source.Reversed;
  }
  Hash& operator<<(const insideout::PointOrigin& origin)
  {
    return *this << origin.Points << origin.Weights;
  }
  Hash& operator<<(const insideout::BoundaryTriangle& face)
  {
    return *this << face.Corners << face.Source;
  }
  Hash& operator<<(const insideout::BoundaryFace& face)
  {
    return *this << face.Corners << face.Facet;
  }
  Hash& operator<<(const insideout::DefectLine& line) { return *this << line.Type << line.Points; }
  Hash& operator<<(const insideout::OutlierPiece& piece)
  {
    return *this << piece.Corners << piece.Facet << piece.Reason;
  }
  Hash& operator<<(const insideout::TriangleDefects& triangle)
  {
    return *this << triangle.Component << triangle.Shell << triangle.SelfIntersections
                 << triangle.Degenerate << triangle.Duplicate << triangle.Inconsistent
                 << triangle.TwoSided << triangle.Turned << triangle.Sheet;
  }
  Hash& operator<<(const insideout::BodyCount& count) { return *this << count.Body << count.Count; }
  Hash& operator<<(const insideout::MassProperties& mass)
  {
    return *this << mass.Volume << mass.CenterOfMass << mass.Inertia;
  }
  Hash& operator<<(const insideout::BettiNumbers& numbers)
  {
    return *this << numbers.Components << numbers.Tunnels << numbers.Cavities;
  }

  Hash& operator<<(const insideout::SegmentSource& source)
  {
    return *this << source.Segment << source.Reversed;
  }
  Hash& operator<<(const insideout::BoundaryEdge& edge)
  {
    return *this << edge.Ends << edge.Segment << edge.IsAlong;
  }
  Hash& operator<<(const insideout::OutlierSegment& outlier)
  {
    return *this << outlier.Segment << outlier.Reason;
  }
  Hash& operator<<(const insideout::SegmentDefects& segment)
  {
    return *this << segment.Component << segment.SelfIntersections << segment.Degenerate
                 << segment.Duplicate;
  }
  Hash& operator<<(const insideout::CurveDefectPoint& point)
  {
    return *this << point.Place << point.InputPoint << point.Type;
  }
  Hash& operator<<(const insideout::AreaProperties& area)
  {
    return *this << area.Area << area.Center;
  }

  std::uint64_t Value = 0xcbf29ce484222325;
};

/** Add one hash of several outputs. */
template <typename... Outputs>
void AddHash(const std::string& name, Hashes& hashes, const Outputs&... outputs)
{
  hashes[name] = (Hash() << ... << outputs).Value;
}

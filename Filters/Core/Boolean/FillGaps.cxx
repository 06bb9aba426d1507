// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/FillGaps.h"

#include "Common/Box.h"
#include "Common/ChunkedLoop.h"
#include "Common/DisjointSets.h"
#include "Common/ScaledPoints.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Distance/StaysNear.h"
#include "Output/InsideBoundary.h"
#include "Output/MassProperties.h"

#include <algorithm>
#include <memory>
#include <set>
#include <sstream>

namespace insideout
{
namespace
{
const ProgressRange Progress = { Stages::Extracting, 0, 0 };

/** The boundary of a body's cells. */
struct BodyBoundary
{
  std::vector<Triangle> Facets;
  std::unique_ptr<SurfaceDistance> Distances; ///< null if the body has no cells
};

/** The intersection of two sorted lists, sorted. */
std::vector<Id> Common(const std::vector<Id>& a, const std::vector<Id>& b)
{
  std::vector<Id> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

class GapFiller
{
public:
  GapFiller(const TetrahedralMesh& mesh, double tolerance, const std::vector<Id>& order,
    std::vector<std::vector<unsigned char>>& inside, Monitor& monitor)
    : Mesh(mesh)
    , Order(order)
    , Inside(inside)
    , Watch(monitor)
    , Exponent(LargestExponent(mesh.Points))
    , Points(ScaledPoints(mesh.Points, -this->Exponent))
    , Tolerance(PowerOfTwo(-this->Exponent).Times(tolerance))
    , GapOf(mesh.Cells.size(), None)
  {
  }

  FilledGaps Fill();

private:
  BodyBoundary BoundaryOf(Id body) const;
  std::vector<Id> PointsOfGaps(const Box& box) const;
  void KeepThoseWithCornersNear(Id body, const BodyBoundary& boundary);
  void KeepThoseThatStayNear(const std::vector<BodyBoundary>& boundaries);
  void JoinGaps();
  Id NewBodyOf(Id gapCell);

  const TetrahedralMesh& Mesh;
  const std::vector<Id>& Order;
  std::vector<std::vector<unsigned char>>& Inside;
  Monitor& Watch;
  const int Exponent;
  const std::vector<Point> Points; ///< scaled to below 1, like the tolerance
  const double Tolerance;

  std::vector<Id> Cells;             ///< that may lie in a gap
  std::vector<std::vector<Id>> Near; ///< per cell of these, the bodies near it, ascending
  std::vector<Id> GapOf;             ///< per cell of the mesh, its index in Cells, or None
  std::vector<std::set<Id>> Beside;  ///< for the first cell of each part of a gap, bodies beside it
  DisjointSets Parts{ 0 };
};

BodyBoundary GapFiller::BoundaryOf(Id body) const
{
  BodyBoundary boundary;
  for (const BoundaryFace& face :
    BoundaryFaces(this->Mesh, this->Inside[body], this->Watch, Progress))
  {
    boundary.Facets.push_back(face.Corners);
  }
  if (!boundary.Facets.empty())
  {
    boundary.Distances = std::make_unique<SurfaceDistance>(this->Points, boundary.Facets);
  }
  return boundary;
}

/** The corners of Cells that lie in a box. */
std::vector<Id> GapFiller::PointsOfGaps(const Box& box) const
{
  std::vector<char> isCorner(this->Points.size(), 0);
  for (const Id cell : this->Cells)
  {
    for (const Id p : this->Mesh.Cells[cell])
    {
      isCorner[p] = box.Holds(this->Points[p]);
    }
  }
  std::vector<Id> points;
  for (std::size_t p = 0; p < isCorner.size(); ++p)
  {
    if (isCorner[p])
    {
      points.push_back(static_cast<Id>(p));
    }
  }
  return points;
}

void GapFiller::KeepThoseWithCornersNear(Id body, const BodyBoundary& boundary)
{
  if (!boundary.Distances)
  {
    return;
  }
  Box box = Box::Empty();
  for (const Triangle& facet : boundary.Facets)
  {
    box.Add(BoundingBox(this->Points, facet));
  }
  const std::vector<Id> points = this->PointsOfGaps(box.Widened(this->Tolerance));
  std::vector<Point> places;
  for (const Id p : points)
  {
    places.push_back(this->Points[p]);
  }
  const std::vector<SurfaceDistance::Nearest> nearest =
    boundary.Distances->At(places, this->Watch, Progress);
  std::vector<char> isNear(this->Points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    isNear[points[i]] = nearest[i].Distance <= this->Tolerance;
  }
  for (std::size_t i = 0; i < this->Cells.size(); ++i)
  {
    const Tetrahedron& corners = this->Mesh.Cells[this->Cells[i]];
    if (std::all_of(corners.begin(), corners.end(), [&](Id p) { return isNear[p] != 0; }))
    {
      this->Near[i].push_back(body);
    }
  }
}

void GapFiller::KeepThoseThatStayNear(const std::vector<BodyBoundary>& boundaries)
{
  const double nanosecondsPerCell = 20000;
  ChunkedLoop(static_cast<Id>(this->Cells.size()), nanosecondsPerCell, this->Watch, Progress,
    [&](Id i)
    {
      std::vector<Id>& near = this->Near[i];
      if (near.size() < 2)
      {
        near.clear();
        return;
      }
      const std::array<Point, 4> cell = CornersOf(this->Points, this->Mesh.Cells[this->Cells[i]]);
      near.erase(std::remove_if(near.begin(), near.end(),
                   [&](Id body)
                   {
                     return !StaysNear(cell, this->Points, boundaries[body].Facets,
                       *boundaries[body].Distances, this->Tolerance);
                   }),
        near.end());
    });
}

/**
 * Join cells through faces if they are near the same two bodies, and find the bodies that have
 * faces on each joined part.
 */
void GapFiller::JoinGaps()
{
  this->Parts = DisjointSets(this->Cells.size());
  this->Beside.assign(this->Cells.size(), {});
  const auto forNeighbors = [&](const auto& visit)
  {
    for (std::size_t i = 0; i < this->Cells.size(); ++i)
    {
      for (const Id beyond : this->Mesh.Neighbors[this->Cells[i]])
      {
        if (beyond != None && this->Near[i].size() >= 2)
        {
          visit(static_cast<Id>(i), beyond);
        }
      }
    }
  };
  forNeighbors(
    [&](Id i, Id beyond)
    {
      const Id other = this->GapOf[beyond];
      if (other != None && Common(this->Near[i], this->Near[other]).size() >= 2)
      {
        this->Parts.Join(i, other);
      }
    });
  forNeighbors(
    [&](Id i, Id beyond)
    {
      for (std::size_t body = 0; body < this->Inside.size(); ++body)
      {
        if (this->Inside[body][beyond] != 0)
        {
          this->Beside[this->Parts.Find(i)].insert(static_cast<Id>(body));
        }
      }
    });
}

/** The last of the bodies that a cell lies between; None if there are fewer than two. */
Id GapFiller::NewBodyOf(Id gapCell)
{
  const std::set<Id>& beside = this->Beside[this->Parts.Find(gapCell)];
  const std::vector<Id> between =
    Common(this->Near[gapCell], std::vector<Id>(beside.begin(), beside.end()));
  const auto last =
    std::find_first_of(this->Order.rbegin(), this->Order.rend(), between.begin(), between.end());
  return between.size() < 2 || last == this->Order.rend() ? None : *last;
}

FilledGaps GapFiller::Fill()
{
  for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
  {
    if (std::all_of(this->Inside.begin(), this->Inside.end(),
          [&](const std::vector<unsigned char>& body) { return body[cell] == 0; }))
    {
      this->GapOf[cell] = static_cast<Id>(this->Cells.size());
      this->Cells.push_back(cell);
    }
  }
  this->Near.resize(this->Cells.size());
  std::vector<BodyBoundary> boundaries;
  for (Id body = 0; body < static_cast<Id>(this->Inside.size()); ++body)
  {
    boundaries.push_back(this->BoundaryOf(body));
    this->KeepThoseWithCornersNear(body, boundaries.back());
  }
  this->KeepThoseThatStayNear(boundaries);
  this->JoinGaps();

  FilledGaps filled;
  std::vector<unsigned char> isFilled(this->Mesh.Cells.size(), 0);
  for (std::size_t i = 0; i < this->Cells.size(); ++i)
  {
    const Id body = this->NewBodyOf(static_cast<Id>(i));
    if (body != None)
    {
      this->Inside[body][this->Cells[i]] = 1;
      isFilled[this->Cells[i]] = 1;
      ++filled.Cells;
    }
  }
  filled.Volume = filled.Cells > 0 ? MeasureMass(this->Mesh, isFilled).Volume : 0;
  return filled;
}
} // namespace

FilledGaps FillGaps(const TetrahedralMesh& mesh, double tolerance, const std::vector<Id>& order,
  std::vector<std::vector<unsigned char>>& inside, Monitor& monitor)
{
  return GapFiller(mesh, tolerance, order, inside, monitor).Fill();
}

void AddFilledGaps(
  const FilledGaps& filled, Statistics& statistics, std::vector<std::string>& warnings)
{
  statistics.emplace_back("GapCells", filled.Cells);
  statistics.emplace_back("GapVolume", filled.Volume);
  if (filled.Cells > 0)
  {
    std::ostringstream line;
    line << "gaps between bodies that are narrower than the merge tolerance were closed by "
         << filled.Cells << (filled.Cells == 1 ? " cell" : " cells") << " of a volume of "
         << filled.Volume;
    warnings.push_back(line.str());
  }
}
} // namespace insideout

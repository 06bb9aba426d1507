// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Planar/FindPlane.h"
#include "Planar/PlanarCurve.h"
#include "Refine/RefinableTriangles.h"
#include "Refine/RefineTetrahedra.h"

#include <algorithm>
#include <queue>
#include <tuple>
#include <vector>

namespace insideout
{
/**
 * Ruppert's Delaunay refinement (1995) of the triangles inside a curve: it inserts points into
 * triangles that are too large or too thin, the longest first (see RefineTriangles). Constraints
 * are the boundary and all segments at inside cells.
 */
class PlanarRefiner
{
public:
  PlanarRefiner(const SegmentComplex& curve, const PlanarMesh& mesh,
    const std::vector<unsigned char>& inside, const Plane& plane,
    const RefinementParameters& parameters, Monitor& monitor);

  /** @throws Error TooLarge if there would be more cells than can be counted, Stopped */
  void Run();

  const RefinableTriangles& Result() const { return this->Mesh; }

  /** Number of triangles larger than the wanted largest area. */
  Id CountLargeCells() const;

  /** Number of triangles with an edge much longer than wanted. */
  Id CountLongCells() const;

  /** Whether the limit of points stopped it. */
  bool RanOut() const { return this->HasRunOut; }

  /** Number of points inserted on constraints. */
  Id SurfacePoints() const
  {
    return static_cast<Id>(std::count_if(
      this->InputEdges.begin(), this->InputEdges.end(), [](Id edge) { return edge != None; }));
  }

private:
  using Place = RefinableTriangles::Place;

  /** A triangle, or one of its constraints, to check. */
  struct Task
  {
    double Length; ///< longest first
    Place At;
    Id Version;
    bool operator<(const Task& other) const
    {
      return std::tie(this->Length, other.At.Cell, other.At.Edge) <
        std::tie(other.Length, this->At.Cell, this->At.Edge);
    }
  };

  double Length(Id a, Id b) const
  {
    return this->Mesh.Metric().Distance(this->Mesh.Points()[a], this->Mesh.Points()[b]);
  }
  Segment EndsOf(const Place& edge) const
  {
    return EdgeOf(this->Mesh.Cells()[edge.Cell].Corners, edge.Edge);
  }

  void FindSizes();
  void FindSharpCorners();
  double SizeAt(Id cell, const PlanarPoint& place) const;
  double EstimatedCells() const;
  void Push(Id cell);
  void PushChanged();
  void LookAtConstraint(const Task& task);
  void LookAtTriangle(const Task& task);
  void Insert(Id cell, const PlanarPoint& place);
  bool IsEncroached(const Segment& ends, const PlanarPoint& place) const;
  bool IsRoomy(Id cell, const PlanarPoint& place, double spacing, double leastAngle) const;
  bool IsAcrossSharpCorner(Id u, Id v, const Triangle& corners) const;
  bool SplitConstraint(const Place& edge, double leastHalf);
  bool MakeWay(const Place& at, const PlanarPoint& center, double leastHalf, bool& isBlocked);
  Id InputEdge(Id source) const;
  Segment EndsOfInputEdge(Id edge) const { return EdgeOf(this->Input.Cells[edge / 3], edge % 3); }
  bool IsSharp(Id point) const
  {
    return point < static_cast<Id>(this->Sharp.size()) && this->Sharp[point] != 0;
  }

  const PlanarMesh& Input;
  RefinableTriangles Mesh;
  const RefinementParameters& Parameters;
  Monitor& Watch;
  const bool IsSplit;
  const double EdgeLength; ///< wanted area, 0 for none
  const double MostArea;
  double Most;                ///< limit of edge lengths
  std::vector<double> Sizes;  ///< per point, the required edge length there
  std::vector<char> Sharp;    ///< per point of the input
  std::vector<Id> InputEdges; ///< per point, the constraint of the input that it splits
  std::priority_queue<Task> Tasks;
  bool HasRunOut = false;
};
} // namespace insideout

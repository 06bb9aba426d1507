// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/PlanarLayers.h"

#include "Common/BoxTree.h"
#include "Common/Error.h"
#include "Common/NearestPoint.h"
#include "Common/PartMonitor.h"
#include "Common/SortUniquely.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Layers/LayerColumns.h"
#include "Layers/LayerHeights.h"
#include "Layers/PlanarWall.h"
#include "Planar/TriangleLocator.h"
#include "Planar/TriangulateHull.h"
#include "Planar/WindingNumberOfTriangles.h"
#include "Refine/RefineTriangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace insideout
{
namespace
{
/** Points behind the layers stay if they are as far as this share of their edges' mean length. */
constexpr double LeastShareOfLength = 0.5;

/** Refuse more points than ids can count, with room for the ids of edges. */
void CheckSize(const std::vector<PlanarPoint>& points, const std::vector<Id>& wall, int layers)
{
  constexpr double most = std::numeric_limits<Id>::max() / 16.0;
  const double all =
    static_cast<double>(points.size()) + 2.0 * static_cast<double>(wall.size()) * layers;
  if (all > most)
  {
    throw Error(ErrorCode::TooLarge,
      std::to_string(layers) + " layers make more points than " +
        std::to_string(std::llround(most)));
  }
}

class PlanarLayerMaker
{
public:
  PlanarLayerMaker(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh,
    const std::vector<Id>& wall, const Plane& plane, const LayerParameters& parameters,
    Monitor& monitor)
    : Mesh(mesh)
    , WallEdges(wall)
    , OfPlane(plane)
    , Parameters(parameters)
    , Caller(monitor)
    , Watch(monitor, { Stages::Layering, 0.5, 0.5 })
    , Fractions(FractionsOfLayers(parameters.Layers, parameters.Growth))
    , Pushed(PushPlanarWall(points, mesh, wall, plane.Metric, parameters, monitor))
    , Locator(points, mesh)
  {
  }

  PlanarLayeredMesh Make()
  {
    this->RefineBehind();
    this->Caller.Check(Stages::Layering, 0.9);
    this->AddPoints();
    this->AddCells();
    this->AddBoundary();
    this->AddStatistics();
    this->Caller.Check(Stages::Layering, 1);
    return std::move(this->Result);
  }

private:
  // The triangles behind.

  /** Points of the input that are at no constraint, and not close to the moved wall. */
  std::vector<Id> FreePoints(const std::vector<SegmentBehind>& segments) const
  {
    std::vector<char> isFree(this->Pushed.NumberOfPoints(), 0);
    std::vector<double> sums(this->Pushed.NumberOfPoints(), 0);
    std::vector<int> counts(this->Pushed.NumberOfPoints(), 0);
    for (const Triangle& cell : this->Mesh.Cells)
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto [a, b] = EdgeOf(cell, k);
        isFree[a] = 1;
        for (const Id p : { a, b })
        {
          sums[p] += Distance(this->Pushed.Flat[a], this->Pushed.Flat[b]);
          counts[p] += 1;
        }
      }
    }
    for (const PlanarConstraint& constraint : this->Pushed.Rims.Constraints)
    {
      isFree[constraint.Ends[0]] = isFree[constraint.Ends[1]] = 0;
    }
    for (const PlanarRun& run : this->Pushed.Rims.Runs)
    {
      for (const Id p : run.Points)
      {
        isFree[p] = 0;
      }
    }
    std::vector<std::array<Point, 3>> moved; // as triangles without area
    std::vector<Box> boxes;
    for (const SegmentBehind& segment : segments)
    {
      if (segment.Ends[0] >= this->Pushed.NumberOfPoints() ||
        segment.Ends[1] >= this->Pushed.NumberOfPoints())
      {
        const std::vector<Point> ends =
          FlatPoints({ this->Pushed.Places[segment.Ends[0]], this->Pushed.Places[segment.Ends[1]] },
            this->OfPlane.Metric);
        moved.push_back({ { ends[0], ends[1], ends[1] } });
        boxes.push_back(BoundingBox(ends));
      }
    }
    const BoxTree tree(boxes);
    const PlanarMesh halves = this->Pushed.HalvesOfLayers();
    const TriangleLocator layers(this->Pushed.Places, halves);
    std::vector<Id> free;
    for (Id p = 0; p < this->Pushed.NumberOfPoints(); ++p)
    {
      if (isFree[p] == 0 || layers.Find(this->Pushed.Places[p], [](Id) { return true; }) != None)
      {
        continue;
      }
      const double least = LeastShareOfLength * sums[p] / counts[p];
      bool isClose = false;
      tree.Visit(Box{ this->Pushed.Flat[p], this->Pushed.Flat[p] }.Widened(least),
        [&](Id s)
        {
          isClose = isClose ||
            Distance(NearestPointOf(moved[s], this->Pushed.Flat[p]), this->Pushed.Flat[p]) < least;
        });
      if (!isClose)
      {
        free.push_back(p);
      }
    }
    return free;
  }

  void RefineBehind()
  {
    this->Segments = this->Pushed.SegmentsBehind();
    std::vector<Id> used = this->FreePoints(this->Segments);
    for (const SegmentBehind& segment : this->Segments)
    {
      used.insert(used.end(), segment.Ends.begin(), segment.Ends.end());
    }
    SortUniquely(used);
    SegmentComplex curve;
    std::vector<Id> numbers(this->Pushed.Places.size(), None); // per first of equal places
    for (const Id place : used)
    {
      Id& number = numbers[this->Pushed.First(place)];
      if (number == None)
      {
        number = static_cast<Id>(curve.Points.size());
        curve.Points.push_back(this->Pushed.Places[place]);
        curve.Origins.push_back(PointOrigin::Input(place));
      }
    }
    for (std::size_t i = 0; i < this->Segments.size(); ++i)
    {
      const SegmentBehind& segment = this->Segments[i];
      curve.Segments.push_back({ { numbers[this->Pushed.First(segment.Ends[0])],
        numbers[this->Pushed.First(segment.Ends[1])] } });
      curve.Multiplicity.push_back(segment.IsOuter ? 1 : 0);
      curve.Sources.push_back({ static_cast<Id>(i), false });
      curve.SourceOffsets.push_back(static_cast<Id>(curve.Sources.size()));
    }
    curve.NumberOfConstraints = curve.NumberOfSegments();
    const PlanarMesh hull = TriangulateHull(curve, this->OfPlane.Metric, this->Watch);
    std::vector<unsigned char> inside;
    for (const double w : WindingNumberOfTriangles(curve, hull, this->OfPlane.Metric, this->Watch))
    {
      if (w > 1.5)
      {
        const Id place = curve.Origins[hull.Cells[inside.size()][0]].Points[0];
        throw Error(ErrorCode::SelfIntersecting,
          "triangles overlap at point " + std::to_string(this->PointOf(place)));
      }
      inside.push_back(w > 0.5 ? 1 : 0);
    }
    this->Refined = RefineTriangles(curve, hull, inside, this->OfPlane, {}, this->Watch);
  }

  // The result.

  void AddPoint(const PlanarPoint& place, Id original, Id near)
  {
    const Id found = this->Locator.Find(place, [](Id) { return true; });
    this->Result.Points.push_back(place);
    this->Result.OriginalPoints.push_back(original);
    this->Result.CellsOfPoints.push_back(found == None ? near : found);
  }

  void AddPoints()
  {
    std::vector<Id>& numbers = this->Numbers; // per place
    numbers.assign(this->Pushed.Places.size(), None);
    this->FirstBorder.assign(this->Pushed.NumberOfPoints(), None);
    const auto next = [this]() { return static_cast<Id>(this->Result.Points.size()); };
    for (const Id p : this->Pushed.AtWall.Points)
    {
      if (this->Pushed.IsLifted(p))
      {
        const Id near = this->CellNear(this->Pushed.InnerOf[p]);
        numbers[p] = next();
        this->AddPoint(this->Pushed.Places[p], p, near);
        this->FirstBorder[p] = next();
        for (Id border = 1; border < this->Parameters.Layers; ++border)
        {
          this->AddPoint(PlaceOnBorder(this->Pushed.Places[p],
                           this->Pushed.Places[this->Pushed.InnerOf[p]], this->Fractions[border]),
            None, near);
        }
      }
    }
    this->FirstBehind = next();
    const SegmentComplex& curve = this->Refined.Curve;
    for (std::size_t i = 0; i < curve.Points.size(); ++i)
    {
      const PointOrigin& origin = curve.Origins[i];
      const Id place = origin.IsInput() ? origin.Points[0] : None;
      this->PlaceOf.push_back(place);
      if (place != None)
      {
        numbers[place] = next();
      }
      this->AddPoint(curve.Points[i], place < this->Pushed.NumberOfPoints() ? place : None,
        this->CellNear(place));
    }
    this->HasCopies.assign(this->Pushed.Places.size(), 0);
    for (const SegmentBehind& segment : this->Segments)
    {
      for (const Id place : segment.Ends)
      {
        if (numbers[place] == None)
        {
          this->HasCopies[this->Pushed.First(place)] = 1;
          numbers[place] = next();
          this->AddPoint(this->Pushed.Places[place], place, this->CellNear(place));
        }
      }
    }
  }

  /** The point of the input that is at a place, or whose layers end there. */
  Id PointOf(Id place) const
  {
    return place < this->Pushed.NumberOfPoints()
      ? place
      : this->Pushed.OwnerOf[place - this->Pushed.NumberOfPoints()];
  }

  /** A cell of the wall at the point whose layers end at a place; None for other places. */
  Id CellNear(Id place) const
  {
    return place < this->Pushed.NumberOfPoints()
      ? None
      : this->WallEdges[this->Pushed.AtWall.FacetsAt[this->PointOf(place)].begin()[0]] / 3;
  }

  /** The point of the result at a corner of a triangle behind: of several in one place that of the
   * constraint around the corner. */
  Id PointAt(Id cell, int corner) const
  {
    const PlanarMesh& mesh = this->Refined.Mesh;
    const Id point = mesh.Cells[cell][corner];
    const Id place = this->PlaceOf[point];
    if (place == None || this->HasCopies[this->Pushed.First(place)] == 0)
    {
      return point + this->FirstBehind;
    }
    while (mesh.Segments[cell][corner] == None)
    {
      cell = mesh.Neighbors[cell][corner];
      const Triangle& corners = mesh.Cells[cell];
      corner = static_cast<int>(std::find(corners.begin(), corners.end(), point) - corners.begin());
    }
    const SegmentComplex& curve = this->Refined.Curve;
    const Id piece = mesh.Segments[cell][corner];
    const Segment& ends = this->Segments[curve.Sources[curve.SourceOffsets[piece]].Segment].Ends;
    return this->Numbers[ends[curve.Segments[piece][0] == point ? 0 : 1]];
  }

  /** The point of the result on a border of layers at a point of the wall. */
  Id OnBorder(Id point, Id border) const
  {
    if (!this->Pushed.IsLifted(point) || border == 0)
    {
      return this->Numbers[point];
    }
    return border == this->Parameters.Layers ? this->Numbers[this->Pushed.InnerOf[point]]
                                             : this->FirstBorder[point] + border - 1;
  }

  void AddCells()
  {
    std::vector<Id>& cellsOf = this->Result.CellsOfPoints;
    for (Id cell = 0; cell < this->Refined.Mesh.NumberOfCells(); ++cell)
    {
      const Triangle corners = { { this->PointAt(cell, 0), this->PointAt(cell, 1),
        this->PointAt(cell, 2) } };
      // Where rounding puts a point outside all cells, it is near one of a neighbor.
      Id near = None;
      for (const Id p : corners)
      {
        near = near == None ? cellsOf[p] : near;
      }
      for (const Id p : corners)
      {
        cellsOf[p] = cellsOf[p] == None ? std::max(near, 0) : cellsOf[p];
      }
      this->AddCell({ corners.begin(), corners.end() }, std::max(near, 0), 0);
    }
    for (const std::size_t size : { 3, 4 }) // triangles before quads
    {
      for (std::size_t f = 0; f < this->Pushed.Facets.size(); ++f)
      {
        for (Id layer = 1; layer <= this->Parameters.Layers; ++layer)
        {
          const std::vector<Id> corners = this->CornersOf(this->Pushed.Facets[f], layer);
          if (corners.size() == size)
          {
            this->AddCell(corners, this->WallEdges[f] / 3, layer);
          }
        }
      }
    }
  }

  /** The corners of a cell of a layer; two where both ends of the edge have no layers. */
  std::vector<Id> CornersOf(const Segment& facet, Id layer) const
  {
    std::vector<Id> corners = { this->OnBorder(facet[0], layer - 1),
      this->OnBorder(facet[1], layer - 1) };
    for (const Id p : { facet[1], facet[0] })
    {
      if (this->Pushed.IsLifted(p))
      {
        corners.push_back(this->OnBorder(p, layer));
      }
    }
    return corners;
  }

  void AddCell(const std::vector<Id>& corners, Id near, Id layer)
  {
    PlanarPoint middle = { 0, 0 };
    for (const Id p : corners)
    {
      for (int k = 0; k < 2; ++k)
      {
        middle[k] += this->Result.Points[p][k] / static_cast<double>(corners.size());
      }
    }
    const Id found = this->Locator.Find(middle, [](Id) { return true; });
    if (corners.size() == 3)
    {
      this->Result.Triangles.push_back({ { corners[0], corners[1], corners[2] } });
    }
    else
    {
      this->Result.Quads.push_back({ { corners[0], corners[1], corners[2], corners[3] } });
    }
    this->Result.OriginalCells.push_back(found == None ? near : found);
    this->Result.Layers.push_back(layer);
  }

  void AddBoundary()
  {
    std::vector<char> isWall(3 * this->Mesh.Cells.size(), 0);
    for (std::size_t f = 0; f < this->Pushed.Facets.size(); ++f)
    {
      const auto& [a, b] = this->Pushed.Facets[f];
      isWall[this->WallEdges[f]] = 1;
      this->Result.Boundary.push_back(
        { { { this->Numbers[a], this->Numbers[b] } }, this->WallEdges[f] });
    }
    for (const SegmentBehind& segment : this->Segments)
    {
      if (segment.IsOuter && isWall[segment.Edge] == 0)
      {
        this->Result.Boundary.push_back(
          { { { this->Numbers[segment.Ends[0]], this->Numbers[segment.Ends[1]] } }, segment.Edge });
      }
    }
    for (const PlanarRun& run : this->Pushed.Rims.Runs)
    {
      for (Id border = 1; border <= this->Parameters.Layers; ++border)
      {
        const Id first = run.Points.front();
        const Id last = run.Points.back();
        if (run.BeginsAtWall && this->Pushed.IsLifted(first))
        {
          this->Result.Boundary.push_back(
            { { { this->OnBorder(first, border - 1), this->OnBorder(first, border) } },
              run.Edges.front() });
        }
        if (run.EndsAtWall && this->Pushed.IsLifted(last))
        {
          this->Result.Boundary.push_back(
            { { { this->OnBorder(last, border), this->OnBorder(last, border - 1) } },
              run.Edges.back() });
        }
      }
    }
  }

  void AddStatistics()
  {
    Statistics& statistics = this->Result.Statistics;
    const std::size_t behind = this->Refined.Mesh.Cells.size();
    statistics = { { "Layers", this->Parameters.Layers }, { "Quads", this->Result.Quads.size() },
      { "LayerTriangles", this->Result.Triangles.size() - behind },
      { "WallEdges", this->Pushed.Facets.size() } };
    std::vector<double> lengths;
    for (const auto& [a, b] : this->Pushed.Facets)
    {
      lengths.push_back(Distance(this->Pushed.Flat[a], this->Pushed.Flat[b]));
    }
    AppendHeights(SharesOfHeight(this->Pushed.AtWall, this->Pushed.Directions, this->Pushed.Heights,
                    this->Pushed.Height),
      this->Pushed.AtWall, this->Pushed.Facets, lengths, statistics);
    statistics.emplace_back("NarrowPoints", this->Pushed.Narrow);
    statistics.emplace_back("EndPoints",
      std::count_if(this->Pushed.AtWall.Points.begin(), this->Pushed.AtWall.Points.end(),
        [this](Id p) { return this->Pushed.Directions[p].Cosine == 0; }));
    for (const auto& one : this->Refined.Statistics)
    {
      if (one.first == "MinAngle" || one.first == "Angle1Percent" || one.first == "MaxAngle")
      {
        statistics.push_back(one);
      }
    }
  }

  const PlanarMesh& Mesh;
  const std::vector<Id>& WallEdges;
  const Plane& OfPlane;
  const LayerParameters& Parameters;
  Monitor& Caller;
  QuietMonitor Watch;
  const std::vector<double> Fractions;
  const PlanarWall Pushed;
  const TriangleLocator Locator;
  std::vector<SegmentBehind> Segments;
  RefinedTriangles Refined;    ///< a source of a segment is its number among Segments
  std::vector<Id> PlaceOf;     ///< per point of Refined; None for a new one
  std::vector<char> HasCopies; ///< per first of equal places, whether several are used behind
  std::vector<Id> Numbers;     ///< per place, its point of the result
  std::vector<Id> FirstBorder; ///< per point, that of the result on the inner border of layer 1
  Id FirstBehind = 0;          ///< number of the result's points before those of Refined
  PlanarLayeredMesh Result;
};
} // namespace

PlanarLayeredMesh MakePlanarLayers(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh,
  const std::vector<Id>& wall, const Plane& plane, const LayerParameters& parameters,
  Monitor& monitor)
{
  CheckLayerParameters(parameters);
  CheckSize(points, wall, parameters.Layers);
  return PlanarLayerMaker(points, mesh, wall, plane, parameters, monitor).Make();
}
} // namespace insideout

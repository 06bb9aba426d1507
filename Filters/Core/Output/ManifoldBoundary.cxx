// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/ManifoldBoundary.h"

#include "Common/DisjointSets.h"
#include "Common/Edge.h"
#include "Common/LoopProgress.h"

#include <algorithm>
#include <tuple>

namespace insideout
{
namespace
{
/** An edge of a face: from its corner k to the next. */
struct FaceEdge
{
  Edge Ends;
  Id Face;
  int Corner;

  bool operator<(const FaceEdge& other) const
  {
    return std::tie(this->Ends, this->Face, this->Corner) <
      std::tie(other.Ends, other.Face, other.Corner);
  }
};

/** A side of a cell, seen from within the cell. */
struct Side
{
  Id Cell;
  int Face;
};

class Joiner
{
public:
  Joiner(const PartedSolid& solid, const std::vector<BoundaryFace>& faces)
    : Solid(solid)
    , Faces(faces)
    , Corners(3 * faces.size())
  {
  }

  void Join(Monitor& monitor, const ProgressRange& progress);
  ManifoldSurface Number();

private:
  using Group = std::pair<const FaceEdge*, const FaceEdge*>;

  bool Has(Id cell, int face, const Edge& places) const;
  bool IsOf(Id cell, const Edge& ends) const;
  Side TurnAround(Side side, const Edge& places) const;
  const FaceEdge* Find(const Group& group, const Side& side) const;
  const FaceEdge* AcrossOutside(const Group& group, const FaceEdge& edge) const;
  const FaceEdge* AcrossInside(const Group& group, const FaceEdge& edge) const;
  void JoinPair(const FaceEdge& a, const FaceEdge& b);
  void JoinGroup(const Group& group);

  const PartedSolid& Solid;
  const std::vector<BoundaryFace>& Faces;
  DisjointSets Corners; ///< 3 for each face
};

/** Whether a face of a cell has an edge, comparing places. */
bool Joiner::Has(Id cell, int face, const Edge& places) const
{
  int found = 0;
  for (const Id corner : FaceOf(this->Solid.Mesh.Cells[cell], face))
  {
    const Id place = this->Solid.Places[corner];
    found += place == places[0] || place == places[1];
  }
  return found == 2;
}

/** Whether the edge is one of a cell inside. */
bool Joiner::IsOf(Id cell, const Edge& ends) const
{
  const Tetrahedron& corners = this->Solid.Mesh.Cells[cell];
  return this->Solid.Inside[cell] != 0 &&
    std::find(corners.begin(), corners.end(), ends[0]) != corners.end() &&
    std::find(corners.begin(), corners.end(), ends[1]) != corners.end();
}

/** The other side of a cell at the edge. */
Side Joiner::TurnAround(Side side, const Edge& places) const
{
  int other = 0;
  while (other == side.Face || !this->Has(side.Cell, other, places))
  {
    ++other;
  }
  return { side.Cell, other };
}

const FaceEdge* Joiner::Find(const Group& group, const Side& side) const
{
  return std::find_if(group.first, group.second,
    [&](const FaceEdge& edge)
    {
      const BoundaryFace& face = this->Faces[edge.Face];
      return face.Cell == side.Cell && face.Face == side.Face;
    });
}

/** The next face at the same edge, going around the edge outside; None if the mesh ends before. */
const FaceEdge* Joiner::AcrossOutside(const Group& group, const FaceEdge& edge) const
{
  const Edge places = { this->Solid.Places[edge.Ends[0]], this->Solid.Places[edge.Ends[1]] };
  const auto& neighbors = this->Solid.Mesh.Neighbors;
  Side side = { this->Faces[edge.Face].Cell, this->Faces[edge.Face].Face };
  for (Id next = neighbors[side.Cell][side.Face]; next != None;
       next = neighbors[side.Cell][side.Face])
  {
    const auto back = std::find(neighbors[next].begin(), neighbors[next].end(), side.Cell);
    side = { next, static_cast<int>(back - neighbors[next].begin()) };
    if (this->IsOf(next, edge.Ends))
    {
      return this->Find(group, side);
    }
    side = this->TurnAround(side, places);
  }
  return group.second;
}

/** The other face at the same edge that bounds the same fan of cells. */
const FaceEdge* Joiner::AcrossInside(const Group& group, const FaceEdge& edge) const
{
  const Edge places = { this->Solid.Places[edge.Ends[0]], this->Solid.Places[edge.Ends[1]] };
  const auto& neighbors = this->Solid.Mesh.Neighbors;
  Side side =
    this->TurnAround({ this->Faces[edge.Face].Cell, this->Faces[edge.Face].Face }, places);
  for (Id next = neighbors[side.Cell][side.Face]; next != None && this->Solid.Inside[next] != 0;
       next = neighbors[side.Cell][side.Face])
  {
    const auto back = std::find(neighbors[next].begin(), neighbors[next].end(), side.Cell);
    side = this->TurnAround({ next, static_cast<int>(back - neighbors[next].begin()) }, places);
  }
  return this->Find(group, side);
}

/** Join the ends of an edge in two faces. */
void Joiner::JoinPair(const FaceEdge& a, const FaceEdge& b)
{
  // The faces run along it in opposite directions.
  this->Corners.Join(3 * a.Face + a.Corner, 3 * b.Face + (b.Corner + 1) % 3);
  this->Corners.Join(3 * a.Face + (a.Corner + 1) % 3, 3 * b.Face + b.Corner);
}

/** All faces at an edge. */
void Joiner::JoinGroup(const Group& group)
{
  if (group.second - group.first == 2)
  {
    this->JoinPair(group.first[0], group.first[1]);
    return;
  }
  std::vector<std::pair<const FaceEdge*, const FaceEdge*>> pairs;
  std::vector<const FaceEdge*> ending; // faces from which the end of the mesh is reached
  for (const FaceEdge* edge = group.first; edge != group.second; ++edge)
  {
    const FaceEdge* const other = this->AcrossOutside(group, *edge);
    if (other == group.second)
    {
      ending.push_back(edge);
    }
    else if (edge < other)
    {
      pairs.emplace_back(edge, other);
    }
  }
  if (ending.size() == 2) // the space beyond the hull is one
  {
    pairs.emplace_back(ending[0], ending[1]);
  }
  else if (!ending.empty())
  {
    pairs.clear();
    for (const FaceEdge* edge = group.first; edge != group.second; ++edge)
    {
      pairs.emplace_back(edge, this->AcrossInside(group, *edge));
    }
  }
  for (const auto& [a, b] : pairs)
  {
    this->JoinPair(*a, *b);
  }
}

void Joiner::Join(Monitor& monitor, const ProgressRange& progress)
{
  std::vector<FaceEdge> edges;
  edges.reserve(3 * this->Faces.size());
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    const Triangle& corners = this->Faces[f].Corners;
    for (int k = 0; k < 3; ++k)
    {
      edges.push_back({ EdgeBetween(corners[k], corners[(k + 1) % 3]), static_cast<Id>(f), k });
    }
  }
  std::sort(edges.begin(), edges.end());
  const LoopProgress turns(monitor, progress, edges.size());
  const FaceEdge* const end = edges.data() + edges.size();
  std::size_t turn = 0;
  for (const FaceEdge* first = edges.data(); first != end;)
  {
    turns.Check(turn++);
    const FaceEdge* const last =
      std::find_if(first, end, [first](const FaceEdge& edge) { return edge.Ends != first->Ends; });
    this->JoinGroup({ first, last });
    first = last;
  }
}

/** Number points in the solid's order, and points at one place by their first face. */
ManifoldSurface Joiner::Number()
{
  std::vector<std::pair<Id, Id>> points; // place, and a representative corner
  for (Id corner = 0; corner < static_cast<Id>(3 * this->Faces.size()); ++corner)
  {
    if (this->Corners.Find(corner) == corner)
    {
      points.emplace_back(this->Faces[corner / 3].Corners[corner % 3], corner);
    }
  }
  std::sort(points.begin(), points.end());
  ManifoldSurface result;
  std::vector<Id> numbers(3 * this->Faces.size(), None);
  for (const auto& [place, corner] : points)
  {
    const std::vector<Id>& places = result.Places;
    result.SharedPoints += !places.empty() && places.back() == place;
    numbers[corner] = static_cast<Id>(places.size());
    result.Places.push_back(place);
  }
  std::vector<Edge> edges;
  for (Id face = 0; face < static_cast<Id>(this->Faces.size()); ++face)
  {
    Triangle triangle;
    for (int k = 0; k < 3; ++k)
    {
      triangle[k] = numbers[this->Corners.Find(3 * face + k)];
    }
    result.Triangles.push_back(triangle);
    for (int k = 0; k < 3; ++k)
    {
      edges.push_back(EdgeBetween(triangle[k], triangle[(k + 1) % 3]));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t first = 0; first < edges.size();)
  {
    const auto last =
      static_cast<std::size_t>(std::upper_bound(edges.begin() + static_cast<std::ptrdiff_t>(first),
                                 edges.end(), edges[first]) -
        edges.begin());
    result.LeftEdges += last - first != 2;
    first = last;
  }
  return result;
}
} // namespace

ManifoldSurface ManifoldBoundary(const PartedSolid& solid, const std::vector<BoundaryFace>& faces,
  Monitor& monitor, const ProgressRange& progress)
{
  Joiner joiner(solid, faces);
  joiner.Join(monitor, progress);
  return joiner.Number();
}
} // namespace insideout

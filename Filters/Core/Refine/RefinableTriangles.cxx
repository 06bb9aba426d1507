// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefinableTriangles.h"

#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"

#include <algorithm>
#include <limits>
#include <unordered_set>

namespace insideout
{
RefinableTriangles::RefinableTriangles(const std::vector<PlanarPoint>& points,
  const PlanarMesh& mesh, const std::vector<unsigned char>& inside, const PlanarMetric& metric)
  : Places(points)
  , Measure(metric)
  , Circle(metric)
{
  std::vector<Id> numbers(mesh.Cells.size(), None);
  Id count = 0;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    numbers[c] = inside[c] != 0 ? count++ : None;
  }
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (numbers[c] == None)
    {
      continue;
    }
    Cell cell{ mesh.Cells[c], {}, {}, c };
    for (int k = 0; k < 3; ++k)
    {
      const Id beyond = mesh.Neighbors[c][k];
      cell.Neighbors[k] = beyond == None ? None : numbers[beyond];
      const bool isConstraint = cell.Neighbors[k] == None || mesh.Segments[c][k] != None;
      cell.Sources[k] = isConstraint ? 3 * c + k : None;
    }
    this->Triangles.push_back(cell);
  }
}

int RefinableTriangles::EdgeTo(Id cell, Id neighbor) const
{
  const auto& neighbors = this->Triangles[cell].Neighbors;
  return static_cast<int>(
    std::find(neighbors.begin(), neighbors.end(), neighbor) - neighbors.begin());
}

RefinableTriangles::Place RefinableTriangles::Locate(Id from, const PlanarPoint& place) const
{
  const auto corner = [&](Id cell, int k) -> const PlanarPoint&
  { return this->Places[this->Triangles[cell].Corners[k % 3]]; };
  PlanarPoint start;
  for (int k = 0; k < 2; ++k)
  {
    start[k] = (corner(from, 0)[k] + corner(from, 1)[k] + corner(from, 2)[k]) / 3;
  }
  for (int k = 0; k < 3; ++k)
  {
    if (Orient2D(corner(from, k), corner(from, k + 1), start) <= 0)
    {
      return { None, None }; // a sliver, whose rounded center is beside it
    }
  }
  int entry = None;
  Id cell = from;
  for (Id steps = 0; steps < this->NumberOfCells(); ++steps)
  {
    int exit = None;
    bool isWithin = true;
    for (int k = 0; k < 3; ++k)
    {
      if (k != entry && Orient2D(corner(cell, k), corner(cell, k + 1), place) < 0)
      {
        isWithin = false;
        if (Orient2D(start, place, corner(cell, k)) <= 0 &&
          Orient2D(start, place, corner(cell, k + 1)) >= 0)
        {
          exit = k;
        }
      }
    }
    if (isWithin)
    {
      return { cell, None };
    }
    if (exit == None)
    {
      return { None, None }; // the way goes through a point
    }
    if (this->Triangles[cell].Sources[exit] != None)
    {
      return { cell, exit };
    }
    const Id next = this->Triangles[cell].Neighbors[exit];
    entry = this->EdgeTo(next, cell);
    cell = next;
  }
  return { None, None }; // around a point on the way
}

RefinableTriangles::View RefinableTriangles::ViewFrom(Id cell, const PlanarPoint& place) const
{
  View view{ { cell }, {}, std::numeric_limits<double>::infinity() };
  std::unordered_set<Id> known{ cell };
  for (std::size_t i = 0; i < view.Cells.size(); ++i)
  {
    const Id at = view.Cells[i];
    const Cell& here = this->Triangles[at];
    for (int k = 0; k < 3; ++k)
    {
      const PlanarPoint& corner = this->Places[here.Corners[k]];
      view.Spacing = std::min(view.Spacing, this->Measure.Distance(corner, place));
      const Id beyond = here.Neighbors[k];
      if (here.Sources[k] != None)
      {
        view.Rim.push_back({ at, k });
      }
      else if (known.count(beyond) == 0)
      {
        const Triangle& c = this->Triangles[beyond].Corners;
        if (this->Circle(this->Places[c[0]], this->Places[c[1]], this->Places[c[2]], place) > 0)
        {
          known.insert(beyond);
          view.Cells.push_back(beyond);
        }
        else
        {
          view.Rim.push_back({ at, k });
        }
      }
    }
  }
  return view;
}

void RefinableTriangles::Set(Id cell, const Triangle& corners, const std::array<Id, 3>& neighbors,
  const std::array<Id, 3>& sources)
{
  Cell& here = this->Triangles[cell];
  here.Corners = corners;
  here.Neighbors = neighbors;
  here.Sources = sources;
  ++here.Version;
  this->Fresh.push_back(cell);
}

void RefinableTriangles::Relink(Id neighbor, Id before, Id after)
{
  if (neighbor != None)
  {
    this->Triangles[neighbor].Neighbors[this->EdgeTo(neighbor, before)] = after;
  }
}

/** A cell of the input on the same side of all constraints as another one. */
Id RefinableTriangles::AddCell(Id like)
{
  Cell fresh{};
  fresh.Near = this->Triangles[like].Near;
  this->Triangles.push_back(fresh);
  return this->NumberOfCells() - 1;
}

bool RefinableTriangles::IsPositive(Id a, Id b, const PlanarPoint& place) const
{
  return Orient2D(this->Places[a], this->Places[b], place) > 0;
}

Id RefinableTriangles::Insert(Id cell, const PlanarPoint& place)
{
  const Cell here = this->Triangles[cell];
  for (int k = 0; k < 3; ++k)
  {
    const auto [a, b] = EdgeOf(here.Corners, k);
    const int side = Orient2D(this->Places[a], this->Places[b], place);
    if (side == 0 && here.Sources[k] == None)
    {
      return this->Split({ cell, k }, place);
    }
    if (side <= 0)
    {
      return None;
    }
  }
  this->Fresh.clear();
  const Id point = static_cast<Id>(this->Places.size());
  this->Places.push_back(place);
  const Id second = this->AddCell(cell);
  const Id third = this->AddCell(cell);
  const auto& [a, b, c] = here.Corners;
  const auto& [ab, bc, ca] = here.Neighbors;
  this->Set(
    cell, { { a, b, point } }, { { ab, second, third } }, { { here.Sources[0], None, None } });
  this->Set(
    second, { { b, c, point } }, { { bc, third, cell } }, { { here.Sources[1], None, None } });
  this->Set(
    third, { { c, a, point } }, { { ca, cell, second } }, { { here.Sources[2], None, None } });
  this->Relink(bc, cell, second);
  this->Relink(ca, cell, third);
  this->Restore({ cell, second, third });
  return point;
}

Id RefinableTriangles::Split(const Place& edge, const PlanarPoint& place)
{
  // The cell (a, b, c) and, where there is one, the other (b, a, d).
  const Id cell = edge.Cell;
  const int k = edge.Edge;
  const Cell here = this->Triangles[cell];
  const Id other = here.Neighbors[k];
  const Id a = here.Corners[k], b = here.Corners[(k + 1) % 3], c = here.Corners[(k + 2) % 3];
  const Cell there = other == None ? Cell{} : this->Triangles[other];
  const int j = other == None ? 0 : this->EdgeTo(other, cell);
  const Id d = there.Corners[(j + 2) % 3];
  if (!this->IsPositive(b, c, place) || !this->IsPositive(c, a, place) ||
    (other != None && (!this->IsPositive(a, d, place) || !this->IsPositive(d, b, place))))
  {
    return None;
  }
  this->Fresh.clear();
  const Id point = static_cast<Id>(this->Places.size());
  this->Places.push_back(place);
  const Id second = this->AddCell(cell);
  const Id fourth = other == None ? None : this->AddCell(other);
  const Id bc = here.Neighbors[(k + 1) % 3], ca = here.Neighbors[(k + 2) % 3];
  const Id source = here.Sources[k];
  this->Set(cell, { { b, c, point } }, { { bc, second, other } },
    { { here.Sources[(k + 1) % 3], None, source } });
  this->Set(second, { { c, a, point } }, { { ca, fourth, cell } },
    { { here.Sources[(k + 2) % 3], source, None } });
  this->Relink(ca, cell, second);
  std::vector<Id> star{ cell, second };
  if (other != None)
  {
    const Id ad = there.Neighbors[(j + 1) % 3], db = there.Neighbors[(j + 2) % 3];
    this->Set(fourth, { { a, d, point } }, { { ad, other, second } },
      { { there.Sources[(j + 1) % 3], None, there.Sources[j] } });
    this->Set(other, { { d, b, point } }, { { db, cell, fourth } },
      { { there.Sources[(j + 2) % 3], there.Sources[j], None } });
    this->Relink(ad, other, fourth);
    star.insert(star.end(), { fourth, other });
  }
  this->Restore(std::move(star));
  return point;
}

/** Whether edge 0, opposite to a new point, is not Delaunay. */
bool RefinableTriangles::MustFlip(Id cell) const
{
  const Cell& here = this->Triangles[cell];
  if (here.Sources[0] != None)
  {
    return false;
  }
  const Id other = here.Neighbors[0];
  const int j = this->EdgeTo(other, cell);
  const Id beyond = this->Triangles[other].Corners[(j + 2) % 3];
  return this->Circle(this->Places[here.Corners[0]], this->Places[here.Corners[1]],
           this->Places[here.Corners[2]], this->Places[beyond]) > 0;
}

/** Flip edges opposite to a new point, which is corner 2 of the cells around it, until all are
 * Delaunay (Lawson 1977). */
void RefinableTriangles::Restore(std::vector<Id> star)
{
  while (!star.empty())
  {
    const Id cell = star.back();
    if (!this->MustFlip(cell))
    {
      star.pop_back();
      continue;
    }
    const Cell here = this->Triangles[cell]; // (a, b, point)
    const Id other = here.Neighbors[0];
    const Cell there = this->Triangles[other]; // has b, a, beyond from its edge j on
    const int j = this->EdgeTo(other, cell);
    const auto& [a, b, point] = here.Corners;
    const Id beyond = there.Corners[(j + 2) % 3];
    const Id outerA = there.Neighbors[(j + 1) % 3], outerB = there.Neighbors[(j + 2) % 3];
    this->Set(cell, { { a, beyond, point } }, { { outerA, other, here.Neighbors[2] } },
      { { there.Sources[(j + 1) % 3], None, here.Sources[2] } });
    this->Set(other, { { beyond, b, point } }, { { outerB, here.Neighbors[1], cell } },
      { { there.Sources[(j + 2) % 3], here.Sources[1], None } });
    this->Relink(outerA, other, cell);
    this->Relink(here.Neighbors[1], cell, other);
    star.push_back(other);
  }
  SortUniquely(this->Fresh);
}
} // namespace insideout

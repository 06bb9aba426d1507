// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/Cavity.h"

#include "Common/Vectors.h"
#include "Refine/CellShape.h"

#include <algorithm>
#include <limits>

namespace insideout
{
double SquaredDistance(const Point& a, const Point& b)
{
  const Point ab = Difference(b, a);
  return Dot(ab, ab);
}

void Cavity::Start(const Point& place)
{
  this->Place = place;
  this->Old.Start(this->Mesh.NumberOfCells());
}

void Cavity::Grow(std::size_t most)
{
  for (std::size_t next = 0; next < this->Cells().size() && this->Cells().size() < most; ++next)
  {
    const RefinableCell& here = this->Mesh.Cell(this->Cells()[next]);
    for (int k = 0; k < 4 && this->Cells().size() < most; ++k)
    {
      const Id neighbor = here.Neighbors[k];
      if (here.Facets[k] == None && !this->Has(neighbor))
      {
        const auto [a, b, c, d] = CornersOf(this->Mesh.Points, this->Mesh.Cell(neighbor).Corners);
        const Circumsphere sphere = CircumsphereOf(a, b, c, d);
        // Cells too flat for doubles are replaced.
        if (!(SquaredDistance(sphere.Center, this->Place) >= sphere.SquaredRadius))
        {
          this->Add(neighbor);
        }
      }
    }
  }
}

bool Cavity::KeepsItsPoints() const
{
  this->OnWalls.Start(this->Mesh.NextPoint());
  for (const Triangle& wall : this->Walls)
  {
    for (const Id corner : wall)
    {
      this->OnWalls.Add(corner);
    }
  }
  return std::all_of(this->Cells().begin(), this->Cells().end(),
    [&](Id cell)
    {
      const Tetrahedron& t = this->Mesh.Cell(cell).Corners;
      return std::all_of(
        t.begin(), t.end(), [this](Id corner) { return this->OnWalls.Has(corner); });
    });
}

double Cavity::SquaredSpacing() const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& wall : this->Walls)
  {
    for (const Id corner : wall)
    {
      least = std::min(least, SquaredDistance(this->Mesh.Points[corner], this->Place));
    }
  }
  return least;
}
} // namespace insideout

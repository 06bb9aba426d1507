// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SolidFaces.h"
#include "Support/TestTetrahedra.h"

#include <map>
#include <random>

/** Solids for solvers' files. */
namespace solidsamples
{
using namespace insideout;

/** Two tetrahedra on the face 1 2 3, each a region of its own; a wall between them, and an outside.
 */
inline SolidMesh TwoRegions()
{
  SolidMesh solid;
  solid.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } };
  solid.Cells = { { 0, 1, 2, 3 }, { 4, 2, 1, 3 } };
  solid.RegionOfCell = { 0, 1 };
  solid.Faces = { { 0, 0 }, { 0, 2 }, { 0, 3 }, { 1, 0 }, { 1, 2 }, { 1, 3 }, { 1, 1 } };
  solid.TagOfFace = { 0, 0, 0, 0, 0, 0, 1 };
  solid.Regions = { { "red", 3 }, { "blue", 1 } };
  solid.Tags = { { "outside", 1 }, { "wall", 5 } };
  return solid;
}

/** The same with a point in the middle of each edge. */
inline SolidMesh Quadratic(SolidMesh solid)
{
  std::map<std::array<Id, 2>, Id> middles;
  for (const Tetrahedron& cell : solid.Cells)
  {
    solid.Midpoints.emplace_back();
    for (std::size_t e = 0; e < TetrahedronEdges.size(); ++e)
    {
      const Id p = cell[TetrahedronEdges[e][0]];
      const Id q = cell[TetrahedronEdges[e][1]];
      const auto [middle, isNew] =
        middles.emplace(std::array<Id, 2>{ { std::min(p, q), std::max(p, q) } },
          static_cast<Id>(solid.Points.size()));
      if (isNew)
      {
        const Point a = solid.Points[p];
        const Point b = solid.Points[q];
        solid.Points.push_back({ (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 });
      }
      solid.Midpoints.back()[e] = middle->second;
    }
  }
  return solid;
}

/** Cells in three regions with gaps between their numbers, and faces with two tags, at random; no
 * coordinate is short, and some points have no cell. */
inline SolidMesh RandomSolid(unsigned seed)
{
  std::mt19937_64 random(seed);
  const TetrahedralMesh mesh = testtetrahedra::Grid(seed, 2);
  SolidMesh solid;
  solid.Points = mesh.Points;
  for (Point& point : solid.Points)
  {
    for (double& x : point)
    {
      x += static_cast<double>(random() >> 11) / 9007199254740992.0;
    }
  }
  solid.Points.push_back({ { 0.1, 0.2, 0.3 } });
  solid.Cells = mesh.Cells;
  for (std::size_t c = 0; c < solid.Cells.size(); ++c)
  {
    solid.RegionOfCell.push_back(c < 3 ? static_cast<Id>(c) : static_cast<Id>(random() % 3));
  }
  solid.Faces = OuterFaces(solid);
  for (std::size_t f = 0; f < solid.Faces.size(); ++f)
  {
    solid.TagOfFace.push_back(f < 2 ? static_cast<Id>(f) : static_cast<Id>(random() % 2));
  }
  solid.Regions = { { "bone", 2 }, { "soft tissue", 5 }, { "fat", 6 } };
  solid.Tags = { { "inlet", 1 }, { "wall 2", 4 } };
  return solid;
}
} // namespace solidsamples

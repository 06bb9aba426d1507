// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"

#include <array>
#include <limits>
#include <random>
#include <vector>

/** Tetrahedral meshes without a tetrahedralizer, and facets chosen among their faces. */
namespace testtetrahedra
{
using namespace insideout;

/**
 * size^3 cubes of six tetrahedra each (Kuhn), 100 apart, every point moved by a random whole number
 * below 10 along each axis. Coordinates are integers, cells positive.
 */
TetrahedralMesh Grid(unsigned seed, int size);

/** The same without noise: every point a multiple of 100. */
TetrahedralMesh EvenGrid(int size);

/** The cells of a mesh that are inside, as a mesh of their own. */
TetrahedralMesh Part(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside);

/** Whether every cell has a positive volume, exactly. */
bool AllPositive(const TetrahedralMesh& mesh);

/** Multiply all coordinates along one axis. */
void Squeeze(TetrahedralMesh& mesh, int axis, double factor);

/**
 * Move at most `most` inner points to within a few units in the last place of the opposite face of
 * one of their cells, where all cells stay positive.
 * @return how many points were moved
 */
int Flatten(TetrahedralMesh& mesh, unsigned seed, int most = std::numeric_limits<int>::max());

/**
 * A complex whose facets are faces of the mesh, entered into the mesh: the faces where `labels`
 * (one per cell, 0 beyond the hull) jump, by as much, turned over at random; and a few others of
 * multiplicity 0. It is closed, and the labels are its winding numbers.
 */
FacetComplex BoundaryOfLabels(TetrahedralMesh& mesh, const std::vector<int>& labels, unsigned seed);

/** The same of random faces with multiplicities from -2 to 2: a complex with open edges. */
FacetComplex RandomFaces(TetrahedralMesh& mesh, unsigned seed);

/** Random labels from -3 to 3, one per cell. */
std::vector<int> RandomLabels(const TetrahedralMesh& mesh, unsigned seed);

/** Random inside (1) or outside (0), one per cell; by the seed a quarter to all are inside. */
std::vector<unsigned char> RandomInside(const TetrahedralMesh& mesh, unsigned seed);

/** The cubes of an EvenGrid with `isInside` true at the centers of their cells. */
template <typename Predicate>
std::vector<unsigned char> Cubes(const TetrahedralMesh& mesh, const Predicate& isInside)
{
  std::vector<unsigned char> inside;
  for (const Tetrahedron& cell : mesh.Cells)
  {
    std::array<int, 3> cube;
    for (int axis = 0; axis < 3; ++axis)
    {
      double sum = 0;
      for (const Id p : cell)
      {
        sum += mesh.Points[p][axis] / 4;
      }
      cube[axis] = static_cast<int>(sum / 100);
    }
    inside.push_back(isInside(cube[0], cube[1], cube[2]) ? 1 : 0);
  }
  return inside;
}
} // namespace testtetrahedra

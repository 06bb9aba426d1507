// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/TestTetrahedra.h"

#include "GraphCut/ConnectCells.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace testtetrahedra
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

bool IsPositive(const TetrahedralMesh& mesh, Id cell)
{
  std::array<Kernel::Point_3, 4> p;
  for (int k = 0; k < 4; ++k)
  {
    const Point& x = mesh.Points[mesh.Cells[cell][k]];
    p[k] = Kernel::Point_3(x[0], x[1], x[2]);
  }
  return CGAL::orientation(p[0], p[1], p[2], p[3]) == CGAL::POSITIVE;
}

Triangle Face(const TetrahedralMesh& mesh, Id cell, int k)
{
  const auto& corners = TetrahedronFaces[k];
  const Tetrahedron& t = mesh.Cells[cell];
  return { t[corners[0]], t[corners[1]], t[corners[2]] };
}

void Connect(TetrahedralMesh& mesh)
{
  std::map<Triangle, std::pair<Id, int>> open;
  mesh.Neighbors.assign(mesh.Cells.size(), { { None, None, None, None } });
  mesh.Facets = mesh.Neighbors;
  mesh.FacetSides.assign(mesh.Cells.size(), { { 0, 0, 0, 0 } });
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      Triangle key = Face(mesh, cell, k);
      std::sort(key.begin(), key.end());
      const auto found = open.find(key);
      if (found == open.end())
      {
        open[key] = { cell, k };
        continue;
      }
      mesh.Neighbors[cell][k] = found->second.first;
      mesh.Neighbors[found->second.first][found->second.second] = cell;
    }
  }
}

FacetComplex EmptyComplex(const TetrahedralMesh& mesh)
{
  FacetComplex complex;
  complex.Points = mesh.Points;
  complex.Origins = mesh.Origins;
  return complex;
}

/** Make face k of the cell a facet, with the multiplicity counted along the cell's normal. */
void AddFacet(
  FacetComplex& complex, TetrahedralMesh& mesh, Id cell, int k, int multiplicity, bool turnedOver)
{
  const Id facet = complex.NumberOfFacets();
  Triangle corners = Face(mesh, cell, k);
  if (turnedOver)
  {
    std::swap(corners[1], corners[2]);
  }
  complex.Facets.push_back(corners);
  complex.Multiplicity.push_back(
    static_cast<std::int16_t>(turnedOver ? -multiplicity : multiplicity));
  complex.Sources.push_back({ facet, false });
  complex.SourceOffsets.push_back(facet + 1);
  complex.NumberOfConstraints = facet + 1;
  const std::int8_t side = turnedOver ? -1 : 1;
  mesh.Facets[cell][k] = facet;
  mesh.FacetSides[cell][k] = side;
  const Id neighbor = mesh.Neighbors[cell][k];
  if (neighbor != None)
  {
    const auto& back = mesh.Neighbors[neighbor];
    const auto j = std::find(back.begin(), back.end(), cell) - back.begin();
    mesh.Facets[neighbor][j] = facet;
    mesh.FacetSides[neighbor][j] = static_cast<std::int8_t>(-side);
  }
}

/** Each face once: from the cell of the higher id, or of the only one. */
template <typename Function>
void ForEachFace(const TetrahedralMesh& mesh, Function function)
{
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[cell][k] < cell)
      {
        function(cell, k);
      }
    }
  }
}

/** Put the point on the face across from corner k, just on the inner side. */
void MoveToFace(TetrahedralMesh& mesh, Id cell, int k)
{
  Point& moved = mesh.Points[mesh.Cells[cell][k]];
  const Point old = moved;
  Point centre = { 0, 0, 0 };
  for (int j = 0; j < 4; ++j)
  {
    for (int axis = 0; j != k && axis < 3; ++axis)
    {
      centre[axis] += mesh.Points[mesh.Cells[cell][j]][axis] / 3;
    }
  }
  moved = centre;
  for (int step = 0; step < 4 && !IsPositive(mesh, cell); ++step)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      moved[axis] = std::nextafter(moved[axis], old[axis]);
    }
  }
}
} // namespace

TetrahedralMesh Grid(unsigned seed, int size)
{
  std::mt19937 random(seed);
  TetrahedralMesh mesh;
  const int n = size + 1;
  for (int i = 0; i < n * n * n; ++i)
  {
    const std::array<int, 3> index = { { i % n, i / n % n, i / n / n } };
    Point p;
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = 100.0 * index[axis] + static_cast<double>(random() % 19) - 9;
    }
    mesh.Points.push_back(p);
    mesh.Origins.push_back(PointOrigin::Input(i));
  }
  const std::array<int, 3> steps = { { 1, n, n * n } };
  for (int i = 0; i < size * size * size; ++i)
  {
    const Id corner = i % size + n * (i / size % size) + n * n * (i / size / size);
    std::array<int, 3> axes = { { 0, 1, 2 } };
    do
    {
      Tetrahedron cell;
      cell[0] = corner;
      for (int k = 0; k < 3; ++k)
      {
        cell[k + 1] = cell[k] + steps[axes[k]];
      }
      mesh.Cells.push_back(cell);
      if (!IsPositive(mesh, mesh.NumberOfCells() - 1))
      {
        std::swap(mesh.Cells.back()[0], mesh.Cells.back()[1]);
      }
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  Connect(mesh);
  return mesh;
}

TetrahedralMesh EvenGrid(int size)
{
  TetrahedralMesh grid = Grid(0, size);
  for (Point& p : grid.Points)
  {
    for (double& x : p)
    {
      x = 100 * std::round(x / 100); // the grid's points are moved by less than 10
    }
  }
  return ConnectCells(grid.Points, grid.Cells);
}

TetrahedralMesh Part(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  std::vector<Tetrahedron> cells;
  for (std::size_t c = 0; c < inside.size(); ++c)
  {
    if (inside[c] != 0)
    {
      cells.push_back(mesh.Cells[c]);
    }
  }
  return ConnectCells(mesh.Points, cells);
}

bool AllPositive(const TetrahedralMesh& mesh)
{
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (!IsPositive(mesh, cell))
    {
      return false;
    }
  }
  return true;
}

void Squeeze(TetrahedralMesh& mesh, int axis, double factor)
{
  for (Point& p : mesh.Points)
  {
    p[axis] *= factor;
  }
}

int Flatten(TetrahedralMesh& mesh, unsigned seed, int most)
{
  std::mt19937 random(seed);
  std::vector<char> fixed(mesh.Points.size(), 0);
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      for (int j = 0; mesh.Neighbors[cell][k] == None && j < 3; ++j)
      {
        fixed[Face(mesh, cell, k)[j]] = 1;
      }
    }
  }
  int moved = 0;
  for (Id tries = 0; tries < mesh.NumberOfCells() && moved < most; ++tries)
  {
    const Id cell = static_cast<Id>(random() % mesh.Cells.size());
    const int k = static_cast<int>(random() % 4);
    const Id point = mesh.Cells[cell][k];
    if (fixed[point])
    {
      continue;
    }
    const Point old = mesh.Points[point];
    MoveToFace(mesh, cell, k);
    if (AllPositive(mesh))
    {
      fixed[point] = 1;
      ++moved;
    }
    else
    {
      mesh.Points[point] = old;
    }
  }
  return moved;
}

FacetComplex BoundaryOfLabels(TetrahedralMesh& mesh, const std::vector<int>& labels, unsigned seed)
{
  std::mt19937 random(seed);
  FacetComplex complex = EmptyComplex(mesh);
  ForEachFace(mesh,
    [&](Id cell, int k)
    {
      const Id neighbor = mesh.Neighbors[cell][k];
      const int jump = labels[cell] - (neighbor == None ? 0 : labels[neighbor]);
      if (jump != 0 || random() % 8 == 0)
      {
        AddFacet(complex, mesh, cell, k, jump, random() % 2 == 0);
      }
    });
  return complex;
}

FacetComplex RandomFaces(TetrahedralMesh& mesh, unsigned seed)
{
  std::mt19937 random(seed);
  FacetComplex complex = EmptyComplex(mesh);
  ForEachFace(mesh,
    [&](Id cell, int k)
    {
      if (random() % 3 == 0)
      {
        const int multiplicity = static_cast<int>(random() % 5) - 2;
        AddFacet(complex, mesh, cell, k, multiplicity, random() % 2 == 0);
      }
    });
  return complex;
}

std::vector<int> RandomLabels(const TetrahedralMesh& mesh, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<int> labels;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    labels.push_back(static_cast<int>(random() % 7) - 3);
  }
  return labels;
}

std::vector<unsigned char> RandomInside(const TetrahedralMesh& mesh, unsigned seed)
{
  std::mt19937 random(seed);
  const unsigned share = 1 + seed % 4; // quarters
  std::vector<unsigned char> inside;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    inside.push_back(random() % 4 < share);
  }
  return inside;
}
} // namespace testtetrahedra

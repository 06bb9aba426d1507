// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/InsideBoundary.h"

#include "Common/Error.h"
#include "Output/BoundaryTriangles.h"
#include "Support/StopAtEveryReport.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace
{
using namespace insideout;
using testtetrahedra::Grid;
using testtetrahedra::RandomInside;

constexpr ProgressRange All = { "extracting", 0, 1 };

std::vector<BoundaryFace> BoundaryFaces(
  const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  Monitor monitor;
  return BoundaryFaces(mesh, inside, monitor, All);
}

/** det(a, b, c) of integer points: six times the volume of the cone from the origin. */
std::int64_t Determinant(const Point& a, const Point& b, const Point& c)
{
  const auto i = [](double x) { return static_cast<std::int64_t>(x); };
  return i(a[0]) * (i(b[1]) * i(c[2]) - i(b[2]) * i(c[1])) +
    i(a[1]) * (i(b[2]) * i(c[0]) - i(b[0]) * i(c[2])) +
    i(a[2]) * (i(b[0]) * i(c[1]) - i(b[1]) * i(c[0]));
}

Point Difference(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

TEST(BoundaryFaces, EnclosesExactlyTheInsideCells)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    const TetrahedralMesh mesh = Grid(seed, 3);
    const std::vector<unsigned char> inside = RandomInside(mesh, seed);
    std::int64_t cells = 0;
    for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
    {
      const Tetrahedron& t = mesh.Cells[cell];
      const Point& apex = mesh.Points[t[0]];
      cells += inside[cell] *
        Determinant(Difference(mesh.Points[t[1]], apex), Difference(mesh.Points[t[2]], apex),
          Difference(mesh.Points[t[3]], apex));
    }
    std::int64_t enclosed = 0;
    for (const BoundaryFace& face : BoundaryFaces(mesh, inside))
    {
      enclosed += Determinant(
        mesh.Points[face.Corners[0]], mesh.Points[face.Corners[1]], mesh.Points[face.Corners[2]]);
    }
    EXPECT_GT(cells, 0);
    EXPECT_EQ(enclosed, cells);
  }
}

TEST(BoundaryFaces, BalancesEveryEdge)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    const TetrahedralMesh mesh = Grid(seed, 3);
    std::map<std::pair<Id, Id>, int> balance;
    for (const BoundaryFace& face : BoundaryFaces(mesh, RandomInside(mesh, seed)))
    {
      for (int k = 0; k < 3; ++k)
      {
        const Id a = face.Corners[k];
        const Id b = face.Corners[(k + 1) % 3];
        balance[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
      }
    }
    EXPECT_FALSE(balance.empty());
    for (const auto& edge : balance)
    {
      EXPECT_EQ(edge.second, 0);
    }
  }
}

TEST(BoundaryFaces, AreTheFacesOfInsideCellsInTheirOrder)
{
  for (unsigned seed = 0; seed < 8; ++seed)
  {
    TetrahedralMesh mesh = Grid(seed, 3);
    testtetrahedra::RandomFaces(mesh, seed);
    const std::vector<unsigned char> inside = RandomInside(mesh, seed);
    std::pair<Id, int> last = { None, 0 };
    int onFacets = 0;
    for (const BoundaryFace& face : BoundaryFaces(mesh, inside))
    {
      EXPECT_LT(last, std::make_pair(face.Cell, face.Face));
      last = { face.Cell, face.Face };
      EXPECT_EQ(inside[face.Cell], 1);
      const Id beyond = mesh.Neighbors[face.Cell][face.Face];
      EXPECT_TRUE(beyond == None || inside[beyond] == 0);
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_EQ(face.Corners[k], mesh.Cells[face.Cell][TetrahedronFaces[face.Face][k]]);
      }
      EXPECT_EQ(face.Facet, mesh.Facets[face.Cell][face.Face]);
      onFacets += face.Facet != None;
    }
    EXPECT_GT(onFacets, 0);
  }
}

TEST(BoundaryFaces, IsTheHullWhenAllIsInsideAndNothingWhenNothingIs)
{
  const TetrahedralMesh mesh = Grid(1, 3);
  EXPECT_EQ(BoundaryFaces(mesh, std::vector<unsigned char>(162, 1)).size(), 2u * 6 * 9);
  EXPECT_TRUE(BoundaryFaces(mesh, std::vector<unsigned char>(162, 0)).empty());
}

TEST(BoundaryFaces, CanBeStopped)
{
  const TetrahedralMesh mesh = Grid(1, 10);
  const std::vector<unsigned char> inside = RandomInside(mesh, 1);
  const int reports =
    testmeshes::StopAtEveryReport([&](Monitor& monitor, const ProgressRange& range)
      { BoundaryFaces(mesh, inside, monitor, range); });
  EXPECT_EQ(reports, 2);
}

TEST(BoundaryTriangles, CanBeStopped)
{
  TetrahedralMesh mesh = Grid(1, 10);
  const FacetComplex surface = testtetrahedra::RandomFaces(mesh, 1);
  const std::vector<BoundaryFace> faces = BoundaryFaces(mesh, RandomInside(mesh, 1));
  const int reports =
    testmeshes::StopAtEveryReport([&](Monitor& monitor, const ProgressRange& range)
      { BoundaryTriangles(surface, mesh, faces, monitor, range); });
  EXPECT_EQ(reports, 2);
}

TEST(InsideBoundary, WantsOneLabelPerCell)
{
  const TetrahedralMesh mesh = Grid(1, 1);
  const auto code = [](auto function)
  {
    try
    {
      function();
    }
    catch (const Error& error)
    {
      EXPECT_STREQ(error.what(), "5 inside labels for 6 cells");
      return error.Code;
    }
    return ErrorCode::EmptySurface;
  };
  const std::vector<unsigned char> five(5, 1);
  EXPECT_EQ(code([&] { BoundaryFaces(mesh, five); }), ErrorCode::InvalidParameter);
}
} // namespace

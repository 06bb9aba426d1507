// SPDX-License-Identifier: GPL-3.0-or-later
#include "Quality/SolidDefects.h"

#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace insideout;
using testtetrahedra::Grid;

SolidDefects DefectsOf(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells,
  const LayerCells& layers = {})
{
  Monitor silent;
  return FindSolidDefects(points, cells, layers, silent);
}

/** Corners, in which a cell has a positive volume: 0, 1, 2 and any of those above. */
const std::vector<Point> Corners = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } },
  { { 0, 0, 1 } }, { { 0, 0, -1 } }, { { 0.3, 0.3, 2 } }, { { 0.3, 0.3, 0 } } };
} // namespace

TEST(SolidDefects, OfAGridAreNone)
{
  const TetrahedralMesh mesh = Grid(2, 4);
  const SolidDefects found = DefectsOf(mesh.Points, mesh.Cells);
  EXPECT_EQ(found.NegativeCells, 0);
  EXPECT_EQ(found.FlatCells, 0);
  EXPECT_EQ(found.NumberOfRegions, 1);
  EXPECT_EQ(found.Boundary.size(), 6u * 4 * 4 * 2);
  EXPECT_TRUE(found.Conforms());
  EXPECT_EQ(found.Orientations, std::vector<std::int8_t>(mesh.Cells.size(), 1));
}

TEST(SolidDefects, TellNegativeFromFlatExactly)
{
  std::vector<Point> points = Corners;
  points.push_back({ { 0.3, 0.3, 0x1p-1000 } });
  const SolidDefects found = DefectsOf(
    points, { { { 0, 1, 2, 3 } }, { { 0, 2, 1, 3 } }, { { 0, 1, 2, 6 } }, { { 0, 1, 2, 7 } } });
  EXPECT_EQ(found.Orientations, (std::vector<std::int8_t>{ 1, -1, 0, 1 }));
  EXPECT_EQ(found.NegativeCells, 1);
  EXPECT_EQ(found.FlatCells, 1);
}

TEST(SolidDefects, AreNotInTheOrderOfPointsAlone)
{
  // A negative cell that is only written the wrong way round lies where it should.
  const SolidDefects found = DefectsOf(Corners, { { { 0, 1, 2, 3 } }, { { 0, 1, 2, 4 } } });
  EXPECT_EQ(found.NegativeCells, 1);
  EXPECT_TRUE(found.Conforms());
  EXPECT_EQ(found.Boundary.size(), 6u);
}

TEST(SolidDefects, FindFacesThatHaveCellsOnOneSideOnly)
{
  const SolidDefects found = DefectsOf(Corners, { { { 0, 1, 2, 3 } }, { { 0, 1, 2, 5 } } });
  EXPECT_EQ(found.OverlappingFaces, 1);
  EXPECT_EQ(found.CrowdedFaces, 0);
  EXPECT_FALSE(found.Conforms());
}

TEST(SolidDefects, FindFacesOfThreeCells)
{
  const SolidDefects found =
    DefectsOf(Corners, { { { 0, 1, 2, 3 } }, { { 0, 1, 2, 5 } }, { { 0, 2, 1, 4 } } });
  EXPECT_EQ(found.CrowdedFaces, 1);
  EXPECT_FALSE(found.Conforms());
}

TEST(SolidDefects, FindAPointInTheMiddleOfAnothersFace)
{
  // Below the face, three cells around a point that the cell above does not have.
  const SolidDefects found = DefectsOf(
    Corners, { { { 0, 1, 2, 3 } }, { { 0, 6, 1, 4 } }, { { 1, 6, 2, 4 } }, { { 2, 6, 0, 4 } } });
  EXPECT_EQ(found.NegativeCells, 0);
  EXPECT_EQ(found.CrowdedFaces, 0);
  EXPECT_EQ(found.OverlappingFaces, 0);
  EXPECT_EQ(found.ContactPairs, 3);
  EXPECT_FALSE(found.Conforms());
  EXPECT_EQ(found.NumberOfRegions, 2);
}

TEST(SolidDefects, FindPointsThatShouldBeOne)
{
  std::vector<Point> points = Corners;
  points.insert(points.end(), { Corners[0], Corners[1], Corners[2] });
  const SolidDefects found = DefectsOf(points, { { { 0, 1, 2, 3 } }, { { 7, 9, 8, 4 } } });
  EXPECT_EQ(found.NegativeCells, 0);
  EXPECT_GT(found.ContactPairs, 0);
}

TEST(SolidDefects, NumberRegionsByTheirFirstCells)
{
  const TetrahedralMesh mesh = Grid(2, 2);
  std::vector<Tetrahedron> cells;
  std::vector<Point> points;
  for (const double shift : { 0.0, 1000.0 })
  {
    const Id offset = static_cast<Id>(points.size());
    for (Point p : mesh.Points)
    {
      p[0] += shift;
      points.push_back(p);
    }
    for (Tetrahedron cell : mesh.Cells)
    {
      for (Id& p : cell)
      {
        p += offset;
      }
      cells.push_back(cell);
    }
  }
  std::swap(cells[1], cells[mesh.Cells.size()]); // the second part comes early
  const SolidDefects found = DefectsOf(points, cells);
  EXPECT_EQ(found.NumberOfRegions, 2);
  EXPECT_EQ(found.Regions[0], 0);
  EXPECT_EQ(found.Regions[1], 1);
  EXPECT_EQ(found.Regions[2], 0);
  EXPECT_EQ(found.Regions.back(), 1);
  EXPECT_TRUE(found.Conforms());
}

namespace
{
/** A prism, a pyramid on one of its sides, and a tetrahedron on top. */
const std::vector<Point> LayerPoints = { { { 0, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 0, 0 } },
  { { 0, 0, 1 } }, { { 0, 1, 1 } }, { { 1, 0, 1 } }, { { 1, 1, 0 } }, { { 0, 0, 2 } } };
const LayerCells OneOfEach = { { { { 1, 4, 5, 2, 6 } } }, { { { 0, 1, 2, 3, 4, 5 } } } };
} // namespace

TEST(SolidDefects, OfLayersAreNone)
{
  const SolidDefects found = DefectsOf(LayerPoints, { { { 3, 5, 4, 7 } } }, OneOfEach);
  EXPECT_EQ(found.Orientations, (std::vector<std::int8_t>{ 1, 1, 1 }));
  EXPECT_EQ(found.Regions, (std::vector<Id>{ 0, 0, 0 }));
  EXPECT_TRUE(found.Conforms());
  EXPECT_EQ(found.Boundary.size(), 3U + 4 + 1 + 4); // two quads of the prism are cut
  EXPECT_EQ(found.Parts.size(), 1U + 2 + 3);
}

TEST(SolidDefects, OfAPrismAreThoseOfItsCorners)
{
  std::vector<Point> points = LayerPoints;
  points[3] = { { 0.9, 0.9, 0.5 } }; // beyond the edge from 4 to 5
  const SolidDefects turned = DefectsOf(points, {}, { {}, OneOfEach.Prisms });
  EXPECT_EQ(turned.Orientations, std::vector<std::int8_t>{ -1 });
  EXPECT_EQ(turned.NegativeCells, 1);
  points[3] = { { 0.5, 0.5, 1 } };
  EXPECT_EQ(DefectsOf(points, {}, { {}, OneOfEach.Prisms }).FlatCells, 1);
}

TEST(SolidDefects, FindTrianglesThatAreHalvesOfQuads)
{
  // In place of the pyramid two tetrahedra; the quad's diagonal is at its lowest corner.
  const SolidDefects found =
    DefectsOf(LayerPoints, { { { 1, 4, 5, 6 } }, { { 1, 5, 2, 6 } } }, { {}, OneOfEach.Prisms });
  EXPECT_EQ(found.NegativeCells + found.FlatCells + found.OverlappingFaces, 0);
  EXPECT_EQ(found.ContactPairs, 2);
  EXPECT_FALSE(found.Conforms());
}

TEST(SolidDefects, OfNothingAreNone)
{
  Statistics figures;
  AppendSolidDefects(DefectsOf({}, {}), figures);
  for (const auto& [name, value] : figures)
  {
    EXPECT_EQ(value, name == "Conforms" ? 1 : 0) << name;
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/MakeRefinable.h"
#include "Refine/SurfaceBudget.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace insideout;
using testtetrahedra::EvenGrid;

namespace
{
/** Two cubes side by side, of two regions; the lower one's top has a label of its own. */
class SurfaceBudgetOfCubes : public testing::Test
{
protected:
  SurfaceBudgetOfCubes()
  {
    const std::vector<unsigned char> inside =
      testtetrahedra::Cubes(EvenGrid(2), [](int, int y, int z) { return y == 0 && z == 0; });
    this->Input = testtetrahedra::Part(EvenGrid(2), inside);
    std::vector<Id> regions;
    for (const Tetrahedron& cell : this->Input.Cells)
    {
      const bool isFirst = std::all_of(
        cell.begin(), cell.end(), [this](Id p) { return this->Input.Points[p][0] <= 100; });
      regions.push_back(isFirst ? 0 : 1);
    }
    this->Facets = FacetsOf(this->Input, regions, {});
    this->Mesh = MakeRefinable(this->Input, regions, this->Facets);
    for (const SurfacePiece& piece : PiecesOf(this->Mesh))
    {
      this->Pieces.push_back(piece);
    }
  }

  /** The pieces at a place, and the same after it has moved. */
  void MovePoint(const Point& place, const Point& by)
  {
    this->Gone.clear();
    for (const SurfacePiece& piece : this->Pieces)
    {
      if (std::find(piece.Places.begin(), piece.Places.end(), place) != piece.Places.end())
      {
        this->Gone.push_back(piece);
      }
    }
    this->Fresh = this->Gone;
    for (SurfacePiece& piece : this->Fresh)
    {
      for (Point& corner : piece.Places)
      {
        if (corner == place)
        {
          corner = { { corner[0] + by[0], corner[1] + by[1], corner[2] + by[2] } };
        }
      }
    }
  }

  TetrahedralMesh Input;
  std::vector<FacetOfInput> Facets;
  RefinableMesh Mesh;
  std::vector<SurfacePiece> Pieces;
  std::vector<SurfacePiece> Gone;
  std::vector<SurfacePiece> Fresh;
};
} // namespace

TEST_F(SurfaceBudgetOfCubes, AllowsSmallChangesUntilTheirSumIsLarge)
{
  SurfaceBudget budget(this->Mesh, this->Facets);
  this->MovePoint({ { 0, 0, 0 } }, { { -2e-5, -2e-5, -2e-5 } });
  int count = 0;
  for (; count < 100 && budget.Allows(this->Gone, this->Fresh); ++count)
  {
    budget.Replace();
  }
  EXPECT_GT(count, 1);
  EXPECT_LT(count, 100);
  EXPECT_TRUE(budget.Allows(this->Fresh, this->Gone)) << "the change back";
}

TEST_F(SurfaceBudgetOfCubes, BoundsTheVolumeOfEachRegion)
{
  SurfaceBudget budget(this->Mesh, this->Facets);
  // Both regions together keep their volume, and areas change by the square of the move.
  this->MovePoint({ { 100, 0, 0 } }, { { 1e-3, 0, 0 } });
  EXPECT_FALSE(budget.Allows(this->Gone, this->Fresh));
  this->MovePoint({ { 100, 0, 0 } }, { { 1e-5, 0, 0 } });
  EXPECT_TRUE(budget.Allows(this->Gone, this->Fresh));
}

TEST_F(SurfaceBudgetOfCubes, BoundsTheAreaOfEachLabel)
{
  for (FacetOfInput& facet : this->Facets)
  {
    facet.Label = 2;
  }
  this->Facets[this->Pieces.front().Facet].Label = 3;
  SurfaceBudget budget(this->Mesh, this->Facets);
  const std::vector<SurfacePiece> last = { this->Pieces.front() };
  EXPECT_FALSE(budget.Allows(last, {}));
}

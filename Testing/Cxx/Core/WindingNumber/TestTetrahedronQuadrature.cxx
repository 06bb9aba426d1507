// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/TetrahedronQuadrature.h"

#include "Common/Error.h"
#include "WindingNumber/WindingNumberOfCells.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace insideout;

double Factorial(int n)
{
  return std::tgamma(n + 1.0);
}

TEST(TetrahedronQuadrature, IntegratesPolynomialsUpToItsOrderExactlyAndNotBeyond)
{
  for (int order : { 1, 2, 3, 5 })
  {
    const QuadratureRule rule = TetrahedronQuadrature(order);
    double worstBeyond = 0;
    for (int i = 0; i <= order + 1; ++i)
    {
      for (int j = 0; i + j <= order + 1; ++j)
      {
        for (int k = 0; i + j + k <= order + 1; ++k)
        {
          const double exact =
            6 * Factorial(i) * Factorial(j) * Factorial(k) / Factorial(i + j + k + 3);
          double sum = 0;
          for (std::size_t s = 0; s < rule.Sites.size(); ++s)
          {
            sum += rule.Weights[s] * std::pow(rule.Sites[s][0], i) * std::pow(rule.Sites[s][1], j) *
              std::pow(rule.Sites[s][2], k);
          }
          if (i + j + k <= order)
          {
            EXPECT_NEAR(sum, exact, 1e-15) << "order " << order;
          }
          else
          {
            worstBeyond = std::max(worstBeyond, std::abs(sum - exact));
          }
        }
      }
    }
    EXPECT_GT(worstBeyond, 1e-6) << "order " << order;
  }
}

TEST(TetrahedronQuadrature, StaysWithinTheCellAndSumsToOneExactly)
{
  for (int order = 1; order <= HighestQuadratureOrder; ++order)
  {
    for (const SiteWeights& site : TetrahedronQuadrature(order).Sites)
    {
      EXPECT_EQ(site[0] + site[1] + site[2] + site[3], 1);
      EXPECT_EQ(site[3], 1 - (site[0] + site[1] + site[2]));
      EXPECT_GT(*std::min_element(site.begin(), site.end()), 0.01);
    }
  }
}

TEST(TetrahedronQuadrature, RefusesOtherOrders)
{
  for (int order : { -1, 0, 6 })
  {
    try
    {
      TetrahedronQuadrature(order);
      ADD_FAILURE() << order;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
      EXPECT_NE(std::string(error.what()).find(std::to_string(order)), std::string::npos);
    }
  }
}

/** One cell of this size about a place, and a square sheet at z = 0 that is not a part of it. */
double MeanInCell(double size, const Point& centre, int order, int divisions)
{
  FacetComplex surface;
  surface.Points = { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 } };
  surface.Facets = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
  surface.Multiplicity = { 1, 1 };
  surface.NumberOfConstraints = 0;
  TetrahedralMesh mesh;
  mesh.Points = surface.Points;
  // The cell is divided into cells by cutting edges in half, (divisions) times.
  std::vector<std::array<Point, 4>> cells = {
    { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } }
  };
  for (int d = 0; d < divisions; ++d)
  {
    std::vector<std::array<Point, 4>> halves;
    for (const auto& cell : cells)
    {
      // Cut the longest edge.
      int a = 0, b = 1;
      double longest = 0;
      for (int i = 0; i < 4; ++i)
      {
        for (int j = i + 1; j < 4; ++j)
        {
          const double length =
            std::hypot(cell[i][0] - cell[j][0], cell[i][1] - cell[j][1], cell[i][2] - cell[j][2]);
          if (length > longest)
          {
            longest = length;
            a = i;
            b = j;
          }
        }
      }
      Point middle;
      for (int axis = 0; axis < 3; ++axis)
      {
        middle[axis] = (cell[a][axis] + cell[b][axis]) / 2;
      }
      auto first = cell, second = cell;
      first[a] = middle;
      second[b] = middle;
      halves.push_back(first);
      halves.push_back(second);
    }
    cells = halves;
  }
  for (const auto& cell : cells)
  {
    const Id first = static_cast<Id>(mesh.Points.size());
    for (const Point& p : cell)
    {
      mesh.Points.push_back({ centre[0] + size * (p[0] - 0.25), centre[1] + size * (p[1] - 0.25),
        centre[2] + size * (p[2] - 0.25) });
    }
    mesh.Cells.push_back({ { first, first + 1, first + 2, first + 3 } });
  }
  mesh.Neighbors.assign(mesh.Cells.size(), { { None, None, None, None } });
  mesh.Facets = mesh.Neighbors;
  mesh.FacetSides.assign(mesh.Cells.size(), { { 0, 0, 0, 0 } });
  Monitor monitor;
  double sum = 0;
  for (double w : WindingNumberOfCells(surface, mesh, monitor, order))
  {
    sum += w / static_cast<double>(mesh.Cells.size());
  }
  return sum;
}

TEST(TetrahedronQuadrature, GainsAtItsRateAwayFromOpenEdges)
{
  const Point away = { 0.3, -0.4, 0.9 };
  for (int order : { 1, 2, 3, 5 })
  {
    std::array<double, 2> error;
    for (int i = 0; i < 2; ++i)
    {
      const double size = i == 0 ? 0.8 : 0.4;
      error[i] = std::abs(MeanInCell(size, away, order, 0) - MeanInCell(size, away, 5, 5));
    }
    // Halving the cell divides the error by 2^(order + 1), or nearly.
    EXPECT_GT(error[0] / error[1], std::pow(2, order + 0.5)) << "order " << order;
  }
}

TEST(TetrahedronQuadrature, GainsLittleAtAnOpenEdge)
{
  // There w depends on the direction from the edge: the error is the same at every size.
  const auto error = [](double size, int order)
  {
    const Point atEdge = { 1 + 0.05 * size, 0.1 * size, 0.07 * size };
    return std::abs(MeanInCell(size, atEdge, order, 0) - MeanInCell(size, atEdge, 5, 7));
  };
  for (int order : { 1, 5 })
  {
    EXPECT_GT(error(0.05, order), 1e-4) << "order " << order;
    EXPECT_LT(error(0.1, order) / error(0.05, order), 1.5) << "order " << order;
  }
}
} // namespace

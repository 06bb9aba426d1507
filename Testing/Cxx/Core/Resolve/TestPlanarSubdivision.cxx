// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/FacetMeeting.h"
#include "Resolve/PlanarSubdivision.h"

#include "Common/Vectors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace insideout;

namespace
{
/** A facet that others pass through along chords of a circle, each of which crosses all others. */
struct PiercedFacet
{
  explicit PiercedFacet(Id chords)
  {
    for (Id i = 0; i < chords; ++i)
    {
      const double begin = std::acos(-1.0) * i / chords;
      const double end = begin + std::acos(-1.0) + 0.7 / chords * std::sin(1.0 + 2.3 * i);
      const Id first = static_cast<Id>(this->Points.size());
      const Point from = { std::cos(begin), std::sin(begin), 0 };
      const Point to = { std::cos(end), std::sin(end), 0 };
      const double up = 1 + 0.01 * i;
      this->Points.push_back({ from[0], from[1], up });
      this->Points.push_back({ to[0], to[1], up });
      this->Points.push_back({ (from[0] + to[0]) / 2, (from[1] + to[1]) / 2, -up });
      this->Facets.push_back({ first, first + 1, first + 2 });
    }
  }

  PlanarSubdivision Subdivide() const
  {
    const FacetList surface{ this->Points, this->Facets };
    std::vector<Cut> cuts;
    for (Id other = 1; other < static_cast<Id>(this->Facets.size()); ++other)
    {
      const Meeting meeting = Meet(surface, 0, other);
      cuts.push_back({ meeting.First, meeting.Last, other });
    }
    return SubdividePlane(surface, { 0 }, cuts);
  }

  std::vector<Point> Points{ { -9, -6, 0 }, { 9, -6, 0 }, { 0, 9, 0 } };
  std::vector<Triangle> Facets{ { 0, 1, 2 } };
};

/** The pieces' areas; one that is turned over counts negative. */
double SumOfAreas(const PiercedFacet& facet, const PlanarSubdivision& subdivision)
{
  const FacetList surface{ facet.Points, facet.Facets };
  double sum = 0;
  for (const Piece& piece : subdivision.Pieces)
  {
    std::array<Point, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = Nearest(subdivision.Points[piece.Corners[k]], surface);
    }
    const double area = NormalOf(corners[0], corners[1], corners[2])[2] / 2;
    EXPECT_GT(area, 0);
    sum += area;
  }
  return sum;
}
} // namespace

TEST(PlanarSubdivision, HasAPointWhereEachPairOfManyCutsCrosses)
{
  // With 8 all triangles are walked through, with 48 walks begin nearby.
  for (const Id chords : { 8, 48 })
  {
    const PiercedFacet facet(chords);
    const PlanarSubdivision subdivision = facet.Subdivide();
    const Id inner = 2 * chords + chords * (chords - 1) / 2;
    EXPECT_EQ(static_cast<Id>(subdivision.Points.size()), 3 + inner);
    EXPECT_EQ(static_cast<Id>(subdivision.Pieces.size()), 2 * inner + 1) << "Euler";
    EXPECT_NEAR(SumOfAreas(facet, subdivision), 18.0 * 15 / 2, 1e-10);
  }
}

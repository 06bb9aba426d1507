// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/MixInCells.h"

#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <numeric>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
/** The weights of a cell's corners at a place in it, all at least 0, however thin the cell. */
std::array<double, 4> WeightsAt(const std::vector<Point>& points, const Tetrahedron& cell,
  const Point& place, const PowerOfTwo& scale)
{
  std::array<double, 4> weights;
  for (int k = 0; k < 4; ++k)
  {
    std::array<Point, 4> corners = CornersOf(points, cell);
    corners[k] = place;
    std::transform(corners.begin(), corners.end(), corners.begin(),
      [&scale](const Point& corner) { return scale.Times(corner); });
    weights[k] = std::max(0.0,
      Determinant(Difference(corners[1], corners[0]), Difference(corners[2], corners[0]),
        Difference(corners[3], corners[0])));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights)
  {
    weight = sum > 0 ? weight / sum : 0.25;
  }
  return weights;
}
} // namespace

std::vector<Attributes::Mixture> MixInCells(const TetrahedralMesh& mesh,
  const std::vector<Point>& points, const std::vector<Id>& originals, const std::vector<Id>& cells)
{
  const PowerOfTwo scale(-LargestExponent(mesh.Points));
  std::vector<Attributes::Mixture> mixtures(points.size());
  for (std::size_t p = 0; p < mixtures.size(); ++p)
  {
    const Id original = originals[p];
    const Tetrahedron& cell = mesh.Cells[cells[p]];
    mixtures[p].IsNew = original == None;
    mixtures[p].Points = original == None ? cell : Tetrahedron{ { original, 0, 0, 0 } };
    mixtures[p].Weights = original == None ? WeightsAt(mesh.Points, cell, points[p], scale)
                                           : std::array<double, 4>{ { 1, 0, 0, 0 } };
  }
  return mixtures;
}

Attributes::Mixture MixInTriangle(
  const std::vector<PlanarPoint>& points, const Triangle& cell, const PlanarPoint& place)
{
  Attributes::Mixture mixture{ { { cell[0], cell[1], cell[2], cell[2] } }, {}, true };
  double sum = 0;
  for (int k = 0; k < 3; ++k)
  {
    mixture.Weights[k] = std::max(
      0.0, AreaOf(points[cell[(k + 1) % 3]], points[cell[(k + 2) % 3]], place, PlanarMetric()));
    sum += mixture.Weights[k];
  }
  for (int k = 0; k < 3; ++k)
  {
    mixture.Weights[k] = sum > 0 ? mixture.Weights[k] / sum : 1.0 / 3;
  }
  return mixture;
}
} // namespace vtkInsideOut

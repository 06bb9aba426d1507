// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/Sites.h"

#include "Common/DoubleDouble.h"

#include <cmath>

namespace insideout
{
RoundedSite::RoundedSite(const Site& site)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    double high = 0;
    double low = 0;
    for (int k = 0; k < 4; ++k)
    {
      const double weight = site.Weights[k];
      const double product = weight * site.Corners[k][axis];
      low += weight == 0.25 ? 0 : std::fma(weight, site.Corners[k][axis], -product);
      const DoubleDouble sum = TwoSum(high, product);
      high = sum.High;
      low += sum.Low;
    }
    const DoubleDouble rounded = TwoSum(high, low);
    this->High[axis] = rounded.High;
    this->Low[axis] = rounded.Low;
  }
}

std::vector<Tetrahedron> CellsOfPoints(std::size_t count)
{
  std::vector<Tetrahedron> cells(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Id p = static_cast<Id>(i);
    cells[i] = { { p, p, p, p } };
  }
  return cells;
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/LayerParameters.h"

#include "Common/Error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace insideout
{
void CheckLayerParameters(const LayerParameters& parameters)
{
  if (parameters.Layers < 1)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the number of layers is " + std::to_string(parameters.Layers) + "; it has to be 1 or more");
  }
  if (!(parameters.FirstHeight > 0) || !std::isfinite(parameters.FirstHeight))
  {
    throw Error(ErrorCode::InvalidParameter, "the height of the first layer has to be positive");
  }
  if (!(parameters.Growth > 0) || !std::isfinite(parameters.Growth))
  {
    throw Error(ErrorCode::InvalidParameter, "the growth of layers has to be positive");
  }
  LayerParameters largest = parameters; // FractionsOfLayers begins with 1
  largest.FirstHeight = std::max(1.0, parameters.FirstHeight);
  if (!std::isfinite(HeightOfAll(largest)))
  {
    throw Error(ErrorCode::InvalidParameter,
      "the height of " + std::to_string(parameters.Layers) + " layers overflows at this growth");
  }
}

double HeightOfAll(const LayerParameters& parameters)
{
  double sum = 0;
  double height = parameters.FirstHeight;
  for (int layer = 0; layer < parameters.Layers; ++layer, height *= parameters.Growth)
  {
    sum += height;
  }
  return sum;
}

std::vector<double> FractionsOfLayers(int layers, double growth)
{
  std::vector<double> fractions = { 0 };
  double height = 1;
  for (int layer = 0; layer < layers; ++layer, height *= growth)
  {
    fractions.push_back(fractions.back() + height);
  }
  const double all = fractions.back();
  for (double& fraction : fractions)
  {
    fraction /= all;
  }
  return fractions;
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace insideout
{
struct LayerParameters
{
  int Layers = 3;
  double FirstHeight = 0; ///< of the layer at the wall
  double Growth = 1.2;    ///< ratio of a layer's height to that of the layer before
};

/** @throws Error InvalidParameter for parameters out of range */
void CheckLayerParameters(const LayerParameters& parameters);

/** The height of all layers. */
double HeightOfAll(const LayerParameters& parameters);

/**
 * The positions of the borders of layers, as fractions of the way from the wall: 0, and up to 1.
 */
std::vector<double> FractionsOfLayers(int layers, double growth);
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SurfaceReaders.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace insideout
{
/**
 * Colors in the two spare bytes of the facets of binary STL, five bits for each component, in two
 * dialects. Magics has `COLOR=` and four bytes in the title, the lowest bits are red, and the
 * highest bit says that the facet has the title's color. Elsewhere (VisCAM, SolidView) the lowest
 * bits are blue, and the highest bit says that there is a color.
 */
class StlColors
{
public:
  explicit StlColors(std::string_view title);

  /** Add the spare bytes of the next facet. */
  void Add(std::uint16_t bits);

  /** Give the polygons `Colors` if all have one, and a warning if only some have. */
  void MoveTo(PolygonSurface& surface, const FileContent& file);

private:
  using Color = std::array<unsigned char, 3>;

  bool IsMagics = false;
  Color OfTitle{};
  std::uint64_t Facets = 0;
  std::vector<unsigned char> Values; ///< number of facets with a color
};
} // namespace insideout

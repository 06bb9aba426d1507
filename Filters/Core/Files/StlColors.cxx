// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/StlColors.h"

#include <algorithm>

namespace insideout
{
namespace
{
constexpr std::uint16_t HighestBit = 0x8000;

/** Five bits scaled to a byte. */
unsigned char Component(std::uint16_t bits, int place)
{
  constexpr int most = 31;
  return static_cast<unsigned char>(((bits >> (5 * place)) & most) * 255 / most);
}
} // namespace

StlColors::StlColors(std::string_view title)
{
  constexpr std::string_view mark = "COLOR=";
  const std::size_t at = title.find(mark);
  this->IsMagics = at != std::string_view::npos && at + mark.size() + 4 <= title.size();
  if (this->IsMagics)
  {
    std::transform(title.begin() + at + mark.size(), title.begin() + at + mark.size() + 3,
      this->OfTitle.begin(), [](char c) { return static_cast<unsigned char>(c); });
  }
}

void StlColors::Add(std::uint16_t bits)
{
  ++this->Facets;
  const bool isHighest = (bits & HighestBit) != 0;
  if (!this->IsMagics && !isHighest)
  {
    return;
  }
  Color color = { Component(bits, 0), Component(bits, 1), Component(bits, 2) };
  if (!this->IsMagics)
  {
    std::swap(color[0], color[2]);
  }
  else if (isHighest)
  {
    color = this->OfTitle;
  }
  this->Values.insert(this->Values.end(), color.begin(), color.end());
}

void StlColors::MoveTo(PolygonSurface& surface, const FileContent& file)
{
  const std::uint64_t colored = this->Values.size() / 3;
  if (colored == this->Facets && colored > 0)
  {
    surface.PolygonAttributes.push_back({ "Colors", 3, std::move(this->Values) });
  }
  else if (colored > 0)
  {
    surface.Warnings.push_back(file.Name + ": colors of " + std::to_string(colored) + " of " +
      std::to_string(this->Facets) + " triangles were skipped, because the others have none");
  }
}
} // namespace insideout

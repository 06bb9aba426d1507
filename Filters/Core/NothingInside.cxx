// SPDX-License-Identifier: GPL-3.0-or-later
#include "NothingInside.h"

#include "WindingNumber/WindingNumberOfCells.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** The cause, and the remedy. @param[in] least,most of w */
std::string LikelyCause(const HullMesh& hull, double least, double most)
{
  const std::vector<std::int16_t>& multiplicity = hull.Surface.Multiplicity;
  if (hull.Counts.NonParticipatingFacets == hull.Counts.Facets)
  {
    return "No facet participates: see NonParticipatingArrayName";
  }
  if (std::all_of(multiplicity.begin(), multiplicity.end(), [](int m) { return m == 0; }))
  {
    return "The surface is two-sided: its facets cancel in pairs. Give each once, leave one side "
           "out by NonParticipatingArrayName, or set ConstrainFacets to keep thin solids";
  }
  // Near sheets each contributes anything between -1/2 and 1/2 to w, which tells no orientation.
  const bool isAllSheets =
    static_cast<Id>(hull.SheetTriangles.size()) + hull.Counts.DegenerateFacets ==
    hull.Counts.InputTriangles;
  if (!isAllSheets && least < -0.5 && SignedContent(hull.Mesh, hull.W) < 0)
  {
    return "The surface is inside out: set Orientation to Automatic, or to the other way";
  }
  // Around a consistently oriented closed surface w is a whole number.
  const bool isClosed = hull.Counts.OpenEdges == 0;
  const bool smoothedAway = most > 0.5 && !(isClosed && most != std::round(most));
  if (smoothedAway)
  {
    return "The graph cut smoothed away where w is above 1/2: set Gamma lower, 0 to keep it all";
  }
  if (!isAllSheets && (isClosed || least < -0.5))
  {
    return "The surface faces both ways, and its parts cancel: set Orientation to Automatic";
  }
  const std::string counting = hull.Counts.DuplicateFacets > 0
    ? "set CountDuplicates if its sheets are meant to add up, "
    : std::string();
  const std::string turning =
    least < -0.5 ? "set Orientation to Reverse if it faces inward, " : std::string();
  return "The surface is too open, w is nowhere above 1/2: close its largest holes, " + turning +
    counting + "take a lower threshold of w, or set Thicken to give its sheets a width";
}
} // namespace

std::string NothingInside(const HullMesh& hull)
{
  const auto [least, most] = std::minmax_element(hull.W.begin(), hull.W.end());
  return "nothing is inside: w ranges from " + std::to_string(*least) + " to " +
    std::to_string(*most) + ". " + LikelyCause(hull, *least, *most);
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/JoinThinHoles.h"

#include "Refine/SurfacePiece.h"
#include "Refine/TriangleTree.h"

#include <algorithm>
#include <map>

namespace insideout
{
void JoinThinHoles(const std::vector<Id>& regions, const RefinementParameters& parameters,
  double distance, std::vector<FacetOfInput>& facets)
{
  if (parameters.LabelOfHoles == None || parameters.Labels.empty())
  {
    return;
  }
  std::map<std::array<Id, 2>, Id> numbers;
  const auto numberOfRegions = [&](const FacetOfInput& facet)
  {
    std::array<Id, 2> sides = { { None, None } };
    for (int i = 0; i < 2; ++i)
    {
      const Id face = facet.Faces[i];
      sides[i] = face == None ? None : regions.empty() ? 0 : regions[face / 4];
    }
    std::sort(sides.begin(), sides.end());
    return numbers.emplace(sides, static_cast<Id>(numbers.size())).first->second;
  };
  std::vector<FacetOfInput*> holes;
  std::vector<LabelledTriangle> others;
  std::vector<Id> labelsOfOthers;
  for (FacetOfInput& facet : facets)
  {
    if (parameters.Labels[facet.Faces[0] / 4][facet.Faces[0] % 4] == parameters.LabelOfHoles)
    {
      holes.push_back(&facet);
    }
    else
    {
      others.push_back({ facet.Corners, numberOfRegions(facet) });
      labelsOfOthers.push_back(facet.Label);
    }
  }
  const TriangleTree tree(others);
  for (FacetOfInput* hole : holes)
  {
    const Id number = numberOfRegions(*hole);
    const TriangleTree::Nearest center = tree.NearestTo(CentreOf(hole->Corners), number, None);
    if (!(center.Distance <= distance))
    {
      continue;
    }
    std::array<TriangleTree::Nearest, 3> near;
    for (int k = 0; k < 3; ++k)
    {
      near[k] = tree.NearestTo(hole->Corners[k], number, center.Triangle);
    }
    if (tree.IsWithin({ hole->Corners, number }, distance, near))
    {
      hole->Label = labelsOfOthers[center.Triangle];
    }
  }
}
} // namespace insideout

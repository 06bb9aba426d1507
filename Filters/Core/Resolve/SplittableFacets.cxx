// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/SplittableFacets.h"

#include <algorithm>
#include <iterator>

namespace insideout
{
bool HasCorner(const Triangle& corners, Id point)
{
  return std::find(corners.begin(), corners.end(), point) != corners.end();
}

SplittableFacets::SplittableFacets(std::size_t numberOfPoints, const std::vector<Triangle>& facets)
  : Given(facets)
  , AtPoints(numberOfPoints,
      [&](auto visit)
      {
        for (std::size_t f = 0; f < facets.size(); ++f)
        {
          for (const Id p : facets[f])
          {
            visit(static_cast<std::size_t>(p), static_cast<Id>(f));
          }
        }
      })
  , IsAlive(facets.size(), 1)
{
}

const Triangle& SplittableFacets::CornersOf(Id f) const
{
  const Id given = static_cast<Id>(this->Given.size());
  return f < given ? this->Given[f] : this->Added[f - given].Corners;
}

Id SplittableFacets::ParentOf(Id f) const
{
  const Id given = static_cast<Id>(this->Given.size());
  return f < given ? f : this->Added[f - given].Parent;
}

std::vector<Id> SplittableFacets::FacetsAlong(const Edge& edge) const
{
  std::vector<Id> facets;
  for (const Id f : this->AtPoints[edge[0]])
  {
    if (this->IsAlive[f] && HasCorner(this->Given[f], edge[1]))
    {
      facets.push_back(f);
    }
  }
  const auto added = this->AddedAlong.find(edge);
  if (added != this->AddedAlong.end())
  {
    std::copy_if(added->second.begin(), added->second.end(), std::back_inserter(facets),
      [&](Id f) { return this->IsAlive[f] != 0; });
  }
  return facets;
}

std::vector<ReplacedFacet> SplittableFacets::PartsOfSplit(const Edge& edge, Id point) const
{
  std::vector<ReplacedFacet> parts;
  for (const Id f : this->FacetsAlong(edge))
  {
    if (HasCorner(this->CornersOf(f), point))
    {
      continue;
    }
    for (const Id replaced : edge)
    {
      parts.push_back({ this->CornersOf(f), this->ParentOf(f) });
      Triangle& corners = parts.back().Corners;
      std::replace(corners.begin(), corners.end(), replaced, point);
    }
  }
  return parts;
}

Id SplittableFacets::Split(const Edge& edge, Id point)
{
  const Id first = this->Count();
  this->Replace(this->FacetsAlong(edge), this->PartsOfSplit(edge, point));
  return first;
}

void SplittableFacets::SplitFacet(Id f, Id point)
{
  std::vector<ReplacedFacet> parts(3, { this->CornersOf(f), this->ParentOf(f) });
  for (int k = 0; k < 3; ++k)
  {
    parts[k].Corners[k] = point;
  }
  this->Replace({ f }, parts);
}

void SplittableFacets::Replace(
  const std::vector<Id>& facets, const std::vector<ReplacedFacet>& parts)
{
  for (const Id f : facets)
  {
    this->IsAlive[f] = 0;
  }
  for (const ReplacedFacet& part : parts)
  {
    const Id f = this->Count();
    this->Added.push_back(part);
    this->IsAlive.push_back(1);
    for (int k = 0; k < 3; ++k)
    {
      this->AddedAlong[EdgeBetween(part.Corners[k], part.Corners[(k + 1) % 3])].push_back(f);
    }
  }
}

Replacement SplittableFacets::Result() const
{
  Replacement result;
  const Id given = static_cast<Id>(this->Given.size());
  for (Id f = 0; f < this->Count(); ++f)
  {
    if (f < given && !this->IsAlive[f])
    {
      result.Removed.push_back(f);
    }
    if (f >= given && this->IsAlive[f])
    {
      result.Added.push_back(this->Added[f - given]);
    }
  }
  return result;
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverLostFacets.h"

#include "Exact/EngineLimits.h"
#include "Exact/Phases.h"
#include "Exact/ValidFacets.h"

#include <utility>

namespace insideout
{
void LostFacetRecovery::Recover(const std::vector<Point>& points, SegmentRecovery::From from)
{
  WorkBudget& work = this->Constrained.Mesh.Work();
  const std::int64_t begin = work.Spent();
  const std::int64_t mostWork = begin + EngineLimits::WorkOnLostFacets;
  std::vector<Id> lost = this->Constrained.FindLost(this->Progress);
  const std::set<Id> hopeless = lost.empty()
    ? std::set<Id>()
    : FacetsThatCross(points, this->Constrained.Facets, this->Progress);
  std::vector<Id> wanted = Without(hopeless, lost);
  this->Constrained.Mesh.ForgetUnused();
  for (int tries = 0; !wanted.empty() && work.Spent() - begin < mostWork && !work.IsUsedUp();
       ++tries)
  {
    this->Progress.Check(Phases::RecoveringLostFacets,
      static_cast<double>(work.Spent() - begin) / static_cast<double>(mostWork));
    from = from == SegmentRecovery::From::LowerEnd ? SegmentRecovery::From::HigherEnd
                                                   : SegmentRecovery::From::LowerEnd;
    this->Constrained.Mesh.StartJournal();
    const SegmentTable segments = this->Constrained.Segments;
    bool isBetter =
      this->Recreate(this->ChooseRuins(wanted), from, tries >= EngineLimits::TriesBeforeSplitting);
    std::vector<Id> now;
    if (isBetter)
    {
      now = this->Constrained.FindLost(this->Progress);
      isBetter = now.size() <= lost.size();
    }
    if (isBetter)
    {
      this->Constrained.Mesh.EndJournal();
      lost = std::move(now);
      wanted = Without(hopeless, lost);
    }
    else
    {
      this->Constrained.Mesh.GoBack();
      this->Constrained.Segments = segments;
    }
    work.Spend(this->Constrained.Mesh.NumberOfCells());
  }
}

/** The lost facets and those around one of their corners, in any order. */
std::vector<Id> LostFacetRecovery::ChooseRuins(const std::vector<Id>& lost)
{
  const Triangle& facet = this->Constrained.Facets[lost[this->Random() % lost.size()]];
  // One after the other: compilers do not agree which argument of a call comes first.
  const int rings = static_cast<int>(this->Random() % EngineLimits::RingsOfRuins);
  const Id corner = facet[this->Random() % 3];
  std::set<Id> ruins = this->Constrained.FacetsAround({ corner }, rings);
  ruins.insert(lost.begin(), lost.end());
  this->AddFacetsBesideSteinerPoints(ruins);
  std::vector<Id> order(ruins.begin(), ruins.end());
  for (std::size_t k = order.size() - 1; k > 0; --k)
  {
    std::swap(order[k], order[this->Random() % (k + 1)]);
  }
  return order;
}

/** Points on their edges are rounded: these can only go together with all facets there. */
void LostFacetRecovery::AddFacetsBesideSteinerPoints(std::set<Id>& facets) const
{
  const SegmentTable& segments = this->Constrained.Segments;
  std::set<Id> split;
  bool grows = true;
  while (grows)
  {
    for (const Id segment : this->Constrained.SegmentsOf({ facets.begin(), facets.end() }))
    {
      if (segments.IsSplit(segment))
      {
        split.insert(segment);
      }
    }
    const std::size_t before = facets.size();
    for (Id facet = 0; facet < static_cast<Id>(this->Constrained.Facets.size()); ++facet)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (split.count(segments.OfFacet(facet, k)) > 0)
        {
          facets.insert(facet);
        }
      }
    }
    grows = facets.size() > before;
  }
}

bool LostFacetRecovery::Recreate(
  const std::vector<Id>& ruins, SegmentRecovery::From from, bool maySplitBeside)
{
  FlippableMesh& mesh = this->Constrained.Mesh;
  SegmentTable& segments = this->Constrained.Segments;
  const std::int64_t since = mesh.NumberOfChanges();
  this->Constrained.LetGo({ ruins.begin(), ruins.end() });
  SteinerPoints(mesh, segments, this->Progress).Tidy(mesh.Infinite() + 1, since);
  this->ShakeCorners(ruins);
  for (const Id segment : this->Constrained.SegmentsOf(ruins))
  {
    segments.Restore(segment);
  }
  std::set<Id> givenUp;
  return this->Recovery.RecoverAndRound(ruins, from, maySplitBeside, since, givenUp);
}

/** Other cells around facets to begin with: else flips would go the same way again. */
void LostFacetRecovery::ShakeCorners(const std::vector<Id>& facets)
{
  std::set<Id> corners;
  for (const Id facet : facets)
  {
    const Triangle& triangle = this->Constrained.Facets[facet];
    corners.insert(triangle.begin(), triangle.end());
  }
  SteinerPoints steiner(this->Constrained.Mesh, this->Constrained.Segments, this->Progress);
  for (const Id corner : corners)
  {
    steiner.FlipAround(corner, this->Random);
  }
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverLostFacets.h"

#include "Exact/Phases.h"
#include "Exact/RecoverConstraints.h"
#include "Exact/RecoverFacets.h"
#include "Exact/SteinerPoints.h"
#include "Exact/ValidFacets.h"

#include <utility>

namespace insideout
{
namespace
{
/** Facets are released in fewer than this many rings of cells around a lost one. */
constexpr unsigned RingsOfRuins = 3;

/** Work limit for lost facets, besides as much as everything before took: a second or two. */
constexpr std::int64_t WorkOnLostFacets = 100000000;

/**
 * Points on the edges of facets are rounded: they can only be removed together with all facets
 * there.
 */
void AddFacetsBesideSteinerPoints(const ExactState& state, std::set<Id>& facets)
{
  std::set<Id> split;
  for (std::size_t before = 0; facets.size() > before;)
  {
    for (const Id segment : state.SegmentsOf({ facets.begin(), facets.end() }))
    {
      if (state.Segments.IsSplit(segment))
      {
        split.insert(segment);
      }
    }
    before = facets.size();
    for (Id facet = 0; facet < static_cast<Id>(state.Facets.size()); ++facet)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (split.count(state.Segments.OfFacet(facet, k)) > 0)
        {
          facets.insert(facet);
        }
      }
    }
  }
}

/** The lost facets and those around one of their corners, in any order. */
std::vector<Id> ChooseRuins(ExactState& state, const std::vector<Id>& lost)
{
  std::mt19937& random = state.Random;
  const Triangle& facet = state.Facets[lost[random() % lost.size()]];
  // Separate statements: compilers evaluate arguments of a call in different orders.
  const int rings = static_cast<int>(random() % RingsOfRuins);
  const Id corner = facet[random() % 3];
  std::set<Id> ruins = state.FacetsAround({ corner }, rings);
  ruins.insert(lost.begin(), lost.end());
  AddFacetsBesideSteinerPoints(state, ruins);
  std::vector<Id> order(ruins.begin(), ruins.end());
  for (std::size_t k = order.size() - 1; k > 0; --k)
  {
    std::swap(order[k], order[random() % (k + 1)]);
  }
  return order;
}

/** Change the cells around facets first; otherwise flips would take the same course again. */
void ShakeCorners(ExactState& state, const std::vector<Id>& facets)
{
  std::set<Id> corners;
  for (const Id facet : facets)
  {
    corners.insert(state.Facets[facet].begin(), state.Facets[facet].end());
  }
  for (const Id corner : corners)
  {
    FlipAround(state, corner);
  }
}

bool Recreate(ExactState& state, const std::vector<Id>& ruins, SplitFrom from)
{
  const std::int64_t since = state.Mesh.NumberOfChanges();
  state.LetGo({ ruins.begin(), ruins.end() });
  Tidy(state, state.Mesh.Infinite() + 1, since);
  ShakeCorners(state, ruins);
  for (const Id segment : state.SegmentsOf(ruins))
  {
    state.Segments.Restore(segment);
  }
  std::set<Id> givenUp;
  return RecoverConstraints(state, ruins, from, since, givenUp);
}
} // namespace

void RecoverLostFacets(ExactState& state, const std::vector<Point>& points, SplitFrom from)
{
  WorkBudget& work = state.Mesh.Work();
  const std::int64_t begin = work.Spent();
  const std::int64_t mostWork = begin + WorkOnLostFacets;
  std::vector<Id> lost = FindLostFacets(state);
  const std::set<Id> hopeless = FacetsThatCross(points, state.Facets, lost, *state.Progress);
  std::vector<Id> wanted = Without(hopeless, lost);
  state.Mesh.ForgetUnused();
  while (!wanted.empty() && work.Spent() - begin < mostWork && !work.IsUsedUp())
  {
    state.Report(Phases::RecoveringLostFacets,
      static_cast<double>(work.Spent() - begin) / static_cast<double>(mostWork));
    from = from == SplitFrom::Middle ? SplitFrom::HigherEnd : SplitFrom::Middle;
    state.Mesh.StartJournal();
    const SegmentTable segments = state.Segments;
    std::vector<Id> now;
    bool isBetter = Recreate(state, ChooseRuins(state, wanted), from);
    if (isBetter)
    {
      now = FindLostFacets(state);
      isBetter = now.size() <= lost.size();
    }
    if (isBetter)
    {
      state.Mesh.EndJournal();
      lost = std::move(now);
      wanted = Without(hopeless, lost);
    }
    else
    {
      state.Mesh.GoBack();
      state.Segments = segments;
    }
    work.Spend(state.Mesh.NumberOfCells());
  }
}
} // namespace insideout

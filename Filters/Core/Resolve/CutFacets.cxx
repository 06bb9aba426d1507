// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/CutFacets.h"

#include "Common/DisjointSets.h"
#include "Resolve/FacetMeeting.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Facets of one plane, and the cuts by other facets. */
struct Group
{
  std::vector<Id> Facets;
  std::vector<Cut> Cuts;
};

std::vector<Group> MakeGroups(std::size_t numberOfFacets,
  const std::vector<std::array<Id, 2>>& pairs, const std::vector<Meeting>& meetings)
{
  DisjointSets groups(numberOfFacets);
  std::vector<char> involved(numberOfFacets, 0);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    involved[pairs[i][0]] = involved[pairs[i][1]] = 1;
    if (meetings[i].Overlap)
    {
      groups.Join(pairs[i][0], pairs[i][1]);
    }
  }

  std::vector<Group> result;
  std::vector<Id> groupOf(numberOfFacets, None);
  for (Id f = 0; f < static_cast<Id>(numberOfFacets); ++f)
  {
    if (involved[f])
    {
      const Id root = groups.Find(f);
      if (root == f)
      {
        groupOf[f] = static_cast<Id>(result.size());
        result.emplace_back();
      }
      groupOf[f] = groupOf[root];
      result[groupOf[f]].Facets.push_back(f);
    }
  }
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const Meeting& meeting = meetings[i];
    if (!meeting.Overlap)
    {
      for (int k = 0; k < 2; ++k)
      {
        const Id other = meeting.InPlane ? None : pairs[i][1 - k];
        result[groupOf[pairs[i][k]]].Cuts.push_back({ meeting.First, meeting.Last, other });
      }
    }
  }
  return result;
}
} // namespace

std::vector<PlanarSubdivision> CutFacets(const FacetList& surface,
  const std::vector<std::array<Id, 2>>& pairs, Monitor& monitor, const ProgressRange& progress)
{
  const double middle = (progress.Begin + progress.End) / 2;
  std::vector<Meeting> meetings(pairs.size());
  const double nanosecondsPerPair = 600;
  ParallelLoop(static_cast<Id>(pairs.size()), nanosecondsPerPair, monitor,
    { progress.Stage, progress.Begin, middle },
    [&](Id i) { meetings[i] = Meet(surface, pairs[i][0], pairs[i][1]); });

  const std::vector<Group> groups = MakeGroups(surface.Facets.size(), pairs, meetings);
  std::vector<PlanarSubdivision> subdivisions(groups.size());
  const double nanosecondsPerGroup = 8000; // of one facet with one or two cuts
  ParallelLoop(static_cast<Id>(groups.size()), nanosecondsPerGroup, monitor,
    { progress.Stage, middle, progress.End },
    [&](Id i) { subdivisions[i] = SubdividePlane(surface, groups[i].Facets, groups[i].Cuts); });
  return subdivisions;
}
} // namespace insideout

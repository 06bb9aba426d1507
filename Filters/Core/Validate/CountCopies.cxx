// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/CountCopies.h"

#include "Common/Buckets.h"
#include "Common/DisjointSets.h"
#include "Common/FacetComplex.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/**
 * A gain has to exceed this fraction of a set's boundary; less may be the rounding of its length.
 */
constexpr double LeastGain = 1e-9;

bool IsGivenAgain(const FacetCopies& given)
{
  return given.Along + given.Against > 1;
}

FacetCopies OncePerOrientation(const FacetCopies& given)
{
  return { given.Along > 0, given.Against > 0 };
}

/** The count along an edge added by one more copy of a set's facets. */
struct SetAtEdge
{
  Id Edge;
  int Direction;
};

/**
 * Adjacent facets with the same numbers of copies get the same count: counts are chosen per set of
 * them.
 */
class CopyChoice
{
public:
  CopyChoice(
    const FacetComplex& surface, const FacetEdges& edges, const std::vector<FacetCopies>& given)
    : Set(given.size(), None)
  {
    this->FindSets(edges, given);
    this->FindEdges(surface, edges, given);
  }

  struct Choice
  {
    std::vector<FacetCopies> Counts; ///< one per set
    double OpenLength;
  };

  /** Add copies (step 1) to those of the start, or remove them (step -1) until one is left. */
  Choice Choose(const std::vector<FacetCopies>& start, int step) const
  {
    Choice choice = { start, 0 };
    std::vector<std::int64_t> sums = this->Sums;
    for (std::size_t set = 0; set < start.size(); ++set)
    {
      const FacetCopies once = OncePerOrientation(this->Given[set]);
      const std::int64_t more =
        (start[set].Along - once.Along) - (start[set].Against - once.Against);
      this->Add(set, more, sums);
    }
    bool changed = true;
    while (changed)
    {
      changed = false;
      for (std::size_t set = 0; set < start.size(); ++set)
      {
        const FacetCopies once = OncePerOrientation(this->Given[set]);
        FacetCopies& counts = choice.Counts[set];
        const auto isBetter = [&](std::int64_t count, std::int64_t least, int sign)
        {
          return count >= least
            ? this->Gain(set, sign * step, sums) > LeastGain * this->Lengths[set]
            : counts.Along + counts.Against > 1 && this->Closes(set, sign * step, sums);
        };
        const auto change = [&](
                              std::int64_t& count, std::int64_t least, std::int64_t most, int sign)
        {
          while (count + step >= 0 && count + step <= most && isBetter(count + step, least, sign))
          {
            count += step;
            this->Add(set, sign * step, sums);
            changed = true;
          }
        };
        change(counts.Along, once.Along, this->Given[set].Along, 1);
        change(counts.Against, once.Against, this->Given[set].Against, -1);
      }
    }
    for (std::size_t e = 0; e < sums.size(); ++e)
    {
      choice.OpenLength += this->EdgeLengths[e] * static_cast<double>(std::abs(sums[e]));
    }
    return choice;
  }

  std::vector<Id> Set;            ///< one per facet, None if it is given once
  std::vector<FacetCopies> Given; ///< one per set

private:
  void FindSets(const FacetEdges& edges, const std::vector<FacetCopies>& given)
  {
    DisjointSets sets(given.size());
    ForEachEdge(edges,
      [&](const FacetEdge* first, const FacetEdge* last)
      {
        for (const FacetEdge* edge = first; edge != last; ++edge)
        {
          for (const FacetEdge* other = first; other != edge; ++other)
          {
            if (edge->Direction != other->Direction && IsGivenAgain(given[edge->Facet]) &&
              given[edge->Facet] == given[other->Facet])
            {
              sets.Join(edge->Facet, other->Facet);
            }
          }
        }
      });
    for (Id f = 0; f < static_cast<Id>(given.size()); ++f)
    {
      if (IsGivenAgain(given[f]))
      {
        const Id lowest = sets.Find(f);
        if (lowest == f)
        {
          this->Set[f] = static_cast<Id>(this->Given.size());
          this->Given.push_back(given[f]);
        }
        this->Set[f] = this->Set[lowest];
      }
    }
  }

  /** The edges of sets, and the signed count along them of all facets, each counted once. */
  void FindEdges(
    const FacetComplex& surface, const FacetEdges& edges, const std::vector<FacetCopies>& given)
  {
    const std::vector<Point> points =
      ScaledPoints(surface.Points, -LargestExponent(surface.Points));
    this->Lengths.assign(this->Given.size(), 0);
    std::vector<std::pair<Id, SetAtEdge>> boundary;
    ForEachEdge(edges,
      [&](const FacetEdge* first, const FacetEdge* last)
      {
        const std::size_t before = boundary.size();
        std::int64_t sum = 0;
        for (const FacetEdge* edge = first; edge != last; ++edge)
        {
          const FacetCopies once = OncePerOrientation(given[edge->Facet]);
          sum += edge->Direction * (once.Along - once.Against);
          const Id set = this->Set[edge->Facet];
          if (set != None)
          {
            const auto begin = boundary.begin() + static_cast<std::ptrdiff_t>(before);
            const auto found =
              std::find_if(begin, boundary.end(), [&](const auto& at) { return at.first == set; });
            if (found != boundary.end())
            {
              found->second.Direction += edge->Direction;
            }
            else
            {
              boundary.push_back({ set, { static_cast<Id>(this->Sums.size()), edge->Direction } });
            }
          }
        }
        const auto isWithin = [](const auto& at) { return at.second.Direction == 0; };
        boundary.erase(std::remove_if(boundary.begin() + static_cast<std::ptrdiff_t>(before),
                         boundary.end(), isWithin),
          boundary.end());
        if (boundary.size() > before)
        {
          this->Sums.push_back(sum);
          this->EdgeLengths.push_back(Distance(points[first->Low], points[first->High]));
        }
      });
    this->Boundary = Buckets<SetAtEdge>(this->Given.size(),
      [&](auto visit)
      {
        for (const auto& [set, at] : boundary)
        {
          visit(static_cast<std::size_t>(set), at);
        }
      });
    for (const auto& [set, at] : boundary)
    {
      this->Lengths[set] += this->EdgeLengths[at.Edge] * std::abs(at.Direction);
    }
  }

  /** The decrease of the open boundary when a set's count is increased. */
  double Gain(std::size_t set, std::int64_t more, const std::vector<std::int64_t>& sums) const
  {
    double gain = 0;
    for (const SetAtEdge& at : this->Boundary[set])
    {
      const std::int64_t sum = sums[at.Edge];
      gain += this->EdgeLengths[at.Edge] *
        static_cast<double>(std::abs(sum) - std::abs(sum + more * at.Direction));
    }
    return gain;
  }

  /** Whether the open boundary at a set vanishes when the set's count is increased. */
  bool Closes(std::size_t set, std::int64_t more, const std::vector<std::int64_t>& sums) const
  {
    const auto boundary = this->Boundary[set];
    return boundary.begin() != boundary.end() &&
      std::all_of(boundary.begin(), boundary.end(),
        [&](const SetAtEdge& at) { return sums[at.Edge] + more * at.Direction == 0; });
  }

  void Add(std::size_t set, std::int64_t more, std::vector<std::int64_t>& sums) const
  {
    for (const SetAtEdge& at : this->Boundary[set])
    {
      sums[at.Edge] += more * at.Direction;
    }
  }

  std::vector<double> Lengths;    // lengths of the sets' boundaries
  Buckets<SetAtEdge> Boundary;    // of the sets
  std::vector<std::int64_t> Sums; // signed counts along these, each facet counted once
  std::vector<double> EdgeLengths;
};
} // namespace

std::vector<FacetCopies> CountCopies(
  const FacetComplex& surface, const FacetEdges& edges, const std::vector<FacetCopies>& given)
{
  std::vector<FacetCopies> counts;
  counts.reserve(given.size());
  std::transform(given.begin(), given.end(), std::back_inserter(counts), OncePerOrientation);
  if (std::none_of(given.begin(), given.end(), IsGivenAgain))
  {
    return counts;
  }
  const CopyChoice choice(surface, edges, given);
  std::vector<FacetCopies> once;
  std::transform(
    choice.Given.begin(), choice.Given.end(), std::back_inserter(once), OncePerOrientation);
  const CopyChoice::Choice added = choice.Choose(choice.Choose(once, 1).Counts, -1);
  const CopyChoice::Choice taken = choice.Choose(choice.Given, -1);
  const bool fewer = taken.OpenLength < (1 - LeastGain) * added.OpenLength;
  const std::vector<FacetCopies>& chosen = fewer ? taken.Counts : added.Counts;
  for (std::size_t f = 0; f < given.size(); ++f)
  {
    if (choice.Set[f] != None)
    {
      counts[f] = chosen[choice.Set[f]];
    }
  }
  return counts;
}
} // namespace insideout

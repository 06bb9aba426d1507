// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/MergePieces.h"

#include "Common/LoopProgress.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Tetrahedralize/PiecesOfFacet.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

namespace insideout
{
namespace
{
/** An input triangle that its pieces on the boundary cover. */
struct Candidate
{
  Triangle Whole; ///< turned outward
  std::vector<Id> Pieces;
  /// points along each edge, including ends, from the lower end
  std::array<std::vector<Id>, 3> Edges;
  std::vector<Id> Inner; ///< points in its interior
  bool IsOut = false;

  bool HasEdge(const std::vector<Id>& edge) const
  {
    return std::find(this->Edges.begin(), this->Edges.end(), edge) != this->Edges.end();
  }
};

/** Whether the pieces cover the triangle, all with one orientation; sets the candidate. */
bool MatchCandidate(
  const Triangle& given, const std::vector<Triangle>& pieces, Candidate& candidate)
{
  PiecesOfFacet match;
  if (!MatchPiecesOfFacet(given, pieces, match))
  {
    return false;
  }
  const auto turned = [&](std::size_t p)
  { return SortedTriangle(pieces[p]).Turned != SortedTriangle(match.Pieces[p]).Turned; };
  for (std::size_t p = 1; p < pieces.size(); ++p)
  {
    if (turned(p) != turned(0))
    {
      return false;
    }
  }
  candidate.Whole = turned(0) ? Triangle{ { given[0], given[2], given[1] } } : given;

  std::vector<Id> outline;
  for (int k = 0; k < 3; ++k)
  {
    std::vector<Id>& edge = candidate.Edges[k];
    edge = match.EdgePoints[k];
    edge.insert(edge.begin(), given[k]);
    outline.insert(outline.end(), edge.begin(), edge.end());
    edge.push_back(given[(k + 1) % 3]);
    if (edge.front() > edge.back())
    {
      std::reverse(edge.begin(), edge.end());
    }
  }
  std::sort(outline.begin(), outline.end());
  for (const Triangle& piece : pieces)
  {
    for (const Id p : piece)
    {
      if (!std::binary_search(outline.begin(), outline.end(), p))
      {
        candidate.Inner.push_back(p);
      }
    }
  }
  SortUniquely(candidate.Inner);
  return true;
}

class Merger
{
public:
  Merger(const std::vector<BoundaryTriangle>& triangles, const std::vector<Triangle>& given,
    Monitor& monitor, const ProgressRange& progress);
  std::vector<BoundaryTriangle> Merge();

private:
  void FindCandidates();
  void LeaveOutTwins();
  void LeaveOutWhatOthersNeed();
  bool IsFree(Id candidate) const;
  bool Drops(Id candidate, Id triangle, const std::vector<Id>* edge) const;
  template <typename Visitor>
  void ForEachDropped(const Candidate& candidate, Visitor visit) const;
  LoopProgress Loop(double begin, double end, std::size_t turns) const;

  const std::vector<BoundaryTriangle>& Triangles;
  const std::vector<Triangle>& Given;
  std::vector<Candidate> Candidates;
  std::vector<Id> CandidateOf;                     ///< per triangle, or None
  std::unordered_map<Id, std::vector<Id>> Corners; ///< triangles at each point to be dropped
  Monitor& Watch;
  const ProgressRange Progress;
};

Merger::Merger(const std::vector<BoundaryTriangle>& triangles, const std::vector<Triangle>& given,
  Monitor& monitor, const ProgressRange& progress)
  : Triangles(triangles)
  , Given(given)
  , CandidateOf(triangles.size(), None)
  , Watch(monitor)
  , Progress(progress)
{
}

/** Process a range of the work; the whole work is 1. */
LoopProgress Merger::Loop(double begin, double end, std::size_t turns) const
{
  const double all = this->Progress.End - this->Progress.Begin;
  return { this->Watch,
    { this->Progress.Stage, this->Progress.Begin + begin * all, this->Progress.Begin + end * all },
    turns };
}

void Merger::FindCandidates()
{
  std::map<Id, std::vector<Id>> piecesOf;
  const LoopProgress gathering = this->Loop(0, 0.2, this->Triangles.size());
  for (Id t = 0; t < static_cast<Id>(this->Triangles.size()); ++t)
  {
    gathering.Check(static_cast<std::size_t>(t));
    if (this->Triangles[t].Source != None)
    {
      piecesOf[this->Triangles[t].Source].push_back(t);
    }
  }
  const LoopProgress matching = this->Loop(0.2, 0.5, piecesOf.size());
  std::size_t number = 0;
  for (auto& [source, ids] : piecesOf)
  {
    matching.Check(number++);
    std::vector<Triangle> pieces;
    for (const Id t : ids)
    {
      pieces.push_back(this->Triangles[t].Corners);
    }
    Candidate candidate;
    if (pieces.size() > 1 && MatchCandidate(this->Given[source], pieces, candidate))
    {
      for (const Id t : ids)
      {
        this->CandidateOf[t] = static_cast<Id>(this->Candidates.size());
      }
      candidate.Pieces = std::move(ids);
      this->Candidates.push_back(std::move(candidate));
    }
  }
}

/** Where rounding left a thin cell on a facet, the whole facet may be a face of the boundary as
 * well: the same triangle twice would bound no solid. */
void Merger::LeaveOutTwins()
{
  std::unordered_map<Triangle, int, HashOfTriangle> count;
  const LoopProgress counting = this->Loop(0.5, 0.7, this->Triangles.size());
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    counting.Check(t);
    ++count[SortedTriangle(this->Triangles[t].Corners).Points];
  }
  for (const Candidate& candidate : this->Candidates)
  {
    ++count[SortedTriangle(candidate.Whole).Points];
  }
  for (Candidate& candidate : this->Candidates)
  {
    candidate.IsOut = count[SortedTriangle(candidate.Whole).Points] > 1;
  }
}

/** Call visit(point, edge) for each dropped point; edge is nullptr in the interior. */
template <typename Visitor>
void Merger::ForEachDropped(const Candidate& candidate, Visitor visit) const
{
  for (const Id p : candidate.Inner)
  {
    visit(p, static_cast<const std::vector<Id>*>(nullptr));
  }
  for (const std::vector<Id>& edge : candidate.Edges)
  {
    for (std::size_t i = 1; i + 1 < edge.size(); ++i)
    {
      visit(edge[i], &edge);
    }
  }
}

/** Whether a triangle at a point that the candidate drops is merged as well. */
bool Merger::Drops(Id candidate, Id triangle, const std::vector<Id>* edge) const
{
  const Id other = this->CandidateOf[triangle];
  return other == candidate ||
    (other != None && edge && !this->Candidates[other].IsOut &&
      this->Candidates[other].HasEdge(*edge));
}

bool Merger::IsFree(Id candidate) const
{
  bool free = true;
  this->ForEachDropped(this->Candidates[candidate],
    [&](Id p, const std::vector<Id>* edge)
    {
      const std::vector<Id>& around = this->Corners.at(p);
      free = free &&
        std::all_of(around.begin(), around.end(),
          [&](Id triangle) { return this->Drops(candidate, triangle, edge); });
    });
  return free;
}

void Merger::LeaveOutWhatOthersNeed()
{
  for (const Candidate& candidate : this->Candidates)
  {
    this->ForEachDropped(candidate, [&](Id p, const std::vector<Id>*) { this->Corners[p]; });
  }
  const LoopProgress listing = this->Loop(0.7, 0.8, this->Triangles.size());
  for (Id t = 0; t < static_cast<Id>(this->Triangles.size()); ++t)
  {
    listing.Check(static_cast<std::size_t>(t));
    for (const Id p : this->Triangles[t].Corners)
    {
      const auto found = this->Corners.find(p);
      if (found != this->Corners.end())
      {
        found->second.push_back(t);
      }
    }
  }
  std::vector<Id> unsure;
  for (Id c = static_cast<Id>(this->Candidates.size()) - 1; c >= 0; --c)
  {
    unsure.push_back(c);
  }
  const LoopProgress asking = this->Loop(0.8, 1, unsure.size());
  for (std::size_t visits = 0; !unsure.empty(); ++visits)
  {
    asking.Check(visits);
    const Id c = unsure.back();
    unsure.pop_back();
    if (this->Candidates[c].IsOut ? this->Candidates[c].Pieces.empty() : this->IsFree(c))
    {
      continue;
    }
    // Reject the candidate for good, and queue those around it.
    this->Candidates[c].IsOut = true;
    this->Candidates[c].Pieces.clear();
    this->ForEachDropped(this->Candidates[c],
      [&](Id p, const std::vector<Id>*)
      {
        for (const Id t : this->Corners.at(p))
        {
          if (this->CandidateOf[t] != None && !this->Candidates[this->CandidateOf[t]].IsOut)
          {
            unsure.push_back(this->CandidateOf[t]);
          }
        }
      });
  }
}

std::vector<BoundaryTriangle> Merger::Merge()
{
  this->FindCandidates();
  this->LeaveOutTwins();
  this->LeaveOutWhatOthersNeed();
  std::vector<BoundaryTriangle> result;
  for (Id t = 0; t < static_cast<Id>(this->Triangles.size()); ++t)
  {
    const Id c = this->CandidateOf[t];
    if (c == None || this->Candidates[c].IsOut)
    {
      result.push_back(this->Triangles[t]);
    }
    else if (this->Candidates[c].Pieces.front() == t)
    {
      result.push_back({ this->Candidates[c].Whole, this->Triangles[t].Source });
    }
  }
  return result;
}
} // namespace

std::vector<BoundaryTriangle> MergePieces(const std::vector<BoundaryTriangle>& triangles,
  const std::vector<Triangle>& given, Monitor& monitor, const ProgressRange& progress)
{
  return Merger(triangles, given, monitor, progress).Merge();
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/PartsApart.h"

#include "Common/BoxTree.h"
#include "Common/DisjointSets.h"
#include "Common/LoopProgress.h"
#include "Common/PointPredicates.h"
#include "Common/Stages.h"
#include "Validate/FacetEdges.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** A disjoint-set forest; groups are numbered from 0 by their lowest members. */
struct Groups
{
  explicit Groups(DisjointSets& sets, std::size_t members)
    : Of(members, None)
  {
    for (Id i = 0; i < static_cast<Id>(members); ++i)
    {
      const Id first = sets.Find(i);
      this->Of[i] = first == i ? this->Count++ : this->Of[first];
    }
  }

  std::vector<Id> Of;
  Id Count = 0;
};

/** Points connected by facets. */
Groups PiecesOf(const FacetComplex& surface)
{
  DisjointSets sets(surface.Points.size());
  for (const Triangle& facet : surface.Facets)
  {
    sets.Join(facet[0], facet[1]);
    sets.Join(facet[0], facet[2]);
  }
  return Groups(sets, surface.Points.size());
}

/** Pieces with an edge at which the facets' signed sum is not 0. */
std::vector<char> FindOpen(const FacetComplex& surface, const Groups& pieces)
{
  std::vector<char> isOpen(pieces.Count, 0);
  const FacetEdges edges = SortedFacetEdges(surface.Facets);
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      int sum = 0;
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        sum += edge->Direction * surface.Multiplicity[edge->Facet];
      }
      if (sum != 0)
      {
        isOpen[pieces.Of[first->Low]] = 1;
      }
    });
  return isOpen;
}

/** Planar pieces. The plane is that of any of their facets: none is degenerate. */
std::vector<char> FindFlat(const FacetComplex& surface, const Groups& pieces)
{
  std::vector<char> isFlat(pieces.Count, 1);
  std::vector<Id> facetOf(pieces.Count, None);
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    facetOf[pieces.Of[surface.Facets[f][0]]] = f;
  }
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    const Id piece = pieces.Of[p];
    if (isFlat[piece] && facetOf[piece] != None)
    {
      const auto& [a, b, c] = surface.Facets[facetOf[piece]];
      isFlat[piece] =
        Orient3D(surface.Points[a], surface.Points[b], surface.Points[c], surface.Points[p]) == 0;
    }
  }
  return isFlat;
}

/** Join the open and flat pieces; if all of these are flat, join the first other piece, too. */
void JoinWhatCannotStandAlone(const FacetComplex& surface, const Groups& pieces, DisjointSets& sets)
{
  const std::vector<char> isOpen = FindOpen(surface, pieces);
  const std::vector<char> isFlat = FindFlat(surface, pieces);
  std::vector<Id> together;
  Id other = None;
  for (Id piece = 0; piece < pieces.Count; ++piece)
  {
    if (isOpen[piece] || isFlat[piece])
    {
      together.push_back(piece);
    }
    else if (other == None)
    {
      other = piece;
    }
  }
  if (together.empty())
  {
    return;
  }
  if (other != None &&
    std::all_of(together.begin(), together.end(), [&](Id piece) { return isFlat[piece] != 0; }))
  {
    together.push_back(other);
  }
  for (const Id piece : together)
  {
    sets.Join(together.front(), piece);
  }
}

/** The boxes of the groups of pieces. */
std::vector<Box> BoxesOf(const std::vector<Box>& boxes, const Groups& groups)
{
  std::vector<Box> joined(groups.Count, Box::Empty());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    joined[groups.Of[i]].Add(boxes[i]);
  }
  return joined;
}

/** Join all boxes that meet. @return one group per box */
Groups JoinWhatMeets(const std::vector<Box>& boxes, Monitor& monitor)
{
  DisjointSets sets(boxes.size());
  const BoxTree tree(boxes);
  const LoopProgress progress(monitor, { Stages::Tetrahedralizing, 0, 0 }, boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    progress.Check(i);
    tree.Visit(boxes[i], [&](Id other) { sets.Join(static_cast<Id>(i), other); });
  }
  return Groups(sets, boxes.size());
}
} // namespace

std::vector<Id> PartsApart(const FacetComplex& surface, Monitor& monitor)
{
  const Groups pieces = PiecesOf(surface);
  DisjointSets sets(pieces.Count);
  JoinWhatCannotStandAlone(surface, pieces, sets);
  const Groups standing(sets, pieces.Count);
  std::vector<Id> parts = pieces.Of;
  std::vector<Box> boxes(pieces.Count, Box::Empty());
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    boxes[pieces.Of[p]].Add(surface.Points[p]);
  }
  const auto join = [&](const Groups& groups)
  {
    boxes = BoxesOf(boxes, groups);
    std::transform(parts.begin(), parts.end(), parts.begin(), [&](Id i) { return groups.Of[i]; });
  };
  join(standing);
  // Joined boxes grow, and may then meet others.
  for (std::size_t before = boxes.size() + 1; boxes.size() < before;)
  {
    before = boxes.size();
    join(JoinWhatMeets(boxes, monitor));
  }
  return parts;
}
} // namespace insideout

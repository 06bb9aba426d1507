// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SurfacePieces.h"

#include "Common/Box.h"
#include "Common/ScaledPoints.h"
#include "Common/Stages.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace insideout
{
namespace
{
using Iterator = std::vector<Id>::iterator;

class Cutter
{
public:
  Cutter(const FacetComplex& surface, Monitor& monitor)
    : Surface(surface)
    , Scale(-LargestExponent(surface.Points))
    , Progress(monitor)
    , Local(surface.Points.size(), None)
  {
  }

  std::vector<CountedPiece> Cut(Id pieces)
  {
    std::vector<Id> facets(this->Surface.Facets.size());
    std::iota(facets.begin(), facets.end(), 0);
    this->Cut(facets.begin(), facets.end(), pieces);
    return std::move(this->Pieces);
  }

private:
  /** Three times the center, scaled so that it is finite. */
  Point CentreOf(Id facet) const
  {
    Point centre = { 0, 0, 0 };
    for (const Id p : this->Surface.Facets[facet])
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        centre[axis] += this->Scale.Times(this->Surface.Points[p][axis]);
      }
    }
    return centre;
  }

  void Cut(Iterator begin, Iterator end, Id pieces)
  {
    this->Progress.Check(Stages::WindingNumbers, 0);
    if (pieces == 1)
    {
      std::sort(begin, end);
      this->Pieces.push_back(this->PieceOf({ begin, end }));
      return;
    }
    Box box = Box::Empty();
    std::for_each(begin, end, [&](Id facet) { box.Add(this->CentreOf(facet)); });
    const int axis = box.LongestAxis();
    const auto key = [&](Id facet) { return std::pair(this->CentreOf(facet)[axis], facet); };
    const Id share = pieces / 2;
    const Iterator middle = begin + (end - begin) * share / pieces;
    std::nth_element(begin, middle, end, [&](Id a, Id b) { return key(a) < key(b); });
    this->Cut(begin, middle, share);
    this->Cut(middle, end, pieces - share);
  }

  CountedPiece PieceOf(std::vector<Id> facets)
  {
    CountedPiece piece;
    FacetComplex& surface = piece.Surface;
    std::vector<Id> used;
    for (const Id facet : facets)
    {
      surface.Facets.push_back(this->Surface.Facets[facet]);
      surface.Multiplicity.push_back(this->Surface.Multiplicity[facet]);
      for (Id& p : surface.Facets.back())
      {
        Id& local = this->Local[p];
        if (local == None)
        {
          local = static_cast<Id>(used.size());
          used.push_back(p);
          surface.Points.push_back(this->Surface.Points[p]);
        }
        p = local;
      }
    }
    for (const Id p : used)
    {
      this->Local[p] = None;
    }
    piece.WholeFacets = std::move(facets);
    return piece;
  }

  const FacetComplex& Surface;
  const PowerOfTwo Scale;
  Monitor& Progress;
  std::vector<Id> Local; // per point; used for one piece at a time
  std::vector<CountedPiece> Pieces;
};
} // namespace

std::vector<CountedPiece> CutIntoPieces(
  const FacetComplex& surface, Id facetsPerPiece, Monitor& monitor)
{
  const Id full = surface.NumberOfFacets() / facetsPerPiece;
  const bool isMore = surface.NumberOfFacets() % facetsPerPiece > 0;
  return Cutter(surface, monitor).Cut(std::max(full + (isMore ? 1 : 0), 1));
}
} // namespace insideout

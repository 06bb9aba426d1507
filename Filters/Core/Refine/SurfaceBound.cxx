// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SurfaceBound.h"

#include "Common/NearestPoint.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <unordered_set>
#include <utility>

namespace insideout
{
namespace
{
Triangle KeyOf(const Triangle& corners)
{
  return SortedTriangle(corners).Points;
}
} // namespace

bool SurfaceOperator::KeepsLabels(
  const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& moved) const
{
  const auto labelOf = [&](const SurfacePiece& piece)
  { return this->Surface.Facet(piece.Facet).Label; };
  return std::all_of(gone.begin(), gone.end(),
    [&](const SurfacePiece& piece)
    {
      return HasNoArea(piece.Places) ||
        std::any_of(moved.begin(), moved.end(),
          [&](const SurfacePiece& other) { return labelOf(other) == labelOf(piece); });
    });
}

std::vector<LabelledTriangle> TrianglesOf(const std::vector<FacetOfInput>& facets)
{
  std::vector<LabelledTriangle> triangles;
  triangles.reserve(facets.size());
  for (const FacetOfInput& facet : facets)
  {
    triangles.push_back({ facet.Corners, facet.Label });
  }
  return triangles;
}

SurfaceBound::SurfaceBound(const RefinableMesh& mesh, const std::vector<FacetOfInput>& facets,
  SurfaceTreatment treatment, double tolerance, SurfaceBudget* budget)
  : Facets(facets)
  , Tolerance(tolerance)
  , Budget(budget)
  , WatchesAll(treatment == SurfaceTreatment::Remeshed)
  , Boundary(this->Watched(PiecesOf(mesh)))
{
  if (treatment == SurfaceTreatment::Remeshed)
  {
    this->Input = std::make_unique<TriangleTree>(TrianglesOf(facets));
    this->TakeSamples(PiecesOf(mesh));
  }
}

void SurfaceBound::TakeSamples(const std::vector<SurfacePiece>& pieces)
{
  // Each corner and edge once, at one of the pieces that share it.
  std::unordered_set<Id> corners;
  std::unordered_set<Edge, HashOfEdge> edges;
  for (const auto& [ids, places, facet] : pieces)
  {
    const auto add = [this, &samples = this->AtPieces[KeyOf(ids)]](const Point& place)
    {
      samples.push_back(static_cast<Id>(this->Places.size()));
      this->Places.push_back(place);
    };
    add(CentreOf(places));
    for (int i = 0; i < 3; ++i)
    {
      if (corners.insert(ids[i]).second)
      {
        add(places[i]);
      }
      if (edges.insert(EdgeBetween(ids[i], ids[(i + 1) % 3])).second)
      {
        add(Midpoint(places[i], places[(i + 1) % 3]));
      }
    }
  }
}

std::vector<SurfacePiece> SurfaceBound::Watched(const std::vector<SurfacePiece>& pieces) const
{
  std::vector<SurfacePiece> result;
  std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(result),
    [this](const SurfacePiece& piece)
    { return this->WatchesAll || this->Facets[piece.Facet].Faces[1] == None; });
  return result;
}

/** Project the samples of gone pieces onto the nearest fresh ones. @return false for the first that
 * is farther than a distance */
bool SurfaceBound::PutDown(
  const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh, double most)
{
  this->AtFresh.assign(fresh.size(), {});
  std::vector<SquaredDistances> distances;
  distances.reserve(fresh.size());
  for (const SurfacePiece& piece : fresh)
  {
    distances.emplace_back(piece.Places);
  }
  std::size_t nearest = 0; // to the last sample: the next one is not far from it
  for (const SurfacePiece& piece : gone)
  {
    const auto found = this->AtPieces.find(KeyOf(piece.Corners));
    if (found == this->AtPieces.end())
    {
      continue;
    }
    for (const Id sample : found->second)
    {
      const Point& place = this->Places[sample];
      double least = std::numeric_limits<double>::infinity();
      const std::size_t first = nearest;
      for (std::size_t k = 0; k < fresh.size(); ++k)
      {
        const std::size_t i = (first + k) % fresh.size();
        const double squared = distances[i].To(place, least);
        if (squared < least)
        {
          least = squared;
          nearest = i;
        }
      }
      if (!(least <= most * most))
      {
        return false;
      }
      this->AtFresh[nearest].push_back(sample);
    }
  }
  return true;
}

bool SurfaceBound::Allows(const std::vector<SurfacePiece>& gone, std::vector<SurfacePiece>& fresh)
{
  if (!this->Input)
  {
    return AreUnfolded(fresh, NormalOf(gone.front())) && this->Accepts(gone, fresh);
  }
  return LookAlike(gone, fresh) && this->StaysNear(gone, fresh, this->Tolerance) &&
    this->Accepts(gone, fresh);
}

bool SurfaceBound::AllowsEach(const std::vector<SurfacePiece>& moved,
  const std::vector<SurfacePiece>& gone, std::vector<SurfacePiece>& fresh, double share)
{
  return EachLooksAlike(moved, fresh, 0) && this->StaysNear(gone, fresh, share * this->Tolerance) &&
    this->Accepts(gone, fresh);
}

bool SurfaceBound::AllowsMove(
  const std::vector<SurfacePiece>& gone, std::vector<SurfacePiece>& fresh)
{
  // Without a budget the turned pieces might add up.
  return EachLooksAlike(gone, fresh, this->Budget ? this->Tolerance : 0) &&
    this->StaysNear(gone, fresh, this->Tolerance) && this->Accepts(gone, fresh);
}

/** Whether both surfaces are near each other; sets the facets that fresh pieces are near to. */
bool SurfaceBound::StaysNear(
  const std::vector<SurfacePiece>& gone, std::vector<SurfacePiece>& fresh, double tolerance)
{
  if (!this->PutDown(gone, fresh, tolerance))
  {
    return false;
  }
  for (SurfacePiece& piece : fresh)
  {
    const Id label = this->Facets[piece.Facet].Label;
    std::array<TriangleTree::Nearest, 3> near;
    for (int k = 0; k < 3; ++k)
    {
      near[k] = this->NearestTo(piece.Corners[k], piece.Places[k], piece.Facet);
    }
    if (!this->Input->IsWithin({ piece.Places, label }, tolerance, near))
    {
      return false;
    }
    piece.Facet = near[0].Triangle;
  }
  return true;
}

/** The point of the input's surface nearest to a point, of a facet's label. Cached, because points
 * outlive many changes of their pieces. */
TriangleTree::Nearest SurfaceBound::NearestTo(Id point, const Point& place, Id facet)
{
  if (this->AtPoints.size() <= static_cast<std::size_t>(point))
  {
    this->AtPoints.resize(2 * point + 1, { { { 0, 0, 0 } }, None, {} });
  }
  NearestToPoint& last = this->AtPoints[point];
  const Id label = this->Facets[facet].Label;
  if (last.Label != label || last.Place != place)
  {
    last = { place, label, this->Input->NearestTo(place, label, facet) };
  }
  return last.Nearest;
}

bool SurfaceBound::AllowsCut(
  const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh)
{
  this->PutDown(gone, fresh, std::numeric_limits<double>::infinity());
  return this->Accepts(gone, fresh);
}

bool SurfaceBound::Accepts(
  const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh)
{
  this->Gone = gone;
  this->Fresh = fresh;
  return (!this->Budget || this->Budget->Allows(gone, fresh)) &&
    this->Boundary.StayApart(this->Watched(gone), this->Watched(fresh));
}

void SurfaceBound::Replace()
{
  if (this->Budget)
  {
    this->Budget->Replace();
  }
  for (const SurfacePiece& piece : this->Gone)
  {
    this->AtPieces.erase(KeyOf(piece.Corners));
  }
  for (std::size_t i = 0; this->Input && i < this->Fresh.size(); ++i)
  {
    this->AtPieces[KeyOf(this->Fresh[i].Corners)] = std::move(this->AtFresh[i]);
  }
  this->Boundary.Replace(this->Watched(this->Gone), this->Watched(this->Fresh));
}

Point SurfaceBound::PlaceOn(const Point& place, Id facet) const
{
  return this->Input->NearestTo(place, this->Facets[facet].Label, facet).Place;
}
} // namespace insideout

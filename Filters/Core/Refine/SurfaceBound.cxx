// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SurfaceBound.h"

#include "Common/NearestPoint.h"
#include "Common/Vectors.h"
#include "Refine/QuadraticCells.h"

#include <algorithm>
#include <limits>
#include <unordered_set>
#include <utility>

namespace insideout
{
namespace
{
/** Of the angle between a piece and those in whose place it comes: the surface would fold over. */
constexpr double LeastCosine = 0.4;

/** Height over the longest edge: thinner pieces of a surface may fold over by rounding. */
constexpr double LeastHeight = 1e-6;

bool IsThin(const std::array<Point, 3>& t)
{
  const double longest =
    std::max({ Distance(t[0], t[1]), Distance(t[1], t[2]), Distance(t[2], t[0]) });
  return !(Length(NormalOf(t[0], t[1], t[2])) > LeastHeight * longest * longest);
}

Triangle KeyOf(const Triangle& corners)
{
  return SortedTriangle(corners).Points;
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

Point CentreOf(const std::array<Point, 3>& t)
{
  Point centre;
  for (int k = 0; k < 3; ++k)
  {
    centre[k] = t[0][k] / 3 + t[1][k] / 3 + t[2][k] / 3;
  }
  return centre;
}

/** Whether all fresh pieces look where the gone ones do, all together. */
bool LookAlike(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh)
{
  Point sum = { { 0, 0, 0 } };
  for (const SurfacePiece& piece : gone)
  {
    const Point normal = NormalOf(piece);
    sum = { { sum[0] + normal[0], sum[1] + normal[1], sum[2] + normal[2] } };
  }
  return std::all_of(fresh.begin(), fresh.end(),
    [&](const SurfacePiece& piece)
    {
      const Point normal = NormalOf(piece);
      return !IsThin(piece.Places) && Dot(normal, sum) > LeastCosine * Length(normal) * Length(sum);
    });
}
} // namespace

Point NormalOf(const SurfacePiece& piece)
{
  return insideout::NormalOf(piece.Places[0], piece.Places[1], piece.Places[2]);
}

bool AreUnfolded(const std::vector<SurfacePiece>& pieces, const Point& normal)
{
  return std::all_of(pieces.begin(), pieces.end(),
    [&](const SurfacePiece& piece)
    { return !IsThin(piece.Places) && Dot(NormalOf(piece), normal) > 0; });
}

SurfaceBound::SurfaceBound(
  const RefinableMesh& mesh, const std::vector<FacetOfInput>& facets, double tolerance)
  : Tolerance(tolerance)
  , Mesh(&mesh)
  , Facets(&facets)
  , Input(std::make_unique<TriangleTree>(TrianglesOf(facets)))
{
  // Each corner and edge once, at one of the facets that share it.
  std::vector<char> isTaken(mesh.Points.size(), 0);
  std::unordered_set<Edge, HashOfEdge> edges;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Triangle f = FaceAcross(mesh.Cell(c).Corners, k);
      if (mesh.Cell(c).Facets[k] == None)
      {
        continue;
      }
      const auto [entry, isNew] = this->AtPieces.try_emplace(KeyOf(f));
      const auto add = [&, &samples = entry->second](const Point& place)
      {
        samples.push_back(static_cast<Id>(this->Places.size()));
        this->Places.push_back(place);
      };
      if (!isNew)
      {
        continue; // seen from the other side
      }
      const std::array<Point, 3> places = CornersOf(mesh.Points, f);
      add(CentreOf(places));
      for (int i = 0; i < 3; ++i)
      {
        if (std::exchange(isTaken[f[i]], 1) == 0)
        {
          add(places[i]);
        }
        if (edges.insert(EdgeBetween(f[i], f[(i + 1) % 3])).second)
        {
          add(Midpoint(places[i], places[(i + 1) % 3]));
        }
      }
    }
  }
}

/** Put samples down at the nearest of the fresh pieces. @return the largest of their distances */
double SurfaceBound::PutDown(const Samples& samples, const std::vector<SurfacePiece>& fresh)
{
  double largest = 0;
  for (const Id sample : samples)
  {
    const Point& place = this->Places[sample];
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < fresh.size(); ++i)
    {
      const double distance = Distance(NearestPointOf(fresh[i].Places, place), place);
      if (distance < least)
      {
        least = distance;
        nearest = i;
      }
    }
    largest = std::max(largest, least);
    this->Fresh[nearest].second.push_back(sample);
  }
  return largest;
}

bool SurfaceBound::Allows(const std::vector<SurfacePiece>& gone, std::vector<SurfacePiece>& fresh)
{
  if (!this->Input || !LookAlike(gone, fresh))
  {
    return false;
  }
  this->Gone.clear();
  this->Fresh.clear();
  for (SurfacePiece& piece : fresh)
  {
    const Id label = (*this->Facets)[piece.Facet].Label;
    if (!this->Input->IsWithin({ piece.Places, label }, this->Tolerance, piece.Facet))
    {
      return false;
    }
    piece.Facet = this->Input->NearestTo(CentreOf(piece.Places), label, piece.Facet).Triangle;
    this->Fresh.push_back({ KeyOf(piece.Corners), {} });
  }
  for (const SurfacePiece& piece : gone)
  {
    this->Gone.push_back(KeyOf(piece.Corners));
    const auto found = this->AtPieces.find(this->Gone.back());
    if (found != this->AtPieces.end() && !(this->PutDown(found->second, fresh) <= this->Tolerance))
    {
      return false;
    }
  }
  return true;
}

void SurfaceBound::Replace()
{
  for (const Triangle& gone : this->Gone)
  {
    this->AtPieces.erase(gone);
  }
  for (auto& [piece, samples] : this->Fresh)
  {
    this->AtPieces[piece] = std::move(samples);
  }
}

void SurfaceBound::Halve(const Triangle& piece, const Triangle& first, const Triangle& second)
{
  const auto found = this->AtPieces.find(KeyOf(piece));
  if (found == this->AtPieces.end())
  {
    return;
  }
  this->Fresh = { { KeyOf(first), {} }, { KeyOf(second), {} } };
  this->Gone = { KeyOf(piece) };
  this->PutDown(found->second,
    { { first, CornersOf(this->Mesh->Points, first), None },
      { second, CornersOf(this->Mesh->Points, second), None } });
  this->Replace();
}

Point SurfaceBound::PlaceOn(const Point& place, Id facet) const
{
  return this->Input->NearestTo(place, (*this->Facets)[facet].Label, facet).Place;
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/PlaceFacets.h"

#include "Common/ParallelLoop.h"
#include "Common/TrianglePredicates.h"
#include "Common/Vectors.h"
#include "Tetrahedralize/PiecesOfFacet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace insideout
{
namespace
{
/**
 * Limit, relative to the mesh's size, of the distance between a rounded Steiner point and the facet
 * that its piece belongs to. If one is farther, the facet counts as lost.
 */
constexpr double LargestRounding = 1e-12;

/** The facets found on faces. */
class FacetPlacer
{
public:
  FacetPlacer(const FaceTable& faces, TetrahedralMesh& mesh)
    : Faces(faces)
    , Mesh(mesh)
  {
    mesh.Facets.assign(mesh.Cells.size(), { { None, None, None, None } });
    mesh.FacetSides.assign(mesh.Cells.size(), { { 0, 0, 0, 0 } });
  }

  FaceTable::Range FaceAt(const Triangle& triangle) const
  {
    return this->Faces.Find(SortedTriangle(triangle));
  }

  /** Whether the triangle is a face that no facet lies on yet. */
  bool IsFree(const Triangle& triangle) const { return this->IsFree(this->FaceAt(triangle)); }
  bool IsFree(const FaceTable::Range& face) const
  {
    return face.First != face.Last && this->Mesh.Facets[face.First->Cell][face.First->Face] == None;
  }

  /** Put the facet on the face of `triangle`, a piece of the facet with the facet's orientation. */
  void Place(Id facet, const Triangle& triangle)
  {
    this->Place(facet, triangle, this->FaceAt(triangle));
  }

  /** @param[in] face of the triangle */
  void Place(Id facet, const Triangle& triangle, const FaceTable::Range& face)
  {
    const SortedTriangle sorted(triangle);
    for (const FaceEntry& side : face)
    {
      this->Mesh.Facets[side.Cell][side.Face] = facet;
      this->Mesh.FacetSides[side.Cell][side.Face] = side.Turned == sorted.Turned ? 1 : -1;
    }
  }

private:
  const FaceTable& Faces;
  TetrahedralMesh& Mesh;
};

// --- Facets in pieces ----------------------------------------------------------------------------

/** Largest extent of the points along an axis. */
double SizeOf(const std::vector<Point>& points)
{
  double size = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto ends = std::minmax_element(points.begin(), points.end(),
      [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    size = std::max(size, (*ends.second)[axis] - (*ends.first)[axis]);
  }
  return size;
}

/** If p is between the ends of edge k of a triangle, the weights of the triangle's corners. */
std::array<double, 3> WeightsOnEdge(const std::array<Point, 3>& corners, int k, const Point& p)
{
  const int next = (k + 1) % 3;
  const Point along = Difference(corners[next], corners[k]);
  const double t = Dot(Difference(p, corners[k]), along) / Dot(along, along);
  std::array<double, 3> weights = { 0, 0, 0 };
  weights[next] = std::min(1.0, std::max(0.0, t));
  weights[k] = 1 - weights[next];
  return weights;
}

/** Barycentric coordinates of p in a triangle, clamped where rounding left it outside. */
std::array<double, 3> WeightsInTriangle(const std::array<Point, 3>& corners, const Point& p)
{
  const Point normal = NormalOf(corners[0], corners[1], corners[2]);
  std::array<double, 3> weights;
  double sum = 0;
  for (int k = 0; k < 3; ++k)
  {
    const Point& next = corners[(k + 1) % 3];
    const Point& last = corners[(k + 2) % 3];
    weights[k] = std::max(0.0, Dot(Cross(Difference(next, p), Difference(last, p)), normal));
    sum += weights[k];
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

/** A Steiner point of a facet and its position there. */
struct PointOnFacet
{
  Id Point;
  std::array<double, 3> Weights;
};

/** A facet that may be a union of faces. */
struct SplitFacet
{
  Id Facet;
  std::vector<Triangle> MarkedFaces;
  PiecesOfFacet Parts;
  std::vector<PointOnFacet> NewPoints;
};

/** The facets that have several marked faces, ascending. */
std::vector<SplitFacet> GatherSplitFacets(
  Id numberOfFacets, const std::vector<Triangle>& faces, const std::vector<Id>& facetOfFaces)
{
  std::vector<int> numberOfPieces(static_cast<std::size_t>(numberOfFacets), 0);
  for (const Id facet : facetOfFaces)
  {
    ++numberOfPieces[facet];
  }
  std::vector<SplitFacet> split;
  std::vector<std::size_t> index(static_cast<std::size_t>(numberOfFacets), 0);
  for (Id facet = 0; facet < numberOfFacets; ++facet)
  {
    if (numberOfPieces[facet] > 1)
    {
      index[facet] = split.size();
      split.push_back({ facet, {}, {}, {} });
    }
  }
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    if (numberOfPieces[facetOfFaces[face]] > 1)
    {
      split[index[facetOfFaces[face]]].MarkedFaces.push_back(faces[face]);
    }
  }
  return split;
}

/** Matches marked faces with facets. */
class SplitFacetMatcher
{
public:
  SplitFacetMatcher(
    const FacetComplex& surface, const FacetPlacer& placer, const TetrahedralMesh& mesh)
    : Surface(surface)
    , Placer(placer)
    , Mesh(mesh)
    , Tolerance(LargestRounding * SizeOf(surface.Points))
  {
  }

  /**
   * Whether the marked faces are faces of the mesh, cover the facet together, and have their points
   * on it.
   */
  bool Match(SplitFacet& split) const
  {
    return std::all_of(split.MarkedFaces.begin(), split.MarkedFaces.end(),
             [this](const Triangle& face) { return this->Placer.IsFree(face); }) &&
      MatchPiecesOfFacet(this->Surface.Facets[split.Facet], split.MarkedFaces, split.Parts) &&
      this->LocateNewPoints(split);
  }

private:
  bool LocateNewPoints(SplitFacet& split) const
  {
    const Triangle& facet = this->Surface.Facets[split.Facet];
    const std::array<Point, 3> corners = { this->Mesh.Points[facet[0]], this->Mesh.Points[facet[1]],
      this->Mesh.Points[facet[2]] };
    std::set<Id> located(facet.begin(), facet.end());
    for (int k = 0; k < 3; ++k)
    {
      for (const Id p : split.Parts.EdgePoints[k])
      {
        located.insert(p);
        if (this->IsNew(p))
        {
          split.NewPoints.push_back({ p, WeightsOnEdge(corners, k, this->Mesh.Points[p]) });
        }
        else if (!this->IsCollinear(facet[k], facet[(k + 1) % 3], p))
        {
          return false;
        }
      }
    }
    for (const Triangle& piece : split.Parts.Pieces)
    {
      for (const Id p : piece)
      {
        if (!located.insert(p).second)
        {
          continue;
        }
        if (this->IsNew(p))
        {
          split.NewPoints.push_back({ p, WeightsInTriangle(corners, this->Mesh.Points[p]) });
        }
        else if (!this->IsCoplanar(facet, p))
        {
          return false;
        }
      }
    }
    return std::all_of(split.NewPoints.begin(), split.NewPoints.end(),
      [&](const PointOnFacet& point) { return this->LiesOn(corners, point); });
  }

  bool IsNew(Id point) const
  {
    return static_cast<std::size_t>(point) >= this->Surface.Points.size();
  }

  /** Input points are not rounded: they lie exactly on a facet or off it. */
  bool IsCollinear(Id a, Id b, Id p) const
  {
    return IsDegenerate(this->Mesh.Points[a], this->Mesh.Points[b], this->Mesh.Points[p]);
  }

  bool IsCoplanar(const Triangle& facet, Id p) const
  {
    return CGAL::coplanar(this->At(facet[0]), this->At(facet[1]), this->At(facet[2]), this->At(p));
  }

  FilteredPoint At(Id p) const { return ToFiltered(this->Mesh.Points[p]); }

  bool LiesOn(const std::array<Point, 3>& corners, const PointOnFacet& point) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      double x = 0;
      for (int k = 0; k < 3; ++k)
      {
        x += point.Weights[k] * corners[k][axis];
      }
      // Rejects a NaN too: the area of a facet may underflow.
      if (!(std::abs(x - this->Mesh.Points[point.Point][axis]) <= this->Tolerance))
      {
        return false;
      }
    }
    return true;
  }

  const FacetComplex& Surface;
  const FacetPlacer& Placer;
  const TetrahedralMesh& Mesh;
  const double Tolerance;
};

/** Points on facets' edges, from each edge's lower end to its higher. */
using EdgePaths = std::map<std::pair<Id, Id>, std::vector<Id>>;

/** Call visit(edge, points) for each edge of a facet, points as in EdgePaths. */
template <typename Visit>
void ForEachPath(const Triangle& facet, const PiecesOfFacet& parts, Visit visit)
{
  for (int k = 0; k < 3; ++k)
  {
    const Id from = facet[k];
    const Id to = facet[(k + 1) % 3];
    std::vector<Id> path = parts.EdgePoints[k];
    if (from > to)
    {
      std::reverse(path.begin(), path.end());
    }
    visit(std::pair<Id, Id>(std::minmax(from, to)), path);
  }
}

/** Facets that share an edge must split it alike, or a gap would open: facets that can only be
 * whole decide, then the lowest one. */
EdgePaths AgreeOnPaths(const FacetComplex& surface, const std::vector<Id>& wholeFacets,
  const std::vector<SplitFacet>& split)
{
  EdgePaths paths;
  for (const SplitFacet& facet : split)
  {
    ForEachPath(surface.Facets[facet.Facet], facet.Parts,
      [&](const std::pair<Id, Id>& edge, const std::vector<Id>& path) {
        paths.insert({ edge, path });
      });
  }
  for (std::size_t f = 0; !paths.empty() && f < wholeFacets.size(); ++f)
  {
    const Triangle& facet = surface.Facets[wholeFacets[f]];
    for (int k = 0; k < 3; ++k)
    {
      const auto path = paths.find(std::minmax(facet[k], facet[(k + 1) % 3]));
      if (path != paths.end())
      {
        path->second.clear();
      }
    }
  }
  return paths;
}

bool FollowsPaths(const Triangle& facet, const PiecesOfFacet& parts, const EdgePaths& paths)
{
  bool follows = true;
  ForEachPath(facet, parts,
    [&](const std::pair<Id, Id>& edge, const std::vector<Id>& path)
    { follows = follows && paths.at(edge) == path; });
  return follows;
}

/** Place the pieces and set the origins of new points, unless a lower facet did. */
void PlaceSplitFacet(
  const FacetComplex& surface, const SplitFacet& split, FacetPlacer& placer, TetrahedralMesh& mesh)
{
  for (const Triangle& piece : split.Parts.Pieces)
  {
    placer.Place(split.Facet, piece);
  }
  const Triangle& facet = surface.Facets[split.Facet];
  for (const PointOnFacet& point : split.NewPoints)
  {
    PointOrigin& origin = mesh.Origins[point.Point];
    if (origin.Points[0] == None)
    {
      origin = ComposeOrigin(
        { surface.Origins[facet[0]], surface.Origins[facet[1]], surface.Origins[facet[2]] },
        point.Weights);
      ++mesh.NumberOfSurfaceSteinerPoints;
    }
  }
}
} // namespace

void PlaceFacets(const FacetComplex& surface, const FaceTable& faces,
  const std::vector<Triangle>& markedFaces, const std::vector<Id>& facetOfMarkedFaces,
  TetrahedralMesh& mesh)
{
  FacetPlacer placer(faces, mesh);
  const SplitFacetMatcher matcher(surface, placer, mesh);
  std::vector<bool> isSplit(static_cast<std::size_t>(surface.NumberOfConstraints), false);
  std::vector<SplitFacet> matched;
  for (SplitFacet& split :
    GatherSplitFacets(surface.NumberOfConstraints, markedFaces, facetOfMarkedFaces))
  {
    if (matcher.Match(split))
    {
      isSplit[split.Facet] = true;
      matched.push_back(std::move(split));
    }
  }
  constexpr double NanosecondsPerFacet = 100;
  std::vector<FaceTable::Range> faceOf(isSplit.size());
  ParallelLoop(faceOf.size(), NanosecondsPerFacet,
    [&](std::size_t facet) { faceOf[facet] = placer.FaceAt(surface.Facets[facet]); });
  std::vector<Id> whole;
  for (Id facet = 0; facet < surface.NumberOfConstraints; ++facet)
  {
    if (isSplit[facet])
    {
      continue;
    }
    if (placer.IsFree(faceOf[facet]))
    {
      placer.Place(facet, surface.Facets[facet], faceOf[facet]);
      whole.push_back(facet);
    }
    else
    {
      mesh.LostFacets.push_back(facet);
    }
  }
  const EdgePaths paths = AgreeOnPaths(surface, whole, matched);
  for (const SplitFacet& split : matched)
  {
    const Triangle& facet = surface.Facets[split.Facet];
    const bool free = std::all_of(split.Parts.Pieces.begin(), split.Parts.Pieces.end(),
      [&](const Triangle& piece) { return placer.IsFree(piece); });
    if (free && FollowsPaths(facet, split.Parts, paths))
    {
      PlaceSplitFacet(surface, split, placer, mesh);
    }
    else if (placer.IsFree(facet) && FollowsPaths(facet, {}, paths))
    {
      placer.Place(split.Facet, facet);
    }
    else
    {
      mesh.LostFacets.push_back(split.Facet);
    }
  }
  std::sort(mesh.LostFacets.begin(), mesh.LostFacets.end());
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/WallRims.h"

#include "Common/Edge.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <unordered_map>

namespace insideout
{
namespace
{
Point UnitNormal(const std::array<Point, 3>& corners)
{
  const Point normal = NormalOf(corners[0], corners[1], corners[2]);
  const double length = Length(normal);
  return length > 0 ? Point{ { normal[0] / length, normal[1] / length, normal[2] / length } }
                    : normal;
}

bool AreParallel(const Point& u, const Point& v)
{
  return Length(Cross(u, v)) <= SineInPlane;
}

/** The planes of the other facets found so far around a point. */
struct PlanesAt
{
  std::vector<Point> Normals;
  std::vector<Id> Labels; ///< of each
  bool HasWall = false;
  bool IsHeld = false;

  void Add(const Point& normal, Id label)
  {
    for (std::size_t i = 0; i < this->Normals.size(); ++i)
    {
      if (AreParallel(this->Normals[i], normal))
      {
        // On a sheet, or with another label.
        this->IsHeld |= !(Dot(this->Normals[i], normal) > 0) || this->Labels[i] != label;
        return;
      }
    }
    this->Normals.push_back(normal);
    this->Labels.push_back(label);
    this->IsHeld |= Length(normal) == 0;
  }
};

/** The numbers of triangles of the wall and of other facets at an edge. */
struct EdgeUse
{
  int OfWall = 0;
  int OfOthers = 0;
  RimEdge Rim = { None, None, None };
};

class RimFinder
{
public:
  RimFinder(const TetrahedralMesh& mesh, const std::vector<FacetOfInput>& facets,
    const std::vector<Id>& wallFaces)
    : Mesh(mesh)
    , Facets(facets)
    , IsWall(4 * mesh.Cells.size(), 0)
    , At(mesh.Points.size())
  {
    for (const Id face : wallFaces)
    {
      this->IsWall[face] = 1;
    }
    for (const FacetOfInput& facet : facets)
    {
      this->AddFacet(facet);
    }
  }

  WallRims Find(const RefinableSurface& surface, const LayerWall& wall)
  {
    WallRims rims;
    this->FindEdges(wall, rims);
    rims.AtPoints.resize(this->At.size());
    for (const Id p : wall.Points)
    {
      const PlanesAt& planes = this->At[p];
      rims.AtPoints[p].IsHeld = planes.IsHeld || planes.Normals.size() > 2 || surface.IsPinched(p);
      rims.AtPoints[p].Normals = planes.Normals;
    }
    this->FindPointsInPlanes(surface, rims);
    return rims;
  }

private:
  Triangle CornersOfFace(Id face) const { return FaceOf(this->Mesh.Cells[face / 4], face % 4); }

  void AddFacet(const FacetOfInput& facet)
  {
    const Id face = facet.Faces[0];
    const Triangle corners = this->CornersOfFace(face);
    const bool isWall = this->IsWall[face] != 0;
    const Point normal = UnitNormal(CornersOf(this->Mesh.Points, corners));
    for (const Id corner : corners)
    {
      PlanesAt& planes = this->At[corner];
      planes.HasWall |= isWall;
      planes.IsHeld |= facet.Faces[1] != None; // between regions
      if (!isWall)
      {
        planes.Add(normal, facet.Label);
      }
    }
  }

  /** Find the edges of rims; hold the points of edges where more than two facets meet. */
  void FindEdges(const LayerWall& wall, WallRims& rims)
  {
    std::unordered_map<Edge, EdgeUse, HashOfEdge> uses;
    for (const Triangle& t : wall.Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        EdgeUse& use = uses[EdgeBetween(t[k], t[(k + 1) % 3])];
        ++use.OfWall;
        use.Rim = { t[k], t[(k + 1) % 3], None };
      }
    }
    for (const FacetOfInput& facet : this->Facets)
    {
      const Id face = facet.Faces[0];
      const Triangle corners = this->CornersOfFace(face);
      for (int k = 0; k < 3 && this->IsWall[face] == 0; ++k)
      {
        const auto found = uses.find(EdgeBetween(corners[k], corners[(k + 1) % 3]));
        if (found != uses.end())
        {
          ++found->second.OfOthers;
          found->second.Rim.Face = face;
        }
      }
    }
    for (const Triangle& t : wall.Triangles) // in the order of the input
    {
      for (int k = 0; k < 3; ++k)
      {
        const EdgeUse& use = uses[EdgeBetween(t[k], t[(k + 1) % 3])];
        if (use.OfWall == 1 && use.OfOthers == 1)
        {
          rims.Edges.push_back(use.Rim);
        }
        else if (use.OfOthers > 0)
        {
          this->At[t[k]].IsHeld = true;
          this->At[t[(k + 1) % 3]].IsHeld = true;
        }
      }
    }
  }

  /** Continue from rims over coplanar facets. */
  void FindPointsInPlanes(const RefinableSurface& surface, WallRims& rims) const
  {
    std::vector<std::vector<Id>> facetsAt(this->At.size());
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      const Triangle corners = this->CornersOfFace(this->Facets[f].Faces[0]);
      for (const Id corner : corners)
      {
        facetsAt[corner].push_back(static_cast<Id>(f));
      }
    }
    std::vector<char> isSeen(this->At.size(), 0);
    std::vector<Id> next;
    for (const RimEdge& edge : rims.Edges)
    {
      next.push_back(edge.From);
      next.push_back(edge.To);
    }
    while (!next.empty())
    {
      const Id point = next.back();
      next.pop_back();
      const PlanesAt& planes = this->At[point];
      const bool isAmid = !planes.HasWall && !planes.IsHeld && planes.Normals.size() == 1 &&
        !surface.IsPinched(point);
      if (isSeen[point] != 0 || !(isAmid || planes.HasWall))
      {
        continue;
      }
      isSeen[point] = 1;
      if (isAmid)
      {
        rims.PointsInPlanes.push_back(point);
      }
      for (const Id facet : facetsAt[point])
      {
        const Id face = this->Facets[facet].Faces[0];
        if (this->IsWall[face] == 0)
        {
          const Triangle corners = this->CornersOfFace(face);
          next.insert(next.end(), corners.begin(), corners.end());
        }
      }
    }
  }

  const TetrahedralMesh& Mesh;
  const std::vector<FacetOfInput>& Facets;
  std::vector<char> IsWall; ///< per face of the mesh
  std::vector<PlanesAt> At; ///< per point
};
} // namespace

Point WallRim::Along(const Point& vector) const
{
  if (this->IsHeld)
  {
    return { { 0, 0, 0 } };
  }
  if (this->Normals.empty())
  {
    return vector;
  }
  Point along;
  if (this->Normals.size() == 1)
  {
    const Point& normal = this->Normals.front();
    const double height = Dot(vector, normal);
    for (int k = 0; k < 3; ++k)
    {
      along[k] = vector[k] - height * normal[k];
    }
    return along;
  }
  const Point line = Cross(this->Normals[0], this->Normals[1]);
  const double share = Dot(vector, line) / Dot(line, line);
  return { { share * line[0], share * line[1], share * line[2] } };
}

WallRims FindWallRims(const TetrahedralMesh& mesh, const std::vector<FacetOfInput>& facets,
  const RefinableSurface& surface, const std::vector<Id>& wallFaces, const LayerWall& wall)
{
  return RimFinder(mesh, facets, wallFaces).Find(surface, wall);
}
} // namespace insideout

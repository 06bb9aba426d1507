// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FlipTarget.h"

namespace insideout
{
namespace
{
/** An edge that obstructs a segment is much harder to remove than a face. */
constexpr int CostOfEdgeCrossing = 3;

/** Size of the cache of sides, a power of 2: more than the vertices around most facets. */
constexpr std::size_t SizeOfCache = 256;
} // namespace

FlipTarget FlipTarget::Segment(const FlippableMesh& mesh, Id a, Id b)
{
  FlipTarget target(mesh);
  target.Kind = ASegment;
  target.Corners = { { a, b, None } };
  return target;
}

FlipTarget FlipTarget::Facet(const FlippableMesh& mesh, const Triangle& corners)
{
  FlipTarget target(mesh);
  target.Kind = AFacet;
  target.Corners = corners;
  target.Sides.assign(SizeOfCache, { None, 0 });
  return target;
}

int FlipTarget::CostOfFace(Id x, Id y, Id z) const
{
  if (this->Kind != ASegment)
  {
    return 0;
  }
  const Id a = this->Corners[0];
  const Id b = this->Corners[1];
  const Id infinite = this->Mesh.Infinite();
  if (x == a || y == a || z == a || x == b || y == b || z == b || x == infinite || y == infinite ||
    z == infinite)
  {
    return 0;
  }
  const ExactVertices& vertices = this->Mesh.Vertices();
  if (vertices.Orient(x, y, z, a) * vertices.Orient(x, y, z, b) >= 0)
  {
    return 0;
  }
  const int first = vertices.Orient(a, b, x, y);
  const int second = vertices.Orient(a, b, y, z);
  if (first * second < 0)
  {
    return 0;
  }
  const int third = vertices.Orient(a, b, z, x);
  return first * third < 0 || second * third < 0 ? 0 : 1;
}

int FlipTarget::CostOfEdge(Id x, Id y) const
{
  if (this->Kind == Nothing || x == this->Mesh.Infinite() || y == this->Mesh.Infinite())
  {
    return 0;
  }
  const bool crosses =
    this->Kind == ASegment ? this->SegmentCrosses(x, y) : this->FacetCrosses(x, y);
  return crosses ? CostOfEdgeCrossing : 0;
}

bool FlipTarget::SegmentCrosses(Id x, Id y) const
{
  const Id a = this->Corners[0];
  const Id b = this->Corners[1];
  const ExactVertices& vertices = this->Mesh.Vertices();
  if (x == a || x == b || y == a || y == b || vertices.Orient(a, b, x, y) != 0)
  {
    return false;
  }
  const Id off = this->Mesh.VertexOffPlane(a, b, x);
  return off != None && vertices.Orient(a, b, x, off) * vertices.Orient(a, b, y, off) < 0 &&
    vertices.Orient(x, y, a, off) * vertices.Orient(x, y, b, off) < 0;
}

bool FlipTarget::FacetCrosses(Id x, Id y) const
{
  const Triangle& f = this->Corners;
  const ExactVertices& vertices = this->Mesh.Vertices();
  if (this->SideOfFacet(x) * this->SideOfFacet(y) >= 0)
  {
    return false;
  }
  const int first = vertices.Orient(x, y, f[0], f[1]);
  const int second = vertices.Orient(x, y, f[1], f[2]);
  if (first * second < 0)
  {
    return false;
  }
  const int third = vertices.Orient(x, y, f[2], f[0]);
  return first * third >= 0 && second * third >= 0;
}

int FlipTarget::SideOfFacet(Id x) const
{
  Side& side = this->Sides[static_cast<std::size_t>(x) % SizeOfCache];
  if (side.Vertex != x)
  {
    const Triangle& f = this->Corners;
    side = { x, this->Mesh.Vertices().Orient(f[0], f[1], f[2], x) };
  }
  return side.Sign;
}
} // namespace insideout

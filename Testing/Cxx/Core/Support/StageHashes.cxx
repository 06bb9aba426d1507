// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/StageHashes.h"

#include "Defects/SurfaceDefects.h"
#include "GraphCut/SegmentMesh.h"
#include "HullMesh.h"
#include "Output/BoundaryTriangles.h"
#include "Output/Outliers.h"
#include "Quality/QualityOfMesh.h"
#include "Quality/SolidDefects.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <cstring>

using namespace insideout;

namespace
{
/** Of bytes (FNV-1a); numbers go in one by one, for structs have gaps. */
class Hash
{
public:
  template <typename Number>
  auto operator<<(Number number)
    -> std::enable_if_t<std::is_arithmetic_v<Number> || std::is_enum_v<Number>, Hash&>
  {
    unsigned char bytes[sizeof(number)];
    std::memcpy(bytes, &number, sizeof(number));
    for (const unsigned char byte : bytes)
    {
      this->Value = (this->Value ^ byte) * 0x100000001b3;
    }
    return *this;
  }

  template <typename T, std::size_t N>
  Hash& operator<<(const std::array<T, N>& array)
  {
    for (const T& item : array)
    {
      *this << item;
    }
    return *this;
  }

  template <typename T>
  Hash& operator<<(const std::vector<T>& array)
  {
    *this << array.size();
    for (const T& item : array)
    {
      *this << item;
    }
    return *this;
  }

  Hash& operator<<(const FacetSource& source)
  {
    return *this << source.Triangle << source.Reversed;
  }
  Hash& operator<<(const PointOrigin& origin) { return *this << origin.Points << origin.Weights; }
  Hash& operator<<(const BoundaryTriangle& face) { return *this << face.Corners << face.Source; }
  Hash& operator<<(const DefectLine& line) { return *this << line.Type << line.Points; }
  Hash& operator<<(const OutlierPiece& piece)
  {
    return *this << piece.Corners << piece.Facet << piece.Reason;
  }
  Hash& operator<<(const TriangleDefects& triangle)
  {
    return *this << triangle.Component << triangle.Shell << triangle.SelfIntersections
                 << triangle.Degenerate << triangle.Duplicate << triangle.Inconsistent
                 << triangle.TwoSided << triangle.Turned << triangle.Sheet;
  }

  std::uint64_t Value = 0xcbf29ce484222325;
};

} // namespace

Hashes HashStages(const TriangleSoup& soup)
{
  constexpr ProgressRange progress = { "extracting", 0, 1 };
  Monitor monitor;
  Hashes hashes;
  const auto add = [&hashes](const char* name, const auto&... outputs)
  { hashes[name] = (Hash() << ... << outputs).Value; };

  const SurfaceDefects defects = FindSurfaceDefects(soup, 0, Orientation::Automatic, monitor);
  add("defects", defects.Triangles, defects.Points, defects.Lines, defects.NearPoints);

  HullMeshParameters parameters;
  parameters.Budgets.Engine = TetrahedralizationEngine::Exact;
  const HullMesh hull = MeshHull(soup, parameters, monitor);
  const FacetComplex& surface = hull.Surface;
  add("resolved points", surface.Points, surface.Origins);
  add("resolved facets", surface.Facets, surface.Multiplicity, surface.Sources);
  add("points", hull.Mesh.Points, hull.Mesh.Origins);
  add("cells", hull.Mesh.Cells, hull.Mesh.Facets, hull.Mesh.FacetSides, hull.Mesh.LostFacets);
  add("w", hull.W);

  const std::vector<FacetPiece> pieces = PiecesOfFacets(hull.Mesh);
  std::vector<unsigned char> inside;
  for (const bool constrain : { true, false })
  {
    SegmentMeshParameters constraints;
    constraints.ConstrainFacets = constraints.FillNonManifold = constrain;
    inside = SegmentMesh(hull.Mesh, hull.W, pieces, {}, constraints, monitor).Inside;
    add(constrain ? "labels with constraints" : "labels", inside);
  }
  add("boundary",
    BoundaryTriangles(
      surface, hull.Mesh, BoundaryFaces(hull.Mesh, inside, monitor, progress), monitor, progress));
  add("outliers", OutlierPieces(surface, hull.Mesh, inside, monitor, progress));

  const SolidDefects solid = FindSolidDefects(hull.Mesh.Points, hull.Mesh.Cells, monitor);
  add("solid defects", solid.Orientations, solid.Regions, solid.ContactPairs);
  const MeshQuality quality = QualityOfMesh(hull.Mesh.Points, hull.Mesh.Cells, monitor, progress);
  add("quality", quality.Histogram, quality.MinDihedralAngle, quality.DihedralAngle1Percent,
    quality.MaxRadiusEdgeRatio, quality.RadiusEdgeRatio99Percent, quality.AverageMeanRatio,
    quality.SurfaceEdgesUnder10Degrees);

  for (const WindingNumberMethod method : { WindingNumberMethod::Exact, WindingNumberMethod::Naive,
         WindingNumberMethod::Hierarchical, WindingNumberMethod::Approximate })
  {
    const SurfaceWindingNumber w(surface, { method }, monitor);
    add(("w at points, method " + std::to_string(static_cast<int>(method))).c_str(),
      w.At(hull.Mesh.Points, monitor));
  }
  return hashes;
}

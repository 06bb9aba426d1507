// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/MendFlatCells.h"

#include "Common/RawTetrahedra.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/MakeRefinable.h"
#include "Refine/ReconnectCells.h"
#include "Refine/SmoothPoint.h"
#include "Tetrahedralize/AssembleMesh.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace insideout
{
namespace
{
/** Square of the least sine of a cell that is not flat: volumes of flatter cells have few digits.
 */
constexpr double FlatShape = 1e-20;

/** One change may make room for another. */
constexpr int MostPasses = 4;

/** Beyond 2 to this power shapes might over- or underflow. */
constexpr int LargestOrdinaryExponent = 60;

/** Faces that stay: those on facets of the complex, and on the hull. */
struct FixedFaces
{
  std::vector<FacetOfInput> Faces;
  std::vector<Id> FacetOfFace; ///< of the complex; None on the hull alone

  explicit FixedFaces(const TetrahedralMesh& mesh)
  {
    for (Id c = 0; c < mesh.NumberOfCells(); ++c)
    {
      for (int k = 0; k < 4; ++k)
      {
        const Id neighbor = mesh.Neighbors[c][k];
        const Id facet = mesh.Facets[c][k];
        if (neighbor == None || (facet != None && c < neighbor))
        {
          this->Faces.push_back({ CornersOf(mesh.Points, FaceOf(mesh.Cells[c], k)),
            { { 4 * c + k, MirrorOf(mesh, c, neighbor) } }, 0 });
          this->FacetOfFace.push_back(facet);
        }
      }
    }
  }

private:
  /** The neighbor's face towards the cell; None without a neighbor. */
  static Id MirrorOf(const TetrahedralMesh& mesh, Id cell, Id neighbor)
  {
    for (int k = 0; k < 4 && neighbor != None; ++k)
    {
      if (mesh.Neighbors[neighbor][k] == cell)
      {
        return 4 * neighbor + k;
      }
    }
    return None;
  }
};

class FlatCellMending
{
public:
  /** @param[in] inputPoints number of points that stay */
  FlatCellMending(RefinableMesh& mesh, const FixedFaces& fixed, Id inputPoints)
    : Mesh(mesh)
    , InputPoints(inputPoints)
    , Surface(mesh, fixed.Faces, this->Locked, SurfaceTreatment::Kept, 0)
    , Bound(mesh, fixed.Faces, SurfaceTreatment::Kept, 0)
    , Reconnect(mesh, this->Surface, this->Bound)
    , Smooth(mesh, this->Surface, this->Bound)
  {
  }

  /** @return whether any cell was replaced, or any point moved */
  bool Pass()
  {
    bool isChanged = false;
    for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
    {
      if (!this->Mesh.IsDead(cell) &&
        ShapeOf(this->Mesh.Points, this->Mesh.Cell(cell).Corners) < FlatShape)
      {
        isChanged |= this->Reconnect.ImproveCell(cell) || this->MoveCorner(cell);
      }
    }
    return isChanged;
  }

private:
  bool MoveCorner(Id cell)
  {
    const Tetrahedron corners = this->Mesh.Cell(cell).Corners;
    return std::any_of(corners.begin(), corners.end(),
      [this](Id corner)
      {
        return corner >= this->InputPoints && this->Mesh.Kinds[corner] == PointKind::Free &&
          this->Smooth.Smooth(corner);
      });
  }

  RefinableMesh& Mesh;
  const Id InputPoints;
  const std::vector<char> Locked;
  RefinableSurface Surface;
  SurfaceBound Bound;
  Reconnection Reconnect;
  PointSmoothing Smooth;
};

RawTetrahedra RawOf(const RefinableMesh& mesh, const FixedFaces& fixed)
{
  RawTetrahedra raw;
  raw.Points = mesh.Points;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (mesh.IsDead(c))
    {
      continue;
    }
    const RefinableCell& cell = mesh.Cell(c);
    raw.Cells.push_back(cell.Corners);
    for (int k = 0; k < 4; ++k)
    {
      const Id facet = cell.Facets[k] == None ? None : fixed.FacetOfFace[cell.Facets[k]];
      if (facet != None && (cell.Neighbors[k] == None || c < cell.Neighbors[k]))
      {
        raw.Faces.push_back(FaceAcross(cell.Corners, k));
        raw.FacetOfFaces.push_back(facet);
      }
    }
  }
  return raw;
}
} // namespace

TetrahedralMesh MendFlatCells(const FacetComplex& surface, TetrahedralMesh mesh, Monitor& monitor)
{
  const bool hasFlat = std::any_of(mesh.Cells.begin(), mesh.Cells.end(),
    [&mesh](const Tetrahedron& cell) { return ShapeOf(mesh.Points, cell) < FlatShape; });
  if (!hasFlat || std::abs(LargestExponent(mesh.Points)) > LargestOrdinaryExponent)
  {
    return mesh;
  }
  const FixedFaces fixed(mesh);
  RefinableMesh refinable = MakeRefinable(mesh, {}, fixed.Faces);
  FlatCellMending mending(refinable, fixed, static_cast<Id>(surface.Points.size()));
  bool isChanged = false;
  for (int pass = 0; pass < MostPasses && mending.Pass(); ++pass)
  {
    isChanged = true;
  }
  if (!isChanged)
  {
    return mesh;
  }
  TetrahedralMesh mended = AssembleMesh(surface, RawOf(refinable, fixed), monitor);
  return mended.LostFacets.size() > mesh.LostFacets.size() ? std::move(mesh) : std::move(mended);
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/MakeRefinable.h"

#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <limits>
#include <string>

namespace insideout
{
namespace
{
/** The definition of a label: the regions on both sides, and the given label. */
using LabelKey = std::array<Id, 3>;

/** Whether a face has a cell that sees it from the same side as its neighbor does. */
bool Overlaps(const TetrahedralMesh& mesh, Id cell, int k)
{
  const SortedTriangle face(FaceOf(mesh.Cells[cell], k));
  const Tetrahedron& other = mesh.Cells[mesh.Neighbors[cell][k]];
  for (int i = 0; i < 4; ++i)
  {
    const SortedTriangle twin(FaceOf(other, i));
    if (twin.Points == face.Points && twin.Turned == face.Turned)
    {
      return true;
    }
  }
  return false;
}
} // namespace

void CheckCells(const TetrahedralMesh& mesh)
{
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (Orient3D(mesh.Points, mesh.Cells[c]) <= 0)
    {
      throw Error(ErrorCode::InvalidParameter, "cell " + std::to_string(c) + " has no volume");
    }
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[c][k] != None && Overlaps(mesh, c, k))
      {
        throw Error(ErrorCode::InvalidParameter,
          "cells " + std::to_string(c) + " and " + std::to_string(mesh.Neighbors[c][k]) +
            " overlap: they are on the same side of a face");
      }
    }
  }
}

std::vector<FacetOfInput> FacetsOf(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<std::array<Id, 4>>& labels)
{
  std::vector<FacetOfInput> facets;
  std::vector<LabelKey> keys;
  const auto regionOf = [&](Id cell) {
    return cell == None ? None : regions.empty() ? 0 : regions[cell];
  };
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = mesh.Neighbors[c][k];
      if ((neighbor != None && neighbor < c) || regionOf(neighbor) == regionOf(c))
      {
        continue;
      }
      Id beyond = None;
      for (int j = 0; j < 4 && neighbor != None; ++j)
      {
        beyond = mesh.Neighbors[neighbor][j] == c ? 4 * neighbor + j : beyond;
      }
      facets.push_back(
        { CornersOf(mesh.Points, FaceOf(mesh.Cells[c], k)), { { 4 * c + k, beyond } }, 0 });
      const auto [low, high] = std::minmax({ regionOf(c), regionOf(neighbor) });
      keys.push_back({ low, high, labels.empty() ? 0 : labels[c][k] });
    }
  }
  std::vector<LabelKey> sorted = keys;
  SortUniquely(sorted);
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    facets[f].Label = IndexIn(sorted, keys[f]);
  }
  return facets;
}

void SetFacets(const std::vector<FacetOfInput>& facets, RefinableMesh& mesh)
{
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    for (const Id face : facets[f].Faces)
    {
      if (face != None)
      {
        mesh.SetFacet(face / 4, CornerAcrossFrom[face % 4], static_cast<Id>(f));
      }
    }
  }
}

RefinableMesh MakeRefinable(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<FacetOfInput>& facets)
{
  RefinableMesh result;
  for (const Point& point : mesh.Points)
  {
    result.AddPoint(point, PointKind::Free, std::numeric_limits<double>::infinity());
  }
  result.SetCells(mesh.Cells.size(),
    [&](Id c)
    {
      RefinableCell cell = { { regions.empty() ? 0 : regions[c], c, 0 }, mesh.Cells[c],
        { { None, None, None, None } }, { { None, None, None, None } } };
      for (int k = 0; k < 4; ++k)
      {
        cell.Neighbors[CornerAcrossFrom[k]] = mesh.Neighbors[c][k];
      }
      return cell;
    });
  SetFacets(facets, result);
  return result;
}
} // namespace insideout

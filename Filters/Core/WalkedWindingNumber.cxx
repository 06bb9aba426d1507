// SPDX-License-Identifier: GPL-3.0-or-later
#include "WalkedWindingNumber.h"

#include <algorithm>
#include <string>

namespace insideout
{
namespace
{
/** Carry the winding number from the hull into every cell that can be reached. */
std::vector<double> Walk(
  const FacetComplex& surface, const TetrahedralMesh& mesh, std::vector<Id>& reached)
{
  std::vector<double> w(mesh.Cells.size(), 0.0);
  std::vector<char> known(mesh.Cells.size(), 0);
  const auto reach = [&](Id cell, double value)
  {
    if (!known[cell])
    {
      known[cell] = 1;
      w[cell] = value;
      reached.push_back(cell);
    }
  };
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[cell][k] == None)
      {
        reach(cell, MultiplicityOnEntering(surface, mesh, cell, k));
      }
    }
  }
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    const Id cell = reached[next];
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[cell][k] != None)
      {
        reach(mesh.Neighbors[cell][k], w[cell] - MultiplicityOnEntering(surface, mesh, cell, k));
      }
    }
  }
  return w;
}

/** Throw unless w jumps by the facets' multiplicity, seen from both sides of every face. */
void VerifyJumps(
  const FacetComplex& surface, const TetrahedralMesh& mesh, const std::vector<double>& w)
{
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = mesh.Neighbors[cell][k];
      const double beyond = neighbor == None ? 0.0 : w[neighbor];
      if (w[cell] - beyond != MultiplicityOnEntering(surface, mesh, cell, k))
      {
        throw Error(ErrorCode::Inconsistent,
          "the winding number does not rise by the facets' count between cell " +
            (neighbor == None ? std::string("(outside)") : std::to_string(neighbor)) +
            " and cell " + std::to_string(cell));
      }
    }
  }
}

/** Walk from a part's first cell to all others. */
void WalkPart(const FaceCounts& counts, const TetrahedralMesh& mesh,
  const std::vector<char>& touched, Id first, UntouchedParts& parts)
{
  const Id part = static_cast<Id>(parts.FirstCell.size());
  parts.FirstCell.push_back(first);
  parts.Part[first] = part;
  std::vector<Id> stack = { first };
  while (!stack.empty())
  {
    const Id cell = stack.back();
    stack.pop_back();
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = mesh.Neighbors[cell][k];
      if (neighbor == None || touched[neighbor])
      {
        continue;
      }
      const int rise = parts.Rise[cell] - counts.OnEntering(cell, k);
      if (parts.Part[neighbor] == None)
      {
        parts.Part[neighbor] = part;
        parts.Rise[neighbor] = rise;
        stack.push_back(neighbor);
      }
      else if (parts.Rise[neighbor] != rise)
      {
        throw Error(ErrorCode::Inconsistent,
          "the winding number does not rise by the facets' count between cell " +
            std::to_string(cell) + " and cell " + std::to_string(neighbor));
      }
    }
  }
}
} // namespace

std::vector<double> WalkedWindingNumbers(
  const FacetComplex& surface, const TetrahedralMesh& mesh, Monitor& monitor, const char* stage)
{
  monitor.Check(stage, 0);
  std::vector<Id> reached;
  const std::vector<double> w = Walk(surface, mesh, reached);
  if (reached.size() != mesh.Cells.size())
  {
    std::sort(reached.begin(), reached.end());
    Id missing = 0;
    while (missing < static_cast<Id>(reached.size()) && reached[missing] == missing)
    {
      ++missing;
    }
    throw Error(ErrorCode::Inconsistent,
      "cell " + std::to_string(missing) + " cannot be reached from the hull");
  }
  monitor.Check(stage, 0.5);
  VerifyJumps(surface, mesh, w);
  monitor.Check(stage, 1);
  return w;
}

FaceCounts::FaceCounts(const FacetComplex& surface, const TetrahedralMesh& mesh)
  : Mesh(mesh)
  , Count(surface.Multiplicity.begin(), surface.Multiplicity.end())
{
  for (const Id facet : mesh.LostFacets)
  {
    this->Count[facet] = 0;
  }
}

std::vector<CountedTriangle> FaceCounts::Chain() const
{
  std::vector<CountedTriangle> faces;
  for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
  {
    const Tetrahedron& t = this->Mesh.Cells[cell];
    for (int k = 0; k < 4; ++k)
    {
      const int count = this->OnEntering(cell, k);
      if (count != 0 && this->Mesh.Neighbors[cell][k] < cell)
      {
        const std::array<int, 3>& corners = TetrahedronFaces[k];
        faces.push_back({ { { t[corners[0]], t[corners[1]], t[corners[2]] } }, count });
      }
    }
  }
  return faces;
}

UntouchedParts WalkParts(
  const FaceCounts& counts, const TetrahedralMesh& mesh, const std::vector<char>& touched)
{
  UntouchedParts parts;
  parts.Part.assign(mesh.Cells.size(), None);
  parts.Rise.assign(mesh.Cells.size(), 0);
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (!touched[cell] && parts.Part[cell] == None)
    {
      WalkPart(counts, mesh, touched, cell, parts);
    }
  }
  return parts;
}
} // namespace insideout

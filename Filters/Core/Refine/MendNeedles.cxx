// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/MendNeedles.h"

#include "Common/LoopProgress.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/ContractSmallSteps.h"
#include "Refine/ReconnectCells.h"
#include "Refine/SurfacePiece.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace insideout
{
namespace
{
/** Limit of rounds: a flipped edge may make room for a contraction. */
constexpr int MostRounds = 4;

/** Feature angle above which no edge is a ridge. */
constexpr double NoRidges = 180;

/** Share in the sum of all names: a name below it is compared with it, as a rounding error. */
constexpr double LeastShare = 1e-9;

/**
 * Flip the longest edges of pieces whose height is at most the tolerance, between pieces of one
 * label and at no ridge: such a needle has no short edge that could be contracted.
 * @return the number of flipped edges
 */
Id FlipCaps(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound, double tolerance,
  Monitor& monitor, const ProgressRange& progress)
{
  Reconnection reconnect(mesh, surface, bound);
  const LoopProgress looked(monitor, progress, mesh.NumberOfCells());
  Id count = 0;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    looked.Check(cell);
    for (int k = 0; k < 4 && !mesh.IsDead(cell); ++k)
    {
      if (mesh.Cell(cell).Neighbors[k] != None)
      {
        continue;
      }
      const Triangle face = FaceAcross(mesh.Cell(cell).Corners, k);
      const std::array<Point, 3> t = CornersOf(mesh.Points, face);
      int longest = 0;
      for (int i = 1; i < 3; ++i)
      {
        longest =
          Distance(t[i], t[(i + 1) % 3]) > Distance(t[longest], t[(longest + 1) % 3]) ? i : longest;
      }
      const double length = Distance(t[longest], t[(longest + 1) % 3]);
      if (Length(NormalOf(t[0], t[1], t[2])) <= tolerance * length &&
        reconnect.RemoveEdgeUnlessWorse(face[longest], face[(longest + 1) % 3], cell, 0))
      {
        ++count;
        break; // the cell was replaced
      }
    }
  }
  return count;
}

/** The largest relative difference of two sums of positive numbers by name. */
double LargestChange(const std::map<Id, double>& before, const std::map<Id, double>& after)
{
  double all = 0;
  for (const auto& [name, sum] : before)
  {
    all += sum;
  }
  double largest = 0;
  for (const auto& [name, sum] : before)
  {
    const auto found = after.find(name);
    const double change = std::abs((found == after.end() ? 0 : found->second) - sum);
    largest = std::max(largest, change / std::max(sum, LeastShare * all));
  }
  return largest;
}
} // namespace

Id MendNeedles(RefinableMesh& mesh, const std::vector<FacetOfInput>& facets,
  const std::vector<char>& locked, double tolerance, Monitor& monitor)
{
  const ProgressRange progress = { Stages::Refining, 0, 0.05 };
  SurfaceBound bound(mesh, facets, SurfaceTreatment::Remeshed, tolerance);
  Id count = 0;
  for (int round = 0; round < MostRounds; ++round)
  {
    RefinableSurface surface(mesh, facets, locked, SurfaceTreatment::Remeshed, NoRidges);
    count += ContractSmallSteps(mesh, surface, bound, tolerance, monitor, progress);
    const Id flipped = FlipCaps(mesh, surface, bound, tolerance, monitor, progress);
    count += flipped;
    if (flipped == 0)
    {
      break;
    }
  }
  return count;
}

double LargestChange(const TetrahedralMesh& before, const std::vector<Id>& regions,
  const RefinableMesh& after, const std::vector<FacetOfInput>& facets)
{
  std::array<std::map<Id, double>, 2> areas;
  for (const FacetOfInput& facet : facets)
  {
    const auto& [a, b, c] = facet.Corners;
    areas[0][facet.Label] += Length(NormalOf(a, b, c));
  }
  for (const SurfacePiece& piece : PiecesOf(after))
  {
    areas[1][facets[piece.Facet].Label] += Length(NormalOf(piece));
  }
  std::array<std::map<Id, double>, 2> volumes;
  const auto volumeOf = [](const std::array<Point, 4>& c)
  { return Determinant(Difference(c[1], c[0]), Difference(c[2], c[0]), Difference(c[3], c[0])); };
  for (Id c = 0; c < before.NumberOfCells(); ++c)
  {
    volumes[0][regions.empty() ? 0 : regions[c]] +=
      volumeOf(CornersOf(before.Points, before.Cells[c]));
  }
  for (Id c = 0; c < after.NumberOfCells(); ++c)
  {
    if (!after.IsDead(c))
    {
      volumes[1][after.Cell(c).Region] += volumeOf(CornersOf(after.Points, after.Cell(c).Corners));
    }
  }
  return std::max(LargestChange(areas[0], areas[1]), LargestChange(volumes[0], volumes[1]));
}
} // namespace insideout

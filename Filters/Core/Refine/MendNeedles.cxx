// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/MendNeedles.h"

#include "Common/LoopProgress.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/ContractSmallSteps.h"
#include "Refine/ReconnectCells.h"

namespace insideout
{
namespace
{
/** Limit of rounds: a flipped edge may make room for a contraction. */
constexpr int MostRounds = 4;

/** Feature angle above which no edge is a ridge. */
constexpr double NoRidges = 180;

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
} // namespace

Id MendNeedles(RefinableMesh& mesh, const std::vector<FacetOfInput>& facets,
  const std::vector<char>& locked, SurfaceBound& bound, double tolerance, Monitor& monitor)
{
  const ProgressRange progress = { Stages::Refining, 0, 0.05 };
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
} // namespace insideout

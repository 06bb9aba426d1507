// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SurfaceBudget.h"

#include "Common/Vectors.h"
#include "Quality/SolverFitness.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** Share in the sum of all: a smaller sum is compared with it, as a rounding error. */
constexpr double LeastShare = 1e-9;

/** About six times the volume of the smallest cell that a solver accepts: smaller changes of
 * regions that are rounding errors do not count. */
constexpr double LeastCell = 8 * SmallestJacobian;
} // namespace

SurfaceBudget::SurfaceBudget(const RefinableMesh& mesh, const std::vector<FacetOfInput>& facets)
  : Facets(facets)
{
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (mesh.IsDead(c))
    {
      continue;
    }
    const auto [a, b, d, e] = CornersOf(mesh.Points, mesh.Cell(c).Corners);
    const double volume = Determinant(Difference(b, a), Difference(d, a), Difference(e, a));
    this->Volumes[mesh.Cell(c).Region].Before += volume;
    this->AllVolumes += volume;
  }
  mesh.VisitFacets(
    [&](Id c, int k)
    {
      if (mesh.HasPiece(c, k))
      {
        const SurfacePiece piece = PieceAt(mesh, c, k);
        const double area = Length(NormalOf(piece));
        const Id label = facets[piece.Facet].Label;
        const Id neighbor = mesh.Cell(c).Neighbors[k];
        this->RegionsAt[label] = { { mesh.Cell(c).Region,
          neighbor == None ? None : mesh.Cell(neighbor).Region } };
        this->Areas[label].Before += area;
        this->AllAreas += area;
      }
    });
}

/** @param[in] sign 1, or -1 for pieces that are removed */
void SurfaceBudget::Add(const std::vector<SurfacePiece>& pieces, double sign, const Point& origin)
{
  for (const SurfacePiece& piece : pieces)
  {
    const Id label = this->Facets[piece.Facet].Label;
    this->AreaChanges[label] += sign * Length(NormalOf(piece));
    const auto& [a, b, c] = piece.Places;
    const double volume =
      sign * Determinant(Difference(a, origin), Difference(b, origin), Difference(c, origin));
    const auto [near, beyond] = this->RegionsAt.at(label);
    this->VolumeChanges[near] -= volume; // normals point into it
    this->VolumeChanges[beyond] += volume;
  }
}

/** @param[in] least change that is too small to count for a sum that is a rounding error */
bool SurfaceBudget::StayWithin(const Sums& sums, double all, const Changes& changes, double least)
{
  const auto mayChangeBy = [&](double before)
  {
    return before > LeastShare * all ? LargestChange * before
                                     : std::max(least, LargestChange * LeastShare * all);
  };
  return std::all_of(changes.begin(), changes.end(),
    [&](const auto& change)
    {
      const auto found = sums.find(change.first);
      return found == sums.end() || // outside
        std::abs(found->second.Change + change.second) <= mayChangeBy(found->second.Before);
    });
}

bool SurfaceBudget::Allows(
  const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh)
{
  this->AreaChanges.clear();
  this->VolumeChanges.clear();
  const Point origin = gone.front().Places.front();
  this->Add(gone, -1, origin);
  this->Add(fresh, 1, origin);
  return StayWithin(this->Areas, this->AllAreas, this->AreaChanges, 0) &&
    StayWithin(this->Volumes, this->AllVolumes, this->VolumeChanges, LeastCell);
}

void SurfaceBudget::Replace()
{
  for (const auto& [label, change] : this->AreaChanges)
  {
    this->Areas[label].Change += change;
  }
  for (const auto& [region, change] : this->VolumeChanges)
  {
    if (region != None)
    {
      this->Volumes[region].Change += change;
    }
  }
}
} // namespace insideout

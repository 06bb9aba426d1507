// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableMesh.h"
#include "Refine/SizeRules.h"
#include "Refine/SurfacePiece.h"

#include <functional>
#include <vector>

namespace insideout
{
struct SizingParameters
{
  double EdgeLength = 0;       ///< limit of edge lengths; 0: as on the surface
  double Grading = 0.35;       ///< growth of lengths per unit of distance
  double MaximumVolume = 0;    ///< limit of a cell's volume; 0: none
  std::vector<double> Lengths; ///< wanted length at each input point; later points have none

  /** Wanted length anywhere, infinite for no limit; empty: nowhere. */
  std::function<double(const Point&)> LengthAt;

  /**
   * Lengths by geometry, tag and region, which SizesByRules turns into LengthAt and LengthOfCell.
   */
  std::vector<SizeRule> Rules;

  /**
   * Wanted length within each input cell, infinite for none, equal within a region; empty: none.
   */
  std::vector<double> LengthOfCell;

  std::vector<double> LengthOfRegion; ///< the same per region

  /** Whether the surface's own edge lengths apply where they are shorter than the wanted ones. */
  bool KeepsShorterEdges = false;
};

/**
 * The required edge length anywhere in a mesh: the wanted length, but at most that of the surface's
 * edges, growing with the distance from it. Its values at the mesh's points are their Sizes.
 */
class SizingField
{
public:
  /**
   * Sets the mesh's Sizes; later points get theirs from At. The mesh has to outlive this object.
   */
  SizingField(RefinableMesh& mesh, const SizingParameters& parameters);

  /** Whether a length is wanted anywhere. */
  bool IsAskedFor() const;

  /** Recompute the mesh's Sizes for a changed surface: the length of its edges.
   * @param[in] heights where above 0, lengths are at most this many heights of the triangles: 1 for
   * a surface to be split */
  void FollowSurface(double heights = 0);

  /** Reduce them at thin triangles of the surface, which adjoin short edges that must stay to keep
   * the surface near the input's.
   * @param[in] pieces of the surface, which need not be faces of cells
   * @param[in] heights per piece: lengths at its corners are at most this many of its heights
   * @param[in] least lengths are not reduced below this one
   */
  void ShortenAtThinTriangles(
    const std::vector<SurfacePiece>& pieces, const std::vector<double>& heights, double least);

  /** Whether wanted lengths take the place of the surface's own. */
  bool ReplacesSurface() const { return this->IsAskedFor() && !this->Parameters.KeepsShorterEdges; }

  /** Set them for a surface to be remeshed: the wanted lengths, regardless of the surface unless
   * its shorter edges are kept; if none are wanted, as FollowSurface does. */
  void FollowWishes();

  /** The length wanted at a point of the mesh, regardless of the surface; infinite without one. */
  double WantedAtPoint(Id point) const { return this->AtPoints[point].Wanted; }

  /** The length wanted everywhere; infinite without one. */
  double Most() const { return this->Everywhere; }

  /** At a place in or near a cell. */
  double At(Id cell, const Point& place) const;

  /** Set the value of a point added to the mesh, from the cell that At(cell, its place) used. */
  void Append(Id cell, const Point& place);

  /** The same for a point between two others. @return its size */
  double AppendBetween(Id u, Id v, const Point& place);

  /** The same for a point in a region, regardless of the surface, until FollowSurface. */
  double AppendIn(Id region, const Point& place);

  /** Estimated number of cells of a mesh with these sizes. */
  double EstimatedCells() const;

private:
  /** The length that the surface allows, the wanted one, and the one given by an array. */
  struct Lengths
  {
    double Surface;
    double Wanted;
    double Array;
    double Region; ///< the least of the regions there; part of Wanted
    double Both() const { return this->Surface < this->Wanted ? this->Surface : this->Wanted; }
  };
  Lengths LengthsAt(Id cell, const Point& place) const;
  double WantedAt(const Point& place, double otherwise) const;
  double LengthOfRegion(Id region) const;
  double CellsIn(Id cell, const std::array<Point, 4>& corners, int halvings) const;
  template <class VisitTriangles>
  void SetLengthsOfSurface(const VisitTriangles& visitTriangles);
  template <class VisitNeighbors>
  void Grow(const VisitNeighbors& visitNeighbors);
  void SetSizes();

  RefinableMesh& Mesh;
  const SizingParameters& Parameters;
  double Everywhere; ///< limit by EdgeLength and MaximumVolume
  std::vector<Lengths> AtPoints;
};
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableMesh.h"

#include <functional>
#include <vector>

namespace insideout
{
struct SizingParameters
{
  double EdgeLength = 0;       ///< that edges are to have at most; 0: as the surface has them
  double Grading = 0.35;       ///< by how much lengths may grow per unit of distance
  double MaximumVolume = 0;    ///< of a cell; 0: any
  std::vector<double> Lengths; ///< wanted at each point of the input; empty: none

  /** Wanted anywhere, infinite where it does not matter; empty: nowhere. */
  std::function<double(const Point&)> LengthAt;
};

/**
 * How long edges are to be anywhere in a mesh: what is asked for, but no longer than those of the
 * surface, growing with the distance from it. Its values at the mesh's points are their Sizes.
 */
class SizingField
{
public:
  /** Sets the mesh's Sizes; later points get theirs from At. The mesh has to live as long. */
  SizingField(RefinableMesh& mesh, const SizingParameters& parameters);

  /** Whether lengths are asked for, anywhere. */
  bool IsAskedFor() const;

  /** Set the mesh's Sizes anew for a surface that has changed: as long as its edges are. */
  void FollowSurface();

  /** Set them for a surface that is to be split: at short edges and thin triangles short. */
  void FollowThinTriangles();

  /** Make them shorter where triangles of the surface are thin now: beside edges that stay short,
   * since without them it would be too far from the input's. */
  void ShortenAtThinTriangles();

  /** Set them for a surface that is to be remeshed: what is asked for, whatever the surface has; if
   * nothing is, as FollowSurface does. */
  void FollowWishes();

  /** The length asked for everywhere; infinite without one. */
  double Most() const { return this->Everywhere; }

  /** At a place in or near a cell. */
  double At(Id cell, const Point& place) const;

  /** Insert the values of a point that was added to the mesh, given what At(cell, its place) used.
   */
  void Append(Id cell, const Point& place);

  /** How many cells a mesh of such sizes has, roughly. */
  double EstimatedCells() const;

private:
  /** The length that the surface allows, and the one asked for. */
  struct Lengths
  {
    double Surface;
    double Wanted;
    double Both() const { return this->Surface < this->Wanted ? this->Surface : this->Wanted; }
  };
  Lengths LengthsAt(Id cell, const Point& place) const;
  double WantedAt(const Point& place, double otherwise) const;
  void SetLengthsOfSurface(double heights);
  void Grow();
  void SetSizes();

  RefinableMesh& Mesh;
  const SizingParameters& Parameters;
  double Everywhere; ///< what EdgeLength and MaximumVolume allow
  std::vector<Lengths> AtPoints;
};
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/Cavity.h"
#include "Refine/CellShape.h"

namespace insideout
{
/**
 * Inserts a point into the cells whose circumsphere contains it (Bowyer 1981, Watson 1981), but
 * never across a facet, and only into cells whose faces it sees, exactly.
 */
class PointInsertion
{
public:
  explicit PointInsertion(RefinableMesh& mesh)
    : Mesh(mesh)
    , Hole(mesh)
  {
  }

  /** Locate a place, walking from a cell. @return false if a facet is between */
  bool Locate(Id cell, const Point& place);

  /** The squared distance of the place to the nearest corner of its cell: an upper bound of
   * SquaredSpacing. */
  double SquaredDistanceToHolder() const;

  /**
   * Find the cells that the located place would replace.
   * @param[in] most limit of replaced cells, nearest first: circumspheres of flat cells contain
   * hundreds of points
   * @return false if it cannot be inserted
   */
  bool FindCavity(std::size_t most) { return this->FindCavity(None, most); }

  /** Locate and find cells. */
  bool Find(Id cell, const Point& place, std::size_t most)
  {
    return this->Locate(cell, place) && this->FindCavity(most);
  }

  /** Find the cells that the center of a cell's neighbor across face k would replace; the cell has
   * to be among them. A cell that is flat in doubles may not contain its own rounded center. */
  bool FindBeside(Id cell, int k, std::size_t most);

  /** The cell that contains the located place. */
  Id Holder() const { return this->Holding; }

  /** The squared distance to the nearest corner of the cells to be replaced. */
  double SquaredSpacing() const { return this->Hole.SquaredSpacing(); }

  /** The worst shape (ShapeOf) of the cells to be replaced. */
  double WorstShapeBefore() const { return WorstShapeOf(this->Mesh, this->Hole.Cells()); }

  /** Move the located place to improve the new cells. @return their worst shape */
  double OptimizePlace();

  /** Insert the located place. @return the point */
  Id Insert(double size);

private:
  bool IsSeen(const Triangle& wall, const Point& place) const;
  bool FindCavity(Id other, std::size_t most);

  RefinableMesh& Mesh;
  Id Holding = None;
  Cavity Hole;
};
} // namespace insideout

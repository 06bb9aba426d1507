// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/Cavity.h"
#include "Refine/CellShape.h"

namespace insideout
{
/**
 * Inserts a point in the cells whose circumsphere holds it (Bowyer 1981, Watson 1981), but never
 * across a facet, and only in cells whose faces it sees, exactly.
 */
class PointInsertion
{
public:
  explicit PointInsertion(RefinableMesh& mesh)
    : Mesh(mesh)
    , Hole(mesh)
  {
  }

  /** Look for a place from a cell on. @return false where a facet is between */
  bool Locate(Id cell, const Point& place);

  /** The square of how far the place is from the nearest corner of the cell that holds it: no more
   * than SquaredSpacing will be. */
  double SquaredDistanceToHolder() const;

  /**
   * Look for the cells that the place located would replace.
   * @param[in] most cells that it replaces, those nearest to it: circumspheres of flat cells hold
   *   hundreds of others
   * @return false where it cannot be inserted
   */
  bool FindCavity(std::size_t most);

  /** Both. */
  bool Find(Id cell, const Point& place, std::size_t most)
  {
    return this->Locate(cell, place) && this->FindCavity(most);
  }

  /** The cell that the place found lies in or on. */
  Id Holder() const { return this->Holding; }

  /** The square of how far the nearest corner of the cells to be replaced is. */
  double SquaredSpacing() const { return this->Hole.SquaredSpacing(); }

  /** The worst shape (ShapeOf) of the cells to be replaced. */
  double WorstShapeBefore() const { return WorstShapeOf(this->Mesh, this->Hole.Cells()); }

  /** Move the place found to where the new cells would be better. @return their worst shape */
  double OptimizePlace();

  /** Insert the place found. @return the point */
  Id Insert(double size);

private:
  bool Walk(Id cell);

  RefinableMesh& Mesh;
  Id Holding = None;
  Cavity Hole;
};
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
/** @file The winding number of a surface whose pieces are read one after the other. */
#pragma once

#include "Data/VtkClasses.h"
#include "Probe/InputWindingNumber.h"
#include "WindingNumber/ClosePieces.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace vtkInsideOut
{
/**
 * Adds up winding numbers at the places of a data set, piece by piece. Only the open edges of
 * earlier pieces are held.
 */
class PiecesInTurn
{
public:
  /**
   * @param options as of InputWindingNumber
   * @throws insideout::Error InvalidParameter, naming the option, if one needs the whole surface
   */
  PiecesInTurn(const SurfaceOptions& options, vtkDataSet* places, bool atPoints);

  /**
   * Add a piece, which is validated by itself; one without polygons adds nothing.
   *
   * @param[in,out] warnings gains skipped or suspicious cells
   * @throws insideout::Error that names the invalid cell or point
   */
  void Add(vtkPolyData* piece, insideout::Monitor& monitor, std::vector<std::string>& warnings);

  /** Add what the pieces leave open. @return the array w @throws insideout::Error */
  vtkSmartPointer<vtkDoubleArray> Finish(insideout::Monitor& monitor);

private:
  void Add(const insideout::CountedPiece& piece, insideout::Monitor& monitor);

  const SurfaceOptions Options;
  vtkDataSet* const Places;
  const bool AtPoints;
  vtkSmartPointer<vtkDoubleArray> W;
  insideout::ClosePieces Pieces;
  bool IsEmpty = true;
};
} // namespace vtkInsideOut

// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The surface that several processes (ranks) ask about: whole on each of them, or in pieces that
 * all of them have in turn.
 *
 * A large surface would fill the memory of every rank. So the first rank, which has gathered it,
 * counts and turns its facets as a whole, cuts it into pieces (SurfacePieces.h), and broadcasts one
 * after the other. All ranks add up what the pieces say in the same order, so that it does not
 * matter how many they are. The others hold no more than a piece.
 */
#pragma once

#include "Probe/InputWindingNumber.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkMultiProcessController;
class vtkPolyData;

namespace vtkInsideOut
{
class SurfaceChunks
{
public:
  /** A surface that this process has. As the constructor of InputWindingNumber. */
  SurfaceChunks(vtkPolyData* surface, const SurfaceOptions& options, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);

  /**
   * A surface of which each rank has a piece; all ranks have to call it.
   *
   * @param together the ranks
   * @param facetsAtOnce lines, points and surfaces of no more polygons than this are whole on all
   * ranks; no piece of another has more facets
   * @throws insideout::Error as there, on all ranks where on one
   */
  SurfaceChunks(vtkPolyData* piece, const SurfaceOptions& options, insideout::Id facetsAtOnce,
    vtkMultiProcessController* together, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);

  /** How many there are; a whole surface is one piece. */
  int Size() const { return this->NumberOfPieces; }

  /** Do what may throw before all pieces are visited. All ranks have to call it.
   *
   * @throws insideout::Error what it throws, on all ranks where on one
   */
  void DoTogether(const std::function<void()>& work) const;

  /** The surface, where it is whole here; else nullptr. */
  const InputWindingNumber* Whole() const { return this->WholeSurface.get(); }

  /** A piece and its turn. */
  struct Turn
  {
    const InputWindingNumber& Piece;
    bool IsFirst;
    bool IsLast;
    insideout::ProgressRange Progress;
  };
  using Visitor = std::function<void(const Turn&)>;

  ///@{
  /**
   * Visit all pieces, for their winding numbers or their distances. All ranks have to call it.
   *
   * @throws insideout::Error what visitors throw, on all ranks where on one
   */
  void TakeTurns(insideout::Monitor& monitor, const Visitor& visit);
  void TakeTurnsForDistances(const Visitor& visit);
  ///@}

  /**
   * What the winding numbers of all pieces add up to. Those of a closed surface are whole numbers
   * off it and halves on its facets: so they are here where rounding, at the edges that pieces have
   * and the whole has not, has left them beside.
   */
  double Rounded(double sum) const;

private:
  using Maker = std::function<InputWindingNumber(const SurfaceChunk&)>;

  void Cut(vtkPolyData* surface, insideout::Id facetsAtOnce, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);
  void TakeTurns(const char* stage, const Maker& make, const Visitor& visit);
  void Broadcast(SurfaceChunk& piece) const;
  bool IsFirstRank() const;

  SurfaceOptions Options;
  vtkMultiProcessController* Together = nullptr;
  std::unique_ptr<const InputWindingNumber> WholeSurface;
  std::vector<SurfaceChunk> Pieces; ///< on the first rank
  int NumberOfPieces = 1;
  int Exponent = 0; ///< coordinates of the whole surface are below 2 to the power of this
  int IsClosed = 0; ///< not 0 where the whole surface is
};
} // namespace vtkInsideOut

// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file The surface queried by several processes (ranks): whole on each of them, or in chunks that
 * all of them have in turn.
 *
 * A large surface would fill the memory of every rank. So the first rank, which has gathered it,
 * counts and turns its facets as a whole, cuts it into chunks (SurfacePieces.h), and broadcasts
 * these one by one. Each is closed by caps (ClosePieces.h), which are broadcast last. All ranks add
 * up the results in the same order, so results do not depend on the number of ranks. The other
 * ranks hold at most one chunk.
 */
#pragma once

#include "Data/VtkClasses.h"
#include "Probe/InputWindingNumber.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vtkInsideOut
{
class SurfaceChunks
{
public:
  /** A surface of this process only. For parameters see InputWindingNumber's constructor. */
  SurfaceChunks(vtkPolyData* surface, const SurfaceOptions& options, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);

  /**
   * A surface of which each rank has a piece; all ranks have to call it.
   *
   * @param together the ranks
   * @param facetsAtOnce lines, points and surfaces of at most this many polygons are whole on all
   * ranks; chunks of others have at most this many facets
   * @throws insideout::Error as there, on all ranks if on one
   */
  SurfaceChunks(vtkPolyData* piece, const SurfaceOptions& options, insideout::Id facetsAtOnce,
    vtkMultiProcessController* together, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);

  /** The number of chunks; a whole surface is one. */
  int Size() const { return this->NumberOfPieces; }

  /** Do something that may throw before chunks are visited. All ranks have to call it.
   *
   * @throws insideout::Error its error, on all ranks if on one
   */
  void DoTogether(const std::function<void()>& work) const;

  /** The surface, if it is whole here; else nullptr. */
  const InputWindingNumber* Whole() const { return this->WholeSurface.get(); }

  /** A chunk, or what is left of the surface after all of them. */
  struct Turn
  {
    const InputWindingNumber& Piece;
    bool IsFirst;
    bool IsLast;
    bool IsClosed; ///< by caps
    insideout::ProgressRange Progress;
  };
  using Visitor = std::function<void(const Turn&)>;

  ///@{
  /**
   * Visit all chunks, for their winding numbers or their distances. All ranks have to call it.
   *
   * @throws insideout::Error of visitors, on all ranks if on one
   */
  void TakeTurns(insideout::Monitor& monitor, const Visitor& visit);
  void TakeTurnsForDistances(const Visitor& visit);
  ///@}

private:
  using Maker = std::function<InputWindingNumber(const SurfaceChunk&)>;

  void Cut(vtkPolyData* surface, insideout::Id facetsAtOnce, insideout::Monitor& monitor,
    std::vector<std::string>& warnings);
  void TakeTurns(int turns, const char* stage, const Maker& make, const Visitor& visit);
  void Broadcast(SurfaceChunk& piece) const;
  bool IsFirstRank() const;

  SurfaceOptions Options;
  vtkMultiProcessController* Together = nullptr;
  std::unique_ptr<const InputWindingNumber> WholeSurface;
  std::vector<SurfaceChunk> Pieces; ///< on the first rank: chunks, then what is left
  int NumberOfPieces = 1;
  int NumberOfTurns = 1; ///< chunks, and what is left
  int Exponent = 0;      ///< coordinates of the whole surface are below 2 to this power
};
} // namespace vtkInsideOut

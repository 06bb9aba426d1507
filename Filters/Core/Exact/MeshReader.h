// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FlippableMesh.h"

#include <algorithm>
#include <array>

namespace insideout
{
/**
 * Searches in a mesh: in all of it while no other thread works on it, or in a block of vertices
 * while other threads change other blocks.
 *
 * A thread may change cells with all corners in its block. A cell with corners in two blocks stays,
 * so a thread may read each cell with a corner in its block, and the neighbors across faces with
 * one.
 */
class MeshReader
{
public:
  /** Cells visited in the time of one predicate. */
  static constexpr std::int64_t CellsPerWork = 2;

  /** A block of vertices, all doubles, and a thread's memory for searches. */
  struct Block
  {
    const std::vector<Id>& BlockOf; ///< per vertex
    Id Number;
    CellMarks& Marks;
    EdgeSearch& Search;
    WorkBudget Work; ///< counts the work, and limits it
  };

  MeshReader(const FlippableMesh& mesh)
    : Read(mesh)
    , Work(mesh.Work())
    , Marks(mesh.Own.Marks)
    , Search(mesh.OwnSearch)
  {
  }

  /** @param[in] block has to outlive the reader */
  MeshReader(const FlippableMesh& mesh, Block& block)
    : Read(mesh)
    , Work(block.Work)
    , Marks(block.Marks)
    , Search(block.Search)
    , Part(&block)
  {
  }

  const FlippableMesh& operator*() const { return this->Read; }
  const FlippableMesh* operator->() const { return &this->Read; }

  /** Whether all corners of a cell are in the block. */
  bool Holds(Id cell) const
  {
    const Tetrahedron& corners = this->Read.Cell(cell).Corners;
    return this->Part == nullptr ||
      std::all_of(corners.begin(), corners.end(),
        [this](Id corner) { return this->Part->BlockOf[corner] == this->Part->Number; });
  }

  void Spend(std::int64_t work) const { this->Work.Spend(work); }

  // The same as the functions of the mesh and of its vertices.

  int Orient(Id a, Id b, Id c, Id d) const
  {
    return this->Read.AllVertices.Orient(a, b, c, d, this->Work);
  }
  Id VertexOffPlane(Id a, Id b, Id c) const;
  void Star(Id vertex, std::vector<Id>& cells) const;
  Id FindEdge(Id u, Id v) const;

private:
  const FlippableMesh& Read;
  WorkBudget& Work;
  CellMarks& Marks;
  EdgeSearch& Search;
  const Block* Part = nullptr;
};
} // namespace insideout

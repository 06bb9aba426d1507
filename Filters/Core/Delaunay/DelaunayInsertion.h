// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Delaunay/DelaunayCells.h"

#include <vector>

namespace insideout
{
/** The outcome for a vertex that was to be inserted. */
enum class Inserted
{
  Fresh,     ///< it is in the mesh
  Coincides, ///< another vertex is in its place
  Busy,      ///< another thread holds a vertex nearby
  NoRoom,    ///< DelaunayCells::Reserve has to be called
};

/**
 * Inserts vertices one by one, on one of several threads: those cells whose spheres hold the vertex
 * give way to cells between it and their outer faces (Bowyer 1981, Watson 1981).
 */
class DelaunayInsertion
{
public:
  /** @param[in] thread another number for each thread at work, not 0 */
  DelaunayInsertion(DelaunayCells& cells, std::uint32_t thread);

  /**
   * Insert a vertex; without effect but where it says Fresh.
   * @param[out] other the vertex that coincides, if one does
   */
  Inserted Insert(Id vertex, Id& other);

private:
  /** A face of a cell that goes, whose other cell stays; later, of the fresh cell there. */
  struct OuterFace
  {
    Id Cell;
    int Face;
  };

  Id Walk(const Point& point) const;
  int FaceTowards(Id cell, int from, const Point& point) const;
  bool Hold(Id vertex);
  bool HoldCell(Id cell, const Point& point);
  bool IsInConflict(Id cell, const Point& point) const;
  Id VertexAt(Id cell, const Point& point) const;
  bool FindCellsThatGo(Id first, const Point& point);
  void Replace(Id vertex);
  void ConnectByTable();
  void ConnectBySorting();
  void Undo();

  DelaunayCells& Cells;
  const std::uint32_t Thread;
  Id Start = 0;         ///< where the search for a place starts
  std::vector<Id> Free; ///< cells that this thread may make
  std::vector<Id> Held; ///< vertices
  std::vector<Id> Going;
  std::vector<Id> Staying; ///< neighbors of those that go
  std::vector<OuterFace> Outer;
  std::vector<std::array<std::size_t, 3>> Places; ///< in Held, of each outer face's corners
  std::vector<Id> Table;                          ///< by two places in Held, numbers of faces
};
} // namespace insideout

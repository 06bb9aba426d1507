// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Exact/ExactVertices.h"

#include <cstdint>
#include <vector>

namespace insideout
{
/** A tetrahedron of a FlippableMesh. Neighbor k and facet k are across from corner k. */
struct FlippableCell
{
  Tetrahedron Corners;
  std::array<Id, 4> Neighbors;
  std::array<Id, 4> Facets; ///< that the face is a piece of, None for none
};

/** The face of a cell across from its corner Face. */
struct MeshFace
{
  Id Cell;
  int Face;
};

/** The cells around an edge (U, V): cell k has the corners U, V, Points[k], Points[k + 1]. */
struct EdgeRing
{
  Id U;
  Id V;
  std::vector<Id> Points;
  std::vector<Id> Cells;
};

/**
 * A tetrahedralization that can be changed: cells with their neighbours, and one change that all
 * others are made of, "replace these cells by those". What is beyond the hull is tetrahedra, too,
 * between the hull's faces and a vertex at infinity, so every face has two cells.
 *
 * Cells are positively oriented (ExactVertices::Orient); one with the infinite vertex is turned as
 * if that lay outside.
 */
class FlippableMesh
{
public:
  /**
   * The Delaunay tetrahedralization of points that span space.
   * @param[out] same for each point the first one at the same place: the vertex that stands for it
   * @param[in] work what is done with the mesh is counted there; it has to live as long as the mesh
   * @throws Error Planar, Stopped
   */
  FlippableMesh(
    const std::vector<Point>& points, std::vector<Id>& same, WorkBudget& work, Monitor& monitor);

  const ExactVertices& Vertices() const { return this->AllVertices; }
  WorkBudget& Work() const { return this->AllVertices.Work(); }

  /** The vertex at infinity. Those below it are the points, those above it Steiner points. */
  Id Infinite() const { return this->InfiniteVertex; }

  /** Of all cells, dead ones too: their ids are below this. */
  Id NumberOfCells() const { return static_cast<Id>(this->Cells.size()); }

  /** Good until the next Replace. */
  const FlippableCell& Cell(Id cell) const { return this->Cells[cell]; }

  /** Whether the cell was replaced; its id is given to another one day. */
  bool IsDead(Id cell) const { return this->Cells[cell].Corners[0] == None; }
  bool IsInfinite(Id cell) const;
  int CornerIndex(Id cell, Id vertex) const;
  bool Has(Id cell, Id vertex) const;

  bool HasVertex(Id vertex) const { return this->CellOf[vertex] != None; }

  /** One of the cells around a vertex, None where it is in no cell. */
  Id CellAt(Id vertex) const { return this->CellOf[vertex]; }

  /** The index that `cell` has among the neighbors of the cell across its face k. */
  int MirrorIndex(Id cell, int k) const;
  Id Opposite(Id cell, int k) const;

  /** The corners of a face, counter-clockwise seen from the corner across. */
  Triangle FaceCorners(Id cell, int face) const;

  /** Append the cells around a vertex; none for a vertex that is in no cell. */
  void Star(Id vertex, std::vector<Id>& cells) const;

  /** The finite vertices that share an edge with one of the points, without these, ascending. */
  std::vector<Id> NeighborsOf(const std::vector<Id>& points) const;

  /** A cell with both vertices, None if they share no edge. */
  Id FindEdge(Id u, Id v) const;

  /** A cell with the three vertices and its face across from the fourth, if they are a face. */
  bool FindFace(Id a, Id b, Id c, Id& cell, int& face) const;

  /** For each of the triangles the face that it is, with Cell None for those that are none. */
  std::vector<MeshFace> FindFaces(const std::vector<Triangle>& triangles) const;

  /** The cells around an edge of `cell`. */
  void Ring(Id u, Id v, Id cell, EdgeRing& ring) const;

  /**
   * Put `fresh` in place of `old`, which fill the same space. Faces between the two sets and the
   * rest keep their facets; inner ones have none.
   */
  void Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh);

  /** Connect a vertex that lies within a cell with its corners. */
  void SplitCell(Id cell, Id vertex);

  /**
   * Connect a vertex that lies on an edge with what is around the edge. The faces at the edge are
   * pieces of no facet then: where they were, whoever splits says so anew (SetFacet).
   */
  void SplitEdge(const EdgeRing& ring, Id vertex);

  /** Let a face be a piece of a facet, or of none. */
  void SetFacet(Id cell, int face, Id facet);

  /** Let the face that three vertices are, if they are one, be a piece of a facet, if there is one.
   */
  void MarkFace(Id a, Id b, Id c, Id facet);

  /** Of four vertices that span space, one that is not in the plane of three others. */
  Id VertexOffPlane(Id a, Id b, Id c) const;

  /** A vertex in no cell yet. */
  Id AddVertex(const Point& point);
  void RemoveLastVertex();
  Id AddVertexBetween(Id first, Id second, const DyadicNumber& a, const DyadicNumber& b,
    const ExactVertices::Span& span);

  /** Forget what is needed no more of vertices in no cell, so that a copy of the mesh is small. */
  void ForgetUnused()
  {
    this->AllVertices.ForgetExactly([this](Id vertex) { return this->HasVertex(vertex); });
  }

  /** Give a vertex another place, where all cells around it have to stay positive. */
  void MoveVertex(Id vertex, const Point& place) { this->AllVertices.MoveTo(vertex, place); }

  /** A mark per cell for one search after the other: cells are unmarked until Mark is called. */
  void StartMarking() const { ++this->Epoch; }
  bool IsMarked(Id cell) const { return this->Marks[cell] == this->Epoch; }
  void Mark(Id cell) const { this->Marks[cell] = this->Epoch; }

  /** How many times Replace or Touch was called. */
  std::int64_t NumberOfChanges() const { return this->Changes; }

  /** What NumberOfChanges was after the last change of the cells around a vertex. */
  std::int64_t LastChangeAround(Id vertex) const { return this->ChangeAround[vertex]; }

  /** Take what is around a vertex as changed, where no cell but a constraint has. */
  void Touch(Id vertex) { this->ChangeAround[vertex] = ++this->Changes; }

private:
  struct PendingFace
  {
    std::array<Id, 3> Corners;
    Id Cell; ///< None where the slot is empty
    int Face;
    Id Facet;
  };

  void FindFacesOneByOne(
    const std::vector<Triangle>& triangles, std::vector<MeshFace>& faces) const;
  void FindFacesInAllCells(
    const std::vector<Triangle>& triangles, std::vector<MeshFace>& faces) const;

  Id NewCell();
  PendingFace& Slot(const std::array<Id, 3>& corners);

  ExactVertices AllVertices;
  std::vector<FlippableCell> Cells;
  Id InfiniteVertex;
  std::vector<Id> CellOf;                 ///< per vertex, None for none
  std::vector<std::int64_t> ChangeAround; ///< per vertex
  std::array<Id, 4> Spanning;
  std::vector<Id> FreeCells;
  std::int64_t Changes = 0;
  mutable std::vector<std::uint32_t> Marks;
  mutable std::uint32_t Epoch = 0;
  mutable std::array<std::vector<Id>, 2> StarScratch;
  std::vector<PendingFace> Table;
};

/** The other two corners of a cell, so that (i, j, first, second) is an even permutation. */
extern const std::array<std::array<std::array<std::int8_t, 2>, 4>, 4> OtherCorners;

/** Corners of the face across from corner k, counter-clockwise seen from corner k. */
extern const std::array<std::array<std::int8_t, 3>, 4> FaceSeenFrom;

inline bool FlippableMesh::IsInfinite(Id cell) const
{
  return this->Has(cell, this->InfiniteVertex);
}

inline int FlippableMesh::CornerIndex(Id cell, Id vertex) const
{
  const Tetrahedron& t = this->Cells[cell].Corners;
  return t[0] == vertex ? 0 : t[1] == vertex ? 1 : t[2] == vertex ? 2 : t[3] == vertex ? 3 : -1;
}

inline bool FlippableMesh::Has(Id cell, Id vertex) const
{
  return this->CornerIndex(cell, vertex) >= 0;
}

inline Triangle FlippableMesh::FaceCorners(Id cell, int face) const
{
  const Tetrahedron& t = this->Cells[cell].Corners;
  const auto& f = FaceSeenFrom[face];
  return { t[f[0]], t[f[1]], t[f[2]] };
}

inline int FlippableMesh::MirrorIndex(Id cell, int k) const
{
  const auto& back = this->Cells[this->Cells[cell].Neighbors[k]].Neighbors;
  // Two cells may share more than one face; the shared one is across from a corner of its own.
  const Tetrahedron& t = this->Cells[cell].Corners;
  const Tetrahedron& other = this->Cells[this->Cells[cell].Neighbors[k]].Corners;
  for (int j = 0; j < 4; ++j)
  {
    if (back[j] == cell)
    {
      const Id apex = other[j];
      if (apex != t[(k + 1) % 4] && apex != t[(k + 2) % 4] && apex != t[(k + 3) % 4])
      {
        return j;
      }
    }
  }
  return -1;
}

inline Id FlippableMesh::Opposite(Id cell, int k) const
{
  return this->Cells[this->Cells[cell].Neighbors[k]].Corners[this->MirrorIndex(cell, k)];
}
} // namespace insideout

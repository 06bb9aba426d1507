// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Exact/EdgeSearch.h"
#include "Exact/ExactVertices.h"
#include "Mesh/Mesh.h"

namespace insideout
{
/** The policy of a Mesh whose hull's faces have cells beyond them, with a vertex at infinity. */
struct HullPolicy
{
  struct Content
  {
  };
  static constexpr bool HasBoundary = false;
  static constexpr std::size_t MostCells = MostNumberedCells;
};

using FlippableCell = MeshCell<HullPolicy::Content>;

/**
 * A tetrahedralization of the convex hull, with exact vertices. Tetrahedra between the hull's faces
 * and a vertex at infinity fill the space beyond the hull, so every face has two cells.
 *
 * Cells are positively oriented (ExactVertices::Orient); one with the infinite vertex is turned as
 * if that lay outside.
 */
class FlippableMesh : public Mesh<HullPolicy>
{
public:
  /**
   * The Delaunay tetrahedralization of points that span space.
   * @param[out] same for each point the first coincident one: the vertex that represents it
   * @param[in] work counts the work on the mesh; it has to live as long as the mesh
   * @throws Error Planar, TooLarge, Stopped
   */
  FlippableMesh(
    const std::vector<Point>& points, std::vector<Id>& same, WorkBudget& work, Monitor& monitor);

  const ExactVertices& Vertices() const { return this->AllVertices; }
  WorkBudget& Work() const { return this->AllVertices.Work(); }

  /** The vertex at infinity. Those below it are the points, those above it Steiner points. */
  Id Infinite() const { return this->InfiniteVertex; }
  bool IsInfinite(Id cell) const { return this->Has(cell, this->InfiniteVertex); }

  /** Append the cells around a vertex; none for a vertex that is in no cell. */
  void Star(Id vertex, std::vector<Id>& cells) const;

  /** The finite vertices that share an edge with a vertex, ascending. */
  std::vector<Id> NeighborsOf(Id vertex) const;

  /** A cell with both vertices, None if they share no edge. */
  Id FindEdge(Id u, Id v) const;

  /** Whether the two vertices of each pair share an edge; on several threads. */
  std::vector<char> HasEdges(const std::vector<std::array<Id, 2>>& edges) const;

  /** A cell with the three vertices and its face across from the fourth, if they are a face. */
  bool FindFace(Id a, Id b, Id c, Id& cell, int& face) const;

  /** The face that coincides with each triangle, with Cell None if there is none. */
  std::vector<MeshFace> FindFaces(const std::vector<Triangle>& triangles) const;

  /** Mesh::Replace, without other facets than before. */
  void Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh);

  /** The same, with facets of faces of the fresh cells. */
  void Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh,
    const std::vector<FreshFacet>& facets)
  {
    this->Replace(old, fresh, facets, this->Own);
  }

  /**
   * The same on one of several threads, each with cells and vertices that only it changes, and in
   * its workspace the dead cells that its fresh ones replace. No journal may be kept.
   */
  void Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh,
    const std::vector<FreshFacet>& facets, Workspace& work);

  /**
   * Add dead cells for a workspace.
   * @return their ids, the first last
   * @throws Error TooLarge
   */
  std::vector<Id> AddDeadCells(std::size_t count);

  /** Take over a workspace's dead cells and its count of changes. */
  void TakeOver(const std::vector<Id>& deadCells, std::int64_t changes);

  /** Connect a vertex that lies within a cell with its corners. */
  void SplitCell(Id cell, Id vertex);

  /**
   * Connect a vertex that lies on an edge with the cells around the edge. The faces at the edge are
   * then pieces of no facet: the caller has to set their facets again (SetFacet).
   */
  void SplitEdge(const EdgeRing& ring, Id vertex);

  /** Set the facet of a face, or None. */
  void SetFacet(Id cell, int face, Id facet);

  /** Set the facet of the face with three vertices, if both exist. */
  void MarkFace(Id a, Id b, Id c, Id facet);

  /** One of four vertices that span space that is not in the plane of three others. */
  Id VertexOffPlane(Id a, Id b, Id c) const;

  /** A vertex in no cell yet. */
  Id AddVertex(const Point& point);
  void RemoveLastVertex();
  Id AddVertexBetween(Id first, Id second, const DyadicNumber& a, const DyadicNumber& b,
    const ExactVertices::Span& span);

  /** Drop exact coordinates of vertices in no cell. No journal may be kept. */
  void ForgetUnused()
  {
    this->AllVertices.ForgetExactly([this](Id vertex) { return this->HasVertex(vertex); });
  }

  /** Move a vertex to a position where all cells around it stay positive. */
  void MoveVertex(Id vertex, const Point& place) { this->AllVertices.MoveTo(vertex, place); }

  /** Start a journal, with which GoBack restores the present mesh. */
  void StartJournal();

  bool HasJournal() const { return this->Own.Past.IsKept; }

  /** End the journal and keep the mesh. */
  void EndJournal();

  /** Restore the mesh at the start of the journal. */
  void GoBack();

  /** How many times Replace or Touch was called. */
  std::int64_t NumberOfChanges() const { return this->Own.Changes; }

  /** Mark the surroundings of a vertex as changed: a constraint has changed, but no cell. */
  void Touch(Id vertex)
  {
    this->RecordVertex(vertex, this->Own);
    this->ChangeAround[vertex] = ++this->Own.Changes;
  }

  /** Marks for searches without marks of their own. */
  CellMarks& Marks() const { return this->Own.Marks; }

private:
  friend class MeshReader;

  void FindFacesOneByOne(
    const std::vector<Triangle>& triangles, std::vector<MeshFace>& faces) const;
  void FindFacesInAllCells(
    const std::vector<Triangle>& triangles, std::vector<MeshFace>& faces) const;

  ExactVertices AllVertices;
  Id InfiniteVertex;
  std::array<Id, 4> Spanning;
  mutable Workspace Own;
  mutable CellMarks VertexMarks; ///< of NeighborsOf
  mutable EdgeSearch OwnSearch;
};
} // namespace insideout

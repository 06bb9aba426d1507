// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FlippableMesh.h"
#include "Exact/SegmentTable.h"
#include "Support/RationalVectors.h"

#include <map>
#include <set>
#include <string>
#include <vector>

/** Meshes under construction: what they must hold whatever was done to them, in rational numbers.
 */
namespace testflips
{
using namespace insideout;
using testmeshes::Rational;
using testmeshes::Vector;

/** Tests read the cells of a mesh here and nowhere else. */
inline const FlippableCell& CellAt(const FlippableMesh& mesh, Id cell)
{
  return mesh.Cell(cell);
}

inline Id NumberOfCells(const FlippableMesh& mesh)
{
  return mesh.NumberOfCells();
}

/** A mesh as it was at one time: to compare with, and to break. */
struct MeshRecord
{
  explicit MeshRecord(const FlippableMesh& mesh);

  bool IsDead(Id cell) const { return this->Cells[cell].Corners[0] == None; }
  bool IsInfinite(Id cell) const;

  /** The live cells without the vertex at infinity, corners ascending. */
  std::set<Tetrahedron> FiniteCells() const;

  Id Infinite;
  std::vector<FlippableCell> Cells;
  std::vector<Id> CellOf;     ///< per vertex a cell that has it, None for none
  std::vector<Vector> Places; ///< per vertex; the infinite one's means nothing
};

/** Six times the volume of a tetrahedron, positive where a, b, c run counter-clockwise seen from d.
 */
Rational SixfoldVolume(const Vector& a, const Vector& b, const Vector& c, const Vector& d);

/** The sum of that over all finite cells. */
Rational SixfoldVolume(const MeshRecord& mesh);

/** The faces that each facet is made of, corners ascending. */
std::map<Id, std::set<Triangle>> FacesOfFacets(const MeshRecord& mesh);

/**
 * The broken laws of a mesh, each line beginning with the law:
 * - corners: a live cell has four different vertices;
 * - neighbors: they are live, mutual, and have the three corners of the shared face;
 * - faces: each has two cells;
 * - orientation: finite cells have positive volumes;
 * - hull: the finite cell behind an infinite one is on the inner side, and no edge is reflex;
 * - vertices: the cells around each hang together, and one of them is the one that it names;
 * - facets: the cells on the two sides of a face name the same;
 * - volume: the finite cells fill what the hull encloses;
 * - Euler: the cells, with the infinite ones, are a triangulated 3-sphere.
 *
 * Where the first three are broken the others are not looked at.
 */
std::vector<std::string> Violations(const MeshRecord& mesh);

/**
 * The same, and whether the mesh says what its cells say:
 * - accessors: MirrorIndex, Opposite, Star and HasVertex;
 * - predicates: Orient is the sign of the volume;
 * - places: Nearest is within rounding errors of the exact place.
 */
std::vector<std::string> FlippableMeshViolations(const FlippableMesh& mesh);

/** How facets have to be kept. */
enum class FacetsKept
{
  AsFaces, ///< the same faces
  AsAreas  ///< faces that cover the same part of the plane, exactly
};

/** Errors in the facets and the volume of a mesh that was `before` earlier. */
std::vector<std::string> ChangeViolations(
  const MeshRecord& before, const MeshRecord& after, FacetsKept kept);

/** Whether triangles in one plane, which do not overlap among each other, cover the same. */
bool CoverTheSame(const std::vector<Vector>& places, const std::set<Triangle>& some,
  const std::set<Triangle>& others);

/**
 * Whether the mesh has all edges of each facet that is there, split where the table says, and the
 * facet's faces are bounded by just these.
 */
std::vector<std::string> ConstraintViolations(
  const FlippableMesh& mesh, const SegmentTable& segments, const std::vector<Triangle>& facets);

/** How two meshes differ: cells, their neighbors and facets, vertices and their places. */
std::vector<std::string> Differences(const MeshRecord& a, const MeshRecord& b);

/** Expect that there are no violations. */
void ExpectFlippableMeshLaws(const FlippableMesh& mesh);
void ExpectFlippableMeshLaws(
  const FlippableMesh& mesh, const MeshRecord& before, FacetsKept kept = FacetsKept::AsFaces);

/** Expect that a mesh is exactly as it was. */
void ExpectUnchanged(const FlippableMesh& mesh, const MeshRecord& before);
} // namespace testflips

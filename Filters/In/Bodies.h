// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Several bodies in one input: the assignment of triangles to bodies, and the arrays for it.
 */
#pragma once

#include "Boolean/BodyRegions.h"
#include "Boolean/SegmentBodies.h"
#include "Data/VtkClasses.h"
#include "HullMesh.h"
#include "In/ReadSurface.h"
#include "In/Tags.h"
#include "Output/RegionBoundaries.h"

namespace vtkInsideOut
{
/** The bodies of a surface; without names it is a single one. */
struct Bodies
{
  std::vector<insideout::Id> OfTriangle; ///< one per triangle, indices in the names
  std::vector<std::string> Names;

  bool AreNamed() const { return !this->Names.empty(); }
};

/** The array that JoinBlocks adds. */
constexpr const char* BodyIds = "BodyIds";

/**
 * Join all blocks of a composite data set to one surface, in their order, with their common data.
 * The cell array BodyIds numbers the blocks, and the field array BodyNames has their names as paths
 * (Block).
 *
 * @param[in,out] warnings gains a line per block without polygons, and per array that is renamed
 * @throws insideout::Error InvalidParameter that names a block which is no vtkPolyData;
 *   EmptySurface if none has polygons
 */
vtkSmartPointer<vtkPolyData> JoinBlocks(vtkDataObject* blocks, std::vector<std::string>& warnings);

/** The names of the bodies of a cell array; none if its name is empty. */
std::vector<std::string> NamesOfBodies(vtkPolyData* surface, const std::string& arrayName);

/**
 * The bodies by a cell array, as ReadTags or ReadSides reads it; none if its name is empty.
 *
 * @param[in,out] surface with two labels per triangle, each triangle between two bodies becomes one
 * copy per body, turned outward; triangles with one body, or none, on both sides are left out with
 * a warning
 */
Bodies ReadBodies(Surface& surface, const std::string& arrayName);

/** Names separated by commas; a backslash escapes the next character. */
std::vector<std::string> SplitNames(const std::string& names);

/**
 * The seeds of each body: those with its name in their array Body, and outside seeds without a
 * name.
 *
 * @param[in] points from which the seeds were read
 * @throws insideout::Error InvalidParameter for the name of no body, for an inside seed without a
 * name, and for an array without one value per point
 */
std::vector<std::vector<insideout::Seed>> SeedsOfBodies(const std::vector<insideout::Seed>& seeds,
  vtkPointSet* points, const std::vector<std::string>& names);

/**
 * The selected pieces of each body's facets.
 *
 * @param[in] chosen one per facet; empty for all
 */
std::vector<std::vector<insideout::FacetPiece>> PiecesOfBodies(
  const insideout::HullMesh& hull, const Bodies& bodies, const std::vector<unsigned char>& chosen);

/** Whether a cell is in one of a facet's own bodies: such a facet is not an outlier. */
std::function<bool(insideout::Id, insideout::Id)> IsInOwnBody(const insideout::HullMesh& hull,
  const Bodies& bodies, const std::vector<std::vector<unsigned char>>& inside);

/** The winding number of each body, as the cell array BodyW of a grid of all cells. */
void AddBodyW(const insideout::HullMesh& hull, const std::vector<std::string>& names,
  vtkUnstructuredGrid* grid);

/** The extent of each body, as the cell array InBody of a grid of all cells, with the field arrays
 * BodyNames, BodyVolume, RegionNames and RegionBodies. */
void AddBodies(const Bodies& bodies, const std::vector<std::vector<unsigned char>>& inside,
  const insideout::BodyRegions& regions, const insideout::TetrahedralMesh& mesh,
  vtkUnstructuredGrid* grid);

/** Add the regions behind and in front of each boundary triangle: the cell array RegionIds. */
void AddRegionIds(const insideout::RegionBoundaries& boundaries, vtkPolyData* boundary);

/**
 * Tag the triangles of a boundary of regions by the two regions: the cell array BoundaryTag.
 * Triangles with the outside beyond have the tags of the surface, if given.
 *
 * @param[in] tags of the surface, or nullptr
 */
void AddRegionTags(const insideout::RegionBoundaries& boundaries,
  const std::vector<std::string>& regionNames, const Tags* tags, vtkPolyData* boundary);
} // namespace vtkInsideOut

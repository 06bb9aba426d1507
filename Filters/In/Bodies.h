// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Several bodies in one input: which triangles are whose, and the arrays that tell of them.
 */
#pragma once

#include "Boolean/BodyRegions.h"
#include "Boolean/SegmentBodies.h"
#include "HullMesh.h"
#include "In/ReadSurface.h"
#include "In/Tags.h"
#include "Output/RegionBoundaries.h"

class vtkDataObject;
class vtkPointSet;
class vtkUnstructuredGrid;

namespace vtkInsideOut
{
/** The bodies of a surface; it is a single one without a name where there are none. */
struct Bodies
{
  std::vector<insideout::Id> OfTriangle; ///< one per triangle, by the names
  std::vector<std::string> Names;

  bool AreNamed() const { return !this->Names.empty(); }
};

/** The array that JoinBlocks adds. */
constexpr const char* BodyIds = "BodyIds";

/**
 * All blocks of a composite data set as one surface, in their order, with the data that all of them
 * have; the cell array BodyIds numbers the blocks, and the field array BodyNames has what they are
 * called, by what leads to them (Block).
 *
 * @param[in,out] warnings gains a line per block without polygons, and per array that is renamed
 * @throws insideout::Error InvalidParameter that names a block which is no vtkPolyData;
 *   EmptySurface where none has polygons
 */
vtkSmartPointer<vtkPolyData> JoinBlocks(vtkDataObject* blocks, std::vector<std::string>& warnings);

/** The names of the bodies by a cell array; none where its name is empty. */
std::vector<std::string> NamesOfBodies(vtkPolyData* surface, const std::string& arrayName);

/**
 * The bodies by a cell array, as ReadTags or ReadSides reads it; none where its name is empty.
 *
 * @param[in,out] surface by sides each triangle between two bodies is there twice then, a copy for
 *   each, turned outward; what lies in one body on both sides, or in none, is left out with a
 *   warning
 */
Bodies ReadBodies(Surface& surface, const std::string& arrayName);

/** Names that are parted by commas; what follows a backslash is part of a name. */
std::vector<std::string> SplitNames(const std::string& names);

/**
 * The seeds of each body: those whose array Body has its name; and those outside that name none.
 *
 * @param[in] points that the seeds were read from
 * @throws insideout::Error InvalidParameter for a name that is no body's, for a seed inside that
 * names none, and for an array that has not one value per point
 */
std::vector<std::vector<insideout::Seed>> SeedsOfBodies(const std::vector<insideout::Seed>& seeds,
  vtkPointSet* points, const std::vector<std::string>& names);

/**
 * The pieces of each body's facets, of those that are chosen.
 *
 * @param[in] chosen one per facet; empty for all
 */
std::vector<std::vector<insideout::FacetPiece>> PiecesOfBodies(
  const insideout::HullMesh& hull, const Bodies& bodies, const std::vector<unsigned char>& chosen);

/** Whether a facet's own bodies have a cell: what keeps it from being an outlier. */
std::function<bool(insideout::Id, insideout::Id)> IsInOwnBody(const insideout::HullMesh& hull,
  const Bodies& bodies, const std::vector<std::vector<unsigned char>>& inside);

/** The winding number of each body on a grid of all cells: its cell array BodyW. */
void AddBodyW(const insideout::HullMesh& hull, const std::vector<std::string>& names,
  vtkUnstructuredGrid* grid);

/** Where bodies are, on a grid of all cells, as its cell array InBody, and the field arrays
 * BodyNames, BodyVolume, RegionNames and RegionBodies. */
void AddBodies(const Bodies& bodies, const std::vector<std::vector<unsigned char>>& inside,
  const insideout::BodyRegions& regions, const insideout::TetrahedralMesh& mesh,
  vtkUnstructuredGrid* grid);

/** Add the regions behind and before each triangle of a boundary of regions: the cell array
 * RegionIds. */
void AddRegionIds(const insideout::RegionBoundaries& boundaries, vtkPolyData* boundary);

/**
 * Tag the triangles of a boundary of regions by the two regions: the cell array BoundaryTag.
 * Triangles without a region beyond have the tags of the surface, if these are given.
 *
 * @param[in] tags of the surface, or nullptr
 */
void AddRegionTags(const insideout::RegionBoundaries& boundaries,
  const std::vector<std::string>& regionNames, const Tags* tags, vtkPolyData* boundary);
} // namespace vtkInsideOut

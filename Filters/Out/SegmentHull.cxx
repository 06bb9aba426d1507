// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/SegmentHull.h"

#include "Boolean/CoveredBodies.h"
#include "Boolean/FillGaps.h"
#include "Boolean/SegmentBodies.h"
#include "Common/Stages.h"

#include <algorithm>
#include <utility>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
/** The number of facets that count 0 and have the same region on both sides of a piece. */
Id FacetsThatSeparateNothing(const HullMesh& hull, const SolidRegions& regions)
{
  std::vector<char> separates(hull.Surface.Facets.size(), 1);
  for (Id cell = 0; cell < hull.Mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id facet = hull.Mesh.Facets[cell][k];
      const Id beyond = hull.Mesh.Neighbors[cell][k];
      if (facet != None && beyond != None && hull.Surface.Multiplicity[facet] == 0 &&
        regions.OfCell[cell] != None && regions.OfCell[cell] == regions.OfCell[beyond])
      {
        separates[facet] = 0;
      }
    }
  }
  return static_cast<Id>(std::count(separates.begin(), separates.end(), 0));
}
} // namespace

SegmentedHull SegmentHull(const KeptHull& kept, const std::vector<Seed>& given, vtkPointSet* points,
  const SegmentOptions& options, Monitor& monitor)
{
  const HullMesh& hull = kept.Hull;
  const std::vector<unsigned char> chosen =
    ReadChosenFacets(kept.Surface, options.ConstrainedArray, hull.Surface);
  const ProgressRange findingRegions = { Stages::Extracting, 0, 0 };
  SegmentedHull segmented;
  segmented.HasInterfaces = kept.Bodies.AreNamed() || options.MembranesSeparateRegions;
  if (!kept.Bodies.AreNamed())
  {
    segmented.All = SegmentMesh(
      hull.Mesh, hull.W, PiecesOfFacets(hull.Mesh, chosen), given, options.Parameters, monitor);
    if (!options.MembranesSeparateRegions)
    {
      segmented.Regions.Regions =
        FindRegions(hull.Mesh, segmented.All.Inside, monitor, findingRegions);
      return segmented;
    }
    segmented.Regions.Regions =
      FindSeparatedRegions(hull.Surface, hull.Mesh, segmented.All.Inside, monitor, findingRegions);
    if (const Id facets = FacetsThatSeparateNothing(hull, segmented.Regions.Regions); facets > 0)
    {
      segmented.All.Warnings.push_back("MembranesSeparateRegions: " + std::to_string(facets) +
        " facets that count 0 have one region on both sides, since cells connect around their "
        "edges");
    }
    return segmented;
  }
  const std::vector<std::string>& names = kept.Bodies.Names;
  const std::vector<std::string> first = SplitNames(options.Priority);
  const std::vector<Id> priority = PriorityOf(names, first);
  const std::vector<std::vector<Seed>> seeds = SeedsOfBodies(given, points, names);
  const std::vector<std::vector<FacetPiece>> pieces = PiecesOfBodies(hull, kept.Bodies, chosen);
  std::vector<BodyToSegment> bodies;
  for (std::size_t b = 0; b < names.size(); ++b)
  {
    bodies.push_back({ names[b], hull.WOfBody(static_cast<Id>(b)), pieces[b], seeds[b] });
  }
  BodySegmentation found = SegmentBodies(hull.Mesh, bodies, options.Parameters, monitor);
  segmented.InBodies = std::move(found.Inside);
  segmented.All.Statistics = std::move(found.Statistics);
  segmented.All.Warnings = std::move(found.Warnings);
  if (options.MergeTolerance > 0)
  {
    AddFilledGaps(
      FillGaps(hull.Mesh, options.MergeTolerance, priority, segmented.InBodies, monitor),
      segmented.All.Statistics, segmented.All.Warnings);
  }
  const BodyOrder order = InnerFirst(segmented.InBodies, priority, first.size());
  segmented.Regions =
    FindBodyRegions(segmented.InBodies, options.Rule, order.Priority, monitor, findingRegions);
  for (std::string& warning : WarningsOfCoveredBodies(
         hull.Mesh, segmented.InBodies, order, segmented.Regions, names, monitor, findingRegions))
  {
    segmented.All.Warnings.push_back(std::move(warning));
  }
  for (const Id region : segmented.Regions.Regions.OfCell)
  {
    segmented.All.Inside.push_back(region != None);
  }
  return segmented;
}
} // namespace vtkInsideOut

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/SegmentHull.h"

#include "Boolean/CoveredBodies.h"
#include "Boolean/FillGaps.h"
#include "Boolean/SegmentBodies.h"
#include "Common/Stages.h"

#include <utility>

namespace vtkInsideOut
{
using namespace insideout;

SegmentedHull SegmentHull(const KeptHull& kept, const std::vector<Seed>& given, vtkPointSet* points,
  const SegmentOptions& options, Monitor& monitor)
{
  const HullMesh& hull = kept.Hull;
  const std::vector<unsigned char> chosen =
    ReadChosenFacets(kept.Surface, options.ConstrainedArray, hull.Surface);
  const ProgressRange findingRegions = { Stages::Extracting, 0, 0 };
  SegmentedHull segmented;
  if (!kept.Bodies.AreNamed())
  {
    segmented.All = SegmentMesh(
      hull.Mesh, hull.W, PiecesOfFacets(hull.Mesh, chosen), given, options.Parameters, monitor);
    segmented.Regions.Regions =
      FindRegions(hull.Mesh, segmented.All.Inside, monitor, findingRegions);
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

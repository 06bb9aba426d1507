// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/ChooseRegions.h"

#include "Common/Error.h"

#include <algorithm>
#include <numeric>

namespace insideout
{
namespace
{
void Check(const ChooseRegionsParameters& parameters)
{
  if (parameters.LargestRegions < 0)
  {
    throw Error(ErrorCode::InvalidParameter,
      std::to_string(parameters.LargestRegions) +
        " regions are to stay, which is no number of them");
  }
  if (!(parameters.MinimumRegionVolume >= 0))
  {
    throw Error(ErrorCode::InvalidParameter,
      "the least volume of a region is " + std::to_string(parameters.MinimumRegionVolume) +
        ", not a number of at least 0");
  }
}

std::vector<double> SumByRegion(const SolidRegions& regions, const std::vector<double>& sizes)
{
  std::vector<double> sums(static_cast<std::size_t>(regions.Count), 0.0);
  for (std::size_t cell = 0; cell < sizes.size(); ++cell)
  {
    if (regions.OfCell[cell] != None)
    {
      sums[regions.OfCell[cell]] += sizes[cell];
    }
  }
  return sums;
}

/** Per region, whether `isMarked` is true for one of its cells. */
template <typename Predicate>
std::vector<unsigned char> RegionsWith(const SolidRegions& regions, const Predicate& isMarked)
{
  std::vector<unsigned char> marks(static_cast<std::size_t>(regions.Count), 0);
  for (Id cell = 0; cell < static_cast<Id>(regions.OfCell.size()); ++cell)
  {
    if (regions.OfCell[cell] != None && isMarked(cell))
    {
      marks[regions.OfCell[cell]] = 1;
    }
  }
  return marks;
}

/** Per region, whether it stays. */
std::vector<unsigned char> Stay(const SolidRegions& regions, const ScaledSizes& sizes,
  const std::vector<std::int8_t>& demands, const ChooseRegionsParameters& parameters)
{
  const std::vector<double> volumes = SumByRegion(regions, sizes.Scaled);
  std::vector<unsigned char> stays(volumes.size(), 1);
  if (parameters.SeededRegions)
  {
    stays = RegionsWith(regions, [&](Id cell) { return !demands.empty() && demands[cell] > 0; });
  }
  std::vector<Id> bySize(volumes.size());
  std::iota(bySize.begin(), bySize.end(), 0);
  std::stable_sort(
    bySize.begin(), bySize.end(), [&](Id a, Id b) { return volumes[a] > volumes[b]; });
  Id count = 0;
  for (const Id region : bySize)
  {
    const bool isWanted = stays[region] &&
      sizes.InUnits(volumes[region]) >= parameters.MinimumRegionVolume &&
      (parameters.LargestRegions == 0 || count < parameters.LargestRegions);
    stays[region] = isWanted ? 1 : 0;
    count += isWanted;
  }
  return stays;
}

/** Flip the labels of regions whose value is not `stays`. */
void Relabel(const SolidRegions& regions, const std::vector<unsigned char>& stays,
  const ScaledSizes& sizes, unsigned char label, std::vector<unsigned char>& inside, Id& count,
  double& volume)
{
  const std::vector<double> volumes = SumByRegion(regions, sizes.Scaled);
  double scaled = 0;
  for (std::size_t region = 0; region < stays.size(); ++region)
  {
    count += !stays[region];
    scaled += stays[region] ? 0 : volumes[region];
  }
  volume = sizes.InUnits(scaled);
  for (std::size_t cell = 0; cell < inside.size(); ++cell)
  {
    if (regions.OfCell[cell] != None && !stays[regions.OfCell[cell]])
    {
      inside[cell] = label;
    }
  }
}
} // namespace

RegionChanges ChooseRegions(const SimplicialCells& cells, const std::vector<std::int8_t>& demands,
  const ChooseRegionsParameters& parameters, std::vector<unsigned char>& inside, Monitor& monitor,
  const ProgressRange& progress)
{
  Check(parameters);
  RegionChanges changes;
  if (parameters.ChooseAll())
  {
    return changes;
  }
  const ScaledSizes sizes = cells.Sizes();
  const SolidRegions regions =
    FindRegions(cells, inside, monitor, { progress.Stage, progress.Begin, progress.At(0.5) });
  Relabel(regions, Stay(regions, sizes, demands, parameters), sizes, 0, inside,
    changes.DroppedRegions, changes.DroppedVolume);
  if (parameters.FillCavities)
  {
    const OutsideRegions outside =
      FindOutside(cells, inside, monitor, { progress.Stage, progress.At(0.5), progress.End });
    const SolidRegions& holes = outside.Regions;
    std::vector<unsigned char> stay =
      RegionsWith(holes, [&](Id cell) { return !demands.empty() && demands[cell] < 0; });
    std::transform(stay.begin(), stay.end(), outside.IsOpen.begin(), stay.begin(),
      [](unsigned char a, unsigned char b) { return a | b; });
    Relabel(holes, stay, sizes, 1, inside, changes.FilledCavities, changes.FilledVolume);
  }
  return changes;
}
} // namespace insideout

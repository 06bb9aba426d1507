// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/MeantVolume.h"

#include "Boolean/WindingVolumes.h"
#include "Common/Error.h"
#include "Common/ScaledPoints.h"
#include "Common/Stages.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "WindingNumber/CountedBoundary.h"

#include <cmath>
#include <optional>

namespace insideout
{
namespace
{
/** Facets per intersecting pair above which the surface is cut. Cutting takes some 100 us per pair
 * and meshing 20 us per facet, so that cutting takes at most a tenth of the time of meshing. */
constexpr std::size_t FacetsPerPair = 50;

/**
 * Pairs that are always cut, regardless of the number of facets: it takes some hundredths of a
 * second.
 */
constexpr std::size_t FewPairs = 256;

using Pairs = std::vector<std::array<Id, 2>>;

/** The facets that count, and the pairs of them that meet. */
struct CountedComplex
{
  FacetComplex Surface;
  Pairs Meeting;
};

CountedComplex KeepCountedFacets(
  const FacetComplex& surface, const std::vector<std::int16_t>& multiplicity, const Pairs& pairs)
{
  CountedComplex counted;
  FacetComplex& kept = counted.Surface;
  kept.Points = surface.Points;
  kept.Origins = surface.Origins;
  std::vector<Id> index(surface.Facets.size(), None);
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (multiplicity[f] == 0)
    {
      continue;
    }
    index[f] = kept.NumberOfFacets();
    kept.Facets.push_back(surface.Facets[f]);
    kept.Multiplicity.push_back(multiplicity[f]);
    kept.Sources.insert(kept.Sources.end(), surface.Sources.begin() + surface.SourceOffsets[f],
      surface.Sources.begin() + surface.SourceOffsets[f + 1]);
    kept.SourceOffsets.push_back(static_cast<Id>(kept.Sources.size()));
  }
  kept.NumberOfConstraints = kept.NumberOfFacets();
  for (const auto& [i, j] : pairs)
  {
    if (index[i] != None && index[j] != None)
    {
      counted.Meeting.push_back({ { index[i], index[j] } });
    }
  }
  return counted;
}

bool IsClosed(const FacetComplex& surface)
{
  return CountedBoundary(CountedFacets(surface), static_cast<Id>(surface.Points.size())).empty();
}

/** The volumes if the surface is closed, few of its facets meet and none is bent, else nothing. */
std::optional<WindingVolumes> ExactVolumes(const CountedComplex& counted, Monitor& monitor)
{
  const FacetComplex& surface = counted.Surface;
  const std::size_t pairs = counted.Meeting.size();
  if (!IsClosed(surface) || (pairs > FewPairs && pairs * FacetsPerPair > surface.Facets.size()))
  {
    return std::nullopt;
  }
  if (pairs == 0)
  {
    return VolumesWithin(surface, monitor);
  }
  const std::vector<Id> oneSet(surface.Facets.size(), 0);
  const Resolution resolution =
    ResolveSelfIntersections(surface, monitor, { oneSet, {}, counted.Meeting });
  return resolution.Warnings.empty() ? VolumesWithin(resolution.Surface, monitor) : std::nullopt;
}

VolumeInterval Exact(double volume)
{
  return { volume, volume, volume };
}

VolumeInterval Scaled(const VolumeInterval& volume, int exponent)
{
  return { std::ldexp(volume.Value, exponent), std::ldexp(volume.Low, exponent),
    std::ldexp(volume.High, exponent) };
}
} // namespace

SampledVolumes FindMeantVolume(const FacetComplex& surface,
  const std::vector<std::int16_t>& multiplicity, const Pairs& pairs, Monitor& monitor)
{
  monitor.Check(Stages::Resolving, 0);
  CountedComplex counted = KeepCountedFacets(surface, multiplicity, pairs);
  if (counted.Surface.Facets.empty())
  {
    return {};
  }
  try
  {
    if (const auto exact = ExactVolumes(counted, monitor))
    {
      return { Exact(exact->Once), Exact(exact->Twice) };
    }
  }
  catch (const Error& error)
  {
    if (error.Code != ErrorCode::Inconsistent)
    {
      throw;
    }
  }
  const int exponent = LargestExponent(surface.Points);
  counted.Surface.Points = ScaledPoints(surface.Points, -exponent);
  const SampledVolumes scaled =
    SampleVolumes(counted.Surface, monitor, { Stages::WindingNumbers, 0, 1 });
  return { Scaled(scaled.Solid, 3 * exponent), Scaled(scaled.Overlap, 3 * exponent) };
}
} // namespace insideout

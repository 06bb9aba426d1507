// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/SampledVolumes.h"

#include "Common/Box.h"
#include "Orient/RandomNumbers.h"
#include "Output/BoundaryTriangles.h"
#include "WindingNumber/HoleCaps.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace insideout
{
namespace
{
/** Independent estimates, whose differences give the standard error. */
constexpr int Grids = 8;

/** Student's t of 99 %, two-sided, for Grids - 1 degrees of freedom. The bounds hold in 95 % of
 * cases, since the cut may decide otherwise than w > 1/2. */
constexpr double StudentsT = 3.499;

/** Volume that all points miss, in boxes: less in 95 % of cases, even if all grids agree (rule of
 * three). */
constexpr double PlacesMissed = 3;

/** Strata along each axis: more for more facets, fewer for more open edges, whose number is the
 * cost of w at a point. A usual surface has 33,000 to 262,000 points, of 1 us each. */
constexpr double LeastStrata = 8;
constexpr double UsualStrata = 16;
constexpr double MostStrata = 32;
constexpr double FacetsPerPlace = 4;
constexpr double PlacesTimesOpenEdges = 1 << 21;

/** Half of the strata's density follows the facets' corners, and half is uniform. */
constexpr double ShareOfFacets = 0.5;
constexpr int Bins = 1024;

/** Range of w in which the cut may decide otherwise than w > 1/2: the meshes of 99 of 102 surfaces
 * are between the bounds that follow (judge-verdict.py). */
constexpr double MayBeInside = 0.2;
constexpr double MayBeOutside = 0.7;

/** Limit of the difference of w between neighboring points without a facet between them: across a
 * facet w differs by 1, from a w in the range above to one between 0 and 1 by at most 0.8. */
constexpr double Jump = 0.8;

/** The volumes by the points of one grid. */
struct Volumes
{
  double Solid = 0; ///< where w is above 1/2
  double Most = 0;  ///< with the points that the cut may take in
  double Least = 0; ///< without those that it may leave out
  double Overlap = 0;
  double Closed = 0; ///< the integral of w of the closed surface, which is known
};

std::vector<CountedEdge> OpenEdges(const FacetComplex& surface)
{
  return CountedBoundary(CountedFacets(surface), static_cast<Id>(surface.Points.size()));
}

/** Close the holes of a surface by caps. */
FacetComplex WithoutHoles(const FacetComplex& surface, const std::vector<CountedEdge>& openEdges)
{
  FacetComplex closed;
  closed.Points = surface.Points;
  for (const CountedTriangle& triangle :
    CloseChain(CountedFacets(surface), CapHoles(surface.Points, openEdges)))
  {
    closed.Facets.push_back(triangle.Corners);
    closed.Multiplicity.push_back(static_cast<std::int16_t>(triangle.Count));
  }
  return closed;
}

/** The integral of a closed surface's w. */
double IntegralOfW(const FacetComplex& surface)
{
  std::vector<BoundaryTriangle> triangles;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const auto [a, b, c] = surface.Facets[f];
    const int count = surface.Multiplicity[f];
    const Triangle facet = count > 0 ? Triangle{ { a, b, c } } : Triangle{ { a, c, b } };
    triangles.insert(triangles.end(), static_cast<std::size_t>(std::abs(count)), { facet, None });
  }
  return VolumeWithin(surface.Points, triangles);
}

/** The limits of strata along an axis. Each has the same share, of which half is length, and half
 * are corners of facets. */
std::vector<double> LimitsOfStrata(
  const FacetComplex& surface, const Box& box, int axis, int strata)
{
  const double extent = box.Extent(axis);
  std::vector<double> density(Bins, 0.0);
  for (const Triangle& facet : surface.Facets)
  {
    for (const Id p : facet)
    {
      const double share = extent > 0 ? (surface.Points[p][axis] - box.Low[axis]) / extent : 0;
      density[std::min(Bins - 1, static_cast<int>(share * Bins))] += 1;
    }
  }
  const double corners = 3 * static_cast<double>(surface.Facets.size());
  std::vector<double> limits = { box.Low[axis] };
  double passed = 0;
  for (int bin = 0; bin < Bins; ++bin)
  {
    const double here = (1 - ShareOfFacets) / Bins + ShareOfFacets * density[bin] / corners;
    for (int k = static_cast<int>(limits.size()); k < strata && (passed + here) * strata >= k; ++k)
    {
      const double share = (bin + (static_cast<double>(k) / strata - passed) / here) / Bins;
      limits.push_back(box.Low[axis] + share * extent);
    }
    passed += here;
  }
  limits.push_back(box.High[axis]);
  return limits;
}

/** A surface, and the same with its holes closed. */
struct WindingNumbers
{
  WindingNumbers(const FacetComplex& surface, const FacetComplex& closed, Monitor& monitor)
    : Given(surface, {}, monitor)
  {
    if (!this->Given.IsClosed())
    {
      this->Closed.emplace(closed, WindingNumberParameters(), monitor);
    }
  }

  SurfaceWindingNumber Given;
  std::optional<SurfaceWindingNumber> Closed; ///< where they differ
};

/** w at the points of a grid, one at random in each box. */
class SampledGrid
{
public:
  SampledGrid(const WindingNumbers& windingNumbers,
    const std::array<std::vector<double>, 3>& limits, RandomNumbers& random, Monitor& monitor,
    const ProgressRange& progress)
    : Limits(limits)
  {
    std::vector<Point> places(this->Size(0) * this->Size(1) * this->Size(2));
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      std::size_t step = 1;
      for (int axis = 0; axis < 3; step *= this->Size(axis), ++axis)
      {
        const std::size_t at = i / step % this->Size(axis);
        places[i][axis] = limits[axis][at] + random.Next() * this->Length(axis, at);
      }
    }
    this->W = windingNumbers.Given.At(
      places, monitor, { progress.Stage, progress.At(0), progress.At(0.5) });
    this->Closed = windingNumbers.Closed ? windingNumbers.Closed->At(places, monitor,
                                             { progress.Stage, progress.At(0.5), progress.At(1) })
                                         : this->W;
  }

  Volumes Measure() const
  {
    const std::vector<char> taken =
      this->Reached([](double w) { return w > 0.5; }, [](double w) { return w > MayBeInside; });
    const std::vector<char> left =
      this->Reached([](double w) { return w <= 0.5; }, [](double w) { return w <= MayBeOutside; });
    Volumes volumes;
    for (std::size_t i = 0; i < this->W.size(); ++i)
    {
      const double w = this->W[i];
      const double volume = this->VolumeOf(i);
      volumes.Solid += w > 0.5 ? volume : 0;
      volumes.Most += taken[i] ? volume : 0;
      volumes.Least += left[i] ? 0 : volume;
      volumes.Closed += this->Closed[i] * volume;
      volumes.Overlap += w > 1.5 ? volume : 0;
    }
    return volumes;
  }

private:
  std::size_t Size(int axis) const { return this->Limits[axis].size() - 1; }

  double Length(int axis, std::size_t at) const
  {
    return this->Limits[axis][at + 1] - this->Limits[axis][at];
  }

  double VolumeOf(std::size_t place) const
  {
    return this->Length(0, place % this->Size(0)) *
      this->Length(1, place / this->Size(0) % this->Size(1)) *
      this->Length(2, place / this->Size(0) / this->Size(1));
  }

  /** Mark the points at which `begins` holds for w, and all points connected with them through
   * neighbors for which `goesOn` holds, without a facet between. */
  template <typename Begins, typename GoesOn>
  std::vector<char> Reached(const Begins& begins, const GoesOn& goesOn) const
  {
    std::vector<char> reached(this->W.size(), 0);
    std::vector<std::size_t> ahead;
    for (std::size_t i = 0; i < this->W.size(); ++i)
    {
      if (begins(this->W[i]))
      {
        reached[i] = 1;
        ahead.push_back(i);
      }
    }
    while (!ahead.empty())
    {
      const std::size_t here = ahead.back();
      ahead.pop_back();
      std::size_t step = 1;
      for (int axis = 0; axis < 3; step *= this->Size(axis), ++axis)
      {
        const std::size_t at = here / step % this->Size(axis);
        for (const bool isForward : { false, true })
        {
          if (isForward ? at + 1 == this->Size(axis) : at == 0)
          {
            continue;
          }
          const std::size_t next = isForward ? here + step : here - step;
          if (!reached[next] && goesOn(this->W[next]) &&
            std::abs(this->W[next] - this->W[here]) < Jump)
          {
            reached[next] = 1;
            ahead.push_back(next);
          }
        }
      }
    }
    return reached;
  }

  const std::array<std::vector<double>, 3>& Limits; ///< of the boxes, along each axis
  std::vector<double> W;                            ///< x fastest, then y
  std::vector<double> Closed;                       ///< w of the closed surface
};

struct Estimate
{
  double Mean;
  double HalfWidth; ///< of the interval
};

Estimate EstimateOf(const std::array<double, Grids>& values)
{
  double mean = 0;
  double squares = 0;
  for (const double value : values)
  {
    mean += value / Grids;
  }
  for (const double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  return { mean, StudentsT * std::sqrt(squares / (Grids - 1) / Grids) };
}

std::array<double, Grids> ByGrids(const std::vector<Volumes>& volumes, double Volumes::*which)
{
  std::array<double, Grids> values;
  std::transform(
    volumes.begin(), volumes.end(), values.begin(), [&](const Volumes& one) { return one.*which; });
  return values;
}

/** The better of two estimates by the grids: their volumes, or the integral of the closed surface's
 * w and the differences of the volumes from it (a control variate). */
Estimate BetterEstimateOf(
  const std::vector<Volumes>& volumes, double Volumes::*which, double integral)
{
  const std::array<double, Grids> values = ByGrids(volumes, which);
  std::array<double, Grids> controlled = ByGrids(volumes, &Volumes::Closed);
  for (std::size_t grid = 0; grid < controlled.size(); ++grid)
  {
    controlled[grid] = integral + (values[grid] - controlled[grid]);
  }
  const Estimate plain = EstimateOf(values);
  const Estimate better = EstimateOf(controlled);
  return better.HalfWidth < plain.HalfWidth ? better : plain;
}

int StrataFor(std::size_t facets, std::size_t openEdges)
{
  const double wanted =
    std::clamp(std::cbrt(static_cast<double>(facets) / FacetsPerPlace), UsualStrata, MostStrata);
  const double payable = std::cbrt(PlacesTimesOpenEdges / (1 + static_cast<double>(openEdges)));
  return static_cast<int>(std::max(LeastStrata, std::min(wanted, payable)));
}
} // namespace

SampledVolumes SampleVolumes(
  const FacetComplex& surface, Monitor& monitor, const ProgressRange& progress)
{
  const std::vector<CountedEdge> openEdges = OpenEdges(surface);
  const int strata = StrataFor(surface.Facets.size(), openEdges.size());
  Box box = Box::Empty();
  for (const Triangle& facet : surface.Facets)
  {
    for (const Id p : facet)
    {
      box.Add(surface.Points[p]);
    }
  }
  std::array<std::vector<double>, 3> limits;
  double places = Grids;
  double whole = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    limits[axis] = LimitsOfStrata(surface, box, axis, strata);
    places *= strata;
    whole *= box.Extent(axis);
  }
  const FacetComplex closed = WithoutHoles(surface, openEdges);
  const WindingNumbers windingNumbers(surface, closed, monitor);
  std::vector<Volumes> volumes;
  for (int grid = 0; grid < Grids; ++grid)
  {
    RandomNumbers random(static_cast<std::uint64_t>(grid));
    const SampledGrid sampled(windingNumbers, limits, random, monitor,
      { progress.Stage, progress.At(grid / double(Grids)),
        progress.At((grid + 1) / double(Grids)) });
    volumes.push_back(sampled.Measure());
  }
  const double integral = IntegralOfW(closed);
  const double least = PlacesMissed * whole / places;
  const Estimate solid = BetterEstimateOf(volumes, &Volumes::Solid, integral);
  const Estimate most = BetterEstimateOf(volumes, &Volumes::Most, integral);
  const Estimate fewest = BetterEstimateOf(volumes, &Volumes::Least, integral);
  const Estimate overlap = EstimateOf(ByGrids(volumes, &Volumes::Overlap));
  const auto interval = [](double value, double low, double high)
  {
    return VolumeInterval{ std::max(0.0, value), std::max(0.0, std::min(low, value)),
      std::max({ 0.0, high, value }) };
  };
  return { interval(solid.Mean, fewest.Mean - std::max(least, fewest.HalfWidth),
             most.Mean + std::max(least, most.HalfWidth)),
    interval(overlap.Mean, overlap.Mean - overlap.HalfWidth, overlap.Mean + overlap.HalfWidth) };
}
} // namespace insideout

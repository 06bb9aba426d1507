// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/ChooseTurns.h"

#include "Common/Buckets.h"
#include "Common/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <tuple>

namespace insideout
{
namespace
{
/** Limit of shells for which all ways are tried: 4,096 ways, a millisecond for each 100 regions. */
constexpr std::size_t MostTried = 12;

/** Volumes may be equal if their difference is below this fraction of the volume where the ways
 * differ: about three standard deviations with some hundred lines. */
constexpr double SureShare = 0.15;

/** Volumes are equal if their difference is below this fraction of the volume where w differs. It
 * exceeds the gap between faces of two shells that coincide up to rounding to floats. */
constexpr double RoundingShare = 1e-5;

/** Limit of rounds of turning shells one by one; few are ever needed. */
constexpr int MostRounds = 32;

using Turns = std::vector<char>; // per shell of a cluster: 1 if it is turned

/** Volumes of two ways to turn shells, where they differ. */
struct Difference
{
  double Net = 0;    ///< volume of the second less that of the first
  double Gross = 0;  ///< volume that only one of them has
  double Turned = 0; ///< volume where w differs

  void Add(bool first, bool second, double volume)
  {
    this->Net += first == second ? 0 : second ? volume : -volume;
    this->Gross += first == second ? 0 : volume;
    this->Turned += volume;
  }

  /** Whether the volumes differ by more than rounding. */
  bool Matters() const { return std::abs(this->Net) > RoundingShare * this->Turned; }

  /** -1 if the second certainly has less, +1 if more. */
  int Sign() const
  {
    const bool sure = this->Matters() && std::abs(this->Net) > SureShare * this->Gross;
    return sure ? (this->Net > 0) - (this->Net < 0) : 0;
  }
};

/** Shells that share regions, numbered from 0. */
class Cluster
{
public:
  std::vector<Id> Shells;
  std::vector<ShellRegion> Regions; ///< in the cluster's numbers

  /** To be called after both are set. @param[in] facets of all shells */
  void Prepare(const std::vector<Id>& facets)
  {
    for (const Id shell : this->Shells)
    {
      this->Facets.push_back(facets[shell]);
    }
    for (const ShellRegion& region : this->Regions)
    {
      int given = 0;
      for (const ShellWinding& winding : region.Windings)
      {
        given += winding.W;
      }
      this->Given.push_back(std::abs(given));
    }
    this->RegionsOf = { this->Shells.size(),
      [&](auto visit)
      {
        for (std::size_t r = 0; r < this->Regions.size(); ++r)
        {
          for (const ShellWinding& winding : this->Regions[r].Windings)
          {
            visit(static_cast<std::size_t>(winding.Shell), r);
          }
        }
      } };
  }

  int W(std::size_t region, const Turns& turns) const
  {
    int w = 0;
    for (const ShellWinding& winding : this->Regions[region].Windings)
    {
      w += turns[winding.Shell] ? -winding.W : winding.W;
    }
    return w;
  }

  static bool HasNoMeaning(int w) { return w < 0; }
  bool IsNoSolid(std::size_t region, int w) const
  {
    return w < 0 || (w > 1 && w > this->Given[region]);
  }

  /** The law's volumes of two ways, compared over some regions. */
  template <typename SomeRegions>
  std::array<Difference, 2> Compare(
    const Turns& first, const Turns& second, const SomeRegions& regions) const
  {
    std::array<Difference, 2> differences;
    for (const std::size_t r : regions)
    {
      const int a = this->W(r, first);
      const int b = this->W(r, second);
      if (a == b)
      {
        continue;
      }
      const double volume = this->Regions[r].Volume;
      differences[0].Add(HasNoMeaning(a), HasNoMeaning(b), volume);
      differences[1].Add(this->IsNoSolid(r, a), this->IsNoSolid(r, b), volume);
    }
    return differences;
  }

  /** Number of facets turned against the others. */
  Id TurnedFacets(const Turns& turns) const
  {
    std::array<Id, 2> facets{ { 0, 0 } };
    for (std::size_t i = 0; i < turns.size(); ++i)
    {
      facets[turns[i]] += this->Facets[i];
    }
    return std::min(facets[0], facets[1]);
  }

  const Buckets<std::size_t>& RegionsOfShells() const { return this->RegionsOf; }

  std::vector<std::size_t> LargestFirst() const
  {
    std::vector<std::size_t> order(this->Shells.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return this->Facets[a] > this->Facets[b]; });
    return order;
  }

private:
  std::vector<Id> Facets;
  std::vector<int> Given; // |w| per region, with nothing turned
  Buckets<std::size_t> RegionsOf;
};

/** The criterion after the volumes: to be least. */
auto LastResort(const Cluster& cluster, const Turns& turns)
{
  return std::make_tuple(
    cluster.TurnedFacets(turns), std::count(turns.begin(), turns.end(), char(1)));
}

struct Choice
{
  Turns Turned;
  Turns Undecided;
};

/** The ways whose volume by one criterion of the law is not certainly above the least. If ways are
 * uncertain, they and the least are added to the unsure ones. */
template <typename VolumeOf>
void KeepLeast(const Cluster& cluster, std::size_t which, const VolumeOf& volumeOf,
  std::vector<Turns>& ways, std::vector<Turns>& unsure)
{
  std::vector<double> volumes;
  for (const Turns& way : ways)
  {
    volumes.push_back(volumeOf(way));
  }
  const Turns least = ways[std::min_element(volumes.begin(), volumes.end()) - volumes.begin()];
  std::vector<std::size_t> all(cluster.Regions.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  std::vector<Turns> kept;
  for (const Turns& way : ways)
  {
    const Difference difference = cluster.Compare(least, way, all)[which];
    if (difference.Sign() <= 0)
    {
      kept.push_back(way);
      if (difference.Matters())
      {
        unsure.insert(unsure.end(), { least, way });
      }
    }
  }
  ways = std::move(kept);
}

/** All ways to turn the shells of a small cluster. */
Choice TryAll(const Cluster& cluster)
{
  const std::size_t shells = cluster.Shells.size();
  std::vector<Turns> ways(std::size_t(1) << shells, Turns(shells));
  for (std::size_t way = 0; way < ways.size(); ++way)
  {
    for (std::size_t i = 0; i < shells; ++i)
    {
      ways[way][i] = static_cast<char>(way >> i & 1);
    }
  }
  const auto sum = [&](const Turns& way, const auto& counts)
  {
    double volume = 0;
    for (std::size_t r = 0; r < cluster.Regions.size(); ++r)
    {
      volume += counts(r, cluster.W(r, way)) ? cluster.Regions[r].Volume : 0;
    }
    return volume;
  };
  std::vector<Turns> unsure;
  KeepLeast(
    cluster, 0,
    [&](const Turns& way)
    { return sum(way, [](std::size_t, int w) { return Cluster::HasNoMeaning(w); }); },
    ways, unsure);
  KeepLeast(
    cluster, 1,
    [&](const Turns& way)
    { return sum(way, [&](std::size_t r, int w) { return cluster.IsNoSolid(r, w); }); },
    ways, unsure);
  Choice choice = { *std::min_element(ways.begin(), ways.end(),
                      [&](const Turns& a, const Turns& b)
                      { return LastResort(cluster, a) < LastResort(cluster, b); }),
    Turns(shells, 0) };
  for (const Turns& way : unsure)
  {
    for (std::size_t i = 0; i < shells; ++i)
    {
      choice.Undecided[i] |= way[i] != choice.Turned[i];
    }
  }
  return choice;
}

/** -1 if the second way is better by the law, +1 if worse. @param[in] regions all regions that
 * differ
 */
template <typename SomeRegions>
int Compare(
  const Cluster& cluster, const Turns& first, const Turns& second, const SomeRegions& regions)
{
  const std::array<Difference, 2> differences = cluster.Compare(first, second, regions);
  for (const Difference& difference : differences)
  {
    if (difference.Sign() != 0)
    {
      return difference.Sign();
    }
  }
  const auto a = LastResort(cluster, first);
  const auto b = LastResort(cluster, second);
  return (b < a) ? -1 : (a < b);
}

/** Turn shells of a large cluster one by one while this is an improvement; larger shells first. */
Choice Search(const Cluster& cluster)
{
  const std::size_t shells = cluster.Shells.size();
  std::vector<std::size_t> all(cluster.Regions.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  Turns best(shells, 0);
  const Turns over(shells, 1);
  if (Compare(cluster, best, over, all) < 0)
  {
    best = over;
  }
  const auto& regionsOf = cluster.RegionsOfShells();
  bool improved = true;
  for (int round = 0; improved && round < MostRounds; ++round)
  {
    improved = false;
    for (const std::size_t shell : cluster.LargestFirst())
    {
      Turns other = best;
      other[shell] ^= 1;
      if (Compare(cluster, best, other, regionsOf[shell]) < 0)
      {
        best = std::move(other);
        improved = true;
      }
    }
  }
  Choice choice = { best, Turns(shells, 0) };
  for (std::size_t shell = 0; shell < shells; ++shell)
  {
    Turns other = best;
    other[shell] ^= 1;
    const auto differences = cluster.Compare(best, other, regionsOf[shell]);
    choice.Undecided[shell] = std::all_of(differences.begin(), differences.end(),
                                [](const Difference& d) { return d.Sign() == 0; }) &&
      std::any_of(
        differences.begin(), differences.end(), [](const Difference& d) { return d.Matters(); });
  }
  return choice;
}

std::vector<Cluster> ClustersOf(
  const std::vector<ShellRegion>& regions, const std::vector<Id>& facets)
{
  DisjointSets sets(facets.size());
  for (const ShellRegion& region : regions)
  {
    for (const ShellWinding& winding : region.Windings)
    {
      sets.Join(region.Windings.front().Shell, winding.Shell);
    }
  }
  std::vector<Cluster> clusters;
  std::vector<std::size_t> clusterOf(facets.size());
  std::vector<Id> place(facets.size());
  for (Id shell = 0; shell < static_cast<Id>(facets.size()); ++shell)
  {
    const Id first = sets.Find(shell);
    if (first == shell)
    {
      clusterOf[shell] = clusters.size();
      clusters.emplace_back();
    }
    clusterOf[shell] = clusterOf[first];
    std::vector<Id>& members = clusters[clusterOf[shell]].Shells;
    place[shell] = static_cast<Id>(members.size());
    members.push_back(shell);
  }
  for (const ShellRegion& region : regions)
  {
    ShellRegion local = region;
    for (ShellWinding& winding : local.Windings)
    {
      winding.Shell = place[winding.Shell];
    }
    clusters[clusterOf[region.Windings.front().Shell]].Regions.push_back(std::move(local));
  }
  for (Cluster& cluster : clusters)
  {
    cluster.Prepare(facets);
  }
  return clusters;
}
} // namespace

ShellTurns ChooseTurns(const std::vector<ShellRegion>& regions, const std::vector<Id>& facets)
{
  ShellTurns turns = { std::vector<char>(facets.size(), 0), std::vector<char>(facets.size(), 0) };
  for (const Cluster& cluster : ClustersOf(regions, facets))
  {
    const Choice choice = cluster.Shells.size() <= MostTried ? TryAll(cluster) : Search(cluster);
    for (std::size_t i = 0; i < cluster.Shells.size(); ++i)
    {
      turns.Turned[cluster.Shells[i]] = choice.Turned[i];
      turns.Undecided[cluster.Shells[i]] = choice.Undecided[i];
    }
  }
  return turns;
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/LoosePatches.h"

#include "Common/Buckets.h"
#include "Common/DisjointSets.h"

#include <cmath>
#include <cstdint>
#include <queue>
#include <tuple>

namespace insideout
{
namespace
{
/** A gain has to exceed this fraction of a patch's seams; less may be the rounding of their
 * lengths. */
constexpr double LeastGain = 1e-9;

/** The sums at all seams, updated as patches are removed and restored. */
class SeamSums
{
public:
  SeamSums(const SeamedPatches& patches, const std::vector<char>& turned)
    : Given(patches)
    , Turned(turned)
    , Sums(patches.Seams.size(), 0)
    , Gains(patches.Count.size(), 0)
    , Lengths(patches.Count.size(), 0)
    , SeamsOf(patches.Count.size(),
        [&](auto visit)
        {
          for (std::size_t s = 0; s < patches.Seams.size(); ++s)
          {
            for (const PatchAtSeam& at : patches.Seams[s].Patches)
            {
              visit(static_cast<std::size_t>(at.Patch), static_cast<Id>(s));
            }
          }
        })
    , Loose(patches.Count.size(), 0)
  {
    for (std::size_t s = 0; s < patches.Seams.size(); ++s)
    {
      for (const PatchAtSeam& at : patches.Seams[s].Patches)
      {
        this->Sums[s] += this->RunOf(at);
        this->Lengths[at.Patch] += patches.Seams[s].Length * std::abs(this->RunOf(at));
      }
      this->AddGains(s, 1);
    }
  }

  bool AllBalance() const
  {
    return std::all_of(this->Sums.begin(), this->Sums.end(), [](auto sum) { return sum == 0; });
  }

  double Gain(Id patch) const { return this->Gains[patch]; }

  bool IsWorthTaking(Id patch) const
  {
    return !this->Loose[patch] && this->Gains[patch] > LeastGain * this->Lengths[patch];
  }

  /** Remove or restore a patch. @return its seams */
  Buckets<Id>::Range Switch(Id patch)
  {
    this->Loose[patch] ^= 1;
    for (const Id s : this->SeamsOf[patch])
    {
      this->AddGains(s, -1);
      for (const PatchAtSeam& at : this->Given.Seams[s].Patches)
      {
        if (at.Patch == patch)
        {
          this->Sums[s] += this->Loose[patch] ? -this->RunOf(at) : this->RunOf(at);
        }
      }
      this->AddGains(s, 1);
    }
    return this->SeamsOf[patch];
  }

  /** Restore the patches at whose seams other patches do not balance. */
  void PutBack()
  {
    std::vector<Id> seams;
    for (Id s = 0; s < static_cast<Id>(this->Sums.size()); ++s)
    {
      seams.push_back(s);
    }
    while (!seams.empty())
    {
      const Id s = seams.back();
      seams.pop_back();
      for (const PatchAtSeam& at : this->Given.Seams[s].Patches)
      {
        if (this->Sums[s] != 0 && this->Loose[at.Patch] && this->RunOf(at) != 0)
        {
          for (const Id other : this->Switch(at.Patch))
          {
            seams.push_back(other);
          }
        }
      }
    }
  }

  const std::vector<char>& LoosePatches() const { return this->Loose; }

private:
  std::int64_t RunOf(const PatchAtSeam& at) const
  {
    const std::int64_t run = this->Given.RunOf(at);
    return this->Turned[at.Patch] ? -run : run;
  }

  void AddGains(Id seam, int sign)
  {
    const std::int64_t sum = this->Sums[seam];
    for (const PatchAtSeam& at : this->Given.Seams[seam].Patches)
    {
      if (!this->Loose[at.Patch])
      {
        this->Gains[at.Patch] += sign * this->Given.Seams[seam].Length *
          static_cast<double>(std::abs(sum) - std::abs(sum - this->RunOf(at)));
      }
    }
  }

  const SeamedPatches& Given;
  const std::vector<char>& Turned;
  std::vector<std::int64_t> Sums; // per seam
  std::vector<double> Gains;      // per patch, gain of removing it
  std::vector<double> Lengths;    // per patch, length of its seams
  Buckets<Id> SeamsOf;
  std::vector<char> Loose;
};

/**
 * Each patch's contribution to the volume of the patches that seams connect it with, taken
 * positive.
 */
std::vector<double> SharesOfVolume(const SeamedPatches& patches, const std::vector<double>& volumes)
{
  DisjointSets connected(volumes.size());
  for (const PatchSeam& seam : patches.Seams)
  {
    for (const PatchAtSeam& at : seam.Patches)
    {
      connected.Join(seam.Patches.front().Patch, at.Patch);
    }
  }
  std::vector<double> sums(volumes.size(), 0);
  for (std::size_t p = 0; p < volumes.size(); ++p)
  {
    sums[connected.Find(static_cast<Id>(p))] += volumes[p];
  }
  std::vector<double> shares(volumes.size());
  for (std::size_t p = 0; p < volumes.size(); ++p)
  {
    shares[p] = sums[connected.Find(static_cast<Id>(p))] < 0 ? -volumes[p] : volumes[p];
  }
  return shares;
}
} // namespace

bool AllSeamsBalance(const SeamedPatches& patches, const std::vector<char>& turned)
{
  return patches.Seams.empty() || SeamSums(patches, turned).AllBalance();
}

std::vector<char> FindLoosePatches(
  const SeamedPatches& patches, const std::vector<char>& turned, const std::vector<double>& volumes)
{
  SeamSums sums(patches, turned);
  const std::vector<double> shares = SharesOfVolume(patches, volumes);
  using Candidate = std::tuple<double, double, Id>; // volume left, gain, patch
  std::priority_queue<Candidate> queue;
  const auto consider = [&](Id patch)
  {
    if (sums.IsWorthTaking(patch))
    {
      queue.push({ -shares[patch], sums.Gain(patch), patch });
    }
  };
  for (Id p = 0; p < static_cast<Id>(volumes.size()); ++p)
  {
    consider(p);
  }
  while (!queue.empty())
  {
    const auto [left, gain, patch] = queue.top();
    queue.pop();
    if (!sums.IsWorthTaking(patch) || sums.Gain(patch) != gain)
    {
      continue; // it has changed, and is in the queue again
    }
    for (const Id s : sums.Switch(patch))
    {
      for (const PatchAtSeam& at : patches.Seams[s].Patches)
      {
        consider(at.Patch);
      }
    }
  }
  sums.PutBack();
  return sums.LoosePatches();
}
} // namespace insideout

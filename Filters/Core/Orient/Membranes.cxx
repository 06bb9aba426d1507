// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/Membranes.h"

#include "Common/Box.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace insideout
{
namespace
{
/** Limits of sample points on a shell; fewer if there are many shells. */
constexpr Id LeastPlaces = 4;
constexpr Id MostPlaces = 128;
constexpr Id PlacesOfAll = 1 << 10;

/** Lines through each sample point, doubled until the means are certain; fewer if there are many
 * points. */
constexpr int FirstLines = 2;
constexpr int MostLines = 64;
constexpr Id LinesOfAll = 1 << 13;

/** A mean is certain if it differs from a limit by this number of standard errors. */
constexpr double SureErrors = 2;

/** Distance, relative to the surface's size, at which both sides of a point are tested for the
 * solid. It exceeds the gap between a sheet and the solid's surface that it lies on. */
constexpr double Beside = 0x1p-24;

/** The largest fraction of its area that a shell within the solid may have outside. */
constexpr double OutsideByChance = 0.2;

/** A shell that seals off no space is a sheet if a larger fraction of its area is outside, else a
 * membrane. */
constexpr double MostOutside = 0.5;

/** A shell lies within shells with holes if their mean winding number along it exceeds this. On
 * their caps, where a lid lies, it is 1/2. */
constexpr double MostInside = 0.6;

/** A shell with a lower seal does not count. Two squares that face each other at four tenths of
 * their size have 0.19, a shallow shell with an open back (mujoco's palm.obj) 0.22. */
constexpr double LeastSeal = 0.2;

struct Place
{
  Point At;
  Point Normal; ///< of length 1, or 0 if the triangle has no area in doubles
};

std::vector<Place> PlacesOn(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, Id count, RandomNumbers& random)
{
  std::vector<Place> places;
  std::vector<double> areaUpTo;
  double areaOfAll = 0;
  for (const CountedTriangle& triangle : triangles)
  {
    const std::array<Point, 3> t = CornersOf(points, triangle.Corners);
    areaOfAll += Length(NormalOf(t[0], t[1], t[2])) / 2;
    areaUpTo.push_back(areaOfAll);
  }
  for (Id i = 0; i < count && !triangles.empty(); ++i)
  {
    const double area = areaOfAll * (static_cast<double>(i) + random.Next()) / count;
    const auto found = std::lower_bound(areaUpTo.begin(), areaUpTo.end() - 1, area);
    const auto& [a, b, c] = CornersOf(points, triangles[found - areaUpTo.begin()].Corners);
    const double root = std::sqrt(random.Next());
    const double share = random.Next();
    const Point normal = NormalOf(a, b, c);
    const double length = Length(normal);
    Place place;
    for (int axis = 0; axis < 3; ++axis)
    {
      place.At[axis] = (1 - root) * a[axis] + root * ((1 - share) * b[axis] + share * c[axis]);
      place.Normal[axis] = length > 0 ? normal[axis] / length : 0;
    }
    places.push_back(place);
  }
  return places;
}

/**
 * A shell that is not entirely within closed shells, with sums over the lines through its sample
 * points.
 */
struct OutsideShell
{
  Id Shell;
  std::vector<Place> Places; ///< number of sample points outside
  bool IsMostlyOutside;
  RandomNumbers Random;
  Id Lines = 0;                   ///< lines drawn through all sample points
  double Rest = 0;                ///< sums of the winding numbers of shells with holes
  std::map<Id, double> Seal = {}; ///< likewise per outside shell, by its index among these
  double Squares = 0;             ///< of the winding number of all

  /** Whether the means differ from the limits by more than their errors. @param[in] seal of the
   * shell, judged without shells that do not count
   */
  bool IsSure(double seal) const
  {
    const double lines = static_cast<double>(this->Lines);
    double mean = this->Rest / lines;
    for (const auto& [other, w] : this->Seal)
    {
      mean += w / lines;
    }
    const double variance = std::max(0.0, this->Squares / lines - mean * mean);
    const double error = SureErrors * std::sqrt(variance / lines);
    return std::abs(seal - LeastSeal) >= error &&
      std::abs(this->Rest / lines - MostInside) >= error;
  }
};

/** The role of an outside shell, and the seal that decided it. */
struct Judgement
{
  ShellRole Role;
  double Seal;
};

class MembraneFinder
{
public:
  MembraneFinder(const std::vector<Point>& points, const std::vector<ShellChain>& chains,
    const std::vector<char>& turned, const RegionSampler& sampler, Monitor& monitor)
    : Points(points)
    , Chains(chains)
    , Turned(turned)
    , Sampler(sampler)
    , Work(monitor)
  {
  }

  std::vector<ShellRole> Find()
  {
    std::vector<ShellRole> roles(this->Chains.size(), ShellRole::Counts);
    std::vector<Id> candidates;
    for (Id shell = 0; shell < static_cast<Id>(this->Chains.size()); ++shell)
    {
      if (this->Chains[shell].Kind == ShellKind::Sheet || this->Chains[shell].IsLoose)
      {
        candidates.push_back(shell);
      }
    }
    if (candidates.empty() || !this->FindSolids())
    {
      return roles;
    }
    const Id count = static_cast<Id>(candidates.size());
    const Id places = std::clamp(PlacesOfAll / count, LeastPlaces, MostPlaces);
    std::vector<OutsideShell> outside;
    for (const Id shell : candidates)
    {
      this->Work.Check(Stages::Orienting, 1);
      RandomNumbers random(static_cast<std::uint64_t>(shell));
      std::vector<Place> found = PlacesOn(this->Points, this->Chains[shell].Facets, places, random);
      found.erase(
        std::remove_if(found.begin(), found.end(),
          [&](const Place& place) { return this->IsInSolid(place, ShellKind::Closed, random); }),
        found.end());
      const double share = static_cast<double>(found.size()) / static_cast<double>(places);
      roles[shell] = ShellRole::Membrane;
      if (share > OutsideByChance)
      {
        outside.push_back({ shell, std::move(found), share > MostOutside, random });
      }
    }
    const std::vector<Judgement> judged = this->Judge(outside);
    for (std::size_t i = 0; i < outside.size(); ++i)
    {
      roles[outside[i].Shell] = judged[i].Role;
    }
    return roles;
  }

private:
  /** Whether a shell bounds the solid of shells up to a kind: Closed, or Holed for both. */
  bool Bounds(Id shell, ShellKind kind) const
  {
    return this->Chains[shell].Kind <= kind && !this->Chains[shell].IsLoose;
  }

  /** Find the boxes around the solids. @return false if no shell bounds a solid */
  bool FindSolids()
  {
    bool isThere = false;
    for (Id shell = 0; shell < static_cast<Id>(this->Chains.size()); ++shell)
    {
      if (!this->Bounds(shell, ShellKind::Holed))
      {
        continue;
      }
      isThere = true;
      for (const CountedTriangle& triangle : this->Chains[shell].Triangles)
      {
        for (const Id p : triangle.Corners)
        {
          this->WithHoled.Add(this->Points[p]);
          if (this->Bounds(shell, ShellKind::Closed))
          {
            this->OfClosed.Add(this->Points[p]);
          }
        }
      }
    }
    return isThere;
  }

  /** Whether either side of a point is in the solid of shells up to a kind, holes capped. */
  bool IsInSolid(const Place& place, ShellKind kind, RandomNumbers& random) const
  {
    for (const double side : { -Beside, Beside })
    {
      Point beside;
      for (int axis = 0; axis < 3; ++axis)
      {
        beside[axis] = place.At[axis] + side * place.Normal[axis];
      }
      if (!(kind == ShellKind::Closed ? this->OfClosed : this->WithHoled).Holds(beside))
      {
        continue;
      }
      int w = 0;
      for (const ShellWinding& winding : this->Sampler.At(beside, random))
      {
        const int turn = this->Turned[winding.Shell] ? -1 : 1;
        w += this->Bounds(winding.Shell, kind) ? turn * winding.W : 0;
      }
      if (w > 0)
      {
        return true;
      }
    }
    return false;
  }

  /** A chain that a line may cross: facets, or caps of an outside shell. */
  struct OpenChain
  {
    Id Shell;
    Id Outside; ///< its index among the outside shells, None for one with holes
    bool IsCap;
  };

  /** The chains that lines may cross: facets and caps of outside shells, facets of shells with
   * holes. */
  std::vector<OpenChain> OpenChains(const std::vector<OutsideShell>& outside) const
  {
    std::vector<OpenChain> open;
    for (Id i = 0; i < static_cast<Id>(outside.size()); ++i)
    {
      open.push_back({ outside[i].Shell, i, false });
      if (!this->Chains[outside[i].Shell].Caps.empty())
      {
        open.push_back({ outside[i].Shell, i, true });
      }
    }
    for (Id shell = 0; shell < static_cast<Id>(this->Chains.size()); ++shell)
    {
      if (this->Bounds(shell, ShellKind::Holed) && !this->Bounds(shell, ShellKind::Closed))
      {
        open.push_back({ shell, None, false });
      }
    }
    return open;
  }

  /** Find the roles of outside shells. */
  std::vector<Judgement> Judge(std::vector<OutsideShell>& outside) const
  {
    if (outside.empty())
    {
      return {};
    }
    const std::vector<OpenChain> open = this->OpenChains(outside);
    std::vector<ShellChain> chains;
    for (const OpenChain& part : open)
    {
      const ShellChain& shell = this->Chains[part.Shell];
      ShellChain chain;
      chain.Kind = ShellKind::Holed;
      chain.Triangles = part.IsCap ? shell.Caps : shell.Facets;
      chains.push_back(std::move(chain));
    }
    const RegionSampler sampler(this->Points, chains);
    Id places = 0;
    for (const OutsideShell& shell : outside)
    {
      places += static_cast<Id>(shell.Places.size());
    }
    const int lines = static_cast<int>(std::clamp<Id>(LinesOfAll / (4 * places), 1, FirstLines));
    Id drawn = lines * places;
    for (OutsideShell& shell : outside)
    {
      this->AddLines(sampler, open, lines, shell);
    }
    std::vector<Judgement> judged = JudgeByMeans(outside);
    for (int more = lines; 2 * more <= MostLines; more *= 2)
    {
      std::vector<OutsideShell*> unsure;
      for (std::size_t i = 0; i < outside.size(); ++i)
      {
        if (!outside[i].IsSure(judged[i].Seal))
        {
          unsure.push_back(&outside[i]);
          drawn += more * static_cast<Id>(outside[i].Places.size());
        }
      }
      if (unsure.empty() || drawn > LinesOfAll)
      {
        break;
      }
      for (OutsideShell* shell : unsure)
      {
        this->AddLines(sampler, open, more, *shell);
      }
      judged = JudgeByMeans(outside);
    }
    return judged;
  }

  /** Add the winding numbers along more lines through each place of an outside shell. */
  void AddLines(const RegionSampler& sampler, const std::vector<OpenChain>& open, int lines,
    OutsideShell& shell) const
  {
    this->Work.Check(Stages::Orienting, 1);
    for (const Place& place : shell.Places)
    {
      for (int i = 0; i < lines; ++i)
      {
        const CrossedLine line = sampler.Through(place.At, shell.Random);
        double ofLine = 0;
        for (const auto& [at, error, chain, rise] : line.Crossings)
        {
          const OpenChain& crossed = open[chain];
          if (std::abs(at) <= std::max(Beside, error) ||
            (crossed.IsCap &&
              !this->IsInSolid(
                { PointOn(place, line, at), line.Direction }, ShellKind::Holed, shell.Random)))
          {
            continue;
          }
          // A capped shell is its facets less its caps.
          const bool isReversed = (at > 0) != crossed.IsCap;
          const bool isTurned = this->Turned[crossed.Shell] != 0;
          const double w = (isReversed != isTurned ? -0.5 : 0.5) * rise;
          (crossed.Outside == None ? shell.Rest : shell.Seal[crossed.Outside]) += w;
          ofLine += w;
        }
        shell.Squares += ofLine * ofLine;
      }
    }
    shell.Lines += lines * static_cast<Id>(shell.Places.size());
  }

  static Point PointOn(const Place& place, const CrossedLine& line, double at)
  {
    Point point;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = place.At[axis] + at * line.Direction[axis];
    }
    return point;
  }

  /** Remove shells within shells with holes, then those with a low seal, the lowest first. */
  static std::vector<Judgement> JudgeByMeans(const std::vector<OutsideShell>& outside)
  {
    std::vector<Judgement> judged;
    for (const OutsideShell& shell : outside)
    {
      const double seal = shell.Rest / static_cast<double>(shell.Lines);
      judged.push_back({ seal > MostInside ? ShellRole::Membrane : ShellRole::Counts, seal });
    }
    std::vector<std::vector<std::pair<Id, double>>> sealed(
      outside.size());                    // the other shells, per shell
    std::set<std::pair<double, Id>> left; // the lowest first
    for (Id shell = 0; shell < static_cast<Id>(outside.size()); ++shell)
    {
      if (judged[shell].Role != ShellRole::Counts)
      {
        continue;
      }
      for (const auto& [other, sum] : outside[shell].Seal)
      {
        if (judged[other].Role == ShellRole::Counts)
        {
          const double w = sum / static_cast<double>(outside[shell].Lines);
          judged[shell].Seal += w;
          sealed[other].push_back({ shell, w });
        }
      }
      left.insert({ judged[shell].Seal, shell });
    }
    while (!left.empty() && left.begin()->first < LeastSeal)
    {
      const Id gone = left.begin()->second;
      left.erase(left.begin());
      judged[gone].Role = outside[gone].IsMostlyOutside ? ShellRole::Sheet : ShellRole::Membrane;
      for (const auto& [shell, w] : sealed[gone])
      {
        if (left.erase({ judged[shell].Seal, shell }) > 0)
        {
          judged[shell].Seal -= w;
          left.insert({ judged[shell].Seal, shell });
        }
      }
    }
    return judged;
  }

  const std::vector<Point>& Points;
  const std::vector<ShellChain>& Chains;
  const std::vector<char>& Turned;
  const RegionSampler& Sampler;
  Monitor& Work;
  Box OfClosed = Box::Empty();  ///< around closed shells
  Box WithHoled = Box::Empty(); ///< around closed shells and those with holes
};
} // namespace

std::vector<ShellRole> FindMembranes(const std::vector<Point>& points,
  const std::vector<ShellChain>& chains, const std::vector<char>& turned,
  const RegionSampler& sampler, Monitor& monitor)
{
  return MembraneFinder(points, chains, turned, sampler, monitor).Find();
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/OrientFacets.h"

#include "Common/ScaledPoints.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Orient/ChooseTurns.h"
#include "Orient/Membranes.h"

#include <algorithm>
#include <cstdio>

namespace insideout
{
namespace
{
/** Numbers of lines through a shell, fewer if there are many shells: all take some hundredths of a
 * second. */
constexpr Id LeastLines = 16;
constexpr Id MostLines = 128;
constexpr Id LinesOfAll = 1 << 11;

/** How often the number of lines may double before the choice is stable. */
constexpr int MostDoublings = 3;

Id FirstLines(const std::vector<ShellChain>& chains)
{
  const Id shells = std::max<Id>(1, static_cast<Id>(chains.size()));
  return std::clamp(LinesOfAll / shells, LeastLines, MostLines);
}

/** The shells to turn by the law of ChooseTurns.h. */
ShellTurns ChooseAutomatically(
  const std::vector<ShellChain>& chains, const RegionSampler& sampler, Monitor& monitor)
{
  std::vector<Id> facets;
  for (const ShellChain& chain : chains)
  {
    facets.push_back(static_cast<Id>(chain.Facets.size()));
  }
  Id lines = FirstLines(chains);
  ShellTurns chosen;
  for (int doublings = 0; doublings <= MostDoublings; ++doublings, lines *= 2)
  {
    const double end = 1 - std::ldexp(0.5, -doublings);
    ShellTurns next =
      ChooseTurns(sampler.Sample(lines, monitor, { Stages::Orienting, 2 * end - 1, end }), facets);
    const bool same = next.Turned == chosen.Turned && next.Undecided == chosen.Undecided;
    chosen = std::move(next);
    if (same)
    {
      break;
    }
  }
  return chosen;
}

ShellTurns ChooseAsTold(const std::vector<ShellChain>& chains, Orientation orientation)
{
  ShellTurns chosen;
  for (const ShellChain& chain : chains)
  {
    const bool facesInward = chain.Kind != ShellKind::Sheet && chain.Volume < 0;
    const bool outward = orientation == Orientation::Outward;
    chosen.Turned.push_back(outward ? facesInward : orientation == Orientation::Reverse);
  }
  chosen.Undecided.assign(chains.size(), 0);
  return chosen;
}

/** A volume of this fraction of the area, for a surface of size 1, has the right sign: it is a sum
 * of one term per facet, each with an error of some 2^-50 of the facet's area. */
constexpr double SureVolume = 1e-8;

/**
 * Whether the surface is one closed shell with one region inside. Without crossings the winding
 * number is constant just before all facets of a patch, and just behind them. So with one patch, of
 * facets with count 1, there is a single winding number beside 0 outside.
 */
bool IsPlain(const Shells& shells, const std::vector<ShellChain>& chains)
{
  return shells.Patches == 1 && chains.size() == 1 && chains[0].Kind == ShellKind::Closed &&
    std::abs(chains[0].Triangles.front().Count) == 1 &&
    std::abs(chains[0].Volume) > SureVolume * chains[0].Area;
}

/** Turn a simple shell outward: then w is 1 within, and regions need not be sampled. */
ShellTurns TurnOutward(const ShellChain& plain)
{
  ShellTurns chosen;
  chosen.Turned.push_back(plain.Volume < 0);
  chosen.Undecided.push_back(0);
  return chosen;
}

/** The fraction of the surface's area that is marked. */
double ShareOf(const std::vector<char>& marks, const std::vector<Point>& points,
  const std::vector<Triangle>& facets)
{
  if (std::find(marks.begin(), marks.end(), 1) == marks.end())
  {
    return 0;
  }
  std::array<double, 2> areas{ { 0, 0 } };
  for (std::size_t f = 0; f < marks.size(); ++f)
  {
    const std::array<Point, 3> corners = CornersOf(points, facets[f]);
    const Point normal = NormalOf(corners[0], corners[1], corners[2]);
    areas[marks[f] != 0] += std::sqrt(Dot(normal, normal));
  }
  return areas[1] > 0 ? areas[1] / (areas[0] + areas[1]) : 0;
}

/** The facets turned over, and the final count of each: the sum of its copies. */
void TurnCopies(const FacetComplex& surface, const Shells& shells,
  const std::vector<ShellChain>& chains, const std::vector<char>& shellTurned,
  const std::vector<ShellRole>& roles, Orientation orientation, FacetTurns& turns)
{
  const bool makeAgree =
    orientation == Orientation::Automatic || orientation == Orientation::Outward;
  const std::size_t facets = surface.Facets.size();
  turns.Turned.assign(facets, orientation == Orientation::Reverse);
  turns.IsSheet.assign(facets, 1);
  turns.IsMembrane.assign(facets, 0);
  turns.Multiplicity.assign(facets, 0);
  const auto add = [&](Id f, Id shell, int multiplicity, bool disagrees)
  {
    const bool turned = (makeAgree && disagrees) != (shellTurned[shell] != 0);
    const bool counts = roles[shell] == ShellRole::Counts;
    turns.IsSheet[f] &= chains[shell].Kind == ShellKind::Sheet || !counts;
    turns.IsMembrane[f] |= roles[shell] == ShellRole::Membrane;
    if (counts)
    {
      const int count = turned ? -multiplicity : multiplicity;
      turns.Multiplicity[f] = static_cast<std::int16_t>(turns.Multiplicity[f] + count);
    }
    return turned;
  };
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (shells.Shell[f] != None)
    {
      turns.Turned[f] = add(f, shells.Shell[f], shells.Multiplicity[f], shells.Turned[f] != 0);
    }
  }
  for (const ShellCopy& copy : shells.MoreCopies)
  {
    add(copy.Facet, copy.Shell, copy.Multiplicity, copy.Turned != 0);
  }
}

/** Mark the facets with an edge at which the counted facets do not sum to 0. */
std::vector<char> BesideOpenEdges(const FacetComplex& surface, const FacetEdges& edges)
{
  std::vector<char> marks(surface.Facets.size(), 0);
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      int sum = 0;
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        sum += edge->Direction * surface.Multiplicity[edge->Facet];
      }
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        marks[edge->Facet] |= sum != 0;
      }
    });
  return marks;
}

/** Count repeated facets whose copies do not count, cancel or face both ways, next to facets that
 * disagree; if none disagree, those next to open edges that face one way more often. */
Id CountDoubtfulCopies(const FacetComplex& surface, const FacetEdges& edges, Id disagreeingFacets)
{
  if (surface.Sources.size() == surface.Facets.size())
  {
    return 0;
  }
  const std::vector<char> isOpen = BesideOpenEdges(surface, edges);
  Id doubtful = 0;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const auto first = surface.Sources.begin() + surface.SourceOffsets[f];
    const auto last = surface.Sources.begin() + surface.SourceOffsets[f + 1];
    const auto copies = last - first;
    const auto against =
      std::count_if(first, last, [](const FacetSource& source) { return source.Reversed; });
    const bool facesBothWays = 0 < against && against < copies;
    const int opposed = surface.Opposed.empty() ? 0 : surface.Opposed[f];
    const bool isLeftOut = std::abs(surface.Multiplicity[f]) + 2 * opposed < copies;
    doubtful += disagreeingFacets > 0 ? copies > 1 && (isLeftOut || facesBothWays)
                                      : isOpen[f] && facesBothWays && 2 * against != copies;
  }
  return doubtful;
}

/** Find shells, and choose which facets to turn. */
FacetTurns ChooseFacets(const FacetComplex& surface, const FacetEdges& edges,
  Orientation orientation, Monitor& monitor, Crossings crossings)
{
  const Shells shells = FindShells(surface, edges);
  const int exponent = LargestExponent(surface.Points);
  const std::vector<Point> points = ScaledPoints(surface.Points, -exponent);
  const std::vector<ShellChain> chains = CloseShells(surface, edges, shells, points);
  const bool automatic = orientation == Orientation::Automatic;
  ShellTurns chosen;
  std::vector<ShellRole> roles(chains.size(), ShellRole::Counts);
  if ((automatic || orientation == Orientation::Outward) && crossings == Crossings::Absent &&
    IsPlain(shells, chains))
  {
    chosen = TurnOutward(chains.front());
  }
  else
  {
    const RegionSampler sampler(points, chains);
    chosen =
      automatic ? ChooseAutomatically(chains, sampler, monitor) : ChooseAsTold(chains, orientation);
    roles = FindMembranes(points, chains, chosen.Turned, sampler, monitor);
    for (std::size_t shell = 0; shell < chains.size(); ++shell)
    {
      const bool counts = roles[shell] == ShellRole::Counts;
      chosen.Turned[shell] &= counts || orientation == Orientation::Reverse;
      chosen.Undecided[shell] &= counts;
    }
  }
  const auto countOf = [](const std::vector<char>& marks)
  { return static_cast<Id>(std::count(marks.begin(), marks.end(), char(1))); };

  FacetTurns turns;
  turns.Shells = shells.Count;
  turns.Membranes = static_cast<Id>(std::count(roles.begin(), roles.end(), ShellRole::Membrane));
  turns.TurnedShells = countOf(chosen.Turned);
  turns.UndecidedShells = countOf(chosen.Undecided);
  turns.DisagreeingFacets = countOf(shells.Turned);
  turns.DoubtfulCopies = CountDoubtfulCopies(surface, edges, turns.DisagreeingFacets);
  turns.Kinds = CountShells(chains, chosen.Turned, roles);
  turns.Shell = shells.Shell;
  for (std::size_t shell = 0; shell < chains.size(); ++shell)
  {
    turns.ShellHasHoles.push_back(chains[shell].Kind == ShellKind::Holed);
    const double volume = std::ldexp(chains[shell].Volume, 3 * exponent);
    turns.ShellVolumes.push_back(
      chains[shell].Kind == ShellKind::Sheet || roles[shell] != ShellRole::Counts ? 0
        : chosen.Turned[shell]                                                    ? -volume
                                                                                  : volume);
  }
  TurnCopies(surface, shells, chains, chosen.Turned, roles, orientation, turns);
  turns.TurnedFacets = countOf(turns.Turned);
  turns.MembraneFacets = countOf(turns.IsMembrane);
  turns.UncountedSheets = static_cast<Id>(std::count(roles.begin(), roles.end(), ShellRole::Sheet));
  turns.TurnedShare = ShareOf(turns.Turned, points, surface.Facets);
  turns.SheetShare = ShareOf(turns.IsSheet, points, surface.Facets);
  turns.MembraneShare = ShareOf(turns.IsMembrane, points, surface.Facets);
  return turns;
}

std::string AsPercentage(double share)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2g %%", 100 * share);
  return text;
}

std::vector<std::string> WarningsAbout(const FacetTurns& turns)
{
  std::vector<std::string> warnings;
  const std::string share = std::to_string(turns.TurnedFacets) + " facets, " +
    AsPercentage(turns.TurnedShare) + " of the area";
  if (turns.TurnedShells > 0 && turns.TurnedShells == turns.Shells)
  {
    warnings.push_back("the surface is inside out as a whole: it is turned over");
  }
  else if (turns.TurnedShells > 0)
  {
    warnings.push_back(std::to_string(turns.TurnedShells) + " of " + std::to_string(turns.Shells) +
      " shells are inside out and are turned over (" + share + ")");
  }
  if (turns.DisagreeingFacets > 0)
  {
    warnings.push_back(std::to_string(turns.DisagreeingFacets) +
      " facets face the other way than those around them and are turned over" +
      (turns.TurnedShells > 0 ? std::string() : " (" + share + ")"));
  }
  if (turns.UndecidedShells > 0)
  {
    warnings.push_back(std::to_string(turns.UndecidedShells) +
      " shells could equally face the other way: Orientation says what to do with them");
  }
  if (turns.DoubtfulCopies > 0)
  {
    warnings.push_back(std::to_string(turns.DoubtfulCopies) +
      (turns.DoubtfulCopies == 1 ? " facet" : " facets") +
      " given again may count too little, because facets disagree or leave edges open: if closed "
      "surfaces share facets, give each surface as a body");
  }
  return warnings;
}

std::vector<std::string> WarningsOfUncounted(const FacetTurns& turns)
{
  std::vector<std::string> warnings;
  const auto warn = [&](Id count, const std::string& word, const std::string& more)
  {
    if (count > 0)
    {
      warnings.push_back(std::to_string(count) + " " + word + (count == 1 ? "" : "s") + more +
        (count == 1 ? ", shapes the mesh and does not count"
                    : ", shape the mesh and do not count"));
    }
  };
  warn(turns.Membranes, "membrane",
    " (" + std::to_string(turns.MembraneFacets) + " facets, " + AsPercentage(turns.MembraneShare) +
      " of the area), within the solid or across it");
  warn(turns.UncountedSheets, "sheet", " outside the solid, sealing off no space");
  return warnings;
}
} // namespace

FacetTurns FindFacetTurns(const FacetComplex& surface, const FacetEdges& edges,
  Orientation orientation, Monitor& monitor, Crossings crossings)
{
  monitor.Check(Stages::Orienting, 0);
  FacetTurns turns = ChooseFacets(surface, edges, orientation, monitor, crossings);
  if (orientation == Orientation::Automatic)
  {
    turns.Warnings = WarningsAbout(turns);
  }
  turns.UncountedWarnings = WarningsOfUncounted(turns);
  monitor.Check(Stages::Orienting, 1);
  return turns;
}

FacetTurns OrientFacets(FacetComplex& surface, const FacetEdges& edges, Orientation orientation,
  Monitor& monitor, Crossings crossings)
{
  FacetTurns turns = FindFacetTurns(surface, edges, orientation, monitor, crossings);
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (turns.Turned[f])
    {
      for (Id s = surface.SourceOffsets[f]; s < surface.SourceOffsets[f + 1]; ++s)
      {
        surface.Sources[s].Reversed = !surface.Sources[s].Reversed;
      }
    }
  }
  surface.Multiplicity = turns.Multiplicity;
  return turns;
}

std::vector<Id> TrianglesOfFacets(const FacetComplex& surface, const std::vector<char>& marks)
{
  std::vector<Id> triangles;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    for (Id s = surface.SourceOffsets[f]; marks[f] && s < surface.SourceOffsets[f + 1]; ++s)
    {
      triangles.push_back(surface.Sources[s].Triangle);
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

void AddTurns(const FacetTurns& turns, Statistics& statistics)
{
  statistics.emplace_back("Shells", turns.Shells);
  statistics.emplace_back("ClosedShells", turns.Kinds.Closed);
  statistics.emplace_back("HoledShells", turns.Kinds.Holed);
  statistics.emplace_back("SheetShells", turns.Kinds.Sheets);
  statistics.emplace_back("SheetShare", turns.SheetShare);
  statistics.emplace_back("Membranes", turns.Membranes);
  statistics.emplace_back("MembraneFacets", turns.MembraneFacets);
  statistics.emplace_back("MembraneShare", turns.MembraneShare);
  statistics.emplace_back("UncountedSheets", turns.UncountedSheets);
  statistics.emplace_back("Cavities", turns.Kinds.Cavities);
  statistics.emplace_back("TurnedShells", turns.TurnedShells);
  statistics.emplace_back("TurnedFacets", turns.TurnedFacets);
  statistics.emplace_back("TurnedShare", turns.TurnedShare);
  statistics.emplace_back("DisagreeingFacets", turns.DisagreeingFacets);
  statistics.emplace_back("UndecidedShells", turns.UndecidedShells);
  statistics.emplace_back("DoubtfulCopies", turns.DoubtfulCopies);
}
} // namespace insideout

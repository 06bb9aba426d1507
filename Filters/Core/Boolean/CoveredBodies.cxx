// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/CoveredBodies.h"

#include "Output/MassProperties.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <set>

namespace insideout
{
namespace
{
/** Limit of the bodies named in one message. */
constexpr std::size_t MostNamed = 10;

using Labels = std::vector<unsigned char>;

/** The owner of each cell of a body: None outside, the body itself if it keeps the cell. */
std::vector<Id> OwnersOfCells(Id body, const Labels& inside, const BodyRegions& regions)
{
  std::vector<Id> owners(inside.size(), None);
  for (std::size_t cell = 0; cell < inside.size(); ++cell)
  {
    if (inside[cell] != 0)
    {
      const std::vector<Id>& of = regions.Bodies[regions.Regions.OfCell[cell]];
      owners[cell] = std::find(of.begin(), of.end(), body) != of.end() ? body : of.front();
    }
  }
  return owners;
}

/** The parts of a body, those that keep no cell, and their owners. */
struct CoveredParts
{
  Id All = 0;
  Id Covered = 0;
  std::set<Id> By;
};

CoveredParts FindCoveredParts(Id body, const std::vector<Id>& owners, const SolidRegions& parts)
{
  CoveredParts found;
  found.All = parts.Count;
  std::vector<char> keepsCell(parts.Count, 0);
  for (std::size_t cell = 0; cell < owners.size(); ++cell)
  {
    if (owners[cell] == body)
    {
      keepsCell[parts.OfCell[cell]] = 1;
    }
  }
  found.Covered = static_cast<Id>(std::count(keepsCell.begin(), keepsCell.end(), 0));
  for (std::size_t cell = 0; cell < owners.size(); ++cell)
  {
    if (owners[cell] != None && !keepsCell[parts.OfCell[cell]])
    {
      found.By.insert(owners[cell]);
    }
  }
  return found;
}

class Words
{
public:
  Words(const BodyOrder& order, const std::vector<std::string>& names)
    : Order(order)
    , Names(names)
    , Place(names.size())
  {
    for (std::size_t i = 0; i < order.Given.size(); ++i)
    {
      this->Place[order.Given[i]] = i;
    }
  }

  /** Whether a body has cells of the other merely because of the given order. */
  bool ComesFirst(Id body, Id other) const
  {
    const std::vector<Id>& within = this->Order.Within[other];
    return !this->IsNamed(body) && !this->IsNamed(other) &&
      !std::binary_search(within.begin(), within.end(), body);
  }

  /** Whether the caller chose this: Priority names the body, or all others that have its cells. */
  bool AreChosen(Id body, const std::set<Id>& others) const
  {
    return this->IsNamed(body) ||
      std::all_of(others.begin(), others.end(), [&](Id other) { return this->IsNamed(other); });
  }

  /** The bodies within a body that have their cells although it comes before them. */
  std::set<Id> InVainBefore(Id body) const
  {
    std::set<Id> inner;
    for (const Id other : this->Order.Within[body])
    {
      if (!this->IsNamed(body) && !this->IsNamed(other) && this->Place[body] < this->Place[other])
      {
        inner.insert(other);
      }
    }
    return inner;
  }

  std::string Of(const std::set<Id>& bodies) const
  {
    std::string words;
    std::size_t named = 0;
    for (auto body = bodies.begin(); body != bodies.end() && named < MostNamed; ++body, ++named)
    {
      words += (words.empty() ? "" : ", ") + this->Names[*body];
    }
    const std::size_t more = bodies.size() - named;
    return " (" + words + (more > 0 ? " and " + std::to_string(more) + " more" : "") + ")";
  }

  std::string Advice(Id body) const
  {
    return "; set Priority to " + AsListed(this->Names[body]) + ", or RegionRule to all";
  }

private:
  /** A name as it stands in a list of names: in quotes if a shell would split it. */
  static std::string AsListed(const std::string& name)
  {
    std::string listed;
    bool isPlain = true;
    for (const char c : name)
    {
      listed += c == ',' || c == '\\' ? std::string("\\") + c : std::string(1, c);
      isPlain = isPlain && (std::isalnum(static_cast<unsigned char>(c)) || std::strchr("_-.+", c));
    }
    return isPlain ? listed : '"' + listed + '"';
  }

  bool IsNamed(Id body) const { return this->Place[body] < this->Order.Named; }

  const BodyOrder& Order;
  const std::vector<std::string>& Names;
  std::vector<std::size_t> Place; ///< per body, its position in the given order
};

/** A warning if the order takes more than half of a body's volume; else nothing. */
std::string WarningOfOrder(Id body, const std::vector<Id>& owners, const TetrahedralMesh& mesh,
  const std::vector<std::string>& names, const Words& words)
{
  const std::vector<MassProperties> masses =
    MeasureRegions(mesh, { owners, static_cast<Id>(names.size()) });
  double all = 0;
  double taken = 0;
  std::set<Id> by;
  for (Id other = 0; other < static_cast<Id>(masses.size()); ++other)
  {
    const double volume = masses[other].Volume;
    all += volume;
    if (volume > 0 && other != body && words.ComesFirst(other, body))
    {
      taken += volume;
      by.insert(other);
    }
  }
  constexpr double Half = 0.5 + 1e-9; // rounding must not decide when it is exactly half
  if (!(taken > Half * all))
  {
    return "";
  }
  return "body " + names[body] + " loses " + std::to_string(std::lround(100 * taken / all)) +
    " % of its volume to bodies before it" + words.Of(by) + words.Advice(body);
}
} // namespace

std::vector<std::string> WarningsOfCoveredBodies(const TetrahedralMesh& mesh,
  const std::vector<std::vector<unsigned char>>& inside, const BodyOrder& order,
  const BodyRegions& regions, const std::vector<std::string>& names, Monitor& monitor,
  const ProgressRange& progress)
{
  const Words words(order, names);
  std::vector<std::string> warnings;
  for (Id body = 0; body < static_cast<Id>(inside.size()); ++body)
  {
    const std::vector<Id> owners = OwnersOfCells(body, inside[body], regions);
    const bool losesCells = std::any_of(
      owners.begin(), owners.end(), [&](Id owner) { return owner != None && owner != body; });
    if (!losesCells)
    {
      continue;
    }
    const CoveredParts parts =
      FindCoveredParts(body, owners, FindRegions(mesh, inside[body], monitor, progress));
    if (parts.Covered == parts.All)
    {
      warnings.push_back("body " + names[body] +
        " has no cell: all of its places are of bodies before it" + words.Of(parts.By) +
        words.Advice(body));
      continue;
    }
    if (parts.Covered > 0 && !words.AreChosen(body, parts.By))
    {
      warnings.push_back(std::to_string(parts.Covered) + " of the " + std::to_string(parts.All) +
        " parts of body " + names[body] +
        " have no cell: all of their places are of bodies before it" + words.Of(parts.By) +
        words.Advice(body));
    }
    const std::string warning = WarningOfOrder(body, owners, mesh, names, words);
    if (!warning.empty())
    {
      warnings.push_back(warning);
    }
    const std::set<Id> inner = words.InVainBefore(body);
    if (!inner.empty())
    {
      warnings.push_back("bodies within body " + names[body] + words.Of(inner) +
        " keep their own cells, although it comes before them" + words.Advice(body));
    }
  }
  return warnings;
}
} // namespace insideout

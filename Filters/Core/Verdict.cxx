// SPDX-License-Identifier: GPL-3.0-or-later
#include "Verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace insideout
{
namespace
{
/** Statistics by name; 0 for a missing one. */
class Figures
{
public:
  explicit Figures(const Statistics& statistics)
    : All(statistics)
  {
  }

  bool Has(const char* name) const { return this->Find(name) != this->All.end(); }

  double operator[](const char* name) const
  {
    return this->Has(name) ? this->Find(name)->second : 0;
  }

private:
  Statistics::const_iterator Find(const char* name) const
  {
    return std::find_if(
      this->All.begin(), this->All.end(), [&](const auto& figure) { return figure.first == name; });
  }

  const Statistics& All;
};

std::string Formatted(const char* format, int digits, double value)
{
  char text[400]; // a double without exponent has at most 309 digits before the point
  std::snprintf(text, sizeof(text), format, digits, value);
  return text;
}

std::string Exactly(double value)
{
  return Formatted("%.*g", 6, value);
}

/** With commas between thousands. */
std::string Grouped(double count)
{
  std::string digits = Formatted("%.*f", 0, count);
  for (int k = static_cast<int>(digits.size()) - 3; k > 0; k -= 3)
  {
    digits.insert(static_cast<std::size_t>(k), ",");
  }
  return digits;
}

/** "1 facet", "2 facets". */
std::string Counted(double count, const std::string& one)
{
  return Grouped(count) + " " + one + (count == 1 ? "" : "s");
}

std::string Sheets(double count)
{
  return count == 1 ? "a sheet" : Counted(count, "sheet");
}

/** The volume of the solid if it was made, else the volume that the surface encloses. */
struct ToldVolume
{
  explicit ToldVolume(const Figures& figures)
    : Value(figures[figures.Has("Volume") ? "Volume" : "EnclosedVolume"])
    , Low(figures.Has("Volume") ? Value : figures["EnclosedVolumeLow"])
    , High(figures.Has("Volume") ? Value : figures["EnclosedVolumeHigh"])
  {
  }

  std::string InWords() const { return VolumeInWords(this->Value, this->Low, this->High); }

  double Value;
  double Low;
  double High;
};

/** Why the shells bound no solid; empty if they do. */
std::string WhyNone(const Figures& figures, const ToldVolume& volume)
{
  const double solids = figures["ClosedShells"] + figures["HoledShells"];
  if (figures["Shells"] == 0)
  {
    return "its facets cancel in pairs or do not count";
  }
  if (solids == 0)
  {
    return Sheets(figures["SheetShells"]);
  }
  const double turned = figures["TurnedFacets"];
  if (figures["DisagreeingFacets"] > 0 && (turned == 0 || turned == figures["Facets"]))
  {
    return Counted(figures["DisagreeingFacets"], "facet") +
      " against those around, as it is oriented";
  }
  if (volume.Value <= 0)
  {
    return figures["Cavities"] == solids ? "it is inside out as oriented"
      : figures["MaximumW"] > 0.5        ? "no cell of its mesh is inside"
                                         : "its winding number is above 1/2 nowhere";
  }
  return {};
}

std::string WhatWasTurned(const Figures& figures)
{
  if (figures["TurnedShells"] >= figures["ClosedShells"] + figures["HoledShells"])
  {
    return " after it is turned over as a whole";
  }
  if (figures["TurnedShells"] > 0)
  {
    return " after turning " + Grouped(figures["TurnedShells"]) + " of " +
      Counted(figures["Shells"], "shell") + " over";
  }
  return figures["TurnedFacets"] > 0
    ? " after turning " + Counted(figures["TurnedFacets"], "facet") + " over"
    : std::string();
}

/** A warning that the surfaces may mean more than the verdict says. */
std::string IfShared(const Figures& figures)
{
  const double facets = figures["DoubtfulCopies"];
  return facets > 0 ? "; more if surfaces share " + Counted(facets, "facet") : std::string();
}

std::string VerdictInSpace(const Figures& figures)
{
  if (figures["Planar"] != 0)
  {
    return "bounds no solid: it lies in one plane" +
      (figures["Area"] > 0 ? ", where it covers an area of " + Exactly(figures["Area"])
                           : std::string());
  }
  const ToldVolume volume(figures);
  if (const std::string why = WhyNone(figures, volume); !why.empty())
  {
    return volume.Value <= 0
      ? "bounds no solid: " + why + IfShared(figures)
      : (volume.Low > 0 ? "means" : "may mean") + (" a solid of volume " + volume.InWords()) +
        " by its winding number; its shells alone bound none: " + why + IfShared(figures);
  }
  std::string sentence = "bounds a solid of volume " + volume.InWords() + WhatWasTurned(figures);
  if (figures["HoledShells"] > 0)
  {
    sentence += ", once its holes are closed";
  }
  if (figures["Membranes"] > 0)
  {
    sentence += ", parted by " + Counted(figures["Membranes"], "membrane");
  }
  if (const double sheets = figures["SheetShells"]; sheets > 0)
  {
    sentence += "; " + Sheets(sheets) + (sheets == 1 ? " encloses" : " enclose") + " nothing";
  }
  return sentence + IfShared(figures);
}

std::string VerdictInPlane(const Figures& figures)
{
  if (figures["Area"] <= 0)
  {
    return "bounds no area in its plane";
  }
  std::string sentence = "bounds an area of " + Exactly(figures["Area"]) + " in a plane";
  if (figures["TurnedSegments"] > 0)
  {
    sentence += " after turning " + Grouped(figures["TurnedSegments"]) + " of " +
      Counted(figures["InputSegments"], "segment") + " over";
  }
  sentence += figures["OpenEnds"] > 0 ? ", once its gaps are closed" : "";
  const char* before = ": ";
  for (const auto& [name, rule] : { std::pair("AreaByWindingNumber", "by the winding number"),
         std::pair("AreaByEvenOdd", "by even-odd"), std::pair("AreaAsGiven", "as given") })
  {
    if (figures.Has(name))
    {
      sentence += before + Exactly(figures[name]) + " " + rule;
      before = ", ";
    }
  }
  return sentence;
}
} // namespace

std::string VolumeInWords(double volume, double low, double high)
{
  if (!(low < high))
  {
    return Exactly(volume);
  }
  // The place value of the last digit; powers of ten neither overflow nor become 0.
  const double place = std::clamp(std::floor(std::log10((high - low) / 2)), -300.0, 300.0);
  const double unit = std::pow(10, std::abs(place));
  const auto rounded = [&](double value, auto round)
  {
    const double units = round(place < 0 ? value * unit : value / unit);
    const double result = place < 0 ? units / unit : units * unit;
    if (result == 0)
    {
      return std::string("0");
    }
    const bool isShort = place > -7 && place < 9;
    const int digits =
      static_cast<int>(std::clamp(std::floor(std::log10(result) + 1e-9) - place, 0.0, 6.0));
    return isShort ? Formatted("%.*f", static_cast<int>(std::max(0.0, -place)), result)
                   : Formatted("%.*e", digits, result);
  };
  return "about " + rounded(volume, [](double x) { return std::round(x); }) +
    " (95 %: " + rounded(low, [](double x) { return std::floor(x); }) + " to " +
    rounded(high, [](double x) { return std::ceil(x); }) + ")";
}

std::string Verdict(const Statistics& statistics)
{
  const Figures figures(statistics);
  return figures["Dimension"] == 2 ? VerdictInPlane(figures) : VerdictInSpace(figures);
}
} // namespace insideout

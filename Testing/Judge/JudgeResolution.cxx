// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Statistics.h"
#include "Support/ExactReference.h"
#include "Support/ReadTriangles.h"
#include "Support/ResolutionLaws.h"
#include "Support/SurfaceFamilies.h"
#include "Validate/CountedChain.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace insideout;
using namespace testmeshes;

namespace
{
constexpr int WindingPoints = 100;

/** Stops the resolver when its time is over, and knows the longest time between two questions. */
class Deadline : public Monitor
{
public:
  explicit Deadline(double seconds)
    : Limit(seconds)
  {
  }

  bool Continue(const char*, double) override
  {
    this->EndSilence();
    return this->Elapsed < this->Limit;
  }

  /** To be called once more at the end. */
  void EndSilence()
  {
    const double lap = this->Watch.Lap();
    this->Elapsed += lap;
    this->LongestSilence = std::max(this->LongestSilence, lap);
  }

  double Elapsed = 0;
  double LongestSilence = 0;

private:
  const double Limit;
  Stopwatch Watch;
};

void PrintHeader()
{
  std::printf("%-44s %8s %8s %6s %8s %8s %9s %7s %8s %8s %8s  %s\n", "surface", "facets", "pairs",
    "rounds", "seconds", "silence", "resolved", "leftout", "offset", "area", "w", "verdict");
}

/** Prints the line of one surface, and below it what is wrong. */
void PrintRow(const std::string& name, const FacetComplex& before, const Resolution& resolution,
  const Deadline& time, const ResolutionJudgement& judged)
{
  std::printf("%-44s %8d %8zu %6d %8.2f %8.2f %9d %7d %8.1e %8.1e %8.1e  %s\n", name.c_str(),
    before.NumberOfFacets(), resolution.IntersectingPairs.size(), resolution.Rounds, time.Elapsed,
    time.LongestSilence, resolution.Surface.NumberOfFacets(), judged.LeftOut, judged.Offset,
    judged.Area, judged.Winding, judged.Violations.empty() ? "ok" : "VIOLATED");
  for (const std::string& violation : judged.Violations)
  {
    std::printf("    %s\n", violation.c_str());
  }
}

/** What came of the surfaces of a family. */
struct Tally
{
  Id Facets = 0;
  Id Resolved = 0;
  Id LeftOut = 0;
  double Seconds = 0;
  int Broken = 0; ///< surfaces with a law broken, or not resolved in time
};

/** Whether the pairs that the resolver says it found are those that there are. */
bool ArePairs(const Resolution& resolution, const FacetComplex& before)
{
  const std::vector<Triangle> constraints(
    before.Facets.begin(), before.Facets.begin() + before.NumberOfConstraints);
  return resolution.IntersectingPairs == IntersectionsBySweep(before.Points, constraints);
}

/**
 * Validates, resolves and judges. Prints a line, in `quiet` only where something is wrong. An error
 * in the surface is none of the resolver's and is thrown on; to be stopped is.
 */
void JudgeSoup(
  const std::string& name, const TriangleSoup& soup, double seconds, bool quiet, Tally& tally)
{
  Monitor patient;
  const FacetComplex before = CountFacets(soup, {}, patient).Surface;
  tally.Facets += before.NumberOfFacets();
  Deadline time(seconds);
  try
  {
    const Resolution resolution = ResolveSelfIntersections(before, time);
    time.EndSilence();
    ResolutionJudgement judged = JudgeResolution(before, resolution.Surface, WindingPoints);
    if (!ArePairs(resolution, before))
    {
      judged.Violations.push_back("the intersecting pairs are others");
    }
    tally.Resolved += resolution.Surface.NumberOfFacets();
    tally.LeftOut += judged.LeftOut;
    tally.Broken += judged.Violations.empty() ? 0 : 1;
    if (!quiet || !judged.Violations.empty())
    {
      PrintRow(name, before, resolution, time, judged);
    }
  }
  catch (const Error& error)
  {
    time.EndSilence();
    ++tally.Broken;
    std::printf("%-44s %8d %8s %6s %8.2f %8.2f  %s\n", name.c_str(), before.NumberOfFacets(), "-",
      "-", time.Elapsed, time.LongestSilence, error.what());
  }
  tally.Seconds += time.Elapsed;
}

bool JudgeFile(const std::string& path, double seconds)
{
  const std::string name = path.substr(path.find_last_of('/') + 1);
  Tally tally;
  try
  {
    JudgeSoup(name, ReadTriangles(path), seconds, false, tally);
  }
  catch (const Error& error)
  {
    std::printf("%-44s no valid surface: %s\n", name.c_str(), error.what());
    return error.Code != ErrorCode::FileUnreadable;
  }
  return tally.Broken == 0;
}

bool JudgeFamilies(int members, double seconds)
{
  std::vector<SurfaceFamily> families = SurfaceFamilies(members);
  families.push_back(GridSoups(members));
  bool allGood = true;
  for (const SurfaceFamily& family : families)
  {
    Tally tally;
    for (std::size_t i = 0; i < family.Members.size(); ++i)
    {
      JudgeSoup(family.Name + "-" + std::to_string(i), family.Members[i], seconds, true, tally);
    }
    std::printf("family %s: %zu surfaces, %d facets, %d resolved, %d left out, "
                "%.2f seconds, %d broken\n",
      family.Name.c_str(), family.Members.size(), tally.Facets, tally.Resolved, tally.LeftOut,
      tally.Seconds, tally.Broken);
    std::fflush(stdout);
    allGood = allGood && tally.Broken == 0;
  }
  return allGood;
}
} // namespace

/**
 * JudgeResolution [--seconds N] [--families MEMBERS] [SURFACE...]: judges the resolver on surface
 * files, and on MEMBERS of each family of hard surfaces (ResolutionLaws.h, SurfaceFamilies.h). One
 * line per file, and per family and what is broken there; `silence` is the longest time in which
 * the resolver could not be stopped, offset, area and w are ResolutionJudgement's. Exit status 1
 * where a law is broken, the N seconds (600) were over, or a file cannot be read.
 */
int main(int argc, char** argv)
{
  double seconds = 600;
  bool allGood = true;
  PrintHeader();
  for (int i = 1; i < argc; ++i)
  {
    const bool takesNumber =
      std::strcmp(argv[i], "--seconds") == 0 || std::strcmp(argv[i], "--families") == 0;
    if (!takesNumber)
    {
      allGood = JudgeFile(argv[i], seconds) && allGood;
    }
    else if (i + 1 == argc || std::atoi(argv[i + 1]) <= 0)
    {
      std::fprintf(stderr, "%s takes a positive number\n", argv[i]);
      return 1;
    }
    else if (std::strcmp(argv[i++], "--seconds") == 0)
    {
      seconds = std::atoi(argv[i]);
    }
    else
    {
      allGood = JudgeFamilies(std::atoi(argv[i]), seconds) && allGood;
    }
    std::fflush(stdout);
  }
  return allGood ? 0 : 1;
}

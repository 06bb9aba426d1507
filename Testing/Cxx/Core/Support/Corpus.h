// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Support/SurfaceFamilies.h"

/** Surfaces that a stage once failed on, or that are made for it to fail: Testing/Data/Corpus has a
 * file for each. */
namespace testmeshes
{
/** A line of the table beside the files. */
struct CorpusEntry
{
  std::string Name; ///< of the file, without folder and ending
  Id OpenEdges = 0;
  Id IntersectingPairs = 0;
  Id LeftOutFacets = 0;
  Id LostFacets = 0;
};

/** For GoogleTest's messages. */
inline void PrintTo(const CorpusEntry& entry, std::ostream* out)
{
  *out << entry.Name;
}

/** The table. */
std::vector<CorpusEntry> Corpus();

/** The names of the files. */
std::vector<std::string> CorpusFiles();

TriangleSoup CorpusSurface(const std::string& name);

/**
 * Each surface of the corpus changed at random: turned, moved by some last places, put on a coarse
 * grid, with triangles missing, or joined with another place of itself.
 */
SurfaceFamily ChangedCorpus(unsigned seed);
} // namespace testmeshes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/Corpus.h"

#include "Support/ReadTriangles.h"
#include "Support/TestMeshes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

namespace testmeshes
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* Folder = INSIDEOUT_CORPUS;

/** In [0, 1), the same under every compiler. */
double Number(std::mt19937& random)
{
  return static_cast<double>(random()) / 4294967296.0;
}

template <typename Map>
void ForEachCoordinate(TriangleSoup& soup, const Map& map)
{
  for (Point& point : soup.Points)
  {
    for (double& x : point)
    {
      x = map(x);
    }
  }
}

/** The length of the longest axis. */
double SizeOfBox(const TriangleSoup& soup)
{
  double size = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [low, high] = std::minmax_element(soup.Points.begin(), soup.Points.end(),
      [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    size = std::max(size, (*high)[axis] - (*low)[axis]);
  }
  return size;
}

/** By the angle of a Pythagorean triple, about an axis of the three. */
TriangleSoup Turned(TriangleSoup soup, std::mt19937& random)
{
  const int triples[3][3] = { { 3, 4, 5 }, { 5, 12, 13 }, { 119, 120, 169 } };
  const int* triple = triples[random() % 3];
  const std::size_t u = random() % 3;
  const std::size_t v = (u + 1) % 3;
  for (Point& p : soup.Points)
  {
    const double x = (triple[0] * p[u] - triple[1] * p[v]) / triple[2];
    p[v] = (triple[1] * p[u] + triple[0] * p[v]) / triple[2];
    p[u] = x;
  }
  return soup;
}

TriangleSoup Trembled(TriangleSoup soup, std::mt19937& random)
{
  const double step = SizeOfBox(soup) * std::numeric_limits<double>::epsilon();
  ForEachCoordinate(soup, [&](double x) { return x + step * std::floor(5 * Number(random) - 2); });
  return soup;
}

TriangleSoup OnAGrid(TriangleSoup soup, std::mt19937& random)
{
  const double step = SizeOfBox(soup) / (4 << random() % 4);
  ForEachCoordinate(soup, [&](double x) { return step * std::round(x / step); });
  return soup;
}

TriangleSoup WithHoles(TriangleSoup soup, std::mt19937& random)
{
  soup.Triangles.erase(std::remove_if(soup.Triangles.begin(), soup.Triangles.end(),
                         [&](const Triangle&) { return random() % 8 == 0; }),
    soup.Triangles.end());
  return soup;
}

TriangleSoup Twice(const TriangleSoup& soup, std::mt19937& random)
{
  const double size = SizeOfBox(soup);
  TriangleSoup other = Turned(soup, random);
  ForEachCoordinate(other, [&](double x) { return x + size * 0x1p-3; });
  return Join(soup, other);
}
} // namespace

std::vector<CorpusEntry> Corpus()
{
  std::vector<CorpusEntry> entries;
  std::ifstream table(fs::path(Folder) / "corpus.txt");
  for (std::string line; std::getline(table, line);)
  {
    std::istringstream words(line.substr(0, line.find('#')));
    CorpusEntry entry;
    if (words >> entry.Name >> entry.OpenEdges >> entry.IntersectingPairs >> entry.LeftOutFacets >>
      entry.LostFacets)
    {
      entries.push_back(entry);
    }
  }
  return entries;
}

std::vector<std::string> CorpusFiles()
{
  std::vector<std::string> names;
  for (const fs::directory_entry& file : fs::directory_iterator(Folder))
  {
    if (file.path().extension() == ".off")
    {
      names.push_back(file.path().stem());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

TriangleSoup CorpusSurface(const std::string& name)
{
  return ReadTriangles((fs::path(Folder) / (name + ".off")).string());
}

SurfaceFamily ChangedCorpus(unsigned seed)
{
  std::mt19937 random(seed);
  SurfaceFamily family{ "corpus", {} };
  for (const CorpusEntry& entry : Corpus())
  {
    const TriangleSoup soup = CorpusSurface(entry.Name);
    switch (random() % 5)
    {
      case 0:
        family.Members.push_back(Turned(soup, random));
        break;
      case 1:
        family.Members.push_back(Trembled(soup, random));
        break;
      case 2:
        family.Members.push_back(OnAGrid(soup, random));
        break;
      case 3:
        family.Members.push_back(WithHoles(soup, random));
        break;
      default:
        family.Members.push_back(Twice(soup, random));
        break;
    }
  }
  return family;
}
} // namespace testmeshes

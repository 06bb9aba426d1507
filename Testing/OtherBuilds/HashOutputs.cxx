// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Team.h"
#include "Support/OptionHashes.h"
#include "Support/ReadTriangles.h"
#include "Support/TestMeshes.h"

#include <cstdio>
#include <string>

using namespace insideout;

namespace
{
/**
 * A ball that a box sticks in: the image of a grid of `side` times `side` points by the inverse of
 * the stereographic projection, which takes no function that processors or libraries round
 * differently. Open around a pole, or closed by a fan.
 */
TriangleSoup BallAndBox(Id side, bool closed)
{
  const double step = 8.0 / (side - 1);
  TriangleSoup ball;
  for (Id i = 0; i < side * side; ++i)
  {
    const double u = (i % side) * step - 4;
    const double v = (i / side) * step - 4;
    const double scale = 1 / (1 + u * u + v * v);
    ball.Points.push_back({ 2 * u * scale, 2 * v * scale, 1 - 2 * scale });
  }
  for (Id i = 0; i + side < side * side; ++i)
  {
    if (i % side != side - 1)
    {
      ball.Triangles.push_back({ i, i + side, i + 1 });
      ball.Triangles.push_back({ i + 1, i + side, i + side + 1 });
    }
  }
  if (closed)
  {
    const Id pole = static_cast<Id>(ball.Points.size());
    ball.Points.push_back({ 0, 0, 1 });
    for (Id k = 0; k + 1 < side; ++k)
    {
      const Id last = side * (side - 1);
      ball.Triangles.push_back({ k, k + 1, pole });
      ball.Triangles.push_back({ last + k + 1, last + k, pole });
      ball.Triangles.push_back({ (k + 1) * side, k * side, pole });
      ball.Triangles.push_back({ k * side + side - 1, (k + 1) * side + side - 1, pole });
    }
  }
  return testmeshes::Join(ball, testmeshes::Box({ 0.25, 0.25, 0.25 }, { 1.5, 0.5, 0.625 }));
}

void PrintHashes(std::FILE* file, const std::string& name, const Hashes& hashes)
{
  for (const auto& [output, hash] : hashes)
  {
    std::fprintf(file, "%s, %s: %016llx\n", name.c_str(), output.c_str(),
      static_cast<unsigned long long>(hash));
  }
}
} // namespace

/**
 * HashOutputs FILE [--small] SURFACE...: writes hashes of every stage's results for balls, random
 * soups and the surface files. Results of options are hashed for tiny balls, tiny soups and the
 * files. The lines have to be the same from every compiler, with and without optimization, and from
 * any number of threads (OMP_NUM_THREADS). All threads take part in every loop. --small leaves out
 * surfaces of many facets, and the options for files.
 */
int main(int argc, char** argv)
{
  std::FILE* file = argc > 1 ? std::fopen(argv[1], "w") : nullptr;
  if (!file)
  {
    std::fprintf(stderr, "no file to write to\n");
    return 1;
  }
  const WholeTeams teams;
  const bool small = argc > 2 && std::string(argv[2]) == "--small";
  if (!small)
  {
    PrintHashes(file, "closed ball", HashStages(BallAndBox(65, true)));
    PrintHashes(file, "open ball", HashStages(BallAndBox(65, false)));
    PrintHashes(file, "grid soup", HashStages(testmeshes::GridSoup(3, 60, 6)));
    PrintHashes(file, "random soup", HashStages(testmeshes::RandomSoup(5, 40)));
  }
  PrintHashes(file, "small closed ball", HashStages(BallAndBox(17, true)));
  PrintHashes(file, "small open ball", HashStages(BallAndBox(17, false)));
  PrintHashes(file, "small grid soup", HashStages(testmeshes::GridSoup(3, 30, 6)));
  PrintHashes(file, "small random soup", HashStages(testmeshes::RandomSoup(5, 15)));
  const std::pair<std::string, TriangleSoup> tiny[] = { { "tiny closed ball", BallAndBox(9, true) },
    { "tiny open ball", BallAndBox(9, false) },
    { "tiny grid soup", testmeshes::GridSoup(3, 15, 6) },
    { "tiny random soup", testmeshes::RandomSoup(5, 10) } };
  for (const auto& [name, soup] : tiny)
  {
    PrintHashes(file, name, HashOptions(soup));
    PrintHashes(file, name, HashTetGen(soup));
  }
  for (int i = small ? 3 : 2; i < argc; ++i)
  {
    const std::string path = argv[i];
    const std::string name = path.substr(path.rfind('/') + 1);
    const TriangleSoup soup = testmeshes::ReadTriangles(path);
    PrintHashes(file, name, HashStages(soup));
    if (!small)
    {
      PrintHashes(file, name, HashOptions(soup));
    }
  }
  return std::fclose(file) == 0 ? 0 : 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "BooleanByManifold.h"

#include "Measure.h"

#include <manifold/manifold.h>

#include <map>

using namespace insideout;

namespace benchmark
{
namespace
{
manifold::MeshGL64 MeshOf(const TriangleSoup& soup)
{
  manifold::MeshGL64 mesh;
  std::map<Point, std::uint64_t> numbers;
  for (const Triangle& triangle : soup.Triangles)
  {
    for (const Id corner : triangle)
    {
      const Point& point = soup.Points[corner];
      const auto [found, isNew] = numbers.try_emplace(point, numbers.size());
      if (isNew)
      {
        mesh.vertProperties.insert(mesh.vertProperties.end(), point.begin(), point.end());
      }
      mesh.triVerts.push_back(found->second);
    }
  }
  return mesh;
}

Made MadeOf(const manifold::Manifold& a, const manifold::Manifold& b, SetOperation operation)
{
  Stopwatch stopwatch;
  const double began = ProcessorSeconds();
  const manifold::Manifold result = operation == SetOperation::Union ? a + b
    : operation == SetOperation::Intersection                        ? a ^ b
                                                                     : a - b;
  const bool isMade = result.Status() == manifold::Manifold::Error::NoError; // evaluates
  Made made{ stopwatch.Lap(), isMade ? result.NumTri() : 0 };
  made.ProcessorSeconds = ProcessorSeconds() - began;
  made.Volume = result.Volume();
  return made;
}
} // namespace

ManifoldPair TakeByManifold(const TriangleSoup& a, const TriangleSoup& b)
{
  const std::array<manifold::MeshGL64, 2> meshes = { MeshOf(a), MeshOf(b) };
  const double began = ProcessorSeconds();
  const manifold::Manifold first(meshes[0]);
  const manifold::Manifold second(meshes[1]);
  for (const manifold::Manifold* one : { &first, &second })
  {
    if (one->Status() != manifold::Manifold::Error::NoError)
    {
      const bool isPairing = one->Status() == manifold::Manifold::Error::NotManifold;
      return { isPairing ? "NotManifold" : "another error", 0, {} };
    }
  }
  return { {}, ProcessorSeconds() - began,
    [first, second](SetOperation operation) { return MadeOf(first, second, operation); } };
}
} // namespace benchmark

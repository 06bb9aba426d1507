// SPDX-License-Identifier: GPL-3.0-or-later
#include "BooleanByUs.h"

#include "Boolean/SurfaceOfExpression.h"
#include "Measure.h"

using namespace insideout;

namespace benchmark
{
Made BooleanByUs(const TriangleSoup& a, const TriangleSoup& b, SetOperation operation)
{
  std::vector<Body> bodies;
  bodies.push_back(MakeBody("A", a, 0, 0));
  bodies.push_back(
    MakeBody("B", b, static_cast<Id>(a.Points.size()), static_cast<Id>(a.Triangles.size())));
  Monitor monitor;
  Stopwatch stopwatch;
  const double began = ProcessorSeconds();
  const ResolvedBodies resolved = ResolveBodies(std::move(bodies), {}, monitor);
  const auto surface = SurfaceOfExpression(resolved, { operation, 2 }, monitor);
  Made made{ stopwatch.Lap(), surface ? surface->Boundary.size() : 0 };
  made.ProcessorSeconds = ProcessorSeconds() - began;
  made.Volume = surface ? VolumeWithin(resolved.Surface.Points, surface->Boundary) : 0;
  return made;
}
} // namespace benchmark

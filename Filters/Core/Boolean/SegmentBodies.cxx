// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/SegmentBodies.h"

#include "Boolean/Body.h"
#include "Common/AddUp.h"
#include "Common/PartMonitor.h"

namespace insideout
{
BodySegmentation SegmentBodies(const TetrahedralMesh& mesh,
  const std::vector<BodyToSegment>& bodies, const SegmentMeshParameters& parameters,
  Monitor& monitor)
{
  BodySegmentation all;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    const BodyToSegment& body = bodies[b];
    PartMonitor part(monitor, b, bodies.size());
    MeshSegmentation one;
    InTheNameOf(body.Name,
      [&]() { one = SegmentMesh(mesh, body.W, body.Pieces, body.Seeds, parameters, part); });
    all.Inside.push_back(std::move(one.Inside));
    AddUp(one.Statistics, all.Statistics);
    for (const std::string& warning : one.Warnings)
    {
      all.Warnings.push_back(WordsOf(body.Name, warning));
    }
  }
  return all;
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/Regions.h"

#include "Output/InsideBoundary.h"

namespace insideout
{
SolidRegions FindRegions(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress)
{
  CheckLabels(mesh, inside);
  return FindRegions(mesh.Neighbors, inside, monitor, progress);
}
} // namespace insideout

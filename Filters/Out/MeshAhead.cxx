// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/MeshAhead.h"

#include "Common/JobsAtOnce.h"
#include "Common/Stages.h"
#include "Out/KeptHull.h"

namespace vtkInsideOut
{
using namespace insideout;

void MeshAhead(const std::vector<std::shared_ptr<KeptHull>>& hulls,
  const HullMeshParameters& parameters, bool fill, int threads, Monitor& monitor)
{
  if (hulls.empty())
  {
    return;
  }
  JobsAtOnce(
    std::vector<double>(hulls.size(), 1.0), threads, Stages::Tetrahedralizing,
    [&](std::size_t i, Monitor& own)
    {
      try
      {
        hulls[i]->Resolve(parameters, own);
        if (fill)
        {
          hulls[i]->Fill(parameters, own);
        }
      }
      catch (...)
      {
        hulls[i]->Failure = std::current_exception();
      }
    },
    monitor);
}
} // namespace vtkInsideOut

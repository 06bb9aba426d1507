// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/SeedsPort.h"

#include "Common/Error.h"
#include "In/Partitions.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>

namespace vtkInsideOut
{
int FillPort(int port, vtkInformation* info, const char* firstType)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? firstType : "vtkPointSet");
  if (port != 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

vtkSmartPointer<vtkPointSet> FindSeeds(vtkInformationVector** inputVector)
{
  return vtkPointSet::SafeDownCast(JoinDataSets(vtkDataObject::GetData(inputVector[1]), "Body"));
}

std::vector<insideout::Seed> ReadSeeds(vtkPointSet* points)
{
  std::vector<insideout::Seed> seeds;
  if (!points || points->GetNumberOfPoints() == 0)
  {
    return seeds;
  }
  vtkDataArray* inside = points->GetPointData()->GetArray("Inside");
  if (!inside || inside->GetNumberOfComponents() != 1 ||
    inside->GetNumberOfTuples() != points->GetNumberOfPoints())
  {
    throw insideout::Error(insideout::ErrorCode::InvalidParameter,
      "the seeds have no point array Inside of one value per point: 1 for inside, 0 for outside");
  }
  for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
  {
    insideout::Seed seed;
    points->GetPoint(p, seed.Position.data());
    seed.Inside = inside->GetComponent(p, 0) != 0;
    seeds.push_back(seed);
  }
  return seeds;
}
} // namespace vtkInsideOut

// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutGather.h"

#include "vtkInsideOutReadCloud.h"

#include <vtkAlgorithm.h>
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

namespace
{
vtkSmartPointer<vtkPolyData> WithoutGhosts(vtkPolyData* piece,
  const std::vector<std::string>& arrays, const std::vector<std::string>& cloudArrays)
{
  vtkNew<vtkPolyData> own;
  own->ShallowCopy(piece);
  own->RemoveGhostCells();
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->CopyStructure(own);
  for (const std::string& name : arrays)
  {
    if (vtkAbstractArray* array = own->GetCellData()->GetAbstractArray(name.c_str()))
    {
      bare->GetCellData()->AddArray(array);
    }
  }
  if (vtkInsideOutIsCloud(own))
  {
    bare->GetPointData()->SetNormals(vtkInsideOutFindNormals(own));
    for (const std::string& name : cloudArrays)
    {
      bare->GetPointData()->AddArray(own->GetPointData()->GetArray(name.c_str()));
    }
  }
  return bare;
}
} // namespace

bool vtkInsideOutAllRanksWork(vtkMultiProcessController* controller, vtkInformation* output)
{
  const int ranks = controller ? controller->GetNumberOfProcesses() : 1;
  return ranks > 1 &&
    output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) == ranks;
}

vtkSmartPointer<vtkPolyData> vtkInsideOutGather(vtkPolyData* piece,
  const std::vector<std::string>& arrays, const std::vector<std::string>& cloudArrays,
  vtkMultiProcessController* controller)
{
  std::vector<vtkSmartPointer<vtkDataObject>> pieces;
  controller->Gather(WithoutGhosts(piece, arrays, cloudArrays), pieces, 0);
  vtkNew<vtkAppendPolyData> all;
  if (controller->GetLocalProcessId() == 0)
  {
    for (vtkDataObject* each : pieces)
    {
      all->AddInputData(vtkPolyData::SafeDownCast(each));
    }
    all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    all->Update();
  }
  vtkSmartPointer<vtkPolyData> whole = all->GetOutput();
  controller->Broadcast(whole, 0);
  return whole;
}

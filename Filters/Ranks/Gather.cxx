// SPDX-License-Identifier: GPL-3.0-or-later
#include "Ranks/Gather.h"

#include "In/ReadCloud.h"
#include "Ranks/Together.h"

#include <vtkAlgorithm.h>
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

namespace vtkInsideOut
{
namespace
{
constexpr int PieceTag = 4826; // MPI tag of messages, unlike those of others

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
  if (IsCloud(own))
  {
    // Unnamed arrays get names in messages, because only arrays of one name are appended.
    vtkDataArray* found = FindNormals(own);
    const auto normals = vtk::TakeSmartPointer(found->NewInstance());
    normals->ShallowCopy(found);
    normals->SetName("Normals");
    bare->GetPointData()->SetNormals(normals);
    for (const std::string& name : cloudArrays)
    {
      bare->GetPointData()->AddArray(own->GetPointData()->GetArray(name.c_str()));
    }
  }
  return bare;
}
} // namespace

bool AllRanksWork(vtkMultiProcessController* controller, vtkInformation* output)
{
  const int ranks = controller ? controller->GetNumberOfProcesses() : 1;
  return ranks > 1 &&
    output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) == ranks;
}

vtkSmartPointer<vtkPolyData> Gather(vtkPolyData* piece, const std::vector<std::string>& arrays,
  const std::vector<std::string>& cloudArrays, vtkMultiProcessController* controller)
{
  vtkSmartPointer<vtkPolyData> own;
  DoTogether(controller, [&] { own = WithoutGhosts(piece, arrays, cloudArrays); });
  // One by one: gathering all at once, MPI would count their bytes together in 32 bits.
  vtkNew<vtkAppendPolyData> all;
  const bool isFirst = controller->GetLocalProcessId() == 0;
  if (isFirst)
  {
    all->AddInputData(own);
  }
  else
  {
    controller->Send(own, 0, PieceTag);
  }
  for (int rank = 1; isFirst && rank < controller->GetNumberOfProcesses(); ++rank)
  {
    vtkNew<vtkPolyData> other;
    controller->Receive(other, rank, PieceTag);
    all->AddInputData(other);
  }
  DoTogether(controller,
    [&]()
    {
      if (isFirst)
      {
        all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
        all->Update();
      }
    });
  return all->GetOutput();
}
} // namespace vtkInsideOut

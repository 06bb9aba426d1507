// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSolidWriter.h"

#include "Common/Stages.h"
#include "In/ReadSolid.h"
#include "Quality/SolverFitness.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>

#include <new>

using namespace insideout;

// The formats' numbers.
static_assert(int(MshVersion::Msh41) == vtkSolidWriter::MSHVERSION_4_1 &&
  int(MshVersion::Msh22) == vtkSolidWriter::MSHVERSION_2_2);

vtkStandardNewMacro(vtkSolidWriter);

vtkSolidWriter::vtkSolidWriter()
{
  this->SetNumberOfInputPorts(2);
}

vtkSolidWriter::~vtkSolidWriter()
{
  this->SetFileName(nullptr);
}

void vtkSolidWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "MshVersion: " << this->MshVersion << "\n";
  os << indent << "CellsOnly: " << this->CellsOnly << "\n";
  os << indent << "RefusedCells: " << this->RefusedCells << "\n";
  os << indent << "PoorCells: " << this->PoorCells << "\n";
}

int vtkSolidWriter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

void vtkSolidWriter::SetBoundaryConnection(vtkAlgorithmOutput* boundary)
{
  this->SetInputConnection(1, boundary);
}

void vtkSolidWriter::SetBoundaryData(vtkPolyData* boundary)
{
  this->SetInputData(1, boundary);
}

void vtkSolidWriter::WriteFile()
{
  const int written = vtkInsideOut::Run(this, nullptr,
    [&]()
    {
      if (!this->FileName || !*this->FileName)
      {
        throw Error(ErrorCode::FileUnwritable, "no file name is set");
      }
      vtkInsideOut::AlgorithmMonitor monitor(this, { Stages::Writing });
      auto* boundary = vtkPolyData::SafeDownCast(this->GetInputDataObject(1, 0));
      SolidMesh solid = vtkInsideOut::ReadSolid(this->GetInput(), boundary);
      const SolverFitness fitness =
        FitnessForSolver(PointsInFile(this->FileName, solid.Points), solid.Cells, solid.Midpoints,
          solid, solid.RegionOfCell, monitor, { Stages::Writing, 0, 0 });
      if (this->CellsOnly)
      {
        solid.Faces.clear();
        solid.TagOfFace.clear();
        solid.Tags.clear();
        std::fill(solid.RegionOfCell.begin(), solid.RegionOfCell.end(), 0);
        solid.Regions = { { "solid", 1 } };
      }
      WriteSolid(this->FileName, solid, insideout::MshVersion(this->MshVersion), monitor);
      this->RefusedCells = fitness.RefusedCells;
      this->PoorCells = fitness.PoorCells;
      if (!fitness.IsGood())
      {
        const CellTreatment done = vtkInsideOut::TreatmentOf(this->GetInput());
        vtkInsideOut::Warn(this,
          { std::string(this->FileName) + ": " +
            WordsOfFitness(fitness, done, vtkInsideOut::MayBeRemeshed(this->GetInput())) });
      }
    });
  if (!written)
  {
    this->SetErrorCode(vtkErrorCode::UnknownError); // Write() gives 0 then
  }
  else if (vtkInsideOut::AlgorithmMonitor::ShouldAbort(this))
  {
    this->SetErrorCode(vtkErrorCode::UserError);
  }
}

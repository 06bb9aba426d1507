// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSolidReader.h"

#include "Common/Error.h"
#include "Common/Stages.h"
#include "Out/MakeSolid.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

using namespace insideout;

vtkStandardNewMacro(vtkSolidReader);

vtkSolidReader::vtkSolidReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

vtkSolidReader::~vtkSolidReader()
{
  this->SetFileName(nullptr);
}

void vtkSolidReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

int vtkSolidReader::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

vtkPolyData* vtkSolidReader::GetBoundary()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkSolidReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector, 0);
  vtkPolyData* boundary = vtkPolyData::GetData(outputVector, 1);
  return vtkInsideOut::Run(this, outputVector,
    [&]()
    {
      if (!this->FileName || !*this->FileName)
      {
        throw Error(ErrorCode::FileUnreadable, "no file name is set");
      }
      vtkInsideOut::AlgorithmMonitor monitor(this, { Stages::Reading });
      const SolidContent solid = ReadSolid(this->FileName, monitor);
      output->ShallowCopy(vtkInsideOut::MakeSolid(solid));
      boundary->ShallowCopy(vtkInsideOut::MakeSolidBoundary(solid));
      vtkInsideOut::Warn(this, solid.Warnings);
    });
}

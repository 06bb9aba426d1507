// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSurfaceReader.h"

#include "Common/Stages.h"
#include "Out/MakeOutputs.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

using namespace insideout;

vtkStandardNewMacro(vtkSurfaceReader);

vtkSurfaceReader::vtkSurfaceReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkSurfaceReader::~vtkSurfaceReader()
{
  this->SetFileName(nullptr);
}

void vtkSurfaceReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

int vtkSurfaceReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return vtkInsideOut::Run(this, outputVector,
    [&]()
    {
      if (!this->FileName || !*this->FileName)
      {
        throw Error(ErrorCode::FileUnreadable, "no file name is set");
      }
      vtkInsideOut::AlgorithmMonitor monitor(this, { Stages::Reading });
      const PolygonSurface surface = ReadSurface(this->FileName, monitor);
      output->ShallowCopy(vtkInsideOut::MakePolygons(surface));
      vtkInsideOut::Warn(this, surface.Warnings);
    });
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSurfaceWriter.h"

#include "Common/Stages.h"
#include "In/ReadSurface.h"
#include "Rounding/RoundToFloats.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <string>

using namespace insideout;

vtkStandardNewMacro(vtkSurfaceWriter);

vtkSurfaceWriter::vtkSurfaceWriter() = default;

vtkSurfaceWriter::~vtkSurfaceWriter()
{
  this->SetFileName(nullptr);
}

void vtkSurfaceWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

int vtkSurfaceWriter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  // VTK splits composite inputs into blocks, but not for algorithms without outputs.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

vtkPolyData* vtkSurfaceWriter::GetInput()
{
  return this->GetInput(0);
}

vtkPolyData* vtkSurfaceWriter::GetInput(int port)
{
  return vtkPolyData::SafeDownCast(this->Superclass::GetInput(port));
}

void vtkSurfaceWriter::WriteFile()
{
  const int written = vtkInsideOut::Run(this, nullptr,
    [&]()
    {
      if (!this->FileName || !*this->FileName)
      {
        throw Error(ErrorCode::FileUnwritable, "no file name is set");
      }
      if (!this->GetInput())
      {
        throw Error(ErrorCode::InvalidParameter,
          std::string("the input is a ") + this->Superclass::GetInput(0)->GetClassName() +
            ", and a file holds one surface: extract one of the blocks, or append them");
      }
      vtkInsideOut::AlgorithmMonitor monitor(
        this, { Stages::FindingIntersections, Stages::Writing });
      PolygonSurface surface = vtkInsideOut::ReadPolygons(this->GetInput());
      const std::string left =
        HasFloats(this->FileName) ? WordsOf(RoundToFloats(surface, monitor)) : std::string();
      WriteSurface(this->FileName, surface, monitor);
      if (!left.empty())
      {
        vtkInsideOut::Warn(this, { std::string(this->FileName) + ": " + left });
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

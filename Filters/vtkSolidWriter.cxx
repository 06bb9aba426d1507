// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSolidWriter.h"

#include "Common/Stages.h"
#include "In/ReadSolid.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <new>

using namespace insideout;

// The numbers that both know.
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

void vtkSolidWriter::WriteData()
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
      const std::string lost =
        WriteSolid(this->FileName, vtkInsideOut::ReadSolid(this->GetInput(), boundary),
          insideout::MshVersion(this->MshVersion), monitor);
      if (!lost.empty())
      {
        vtkInsideOut::Warn(this, { std::string(this->FileName) + ": " + lost });
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

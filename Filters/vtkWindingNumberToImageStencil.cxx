// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkWindingNumberToImageStencil.h"

#include "Common/Error.h"
#include "Common/Stages.h"
#include "In/Partitions.h"
#include "In/ReadCurve.h"
#include "Probe/VisitPlaces.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkImageStencilData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

using namespace insideout;

vtkStandardNewMacro(vtkWindingNumberToImageStencil);

vtkWindingNumberToImageStencil::vtkWindingNumberToImageStencil()
{
  this->SetNumberOfInputPorts(1);
}

void vtkWindingNumberToImageStencil::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
  os << indent << "NonParticipatingArrayName: " << this->NonParticipatingArrayName << "\n";
}

void vtkWindingNumberToImageStencil::SetInputData(vtkDataObject* surface)
{
  this->SetInputDataObject(0, surface);
}

int vtkWindingNumberToImageStencil::FillInputPortInformation(
  int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  return 1;
}

/** Any part of the image needs the whole surface. */
int vtkWindingNumberToImageStencil::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  vtkInformation* surface = inputVector[0]->GetInformationObject(0);
  surface->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
  surface->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  surface->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

namespace
{
/** Add the runs of values above the threshold in a row that starts at Extent[0]. */
void AddRuns(const double* w, double threshold, int y, int z, vtkImageStencilData* stencil)
{
  const int* const extent = stencil->GetExtent();
  for (int x = extent[0]; x <= extent[1]; ++x)
  {
    const int first = x;
    while (x <= extent[1] && w[x - extent[0]] > threshold)
    {
      ++x;
    }
    if (x > first)
    {
      stencil->InsertNextExtent(first, x - 1, y, z);
    }
  }
}
} // namespace

int vtkWindingNumberToImageStencil::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  return vtkInsideOut::Run(this, outputVector,
    [&]()
    {
      const auto surface = vtkInsideOut::JoinSurfaces(vtkDataObject::GetData(inputVector[0]));
      if (vtkInsideOut::AreLines(surface))
      {
        throw Error(ErrorCode::EmptySurface,
          "the surface has lines but no polygons, and a stencil is of polygons only");
      }
      vtkImageData* const like = this->GetInformationInput();
      if (like && !like->GetDirectionMatrix()->IsIdentity())
      {
        throw Error(ErrorCode::InvalidParameter,
          "the image's axes are not x, y and z, and a stencil knows no others");
      }
      vtkImageStencilData* stencil =
        this->AllocateOutputData(outInfo->Get(vtkDataObject::DATA_OBJECT()),
          outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
      vtkInsideOut::AlgorithmMonitor monitor(
        this, { Stages::Validating, Stages::Orienting, Stages::WindingNumbers });
      std::vector<std::string> warnings;
      const vtkInsideOut::InputWindingNumber windingNumber(
        surface, vtkInsideOut::ReadSurfaceOptions(this), monitor, warnings);
      vtkNew<vtkImageData> image;
      image->SetExtent(stencil->GetExtent());
      image->SetOrigin(stencil->GetOrigin());
      image->SetSpacing(stencil->GetSpacing());
      const int* const extent = stencil->GetExtent();
      const vtkIdType width = extent[1] - extent[0] + 1;
      const vtkIdType height = extent[3] - extent[2] + 1;
      vtkInsideOut::VisitPlaces(image, true, windingNumber, this->Threshold, monitor,
        { Stages::WindingNumbers, 0, 1 },
        [&](vtkIdType first, const std::vector<double>& w)
        {
          for (vtkIdType row = 0; row * width < static_cast<vtkIdType>(w.size()); ++row)
          {
            const vtkIdType all = first / width + row;
            AddRuns(w.data() + row * width, this->Threshold,
              extent[2] + static_cast<int>(all % height),
              extent[4] + static_cast<int>(all / height), stencil);
          }
        });
      vtkInsideOut::Warn(this, warnings);
    });
}

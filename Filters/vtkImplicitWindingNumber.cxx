// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImplicitWindingNumber.h"

#include "In/Blocks.h"
#include "In/Partitions.h"
#include "Probe/InputWindingNumber.h"
#include "Run/RunFilter.h"

#include "Common/ForkableMutex.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <atomic>
#include <mutex>

using namespace insideout;

vtkStandardNewMacro(vtkImplicitWindingNumber);

class vtkImplicitWindingNumber::Internal
{
public:
  std::unique_ptr<const vtkInsideOut::InputWindingNumber>
    WindingNumber; ///< null without a usable surface
  std::atomic<vtkMTimeType> BuildTime{ 0 };
  ForkableMutex Mutex;
};

vtkImplicitWindingNumber::vtkImplicitWindingNumber()
  : Built(new Internal)
{
  this->AreaArrayName = vtkInsideOut::SurfaceOptions().Areas;
}

vtkImplicitWindingNumber::~vtkImplicitWindingNumber()
{
  this->SetInput(nullptr);
  delete this->Built;
}

void vtkImplicitWindingNumber::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Input: " << this->Input << "\n";
  os << indent << "SignedDistance: " << this->SignedDistance << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
  os << indent << "NonParticipatingArrayName: " << this->NonParticipatingArrayName << "\n";
  os << indent << "AreaArrayName: " << this->AreaArrayName << "\n";
}

vtkCxxSetObjectMacro(vtkImplicitWindingNumber, Input, vtkDataObject);

vtkMTimeType vtkImplicitWindingNumber::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Input ? std::max(own, vtkInsideOut::LastChange(this->Input)) : own;
}

void vtkImplicitWindingNumber::Build()
{
  this->Built->WindingNumber.reset();
  if (!this->Input)
  {
    return;
  }
  try
  {
    Monitor silent;
    std::vector<std::string> warnings;
    vtkInsideOut::SurfaceOptions options = vtkInsideOut::ReadSurfaceOptions(this);
    options.Areas = this->AreaArrayName;
    options.Distance = this->SignedDistance;
    this->Built->WindingNumber = std::make_unique<const vtkInsideOut::InputWindingNumber>(
      vtkInsideOut::JoinSurfaces(this->Input), options, silent, warnings);
    for (const std::string& warning : warnings)
    {
      vtkWarningMacro(<< warning);
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< vtkInsideOut::WordsOf(error));
  }
}

/** The winding number of the surface in its present state; the first thread builds it. */
const vtkImplicitWindingNumber::Internal& vtkImplicitWindingNumber::UpToDate()
{
  const vtkMTimeType now = this->GetMTime();
  if (this->Built->BuildTime.load(std::memory_order_acquire) < now)
  {
    const std::lock_guard<ForkableMutex> lock(this->Built->Mutex);
    if (this->Built->BuildTime.load(std::memory_order_relaxed) < now)
    {
      this->Build();
      this->Built->BuildTime.store(now, std::memory_order_release);
    }
  }
  return *this->Built;
}

namespace
{
double Signed(const vtkInsideOut::NearestPoint& nearest, double w)
{
  return w > 0.5 ? -nearest.Distance : nearest.Distance;
}
} // namespace

double vtkImplicitWindingNumber::EvaluateFunction(double x[3])
{
  const Internal& built = this->UpToDate();
  if (!built.WindingNumber)
  {
    return 0.5;
  }
  const Point place = { x[0], x[1], x[2] };
  const double w = built.WindingNumber->At(place);
  return this->SignedDistance ? Signed(built.WindingNumber->NearestTo(place), w) : 0.5 - w;
}

void vtkImplicitWindingNumber::EvaluateFunction(vtkDataArray* input, vtkDataArray* output)
{
  const Internal& built = this->UpToDate();
  const vtkIdType size = input->GetNumberOfTuples();
  output->SetNumberOfComponents(1);
  output->SetNumberOfTuples(size);
  output->Fill(0.5);
  if (!built.WindingNumber)
  {
    return;
  }
  try
  {
    std::vector<Point> points(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      input->GetTuple(i, points[i].data());
    }
    Monitor silent;
    const std::vector<double> w = built.WindingNumber->At(points, silent);
    const std::vector<vtkInsideOut::NearestPoint> nearest = this->SignedDistance
      ? built.WindingNumber->NearestTo(points, silent, { Stages::Distances, 0, 1 })
      : std::vector<vtkInsideOut::NearestPoint>();
    for (vtkIdType i = 0; i < size; ++i)
    {
      output->SetComponent(i, 0, this->SignedDistance ? Signed(nearest[i], w[i]) : 0.5 - w[i]);
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< vtkInsideOut::WordsOf(error)); // VTK's callers do not expect exceptions
  }
}

void vtkImplicitWindingNumber::EvaluateGradient(double x[3], double g[3])
{
  const Internal& built = this->UpToDate();
  const Point place = { x[0], x[1], x[2] };
  std::fill_n(g, 3, 0.0);
  if (built.WindingNumber && this->SignedDistance)
  {
    const vtkInsideOut::NearestPoint nearest = built.WindingNumber->NearestTo(place);
    const double distance = Signed(nearest, built.WindingNumber->At(place));
    for (int i = 0; i < 3 && distance != 0; ++i)
    {
      g[i] = (place[i] - nearest.Place[i]) / distance;
    }
  }
  else if (built.WindingNumber)
  {
    const Point rise = built.WindingNumber->Gradient(place);
    for (int i = 0; i < 3; ++i)
    {
      g[i] = 0 - rise[i];
    }
  }
}

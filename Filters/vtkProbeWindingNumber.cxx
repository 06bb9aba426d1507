// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkProbeWindingNumber.h"

#include "Common/PartMonitor.h"
#include "Common/Stages.h"
#include "Data/Arrays.h"
#include "Data/Attributes.h"
#include "Data/StatisticsArrays.h"
#include "In/Blocks.h"
#include "In/FollowTime.h"
#include "In/Partitions.h"
#include "In/PieceOfInput.h"
#include "In/ReadCurve.h"
#include "In/WholeInput.h"
#include "Out/MakeOutputs.h"
#include "Probe/PiecesInTurn.h"
#include "Probe/VisitPlaces.h"
#include "Ranks/FailTogether.h"
#include "Ranks/Gather.h"
#include "Ranks/SurfaceChunks.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkAlgorithmOutput.h>
#include <vtkCellData.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <optional>
#include <utility>

using namespace insideout;

vtkStandardNewMacro(vtkProbeWindingNumber);

class vtkProbeWindingNumber::Internal
{
public:
  std::unique_ptr<vtkInsideOut::SurfaceChunks> Surface;
};

vtkProbeWindingNumber::vtkProbeWindingNumber()
  : Controller(vtkMultiProcessController::GetGlobalController())
  , Last(new Internal)
  , Failures(new vtkInsideOut::FailTogether)
{
  this->SetNumberOfInputPorts(2);
  this->AreaArrayName = vtkInsideOut::SurfaceOptions().Areas;
  const WindingNumberParameters windingNumber;
  this->Method = static_cast<int>(windingNumber.Method);
  this->ApproximationOrder = windingNumber.ApproximationOrder;
  this->Accuracy = windingNumber.Accuracy;
}

vtkProbeWindingNumber::~vtkProbeWindingNumber()
{
  delete this->Last;
}

void vtkProbeWindingNumber::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Association: " << this->Association << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "InsideOut: " << this->InsideOut << "\n";
  os << indent << "OutputWindingNumber: " << this->OutputWindingNumber << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "ClosestPoints: " << this->ClosestPoints << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "ApproximationOrder: " << this->ApproximationOrder << "\n";
  os << indent << "Accuracy: " << this->Accuracy << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
  os << indent << "NonParticipatingArrayName: " << this->NonParticipatingArrayName << "\n";
  os << indent << "AreaArrayName: " << this->AreaArrayName << "\n";
  os << indent << "SurfacePieces: " << this->SurfacePieces << "\n";
  os << indent << "FacetsAtOnce: " << this->FacetsAtOnce << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}

void vtkProbeWindingNumber::SetSurfaceData(vtkDataObject* surface)
{
  this->SetInputDataObject(1, surface);
}

void vtkProbeWindingNumber::SetSurfaceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

vtkPolyData* vtkProbeWindingNumber::GetSurface()
{
  return vtkPolyData::SafeDownCast(this->GetExecutive()->GetInputData(1, 0));
}

int vtkProbeWindingNumber::ModifyRequest(vtkInformation* request, int when)
{
  return this->Failures->ModifyRequest(this, this->Controller, request, when);
}

int vtkProbeWindingNumber::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkPolyData");
  if (port == 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  }
  return 1;
}

void vtkProbeWindingNumber::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkProbeWindingNumber::GetController()
{
  return this->Controller;
}

int vtkProbeWindingNumber::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* vtkNotUsed(outputVector))
{
  return vtkInsideOut::FollowTime(this);
}

/** Each MPI piece of the output needs the whole surface. If all ranks work, each requests its own
 * piece of the surface, and they gather them. With blocks this is impossible: ranks may have
 * different numbers of these, and would wait for each other for ever. */
int vtkProbeWindingNumber::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  bool inPieces =
    vtkInsideOut::AllRanksWork(this->Controller, outputVector->GetInformationObject(0));
  for (int port = 0; port < 2; ++port)
  {
    if (vtkInformation* input = inputVector[port]->GetInformationObject(0))
    {
      vtkInsideOut::RememberBlocks(input);
      inPieces = inPieces && !vtkInsideOut::HasBlocks(input);
    }
  }
  if (vtkInformation* surface = inputVector[1]->GetInformationObject(0))
  {
    inPieces = inPieces && this->SurfacePieces == 1;
    surface->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(),
      inPieces ? this->Controller->GetLocalProcessId() : 0);
    surface->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(),
      inPieces ? this->Controller->GetNumberOfProcesses() : this->SurfacePieces);
    surface->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return done;
}

namespace
{
vtkInsideOut::SurfaceOptions ReadOptions(vtkProbeWindingNumber* filter)
{
  using Filter = vtkProbeWindingNumber;
  using Method = WindingNumberMethod;
  static_assert(Filter::EXACT == static_cast<int>(Method::Exact));
  static_assert(Filter::NAIVE == static_cast<int>(Method::Naive));
  static_assert(Filter::HIERARCHICAL == static_cast<int>(Method::Hierarchical));
  static_assert(Filter::APPROXIMATE == static_cast<int>(Method::Approximate));
  vtkInsideOut::SurfaceOptions options = vtkInsideOut::ReadSurfaceOptions(filter);
  options.WindingNumber.Method = static_cast<Method>(filter->GetMethod());
  options.WindingNumber.ApproximationOrder = filter->GetApproximationOrder();
  options.WindingNumber.Accuracy = filter->GetAccuracy();
  options.Areas = filter->GetAreaArrayName();
  options.Distance = filter->GetDistance();
  return options;
}

unsigned char Mark(double w, double threshold, bool insideOut)
{
  return (w > threshold) != insideOut ? 1 : 0;
}

using Arrays = std::vector<vtkSmartPointer<vtkDataArray>>;

/** An array for the output, with room for a tuple per place. */
template <typename Array>
Array* Add(Arrays& arrays, const char* name, vtkIdType size, int components = 1)
{
  const auto array = vtkInsideOut::MakeArray<Array>(name, size, components);
  arrays.emplace_back(array);
  return array;
}

/** w, if it is wanted or summed, and Inside, which comes last. */
Arrays AskWindingNumbers(vtkProbeWindingNumber* filter, vtkDataSet* input,
  vtkInsideOut::SurfaceChunks& surface, Monitor& monitor)
{
  const bool atPoints = filter->GetAssociation() == vtkProbeWindingNumber::POINTS;
  const vtkIdType size = vtkInsideOut::NumberOfPlaces(input, atPoints);
  const double threshold = filter->GetThreshold();
  const bool insideOut = filter->GetInsideOut();
  const bool addsUp = surface.Size() > 1;
  Arrays arrays;
  double* w = nullptr;
  unsigned char* inside = nullptr;
  surface.DoTogether(
    [&]()
    {
      if (filter->GetOutputWindingNumber() || addsUp)
      {
        w = Add<vtkDoubleArray>(arrays, "w", size)->GetPointer(0);
      }
      inside = Add<vtkUnsignedCharArray>(arrays, "Inside", size)->GetPointer(0);
    });
  surface.TakeTurns(monitor,
    [&](const vtkInsideOut::SurfaceChunks::Turn& turn)
    {
      vtkInsideOut::VisitPlaces(input, atPoints, turn.Piece,
        w ? std::nullopt : std::optional<double>(threshold), monitor, turn.Progress,
        [&](vtkIdType first, const std::vector<double>& values)
        {
          for (std::size_t i = 0; i < values.size(); ++i)
          {
            const vtkIdType place = first + static_cast<vtkIdType>(i);
            double value = turn.IsFirst ? values[i] : w[place] + values[i];
            if (turn.IsClosed)
            {
              value = SumOfClosed(value);
            }
            if (w)
            {
              w[place] = value;
            }
            inside[place] = Mark(value, threshold, insideOut);
          }
        });
    });
  if (!filter->GetOutputWindingNumber() && w)
  {
    arrays.erase(arrays.begin());
  }
  return arrays;
}

/** Distance and its associated arrays; the array Inside determines its sign. */
Arrays AskDistances(vtkProbeWindingNumber* filter, vtkDataSet* input,
  vtkInsideOut::SurfaceChunks& surface, vtkDataArray* inside, Monitor& monitor)
{
  const bool atPoints = filter->GetAssociation() == vtkProbeWindingNumber::POINTS;
  const vtkIdType size = vtkInsideOut::NumberOfPlaces(input, atPoints);
  const bool closest = filter->GetClosestPoints();
  const double negative = filter->GetInsideOut() ? 0 : 1;
  Arrays arrays;
  vtkDoubleArray* distance = nullptr;
  vtkDoubleArray* place = nullptr;
  vtkIdTypeArray* cell = nullptr;
  std::vector<vtkInsideOut::NearestPoint> best; // so far
  surface.DoTogether(
    [&]()
    {
      distance = Add<vtkDoubleArray>(arrays, "Distance", size);
      place = closest ? Add<vtkDoubleArray>(arrays, "ClosestPoint", size, 3) : nullptr;
      cell = closest ? Add<vtkIdTypeArray>(arrays, "ClosestCellId", size) : nullptr;
      best.resize(surface.Size() > 1 ? size : 0);
    });
  surface.TakeTurnsForDistances(
    [&](const vtkInsideOut::SurfaceChunks::Turn& turn)
    {
      vtkInsideOut::VisitNearest(input, atPoints, turn.Piece, monitor, turn.Progress,
        [&](vtkIdType i, const vtkInsideOut::NearestPoint& found)
        {
          const vtkInsideOut::NearestPoint& nearest =
            turn.IsFirst || found.IsNearerThan(best[i]) ? found : best[i];
          if (!turn.IsLast)
          {
            best[i] = nearest;
            return;
          }
          const bool isNegative = inside->GetComponent(i, 0) == negative;
          distance->SetValue(i, isNegative ? -nearest.Distance : nearest.Distance);
          if (closest)
          {
            place->SetTuple(i, nearest.Place.data());
            cell->SetValue(i, nearest.Cell);
          }
        });
    });
  return arrays;
}

/** The same of a surface whose pieces are requested one after the other. */
Arrays AskInTurn(vtkProbeWindingNumber* filter, vtkDataSet* input,
  const vtkInsideOut::SurfaceOptions& options, std::vector<std::string>& warnings)
{
  vtkInsideOut::AlgorithmMonitor monitor(filter, { Stages::WindingNumbers });
  const bool atPoints = filter->GetAssociation() == vtkProbeWindingNumber::POINTS;
  vtkInsideOut::PiecesInTurn pieces(options, input, atPoints);
  const int size = filter->GetSurfacePieces();
  for (int k = 0; k < size; ++k)
  {
    const double begin = static_cast<double>(k) / size;
    QuietMonitor ofPiece(monitor, { Stages::WindingNumbers, begin, begin });
    const auto piece = vtkInsideOut::JoinSurfaces(vtkInsideOut::PieceOfInput(filter, 1, k, size));
    const std::string name = "piece " + std::to_string(k) + " of the surface: ";
    std::vector<std::string> more;
    try
    {
      pieces.Add(piece, ofPiece, more);
    }
    catch (const Error& error)
    {
      if (error.Code == ErrorCode::Stopped)
      {
        throw;
      }
      if (error.Code != ErrorCode::AllDegenerate)
      {
        throw Error(error.Code, name + error.what());
      }
      more.emplace_back(error.what());
    }
    for (const std::string& warning : more)
    {
      warnings.push_back(name + warning);
    }
  }
  const vtkSmartPointer<vtkDoubleArray> w = pieces.Finish(monitor);
  Arrays arrays;
  if (filter->GetOutputWindingNumber())
  {
    arrays.emplace_back(w);
  }
  auto* inside = Add<vtkUnsignedCharArray>(arrays, "Inside", w->GetNumberOfValues());
  for (vtkIdType i = 0; i < w->GetNumberOfValues(); ++i)
  {
    inside->SetValue(i, Mark(w->GetValue(i), filter->GetThreshold(), filter->GetInsideOut()));
  }
  return arrays;
}

/** The input with the arrays, the first of which is active. */
void AddArrays(vtkProbeWindingNumber* filter, vtkDataSet* input, const Arrays& arrays,
  vtkDataSet* output, std::vector<std::string>& warnings)
{
  output->ShallowCopy(input);
  vtkDataSetAttributes* data = output->GetAttributes(
    filter->GetAssociation() == vtkProbeWindingNumber::POINTS ? vtkDataObject::POINT
                                                              : vtkDataObject::CELL);
  for (const auto& array : arrays)
  {
    vtkInsideOut::Attributes::RenameArrays(
      data, vtkInsideOut::Attributes::AreMadeHere(input), { array->GetName() }, warnings);
    data->AddArray(array);
  }
  data->SetActiveScalars(arrays.front()->GetName()); // SetScalars would remove earlier arrays
}
} // namespace

int vtkProbeWindingNumber::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* output = vtkDataSet::GetData(outputVector);
  const bool isPiece = inputVector[1]->GetInformationObject(0)->Get(
                         vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) > 1;
  const bool inTurn = this->SurfacePieces > 1;
  vtkMultiProcessController* const together = isPiece && !inTurn ? this->Controller.Get() : nullptr;
  this->Last->Surface.reset();
  const auto work = [&]()
  {
    vtkInsideOut::WarnOfThreads(this);
    std::vector<std::string> warnings;
    const vtkInsideOut::SurfaceOptions options = ReadOptions(this);
    if (inTurn)
    {
      AddArrays(this, input, AskInTurn(this, input, options, warnings), output, warnings);
      vtkInsideOut::AddStatistics(
        { { "SurfacePieces", static_cast<double>(this->SurfacePieces) } }, output);
      vtkInsideOut::Warn(this, warnings);
      return;
    }
    const auto surface = vtkInsideOut::JoinSurfaces(vtkDataObject::GetData(inputVector[1]));
    std::vector<std::string> stages = { Stages::Validating, Stages::Orienting,
      Stages::WindingNumbers };
    if (this->Distance)
    {
      stages.emplace_back(Stages::Distances);
    }
    if (vtkInsideOut::AreLines(surface) || surface->GetNumberOfCells() == 0)
    {
      // A curve, which all may share, is resolved and its hull triangulated before its orientation
      // is known.
      stages.insert(stages.begin() + 1, { Stages::Resolving, Stages::Triangulating });
    }
    vtkInsideOut::AlgorithmMonitor monitor(this, stages);
    this->Last->Surface = together
      ? std::make_unique<vtkInsideOut::SurfaceChunks>(
          surface, options, this->FacetsAtOnce, together, monitor, warnings)
      : std::make_unique<vtkInsideOut::SurfaceChunks>(surface, options, monitor, warnings);
    vtkInsideOut::SurfaceChunks& pieces = *this->Last->Surface;
    Arrays arrays = AskWindingNumbers(this, input, pieces, monitor);
    if (this->Distance)
    {
      const Arrays more = AskDistances(this, input, pieces, arrays.back(), monitor);
      arrays.insert(arrays.end(), more.begin(), more.end());
    }
    AddArrays(this, input, arrays, output, warnings);
    if (together)
    {
      vtkInsideOut::AddStatistics(
        { { "SurfacePieces", static_cast<double>(pieces.Size()) } }, output);
    }
    if (!vtkInsideOut::IsFurtherPiece(outputVector)) // all have the same statistics of the surface
    {
      vtkInsideOut::Warn(this, warnings);
    }
  };
  return vtkInsideOut::Run(this, outputVector, work, together);
}

int vtkProbeWindingNumber::IsInside(vtkIdType id)
{
  vtkDataSet* output = this->GetOutput();
  vtkDataSetAttributes* data = output
    ? output->GetAttributes(
        this->Association == POINTS ? vtkDataObject::POINT : vtkDataObject::CELL)
    : nullptr;
  auto* inside = vtkUnsignedCharArray::SafeDownCast(data ? data->GetArray("Inside") : nullptr);
  return inside && id >= 0 && id < inside->GetNumberOfValues() ? inside->GetValue(id) : 0;
}

int vtkProbeWindingNumber::IsInsideSurface(double x, double y, double z)
{
  const vtkInsideOut::InputWindingNumber* windingNumber =
    this->Last->Surface ? this->Last->Surface->Whole() : nullptr;
  return windingNumber ? Mark(windingNumber->At(Point{ x, y, z }), this->Threshold, this->InsideOut)
                       : 0;
}

int vtkProbeWindingNumber::IsInsideSurface(double x[3])
{
  return this->IsInsideSurface(x[0], x[1], x[2]);
}

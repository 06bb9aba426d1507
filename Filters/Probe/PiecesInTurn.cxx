// SPDX-License-Identifier: GPL-3.0-or-later
#include "Probe/PiecesInTurn.h"

#include "Data/Arrays.h"
#include "Probe/VisitPlaces.h"

#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkPolyData.h>

#include <utility>

namespace vtkInsideOut
{
namespace
{
void Refuse(bool isGiven, const std::string& option)
{
  if (isGiven)
  {
    throw insideout::Error(insideout::ErrorCode::InvalidParameter,
      option + " needs the whole surface, and SurfacePieces is above 1");
  }
}

/** How often copies and two-sided parts are meant to count depends on the whole surface. */
SurfaceOptions ForPieces(SurfaceOptions options)
{
  options.CountsAsGiven = true;
  return options;
}
} // namespace

PiecesInTurn::PiecesInTurn(const SurfaceOptions& options, vtkDataSet* places, bool atPoints)
  : Options(ForPieces(options))
  , Places(places)
  , AtPoints(atPoints)
{
  Refuse(options.Orientation == insideout::Orientation::Automatic, "Orientation AUTOMATIC");
  Refuse(options.Orientation == insideout::Orientation::Outward, "Orientation OUTWARD");
  Refuse(options.Chain.MergeTolerance > 0, "MergeTolerance");
  Refuse(options.Distance, "Distance");
  Refuse(options.WindingNumber.Method == insideout::WindingNumberMethod::Approximate,
    "Method APPROXIMATE");
  this->W = MakeArray<vtkDoubleArray>("w", NumberOfPlaces(places, atPoints));
  this->W->Fill(0);
}

void PiecesInTurn::Add(
  vtkPolyData* piece, insideout::Monitor& monitor, std::vector<std::string>& warnings)
{
  if (piece->GetNumberOfPolys() + piece->GetNumberOfStrips() == 0)
  {
    return;
  }
  insideout::CountedPiece counted;
  counted.Surface = Facets(piece, this->Options, monitor, warnings).Surface;
  this->IsEmpty = false;
  this->Pieces.Close(counted.Surface);
  this->Add(counted, monitor);
}

void PiecesInTurn::Add(const insideout::CountedPiece& piece, insideout::Monitor& monitor)
{
  double* const w = this->W->GetPointer(0);
  const bool isClosed = piece.Boundary.empty();
  VisitPlaces(this->Places, this->AtPoints, InputWindingNumber(piece, this->Options, monitor),
    std::nullopt, monitor, { insideout::Stages::WindingNumbers, 0, 1 },
    [&](vtkIdType first, const std::vector<double>& values)
    {
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        double& sum = w[first + static_cast<vtkIdType>(i)];
        sum = isClosed ? insideout::SumOfClosed(sum + values[i]) : sum + values[i];
      }
    });
}

vtkSmartPointer<vtkDoubleArray> PiecesInTurn::Finish(insideout::Monitor& monitor)
{
  if (this->IsEmpty)
  {
    throw insideout::Error(
      insideout::ErrorCode::EmptySurface, "no piece of the surface has polygons with an area");
  }
  for (const insideout::CountedPiece& rest : this->Pieces.Rest())
  {
    this->Add(rest, monitor);
  }
  return this->W;
}
} // namespace vtkInsideOut

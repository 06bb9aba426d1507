// SPDX-License-Identifier: GPL-3.0-or-later
#include "Ranks/SurfaceChunks.h"

#include "Common/ScaledPoints.h"
#include "In/ReadCloud.h"
#include "In/ReadCurve.h"
#include "Ranks/Gather.h"
#include "Ranks/Together.h"
#include "WindingNumber/ClosePieces.h"

#include <vtkCellArray.h>
#include <vtkMultiProcessController.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>

namespace vtkInsideOut
{
using insideout::Id;
using insideout::Monitor;

namespace
{
// Limit of a broadcast: MPI counts its bytes in 32 bits.
constexpr std::size_t MostBytesAtOnce = std::size_t(1) << 30;

template <typename Value>
void BroadcastValues(std::vector<Value>& values, vtkMultiProcessController* together)
{
  auto* bytes = reinterpret_cast<unsigned char*>(values.data());
  const std::size_t size = values.size() * sizeof(Value);
  for (std::size_t first = 0; first < size; first += MostBytesAtOnce)
  {
    together->Broadcast(
      bytes + first, static_cast<vtkIdType>(std::min(MostBytesAtOnce, size - first)), 0);
  }
}
} // namespace

SurfaceChunks::SurfaceChunks(vtkPolyData* surface, const SurfaceOptions& options, Monitor& monitor,
  std::vector<std::string>& warnings)
  : Options(options)
  , WholeSurface(std::make_unique<const InputWindingNumber>(surface, options, monitor, warnings))
{
}

SurfaceChunks::SurfaceChunks(vtkPolyData* piece, const SurfaceOptions& options, Id facetsAtOnce,
  vtkMultiProcessController* together, Monitor& monitor, std::vector<std::string>& warnings)
  : Options(options)
  , Together(together)
{
  const vtkSmartPointer<vtkPolyData> gathered =
    Gather(piece, { options.NonParticipating, "FacetMultiplicity" }, { options.Areas }, together);
  int isCut = gathered->GetNumberOfPolys() + gathered->GetNumberOfStrips() > facetsAtOnce;
  together->Broadcast(&isCut, 1, 0);
  if (!isCut)
  {
    together->Broadcast(gathered, 0);
    vtkInsideOut::DoTogether(together,
      [&]()
      {
        this->WholeSurface =
          std::make_unique<const InputWindingNumber>(gathered, options, monitor, warnings);
      });
    return;
  }
  vtkInsideOut::DoTogether(together,
    [&]()
    {
      if (this->IsFirstRank())
      {
        this->Cut(gathered, facetsAtOnce, monitor, warnings);
      }
    });
  std::array<int, 3> known = { this->NumberOfPieces, this->NumberOfTurns, this->Exponent };
  together->Broadcast(known.data(), static_cast<vtkIdType>(known.size()), 0);
  this->NumberOfPieces = known[0];
  this->NumberOfTurns = known[1];
  this->Exponent = known[2];
}

bool SurfaceChunks::IsFirstRank() const
{
  return this->Together->GetLocalProcessId() == 0;
}

void SurfaceChunks::DoTogether(const std::function<void()>& work) const
{
  vtkInsideOut::DoTogether(this->Together, work);
}

void SurfaceChunks::Cut(
  vtkPolyData* surface, Id facetsAtOnce, Monitor& monitor, std::vector<std::string>& warnings)
{
  const Facets facets(surface, this->Options, monitor, warnings);
  const insideout::FacetComplex& whole = facets.Surface;
  this->Exponent = insideout::LargestExponent(whole.Points);
  insideout::ClosePieces pieces;
  for (insideout::CountedPiece& cut : CutIntoPieces(whole, facetsAtOnce, monitor))
  {
    SurfaceChunk piece = { std::move(cut), {} };
    if (this->Options.Distance)
    {
      for (const Id facet : piece.WholeFacets)
      {
        piece.Cells.push_back(facets.Cells[facet]);
      }
    }
    pieces.Close(piece.Surface);
    this->Pieces.push_back(std::move(piece));
  }
  this->NumberOfPieces = static_cast<int>(this->Pieces.size());
  for (insideout::CountedPiece& rest : pieces.Rest())
  {
    this->Pieces.push_back({ std::move(rest), {} });
  }
  this->NumberOfTurns = static_cast<int>(this->Pieces.size());
}

/** Broadcast from the first rank to all. */
void SurfaceChunks::Broadcast(SurfaceChunk& piece) const
{
  insideout::FacetComplex& surface = piece.Surface;
  std::vector<vtkIdType> sizes = { static_cast<vtkIdType>(surface.Points.size()),
    static_cast<vtkIdType>(surface.Facets.size()), static_cast<vtkIdType>(piece.WholeFacets.size()),
    static_cast<vtkIdType>(piece.Cells.size()), static_cast<vtkIdType>(piece.Boundary.size()) };
  BroadcastValues(sizes, this->Together);
  vtkInsideOut::DoTogether(this->Together,
    [&]()
    {
      surface.Points.resize(sizes[0]);
      surface.Facets.resize(sizes[1]);
      surface.Multiplicity.resize(sizes[1]);
      piece.WholeFacets.resize(sizes[2]);
      piece.Cells.resize(sizes[3]);
      piece.Boundary.resize(sizes[4]);
    });
  BroadcastValues(surface.Points, this->Together);
  BroadcastValues(surface.Facets, this->Together);
  BroadcastValues(surface.Multiplicity, this->Together);
  BroadcastValues(piece.WholeFacets, this->Together);
  BroadcastValues(piece.Cells, this->Together);
  BroadcastValues(piece.Boundary, this->Together);
}

void SurfaceChunks::TakeTurns(int turns, const char* stage, const Maker& make, const Visitor& visit)
{
  for (int turn = 0; turn < turns; ++turn)
  {
    const bool isLast = turn + 1 == turns;
    const insideout::ProgressRange progress = { stage, static_cast<double>(turn) / turns,
      static_cast<double>(turn + 1) / turns };
    if (this->WholeSurface)
    {
      vtkInsideOut::DoTogether(this->Together,
        [&]() {
          visit({ *this->WholeSurface, true, true, false, progress });
        });
      continue;
    }
    SurfaceChunk received;
    SurfaceChunk& piece = this->IsFirstRank() ? this->Pieces[turn] : received;
    this->Broadcast(piece);
    vtkInsideOut::DoTogether(this->Together,
      [&]() {
        visit({ make(piece), turn == 0, isLast, piece.Boundary.empty(), progress });
      });
  }
}

void SurfaceChunks::TakeTurns(Monitor& monitor, const Visitor& visit)
{
  const Maker make = [&](const SurfaceChunk& piece)
  { return InputWindingNumber(piece, this->Options, monitor); };
  this->TakeTurns(this->NumberOfTurns, insideout::Stages::WindingNumbers, make, visit);
}

void SurfaceChunks::TakeTurnsForDistances(const Visitor& visit)
{
  const Maker make = [&](const SurfaceChunk& piece)
  { return InputWindingNumber(piece, this->Exponent); };
  this->TakeTurns(this->NumberOfPieces, insideout::Stages::Distances, make, visit);
}
} // namespace vtkInsideOut

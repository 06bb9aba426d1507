// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/FacetConstraint.h"

#include "Common/LoopProgress.h"
#include "Common/Stages.h"

#include <algorithm>

namespace insideout
{
namespace
{
bool IsInside(const GreedyLabels& labels, Id cell)
{
  return cell != None && labels.IsInside(cell);
}

/** The cell to be labelled inside for a piece; None where neither may be. */
Id BetterCell(const GreedyLabels& labels, const FacetPiece& piece)
{
  Id best = None;
  for (const Id cell : { std::min(piece.First, piece.Second), std::max(piece.First, piece.Second) })
  {
    if (cell != None && labels.MayBeInside(cell) &&
      (best == None || labels.W(cell) > labels.W(best)))
    {
      best = cell;
    }
  }
  return best;
}
} // namespace

std::vector<FacetPiece> PiecesOfFacets(
  const TetrahedralMesh& mesh, const std::vector<unsigned char>& chosen)
{
  std::vector<FacetPiece> pieces;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id facet = mesh.Facets[cell][k];
      const Id beyond = mesh.Neighbors[cell][k];
      if (facet != None && (beyond == None || beyond > cell) && (chosen.empty() || chosen[facet]))
      {
        pieces.push_back({ cell, beyond, facet });
      }
    }
  }
  return pieces;
}

FacetConstraint::FacetConstraint(const std::vector<FacetPiece>& pieces, Id cells)
  : Pieces(pieces)
  , Offsets(static_cast<std::size_t>(cells) + 2, 0)
{
  const auto forEachSide = [&](auto visit)
  {
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      for (const Id cell : { pieces[p].First, pieces[p].Second })
      {
        if (cell != None)
        {
          visit(static_cast<std::size_t>(cell), static_cast<Id>(p));
        }
      }
    }
  };
  // Counted one cell ahead, so that filling moves each offset to where it belongs.
  forEachSide([&](std::size_t cell, Id) { ++this->Offsets[cell + 2]; });
  for (std::size_t i = 2; i < this->Offsets.size(); ++i)
  {
    this->Offsets[i] += this->Offsets[i - 1];
  }
  this->PiecesOfCells.resize(this->Offsets.back());
  forEachSide(
    [&](std::size_t cell, Id piece) { this->PiecesOfCells[this->Offsets[cell + 1]++] = piece; });
}

bool FacetConstraint::Allows(const GreedyLabels& labels, Id cell)
{
  if (!labels.IsInside(cell))
  {
    return true;
  }
  for (std::size_t k = this->Offsets[cell]; k < this->Offsets[cell + 1]; ++k)
  {
    const FacetPiece& piece = this->Pieces[this->PiecesOfCells[k]];
    if (!IsInside(labels, piece.First == cell ? piece.Second : piece.First))
    {
      return false;
    }
  }
  return true;
}

FacetConstraint::Outcome FacetConstraint::Satisfy(
  GreedyLabels& labels, Monitor& monitor, double begin, double end)
{
  const LoopProgress progress(monitor, { Stages::Segmenting, begin, end }, this->Pieces.size());
  Outcome outcome;
  labels.Add(*this);
  for (std::size_t p = 0; p < this->Pieces.size(); ++p)
  {
    progress.Check(p);
    const FacetPiece& piece = this->Pieces[p];
    if (IsInside(labels, piece.First) || IsInside(labels, piece.Second))
    {
      continue;
    }
    const Id cell = BetterCell(labels, piece);
    if (cell == None)
    {
      outcome.Unsatisfied.push_back(static_cast<Id>(p));
      continue;
    }
    labels.Force(cell);
    labels.ImproveAround({ cell });
    ++outcome.Forced;
  }
  return outcome;
}
} // namespace insideout

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

/** The cell to be labelled inside for a piece; None if neither may be. */
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
  , PiecesOfCells(static_cast<std::size_t>(cells),
      [&](auto visit)
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
      })
{
}

bool FacetConstraint::Allows(const GreedyLabels& labels, Id cell)
{
  const auto pieces = this->PiecesOfCells[cell];
  return !labels.IsInside(cell) ||
    std::all_of(pieces.begin(), pieces.end(),
      [&](Id p)
      {
        const FacetPiece& piece = this->Pieces[p];
        return IsInside(labels, piece.First == cell ? piece.Second : piece.First);
      });
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

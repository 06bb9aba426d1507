// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SurfaceMesh.h"

#include "Common/SortUniquely.h"

#include <algorithm>

namespace insideout
{
SurfaceMesh::SurfaceMesh(const std::vector<SurfacePiece>& pieces)
{
  for (const SurfacePiece& piece : pieces)
  {
    this->Add(piece);
  }
}

const std::vector<Id>& SurfaceMesh::At(Id point) const
{
  static const std::vector<Id> none;
  return point < static_cast<Id>(this->AtPoints.size()) ? this->AtPoints[point] : none;
}

std::vector<Id> SurfaceMesh::AtEdge(Id u, Id v) const
{
  std::vector<Id> found;
  for (const Id piece : this->At(u))
  {
    const Triangle& corners = this->Pieces[piece].Corners;
    if (std::find(corners.begin(), corners.end(), v) != corners.end())
    {
      found.push_back(piece);
    }
  }
  return found;
}

std::vector<SurfacePiece> SurfaceMesh::All() const
{
  std::vector<SurfacePiece> all;
  std::copy_if(this->Pieces.begin(), this->Pieces.end(), std::back_inserter(all),
    [](const SurfacePiece& piece) { return piece.Corners[0] != None; });
  return all;
}

std::vector<Edge> SurfaceMesh::Edges() const
{
  std::vector<Edge> edges;
  for (const SurfacePiece& piece : this->All())
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.push_back(EdgeBetween(piece.Corners[i], piece.Corners[(i + 1) % 3]));
    }
  }
  SortUniquely(edges);
  return edges;
}

void SurfaceMesh::Replace(const std::vector<Id>& gone, const std::vector<SurfacePiece>& fresh)
{
  ++this->Changes;
  const std::vector<Id> removed = gone; // may be a list of this mesh
  for (const Id piece : removed)
  {
    this->Remove(piece);
  }
  for (const SurfacePiece& piece : fresh)
  {
    this->Add(piece);
  }
}

void SurfaceMesh::Add(const SurfacePiece& piece)
{
  Id id = this->NumberOfPieces();
  if (this->Removed.empty())
  {
    this->Pieces.push_back(piece);
  }
  else
  {
    id = this->Removed.back();
    this->Removed.pop_back();
    this->Pieces[id] = piece;
  }
  for (const Id corner : piece.Corners)
  {
    if (corner >= static_cast<Id>(this->AtPoints.size()))
    {
      this->AtPoints.resize(corner + 1);
      this->ChangeAt.resize(corner + 1, 0);
    }
    this->AtPoints[corner].push_back(id);
    this->ChangeAt[corner] = this->Changes;
  }
}

void SurfaceMesh::Remove(Id piece)
{
  for (const Id corner : this->Pieces[piece].Corners)
  {
    std::vector<Id>& there = this->AtPoints[corner];
    there.erase(std::find(there.begin(), there.end(), piece));
    this->ChangeAt[corner] = this->Changes;
  }
  this->Pieces[piece].Corners[0] = None;
  this->Removed.push_back(piece);
}
} // namespace insideout

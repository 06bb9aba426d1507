// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/BoundaryPieces.h"

#include "Resolve/MeetBeyondSharedCorners.h"

#include <algorithm>
#include <utility>

namespace insideout
{
namespace
{
Box BoxOf(const SurfacePiece& piece)
{
  const auto& [a, b, c] = piece.Places;
  Box box = { a, a };
  box.Add(b);
  box.Add(c);
  return box;
}

Box BoxOf(const std::vector<SurfacePiece>& pieces)
{
  Box box = Box::Empty();
  for (const SurfacePiece& piece : pieces)
  {
    box.Add(BoxOf(piece));
  }
  return box;
}

Triangle KeyOf(const SurfacePiece& piece)
{
  return SortedTriangle(piece.Corners).Points;
}

/** Whether two pieces meet; includes identical pieces seen from different sides. */
bool Meet(const SurfacePiece& a, const SurfacePiece& b)
{
  return KeyOf(a) == KeyOf(b) || MeetBeyondSharedCorners(a.Corners, a.Places, b.Corners, b.Places);
}
} // namespace

BoundaryPieces::BoundaryPieces(const std::vector<SurfacePiece>& pieces)
  : Octree(BoxOf(pieces))
{
  for (const SurfacePiece& piece : pieces)
  {
    this->Add(piece);
  }
}

void BoundaryPieces::Add(const SurfacePiece& piece)
{
  Id id = static_cast<Id>(this->Pieces.size());
  if (this->Unused.empty())
  {
    this->Pieces.push_back(piece);
  }
  else
  {
    id = this->Unused.back();
    this->Unused.pop_back();
    this->Pieces[id] = piece;
  }
  this->Ids.emplace(KeyOf(piece), id);
  this->Octree.Insert(id, BoxOf(piece));
}

bool BoundaryPieces::StayApart(
  const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh) const
{
  std::vector<Triangle> goneKeys;
  for (const SurfacePiece& piece : gone)
  {
    goneKeys.push_back(KeyOf(piece));
  }
  std::vector<std::pair<const SurfacePiece*, Box>> others;
  this->Octree.Visit(BoxOf(fresh),
    [&](Id id)
    {
      const SurfacePiece& piece = this->Pieces[id];
      if (std::find(goneKeys.begin(), goneKeys.end(), KeyOf(piece)) == goneKeys.end())
      {
        others.push_back({ &piece, BoxOf(piece) });
      }
    });
  for (const SurfacePiece& piece : fresh)
  {
    const Box box = BoxOf(piece);
    if (std::any_of(others.begin(), others.end(),
          [&](const auto& other) { return box.Meets(other.second) && Meet(piece, *other.first); }))
    {
      return false;
    }
    others.push_back({ &piece, box });
  }
  return true;
}

void BoundaryPieces::Replace(
  const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh)
{
  for (const SurfacePiece& piece : gone)
  {
    const auto found = this->Ids.find(KeyOf(piece));
    this->Octree.Remove(found->second, BoxOf(this->Pieces[found->second]));
    this->Unused.push_back(found->second);
    this->Ids.erase(found);
  }
  for (const SurfacePiece& piece : fresh)
  {
    this->Add(piece);
  }
}
} // namespace insideout

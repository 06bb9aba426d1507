// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/SortUniquely.h"
#include "Exact/FlippableMesh.h"
#include "Exact/SegmentTable.h"

#include <algorithm>
#include <array>
#include <vector>

namespace insideout
{
/** A face between cells that give way to a cone, with the cone's apex: it stays. */
struct SurfaceFace
{
  Id A;
  Id B;
  Id Facet;
};

/** The faces around cells that give way to a cone over them: what is on them stays. */
class CavityWall
{
public:
  void Clear()
  {
    this->Corners.clear();
    this->Edges.clear();
  }

  /** Add the face of a cell opposite to corner k. */
  void Add(const Tetrahedron& cell, int k)
  {
    for (int j = 0; j < 3; ++j)
    {
      const Id u = cell[FaceSeenFrom[k][j]];
      const Id v = cell[FaceSeenFrom[k][(j + 1) % 3]];
      this->Edges.push_back({ { std::min(u, v), std::max(u, v) } });
      this->Corners.push_back(u);
    }
  }

  /** All faces are there: from now on it can be asked. */
  void Close()
  {
    SortUniquely(this->Corners);
    SortUniquely(this->Edges);
  }

  bool HasEdge(Id u, Id v) const
  {
    return std::binary_search(this->Edges.begin(), this->Edges.end(),
      std::array<Id, 2>{ { std::min(u, v), std::max(u, v) } });
  }

  /** Whether all corners of a cell but the apex, and the segments between them, are on the wall. */
  bool Keeps(const Tetrahedron& cell, Id apex, const SegmentTable& segments) const
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id u = cell[k];
      if (u == apex)
      {
        continue;
      }
      if (!std::binary_search(this->Corners.begin(), this->Corners.end(), u))
      {
        return false;
      }
      for (int j = 0; j < k; ++j)
      {
        const Id v = cell[j];
        if (v != apex && !this->HasEdge(u, v) && segments.Find(u, v) != None)
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  std::vector<Id> Corners;
  std::vector<std::array<Id, 2>> Edges;
};
} // namespace insideout

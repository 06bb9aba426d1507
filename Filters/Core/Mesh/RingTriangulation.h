// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Mesh/MeshCell.h"

namespace insideout
{
/**
 * The best triangulation of the points around an edge, by dynamic programming (Klincsek 1980,
 * Minimal triangulations of polygonal domains). Each of its triangles becomes two cells, one at
 * each end of the edge; the edge is removed.
 *
 * @tparam Value of a triangulation or a part of it
 */
template <class Value>
class RingTriangulation
{
public:
  /**
   * @param[in] measure has the values Edge (of an edge of the ring) and Impossible; IsBetter(a, b);
   * IsEnough(a), required of every part; Join(a, b), the value of two parts; OfTriangle(i, j, k)
   * and OfDiagonal(i, j), for points of the ring
   * @param[in] first the triangulation is of this and all later points
   * @return whether there is a triangulation that is good enough
   */
  template <class Measure>
  bool Find(const Measure& measure, int first, int size)
  {
    this->Size = size;
    this->Best.assign(static_cast<std::size_t>(size) * size, measure.Impossible);
    this->Middle.assign(static_cast<std::size_t>(size) * size, -1);
    for (int i = first; i + 1 < size; ++i)
    {
      this->Best[i * size + i + 1] = measure.Edge;
    }
    for (int length = 2; length < size - first; ++length)
    {
      for (int i = first; i + length < size; ++i)
      {
        this->FindPart(measure, i, i + length);
      }
    }
    return measure.IsEnough(this->Best[first * size + size - 1]);
  }

  /** Append the cells of the part from point i to point j of the result. */
  void AppendCells(const EdgeRing& ring, int i, int j, std::vector<Tetrahedron>& fresh) const
  {
    if (j > i + 1)
    {
      const int k = this->Middle[i * this->Size + j];
      AppendPair(ring, i, k, j, fresh);
      this->AppendCells(ring, i, k, fresh);
      this->AppendCells(ring, k, j, fresh);
    }
  }

  /** Append the two cells of a triangle. */
  static void AppendPair(const EdgeRing& ring, int i, int j, int k, std::vector<Tetrahedron>& fresh)
  {
    const std::vector<Id>& p = ring.Points;
    fresh.push_back({ { p[i], p[j], p[k], ring.V } });
    fresh.push_back({ { p[j], p[i], p[k], ring.U } });
  }

private:
  /** The best triangulation from point i to point j, with the diagonal between them. */
  template <class Measure>
  void FindPart(const Measure& measure, int i, int j)
  {
    Value& best = this->Best[i * this->Size + j];
    int& middle = this->Middle[i * this->Size + j];
    for (int k = i + 1; k < j; ++k)
    {
      const Value parts =
        measure.Join(this->Best[i * this->Size + k], this->Best[k * this->Size + j]);
      if (measure.IsEnough(parts) && measure.IsBetter(parts, best))
      {
        const Value value = measure.Join(parts, measure.OfTriangle(i, k, j));
        if (measure.IsBetter(value, best) && measure.IsEnough(value))
        {
          best = value;
          middle = k;
        }
      }
    }
    if (middle >= 0)
    {
      best = measure.Join(best, measure.OfDiagonal(i, j));
    }
  }

  int Size = 0;
  std::vector<Value> Best; ///< best value from point i to point j, at i * Size + j
  std::vector<int> Middle; ///< its third corner of the triangle at the diagonal
};
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/ChainFacets.h"

namespace insideout
{
/**
 * A grid of cubes over a closed chain, with the chain's winding number at one reference place in
 * each cube, and the facets that may meet it.
 *
 * References stand in columns. Along a column the winding number is carried from 0 outside through
 * one facet after the other. If a reference lies in a facet's plane, or doubles do not decide which
 * column meets a facet, all references are moved together. This fails only for chains made to
 * prevent it.
 *
 * There are about twice as many cubes as facets at most, so that time and memory grow with the
 * number of facets.
 */
class ReferenceGrid
{
public:
  /** @param[in] facets at least one; has to live as long as this object */
  explicit ReferenceGrid(const ChainFacets& facets);

  /**
   * Carry winding numbers, and hand out facets, to cubes that are wanted.
   *
   * @param[in] isWanted one per cube, or empty for all
   * @return false if no references work: the object is then unusable
   */
  bool Fill(const std::vector<char>& isWanted);

  std::size_t NumberOfCubes() const { return this->First.size() - 1; }

  /** None if the place is outside the chain's box. */
  std::ptrdiff_t CubeAt(const Point& place) const
  {
    std::size_t cube = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double i = (place[axis] - this->Origin[axis]) * this->CubesPerLength;
      if (!(i >= 0 && i < this->Cubes[axis]))
      {
        return None;
      }
      cube = cube * static_cast<std::size_t>(this->Cubes[axis]) + static_cast<std::size_t>(i);
    }
    return static_cast<std::ptrdiff_t>(cube);
  }

  /** Slightly larger than the region whose places CubeAt maps to the cube. */
  Box BoxOf(std::size_t cube) const;
  Point ReferenceOf(std::size_t cube) const;
  int ValueAtReference(std::size_t cube) const { return this->Value[cube]; }

  /** Facets that may meet the cube, each with the reference's side of it, in no certain order. */
  const SidedFacet* FirstFacet(std::size_t cube) const
  {
    return this->Entries.data() + this->First[cube];
  }
  const SidedFacet* LastFacet(std::size_t cube) const
  {
    return this->Entries.data() + this->First[cube + 1];
  }

private:
  struct Range
  {
    std::array<int, 3> First;
    std::array<int, 3> Last; ///< included
  };

  void ChooseCubes();
  std::size_t Index(int i, int j, int k) const
  {
    return this->ColumnOf(i, j) * static_cast<std::size_t>(this->Cubes[2]) +
      static_cast<std::size_t>(k);
  }
  std::size_t ColumnOf(int i, int j) const
  {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(this->Cubes[1]) +
      static_cast<std::size_t>(j);
  }
  double Coordinate(int axis, int i) const
  {
    return this->Origin[axis] + (i + this->Offset[axis]) * this->Length;
  }
  Range RangeOf(Id facet) const;
  template <typename Visit>
  bool ForCubesOf(Id facet, const std::vector<char>& isWanted, const Visit& visit) const;
  bool AddRises(Id facet, const std::vector<char>& isWantedColumn);
  std::vector<char> ColumnsOf(const std::vector<char>& isWanted) const;
  bool Try(const std::vector<char>& isWanted);

  const ChainFacets& Facets;
  Point Origin;
  double Length;
  double CubesPerLength;
  std::array<int, 3> Cubes;
  Point Offset; ///< of the references, from 0 to 1 within each cube
  std::vector<int> Value;
  std::vector<std::uint32_t> First; ///< start index per cube, and the end
  std::vector<SidedFacet> Entries;
};
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "Files/OutputFile.h"
#include "Files/SolidFile.h"

/** Shared by the writers of the solvers' formats; call them through WriteSolid. */
namespace insideout
{
/** The writers. All ids of the solid are in range, and all coordinates finite. @{ */
void WriteMsh(OutputFile& file, const SolidMesh& solid, MshVersion version);
void WriteInp(OutputFile& file, const SolidMesh& solid);
void WriteMedit(OutputFile& file, const SolidMesh& solid);
/** @} */

/** The point as read back from the 20 characters per number of .inp. */
Point PointInInp(Point point);

/** The shapes of the cells of a solid. */
enum class CellShape
{
  Tetrahedron,
  Pyramid,
  Prism
};

inline CellShape ShapeOfCell(const SolidMesh& solid, std::size_t cell)
{
  return cell < solid.Cells.size()                      ? CellShape::Tetrahedron
    : cell < solid.Cells.size() + solid.Pyramids.size() ? CellShape::Pyramid
                                                        : CellShape::Prism;
}

/** The points of a cell or a face: corners, then midpoints if there are any. */
struct SolidNodes
{
  std::array<Id, 10> Ids;
  int Count;

  const Id* begin() const { return this->Ids.data(); }
  const Id* end() const { return this->Ids.data() + this->Count; }
};

/** The points of a cell in VTK's order, midpoints in that of TetrahedronEdges. */
SolidNodes NodesOf(const SolidMesh& solid, std::size_t cell);

/** The points of a face, counter-clockwise seen from outside its cell; midpoint k is between
 * corners k and k + 1. */
SolidNodes NodesOf(const SolidMesh& solid, const CellFace& face);

/** Whether cells have midpoints. */
inline bool IsQuadratic(const SolidMesh& solid)
{
  return !solid.Midpoints.empty();
}

/** The cells or faces of each group. */
inline Buckets<Id> ByGroup(std::size_t groups, const std::vector<Id>& groupOf)
{
  return Buckets<Id>(groups,
    [&groupOf](auto visit)
    {
      for (std::size_t e = 0; e < groupOf.size(); ++e)
      {
        visit(static_cast<std::size_t>(groupOf[e]), static_cast<Id>(e));
      }
    });
}

/** A blank and the file's number for each of the points. */
inline void WriteNumbers(OutputFile& file, const SolidNodes& nodes)
{
  for (const Id point : nodes)
  {
    file.Text(" ");
    file.Decimal(std::int64_t(point) + 1);
  }
}

/** The coordinates, separated by blanks. */
inline void WriteCoordinates(OutputFile& file, const Point& point)
{
  file.Decimal(point[0]);
  file.Text(" ");
  file.Decimal(point[1]);
  file.Text(" ");
  file.Decimal(point[2]);
}
} // namespace insideout

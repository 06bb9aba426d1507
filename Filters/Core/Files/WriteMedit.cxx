// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/GroupNames.h"
#include "Files/SolidFaces.h"
#include "Files/SolidWriters.h"

#include <algorithm>
#include <string>

// The format: Frey, MEDIT: An interactive mesh visualization software (2001); for quadratic cells,
// and the sections on the order of their points, Marechal, libMeshb.

namespace insideout
{
namespace
{
/** Comments with the group that each number stands for. */
void WriteNames(OutputFile& file, const char* what, const std::vector<SolidGroup>& groups)
{
  for (const SolidGroup& group : groups)
  {
    file.Text(std::string("# ") + what + " " + std::to_string(group.Number) + ": " +
      PrintableText(group.Name) + "\n");
  }
}

/** Positions of an element's points, by twice their barycentric coordinates: corners, then
 * midpoints of edges. */
template <std::size_t Edges>
void WriteOrdering(OutputFile& file, const char* section, std::size_t corners,
  const std::array<std::array<int, 2>, Edges>& edges)
{
  file.Text(std::string(section) + "\n" + std::to_string(corners + Edges) + "\n");
  const auto writePlace = [&file, corners](std::size_t one, std::size_t other)
  {
    for (std::size_t k = 0; k < corners; ++k)
    {
      file.Text(k > 0 ? " " : "");
      file.Decimal(int(k == one) + int(k == other));
    }
    file.Text("\n");
  };
  for (std::size_t k = 0; k < corners; ++k)
  {
    writePlace(k, k);
  }
  for (const std::array<int, 2>& edge : edges)
  {
    writePlace(static_cast<std::size_t>(edge[0]), static_cast<std::size_t>(edge[1]));
  }
}

/** The points, and the number of the group. */
void WriteElement(OutputFile& file, const SolidNodes& nodes, const SolidGroup& group)
{
  WriteNumbers(file, nodes);
  file.Text(" ");
  file.Decimal(group.Number);
  file.Text("\n");
}
} // namespace

void WriteMedit(OutputFile& file, const SolidMesh& solid)
{
  file.Text("MeshVersionFormatted 2\n"); // of type double
  file.Text("# Written by InsideOut\n");
  WriteNames(file, "Triangles with reference", solid.Tags);
  WriteNames(file, "Tetrahedra with reference", solid.Regions);
  file.Text("Dimension\n3\nVertices\n" + std::to_string(solid.Points.size()) + "\n");
  for (const Point& point : solid.Points)
  {
    WriteCoordinates(file, point);
    file.Text(" 0\n");
  }
  constexpr std::array<std::array<int, 2>, 3> triangleEdges = { { { { 0, 1 } }, { { 1, 2 } },
    { { 2, 0 } } } };
  if (IsQuadratic(solid))
  {
    WriteOrdering(file, "TrianglesP2Ordering", 3, triangleEdges);
    WriteOrdering(file, "TetrahedraP2Ordering", 4, TetrahedronEdges);
  }
  const std::string order = IsQuadratic(solid) ? "P2\n" : "\n";
  const auto writeFaces = [&](const std::string& section, bool areQuads)
  {
    const auto isWritten = [&](const CellFace& face) { return IsQuad(solid, face) == areQuads; };
    const auto count = std::count_if(solid.Faces.begin(), solid.Faces.end(), isWritten);
    file.Text(count > 0 || !areQuads ? section + std::to_string(count) + "\n" : "");
    for (std::size_t f = 0; f < solid.Faces.size(); ++f)
    {
      if (isWritten(solid.Faces[f]))
      {
        WriteElement(file, NodesOf(solid, solid.Faces[f]), solid.Tags[solid.TagOfFace[f]]);
      }
    }
  };
  writeFaces("Triangles" + order, false);
  writeFaces("Quadrilaterals\n", true);
  file.Text("Tetrahedra" + order + std::to_string(solid.Cells.size()) + "\n");
  for (std::size_t c = 0; c < solid.Cells.size(); ++c)
  {
    WriteElement(file, NodesOf(solid, c), solid.Regions[solid.RegionOfCell[c]]);
  }
  const auto writeLayers =
    [&](const char* section, CellShape shape, std::size_t first, std::size_t count)
  {
    file.Text(count > 0 ? section + ("\n" + std::to_string(count)) + "\n" : "");
    for (std::size_t c = first; c < first + count; ++c)
    {
      SolidNodes nodes = NodesOf(solid, c);
      if (shape == CellShape::Prism) // the first triangle is seen from within in this format
      {
        std::rotate(nodes.Ids.begin(), nodes.Ids.begin() + 3, nodes.Ids.begin() + 6);
      }
      WriteElement(file, nodes, solid.Regions[solid.RegionOfCell[c]]);
    }
  };
  const std::size_t pyramids = solid.Cells.size();
  writeLayers("Pyramids", CellShape::Pyramid, pyramids, solid.Pyramids.size());
  writeLayers("Prisms", CellShape::Prism, pyramids + solid.Pyramids.size(), solid.Prisms.size());
  file.Text("End\n");
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
// What solvers' files mean. Testing/Python/TestReadSolid.py reads those that other programs write.
#include "Files/SolidFile.h"

#include "Common/Error.h"
#include "Files/SolidWriters.h"
#include "Support/SolidSamples.h"
#include "Support/TemporaryFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace insideout;
using namespace solidsamples;
using testfiles::TemporaryFile;

namespace
{
SolidContent Read(const std::string& name, const std::string& content)
{
  const TemporaryFile file(name, content);
  Monitor monitor;
  return ReadSolid(file.Path, monitor);
}

SolidContent ReadBack(const SolidMesh& solid, const std::string& name, MshVersion version)
{
  const TemporaryFile file(name);
  Monitor monitor;
  WriteSolid(file.Path, solid, version, monitor);
  return ReadSolid(file.Path, monitor);
}

void ExpectError(const std::string& name, const std::string& content, const std::string& words)
{
  try
  {
    Read(name, content);
    ADD_FAILURE() << "no error: " << words;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::FileMalformed) << error.what();
    EXPECT_NE(std::string(error.what()).find(name + words), std::string::npos) << error.what();
  }
}

/** Number and name of the group of each element. */
template <typename Elements>
std::vector<std::pair<Id, std::string>> GroupsOf(const Elements& elements)
{
  std::vector<std::pair<Id, std::string>> groups;
  for (const Id group : elements.GroupOf)
  {
    groups.emplace_back(elements.Groups[group].Number, elements.Groups[group].Name);
  }
  return groups;
}

using Groups = std::vector<std::pair<Id, std::string>>;

std::string Msh22(const std::string& nodes, const std::string& elements)
{
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + nodes + "$EndNodes\n$Elements\n" +
    elements + "$EndElements\n";
}

const std::string FourNodes = "4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";

std::string Mesh(const std::string& sections)
{
  return "MeshVersionFormatted 2\nDimension 3\nVertices 5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
         "1 1 1 0\n" +
    sections;
}

const std::string InpNodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n5, 1, 1, 1\n";
} // namespace

TEST(ReadSolid, GivesBackWhatWasWritten)
{
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    const SolidMesh linear = RandomSolid(seed);
    const SolidMesh solid = seed % 2 == 0 ? Quadratic(linear) : linear;
    for (const auto& [name, version] :
      { std::make_pair("a.msh", MshVersion::Msh41), std::make_pair("a.msh", MshVersion::Msh22),
        std::make_pair("a.inp", MshVersion::Msh41), std::make_pair("a.mesh", MshVersion::Msh41) })
    {
      SCOPED_TRACE(name + std::to_string(seed));
      const SolidContent read = ReadBack(solid, name, version);
      EXPECT_EQ(read.Warnings, std::vector<std::string>());
      EXPECT_EQ(read.Points, solid.Points);
      EXPECT_EQ(read.Tetrahedra.Cells, solid.Cells);
      EXPECT_EQ(read.Tetrahedra.Midpoints, solid.Midpoints);
      Groups regions;
      for (const Id region : solid.RegionOfCell)
      {
        regions.emplace_back(solid.Regions[region].Number, solid.Regions[region].Name);
      }
      EXPECT_EQ(GroupsOf(read.Tetrahedra), regions);
      // Faces stand in surfaces in .inp files.
      std::vector<std::size_t> order(solid.Faces.size());
      std::iota(order.begin(), order.end(), 0);
      if (std::string(name) == "a.inp")
      {
        std::stable_sort(order.begin(), order.end(),
          [&solid](std::size_t f, std::size_t g)
          { return solid.TagOfFace[f] < solid.TagOfFace[g]; });
      }
      Groups tags;
      std::vector<Triangle> faces;
      for (const std::size_t f : order)
      {
        const SolidGroup& tag = solid.Tags[solid.TagOfFace[f]];
        tags.emplace_back(tag.Number, tag.Name);
        faces.push_back(FaceOf(solid.Cells[solid.Faces[f].Cell], solid.Faces[f].Face));
      }
      EXPECT_EQ(read.Triangles.Cells, faces);
      EXPECT_EQ(GroupsOf(read.Triangles), tags);
    }
  }
}

TEST(ReadSolid, TakesPointsAndElementsByTheirNumbers)
{
  const SolidContent msh = Read("a.msh",
    Msh22("4\n700 0 0 1\n-3 0 0 0\n9000000000 1 0 0\n12 0 1 0\n",
      "2\n8 4 2 1 1 12 -3 9000000000 700\n5 4 2 1 1 -3 9000000000 12 700\n"));
  EXPECT_EQ(msh.Points, (std::vector<Point>{ { 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 } }));
  EXPECT_EQ(msh.Tetrahedra.Cells, (std::vector<Tetrahedron>{ { 0, 3, 1, 2 }, { 1, 0, 3, 2 } }));
  // An element may come before its points there.
  const SolidContent inp = Read("a.inp", "*ELEMENT, TYPE=C3D4\n1, 4, 3, 2, 1\n" + InpNodes);
  EXPECT_EQ(inp.Tetrahedra.Cells, (std::vector<Tetrahedron>{ { 3, 2, 1, 0 } }));
}

TEST(ReadSolid, GroupsByEntitiesWhereThereIsNoPhysicalGroup)
{
  const std::string elements = "2\n1 4 2 0 7 1 2 3 4\n2 4 2 0 3 4 3 2 1\n";
  EXPECT_EQ(GroupsOf(Read("a.msh", Msh22(FourNodes, elements)).Tetrahedra),
    (Groups{ { 7, "" }, { 3, "" } }));
  // Those of no group are behind the last.
  const std::string some = "2\n1 4 2 0 7 1 2 3 4\n2 4 2 -3 3 4 3 2 1\n";
  EXPECT_EQ(
    GroupsOf(Read("a.msh", Msh22(FourNodes, some)).Tetrahedra), (Groups{ { 4, "" }, { 3, "" } }));
}

TEST(ReadSolid, TakesAnElementOfSeveralGroupsOnce)
{
  const std::string elements =
    "4\n1 4 2 8 1 1 2 3 4\n2 4 2 5 1 4 3 2 1\n3 4 2 6 1 1 2 3 4\n4 4 2 6 1 4 3 2 1\n";
  const SolidContent msh = Read("a.msh", Msh22(FourNodes, elements));
  EXPECT_EQ(msh.Tetrahedra.Cells, (std::vector<Tetrahedron>{ { 0, 1, 2, 3 }, { 3, 2, 1, 0 } }));
  EXPECT_EQ(GroupsOf(msh.Tetrahedra), (Groups{ { 8, "" }, { 5, "" } }));
}

TEST(ReadSolid, CountsGroupsWhoseNumbersAreTooLarge)
{
  const std::string elements = "2\n1 4 2 2000000000 1 1 2 3 4\n2 4 2 5 1 4 3 2 1\n";
  EXPECT_EQ(GroupsOf(Read("a.msh", Msh22(FourNodes, elements)).Tetrahedra),
    (Groups{ { 2, "" }, { 1, "" } }));
}

TEST(ReadSolid, CountsWhatIsNoTetrahedronOrTriangle)
{
  const std::string elements = "5\n1 15 2 0 1 1\n2 1 2 0 1 1 2\n3 3 2 0 1 1 2 3 4\n"
                               "4 5 2 0 1 1 2 3 4 1 2 3 4\n5 4 2 0 1 1 2 3 4\n";
  const SolidContent msh = Read("a.msh", Msh22(FourNodes, elements));
  ASSERT_EQ(msh.Warnings.size(), 1u);
  EXPECT_NE(msh.Warnings[0].find("left out: 1 hexahedra, 1 quadrangles"), std::string::npos)
    << msh.Warnings[0];
  const SolidContent inp = Read("a.inp",
    InpNodes + "*ELEMENT, TYPE=C3D20\n1, 1, 2, 3, 4, 5,\n1, 2, 3\n2, 1,\n2\n" +
      "*ELEMENT, TYPE=T3D2\n3, 1, 2\n*Element, type=c3d4\n4, 1, 2, 3, 4\n");
  ASSERT_EQ(inp.Warnings.size(), 1u);
  EXPECT_NE(inp.Warnings[0].find("left out: 2 elements of type C3D20"), std::string::npos)
    << inp.Warnings[0];
  const SolidContent mesh = Read("a.mesh",
    Mesh("Edges\n1\n1 2 0\nHexahedra\n1\n1 2 3 4 5 1 2 3 0\nTetrahedra\n1\n1 2 3 4 0\nEnd\n"));
  ASSERT_EQ(mesh.Warnings.size(), 1u);
  EXPECT_NE(mesh.Warnings[0].find("left out: 1 hexahedra"), std::string::npos) << mesh.Warnings[0];
  ExpectError("a.mesh", Mesh("Hexahedra\n1\n1 2 3 4 5 1 2 3 0\nEnd\n"),
    ": holds no tetrahedra and no triangles");
}

TEST(ReadSolid, TakesTrianglesAloneAsASolidInAPlane)
{
  const SolidContent msh = Read("a.msh", Msh22(FourNodes, "1\n1 2 2 0 6 1 2 3\n"));
  EXPECT_TRUE(msh.Tetrahedra.Cells.empty());
  EXPECT_EQ(msh.Triangles.Cells, (std::vector<Triangle>{ { 0, 1, 2 } }));
  const SolidContent inp = Read("a.inp",
    "*NODE\n1, 0\n2, 2,\n3, , 2\n4, 1\n5, 1, 1\n6, 0, 1.\n*ELEMENT, TYPE=CPS6, ELSET=plate\n" +
      std::string("1, 1, 2, 3, 4,\n5, 6\n"));
  EXPECT_EQ(inp.Points[2], (Point{ { 0, 2, 0 } }));
  EXPECT_EQ(inp.Triangles.Midpoints, (std::vector<std::array<Id, 3>>{ { { 3, 4, 5 } } }));
  EXPECT_EQ(GroupsOf(inp.Triangles), (Groups{ { 1, "plate" } }));
  const SolidContent mesh = Read("a.mesh",
    "MeshVersionFormatted 1\nDimension\n2\nVertices\n3\n0 0 1\n1 0 1\n0 1 1\nTriangles\n1\n1 2 3 "
    "8\nEnd");
  EXPECT_EQ(mesh.Points[1], (Point{ { 1, 0, 0 } }));
  EXPECT_EQ(GroupsOf(mesh.Triangles), (Groups{ { 8, "" } }));
}

TEST(ReadSolid, DropsMidpointsWhereOthersHaveNone)
{
  const std::string nodes = "10\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 0\n6 0 0 0\n7 0 0 0\n"
                            "8 0 0 0\n9 0 0 0\n10 0 0 0\n";
  const SolidContent msh =
    Read("a.msh", Msh22(nodes, "2\n1 11 2 0 1 1 2 3 4 5 6 7 8 9 10\n2 4 2 0 1 2 1 3 4\n"));
  EXPECT_EQ(msh.Tetrahedra.Cells.size(), 2u);
  EXPECT_TRUE(msh.Tetrahedra.Midpoints.empty());
  ASSERT_EQ(msh.Warnings.size(), 1u);
  EXPECT_NE(msh.Warnings[0].find("1 of 2 cells are quadratic"), std::string::npos);
}

TEST(ReadSolid, OrdersMidpointsAsMeditSays)
{
  // The last two the other way round, and the middle of corners 1 and 2 first.
  const std::string order = "TetrahedraP2Ordering\n10\n2 0 0 0\n0 2 0 0\n0 0 2 0\n0 0 0 2\n"
                            "1 1 0 0\n0 1 1 0\n1 0 1 0\n1 0 0 1\n0 0 1 1\n0 1 0 1\n";
  const std::string cells = "TetrahedraP2\n1\n1 2 3 4 1 2 3 4 5 1 0\n";
  const std::string end = "End\n";
  EXPECT_EQ(Read("a.mesh", Mesh(cells + end)).Tetrahedra.Midpoints[0],
    (std::array<Id, 6>{ { 0, 1, 2, 3, 4, 0 } }));
  EXPECT_EQ(Read("a.mesh", Mesh(cells + order + end)).Tetrahedra.Midpoints[0],
    (std::array<Id, 6>{ { 0, 1, 2, 3, 0, 4 } }));
  ExpectError("a.mesh",
    Mesh("TrianglesP2Ordering\n6\n2 0 0\n0 2 0\n0 0 2\n1 1 0\n1 1 0\n1 0 1\n" + cells + end),
    ", line 16: the order of an element's points has one of them twice");
}

TEST(ReadSolid, FindsGroupsInTheSetsOfInp)
{
  const std::string cells = "*ELEMENT, TYPE=C3D4, ELSET=all\n1, 1, 2, 3, 4\n2, 2, 3, 4, 5\n"
                            "3, 2, 3, 4, 5\n";
  EXPECT_EQ(GroupsOf(Read("a.inp", InpNodes + cells).Tetrahedra),
    (Groups{ { 1, "all" }, { 1, "all" }, { 1, "all" } }));
  // Lists that have each cell once say more.
  EXPECT_EQ(GroupsOf(Read("a.inp",
              InpNodes + cells + "*ELSET, ELSET=\"left part\"\n2\n*ELSET, " +
                "ELSET=right, GENERATE\n1, 3, 2\n")
                       .Tetrahedra),
    (Groups{ { 2, "right" }, { 1, "left part" }, { 2, "right" } }));
  // Others do not.
  EXPECT_EQ(GroupsOf(Read("a.inp", InpNodes + cells + "*ELSET, ELSET=some\n2\n").Tetrahedra),
    (Groups{ { 1, "all" }, { 1, "all" }, { 1, "all" } }));
}

TEST(ReadSolid, MakesTrianglesOfTheSurfacesOfInp)
{
  const SolidContent inp = Read("a.inp",
    InpNodes + "*ELEMENT, TYPE=C3D4, ELSET=Part\n1, 1, 2, 3, 4\n2, 5, 3, 2, 4\n" +
      "*ELSET, ELSET=low, INTERNAL\n1\n*SURFACE, NAME=bottom\nlow, S1\n*SURFACE, TYPE=ELEMENT,\n" +
      " NAME=sides\n2, S2\npart, s4\n1, S1\n99, S1\n*SURFACE, NAME=nodes, TYPE=NODE\n1\n");
  EXPECT_EQ(inp.Triangles.Cells,
    (std::vector<Triangle>{ { 0, 2, 1 }, { 4, 2, 3 }, { 2, 0, 3 }, { 1, 4, 3 } }));
  EXPECT_EQ(GroupsOf(inp.Triangles),
    (Groups{ { 1, "bottom" }, { 2, "sides" }, { 2, "sides" }, { 2, "sides" } }));
}

TEST(ReadSolid, ReadsOnePartOfAnAssembly)
{
  const std::string part =
    "*PART, NAME=a\n" + InpNodes + "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n*END PART\n";
  const SolidContent inp = Read("a.inp",
    "*HEADING\n1, 2\n" + part + "*ASSEMBLY\n*INSTANCE, PART=a\n*END INSTANCE\n*NODE\n1, 7, 7, 7\n" +
      "*END ASSEMBLY\n*INCLUDE, INPUT=loads.inp\n");
  EXPECT_EQ(inp.Points.size(), 5u);
  ASSERT_EQ(inp.Warnings.size(), 1u);
  EXPECT_NE(inp.Warnings[0].find("line 19: the content of another file is left out: loads.inp"),
    std::string::npos)
    << inp.Warnings[0];
  ExpectError("a.inp", part + part, ", line 11: a second *PART begins");
}

TEST(ReadSolid, NamesTheLineAndTheElement)
{
  ExpectError("a.msh", Msh22(FourNodes, "1\n3 4 2 1 1 1 2 3 99\n"),
    ", line 13: tetrahedron 3 refers to point 99 of 4");
  ExpectError("a.msh", Msh22("1\n7 0 0 0\n", "1\n3 2 2 1 1 7 7 6\n"),
    ", line 10: triangle 3 refers to point 6, which is not there");
  ExpectError("a.msh", Msh22("1\n17 0 nan 0\n", "0\n"), ", line 6: point 17 is not finite");
  ExpectError("a.msh", Msh22("2000000000\n1 0 0 0\n", "0\n"),
    ", line 5: 2000000000 points announced, at most");
  ExpectError(
    "a.msh", Msh22("1\n1 0 0 0\n", "2000000000\n"), ", line 9: 2000000000 elements announced");
  ExpectError(
    "a.msh", Msh22("2\n1 0 0 0\n1 0 0 0\n", "1\n3 2 0 1 1 1\n"), ": point 1 is there twice");
  ExpectError("a.msh", Msh22(FourNodes, "2\n3 2 0 1 2 3\n3 2 0 1 2 4\n"),
    ", line 14: triangle 3 is there twice");
  ExpectError("a.msh", Msh22(FourNodes, "1\n3 4 2 1 1 1 2 3\n"),
    ", line 13: expected an integer, found the end of the line");
  ExpectError("a.msh", Msh22(FourNodes, "1\n3 4 2 1 1 1 2 3 4 1\n"),
    ", line 13: element 3 has more than 4 points");
  ExpectError("a.mesh", Mesh("Tetrahedra\n2\n1 2 3 4 0\n1 2 3 6 0\nEnd\n"),
    ", line 12: tetrahedron 2 refers to point 6 of 5");
  ExpectError("a.mesh", Mesh("Triangles\n2000000000\n1 2 3 0\nEnd\n"),
    ", line 10: 2000000000 elements announced");
  ExpectError(
    "a.mesh", Mesh("Triangles\n-1\nEnd\n"), ", line 10: the number of elements is negative");
  ExpectError(
    "a.mesh", Mesh("Triangles\n1\n1 2 3 0\n"), ", line 12: there is no End: the file is truncated");
  ExpectError("a.inp", InpNodes + "*ELEMENT, TYPE=C3D4\n8, 1, 2, 3\n",
    ", line 8: element 8 has not 4 points");
  ExpectError("a.inp", InpNodes + "*ELEMENT, TYPE=C3D4\n8, 1, 2, 3, 4, 5\n",
    ", line 8: element 8 has more than 4 points");
  ExpectError("a.inp", InpNodes + "*ELEMENT, TYPE=C3D4\n8, 1, 2, 3, 70\n",
    ", line 8: tetrahedron 8 refers to point 70 of 5");
  ExpectError("a.inp", "*NODE\n1, 0, inf\n", ", line 2: point 1 is not finite");
  ExpectError("a.inp", "*NODE\n1 0 0 0\n", ", line 2: expected a comma, found '0'");
  ExpectError("a.inp", "*NODE, SYSTEM=C\n1, 0, 0, 0\n", ", line 1: coordinates of the system 'C'");
  ExpectError("a.inp", InpNodes + "*ELEMENT\n8, 1, 2, 3\n", ", line 7: *ELEMENT has no TYPE");
}

TEST(ReadSolid, RefusesOtherFormats)
{
  ExpectError("a.msh", "$MeshFormat\n4 0 8\n", ", line 2: is of version '4' of gmsh's format");
  ExpectError("a.msh", "$MeshFormat\n2.2 1 8\n", ", line 2: is binary");
  ExpectError("a.msh", "$NOD\n", ", line 1: is not a file of gmsh's from version 2 on");
  ExpectError("a.mesh", "solid\n", ", line 1: is not a file of Medit's");
  const TemporaryFile file("a.vtk", "x");
  Monitor monitor;
  try
  {
    ReadSolid(file.Path, monitor);
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::FileUnreadable);
    EXPECT_EQ(
      error.what(), file.Path + ": the ending is none of .msh, .inp and .mesh, which can be read");
  }
}

TEST(ReadSolid, ReadsLinesOfOtherSystems)
{
  const SolidMesh solid = RandomSolid(3);
  for (const char* name : { "a.msh", "a.inp", "a.mesh" })
  {
    const TemporaryFile file(name);
    Monitor monitor;
    WriteSolid(file.Path, solid, MshVersion::Msh41, monitor);
    std::string text = file.Read();
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    {
      text.replace(at, 1, "\r\n");
    }
    const SolidContent read = Read(name, "\xEF\xBB\xBF" + text);
    EXPECT_EQ(read.Tetrahedra.Cells, solid.Cells);
    EXPECT_EQ(read.Tetrahedra.Groups[1].Name, "soft tissue");
    EXPECT_EQ(read.Triangles.Groups[1].Name, "wall 2");
  }
}

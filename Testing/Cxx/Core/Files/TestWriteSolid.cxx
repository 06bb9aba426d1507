// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the files. Testing/Python/TestSolidFiles.py lets gmsh, meshio and CalculiX read
// them.
#include "Files/SolidFile.h"

#include "Common/Error.h"
#include "Support/SolidSamples.h"
#include "Support/TemporaryFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>
#include <random>
#include <sstream>

using namespace insideout;
using namespace solidsamples;
using testfiles::TemporaryFile;

namespace
{
std::string Written(
  const SolidMesh& solid, const std::string& name, MshVersion version = MshVersion::Msh41)
{
  const TemporaryFile file(name);
  Monitor monitor;
  WriteSolid(file.Path, solid, version, monitor);
  return file.Read();
}

/** The lines behind the line that begins with `heading`, as words; commas part words, too. */
std::vector<std::vector<std::string>> LinesBehind(
  const std::string& text, const std::string& heading)
{
  std::vector<std::vector<std::string>> lines;
  std::istringstream stream(text);
  bool isThere = false;
  for (std::string line; std::getline(stream, line);)
  {
    if (isThere)
    {
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream words(line);
      lines.emplace_back(
        std::istream_iterator<std::string>(words), std::istream_iterator<std::string>());
    }
    isThere = isThere || (line + '\n').compare(0, heading.size(), heading) == 0;
  }
  EXPECT_TRUE(isThere) << heading;
  return lines;
}

/** Some of the numbers of a line. */
std::vector<Id> Numbers(const std::vector<std::string>& words, std::size_t begin, std::size_t end)
{
  std::vector<Id> numbers;
  for (std::size_t k = begin; k < end && k < words.size(); ++k)
  {
    numbers.push_back(std::stoi(words[k]));
  }
  return numbers;
}

/** Which corners the points of an element behind its corners are in the middle of, counted from 1.
 */
std::vector<std::array<int, 2>> EdgesOfMidpoints(
  const SolidMesh& solid, const std::vector<Id>& nodes, std::size_t corners)
{
  std::vector<std::array<int, 2>> edges;
  for (std::size_t m = corners; m < nodes.size(); ++m)
  {
    for (std::size_t a = 0; a < corners; ++a)
    {
      for (std::size_t b = a + 1; b < corners; ++b)
      {
        const Point& p = solid.Points[nodes[a] - 1];
        const Point& q = solid.Points[nodes[b] - 1];
        const Point middle = { (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2 };
        if (middle == solid.Points[nodes[m] - 1])
        {
          edges.push_back({ { static_cast<int>(a) + 1, static_cast<int>(b) + 1 } });
        }
      }
    }
  }
  return edges;
}

using Edges = std::vector<std::array<int, 2>>;

// As the formats' manuals have them; of edges the lower corner first.
const Edges GmshTetrahedron = { { 1, 2 }, { 2, 3 }, { 1, 3 }, { 1, 4 }, { 3, 4 }, { 2, 4 } };
const Edges AbaqusTetrahedron = { { 1, 2 }, { 2, 3 }, { 1, 3 }, { 1, 4 }, { 2, 4 }, { 3, 4 } };
const Edges EveryTriangle = { { 1, 2 }, { 2, 3 }, { 1, 3 } };

/** Coordinates with any bits, in 25 tetrahedra that share no points. */
SolidMesh AnyCoordinates(unsigned seed)
{
  std::mt19937_64 random(seed);
  SolidMesh solid;
  while (solid.Points.size() < 100)
  {
    Point point;
    for (double& x : point)
    {
      do
      {
        const std::uint64_t bits = random();
        std::memcpy(&x, &bits, sizeof(x));
      } while (!std::isfinite(x));
    }
    solid.Points.push_back(point);
  }
  for (Id p = 0; p < 100; p += 4)
  {
    solid.Cells.push_back({ { p, p + 1, p + 2, p + 3 } });
    solid.RegionOfCell.push_back(0);
    solid.Faces.push_back({ p / 4, 2 });
    solid.TagOfFace.push_back(0);
  }
  solid.Regions = { { "solid", 1 } };
  solid.Tags = { { "surface", 1 } };
  return solid;
}

void ExpectError(const SolidMesh& solid, ErrorCode code, const std::string& words,
  const std::string& name = "a.msh")
{
  const TemporaryFile file(name, "earlier");
  try
  {
    Monitor monitor;
    WriteSolid(file.Path, solid, MshVersion::Msh41, monitor);
    ADD_FAILURE() << "no error: " << words;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, code) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
  EXPECT_EQ(file.Read(), "earlier");
}
} // namespace

TEST(WriteSolid, NamesThePhysicalGroupsOfMsh)
{
  for (const MshVersion version : { MshVersion::Msh41, MshVersion::Msh22 })
  {
    const std::string text = Written(TwoRegions(), "a.msh", version);
    EXPECT_NE(
      text.find("$PhysicalNames\n4\n2 1 \"outside\"\n2 5 \"wall\"\n3 3 \"red\"\n3 1 \"blue\"\n"
                "$EndPhysicalNames\n"),
      std::string::npos)
      << text;
  }
}

TEST(WriteSolid, SaysInMsh41WhichSurfacesBoundAVolumeAndHowTheyFace)
{
  const auto lines = LinesBehind(Written(TwoRegions(), "a.msh"), "$Entities");
  EXPECT_EQ(lines[0], (std::vector<std::string>{ "0", "0", "2", "2" }));
  EXPECT_EQ(
    lines[1], (std::vector<std::string>{ "1", "0", "0", "0", "1", "1", "1", "1", "1", "0" }));
  EXPECT_EQ(
    lines[2], (std::vector<std::string>{ "5", "0", "0", "0", "1", "1", "1", "1", "5", "0" }));
  // The wall faces out of the second region, whose number is 1.
  EXPECT_EQ(lines[3],
    (std::vector<std::string>{ "3", "0", "0", "0", "1", "1", "1", "1", "3", "2", "1", "-5" }));
  EXPECT_EQ(lines[4],
    (std::vector<std::string>{ "1", "0", "0", "0", "1", "1", "1", "1", "1", "2", "1", "5" }));
}

TEST(WriteSolid, OrdersQuadraticElementsAsEachFormatDoes)
{
  const SolidMesh solid = Quadratic(TwoRegions());
  const std::size_t faces = solid.Faces.size();

  const auto msh = LinesBehind(Written(solid, "a.msh", MshVersion::Msh22), "$Elements");
  for (std::size_t e = 1; e <= faces + 2; ++e)
  {
    const bool isFace = e <= faces;
    const std::size_t corners = isFace ? 3 : 4;
    EXPECT_EQ(msh[e][1], isFace ? "9" : "11");
    const std::vector<Id> nodes = Numbers(msh[e], 5, msh[e].size());
    EXPECT_EQ(EdgesOfMidpoints(solid, nodes, corners), isFace ? EveryTriangle : GmshTetrahedron);
  }
  const auto inp = LinesBehind(Written(solid, "a.inp"), "*ELEMENT, TYPE=C3D10, ELSET=red");
  EXPECT_EQ(EdgesOfMidpoints(solid, Numbers(inp[0], 1, inp[0].size()), 4), AbaqusTetrahedron);

  // Medit's says itself what the order is: twice the barycentric coordinates of each point.
  const std::string mesh = Written(solid, "a.mesh");
  for (const std::size_t corners : { 3u, 4u })
  {
    const std::string word = corners == 3 ? "Triangles" : "Tetrahedra";
    const std::size_t nodes = corners == 3 ? 6 : 10;
    const auto ordering = LinesBehind(mesh, word + "P2Ordering");
    const auto elements = LinesBehind(mesh, word + "P2\n");
    EXPECT_EQ(ordering[0], std::vector<std::string>{ std::to_string(nodes) });
    for (std::size_t e = 1; e <= static_cast<std::size_t>(std::stoi(elements[0][0])); ++e)
    {
      ASSERT_EQ(elements[e].size(), nodes + 1);
      const std::vector<Id> ids = Numbers(elements[e], 0, nodes);
      for (std::size_t k = 0; k < nodes; ++k)
      {
        const std::vector<Id> twice = Numbers(ordering[1 + k], 0, corners);
        Point place = { 0, 0, 0 };
        for (std::size_t c = 0; c < corners; ++c)
        {
          for (int axis = 0; axis < 3; ++axis)
          {
            place[axis] += twice[c] / 2.0 * solid.Points[ids[c] - 1][axis];
          }
        }
        EXPECT_EQ(place, solid.Points[ids[k] - 1]) << word << " " << e << ", point " << k;
      }
    }
  }
}

TEST(WriteSolid, FacesFaceOutOfTheirCells)
{
  const SolidMesh solid = Quadratic(TwoRegions());
  const auto elements = LinesBehind(Written(solid, "a.msh", MshVersion::Msh22), "$Elements");
  for (std::size_t f = 0; f < solid.Faces.size(); ++f)
  {
    const Triangle corners = FaceOf(solid.Cells[solid.Faces[f].Cell], solid.Faces[f].Face);
    EXPECT_EQ(Numbers(elements[1 + f], 5, 8),
      (std::vector<Id>{ corners[0] + 1, corners[1] + 1, corners[2] + 1 }));
    const std::vector<std::string> numbers(elements[1 + f].begin(), elements[1 + f].begin() + 5);
    const std::string tag = std::to_string(solid.Tags[solid.TagOfFace[f]].Number);
    EXPECT_EQ(numbers, (std::vector<std::string>{ std::to_string(f + 1), "9", "2", tag, tag }));
  }
}

TEST(WriteSolid, NumbersTheFacesOfInpAsAbaqusDoes)
{
  // Which corners S1 to S4 have, of the Abaqus Elements Guide.
  const std::map<std::string, std::array<int, 3>> corners = { { "S1", { { 1, 2, 3 } } },
    { "S2", { { 1, 2, 4 } } }, { "S3", { { 2, 3, 4 } } }, { "S4", { { 1, 3, 4 } } } };
  const SolidMesh solid = TwoRegions();
  const auto lines = LinesBehind(Written(solid, "a.inp"), "*SURFACE, NAME=outside, TYPE=ELEMENT");
  for (std::size_t f = 0; f < 6; ++f)
  {
    const CellFace& face = solid.Faces[f];
    EXPECT_EQ(lines[f][0], std::to_string(face.Cell + 1));
    std::array<int, 3> expected = TetrahedronFaces[face.Face];
    std::sort(expected.begin(), expected.end());
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(corners.at(lines[f][1])[k], expected[k] + 1);
    }
  }
  const auto wall = LinesBehind(Written(solid, "a.inp"), "*SURFACE, NAME=wall, TYPE=ELEMENT");
  EXPECT_EQ(wall, (std::vector<std::vector<std::string>>{ { "2", "S3" } }));
}

TEST(WriteSolid, HasTheSetsOfInp)
{
  const std::string text = Written(TwoRegions(), "a.inp");
  EXPECT_EQ(
    LinesBehind(text, "*NSET, NSET=red")[0], (std::vector<std::string>{ "1", "2", "3", "4" }));
  EXPECT_EQ(
    LinesBehind(text, "*NSET, NSET=blue")[0], (std::vector<std::string>{ "2", "3", "4", "5" }));
  EXPECT_EQ(LinesBehind(text, "*NSET, NSET=wall")[0], (std::vector<std::string>{ "2", "3", "4" }));
  EXPECT_EQ(LinesBehind(text, "*ELSET, ELSET=Eall")[0], (std::vector<std::string>{ "red" }));
  EXPECT_EQ(LinesBehind(text, "*ELSET, ELSET=Eall")[1], (std::vector<std::string>{ "blue" }));
  EXPECT_EQ(LinesBehind(text, "*ELEMENT, TYPE=C3D4, ELSET=blue")[0],
    (std::vector<std::string>{ "2", "5", "3", "2", "4" }));
  EXPECT_EQ(
    LinesBehind(text, "*NODE, NSET=Nall")[4], (std::vector<std::string>{ "5", "1", "1", "1" }));
}

TEST(WriteSolid, TellsInInpAndMeshWhatNamesWere)
{
  SolidMesh solid = TwoRegions();
  solid.Tags[1].Name = "the wall";
  EXPECT_NE(Written(solid, "a.inp").find("** the_wall: tag 5, the wall\n"), std::string::npos);
  EXPECT_NE(
    Written(solid, "a.mesh").find("# Triangles with reference 5: the wall\n"), std::string::npos);
  EXPECT_NE(
    Written(solid, "a.mesh").find("# Tetrahedra with reference 3: red\n"), std::string::npos);
}

TEST(WriteSolid, KeepsEveryBitInMshAndMesh)
{
  const SolidMesh solid = AnyCoordinates(5);
  for (const auto& [name, version, heading] :
    { std::make_tuple("a.msh", MshVersion::Msh41, "$Nodes"),
      std::make_tuple("a.msh", MshVersion::Msh22, "$Nodes"),
      std::make_tuple("a.mesh", MshVersion::Msh41, "Vertices") })
  {
    const auto lines = LinesBehind(Written(solid, name, version), heading);
    std::size_t found = 0;
    for (std::size_t p = 0; p < solid.Points.size(); ++p)
    {
      for (std::size_t l = 1; l < lines.size() && l <= 2 * solid.Points.size() + 4; ++l)
      {
        // Behind the number in 2.2, before the reference in .mesh, alone in 4.1.
        const std::size_t first = version == MshVersion::Msh22 ? 1 : 0;
        if (lines[l].size() >= first + 3)
        {
          const Point point = { std::strtod(lines[l][first].c_str(), nullptr),
            std::strtod(lines[l][first + 1].c_str(), nullptr),
            std::strtod(lines[l][first + 2].c_str(), nullptr) };
          found += std::memcmp(point.data(), solid.Points[p].data(), sizeof(Point)) == 0;
        }
      }
    }
    EXPECT_EQ(found, solid.Points.size()) << name;
  }
}

TEST(WriteSolid, TellsWhichPointsItsNumbersAre)
{
  const SolidMesh solid = AnyCoordinates(8);
  for (const char* name : { "a.inp", "a.INP", "a.msh", "a.mesh" })
  {
    const TemporaryFile file(name);
    Monitor monitor;
    WriteSolid(file.Path, solid, MshVersion::Msh41, monitor);
    const std::vector<Point> points = PointsInFile(file.Path, solid.Points);
    EXPECT_EQ(ReadSolid(file.Path, monitor).Points, points) << name;
    EXPECT_EQ(points == solid.Points, std::string(name).find('m') != std::string::npos) << name;
  }
}

TEST(WriteSolid, HasNumbersOfTwentyCharactersInInp)
{
  SolidMesh solid = AnyCoordinates(6);
  std::mt19937_64 random(7);
  for (std::size_t p = 0; p < 60; ++p)
  {
    for (double& x : solid.Points[p])
    {
      x = (static_cast<double>(random() >> 11) / 9007199254740992.0 - 0.5) * std::pow(10.0, p % 20);
    }
  }
  const auto lines = LinesBehind(Written(solid, "a.inp"), "*NODE");
  for (std::size_t p = 0; p < solid.Points.size(); ++p)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double x = solid.Points[p][axis];
      const std::string& text = lines[p][1 + axis];
      const double found = std::strtod(text.c_str(), nullptr);
      EXPECT_LE(text.size(), 20u);
      if (std::abs(x) >= 0.01 && std::abs(x) < 1e17)
      {
        EXPECT_EQ(found, x) << text;
      }
      EXPECT_LE(std::abs(found - x), 1e-12 * std::abs(x)) << text;
    }
  }
}

TEST(WriteSolid, PutsEachPointOfMsh41OnOneEntity)
{
  SolidMesh solid = Quadratic(TwoRegions());
  solid.Points.push_back({ 7, 7, 7 }); // of no cell
  const auto lines = LinesBehind(Written(solid, "a.msh"), "$Nodes");
  const std::size_t points = solid.Points.size();
  std::vector<int> times(points);
  std::size_t line = 1;
  for (int blocks = std::stoi(lines[0][0]); blocks > 0; --blocks)
  {
    const std::size_t count = static_cast<std::size_t>(std::stoi(lines[line][3]));
    for (std::size_t k = 1; k <= count; ++k)
    {
      ++times[static_cast<std::size_t>(std::stoi(lines[line + k][0])) - 1];
    }
    line += 1 + 2 * count;
  }
  EXPECT_EQ(lines[line], std::vector<std::string>{ "$EndNodes" });
  EXPECT_EQ(times, std::vector<int>(points, 1));
}

namespace
{
/** A prism, a pyramid on one of its sides, and a tetrahedron on top; the wall is below. */
SolidMesh WithLayers()
{
  SolidMesh solid;
  solid.Points = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 },
    { 1, 1, 0 }, { 0, 0, 2 } };
  solid.Cells = { { 3, 5, 4, 7 } };
  solid.Pyramids = { { { 1, 4, 5, 2, 6 } } };
  solid.Prisms = { { { 0, 1, 2, 3, 4, 5 } } };
  solid.RegionOfCell = { 0, 0, 0 };
  solid.Regions = { { "solid", 1 } };
  solid.Tags = { { "wall", 1 } };
  solid.Faces = FacesOfTriangles(solid, solid.Points, { { 0, 1, 2 }, { 2, 1, 6 }, { 3, 7, 5 } });
  solid.TagOfFace = { 0, 0, 0 };
  return solid;
}
} // namespace

TEST(WriteSolid, WritesQuadsOfLayers)
{
  // The prism's quad at its corners 0 and 1, and its first triangle; the pyramid has one at 1
  // and 6.
  SolidMesh solid = WithLayers();
  solid.Faces = { { 2, 0 }, { 2, 2 } };
  solid.TagOfFace = { 0, 0 };
  const std::string old = Written(solid, "a.msh", MshVersion::Msh22);
  EXPECT_NE(old.find("\n1 2 2 1 1 1 2 3\n2 3 2 1 1 1 4 5 2\n"), std::string::npos) << old;
  const std::string text = Written(solid, "a.msh");
  EXPECT_NE(
    text.find("$Elements\n5 5 1 5\n2 1 2 1\n1 1 2 3\n2 1 3 1\n2 1 4 5 2\n"), std::string::npos)
    << text;
  const std::string medit = Written(solid, "a.mesh");
  EXPECT_NE(medit.find("Triangles\n1\n 1 2 3 1\nQuadrilaterals\n1\n 1 4 5 2 1\nTetrahedra\n"),
    std::string::npos)
    << medit;
  // C3D6's third face is at its corners 1 and 2, here 4 and 5; a pyramid's base is the fourth.
  EXPECT_NE(Written(solid, "a.inp").find("TYPE=ELEMENT\n3, S2\n3, S3\n"), std::string::npos);
  solid.Faces = { { 1, 4 } };
  solid.TagOfFace = { 0 };
  EXPECT_NE(Written(solid, "a.inp").find("TYPE=ELEMENT\n2, S4\n"), std::string::npos);
}

TEST(WriteSolid, WritesPrismsAndPyramidsOfLayers)
{
  const SolidMesh solid = WithLayers();
  ASSERT_EQ(solid.Faces.size(), 3U);
  EXPECT_EQ(solid.Faces[0].Cell, 2);
  EXPECT_EQ(solid.Faces[0].Face, 0);
  EXPECT_EQ(solid.Faces[1].Cell, 1);
  EXPECT_EQ(solid.Faces[2].Cell, 0);
  // A prism's first triangle is counter-clockwise seen from within in all of these.
  const std::string old = Written(solid, "a.msh", MshVersion::Msh22);
  EXPECT_NE(old.find("\n4 4 2 1 1 4 6 5 8\n5 7 2 1 1 2 5 6 3 7\n6 6 2 1 1 4 5 6 1 2 3\n"),
    std::string::npos)
    << old;
  const std::string text = Written(solid, "a.msh");
  EXPECT_NE(text.find("$Elements\n4 6 1 6\n"), std::string::npos) << text;
  EXPECT_NE(
    text.find("3 1 7 1\n5 2 5 6 3 7\n3 1 6 1\n6 4 5 6 1 2 3\n$EndElements"), std::string::npos)
    << text;
  const std::string medit = Written(solid, "a.mesh");
  EXPECT_NE(
    medit.find("Pyramids\n1\n 2 5 6 3 7 1\nPrisms\n1\n 4 5 6 1 2 3 1\nEnd\n"), std::string::npos)
    << medit;
  const std::string inp = Written(solid, "a.inp");
  EXPECT_NE(
    inp.find("*ELEMENT, TYPE=C3D6, ELSET=solid\n2, 7, 3, 6, 7, 2, 5\n3, 4, 5, 6, 1, 2, 3\n"),
    std::string::npos)
    << inp;
  // The wall is the second triangle of the prism; of the pyramid the one at its corners 4 and 1.
  EXPECT_NE(inp.find("TYPE=ELEMENT\n3, S2\n2, S3\n1, S2\n"), std::string::npos) << inp;

  SolidMesh other = solid;
  other.Faces[0].Face = 5;
  ExpectError(other, ErrorCode::InvalidParameter, "no face 5 of cell 2");
  other = solid;
  other.Prisms[0][5] = 9;
  ExpectError(other, ErrorCode::PointOutOfRange, "refers to point 9 of 8");
  EXPECT_THROW(OuterFaces(solid), Error);
}

TEST(WriteSolid, RejectsSolidsThatAreNone)
{
  ExpectError(SolidMesh(), ErrorCode::InvalidParameter, "no cells");
  SolidMesh solid = TwoRegions();
  solid.Cells[1][0] = 5;
  ExpectError(solid, ErrorCode::PointOutOfRange, "cell 1 refers to point 5 of 5");
  solid = TwoRegions();
  solid.Points[2][0] = HUGE_VAL;
  ExpectError(solid, ErrorCode::PointNotFinite, "point 2");
  solid = TwoRegions();
  solid.RegionOfCell[1] = 2;
  ExpectError(solid, ErrorCode::InvalidParameter, "cell 1 is of group 2 of 2");
  solid = TwoRegions();
  solid.TagOfFace[6] = -1;
  ExpectError(solid, ErrorCode::InvalidParameter, "face 6 is of group -1 of 2");
  solid = TwoRegions();
  solid.TagOfFace[6] = 0;
  ExpectError(solid, ErrorCode::InvalidParameter, "group 'wall' has no face");
  solid = TwoRegions();
  solid.Tags[1].Number = 1;
  ExpectError(solid, ErrorCode::InvalidParameter, "group 'wall' has a number that is not above 0");
  solid = TwoRegions();
  solid.Faces[6].Face = 4;
  ExpectError(solid, ErrorCode::InvalidParameter, "no face 4 of cell 1");
  solid = TwoRegions();
  solid.RegionOfCell.pop_back();
  ExpectError(solid, ErrorCode::InvalidParameter, "regions differ, or those of faces and tags");
  solid = Quadratic(TwoRegions());
  solid.Midpoints.pop_back();
  ExpectError(solid, ErrorCode::InvalidParameter, "regions differ, or those of faces and tags");
}

TEST(WriteSolid, NamesFilesThatItCannotWrite)
{
  ExpectError(TwoRegions(), ErrorCode::InvalidParameter, "a.vtu: the ending is none of", "a.vtu");
  for (const char* name : { "a.msh", "a.inp", "a.mesh" })
  {
    const std::string nowhere = testing::TempDir() + "no/such/folder/" + name;
    try
    {
      Monitor monitor;
      WriteSolid(nowhere, TwoRegions(), MshVersion::Msh41, monitor);
      ADD_FAILURE();
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.what(), nowhere + ": No such file or directory");
    }
  }
}

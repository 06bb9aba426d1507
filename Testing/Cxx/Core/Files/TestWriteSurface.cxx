// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SurfaceFile.h"

#include "Support/TemporaryFile.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <random>

using namespace insideout;
using testfiles::TemporaryFile;

namespace
{
PolygonSurface ToSurface(const TriangleSoup& soup)
{
  PolygonSurface surface;
  surface.Points = soup.Points;
  for (const Triangle& triangle : soup.Triangles)
  {
    surface.Corners.insert(surface.Corners.end(), triangle.begin(), triangle.end());
    surface.Offsets.push_back(static_cast<Id>(surface.Corners.size()));
  }
  return surface;
}

double AnyFiniteDouble(std::mt19937_64& random)
{
  double x;
  do
  {
    const std::uint64_t bits = random();
    std::memcpy(&x, &bits, sizeof(x));
  } while (!std::isfinite(x));
  return x;
}

/** Polygons of 3 to 6 corners over points with any bits; every point is used. */
PolygonSurface RandomPolygons(unsigned seed)
{
  std::mt19937_64 random(seed);
  PolygonSurface surface;
  for (int p = 0; p < 300; ++p)
  {
    const std::size_t corners = 3 + random() % 4;
    for (std::size_t k = 0; k < corners; ++k)
    {
      surface.Corners.push_back(static_cast<Id>(surface.Points.size()));
      surface.Points.push_back(
        { AnyFiniteDouble(random), AnyFiniteDouble(random), AnyFiniteDouble(random) });
    }
    surface.Corners.back() = static_cast<Id>(random() % surface.Points.size());
    surface.Corners.push_back(static_cast<Id>(surface.Points.size() - 1));
    surface.Offsets.push_back(static_cast<Id>(surface.Corners.size()));
  }
  return surface;
}

template <typename T>
Attribute RandomAttribute(const char* name, int components, std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<T> values;
  for (std::size_t i = 0; i < count * static_cast<std::size_t>(components); ++i)
  {
    values.push_back(static_cast<T>(random() / 7.0e9 * 255.0));
  }
  return { name, components, std::move(values) };
}

PolygonSurface WrittenAndRead(const PolygonSurface& surface, const std::string& name)
{
  const TemporaryFile file(name);
  Monitor monitor;
  WriteSurface(file.Path, surface, monitor);
  return ReadSurface(file.Path, monitor);
}

void ExpectSame(const PolygonSurface& surface, const PolygonSurface& expected)
{
  ASSERT_EQ(surface.Points.size(), expected.Points.size());
  EXPECT_EQ(std::memcmp(surface.Points.data(), expected.Points.data(),
              expected.Points.size() * sizeof(Point)),
    0);
  EXPECT_EQ(surface.Corners, expected.Corners);
  EXPECT_EQ(surface.Offsets, expected.Offsets);
}

void ExpectSameAttributes(
  const std::vector<Attribute>& attributes, const std::vector<Attribute>& expected)
{
  ASSERT_EQ(attributes.size(), expected.size());
  for (std::size_t i = 0; i < attributes.size(); ++i)
  {
    EXPECT_EQ(attributes[i].Name, expected[i].Name);
    EXPECT_EQ(attributes[i].Components, expected[i].Components);
    EXPECT_TRUE(attributes[i].Values == expected[i].Values) << expected[i].Name;
  }
}

void ExpectError(
  const std::string& path, const PolygonSurface& surface, ErrorCode code, const std::string& part)
{
  try
  {
    Monitor monitor;
    WriteSurface(path, surface, monitor);
    ADD_FAILURE() << path << " was written";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, code) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

PolygonSurface Box()
{
  return ToSurface(testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 }));
}
} // namespace

TEST(WriteSurface, KeepsEveryBitThroughPlyObjAndOff)
{
  for (const char* name : { "a.ply", "a.obj", "a.off" })
  {
    for (unsigned seed = 0; seed < 5; ++seed)
    {
      const PolygonSurface surface = RandomPolygons(seed);
      const PolygonSurface back = WrittenAndRead(surface, name);
      ExpectSame(back, surface);
      EXPECT_TRUE(back.Warnings.empty());
      EXPECT_TRUE(back.PointAttributes.empty());
    }
  }
}

TEST(WriteSurface, KeepsSpecialNumbersThroughPlyObjAndOff)
{
  PolygonSurface surface = Box();
  surface.Points[0] = { -0.0, std::numeric_limits<double>::denorm_min(),
    std::numeric_limits<double>::max() };
  surface.Points[1] = { std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::min() };
  for (const char* name : { "a.ply", "a.obj", "a.off" })
  {
    ExpectSame(WrittenAndRead(surface, name), surface);
  }
  surface.Points[2][1] = std::numeric_limits<double>::quiet_NaN();
  for (const char* name : { "a.ply", "a.obj", "a.off", "a.stl" })
  {
    surface.Points[0][2] = 1.0;
    const PolygonSurface back = WrittenAndRead(surface, name);
    EXPECT_TRUE(std::isnan(back.Points[static_cast<std::size_t>(back.Corners[1])][1]));
  }
}

TEST(WriteSurface, KeepsAttributesThroughPly)
{
  PolygonSurface surface = RandomPolygons(1);
  const std::size_t points = surface.Points.size();
  const std::size_t polygons = surface.Offsets.size() - 1;
  surface.PointAttributes = { RandomAttribute<float>("Normals", 3, points, 1),
    RandomAttribute<double>("TCoords", 2, points, 2),
    RandomAttribute<unsigned char>("Colors", 4, points, 3),
    RandomAttribute<double>("w", 1, points, 4) };
  surface.PolygonAttributes = { RandomAttribute<unsigned char>("Colors", 3, polygons, 5),
    RandomAttribute<std::int32_t>("GroupIds", 1, polygons, 6),
    RandomAttribute<float>("area", 1, polygons, 7),
    RandomAttribute<unsigned char>("Inside", 1, polygons, 8) };
  const PolygonSurface back = WrittenAndRead(surface, "a.ply");
  ExpectSame(back, surface);
  ExpectSameAttributes(back.PointAttributes, surface.PointAttributes);
  ExpectSameAttributes(back.PolygonAttributes, surface.PolygonAttributes);
}

TEST(WriteSurface, GivesPlyPropertiesNamesOfTheirOwn)
{
  PolygonSurface surface = Box();
  surface.PointAttributes = { RandomAttribute<double>("x", 1, 8, 1),
    RandomAttribute<double>("two words", 1, 8, 2), RandomAttribute<double>("v", 2, 8, 3),
    RandomAttribute<double>("v_1", 1, 8, 4) };
  const PolygonSurface back = WrittenAndRead(surface, "a.ply");
  ExpectSame(back, surface);
  std::vector<std::string> names;
  for (const Attribute& attribute : back.PointAttributes)
  {
    names.push_back(attribute.Name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{ "x_", "two_words", "v_0", "v_1", "v_1_" }));
  EXPECT_TRUE(back.PointAttributes[4].Values == surface.PointAttributes[3].Values);
}

TEST(WriteSurface, KeepsAttributesThroughObj)
{
  PolygonSurface surface = RandomPolygons(2);
  const std::size_t points = surface.Points.size();
  // The reader gives 0 to what no polygon uses.
  surface.Corners.resize(points);
  surface.Offsets = { 0, static_cast<Id>(points) };
  for (std::size_t p = 0; p < points; ++p)
  {
    surface.Corners[p] = static_cast<Id>(p);
  }
  const Attribute normals = RandomAttribute<double>("Normals", 3, points, 1);
  const Attribute tcoords = RandomAttribute<double>("TCoords", 2, points, 2);
  const Attribute colors = RandomAttribute<unsigned char>("Colors", 3, points, 3);
  const Attribute dark = { "Colors", 3, std::vector<unsigned char>(3 * points, 1) };
  const std::vector<std::vector<Attribute>> cases = { { normals }, { tcoords }, { colors },
    { dark }, { normals, tcoords, colors } };
  for (const std::vector<Attribute>& attributes : cases)
  {
    surface.PointAttributes = attributes;
    const PolygonSurface back = WrittenAndRead(surface, "a.obj");
    ExpectSame(back, surface);
    ExpectSameAttributes(back.PointAttributes, attributes);
  }
}

TEST(WriteSurface, KeepsGroupsAndMaterialsThroughObj)
{
  PolygonSurface surface = RandomPolygons(3);
  std::vector<std::int32_t> groups;
  std::vector<std::int32_t> materials;
  for (std::size_t p = 0; p + 1 < surface.Offsets.size(); ++p)
  {
    groups.push_back(p < 7 ? 0 : static_cast<std::int32_t>(p % 6) - 1);
    materials.push_back(p < 9 ? 1 : 0);
  }
  surface.PolygonAttributes = { { "GroupIds", 1, groups }, { "MaterialIds", 1, materials } };
  surface.Names = { { "MaterialNames", { "steel\\", "red #2" } },
    { "GroupNames", { "left\nwing", "", "#one", "a#b" } } };
  const auto back = [&]()
  {
    const PolygonSurface read = WrittenAndRead(surface, "a.obj");
    ExpectSame(read, surface);
    std::vector<std::string> names;
    for (std::size_t a = 0; a < read.PolygonAttributes.size(); ++a)
    {
      for (const auto id : std::get<std::vector<std::int32_t>>(read.PolygonAttributes[a].Values))
      {
        names.push_back(read.Names.at(a).Values.at(static_cast<std::size_t>(id)));
      }
    }
    return names;
  };
  const auto named =
    [](const std::vector<std::int32_t>& ids, const std::map<std::int32_t, std::string>& nameOf)
  {
    std::vector<std::string> names;
    for (const std::int32_t id : ids)
    {
      names.push_back(nameOf.at(id));
    }
    return names;
  };
  const std::vector<std::string> ofMaterials =
    named(materials, { { 0, "steel_" }, { 1, "red _2" } });
  std::vector<std::string> expected = named(groups,
    { { -1, "-1" }, { 0, "left wing" }, { 1, "1" }, { 2, "_one" }, { 3, "a#b" }, { 4, "4" } });
  expected.insert(expected.end(), ofMaterials.begin(), ofMaterials.end());
  EXPECT_EQ(back(), expected);

  surface.PolygonAttributes.push_back({ "BoundaryTag", 1, materials });
  EXPECT_EQ(back(), expected) << "without names";
  surface.Names.push_back({ "BoundaryTagNames", { "in", "out" } });
  expected = named(materials, { { 0, "in" }, { 1, "out" } });
  expected.insert(expected.end(), ofMaterials.begin(), ofMaterials.end());
  EXPECT_EQ(back(), expected);
}

TEST(WriteSurface, WritesPolygonsOfMoreCornersThanAByteCounts)
{
  PolygonSurface surface;
  for (Id p = 0; p < 300; ++p)
  {
    surface.Points.push_back({ std::cos(p * 0.02), std::sin(p * 0.02), 0.0 });
    surface.Corners.push_back(p);
  }
  surface.Offsets.push_back(300);
  ExpectSame(WrittenAndRead(surface, "a.ply"), surface);
  ExpectSame(WrittenAndRead(surface, "a.obj"), surface);
  ExpectSame(WrittenAndRead(surface, "a.off"), surface);
}

TEST(WriteSurface, WritesStlOfFloatsWithNormals)
{
  const PolygonSurface surface = ToSurface(testmeshes::RandomSoup(3, 200));
  const TemporaryFile file("a.stl");
  Monitor monitor;
  WriteSurface(file.Path, surface, monitor);
  const PolygonSurface back = ReadSurface(file.Path, monitor);
  ASSERT_EQ(back.Offsets, surface.Offsets);
  for (std::size_t c = 0; c < surface.Corners.size(); ++c)
  {
    const Point& point = surface.Points[static_cast<std::size_t>(surface.Corners[c])];
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(back.Points[c][axis], double(static_cast<float>(point[axis])));
    }
  }
  const std::string bytes = file.Read();
  ASSERT_EQ(bytes.size(), 84u + 50u * 200u);
  EXPECT_NE(bytes.substr(0, 5), "solid");
  for (std::size_t t = 0; t < 200; ++t)
  {
    float normal[3];
    std::memcpy(normal, &bytes[84 + 50 * t], sizeof(normal));
    const Point& a = back.Points[3 * t];
    EXPECT_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1.0, 1e-6);
    for (std::size_t k = 1; k < 3; ++k)
    {
      const Point& b = back.Points[3 * t + k];
      EXPECT_NEAR(normal[0] * (b[0] - a[0]) + normal[1] * (b[1] - a[1]) + normal[2] * (b[2] - a[2]),
        0.0, 1e-4);
    }
  }
}

TEST(WriteSurface, TurnsStlNormalsOutward)
{
  const TemporaryFile file("a.stl");
  Monitor monitor;
  WriteSurface(file.Path, Box(), monitor);
  const std::string bytes = file.Read();
  for (std::size_t t = 0; t < 12; ++t)
  {
    float numbers[12];
    std::memcpy(numbers, &bytes[84 + 50 * t], sizeof(numbers));
    float outward = 0.0f;
    for (int axis = 0; axis < 3; ++axis)
    {
      outward += numbers[axis] * (numbers[3 + axis] - 0.5f);
    }
    EXPECT_EQ(outward, 0.5f) << "triangle " << t;
  }
}

TEST(WriteSurface, WritesNothingToo)
{
  for (const char* name : { "a.off", "a.ply", "a.stl" })
  {
    const PolygonSurface back = WrittenAndRead(PolygonSurface(), name);
    EXPECT_TRUE(back.Points.empty());
    EXPECT_EQ(back.Offsets, (std::vector<Id>{ 0 }));
  }
}

TEST(WriteSurface, RejectsWhatTheFormatCannotHold)
{
  const TemporaryFile stl("a.stl");
  PolygonSurface quad = Box();
  quad.Offsets = { 0, 3, 7, 36 };
  ExpectError(stl.Path, quad, ErrorCode::InvalidParameter, "polygon 1 has 4 corners");
  PolygonSurface large = Box();
  large.Points[5][1] = 1e39;
  ExpectError(stl.Path, large, ErrorCode::InvalidParameter, "point 5");
  const TemporaryFile vtk("a.vtk");
  ExpectError(vtk.Path, Box(), ErrorCode::InvalidParameter,
    "a.vtk: the ending is none of those that can be written: .obj .off .ply .stl");
  EXPECT_FALSE(std::filesystem::exists(stl.Path) || std::filesystem::exists(vtk.Path));
}

TEST(WriteSurface, RejectsSurfacesThatAreNone)
{
  const TemporaryFile file("a.ply");
  PolygonSurface outside = Box();
  outside.Corners[7] = 8;
  ExpectError(file.Path, outside, ErrorCode::PointOutOfRange, "polygon 2 refers to point 8 of 8");
  outside.Corners[7] = -1;
  ExpectError(file.Path, outside, ErrorCode::PointOutOfRange, "polygon 2 refers to point -1 of 8");
  PolygonSurface offsets = Box();
  offsets.Offsets.back() = 37;
  ExpectError(file.Path, offsets, ErrorCode::InvalidParameter, "offsets");
  PolygonSurface attribute = Box();
  attribute.PointAttributes = { RandomAttribute<float>("Normals", 3, 7, 1) };
  ExpectError(file.Path, attribute, ErrorCode::InvalidParameter, "attribute 'Normals'");
  EXPECT_FALSE(std::filesystem::exists(file.Path));
}

TEST(WriteSurface, NamesFilesThatItCannotWrite)
{
  const std::string nowhere = testing::TempDir() + "no/such/folder/a.ply";
  ExpectError(nowhere, Box(), ErrorCode::FileUnwritable, nowhere + ": No such file or directory");
  if (!std::filesystem::exists("/dev/full"))
  {
    GTEST_SKIP() << "the system has no /dev/full, a disk that is always full";
  }
  const TemporaryFile full("full.ply");
  std::filesystem::create_symlink("/dev/full", full.Path);
  ExpectError(full.Path, Box(), ErrorCode::FileUnwritable, full.Path + ": No space left on device");
}

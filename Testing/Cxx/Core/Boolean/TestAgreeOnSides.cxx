// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/AgreeOnSides.h"

#include "Output/BoundaryTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

// Two labels per triangle, as segmentations of images give them: after turning, the triangles
// around each label enclose its voxels, whichever way they ran.

namespace
{
using namespace insideout;

/** A block of voxels with labels from 0 on, and the faces between labels: None is around all. */
struct Voxels
{
  std::array<int, 3> Size;
  std::vector<Id> Labels;
  TriangleSoup Soup;
  std::vector<Sides> Between;

  Voxels(std::array<int, 3> size, std::mt19937& random, int labels)
    : Size(size)
  {
    for (int v = 0; v < size[0] * size[1] * size[2]; ++v)
    {
      this->Labels.push_back(static_cast<Id>(random() % labels));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->AddFaces(axis);
    }
  }

  Id LabelAt(const std::array<int, 3>& v) const
  {
    for (int k = 0; k < 3; ++k)
    {
      if (v[k] < 0 || v[k] >= this->Size[k])
      {
        return None;
      }
    }
    return this->Labels[(v[0] * this->Size[1] + v[1]) * this->Size[2] + v[2]];
  }

private:
  /** Their normals point along the axis. Points in one place are several. */
  void AddFaces(int axis)
  {
    std::array<int, 3> v;
    for (v[0] = -1; v[0] < this->Size[0]; ++v[0])
    {
      for (v[1] = -1; v[1] < this->Size[1]; ++v[1])
      {
        for (v[2] = -1; v[2] < this->Size[2]; ++v[2])
        {
          std::array<int, 3> next = v;
          ++next[axis];
          const Sides sides = { { this->LabelAt(v), this->LabelAt(next) } };
          if (sides[0] != sides[1])
          {
            this->AddFace(next, axis, sides);
          }
        }
      }
    }
  }

  void AddFace(const std::array<int, 3>& low, int axis, const Sides& sides)
  {
    const Id first = static_cast<Id>(this->Soup.Points.size());
    for (int k = 0; k < 4; ++k)
    {
      Point p = { { double(low[0]), double(low[1]), double(low[2]) } };
      p[(axis + 1) % 3] += k == 1 || k == 2;
      p[(axis + 2) % 3] += k >= 2;
      this->Soup.Points.push_back(p);
    }
    this->Soup.Triangles.push_back({ { first, first + 1, first + 2 } });
    this->Soup.Triangles.push_back({ { first, first + 2, first + 3 } });
    this->Between.insert(this->Between.end(), 2, sides);
  }
};

void TurnOver(Triangle& triangle)
{
  std::swap(triangle[1], triangle[2]);
}

/** The volumes that the triangles around each label enclose. */
std::map<Id, double> VolumesOf(const Voxels& voxels, const std::vector<unsigned char>& turned)
{
  std::map<Id, std::vector<BoundaryTriangle>> around;
  for (std::size_t t = 0; t < voxels.Between.size(); ++t)
  {
    for (int side = 0; side < 2; ++side)
    {
      Triangle triangle = voxels.Soup.Triangles[t];
      if ((side == 1) != (turned[t] != 0))
      {
        TurnOver(triangle);
      }
      around[voxels.Between[t][side]].push_back({ triangle, static_cast<Id>(t) });
    }
  }
  std::map<Id, double> volumes;
  for (const auto& [label, triangles] : around)
  {
    volumes[label] = VolumeWithin(voxels.Soup.Points, triangles);
  }
  return volumes;
}

std::map<Id, double> CountsOf(const Voxels& voxels)
{
  std::map<Id, double> counts;
  for (const Id label : voxels.Labels)
  {
    ++counts[label];
    --counts[None];
  }
  return counts;
}

TEST(AgreeOnSides, LeavesTrianglesThatAgree)
{
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round)
  {
    const Voxels voxels({ { 3, 2, 4 } }, random, 3);
    const auto turned = AgreeOnSides(voxels.Soup, voxels.Between);
    EXPECT_EQ(std::count(turned.begin(), turned.end(), 1), 0);
    EXPECT_EQ(VolumesOf(voxels, turned), CountsOf(voxels));
  }
}

TEST(AgreeOnSides, FindsThemHoweverTrianglesRun)
{
  std::mt19937 random(4);
  for (int round = 0; round < 60; ++round)
  {
    SCOPED_TRACE(round);
    Voxels voxels({ { 4, 3, 4 } }, random, 4);
    for (std::size_t t = 0; t < voxels.Between.size(); ++t)
    {
      // At random, all, or where labels are sorted and corners are not.
      Sides& sides = voxels.Between[t];
      if (round % 3 == 2 ? sides[0] == None || (sides[1] != None && sides[0] > sides[1])
                         : round % 3 == 1 || random() % 2)
      {
        std::swap(sides[0], sides[1]);
      }
    }
    EXPECT_EQ(VolumesOf(voxels, AgreeOnSides(voxels.Soup, voxels.Between)), CountsOf(voxels));
  }
}

TEST(AgreeOnSides, BelievesMostTrianglesBetweenTwoRegions)
{
  std::mt19937 random(5);
  Voxels voxels({ { 1, 1, 2 } }, random, 1);
  std::swap(voxels.Between[3][0], voxels.Between[3][1]);
  EXPECT_EQ(VolumesOf(voxels, AgreeOnSides(voxels.Soup, voxels.Between)), CountsOf(voxels));
  for (Sides& sides : voxels.Between)
  {
    std::swap(sides[0], sides[1]); // a cavity of two voxels: nothing else tells
  }
  const auto volumes = VolumesOf(voxels, AgreeOnSides(voxels.Soup, voxels.Between));
  EXPECT_EQ(volumes.at(0), -2);
}
} // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/LooseOctree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

using namespace insideout;

namespace
{
/** A box of any width, from a point's to that of all space, and sometimes beyond it. */
Box RandomBox(std::mt19937& random)
{
  std::uniform_real_distribution<double> anywhere(-1.2, 1.2);
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    box.Low[axis] = anywhere(random);
    const double width = std::pow(anywhere(random), 8);
    box.High[axis] = box.Low[axis] + (random() % 4 == 0 ? 0 : width);
  }
  return box;
}

std::vector<Id> Meeting(const LooseOctree& octree, const Box& box)
{
  std::vector<Id> found;
  octree.Visit(box, [&found](Id item) { found.push_back(item); });
  std::sort(found.begin(), found.end());
  return found;
}
} // namespace

TEST(LooseOctree, FindsWhatIsThereWhileBoxesComeAndGo)
{
  std::mt19937 random(1);
  LooseOctree octree({ { { -1, -1, -1 } }, { { 1, 1, 1 } } });
  std::map<Id, Box> there;
  std::size_t met = 0;
  for (Id item = 0; item < 3000; ++item)
  {
    const Box box = RandomBox(random);
    octree.Insert(item, box);
    there[item] = box;
    if (random() % 3 > 0)
    {
      const auto gone =
        std::next(there.begin(), static_cast<std::ptrdiff_t>(random() % there.size()));
      octree.Remove(gone->first, gone->second);
      there.erase(gone);
    }
    const Box asked = RandomBox(random);
    std::vector<Id> expected;
    for (const auto& [other, bounds] : there)
    {
      if (bounds.Meets(asked))
      {
        expected.push_back(other);
      }
    }
    ASSERT_EQ(Meeting(octree, asked), expected) << "after " << item;
    met += expected.size();
  }
  EXPECT_GT(met, 3000U);
}

TEST(LooseOctree, FindsOneOfManySmallBoxes)
{
  LooseOctree octree({ { { 0, 0, 0 } }, { { 1, 1, 1 } } });
  constexpr int size = 32;
  const auto small = [](double x, double y, double z) -> Box {
    return { { { x, y, z } }, { { x + 0.01, y + 0.01, z + 0.01 } } };
  };
  for (int i = 0; i < size * size * size; ++i)
  {
    octree.Insert(i,
      small(
        i % size / (size + 1.0), i / size % size / (size + 1.0), i / size / size / (size + 1.0)));
  }
  EXPECT_EQ(Meeting(octree, small(0.49, 0.49, 0.49)).size(), 1U);
}

TEST(LooseOctree, TakesManyBoxesInOnePlace)
{
  LooseOctree octree({ { { 0, 0, 0 } }, { { 0, 0, 0 } } });
  const Box box = { { { 5, 5, 5 } }, { { 5, 5, 5 } } };
  for (Id item = 0; item < 100; ++item)
  {
    octree.Insert(item, box);
  }
  for (Id item = 0; item < 99; ++item)
  {
    octree.Remove(item, box);
  }
  EXPECT_EQ(Meeting(octree, box), std::vector<Id>{ 99 });
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Verdict.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace insideout;

TEST(Verdict, SaysOfAVolumeThatItIsExactOrHowSureItIs)
{
  EXPECT_EQ(VolumeInWords(1.875, 1.875, 1.875), "1.875");
  EXPECT_EQ(VolumeInWords(14093.6478, 14093.6478, 14093.6478), "14093.6");
  EXPECT_EQ(VolumeInWords(4.2934, 4.213, 4.367), "about 4.29 (95 %: 4.21 to 4.37)");
  EXPECT_EQ(VolumeInWords(64989.3, 63667, 66311.6), "about 65000 (95 %: 63000 to 67000)");
  EXPECT_EQ(VolumeInWords(5389.5, 350.8, 25732.9), "about 10000 (95 %: 0 to 30000)");
  EXPECT_EQ(VolumeInWords(3.2e-5, 3.1e-5, 3.3e-5), "about 0.000032 (95 %: 0.000031 to 0.000033)");
  EXPECT_EQ(VolumeInWords(2e-6, 0, 3e-5), "about 0 (95 %: 0 to 0.00003)");
  EXPECT_EQ(VolumeInWords(3.21e-12, 3.1e-12, 3.3e-12), "about 3.2e-12 (95 %: 3.1e-12 to 3.3e-12)");
  EXPECT_EQ(VolumeInWords(3.21e12, 3.1e12, 3.3e12), "about 3.2e+12 (95 %: 3.1e+12 to 3.3e+12)");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(VolumeInWords(1e300, 0, infinity), "about 1e+300 (95 %: 0 to inf)");
  EXPECT_EQ(VolumeInWords(2e-320, 0, 4e-320), "about 0 (95 %: 0 to 1e-300)");
}

Statistics Surface(double closed, double holed, double sheets)
{
  return { { "Shells", closed + holed + sheets }, { "ClosedShells", closed },
    { "HoledShells", holed }, { "SheetShells", sheets }, { "Facets", 1234567 } };
}

std::string VerdictOn(Statistics statistics, const Statistics& more)
{
  statistics.insert(statistics.end(), more.begin(), more.end());
  return Verdict(statistics);
}

const Statistics Unsure = { { "EnclosedVolume", 2 }, { "EnclosedVolumeLow", 1.7 },
  { "EnclosedVolumeHigh", 2.3 } };
const Statistics Nothing = { { "EnclosedVolume", 0 }, { "EnclosedVolumeHigh", 0.1 } };

TEST(Verdict, TellsTheMeshOnceThereIsOne)
{
  EXPECT_EQ(VerdictOn(Surface(0, 1, 2), Unsure),
    "bounds a solid of volume about 2.0 (95 %: 1.7 to 2.3), once its holes are closed; 2 sheets "
    "enclose nothing");
  Statistics meshed = Unsure;
  meshed.emplace_back("Volume", 2.125);
  EXPECT_EQ(VerdictOn(Surface(0, 1, 2), meshed),
    "bounds a solid of volume 2.125, once its holes are closed; 2 sheets enclose nothing");
}

TEST(Verdict, SaysThatSharedFacetsMayMeanMore)
{
  Statistics doubtful = { { "Volume", 20 } };
  doubtful.emplace_back("DoubtfulCopies", 4);
  EXPECT_EQ(VerdictOn(Surface(2, 0, 0), doubtful),
    "bounds a solid of volume 20; more if surfaces share 4 facets");
  doubtful.back().second = 1;
  EXPECT_EQ(VerdictOn(Surface(0, 0, 2), doubtful),
    "means a solid of volume 20 by its winding number; its shells alone bound none: 2 sheets; more "
    "if surfaces share 1 facet");
}

TEST(Verdict, SaysWhyThereIsNoSolid)
{
  EXPECT_EQ(VerdictOn(Surface(0, 0, 1), Nothing), "bounds no solid: a sheet");
  EXPECT_EQ(VerdictOn(Surface(0, 0, 2), Unsure),
    "means a solid of volume about 2.0 (95 %: 1.7 to 2.3) by its winding number; its shells alone "
    "bound none: 2 sheets");
  EXPECT_EQ(VerdictOn(Surface(0, 1, 0), Nothing),
    "bounds no solid: its winding number is above 1/2 nowhere");
  EXPECT_EQ(VerdictOn(Surface(1, 0, 0), { { "Volume", 0 }, { "MaximumW", 1 } }),
    "bounds no solid: no cell of its mesh is inside");
  Statistics inward = Nothing;
  inward.emplace_back("Cavities", 1);
  EXPECT_EQ(VerdictOn(Surface(1, 0, 0), inward), "bounds no solid: it is inside out as oriented");
  EXPECT_EQ(Verdict({}), "bounds no solid: its facets cancel in pairs or do not count");
  EXPECT_EQ(Verdict({ { "Planar", 1 }, { "Area", 400 } }),
    "bounds no solid: it lies in one plane, where it covers an area of 400");
}

TEST(Verdict, CountsWhatIsTurned)
{
  const Statistics exact = { { "EnclosedVolume", 9 }, { "EnclosedVolumeLow", 9 },
    { "EnclosedVolumeHigh", 9 } };
  Statistics turned = exact;
  turned.emplace_back("TurnedShells", 1);
  EXPECT_EQ(VerdictOn(Surface(2, 0, 0), turned),
    "bounds a solid of volume 9 after turning 1 of 2 shells over");
  EXPECT_EQ(VerdictOn(Surface(1, 0, 0), turned),
    "bounds a solid of volume 9 after it is turned over as a whole");
  Statistics facets = exact;
  facets.emplace_back("TurnedFacets", 1234);
  facets.emplace_back("Membranes", 2);
  EXPECT_EQ(VerdictOn(Surface(1, 0, 0), facets),
    "bounds a solid of volume 9 after turning 1,234 facets over, parted by 2 membranes");
}

TEST(Verdict, SpeaksOfAreasInAPlane)
{
  EXPECT_EQ(Verdict({ { "Dimension", 2 }, { "Area", 0 } }), "bounds no area in its plane");
  EXPECT_EQ(Verdict({ { "Dimension", 2 }, { "Area", 4 }, { "TurnedSegments", 1 },
              { "InputSegments", 8 }, { "OpenEnds", 2 } }),
    "bounds an area of 4 in a plane after turning 1 of 8 segments over, once its gaps are closed");
}
} // namespace

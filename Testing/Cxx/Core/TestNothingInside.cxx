// SPDX-License-Identifier: GPL-3.0-or-later
#include "NothingInside.h"

#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

namespace
{
using namespace insideout;
using namespace testmeshes;

std::string Cause(const TriangleSoup& soup, Orientation orientation = Orientation::Automatic)
{
  Monitor monitor;
  HullMeshParameters parameters;
  parameters.Orientation = orientation;
  parameters.Budgets.Engine = TetrahedralizationEngine::Exact;
  const std::string text = NothingInside(MeshHull(soup, parameters, monitor));
  EXPECT_EQ(text.find('\n'), std::string::npos);
  return text;
}

void ExpectWords(const std::string& text, const std::string& range, const std::string& cause,
  const std::string& remedy)
{
  EXPECT_EQ(text.find("nothing is inside: w ranges from " + range), 0u) << text;
  EXPECT_NE(text.find(cause), std::string::npos) << text;
  EXPECT_NE(text.find(remedy), std::string::npos) << text;
}

/** Two squares, one above the other. */
TriangleSoup Sheets()
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  box.Triangles.resize(4);
  return box;
}

TEST(NothingInside, KnowsATwoSidedSurface)
{
  TriangleSoup soup = Sheets();
  const TriangleSoup other = Reversed(soup);
  soup.Triangles.insert(soup.Triangles.end(), other.Triangles.begin(), other.Triangles.end());
  ExpectWords(Cause(soup), "0.000000 to 0.000000", "two-sided", "Give each once");
}

TEST(NothingInside, KnowsASurfaceThatDoesNotParticipate)
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  box.NonParticipating.assign(12, 1);
  ExpectWords(
    Cause(box), "0.000000 to 0.000000", "No facet participates", "NonParticipatingArrayName");
}

TEST(NothingInside, KnowsASurfaceThatIsInsideOut)
{
  const TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  ExpectWords(Cause(Reversed(box), Orientation::AsGiven), "-1.000000 to -1.000000", "inside out",
    "set Orientation");
  ExpectWords(
    Cause(box, Orientation::Reverse), "-1.000000 to -1.000000", "inside out", "set Orientation");
}

TEST(NothingInside, KnowsASurfaceThatIsTooOpen)
{
  TriangleSoup soup = Box({ 0, 0, 0 }, { 1, 1, 1 });
  soup.Triangles = { soup.Triangles[0], soup.Triangles[4] };
  const std::string text = Cause(soup);
  ExpectWords(text, "0.", "too open", "close its largest holes");
  EXPECT_EQ(text.find("CountDuplicates"), std::string::npos);

  soup.Triangles.insert(soup.Triangles.end(), { soup.Triangles[0], soup.Triangles[1] });
  ExpectWords(Cause(soup), "0.", "too open", "CountDuplicates");
}

TEST(NothingInside, KnowsASurfaceThatFacesBothWays)
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  for (std::size_t t = 0; t < 12; t += 2)
  {
    std::swap(box.Triangles[t][1], box.Triangles[t][2]);
  }
  ExpectWords(
    Cause(box, Orientation::AsGiven), "", "faces both ways", "set Orientation to Automatic");
}

TEST(NothingInside, DoesNotTakeSheetsForASurfaceThatIsInsideOut)
{
  // Above three that face up w is nearly -3/2, and turning them over would help nothing.
  TriangleSoup soup;
  for (const double z : { 0.0, 0.01, 0.02 })
  {
    TriangleSoup square;
    square.Points = { { 0, 0, z }, { 1, 0, z }, { 1, 1, z }, { 0, 1, z + 0.001 } };
    square.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
    soup = Join(soup, square);
  }
  soup =
    Join(soup, { { { 0.4, 0.4, 0.5 }, { 0.6, 0.4, 0.5 }, { 0.5, 0.6, 0.6 } }, { { 0, 1, 2 } } });
  const std::string text = Cause(soup);
  EXPECT_EQ(text.find("inside out"), std::string::npos) << text;
  EXPECT_NE(text.find("too open"), std::string::npos) << text;
  EXPECT_NE(text.find("set Thicken"), std::string::npos) << text;
}

/** A box without a floor, upside down: flat, so that its hole is larger than its sides. */
TriangleSoup Tray(double height)
{
  TriangleSoup tray = Box({ 0, 0, 0 }, { 20, 20, height });
  tray.Triangles.erase(tray.Triangles.begin(), tray.Triangles.begin() + 2);
  return tray;
}

TEST(NothingInside, KnowsASheetThatMayFaceInward)
{
  ExpectWords(Cause(Reversed(Tray(3))), "-0.", "too open", "set Orientation to Reverse");
}

TEST(NothingInside, KnowsThatGammaIsTooLarge)
{
  ExpectWords(
    Cause(Box({ 0, 0, 0 }, { 1, 1, 1 })), "1.000000 to 1.000000", "smoothed away", "Gamma lower");
}
} // namespace

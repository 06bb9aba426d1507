// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/Summarize.h"

#include "Common/AddUp.h"
#include "Data/StatisticsArrays.h"
#include "Out/MakeOutputs.h"
#include "Verdict.h"

#include <vtkCompositeDataSet.h>
#include <vtkCompositeDataSetRange.h>
#include <vtkDataObject.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <vector>

namespace vtkInsideOut
{
namespace
{
// One line each. The first statistic is always shown, the others if they are not 0.
const std::vector<std::vector<std::string>> Lines = { { "InputTriangles", "Components" },
  { "IntersectingPairs", "NonManifoldEdges", "InconsistentEdges", "DuplicateFacets",
    "DegenerateFacets", "TurnedFacets" },
  { "OpenEdges", "HoledShells" }, { "InsideCells", "RefinedCells", "Regions" },
  { "OutlierFacets", "OutliersLost", "OutliersLeftOut", "OutliersDegenerate" } };

/** "Open Edges" for "OpenEdges", like panels' labels of options. */
std::string Words(const std::string& name)
{
  std::string words;
  for (const char letter : name)
  {
    words +=
      std::isupper(letter) && !words.empty() ? std::string(" ") + letter : std::string(1, letter);
  }
  return words;
}

std::string Digits(double value)
{
  std::ostringstream digits;
  digits.precision(value == std::floor(value) ? 15 : 6);
  digits << value;
  return digits.str();
}
} // namespace

std::string Summarize(vtkDataObject* solid)
{
  insideout::Statistics sums;
  const auto add = [&](vtkDataObject* data)
  { insideout::AddUp(StatisticsOf(data->GetFieldData()), sums); };
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(solid))
  {
    for (vtkDataObject* block : vtk::Range(blocks))
    {
      add(block);
    }
  }
  else
  {
    add(solid);
  }
  std::string text;
  for (const std::vector<std::string>& names : Lines)
  {
    std::string line;
    for (const std::string& name : names)
    {
      const auto found =
        std::find_if(sums.begin(), sums.end(), [&](const auto& one) { return one.first == name; });
      if (found != sums.end() && (found->second != 0 || name == names[0]))
      {
        line += (line.empty() ? "" : ", ") + Words(name) + " " + Digits(found->second);
      }
    }
    text += line.empty() || text.empty() ? line : "\n" + line;
  }
  return sums.empty() ? text : text + "\n" + insideout::Verdict(sums);
}
} // namespace vtkInsideOut

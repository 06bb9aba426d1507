// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SizeRules.h"

#include "Common/RuleText.h"

#include <algorithm>
#include <iterator>

namespace insideout
{
namespace
{
using Kind = SizeRule::Kind;

struct Word
{
  const char* Text;
  Kind What;
  const char* Form;
};

const Word Words[] = {
  { "curvature", Kind::Curvature, "curvature=EDGES" },
  { "gap", Kind::Gap, "gap=CELLS" },
  { "tag", Kind::Tag, "tag NAME=LENGTH" },
  { "region", Kind::Region, "region NAME=LENGTH" },
  { "point", Kind::Point, "point X Y Z [RADIUS]=LENGTH" },
};

SizeRule ReadRule(const std::string& text)
{
  const std::size_t equals = text.rfind('='); // names may contain "=", too
  const auto [head, tail] = SplitHead(Trimmed(text.substr(0, equals)));
  const auto* const word = std::find_if(std::begin(Words), std::end(Words),
    [&head = head](const Word& one) { return one.Text == head; });
  if (word == std::end(Words) || equals == std::string::npos)
  {
    std::string known;
    for (const Word& one : Words)
    {
      known += (known.empty() ? "" : ", ") + std::string(one.Form);
    }
    RefuseRule(text, "is none of " + known);
  }
  SizeRule rule = { word->What, 0, "", text };
  const std::vector<double> values = NumbersOf(text.substr(equals + 1), text);
  if (values.size() != 1 || !(values.front() > 0))
  {
    RefuseRule(text, "does not end with one number above 0");
  }
  rule.Value = values.front();
  const bool isNamed = rule.What == Kind::Tag || rule.What == Kind::Region;
  const std::vector<double> place = isNamed ? std::vector<double>() : NumbersOf(tail, text);
  const bool isPlaced = rule.What == Kind::Point;
  if (isNamed ? tail.empty() : isPlaced ? place.size() < 3 || place.size() > 4 : !place.empty())
  {
    RefuseRule(text, "is not of the form " + std::string(word->Form));
  }
  rule.Name = isNamed ? tail : "";
  if (isPlaced)
  {
    std::copy_n(place.begin(), 3, rule.Center.begin());
    rule.Radius = place.size() > 3 ? place[3] : 0;
  }
  if (rule.Radius < 0)
  {
    RefuseRule(text, "has a radius below 0");
  }
  return rule;
}
} // namespace

std::vector<SizeRule> ReadSizeRules(const std::string& text)
{
  std::vector<SizeRule> rules;
  for (const std::string& part : SplitText(text, ';'))
  {
    const std::string rule = Trimmed(part);
    if (!rule.empty())
    {
      rules.push_back(ReadRule(rule));
    }
  }
  return rules;
}
} // namespace insideout

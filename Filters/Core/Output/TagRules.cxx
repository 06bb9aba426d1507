// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/TagRules.h"

#include "Common/Box.h"
#include "Common/DisjointSets.h"
#include "Common/Edge.h"
#include "Common/NearestPoint.h"
#include "Common/RuleText.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>

namespace insideout
{
namespace
{
using Kind = TagCondition::Kind;

constexpr double DegreesOfNormal = 10;
constexpr double DegreesOfFeature = 30; // as RefinementParameters::FeatureAngle

/** Limit of the distance from a plane that counts as rounding, in diagonals. */
constexpr double ReachOfPlane = 1e-6;

double Radians(double degrees)
{
  return degrees * std::acos(-1.0) / 180;
}

/** A kind of condition in the text of a rule. */
struct Word
{
  const char* Text;
  Kind What;
  std::size_t Numbers;
  std::optional<double> Default; ///< of one number more
  const char* Takes;
};

const Word Words[] = {
  { "normal", Kind::Normal, 3, DegreesOfNormal, "X Y Z [DEGREES]" },
  { "box", Kind::Box, 6, std::nullopt, "X Y Z X Y Z" },
  { "sphere", Kind::Sphere, 4, std::nullopt, "X Y Z RADIUS" },
  { "plane", Kind::Plane, 6, -1.0, "X Y Z NX NY NZ [DISTANCE]" }, // -1: by the surface's size
  { "face", Kind::Face, 3, DegreesOfFeature, "X Y Z [DEGREES]" },
  { "faces", Kind::Faces, 0, DegreesOfFeature, "[DEGREES]" },
  { "nearest", Kind::Nearest, 3, std::nullopt, "X Y Z" },
};
constexpr const char* WordOfArray = "array";

/** Check that a direction has a length. */
void CheckDirection(const TagCondition& condition, std::size_t first, const std::string& rule)
{
  const std::vector<double>& n = condition.Numbers;
  if (!(Length({ { n[first], n[first + 1], n[first + 2] } }) > 0))
  {
    RefuseRule(rule, "has a direction without a length");
  }
}

TagCondition ReadCondition(const std::string& given, const std::string& rule)
{
  const auto [head, tail] = SplitHead(Trimmed(given));
  if (head.empty())
  {
    RefuseRule(rule, "has a condition without a word");
  }
  if (head == WordOfArray)
  {
    if (tail.empty())
    {
      RefuseRule(rule, "names no array");
    }
    return { Kind::Array, {}, tail };
  }
  const auto* const word = std::find_if(std::begin(Words), std::end(Words),
    [&head = head](const Word& one) { return one.Text == head; });
  if (word == std::end(Words))
  {
    std::string known;
    for (const Word& one : Words)
    {
      known += std::string(one.Text) + ", ";
    }
    RefuseRule(rule, "begins with \"" + head + "\"; it can be " + known + "or " + WordOfArray);
  }
  TagCondition condition = { word->What, NumbersOf(tail, rule), "" };
  const std::size_t count = condition.Numbers.size();
  if (count != word->Numbers && !(word->Default && count == word->Numbers + 1))
  {
    RefuseRule(rule,
      "has " + std::to_string(count) + " numbers behind " + head + ", which takes " + word->Takes);
  }
  const bool isAtLeast0 = condition.What == Kind::Sphere || count > word->Numbers;
  if (isAtLeast0 && condition.Numbers.back() < 0)
  {
    RefuseRule(rule, "ends with a number below 0");
  }
  if (word->Default && count == word->Numbers)
  {
    condition.Numbers.push_back(*word->Default);
  }
  if (condition.What == Kind::Normal || condition.What == Kind::Plane)
  {
    CheckDirection(condition, condition.What == Kind::Plane ? 3 : 0, rule);
  }
  return condition;
}

/** The triangles of a surface, prepared for conditions. */
class Matcher
{
public:
  Matcher(const std::vector<TagRule>& rules, const TaggedSurface& surface)
    : Surface(surface)
    , Box(BoundingBox(surface.Points))
  {
    for (const Triangle& triangle : surface.Triangles)
    {
      this->Corners.push_back(CornersOf(surface.Points, triangle));
      const std::array<Point, 3>& c = this->Corners.back();
      Point center;
      for (int axis = 0; axis < 3; ++axis)
      {
        center[axis] = c[0][axis] / 3 + c[1][axis] / 3 + c[2][axis] / 3;
      }
      this->Centers.push_back(center);
    }
    this->FindNormals();
    for (const TagRule& rule : rules)
    {
      for (const TagCondition& condition : rule.Conditions)
      {
        if (condition.What == Kind::Nearest)
        {
          this->Named.push_back(PointIn(condition, 0));
        }
      }
    }
  }

  /** @param[out] faces the number of each triangle's face, if the condition refers to all faces */
  std::vector<bool> Holds(const TagCondition& condition, std::vector<Id>& faces)
  {
    const std::vector<double>& n = condition.Numbers;
    std::vector<bool> holds(this->Corners.size(), true);
    const auto test = [&](const auto& of)
    {
      for (std::size_t t = 0; t < holds.size(); ++t)
      {
        holds[t] = of(t);
      }
    };
    switch (condition.What)
    {
      case Kind::Normal:
        test([&](std::size_t t)
          { return AngleBetween(this->Normals[t], PointIn(condition, 0)) <= Radians(n[3]); });
        break;
      case Kind::Box:
      {
        insideout::Box box = insideout::Box::Empty();
        box.Add(PointIn(condition, 0));
        box.Add(PointIn(condition, 3));
        test([&](std::size_t t) { return box.Holds(this->Centers[t]); });
        break;
      }
      case Kind::Sphere:
        test(
          [&](std::size_t t) { return Distance(this->Centers[t], PointIn(condition, 0)) <= n[3]; });
        break;
      case Kind::Plane:
        test([&](std::size_t t) { return this->IsInPlane(t, condition); });
        break;
      case Kind::Face:
      {
        const std::vector<Id>& patches = this->FacesBetween(n[3]);
        const Id nearest = this->NearestTo(PointIn(condition, 0));
        test([&](std::size_t t) { return patches[t] == patches[nearest]; });
        break;
      }
      case Kind::Faces:
        faces = this->FacesBetween(n[0]);
        break;
      case Kind::Nearest:
        test([&](std::size_t t) { return this->IsNearest(t, PointIn(condition, 0)); });
        break;
      case Kind::Array:
        test([&](std::size_t t) { return this->Surface.IsIn(condition.Name, static_cast<Id>(t)); });
        break;
    }
    return holds;
  }

private:
  static Point PointIn(const TagCondition& condition, std::size_t first)
  {
    const std::vector<double>& n = condition.Numbers;
    return { { n[first], n[first + 1], n[first + 2] } };
  }

  /** Pieces of one facet have its normal: rounding leaves thin pieces no reliable one. */
  void FindNormals()
  {
    std::unordered_map<Id, std::size_t> largest; // by source
    std::vector<double> areas;
    for (std::size_t t = 0; t < this->Corners.size(); ++t)
    {
      const std::array<Point, 3>& c = this->Corners[t];
      this->Normals.push_back(NormalOf(c[0], c[1], c[2]));
      areas.push_back(Length(this->Normals.back()));
      const auto [found, isNew] = largest.insert({ this->Surface.Sources[t], t });
      found->second = areas[t] > areas[found->second] ? t : found->second;
    }
    const std::vector<Point> own = this->Normals;
    for (std::size_t t = 0; t < own.size(); ++t)
    {
      if (this->Surface.Sources[t] != None)
      {
        const Point& normal = own[largest.at(this->Surface.Sources[t])];
        const double sign =
          Dot(normal, own[t]) < 0 ? -1 : 1; // it may bound the solid on both sides
        this->Normals[t] = { { sign * normal[0], sign * normal[1], sign * normal[2] } };
      }
    }
  }

  /** The angle; 0 if one of the vectors has no length. */
  static double AngleBetween(const Point& a, const Point& b)
  {
    return std::atan2(Length(Cross(a, b)), Dot(a, b));
  }

  bool IsInPlane(std::size_t triangle, const TagCondition& condition) const
  {
    const Point normal = PointIn(condition, 3);
    const double given = condition.Numbers[6];
    const double reach = given < 0 ? ReachOfPlane * Distance(this->Box.Low, this->Box.High) : given;
    const std::array<Point, 3>& corners = this->Corners[triangle];
    return std::all_of(corners.begin(), corners.end(),
      [&](const Point& corner)
      {
        const Point from = Difference(corner, PointIn(condition, 0));
        return std::abs(Dot(from, normal)) <= reach * Length(normal);
      });
  }

  bool IsNearest(std::size_t triangle, const Point& point) const
  {
    const double distance = Distance(this->Centers[triangle], point);
    return std::none_of(this->Named.begin(), this->Named.end(),
      [&](const Point& other) { return Distance(this->Centers[triangle], other) < distance; });
  }

  Id NearestTo(const Point& point) const
  {
    Id nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < this->Corners.size(); ++t)
    {
      const double distance = Distance(NearestPointOf(this->Corners[t], point), point);
      if (distance < least)
      {
        nearest = static_cast<Id>(t);
        least = distance;
      }
    }
    return nearest;
  }

  /**
   * The number of each triangle's face. Triangles belong to one face if they are connected by edges
   * between two triangles with no larger angle, or within one facet.
   */
  const std::vector<Id>& FacesBetween(double degrees)
  {
    std::vector<Id>& faces = this->Faces[degrees];
    if (!faces.empty())
    {
      return faces;
    }
    std::map<Point, Id> places; // points may be repeated, as at seams
    std::vector<Id> placeOf;
    for (const Point& point : this->Surface.Points)
    {
      const Id next = static_cast<Id>(places.size());
      placeOf.push_back(places.insert({ point, next }).first->second);
    }
    std::unordered_map<Edge, std::vector<Id>, HashOfEdge> triangles;
    for (std::size_t t = 0; t < this->Surface.Triangles.size(); ++t)
    {
      const Triangle& corners = this->Surface.Triangles[t];
      for (int k = 0; k < 3; ++k)
      {
        const Edge edge = EdgeBetween(placeOf[corners[k]], placeOf[corners[(k + 1) % 3]]);
        triangles[edge].push_back(static_cast<Id>(t));
      }
    }
    DisjointSets sets(this->Surface.Triangles.size());
    for (const auto& [edge, both] : triangles)
    {
      if (both.size() != 2)
      {
        continue;
      }
      const Id source = this->Surface.Sources[both[0]];
      if ((source != None && source == this->Surface.Sources[both[1]]) ||
        AngleBetween(this->Normals[both[0]], this->Normals[both[1]]) <= Radians(degrees))
      {
        sets.Join(both[0], both[1]);
      }
    }
    std::map<Id, Id> numbers;
    for (std::size_t t = 0; t < this->Surface.Triangles.size(); ++t)
    {
      const Id next = static_cast<Id>(numbers.size());
      faces.push_back(numbers.insert({ sets.Find(static_cast<Id>(t)), next }).first->second);
    }
    return faces;
  }

  const TaggedSurface& Surface;
  insideout::Box Box;
  std::vector<std::array<Point, 3>> Corners;
  std::vector<Point> Centers;
  std::vector<Point> Normals;
  std::vector<Point> Named; ///< the points of conditions on the nearest face
  std::map<double, std::vector<Id>> Faces;
};
} // namespace

std::vector<TagRule> ReadTagRules(const std::string& text)
{
  std::vector<TagRule> rules;
  for (const std::string& part : SplitText(text, ';'))
  {
    TagRule rule;
    rule.Text = Trimmed(part);
    if (rule.Text.empty())
    {
      continue;
    }
    const std::size_t equals = rule.Text.find('=');
    rule.Name = Trimmed(rule.Text.substr(0, equals));
    if (equals == std::string::npos || rule.Name.empty())
    {
      RefuseRule(rule.Text, "is not a name, an equals sign and a condition");
    }
    for (const std::string& condition : SplitText(rule.Text.substr(equals + 1), '&'))
    {
      rule.Conditions.push_back(ReadCondition(condition, rule.Text));
    }
    rules.push_back(rule);
  }
  return rules;
}

std::vector<TagMatch> MatchTagRules(const std::vector<TagRule>& rules, const TaggedSurface& surface)
{
  std::vector<TagMatch> matches(surface.Triangles.size());
  if (matches.empty())
  {
    return matches;
  }
  Matcher matcher(rules, surface);
  for (std::size_t r = 0; r < rules.size(); ++r)
  {
    std::vector<bool> holds(matches.size(), true);
    std::vector<Id> faces;
    for (const TagCondition& condition : rules[r].Conditions)
    {
      const std::vector<bool> more = matcher.Holds(condition, faces);
      std::transform(
        holds.begin(), holds.end(), more.begin(), holds.begin(), std::logical_and<bool>());
    }
    std::map<Id, Id> numbers; // only faces with a matching triangle
    for (std::size_t t = 0; t < matches.size(); ++t)
    {
      if (holds[t])
      {
        const Id next = static_cast<Id>(numbers.size());
        matches[t].Rule = static_cast<Id>(r);
        matches[t].Face = faces.empty() ? None : numbers.insert({ faces[t], next }).first->second;
      }
    }
  }
  return matches;
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/ResolutionLaws.h"

#include "Support/ExactReference.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <random>

namespace testmeshes
{
namespace
{
constexpr double LengthTolerance = 1e-12; ///< of the size
constexpr double WindingTolerance = 1e-9;
constexpr double WindingDistance = 1e-6; ///< of the size

using Real = long double;
__extension__ typedef __float128 Wide;

template <class T>
using VectorOf = std::array<T, 3>;
using Vector = VectorOf<Real>;

template <class T = Real>
VectorOf<T> Minus(const Point& a, const Point& b)
{
  return { static_cast<T>(a[0]) - b[0], static_cast<T>(a[1]) - b[1], static_cast<T>(a[2]) - b[2] };
}

template <class T>
VectorOf<T> Cross(const VectorOf<T>& a, const VectorOf<T>& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

template <class T>
T Dot(const VectorOf<T>& a, const VectorOf<T>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
Real Length(const VectorOf<T>& a)
{
  return std::sqrt(static_cast<Real>(Dot(a, a)));
}

using Corners = std::array<Point, 3>;

Corners CornersOf(const FacetComplex& surface, Id facet)
{
  const Triangle& t = surface.Facets[facet];
  return { surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]] };
}

/** Twice the area, along the normal. */
template <class T = Real>
VectorOf<T> Normal(const Corners& t)
{
  return Cross(Minus<T>(t[1], t[0]), Minus<T>(t[2], t[0]));
}

Real Perimeter(const Corners& t)
{
  return Length(Minus(t[1], t[0])) + Length(Minus(t[2], t[1])) + Length(Minus(t[0], t[2]));
}

Real DistanceToSegment(const Point& p, const Point& a, const Point& b)
{
  const Vector along = Minus(b, a);
  const Vector toP = Minus(p, a);
  const Real t = std::clamp<Real>(Dot(toP, along) / Dot(along, along), 0, 1);
  return Length(Vector{ toP[0] - t * along[0], toP[1] - t * along[1], toP[2] - t * along[2] });
}

Real DistanceToEdges(const Point& p, const Corners& t)
{
  return std::min({ DistanceToSegment(p, t[0], t[1]), DistanceToSegment(p, t[1], t[2]),
    DistanceToSegment(p, t[2], t[0]) });
}

/** The distance to the triangle's plane where p is above the triangle, else to its edges. */
template <class T>
Real DistanceAbove(const Point& p, const Corners& t)
{
  const VectorOf<T> normal = Normal<T>(t);
  for (int k = 0; k < 3; ++k)
  {
    if (Dot(Cross(normal, Minus<T>(t[(k + 1) % 3], t[k])), Minus<T>(p, t[k])) < 0)
    {
      return DistanceToEdges(p, t);
    }
  }
  return std::abs(static_cast<Real>(Dot(Minus<T>(p, t[0]), normal))) / Length(normal);
}

/** A thin triangle's normal loses as many digits as it is thinner than long. */
Real DistanceToTriangle(const Point& p, const Corners& t)
{
  const Real perimeter = Perimeter(t);
  const bool isThin = Length(Normal(t)) < 1e-3L * perimeter * perimeter;
  return isThin ? DistanceAbove<Wide>(p, t) : DistanceAbove<Real>(p, t);
}

Triangle Sorted(Triangle t)
{
  std::sort(t.begin(), t.end());
  return t;
}

/** +1 where b runs around the same three points as a does, -1 where the other way. */
int Turn(const Triangle& a, const Triangle& b)
{
  const auto first = std::find(b.begin(), b.end(), a[0]) - b.begin();
  return a[1] == b[(first + 1) % 3] ? 1 : -1;
}

bool IsDegenerate(const Corners& t)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto at = [](const Point& p) { return Kernel::Point_3(p[0], p[1], p[2]); };
  return CGAL::collinear(at(t[0]), at(t[1]), at(t[2]));
}

std::string Named(const char* thing, Id id)
{
  return std::string(thing) + " " + std::to_string(id);
}

/** A part of an input facet: which facet of the result, and +1 or -1 by how it is turned. */
struct Part
{
  Id Facet;
  int Turn;
};

/** An input facet that an input triangle belongs to, and how that triangle is turned in it. */
struct Owner
{
  Id Facet = None;
  bool Reversed = false;
};

class Judge
{
public:
  Judge(const FacetComplex& before, const FacetComplex& after)
    : Before(before)
    , After(after)
    , Size(SizeOf(before.Points))
  {
  }

  ResolutionJudgement Run(int windingPoints)
  {
    if (!this->IsWellFormed())
    {
      return this->Found;
    }
    this->CheckPoints();
    this->CheckFacets();
    this->CheckLastFacets();
    this->CheckCrossings();
    this->CheckLoosePoints();
    this->CollectParts();
    this->CheckCoverage();
    this->CheckClosedness();
    this->CheckWinding(windingPoints);
    return this->Found;
  }

private:
  void Violate(const std::string& what) { this->Found.Violations.push_back(what); }

  bool IsWellFormed();
  void CheckPoints();
  void CheckFacets();
  void CheckLastFacets();
  void CheckCrossings();
  void CheckLoosePoints();
  void CollectParts();
  void CollectPartsOf(Id facet, const std::vector<Owner>& owners);
  void CheckCoverage();
  bool IsWhole(Id facet) const;
  void CheckBoundary(Id facet, std::vector<std::string>& violations) const;
  void CheckClosedness();
  void CheckWinding(int points);

  const FacetComplex& Before;
  const FacetComplex& After;
  const Real Size;
  ResolutionJudgement Found;
  std::vector<std::vector<Part>> Parts; ///< per facet of Before
};

bool Judge::IsWellFormed()
{
  const FacetComplex& s = this->After;
  const std::size_t facets = s.Facets.size();
  const bool sizes = s.Origins.size() == s.Points.size() && s.Multiplicity.size() == facets &&
    s.SourceOffsets.size() == facets + 1 && s.SourceOffsets.front() == 0 &&
    s.SourceOffsets.back() == static_cast<Id>(s.Sources.size()) && s.NumberOfConstraints >= 0 &&
    s.NumberOfConstraints <= s.NumberOfFacets() &&
    std::is_sorted(s.SourceOffsets.begin(), s.SourceOffsets.end());
  const auto inRange = [&](const Triangle& t)
  {
    return std::all_of(
      t.begin(), t.end(), [&](Id p) { return p >= 0 && p < static_cast<Id>(s.Points.size()); });
  };
  if (!sizes || !std::all_of(s.Facets.begin(), s.Facets.end(), inRange))
  {
    this->Violate("the arrays do not fit each other");
    return false;
  }
  return true;
}

void Judge::CheckPoints()
{
  const std::size_t count = this->Before.Points.size();
  if (this->After.Points.size() < count ||
    (count > 0 &&
      std::memcmp(this->Before.Points.data(), this->After.Points.data(), count * sizeof(Point)) !=
        0))
  {
    this->Violate("the input points do not come first, bit by bit");
    return;
  }
  for (std::size_t p = 0; p < count; ++p)
  {
    if (this->Before.Origins[p].Points != this->After.Origins[p].Points ||
      this->Before.Origins[p].Weights != this->After.Origins[p].Weights)
    {
      this->Violate(Named("the origin changed of point", static_cast<Id>(p)));
      return;
    }
  }
  std::vector<char> isCorner(this->After.Points.size(), 0);
  for (const Triangle& t : this->After.Facets)
  {
    isCorner[t[0]] = isCorner[t[1]] = isCorner[t[2]] = 1;
  }
  const auto unused = std::find(isCorner.begin() + count, isCorner.end(), 0);
  if (unused != isCorner.end())
  {
    this->Violate(Named("no facet has new point", static_cast<Id>(unused - isCorner.begin())));
  }
}

/** No facet is degenerate, none there twice, sources stand in order. */
void Judge::CheckFacets()
{
  const FacetComplex& s = this->After;
  std::vector<std::pair<Triangle, Id>> sorted;
  for (Id f = 0; f < s.NumberOfConstraints; ++f)
  {
    sorted.push_back({ Sorted(s.Facets[f]), f });
    const Triangle& t = sorted.back().first;
    if (t[0] == t[1] || t[1] == t[2] || IsDegenerate(CornersOf(s, f)))
    {
      this->Violate(Named("degenerate is facet", f));
      break;
    }
    const auto first = s.Sources.begin() + s.SourceOffsets[f];
    const auto last = s.Sources.begin() + s.SourceOffsets[f + 1];
    const auto notAscending = [](const FacetSource& a, const FacetSource& b)
    { return a.Triangle >= b.Triangle; };
    if (first == last || std::adjacent_find(first, last, notAscending) != last)
    {
      this->Violate(Named("no sources, or not in order, has facet", f));
      break;
    }
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (sorted[i].first == sorted[i - 1].first)
    {
      this->Violate(Named("there twice is facet", sorted[i].second));
      break;
    }
  }
}

/** Facets that were not constraints before come last, unchanged. */
void Judge::CheckLastFacets()
{
  const Id count = this->Before.NumberOfFacets() - this->Before.NumberOfConstraints;
  const Id first = this->After.NumberOfFacets() - count;
  this->Found.LeftOut = first - this->After.NumberOfConstraints;
  if (this->Found.LeftOut < 0)
  {
    this->Violate("facets that were no constraints became some, or are missing");
    return;
  }
  for (Id i = 0; i < count; ++i)
  {
    const Id old = this->Before.NumberOfConstraints + i;
    if (this->After.Facets[first + i] != this->Before.Facets[old] ||
      this->After.Multiplicity[first + i] != this->Before.Multiplicity[old])
    {
      this->Violate(Named("changed although no constraint: facet", old));
      return;
    }
  }
}

void Judge::CheckCrossings()
{
  const std::vector<Triangle> constraints(
    this->After.Facets.begin(), this->After.Facets.begin() + this->After.NumberOfConstraints);
  const auto pairs = IntersectionsBySweep(this->After.Points, constraints);
  this->Found.Crossings = static_cast<Id>(pairs.size());
  if (!pairs.empty())
  {
    this->Violate(Named("crossing pairs:", this->Found.Crossings) +
      Named(", the first of facets", pairs[0][0]) + Named(" and", pairs[0][1]));
  }
}

/**
 * Crossings detect a constraint's corner that lies within another one; the other cases are tested
 * here.
 */
void Judge::CheckLoosePoints()
{
  const FacetComplex& s = this->After;
  std::vector<char> isCorner(s.Points.size(), 0);
  for (Id f = 0; f < s.NumberOfConstraints; ++f)
  {
    isCorner[s.Facets[f][0]] = isCorner[s.Facets[f][1]] = isCorner[s.Facets[f][2]] = 1;
  }
  const auto isInBox = [&](const Triangle& t, Id p)
  {
    bool inBox = true;
    for (int k = 0; k < 3; ++k)
    {
      const auto range = std::minmax({ s.Points[t[0]][k], s.Points[t[1]][k], s.Points[t[2]][k] });
      inBox = inBox && range.first <= s.Points[p][k] && s.Points[p][k] <= range.second;
    }
    return inBox;
  };
  for (Id p = 0; p < static_cast<Id>(s.Points.size()); ++p)
  {
    for (Id f = 0; !isCorner[p] && f < s.NumberOfConstraints; ++f)
    {
      if (isInBox(s.Facets[f], p) && LiesWithinByClipping(s.Points, s.Facets[f], p))
      {
        this->Violate(Named("within facet", f) + Named(" lies point", p));
        return;
      }
    }
  }
}

/** Finds the parts of each input facet by their sources. */
void Judge::CollectParts()
{
  Id triangles = 0;
  for (const FacetSource& source : this->Before.Sources)
  {
    triangles = std::max(triangles, source.Triangle + 1);
  }
  std::vector<Owner> owners(triangles);
  for (Id f = 0; f < this->Before.NumberOfFacets(); ++f)
  {
    for (Id s = this->Before.SourceOffsets[f]; s < this->Before.SourceOffsets[f + 1]; ++s)
    {
      owners[this->Before.Sources[s].Triangle] = { f, this->Before.Sources[s].Reversed };
    }
  }
  this->Parts.resize(this->Before.Facets.size());
  for (Id f = 0; f < this->After.NumberOfFacets(); ++f)
  {
    this->CollectPartsOf(f, owners);
  }
}

void Judge::CollectPartsOf(Id facet, const std::vector<Owner>& owners)
{
  std::map<Id, std::pair<int, Id>> found; // input facet: how turned, how many of its sources
  for (Id s = this->After.SourceOffsets[facet]; s < this->After.SourceOffsets[facet + 1]; ++s)
  {
    const FacetSource& source = this->After.Sources[s];
    if (source.Triangle < 0 || source.Triangle >= static_cast<Id>(owners.size()) ||
      owners[source.Triangle].Facet == None)
    {
      this->Violate(Named("a source that is none has facet", facet));
      return;
    }
    const Owner& owner = owners[source.Triangle];
    const int turn = source.Reversed == owner.Reversed ? 1 : -1;
    auto& entry = found.insert({ owner.Facet, { turn, 0 } }).first->second;
    ++entry.second;
    if (entry.first != turn)
    {
      this->Violate(Named("sources that contradict each other has facet", facet));
      return;
    }
  }
  int sum = 0;
  for (const auto& entry : found)
  {
    const Id f = entry.first;
    if (entry.second.second != this->Before.SourceOffsets[f + 1] - this->Before.SourceOffsets[f])
    {
      this->Violate(Named("sources are missing of facet", facet));
      return;
    }
    sum += entry.second.first * this->Before.Multiplicity[f];
    this->Parts[f].push_back({ facet, entry.second.first });
  }
  if (sum != this->After.Multiplicity[facet])
  {
    this->Violate(Named("does not count as often as its sources: facet", facet));
  }
}

/** Whether the only part of an input facet is itself. */
bool Judge::IsWhole(Id facet) const
{
  const std::vector<Part>& parts = this->Parts[facet];
  return parts.size() == 1 &&
    Sorted(this->After.Facets[parts[0].Facet]) == Sorted(this->Before.Facets[facet]) &&
    Turn(this->Before.Facets[facet], this->After.Facets[parts[0].Facet]) == parts[0].Turn;
}

void Judge::CheckCoverage()
{
  const Id count = this->Before.NumberOfFacets();
  Real offset = 0;
  Real area = 0;
  std::vector<std::string> violations;
#pragma omp parallel for schedule(dynamic, 64) reduction(max : offset, area)
  for (Id f = 0; f < count; ++f)
  {
    if (this->IsWhole(f))
    {
      continue;
    }
    const Corners triangle = CornersOf(this->Before, f);
    const Vector normal = Normal(triangle);
    const Real twiceArea = Length(normal);
    Real sum = 0;
    Real offsetHere = 0;
    for (const Part& part : this->Parts[f])
    {
      const Corners piece = CornersOf(this->After, part.Facet);
      sum += part.Turn * Dot(Normal(piece), normal) / twiceArea;
      for (const Point& p : piece)
      {
        offsetHere = std::max(offsetHere, DistanceToTriangle(p, triangle) / this->Size);
      }
    }
    const Real areaHere = std::abs(sum - twiceArea) / 2 / (this->Size * Perimeter(triangle));
    offset = std::max(offset, offsetHere);
    area = std::max(area, areaHere);
    std::vector<std::string> here;
    if (offsetHere > LengthTolerance)
    {
      here.push_back(Named("its pieces stand off it: facet", f) + " by " +
        std::to_string(static_cast<double>(offsetHere * 1e12L)) + "e-12");
    }
    if (areaHere > LengthTolerance)
    {
      here.push_back(Named("its pieces' area is not its own: facet", f));
    }
    if (this->Found.LeftOut == 0)
    {
      this->CheckBoundary(f, here);
    }
    if (!here.empty())
    {
#pragma omp critical(InsideOutJudgeCoverage)
      violations.insert(violations.end(), here.begin(), here.end());
    }
  }
  this->Found.Offset = static_cast<double>(offset);
  this->Found.Area = static_cast<double>(area);
  std::sort(violations.begin(), violations.end());
  constexpr std::size_t enough = 5;
  if (violations.size() > enough)
  {
    violations.resize(enough);
    violations.push_back("and more of that kind");
  }
  for (const std::string& violation : violations)
  {
    this->Violate(violation);
  }
}

/** The pieces' edges cancel but for those along the facet's three edges: there are no gaps. */
void Judge::CheckBoundary(Id facet, std::vector<std::string>& violations) const
{
  std::map<std::array<Id, 2>, int> edges;
  for (const Part& part : this->Parts[facet])
  {
    const Triangle& t = this->After.Facets[part.Facet];
    for (int k = 0; k < 3; ++k)
    {
      const Id p = t[k];
      const Id q = t[(k + 1) % 3];
      edges[{ std::min(p, q), std::max(p, q) }] += p < q ? part.Turn : -part.Turn;
    }
  }
  const Corners triangle = CornersOf(this->Before, facet);
  const Real tolerance = LengthTolerance * this->Size;
  for (const auto& edge : edges)
  {
    const Point& p = this->After.Points[edge.first[0]];
    const Point& q = this->After.Points[edge.first[1]];
    bool onBoundary = false;
    for (int k = 0; k < 3; ++k)
    {
      const Point& a = triangle[k];
      const Point& b = triangle[(k + 1) % 3];
      onBoundary = onBoundary ||
        (DistanceToSegment(p, a, b) <= tolerance && DistanceToSegment(q, a, b) <= tolerance);
    }
    if (edge.second != 0 && !onBoundary)
    {
      violations.push_back(Named("a gap between its pieces has facet", facet));
      return;
    }
  }
}

/** How many edges have a signed sum that is not 0. */
std::size_t UnbalancedEdges(const FacetComplex& surface)
{
  struct Entry
  {
    std::array<Id, 2> Edge;
    int Count;
  };
  std::vector<Entry> entries;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id p = surface.Facets[f][k];
      const Id q = surface.Facets[f][(k + 1) % 3];
      const int count = surface.Multiplicity[f];
      entries.push_back({ { std::min(p, q), std::max(p, q) }, p < q ? count : -count });
    }
  }
  std::sort(
    entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.Edge < b.Edge; });
  std::size_t unbalanced = 0;
  for (std::size_t i = 0; i < entries.size();)
  {
    int sum = 0;
    std::size_t j = i;
    for (; j < entries.size() && entries[j].Edge == entries[i].Edge; ++j)
    {
      sum += entries[j].Count;
    }
    unbalanced += sum != 0 ? 1 : 0;
    i = j;
  }
  return unbalanced;
}

void Judge::CheckClosedness()
{
  if (this->Found.LeftOut == 0 && UnbalancedEdges(this->Before) == 0 &&
    UnbalancedEdges(this->After) != 0)
  {
    this->Violate("the closed surface came open");
  }
}

/** Facets of `surface` that are not in `other` with the same corners and multiplicity. */
std::vector<Id> ChangedFacets(const FacetComplex& surface, const FacetComplex& other)
{
  using Key = std::pair<Triangle, int>;
  const auto keyOf = [](const FacetComplex& s, Id f)
  {
    const Triangle sorted = Sorted(s.Facets[f]);
    return Key{ sorted, Turn(sorted, s.Facets[f]) * s.Multiplicity[f] };
  };
  std::vector<Key> keys;
  for (Id f = 0; f < other.NumberOfFacets(); ++f)
  {
    keys.push_back(keyOf(other, f));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Id> changed;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (!std::binary_search(keys.begin(), keys.end(), keyOf(surface, f)))
    {
      changed.push_back(f);
    }
  }
  return changed;
}

/** The part of the winding number that these facets make: the definition, solid angles after van
 * Oosterom and Strackee (1983). */
Real WindingNumber(const FacetComplex& surface, const std::vector<Id>& facets, const Point& q)
{
  Real sum = 0;
  for (const Id f : facets)
  {
    const Corners t = CornersOf(surface, f);
    const Vector a = Minus(t[0], q);
    const Vector b = Minus(t[1], q);
    const Vector c = Minus(t[2], q);
    const Real lengthA = Length(a);
    const Real lengthB = Length(b);
    const Real lengthC = Length(c);
    const Real div =
      lengthA * lengthB * lengthC + Dot(a, b) * lengthC + Dot(b, c) * lengthA + Dot(c, a) * lengthB;
    sum += surface.Multiplicity[f] * std::atan2(Dot(a, Cross(b, c)), div);
  }
  return sum / (2 * 3.14159265358979323846264338L);
}

/** By turns a point anywhere in the surface's box and one near a facet in `facets`. */
Point RandomPoint(std::mt19937& random, int turn, const FacetComplex& surface,
  const std::vector<Id>& facets, double size)
{
  const auto uniform = [&] { return random() / 4294967296.0; };
  const Corners t = CornersOf(surface, facets[random() % facets.size()]);
  const Corners u = CornersOf(surface, facets[random() % facets.size()]);
  const double reach = size * std::pow(10.0, -3 * uniform());
  Point q;
  const double s = uniform();
  for (int k = 0; k < 3; ++k)
  {
    q[k] = turn % 2 == 0 ? t[0][k] + s * (u[1][k] - t[0][k]) + 0.2 * size * (uniform() - 0.5)
                         : t[0][k] + s * (t[1][k] - t[0][k]) + reach * (uniform() - 0.5);
  }
  return q;
}

/** Facets that are the same before and after add the same: only the others are summed. */
void Judge::CheckWinding(int points)
{
  const std::vector<Id> before = ChangedFacets(this->Before, this->After);
  const std::vector<Id> after = ChangedFacets(this->After, this->Before);
  if (before.empty())
  {
    if (!after.empty())
    {
      this->Violate("facets were added to a surface of which none was cut");
    }
    return;
  }
  std::mt19937 random(7);
  std::vector<Point> queries;
  for (int i = 0; i < points; ++i)
  {
    queries.push_back(
      RandomPoint(random, i, this->Before, before, static_cast<double>(this->Size)));
  }
  Real worst = 0;
  int tried = 0;
#pragma omp parallel for schedule(dynamic) reduction(max : worst) reduction(+ : tried)
  for (int i = 0; i < points; ++i)
  {
    const auto isNear = [&](Id f)
    {
      return DistanceToTriangle(queries[i], CornersOf(this->Before, f)) <
        WindingDistance * this->Size;
    };
    if (std::none_of(before.begin(), before.end(), isNear))
    {
      ++tried;
      worst = std::max(worst,
        std::abs(WindingNumber(this->Before, before, queries[i]) -
          WindingNumber(this->After, after, queries[i])));
    }
  }
  this->Found.Winding = static_cast<double>(worst);
  this->Found.WindingPoints = tried;
  if (!(worst <= WindingTolerance))
  {
    this->Violate("w differs by " + std::to_string(static_cast<double>(worst * 1e9L)) + "e-9");
  }
}
} // namespace

double SizeOf(const std::vector<Point>& points)
{
  double size = 0;
  for (const Point& p : points)
  {
    size = std::max({ size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  return size;
}

ResolutionJudgement JudgeResolution(
  const FacetComplex& before, const FacetComplex& after, int windingPoints)
{
  return Judge(before, after).Run(windingPoints);
}

bool SameBytes(const FacetComplex& a, const FacetComplex& b)
{
  const auto same = [](const auto& p, const auto& q)
  {
    return p.size() == q.size() &&
      (p.empty() || std::memcmp(p.data(), q.data(), p.size() * sizeof(p[0])) == 0);
  };
  const auto sameSources = [](const FacetSource& p, const FacetSource& q)
  { return p.Triangle == q.Triangle && p.Reversed == q.Reversed; };
  return same(a.Points, b.Points) && same(a.Facets, b.Facets) &&
    same(a.Multiplicity, b.Multiplicity) && same(a.SourceOffsets, b.SourceOffsets) &&
    std::equal(
      a.Sources.begin(), a.Sources.end(), b.Sources.begin(), b.Sources.end(), sameSources) &&
    std::equal(a.Origins.begin(), a.Origins.end(), b.Origins.begin(), b.Origins.end(),
      [](const PointOrigin& p, const PointOrigin& q)
      {
        return p.Points == q.Points &&
          std::memcmp(p.Weights.data(), q.Weights.data(), sizeof(p.Weights)) == 0;
      }) &&
    a.NumberOfConstraints == b.NumberOfConstraints;
}
} // namespace testmeshes

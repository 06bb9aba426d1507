// SPDX-License-Identifier: GPL-3.0-or-later
#include "Rounding/RoundToFloats.h"

#include "Common/Box.h"
#include "Common/Edge.h"
#include "Common/Floats.h"
#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Common/Vectors.h"
#include "Defects/NearPoints.h"
#include "Resolve/CollapseSlivers.h"
#include "Resolve/FindIntersections.h"
#include "Resolve/MeetBeyondSharedCorners.h"
#include "Rounding/MoveCorners.h"
#include "Validate/MergePoints.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <variant>

namespace insideout
{
namespace
{
/** Distance that counts as near, as in Defects/SurfaceDefects: some ten float spacings. */
constexpr double NearFraction = 1e-6;

/** Limit of movement, in these units; a contraction moves by 1 at most. */
constexpr double Reach = 2.0;

/** Limit of passes over all crossings: a pass may enable further moves; few are needed. */
constexpr int MaximumPasses = 4;

std::vector<Point> InFloats(std::vector<Point> points)
{
  for (Point& point : points)
  {
    for (double& x : point)
    {
      x = InFloat(x);
    }
  }
  return points;
}

std::vector<Triangle> TrianglesOf(const PolygonSurface& surface, const std::vector<Id>& pointOf)
{
  std::vector<Triangle> triangles(surface.Corners.size() / 3);
  for (std::size_t c = 0; c < 3 * triangles.size(); ++c)
  {
    triangles[c / 3][c % 3] = pointOf[static_cast<std::size_t>(surface.Corners[c])];
  }
  return triangles;
}

class FloatRounder
{
public:
  FloatRounder(const PolygonSurface& surface, Monitor& monitor)
    : Watch(monitor)
    , Given(surface.Points)
    , GivenCorners(TrianglesOf(surface, MergePoints(this->Given, 0)))
    , Points(InFloats(surface.Points))
    , Triangles(TrianglesOf(surface, MergePoints(this->Points, 0)))
    , Sources(this->Triangles.size())
  {
    std::iota(this->Sources.begin(), this->Sources.end(), 0);
  }

  FloatRounding Round()
  {
    this->DropWithoutArea();
    this->DropReversed();
    this->CollapseCollinear();
    this->MoveNearAndCrossing();
    FloatRounding counts;
    counts.IntersectingPairs = static_cast<Id>(this->NewCrossings().size());
    const std::vector<Point> used = this->UsedPoints();
    counts.NearPoints = FindNearPoints(used, NearFraction).Count;
    return counts;
  }

  void MoveTo(PolygonSurface& surface)
  {
    surface.Points = std::move(this->Points);
    surface.PointAttributes.clear();
    for (Attribute& attribute : surface.PolygonAttributes)
    {
      this->TakeFromSources(attribute);
    }
    surface.Offsets = { 0 };
    surface.Corners.clear();
    for (const Triangle& triangle : this->Triangles)
    {
      surface.Corners.insert(surface.Corners.end(), triangle.begin(), triangle.end());
      surface.Offsets.push_back(static_cast<Id>(surface.Corners.size()));
    }
  }

private:
  using Pairs = std::vector<std::array<Id, 2>>;

  /** Set each triangle's attributes to those of the given triangle that contains it. */
  void TakeFromSources(Attribute& attribute) const
  {
    std::visit(
      [&](auto& values)
      {
        const auto given = std::move(values);
        values.clear();
        for (const Id source : this->Sources)
        {
          const auto first = given.begin() + std::ptrdiff_t(source) * attribute.Components;
          values.insert(values.end(), first, first + attribute.Components);
        }
      },
      attribute.Values);
  }

  const Triangle& GivenCornersOf(Id triangle) const
  {
    return this->GivenCorners[this->Sources[triangle]];
  }

  /** Whether both had the same corners before. */
  bool WereOne(Id a, Id b) const
  {
    return SortedTriangle(this->GivenCornersOf(a)).Points ==
      SortedTriangle(this->GivenCornersOf(b)).Points;
  }

  bool MetInDoubles(Id a, Id b) const
  {
    const Triangle& p = this->GivenCornersOf(a);
    const Triangle& q = this->GivenCornersOf(b);
    return this->Sources[a] != this->Sources[b] &&
      (this->WereOne(a, b) ||
        (!IsDegenerate(this->Given, p) && !IsDegenerate(this->Given, q) &&
          MeetBeyondSharedCorners(this->Given, p, q)));
  }

  void Keep(const std::vector<char>& isKept)
  {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < isKept.size(); ++t)
    {
      if (isKept[t])
      {
        this->Triangles[kept] = this->Triangles[t];
        this->Sources[kept++] = this->Sources[t];
      }
    }
    this->Triangles.resize(kept);
    this->Sources.resize(kept);
  }

  void DropWithoutArea()
  {
    std::vector<char> isKept;
    for (const auto& [a, b, c] : this->Triangles)
    {
      isKept.push_back(a != b && b != c && c != a);
    }
    this->Keep(isKept);
  }

  /** The triangles at each place, grouped by place. */
  std::vector<Id> ByPlace() const
  {
    std::vector<Id> order(this->Triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
      [this](Id a, Id b)
      {
        return std::make_tuple(SortedTriangle(this->Triangles[a]).Points, a) <
          std::make_tuple(SortedTriangle(this->Triangles[b]).Points, b);
      });
    return order;
  }

  /** Pairs of triangles that rounding moved to one place, one the reverse of the other. */
  void DropReversed()
  {
    const std::vector<Id> order = this->ByPlace();
    std::vector<char> isKept(this->Triangles.size(), 1);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const SortedTriangle one(this->Triangles[order[i]]);
      for (std::size_t j = i + 1; isKept[order[i]] && j < order.size(); ++j)
      {
        const SortedTriangle other(this->Triangles[order[j]]);
        if (other.Points != one.Points)
        {
          break;
        }
        if (isKept[order[j]] && other.Turned != one.Turned && !this->WereOne(order[i], order[j]))
        {
          isKept[order[i]] = isKept[order[j]] = 0;
        }
      }
    }
    this->Keep(isKept);
  }

  /** Triangles whose corners became collinear. No point moves. */
  void CollapseCollinear()
  {
    std::vector<Id> candidates = this->Collinear();
    for (int pass = 0; pass < MaximumPasses && !candidates.empty(); ++pass)
    {
      const Replacement replacement =
        CollapseSlivers(this->Points, this->Triangles, candidates, 0.0);
      std::vector<char> isKept(this->Triangles.size(), 1);
      for (const Id t : replacement.Removed)
      {
        isKept[t] = 0;
      }
      for (const ReplacedFacet& part : replacement.Added)
      {
        this->Triangles.push_back(part.Corners);
        this->Sources.push_back(Id(this->Sources[part.Parent]));
        isKept.push_back(1);
      }
      this->Keep(isKept);
      this->DropReversed();
      candidates = this->Collinear();
    }
  }

  std::vector<Id> Collinear() const
  {
    std::vector<Id> collinear;
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      if (IsDegenerate(this->Points, this->Triangles[t]))
      {
        collinear.push_back(static_cast<Id>(t));
      }
    }
    return collinear;
  }

  /** The first triangle at each place. */
  std::vector<Id> FirstOfPlaces() const
  {
    std::vector<Id> order = this->ByPlace();
    const auto inOnePlace = [this](Id a, Id b) {
      return SortedTriangle(this->Triangles[a]).Points == SortedTriangle(this->Triangles[b]).Points;
    };
    order.erase(std::unique(order.begin(), order.end(), inOnePlace), order.end());
    std::sort(order.begin(), order.end());
    return order;
  }

  std::vector<Triangle> TrianglesOfPlaces(const std::vector<Id>& first) const
  {
    std::vector<Triangle> triangles;
    for (const Id t : first)
    {
      triangles.push_back(this->Triangles[t]);
    }
    return triangles;
  }

  /** Pairs that meet, but did not in doubles. */
  Pairs NewCrossings()
  {
    const std::vector<Id> first = this->FirstOfPlaces();
    Pairs pairs = FindIntersections(this->Points, this->TrianglesOfPlaces(first), this->Watch);
    const auto isOld = [&](std::array<Id, 2>& pair)
    {
      pair = { first[pair[0]], first[pair[1]] };
      return this->MetInDoubles(pair[0], pair[1]);
    };
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isOld), pairs.end());
    return pairs;
  }

  std::vector<Point> UsedPoints() const
  {
    std::vector<Id> ids;
    for (const Triangle& triangle : this->Triangles)
    {
      ids.insert(ids.end(), triangle.begin(), triangle.end());
    }
    SortUniquely(ids);
    std::vector<Point> used;
    for (const Id p : ids)
    {
      used.push_back(this->Points[p]);
    }
    return used;
  }

  /** Edges shorter than `length`, shortest first. */
  std::vector<Edge> ShortEdges(double length) const
  {
    std::vector<std::pair<double, Edge>> edges;
    for (const Triangle& triangle : this->Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Edge edge = EdgeBetween(triangle[k], triangle[(k + 1) % 3]);
        const double distance = Distance(this->Points[edge[0]], this->Points[edge[1]]);
        if (distance < length)
        {
          edges.emplace_back(distance, edge);
        }
      }
    }
    SortUniquely(edges);
    std::vector<Edge> sorted;
    for (const auto& [distance, edge] : edges)
    {
      sorted.push_back(edge);
    }
    return sorted;
  }

  void MoveNearAndCrossing()
  {
    const Box box = BoundingBox(this->UsedPoints());
    const double near = NearFraction * Distance(box.Low, box.High);
    for (int pass = 0; pass < MaximumPasses; ++pass)
    {
      const std::vector<Edge> edges = this->ShortEdges(near);
      const Pairs crossings = this->NewCrossings();
      if (edges.empty() && crossings.empty())
      {
        return;
      }
      MoveCorners mover(this->Points, this->TrianglesOfPlaces(this->FirstOfPlaces()), Reach * near);
      bool isChanged = false;
      for (const auto& [a, b] : edges)
      {
        const Id p = mover.CornerOf(a);
        const Id q = mover.CornerOf(b);
        isChanged = mover.Contract(q, p) || mover.Contract(p, q) || isChanged;
      }
      for (const Id corner : this->CornersOf(crossings))
      {
        isChanged = mover.MoveToNeighbor(mover.CornerOf(corner)) || isChanged;
      }
      this->Take(mover);
      if (!isChanged)
      {
        return;
      }
    }
  }

  std::vector<Id> CornersOf(const Pairs& pairs) const
  {
    std::vector<Id> corners;
    for (const std::array<Id, 2>& pair : pairs)
    {
      for (const Id triangle : pair)
      {
        corners.insert(
          corners.end(), this->Triangles[triangle].begin(), this->Triangles[triangle].end());
      }
    }
    SortUniquely(corners);
    return corners;
  }

  void Take(const MoveCorners& mover)
  {
    for (Triangle& triangle : this->Triangles)
    {
      for (Id& corner : triangle)
      {
        corner = mover.CornerOf(corner);
      }
    }
    this->Points = mover.Points();
    this->DropWithoutArea();
    this->DropReversed();
  }

  ForwardMonitor Watch; ///< found several times
  const std::vector<Point> Given;
  const std::vector<Triangle> GivenCorners; ///< triangles of Given, with equal points merged
  std::vector<Point> Points;                ///< in floats; used points are at different places
  std::vector<Triangle> Triangles;
  std::vector<Id> Sources; ///< per triangle the given one that contains it
};

bool IsOfFiniteTriangles(const PolygonSurface& surface)
{
  const auto isFinite = [](const Point& point)
  {
    return std::all_of(
      point.begin(), point.end(), [](double x) { return std::isfinite(static_cast<float>(x)); });
  };
  for (std::size_t p = 0; p < surface.Offsets.size(); ++p)
  {
    if (surface.Offsets[p] != static_cast<Id>(3 * p))
    {
      return false;
    }
  }
  return std::all_of(surface.Points.begin(), surface.Points.end(), isFinite);
}
} // namespace

FloatRounding RoundToFloats(PolygonSurface& surface, Monitor& monitor)
{
  FloatRounding rounding;
  if (IsOfFiniteTriangles(surface))
  {
    FloatRounder rounder(surface, monitor);
    rounding = rounder.Round();
    rounder.MoveTo(surface);
  }
  return rounding;
}

std::string WordsOf(const FloatRounding& rounding)
{
  std::string words;
  if (rounding.IntersectingPairs > 0)
  {
    words +=
      std::to_string(rounding.IntersectingPairs) + " pairs of triangles meet that did not before";
  }
  if (rounding.NearPoints > 0)
  {
    words += (words.empty() ? "" : ", and ") + std::to_string(rounding.NearPoints) +
      " points are nearer to another one than a millionth of the size";
  }
  return words.empty() ? words : "rounded to the floats that the format has: " + words;
}
} // namespace insideout

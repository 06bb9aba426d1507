// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/PlanarRefiner.h"

#include "Common/Error.h"
#include "Common/LoopProgress.h"
#include "Common/PointPredicates.h"
#include "Common/Stages.h"

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace insideout
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Infinite = std::numeric_limits<double>::infinity();

/** Relative to the required edge length: the largest circumradius (0.58 for a regular triangle),
 * and the longest constraint. */
constexpr double LargestRadius = 0.7;
constexpr double LongestConstraint = 4.0 / 3;

/** The square of the largest ratio of circumradius to shortest edge for which Ruppert's proof
 * holds, and the resulting least angle, in degrees. */
constexpr double LargestSquaredRatio = 2;
constexpr double GoodAngle = 20.7;

/**
 * Corners of the curve below the first angle, in degrees, get shells. Below the second all
 * triangles between shells stay thin: good ones would number some hundred for each power of two in
 * length.
 */
constexpr double SharpCorner = 60;
constexpr double SharpestCorner = 0.5;

/**
 * Two cuts are on one shell if their distances from the corner differ by less than this,
 * relatively.
 */
constexpr double SameShell = 1e-6;

/**
 * Kept: least distance to other points relative to the length, and to constraints relative to the
 * former.
 */
constexpr double LeastSpacing = 0.7;
constexpr double LeastHeight = 0.5;

/**
 * Kept: degrees. Wanted edge lengths make no triangle with an angle below this: beside a long
 * constraint either small triangles are flat or large ones stay.
 */
constexpr double LeastAngleForLength = 10;

/** Kept: triangles with edges this many times longer than wanted are counted and warned about. */
constexpr double TooLong = 1.5;

/**
 * Limits of points, per input point and per cell that sizes require. They bound the triangles in a
 * narrow gap between two curves, which would be as small as the gap. Long edges come first, so that
 * only small ones remain.
 */
constexpr double PointsPerPoint = 400;
constexpr double PointsPerCell = 4;

double EdgeOfArea(double area)
{
  return std::sqrt(area * 4 / std::sqrt(3.0));
}

double AreaOfEdge(double edge)
{
  return edge * edge * std::sqrt(3.0) / 4;
}

double ScaledArea(double area, int exponent)
{
  return area > 0 ? std::ldexp(area, -2 * exponent) : Infinite;
}

double LeastAngleOf(
  const PlanarPoint& p, const PlanarPoint& q, const PlanarPoint& r, const PlanarMetric& metric)
{
  return std::min({ AngleAt(p, q, r, metric), AngleAt(q, r, p, metric), AngleAt(r, p, q, metric) });
}
} // namespace

PlanarRefiner::PlanarRefiner(const SegmentComplex& curve, const PlanarMesh& mesh,
  const std::vector<unsigned char>& inside, const Plane& plane,
  const RefinementParameters& parameters, Monitor& monitor)
  : Input(mesh)
  , Mesh(curve.Points, mesh, inside, plane.Metric)
  , Parameters(parameters)
  , Watch(monitor)
  , IsSplit(parameters.Surface == SurfaceTreatment::Split)
  , EdgeLength(std::ldexp(parameters.Sizes.EdgeLength, -plane.Exponent))
  , MostArea(ScaledArea(parameters.Sizes.MaximumVolume, plane.Exponent))
  , InputEdges(curve.Points.size(), None)
{
  this->Most =
    std::min(this->EdgeLength > 0 ? this->EdgeLength : Infinite, EdgeOfArea(this->MostArea));
  this->FindSizes();
  this->FindSharpCorners();
}

/** The lower of the two ids that an edge of the input has, one for each side. */
Id PlanarRefiner::InputEdge(Id source) const
{
  const Id cell = source / 3;
  const Id beyond = this->Input.Neighbors[cell][source % 3];
  if (beyond == None)
  {
    return source;
  }
  const auto& back = this->Input.Neighbors[beyond];
  const Id k = static_cast<Id>(std::find(back.begin(), back.end(), cell) - back.begin());
  return std::min(source, 3 * beyond + k);
}

/** The mean length of the constraints at each point, growing from there (Dijkstra 1959). */
void PlanarRefiner::FindSizes()
{
  std::vector<double> sums(this->Mesh.Points().size(), 0);
  std::vector<int> counts(sums.size(), 0);
  std::vector<std::vector<Id>> around(sums.size());
  for (const RefinableTriangles::Cell& cell : this->Mesh.Cells())
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto [a, b] = EdgeOf(cell.Corners, k);
      around[a].push_back(b);
      around[b].push_back(a);
      for (const Id p : { a, b })
      {
        sums[p] += cell.Sources[k] == None ? 0 : this->Length(a, b);
        counts[p] += cell.Sources[k] == None ? 0 : 1;
      }
    }
  }
  using Entry = std::pair<double, Id>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (std::size_t p = 0; p < sums.size(); ++p)
  {
    this->Sizes.push_back(counts[p] > 0 ? std::min(sums[p] / counts[p], this->Most) : this->Most);
    queue.push({ this->Sizes.back(), static_cast<Id>(p) });
  }
  while (!queue.empty())
  {
    const auto [size, point] = queue.top();
    queue.pop();
    if (size > this->Sizes[point])
    {
      continue;
    }
    for (const Id other : around[point])
    {
      const double grown = size + this->Parameters.Sizes.Grading * this->Length(point, other);
      if (grown < this->Sizes[other])
      {
        this->Sizes[other] = grown;
        queue.push({ grown, other });
      }
    }
  }
}

/** Points at which two constraints make a sharp angle, on either side. */
void PlanarRefiner::FindSharpCorners()
{
  std::vector<std::vector<double>> directions(this->Mesh.Points().size());
  for (const RefinableTriangles::Cell& cell : this->Mesh.Cells())
  {
    for (int k = 0; k < 3; ++k)
    {
      if (cell.Sources[k] == None)
      {
        continue;
      }
      const auto [a, b] = EdgeOf(cell.Corners, k);
      const PlanarPoint &from = this->Mesh.Points()[a], &to = this->Mesh.Points()[b];
      const PlanarPoint d = this->Mesh.Metric().Map({ to[0] - from[0], to[1] - from[1] });
      directions[a].push_back(std::atan2(d[1], d[0]));
      directions[b].push_back(std::atan2(-d[1], -d[0]));
    }
  }
  constexpr double sharp = SharpCorner / 180 * Pi;
  constexpr double same = 1e-12; // a constraint seen from both sides
  for (std::vector<double>& all : directions)
  {
    std::sort(all.begin(), all.end());
    bool isSharp = false;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      const bool isLast = i + 1 == all.size();
      const double gap = isLast ? all[0] + 2 * Pi - all[i] : all[i + 1] - all[i];
      isSharp = isSharp || (gap > same && gap < sharp);
    }
    this->Sharp.push_back(isSharp);
  }
}

double PlanarRefiner::SizeAt(Id cell, const PlanarPoint& place) const
{
  double size = this->Most;
  for (const Id p : this->Mesh.Cells()[cell].Corners)
  {
    size = std::min(size,
      this->Sizes[p] +
        this->Parameters.Sizes.Grading *
          this->Mesh.Metric().Distance(this->Mesh.Points()[p], place));
  }
  return size;
}

double PlanarRefiner::EstimatedCells() const
{
  double cells = 0;
  for (Id c = 0; c < this->Mesh.NumberOfCells(); ++c)
  {
    const auto& points = this->Mesh.Points();
    const auto& [a, b, d] = this->Mesh.Cells()[c].Corners;
    const PlanarPoint middle = { (points[a][0] + points[b][0] + points[d][0]) / 3,
      (points[a][1] + points[b][1] + points[d][1]) / 3 };
    cells += 1 +
      AreaOf(points[a], points[b], points[d], this->Mesh.Metric()) /
        AreaOfEdge(this->SizeAt(c, middle));
  }
  return cells;
}

/** Queue a triangle and its constraints. */
void PlanarRefiner::Push(Id cell)
{
  const RefinableTriangles::Cell& here = this->Mesh.Cells()[cell];
  double longest = 0;
  for (int k = 0; k < 3; ++k)
  {
    const auto [a, b] = EdgeOf(here.Corners, k);
    const double length = this->Length(a, b);
    longest = std::max(longest, length);
    if (this->IsSplit && here.Sources[k] != None)
    {
      this->Tasks.push({ length, { cell, k }, here.Version });
    }
  }
  this->Tasks.push({ longest, { cell, None }, here.Version });
}

void PlanarRefiner::PushChanged()
{
  for (const Id cell : this->Mesh.Changed())
  {
    this->Push(cell);
  }
}

/** Whether a place is within the diametral circle of a segment. */
bool PlanarRefiner::IsEncroached(const Segment& ends, const PlanarPoint& place) const
{
  const PlanarPoint &a = this->Mesh.Points()[ends[0]], &b = this->Mesh.Points()[ends[1]];
  const PlanarPoint u = this->Mesh.Metric().Map({ a[0] - place[0], a[1] - place[1] });
  const PlanarPoint v = this->Mesh.Metric().Map({ b[0] - place[0], b[1] - place[1] });
  return u[0] * v[0] + u[1] * v[1] < 0;
}

/** Whether a point may be inserted at a place within a cell where constraints stay: all points that
 * it sees are far enough away, constraints are not much nearer, and no new triangle is thinner than
 * the angle, unless a replaced one is. */
bool PlanarRefiner::IsRoomy(
  Id cell, const PlanarPoint& place, double spacing, double leastAngle) const
{
  const RefinableTriangles::View view = this->Mesh.ViewFrom(cell, place);
  const auto& points = this->Mesh.Points();
  const PlanarMetric& metric = this->Mesh.Metric();
  if (view.Spacing < spacing)
  {
    return false;
  }
  for (const Id c : view.Cells)
  {
    const auto& [p, q, r] = this->Mesh.Cells()[c].Corners;
    leastAngle = std::min(leastAngle, LeastAngleOf(points[p], points[q], points[r], metric));
  }
  return std::none_of(view.Rim.begin(), view.Rim.end(),
    [&](const Place& edge)
    {
      const auto [a, b] = this->EndsOf(edge);
      const bool isConstraint = this->Mesh.Cells()[edge.Cell].Sources[edge.Edge] != None;
      const double height = 2 * AreaOf(points[a], points[b], place, metric) / this->Length(a, b);
      return (isConstraint && height < LeastHeight * spacing) ||
        LeastAngleOf(points[a], points[b], place, metric) < leastAngle;
    });
}

/** Whether an edge is short because of a sharp corner, so that no point is inserted: two corners of
 * a triangle cut constraints at the corner, on one shell. The third is that corner, or the corner
 * is too sharp for good triangles beside it. */
bool PlanarRefiner::IsAcrossSharpCorner(Id u, Id v, const Triangle& corners) const
{
  const Id first = this->InputEdges[u], second = this->InputEdges[v];
  if (first == None || second == None || first == second)
  {
    return false;
  }
  for (const Id p : this->EndsOfInputEdge(first))
  {
    const Segment other = this->EndsOfInputEdge(second);
    if (this->IsSharp(p) && (p == other[0] || p == other[1]))
    {
      const double ofU = this->Length(p, u), ofV = this->Length(p, v);
      const bool isAtCorner = std::find(corners.begin(), corners.end(), p) != corners.end();
      return std::abs(ofU - ofV) <= SameShell * std::max(ofU, ofV) &&
        (isAtCorner || this->Length(u, v) < SharpestCorner / 180 * Pi * ofU);
    }
  }
  return false;
}

namespace
{
/** Move a rounded place between the ends of a segment to its line, or to the left of it. So parts
 * of the boundary that almost touch do not cross. */
void MoveLeft(const PlanarPoint& a, const PlanarPoint& b, PlanarPoint& place)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const PlanarPoint normal = { a[1] - b[1], b[0] - a[0] };
  const auto stepAlong = [&](int axis)
  { return std::nextafter(place[axis], std::copysign(infinity, normal[axis])); };
  constexpr int enough = 4; // the place is off by less than two steps along both axes
  for (int step = 0; step < enough && Orient2D(a, b, place) < 0; ++step)
  {
    const auto gain = [&](int axis) { return (stepAlong(axis) - place[axis]) * normal[axis]; };
    const int axis = gain(0) > gain(1) ? 0 : 1;
    place[axis] = stepAlong(axis);
  }
}
} // namespace

/**
 * @param[in] leastHalf constraints with a shorter half are not split. @return whether it was split
 */
bool PlanarRefiner::SplitConstraint(const Place& edge, double leastHalf)
{
  Segment ends = this->EndsOf(edge);
  std::sort(ends.begin(), ends.end()); // the same from both sides
  const double length = this->Length(ends[0], ends[1]);
  double part = 0.5;
  if (this->IsSharp(ends[0]) != this->IsSharp(ends[1]))
  {
    // A power of two that leaves at least a third.
    const double shell = std::exp2(std::floor(std::log2(length * 2 / 3))) / length;
    part = this->IsSharp(ends[0]) ? shell : 1 - shell;
  }
  if (length / 2 < leastHalf)
  {
    return false;
  }
  const PlanarPoint &a = this->Mesh.Points()[ends[0]], &b = this->Mesh.Points()[ends[1]];
  PlanarPoint place = { a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]) };
  if (this->Mesh.Cells()[edge.Cell].Neighbors[edge.Edge] == None)
  {
    const Segment boundary = this->EndsOf(edge);
    MoveLeft(this->Mesh.Points()[boundary[0]], this->Mesh.Points()[boundary[1]], place);
  }
  const double size = this->SizeAt(edge.Cell, place);
  const Id source = this->Mesh.Cells()[edge.Cell].Sources[edge.Edge];
  if (this->Mesh.Split(edge, place) == None)
  {
    return false;
  }
  this->Sizes.push_back(size);
  this->InputEdges.push_back(this->InputEdge(source));
  this->PushChanged();
  return true;
}

void PlanarRefiner::LookAtConstraint(const Task& task)
{
  const Segment ends = this->EndsOf(task.At);
  const Id apex = this->Mesh.Cells()[task.At.Cell].Corners[(task.At.Edge + 2) % 3];
  const PlanarPoint &a = this->Mesh.Points()[ends[0]], &b = this->Mesh.Points()[ends[1]];
  const double size =
    this->SizeAt(task.At.Cell, { a[0] + (b[0] - a[0]) / 2, a[1] + (b[1] - a[1]) / 2 });
  if (task.Length > LongestConstraint * size || this->IsEncroached(ends, this->Mesh.Points()[apex]))
  {
    this->SplitConstraint(task.At, 0);
  }
}

/**
 * Split the constraints that a new point would be too near to.
 * @return whether any was split
 */
bool PlanarRefiner::MakeWay(
  const Place& at, const PlanarPoint& center, double leastHalf, bool& isBlocked)
{
  std::vector<Place> blocking;
  if (at.Edge != None)
  {
    blocking.push_back(at);
  }
  else
  {
    for (const Place& edge : this->Mesh.ViewFrom(at.Cell, center).Rim)
    {
      if (this->Mesh.Cells()[edge.Cell].Sources[edge.Edge] != None &&
        this->IsEncroached(this->EndsOf(edge), center))
      {
        blocking.push_back(edge);
      }
    }
  }
  isBlocked = !blocking.empty();
  // One by one: a split changes the cells around it.
  return std::any_of(blocking.begin(), blocking.end(),
    [&](const Place& edge) { return this->SplitConstraint(edge, leastHalf); });
}

void PlanarRefiner::LookAtTriangle(const Task& task)
{
  const auto [a, b, c] = this->Mesh.Cells()[task.At.Cell].Corners;
  const auto& points = this->Mesh.Points();
  const PlanarMetric& metric = this->Mesh.Metric();
  // The center relative to c, in orthonormal coordinates.
  const PlanarPoint u = metric.Map({ points[a][0] - points[c][0], points[a][1] - points[c][1] });
  const PlanarPoint v = metric.Map({ points[b][0] - points[c][0], points[b][1] - points[c][1] });
  const double twice = 2 * (u[0] * v[1] - u[1] * v[0]);
  const double uu = u[0] * u[0] + u[1] * u[1], vv = v[0] * v[0] + v[1] * v[1];
  const PlanarPoint offset = { (v[1] * uu - u[1] * vv) / twice, (u[0] * vv - v[0] * uu) / twice };
  const double radius = std::hypot(offset[0], offset[1]);
  const double y = offset[1] / metric.YY;
  const PlanarPoint center = { points[c][0] + (offset[0] - metric.XY * y) / metric.XX,
    points[c][1] + y };
  if (!std::isfinite(center[0]) || !std::isfinite(center[1]))
  {
    return;
  }
  Segment shortest = { { a, b } };
  for (const Segment& edge : { Segment{ { b, c } }, Segment{ { c, a } } })
  {
    shortest =
      this->Length(edge[0], edge[1]) < this->Length(shortest[0], shortest[1]) ? edge : shortest;
  }
  const double least = this->Length(shortest[0], shortest[1]);
  const bool isLarge =
    radius > LargestRadius * this->SizeAt(task.At.Cell, center) || twice > 4 * this->MostArea;
  const bool isThin = radius * radius > LargestSquaredRatio * least * least &&
    !this->IsAcrossSharpCorner(shortest[0], shortest[1], { { a, b, c } });
  if (!isLarge && !isThin)
  {
    return;
  }
  if (!this->IsSplit)
  {
    const PlanarPoint middle = { (points[a][0] + points[b][0] + points[c][0]) / 3,
      (points[a][1] + points[b][1] + points[c][1]) / 3 };
    for (const PlanarPoint& place : { center, middle })
    {
      const Place at = this->Mesh.Locate(task.At.Cell, place);
      if (at.Cell != None && at.Edge == None &&
        this->IsRoomy(at.Cell, place, isLarge ? LeastSpacing * this->SizeAt(at.Cell, place) : least,
          isLarge && this->Most < Infinite ? LeastAngleForLength : GoodAngle))
      {
        this->Insert(at.Cell, place);
        return;
      }
    }
    return;
  }
  const Place at = this->Mesh.Locate(task.At.Cell, center);
  bool isBlocked = at.Cell == None;
  // For a thin triangle no constraint is split into halves shorter than its shortest edge.
  if (!isBlocked && this->MakeWay(at, center, isLarge ? 0 : least, isBlocked) &&
    this->Mesh.Cells()[task.At.Cell].Version == task.Version)
  {
    this->Tasks.push(task);
  }
  if (!isBlocked)
  {
    this->Insert(at.Cell, center);
  }
}

void PlanarRefiner::Insert(Id cell, const PlanarPoint& place)
{
  const double size = this->SizeAt(cell, place);
  if (this->Mesh.Insert(cell, place) != None)
  {
    this->Sizes.push_back(size);
    this->InputEdges.push_back(None);
    this->PushChanged();
  }
}

void PlanarRefiner::Run()
{
  const double estimate = this->EstimatedCells();
  const double most =
    PointsPerPoint * static_cast<double>(this->Mesh.Points().size()) + PointsPerCell * estimate;
  if (most > std::numeric_limits<Id>::max() / 16.0)
  {
    std::ostringstream words;
    words << "there would be about " << std::setprecision(2) << estimate
          << " triangles, more than can be counted";
    throw Error(ErrorCode::TooLarge, words.str());
  }
  for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
  {
    this->Push(cell);
  }
  const LoopProgress progress(this->Watch, { Stages::Refining, 0, 0.8 },
    static_cast<std::size_t>(6 * estimate) + 6 * this->Mesh.Cells().size());
  for (std::size_t turn = 0; !this->Tasks.empty() && !this->HasRunOut; ++turn)
  {
    progress.Check(turn);
    const Task task = this->Tasks.top();
    this->Tasks.pop();
    if (this->Mesh.Cells()[task.At.Cell].Version == task.Version)
    {
      task.At.Edge == None ? this->LookAtTriangle(task) : this->LookAtConstraint(task);
      this->HasRunOut = static_cast<double>(this->Mesh.Points().size()) > most;
    }
  }
}

Id PlanarRefiner::CountLargeCells() const
{
  const auto& points = this->Mesh.Points();
  return static_cast<Id>(std::count_if(this->Mesh.Cells().begin(), this->Mesh.Cells().end(),
    [&](const RefinableTriangles::Cell& cell)
    {
      const auto& [a, b, c] = cell.Corners;
      return AreaOf(points[a], points[b], points[c], this->Mesh.Metric()) > this->MostArea;
    }));
}

/** Relative to a wanted length. */
Id PlanarRefiner::CountLongCells() const
{
  return static_cast<Id>(std::count_if(this->Mesh.Cells().begin(), this->Mesh.Cells().end(),
    [&](const RefinableTriangles::Cell& cell)
    {
      const auto& [a, b, c] = cell.Corners;
      return std::max({ this->Length(a, b), this->Length(b, c), this->Length(c, a) }) >
        TooLong * this->EdgeLength;
    }));
}
} // namespace insideout

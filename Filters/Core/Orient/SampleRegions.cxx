// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/SampleRegions.h"

#include "Common/BoxTree.h"
#include "Common/ChunkedLoop.h"
#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"

#include <algorithm>
#include <map>
#include <optional>

namespace insideout
{
namespace
{
/** The error of a few operations on coordinates below 1. */
constexpr double Rounding = 0x1p-45;

struct Line
{
  Point Origin;
  Point Direction; ///< of length 1

  /** False only where the line certainly misses the box: coordinates are below 1. */
  bool MayMeet(const Box& box) const
  {
    Point centre;
    Point half;
    for (int axis = 0; axis < 3; ++axis)
    {
      centre[axis] = (box.Low[axis] + box.High[axis]) / 2 - this->Origin[axis];
      half[axis] = (box.High[axis] - box.Low[axis]) / 2;
    }
    const Point& d = this->Direction;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int i = (axis + 1) % 3;
      const int j = (axis + 2) % 3;
      if (std::abs(centre[i] * d[j] - centre[j] * d[i]) >
        half[i] * std::abs(d[j]) + half[j] * std::abs(d[i]) + Rounding)
      {
        return false;
      }
    }
    return true;
  }
};

using Crossing = CrossedLine::Crossing;

/** A stretch of a line within one region. */
struct Stretch
{
  std::vector<ShellWinding> Windings;
  double Length;
};

/** A line may meet an edge: it is replaced by up to this many others. */
constexpr int MostTries = 16;

constexpr double NanosecondsPerTriangle = 20; ///< for its area and its box
} // namespace

/** All triangles of all shells, to draw lines through. */
class RegionSampler::Scene
{
public:
  Scene(const std::vector<Point>& points, const std::vector<ShellChain>& chains)
    : Points(points)
  {
    std::size_t count = 0;
    for (const ShellChain& chain : chains)
    {
      count += chain.Kind == ShellKind::Sheet ? 0 : chain.Triangles.size();
    }
    this->Facets.resize(count);
    RawVector<Box> boxes(count);
    std::size_t first = 0;
    for (Id shell = 0; shell < static_cast<Id>(chains.size()); ++shell)
    {
      if (chains[shell].Kind == ShellKind::Sheet)
      {
        continue;
      }
      const std::vector<CountedTriangle>& triangles = chains[shell].Triangles;
      ParallelLoop(triangles.size(), NanosecondsPerTriangle,
        [&](std::size_t i)
        {
          const auto& [corners, multiplicity] = triangles[i];
          const auto [a, b, c] = CornersOf(points, corners);
          this->Facets[first + i] = { corners, shell, multiplicity, Length(NormalOf(a, b, c)) / 2 };
          boxes[first + i] = BoundingBox(points, corners);
        });
      const std::size_t last = first + triangles.size();
      double area = 0;
      for (std::size_t f = first; f < last; ++f)
      {
        area += this->Facets[f].AreaUpTo;
        this->Facets[f].AreaUpTo = area;
      }
      this->Ranges.push_back({ first, last });
      this->Areas.resize(chains.size(), 0);
      this->Areas[shell] = area;
      first = last;
    }
    this->Tree.emplace(boxes);
  }

  Id NumberOfShells() const { return static_cast<Id>(this->Ranges.size()); }

  /**
   * A line through a shell. @param[in] part fraction of its area, 0 to 1, at which the line begins
   */
  Line Draw(Id shell, double part, RandomNumbers& random) const
  {
    const auto [first, last] = this->Ranges[shell];
    const auto begin = this->Facets.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = this->Facets.begin() + static_cast<std::ptrdiff_t>(last - 1);
    const double area = part * end->AreaUpTo;
    const Facet& facet =
      *std::lower_bound(begin, end, area, [](const Facet& f, double a) { return f.AreaUpTo < a; });
    const auto [a, b, c] = CornersOf(this->Points, facet.Corners);
    const double root = std::sqrt(random.Next());
    const double share = random.Next();
    const Point normal = NormalOf(a, b, c);
    const double size = Length(normal);
    Line line;
    double length = 0;
    while (!(length > 0x1p-20)) // nearly always
    {
      const Point sphere = random.OnSphere();
      for (int axis = 0; axis < 3; ++axis)
      {
        line.Origin[axis] = (1 - root) * a[axis] + root * ((1 - share) * b[axis] + share * c[axis]);
        line.Direction[axis] = (size > 0 ? normal[axis] / size : 0) + sphere[axis];
      }
      length = Length(line.Direction);
    }
    for (double& x : line.Direction)
    {
      x /= length;
    }
    return line;
  }

  /**
   * The line's crossings with the shells. Signs of products of coordinates, common to the facets
   * that share an edge, decide on which side of the line an edge is: the line cannot slip through.
   *
   * @return false if it meets an edge, as far as doubles decide
   */
  bool Cross(const Line& line, std::vector<Crossing>& crossings) const
  {
    crossings.clear();
    const std::array<Point, 2> frame = FrameOf(line.Direction);
    bool sure = true;
    this->Tree->VisitWhere([&](const Box& box) { return line.MayMeet(box); },
      [&](Id f)
      {
        const Facet& facet = this->Facets[f];
        const std::array<Point, 3> corners = CornersOf(this->Points, facet.Corners);
        std::array<std::array<double, 3>, 3> seen; // coordinates across the line, and along it
        for (int k = 0; k < 3; ++k)
        {
          const Point from = Difference(corners[k], line.Origin);
          seen[k] = { Dot(from, frame[0]), Dot(from, frame[1]), Dot(from, line.Direction) };
        }
        std::array<double, 3> weights;
        for (int k = 0; k < 3; ++k)
        {
          const auto& p = seen[(k + 1) % 3];
          const auto& q = seen[(k + 2) % 3];
          weights[k] = p[0] * q[1] - q[0] * p[1];
        }
        const auto [least, most] = std::minmax_element(weights.begin(), weights.end());
        if (*least < 0 && *most > 0)
        {
          return;
        }
        sure = sure && *least * *most > 0;
        const double sum = weights[0] + weights[1] + weights[2];
        crossings.push_back({ (weights[0] / sum) * seen[0][2] + (weights[1] / sum) * seen[1][2] +
            (weights[2] / sum) * seen[2][2],
          ErrorOfCrossing(seen, sum), facet.Shell, sum > 0 ? -facet.Count : facet.Count });
      });
    return sure;
  }

  /** The stretches of a line between its crossings, as far as they count. */
  std::vector<Stretch> Divide(std::vector<Crossing>& crossings) const
  {
    // The density of drawing the line among all lines, per line of each shell.
    double density = 0;
    for (const Crossing& crossing : crossings)
    {
      density += 1 / (Pi * this->Areas[crossing.Shell]);
    }
    std::sort(crossings.begin(), crossings.end(),
      [](const Crossing& a, const Crossing& b)
      { return std::tie(a.At, a.Shell, a.Rise) < std::tie(b.At, b.Shell, b.Rise); });
    std::vector<Stretch> stretches;
    std::map<Id, int> windings;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i)
    {
      int& w = windings[crossings[i].Shell];
      w += crossings[i].Rise;
      if (w == 0)
      {
        windings.erase(crossings[i].Shell);
      }
      // Facets that partly coincide are crossed at one place, in an order decided by rounding.
      const double length = crossings[i + 1].At - crossings[i].At;
      if (!windings.empty() && length > crossings[i].Error + crossings[i + 1].Error)
      {
        // The lines through a point have a solid angle of 2 pi.
        Stretch stretch = { {}, length / (2 * Pi * density) };
        for (const auto& [shell, count] : windings)
        {
          stretch.Windings.push_back({ shell, count });
        }
        stretches.push_back(std::move(stretch));
      }
    }
    return stretches;
  }

private:
  struct Facet
  {
    Triangle Corners;
    Id Shell;
    int Count;
    double AreaUpTo; ///< cumulated over the shell's facets
  };

  /** The error of Crossing::At: weights have rounding errors, which grow as the facet gets flatter
   * or thinner seen along the line. */
  static double ErrorOfCrossing(const std::array<std::array<double, 3>, 3>& seen, double sum)
  {
    double across = 0;
    for (const auto& corner : seen)
    {
      across = std::max({ across, std::abs(corner[0]), std::abs(corner[1]) });
    }
    const auto [first, last] = std::minmax({ seen[0][2], seen[1][2], seen[2][2] });
    return Rounding * (1 + across * (last - first) / std::abs(sum));
  }

  static std::array<Point, 2> FrameOf(const Point& direction)
  {
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
      least = std::abs(direction[axis]) < std::abs(direction[least]) ? axis : least;
    }
    Point axis = { 0, 0, 0 };
    axis[least] = 1;
    const Point across = insideout::Cross(direction, axis);
    return { across, insideout::Cross(direction, across) };
  }

  const std::vector<Point>& Points;
  RawVector<Facet> Facets;
  std::vector<std::array<std::size_t, 2>> Ranges; // of the facets, per shell that is not a sheet
  std::vector<double> Areas;                      // per shell, with its caps
  std::optional<BoxTree> Tree;
};

RegionSampler::RegionSampler(
  const std::vector<Point>& points, const std::vector<ShellChain>& chains)
  : Shells(std::make_unique<const Scene>(points, chains))
{
}

RegionSampler::~RegionSampler() = default;

CrossedLine RegionSampler::Through(const Point& point, RandomNumbers& random) const
{
  CrossedLine line;
  for (int tries = 0; tries < MostTries; ++tries)
  {
    line.Direction = random.OnSphere();
    if (this->Shells->Cross({ point, line.Direction }, line.Crossings))
    {
      return line;
    }
  }
  return {};
}

std::vector<ShellWinding> RegionSampler::At(const Point& point, RandomNumbers& random) const
{
  std::map<Id, int> windings;
  for (const Crossing& crossing : this->Through(point, random).Crossings)
  {
    windings[crossing.Shell] += crossing.At < 0 ? crossing.Rise : 0;
  }
  std::vector<ShellWinding> found;
  for (const auto& [shell, w] : windings)
  {
    if (w != 0)
    {
      found.push_back({ shell, w });
    }
  }
  return found;
}

std::vector<ShellRegion> RegionSampler::Sample(
  Id linesPerShell, Monitor& monitor, const ProgressRange& progress) const
{
  const Scene& scene = *this->Shells;
  const Id lines = scene.NumberOfShells() * linesPerShell;
  std::vector<std::vector<Stretch>> stretches(static_cast<std::size_t>(lines));
  const auto draw = [&](Id i)
  {
    RandomNumbers random(static_cast<std::uint64_t>(i));
    std::vector<Crossing> crossings;
    for (int tries = 0; tries < MostTries; ++tries)
    {
      const double part = (i % linesPerShell + random.Next()) / linesPerShell;
      if (scene.Cross(scene.Draw(i / linesPerShell, part, random), crossings))
      {
        stretches[i] = scene.Divide(crossings);
        return;
      }
    }
  };
  const double nanosecondsPerLine = 5000; // for tens of thousands of facets; half of it for few
  ChunkedLoop(lines, nanosecondsPerLine, monitor, progress, draw);

  std::map<std::vector<ShellWinding>, double> volumes;
  for (const std::vector<Stretch>& line : stretches)
  {
    for (const Stretch& stretch : line)
    {
      volumes[stretch.Windings] += stretch.Length / linesPerShell;
    }
  }
  std::vector<ShellRegion> regions;
  for (auto& [windings, volume] : volumes)
  {
    regions.push_back({ windings, volume });
  }
  return regions;
}
} // namespace insideout

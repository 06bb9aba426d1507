// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/VoxelFractions.h"

#include "Common/Box.h"
#include "Common/Buckets.h"
#include "Common/ChunkedLoop.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
using Polygon = std::vector<Point>;

/** A convex body given by its faces, which run counter-clockwise seen from outside. */
using Body = std::vector<Polygon>;

Body BodyOf(std::array<Point, 4> corners)
{
  if (Determinant(Difference(corners[1], corners[0]), Difference(corners[2], corners[0]),
        Difference(corners[3], corners[0])) < 0)
  {
    std::swap(corners[2], corners[3]);
  }
  Body body;
  for (const auto& face : TetrahedronFaces)
  {
    body.push_back({ corners[face[0]], corners[face[1]], corners[face[2]] });
  }
  return body;
}

/** Relative to a corner of its own, so that a small body far from 0 loses few digits. */
double VolumeOf(const Body& body)
{
  double volume = 0;
  for (const Polygon& face : body)
  {
    for (std::size_t k = 2; k < face.size(); ++k)
    {
      const Point& apex = body.front().front();
      volume += Determinant(
        Difference(face[0], apex), Difference(face[k - 1], apex), Difference(face[k], apex));
    }
  }
  return volume / 6;
}

/** The points of a convex face that is perpendicular to an axis, in the order around it. */
Polygon Around(Polygon points, int axis, int side)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  Point middle = { 0, 0, 0 };
  for (const Point& p : points)
  {
    middle[u] += p[u] / static_cast<double>(points.size());
    middle[v] += p[v] / static_cast<double>(points.size());
  }
  const auto angle = [&](const Point& p)
  { return side * std::atan2(p[v] - middle[v], p[u] - middle[u]); };
  std::sort(points.begin(), points.end(),
    [&](const Point& a, const Point& b) { return angle(a) < angle(b); });
  return points;
}

/** The part of the body below a coordinate (side +1), or above it (-1). */
Body Cut(const Body& body, int axis, double x, int side)
{
  Body rest;
  Polygon lid;
  for (const Polygon& face : body)
  {
    Polygon kept;
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      const Point& a = face[k];
      const Point& b = face[(k + 1) % face.size()];
      const double toA = side * (x - a[axis]);
      const double toB = side * (x - b[axis]);
      if (toA >= 0)
      {
        kept.push_back(a);
      }
      if ((toA > 0 && toB < 0) || (toA < 0 && toB > 0))
      {
        // From the lower end, so that both faces at an edge get the same point.
        const bool fromA = a < b;
        const Point& from = fromA ? a : b;
        const Point& to = fromA ? b : a;
        const double t = (x - from[axis]) / (to[axis] - from[axis]);
        Point p;
        for (int i = 0; i < 3; ++i)
        {
          p[i] = from[i] + t * (to[i] - from[i]);
        }
        p[axis] = x;
        kept.push_back(p);
      }
    }
    for (const Point& p : kept)
    {
      if (p[axis] == x)
      {
        lid.push_back(p);
      }
    }
    if (kept.size() > 2)
    {
      rest.push_back(std::move(kept));
    }
  }
  std::sort(lid.begin(), lid.end());
  lid.erase(std::unique(lid.begin(), lid.end()), lid.end());
  if (lid.size() > 2 && rest.size() > 2)
  {
    rest.push_back(Around(std::move(lid), axis, side));
  }
  return rest;
}

Box BoxOf(const Body& body)
{
  Box box = Box::Empty();
  for (const Polygon& face : body)
  {
    for (const Point& p : face)
    {
      box.Add(p);
    }
  }
  return box;
}

struct Range
{
  std::size_t First;
  std::size_t Last; ///< not included
};

/** The layers along an axis that meet an interval. */
Range LayersOf(const std::vector<double>& sides, double low, double high)
{
  const auto first = std::upper_bound(sides.begin(), sides.end(), low);
  const auto last = std::lower_bound(sides.begin(), sides.end(), high);
  const std::ptrdiff_t layers = static_cast<std::ptrdiff_t>(sides.size()) - 1;
  return { static_cast<std::size_t>(std::max<std::ptrdiff_t>(first - sides.begin() - 1, 0)),
    static_cast<std::size_t>(std::min<std::ptrdiff_t>(last - sides.begin(), layers)) };
}

/** Call visit(i, part) for each layer of the axis with the body's part in it. */
template <typename Visitor>
void ForLayers(const Body& body, int axis, const std::vector<double>& sides, const Visitor& visit)
{
  const Box box = BoxOf(body);
  const Range layers = LayersOf(sides, box.Low[axis], box.High[axis]);
  for (std::size_t i = layers.First; i < layers.Last; ++i)
  {
    const bool above = box.Low[axis] < sides[i];
    const bool below = box.High[axis] > sides[i + 1];
    const Body trimmed = above ? Cut(body, axis, sides[i], -1) : body;
    const Body part = below ? Cut(trimmed, axis, sides[i + 1], 1) : trimmed;
    if (part.size() > 3)
    {
      visit(i, part);
    }
  }
}
} // namespace

std::vector<double> VoxelFractions(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const std::array<std::vector<double>, 3>& sides,
  Monitor& monitor, const ProgressRange& progress)
{
  const std::size_t nx = sides[0].size() - 1;
  const std::size_t ny = sides[1].size() - 1;
  const std::size_t nz = sides[2].size() - 1;
  std::vector<double> fractions(nx * ny * nz, 0);
  const Buckets<Id> inLayer(nz,
    [&](const auto& visit)
    {
      for (Id c = 0; c < static_cast<Id>(cells.size()); ++c)
      {
        const Box box = BoundingBox(points, cells[c]);
        const Range layers = LayersOf(sides[2], box.Low[2], box.High[2]);
        for (std::size_t k = layers.First; k < layers.Last; ++k)
        {
          visit(k, c);
        }
      }
    });
  const double nanosecondsPerLayer = 3000.0 * static_cast<double>(cells.size() + 1);
  ChunkedLoop(static_cast<Id>(nz), nanosecondsPerLayer, monitor, progress,
    [&](Id k)
    {
      const std::vector<double> layer = { sides[2][k], sides[2][k + 1] };
      double* const ofLayer = &fractions[static_cast<std::size_t>(k) * nx * ny];
      for (const Id c : inLayer[static_cast<std::size_t>(k)])
      {
        ForLayers(BodyOf(CornersOf(points, cells[c])), 2, layer,
          [&](std::size_t, const Body& slab)
          {
            ForLayers(slab, 1, sides[1],
              [&](std::size_t j, const Body& row)
              {
                ForLayers(row, 0, sides[0],
                  [&](std::size_t i, const Body& part) { ofLayer[j * nx + i] += VolumeOf(part); });
              });
          });
      }
      for (std::size_t j = 0; j < ny; ++j)
      {
        for (std::size_t i = 0; i < nx; ++i)
        {
          ofLayer[j * nx + i] /= (sides[0][i + 1] - sides[0][i]) * (sides[1][j + 1] - sides[1][j]) *
            (layer[1] - layer[0]);
        }
      }
    });
  return fractions;
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumberByEmbree.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <limits>

namespace benchmark
{
using namespace insideout;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/** A query's context, with the signed number of facets that its ray has crossed so far. */
struct CountingContext
{
  RTCIntersectContext Base;
  const FacetComplex* Surface;
  int Sum;
};

/** Counts a hit along the direction of the ray, and tells Embree to go on. */
void CountHit(const RTCFilterFunctionNArguments* arguments)
{
  auto* context = reinterpret_cast<CountingContext*>(arguments->context);
  const float normal = RTCHitN_Ng_z(arguments->hit, arguments->N, 0);
  const unsigned facet = RTCHitN_primID(arguments->hit, arguments->N, 0);
  const int multiplicity = context->Surface->Multiplicity[facet];
  context->Sum += normal > 0 ? multiplicity : -multiplicity;
  arguments->valid[0] = 0;
}
} // namespace

WindingNumberByEmbree::WindingNumberByEmbree(const FacetComplex& surface)
  : Surface(surface)
  , Device(rtcNewDevice(nullptr))
  , Scene(rtcNewScene(this->Device))
{
  std::vector<CountedTriangle> triangles;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    triangles.push_back({ surface.Facets[f], surface.Multiplicity[f] });
  }
  this->Boundary = CountedBoundary(triangles, static_cast<Id>(surface.Points.size()));

  const RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
    RTC_FORMAT_FLOAT3, 3 * sizeof(float), surface.Points.size()));
  for (const Point& p : surface.Points)
  {
    for (const double x : p)
    {
      *points++ = static_cast<float>(x);
    }
  }
  auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
    RTC_FORMAT_UINT3, 3 * sizeof(unsigned), surface.Facets.size()));
  for (const Triangle& t : surface.Facets)
  {
    for (const Id p : t)
    {
      *corners++ = static_cast<unsigned>(p);
    }
  }
  rtcSetGeometryOccludedFilterFunction(geometry, CountHit);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(this->Scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneFlags(this->Scene, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(this->Scene);
}

WindingNumberByEmbree::~WindingNumberByEmbree()
{
  rtcReleaseScene(this->Scene);
  rtcReleaseDevice(this->Device);
}

double WindingNumberByEmbree::Crossings(const Point& p) const
{
  CountingContext context;
  rtcInitIntersectContext(&context.Base);
  context.Surface = &this->Surface;
  context.Sum = 0;
  RTCRay ray = {};
  ray.org_x = static_cast<float>(p[0]);
  ray.org_y = static_cast<float>(p[1]);
  ray.org_z = static_cast<float>(p[2]);
  ray.dir_z = 1;
  ray.tfar = std::numeric_limits<float>::infinity();
  ray.mask = ~0u;
  rtcOccluded1(this->Scene, &context.Base, &ray);
  return context.Sum;
}

/**
 * Seen from p, the surface and a fan over its boundary from the direction opposite to the ray's
 * close; the ray does not meet the fan. This is the fan's solid angle over 4 pi.
 */
double WindingNumberByEmbree::BoundaryIntegral(const Point& p) const
{
  double sum = 0;
  for (const CountedEdge& edge : this->Boundary)
  {
    Point a, b;
    for (int axis = 0; axis < 3; ++axis)
    {
      a[axis] = this->Surface.Points[edge.From][axis] - p[axis];
      b[axis] = this->Surface.Points[edge.To][axis] - p[axis];
    }
    const double lengthA = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    const double lengthB = std::sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
    const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const double det = -(a[0] * b[1] - a[1] * b[0]);
    const double div = lengthA * lengthB + dot - b[2] * lengthA - a[2] * lengthB;
    sum += static_cast<double>(edge.Count) * std::atan2(det, div);
  }
  return sum / (2 * Pi);
}

std::vector<double> WindingNumberByEmbree::At(const std::vector<Point>& points) const
{
  std::vector<double> w(points.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    w[i] = this->Crossings(points[i]) + this->BoundaryIntegral(points[i]);
  }
  return w;
}
} // namespace benchmark

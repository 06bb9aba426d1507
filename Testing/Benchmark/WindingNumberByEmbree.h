// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "WindingNumber/CountedBoundary.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace benchmark
{
/**
 * The winding number by signed crossings of one ray, with Embree, and an arctangent for each open
 * edge: a stand-in for the method of Martens, Trettner and Bessmeltsev (2026), which is the fastest
 * published one. Embree computes in single precision, so that a value may be off by a unit.
 */
class WindingNumberByEmbree
{
public:
  explicit WindingNumberByEmbree(const insideout::FacetComplex& surface);
  ~WindingNumberByEmbree();
  WindingNumberByEmbree(const WindingNumberByEmbree&) = delete;
  void operator=(const WindingNumberByEmbree&) = delete;

  /** On all threads. */
  std::vector<double> At(const std::vector<insideout::Point>& points) const;

private:
  double Crossings(const insideout::Point& p) const;
  double BoundaryIntegral(const insideout::Point& p) const;

  const insideout::FacetComplex& Surface;
  std::vector<insideout::CountedEdge> Boundary;
  RTCDeviceTy* Device;
  RTCSceneTy* Scene;
};
} // namespace benchmark

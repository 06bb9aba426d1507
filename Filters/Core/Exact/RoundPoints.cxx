// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RoundPoints.h"

#include "Exact/MovePoint.h"
#include "Exact/Phases.h"
#include "Exact/RoundingPlaces.h"
#include "Exact/SteinerPoints.h"

#include <algorithm>

namespace insideout
{
std::vector<Id> RoundInOrder(ExactState& state)
{
  const FlippableMesh& mesh = state.Mesh;
  std::vector<Id> left;
  const Id end = mesh.Vertices().Size();
  for (Id point = mesh.Infinite() + 1; point < end; ++point)
  {
    if (mesh.Vertices().IsDouble(point) || !mesh.HasVertex(point))
    {
      continue;
    }
    state.Report(Phases::RoundingPoints);
    const std::vector<Point> places = PlacesFor(state, point);
    if (std::none_of(places.begin(), places.end(),
          [&](const Point& place) { return MovePoint(state, point, place); }))
    {
      left.push_back(point);
    }
  }
  return left;
}

std::vector<Id> RoundPoints(ExactState& state, std::int64_t since)
{
  const Id first = state.Mesh.Infinite() + 1;
  std::vector<Id> left = RoundInOrder(state);
  std::size_t before = left.size() + 1;
  while (!left.empty() && left.size() < before)
  {
    before = left.size();
    Tidy(state, first, since);
    left = RoundInOrder(state);
  }
  int patience = ShakesWithoutGain;
  while (!left.empty() && patience > 0 && !state.Mesh.Work().IsUsedUp())
  {
    before = left.size();
    Shake(state, left);
    left = RoundInOrder(state);
    patience = left.size() < before ? ShakesWithoutGain : patience - 1;
  }
  return left;
}
} // namespace insideout

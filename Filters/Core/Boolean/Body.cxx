// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/Body.h"

#include "Common/Buckets.h"
#include "Common/Error.h"
#include "Common/SortUniquely.h"

#include <numeric>

namespace insideout
{
Body MakeBody(std::string name, TriangleSoup soup, Id firstPoint, Id firstTriangle)
{
  Body body;
  body.Name = std::move(name);
  body.PointIds.resize(soup.Points.size());
  body.TriangleIds.resize(soup.Triangles.size());
  std::iota(body.PointIds.begin(), body.PointIds.end(), firstPoint);
  std::iota(body.TriangleIds.begin(), body.TriangleIds.end(), firstTriangle);
  body.Soup = std::move(soup);
  return body;
}

std::vector<Body> OneBody(TriangleSoup soup)
{
  std::vector<Body> bodies; // a list of initial values would be copied
  bodies.push_back(MakeBody({}, std::move(soup), 0, 0));
  return bodies;
}

namespace
{
void CheckSplit(
  const TriangleSoup& soup, const std::vector<Id>& bodyOfTriangle, std::size_t numberOfBodies)
{
  if (bodyOfTriangle.size() != soup.Triangles.size())
  {
    throw Error(ErrorCode::InvalidParameter,
      "bodies are given for " + std::to_string(bodyOfTriangle.size()) + " of " +
        std::to_string(soup.Triangles.size()) + " triangles");
  }
  for (std::size_t t = 0; t < soup.Triangles.size(); ++t)
  {
    const Id body = bodyOfTriangle[t];
    if (body < 0 || body >= static_cast<Id>(numberOfBodies))
    {
      throw Error(ErrorCode::InvalidParameter,
        "triangle " + std::to_string(t) + " is of body " + std::to_string(body) + " of " +
          std::to_string(numberOfBodies));
    }
    for (const Id p : soup.Triangles[t])
    {
      if (p < 0 || p >= static_cast<Id>(soup.Points.size()))
      {
        throw Error(ErrorCode::PointOutOfRange,
          "triangle " + std::to_string(t) + " refers to point " + std::to_string(p) + " of " +
            std::to_string(soup.Points.size()));
      }
    }
  }
}
} // namespace

std::vector<Body> SplitBodies(const TriangleSoup& soup, const std::vector<Id>& bodyOfTriangle,
  const std::vector<std::string>& names)
{
  CheckSplit(soup, bodyOfTriangle, names.size());
  const Buckets<Id> triangles(names.size(),
    [&](auto visit)
    {
      for (std::size_t t = 0; t < soup.Triangles.size(); ++t)
      {
        visit(static_cast<std::size_t>(bodyOfTriangle[t]), static_cast<Id>(t));
      }
    });
  std::vector<Body> bodies;
  std::vector<Id> index(soup.Points.size(), None);
  for (std::size_t b = 0; b < names.size(); ++b)
  {
    Body body;
    body.Name = names[b];
    body.TriangleIds.assign(triangles[b].begin(), triangles[b].end());
    for (const Id t : triangles[b])
    {
      body.PointIds.insert(body.PointIds.end(), soup.Triangles[t].begin(), soup.Triangles[t].end());
    }
    SortUniquely(body.PointIds);
    for (const Id p : body.PointIds)
    {
      index[p] = static_cast<Id>(body.Soup.Points.size());
      body.Soup.Points.push_back(soup.Points[p]);
    }
    for (const Id t : triangles[b])
    {
      const Triangle& corners = soup.Triangles[t];
      body.Soup.Triangles.push_back(
        { { index[corners[0]], index[corners[1]], index[corners[2]] } });
      if (!soup.Multiplicity.empty())
      {
        body.Soup.Multiplicity.push_back(soup.Multiplicity[t]);
      }
      if (!soup.NonParticipating.empty())
      {
        body.Soup.NonParticipating.push_back(soup.NonParticipating[t]);
      }
    }
    bodies.push_back(std::move(body));
  }
  return bodies;
}
} // namespace insideout

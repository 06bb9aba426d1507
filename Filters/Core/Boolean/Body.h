// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Error.h"
#include "Common/FacetComplex.h"

#include <string>

namespace insideout
{
/** A given body: a surface, and the numbers of its points and triangles. */
struct Body
{
  std::string Name; ///< for messages; empty for a surface that is given alone
  TriangleSoup Soup;
  std::vector<Id> PointIds;    ///< one per point; bodies may share numbers of points
  std::vector<Id> TriangleIds; ///< one per triangle, ascending; no two bodies share one
};

/** A surface as the only body, without a name. */
std::vector<Body> OneBody(TriangleSoup soup);

/** Whether there are several bodies, or one with a name. */
inline bool AreNamed(const std::vector<Body>& bodies)
{
  return bodies.size() != 1 || !bodies.front().Name.empty();
}

/**
 * A body from a surface; its points are numbered from `firstPoint` on, and its triangles from
 * `firstTriangle`.
 */
Body MakeBody(std::string name, TriangleSoup soup, Id firstPoint, Id firstTriangle);

/**
 * The bodies of one surface. Points and triangles keep their numbers.
 *
 * @param[in] bodyOfTriangle one per triangle: the index of its body in `names`
 * @throws Error InvalidParameter if a body is out of range; PointOutOfRange
 */
std::vector<Body> SplitBodies(const TriangleSoup& soup, const std::vector<Id>& bodyOfTriangle,
  const std::vector<std::string>& names);

/** A message about a body, with the body's name in front. */
inline std::string WordsOf(const std::string& body, const std::string& words)
{
  return body.empty() ? words : "body " + body + ": " + words;
}

/** Call a function on a body; the body's name is added to messages of errors. */
template <typename Work>
void InTheNameOf(const std::string& body, const Work& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    if (error.Code == ErrorCode::Stopped)
    {
      throw;
    }
    throw Error(error.Code, WordsOf(body, error.what()));
  }
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace insideout
{
/** The kind of an error; the message of the Error names the culprit. */
enum class ErrorCode
{
  EmptySurface,          ///< no facet was given
  PointNotFinite,        ///< a coordinate is NaN or infinite
  PointOutOfRange,       ///< a facet refers to a point that does not exist
  AllDegenerate,         ///< facets were given, but all have no area
  Planar,                ///< all facets lie in one plane, so there is no volume to fill
  TooLarge,              ///< more points, facets or cells than Id can count
  InvalidParameter,      ///< an option outside its range
  FileUnreadable,        ///< the file is missing or cannot be opened
  FileMalformed,         ///< the file's content violates its format
  FileUnwritable,        ///< the file cannot be created or written
  SelfIntersecting,      ///< facets cross in a stage that requires them resolved
  TetrahedralizerDied,   ///< the helper program crashed, could not be started or sent garbage
  TetrahedralizerFailed, ///< the helper program ran and reported failure
  Inconsistent,          ///< a result failed its own check: a bug worth reporting
  Forked,                ///< this process was forked during a loop, without its threads
  Stopped                ///< the monitor requested a stop
};

/** Thrown by every stage. what() is one line a user can act on. */
class Error : public std::runtime_error
{
public:
  Error(ErrorCode code, const std::string& message)
    : std::runtime_error(message)
    , Code(code)
  {
  }

  const ErrorCode Code;
};
} // namespace insideout

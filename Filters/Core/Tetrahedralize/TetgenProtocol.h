// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/**
 * The protocol between the library and the helper program insideout-tetgen: one request and one
 * answer, in the machine's byte order. This file is all that the two sides share. Every count is
 * checked before anything is allocated by it.
 */
namespace insideout
{
namespace tetgenprotocol
{
/** First bytes of a message; the last digit is the protocol's version. */
constexpr std::uint64_t RequestMagic = 0x3351544F49534E49;
constexpr std::uint64_t AnswerMagic = 0x3341544F49534E49;

/** TetGen indexes its arrays of four numbers per element by int. */
constexpr std::int64_t MaximumCount = INT32_MAX / 4;
constexpr std::int64_t MaximumMessageLength = 4096;

/**
 * Followed by the points (3 double each) and the facets (3 int32 each).
 */
struct RequestHeader
{
  std::uint64_t Magic;
  std::int64_t
    LeaveSteinerPoints; ///< 0: off facets, where TetGen can avoid them; 1: where it put them
  std::int64_t NumberOfPoints;
  std::int64_t NumberOfFacets;
};

/**
 * Followed by the message (char), the points (3 double each; the request's come first, in their
 * order), the cells (4 int32 each), the faces that lie on facets (3 int32 each) and the facet of
 * each of these faces (int32). If the status is not 0, only the message follows.
 */
struct AnswerHeader
{
  std::uint64_t Magic;
  std::int64_t Status; ///< 0 for a mesh, else what TetGen threw
  std::int64_t MessageLength;
  std::int64_t NumberOfPoints;
  std::int64_t NumberOfCells;
  std::int64_t NumberOfFaces;
};

static_assert(sizeof(RequestHeader) == 32 && sizeof(AnswerHeader) == 48, "no padding");
static_assert(sizeof(double) == 8 && sizeof(int) == 4, "numbers go as they are in memory");
} // namespace tetgenprotocol
} // namespace insideout

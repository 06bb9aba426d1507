// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ProgressRange.h"

namespace insideout
{
/**
 * The phases of the exact engine, in the order of their first start. Each has a share of the
 * progress: about its share of the time on real surfaces. Phases that repeat within others have
 * none. If facets are lost, several phases repeat without progress.
 */
struct Phases
{
  static constexpr ProgressRange InsertingPoints = { "inserting points", 0, 0.1 };
  static constexpr ProgressRange RecoveringSegments = { "recovering segments", 0.1, 0.4 };
  static constexpr ProgressRange SplittingSegments = { "splitting segments", 0.4, 0.65 };
  static constexpr ProgressRange RecoveringFacets = { "recovering facets", 0.65, 0.7 };
  static constexpr ProgressRange SplittingFacets = { "splitting facets", 0.7, 0.75 };
  static constexpr ProgressRange ShakingPoints = { "shaking points", 0.75, 0.9 };
  static constexpr ProgressRange RecoveringLostFacets = { "recovering lost facets", 0.9, 1 };

  static constexpr ProgressRange MovingPoints = { "moving points into the volume", 0, 0 };
  static constexpr ProgressRange RemovingPoints = { "removing points", 0, 0 };
  static constexpr ProgressRange FindingCrossings = { "finding facets that cross", 0, 0 };
  static constexpr ProgressRange RoundingPoints = { "rounding points", 0, 0 };
};
} // namespace insideout

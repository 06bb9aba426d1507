// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace insideout
{
/**
 * A stage's name and the range of its progress, within 0 to 1, that a step or loop of it covers.
 */
struct ProgressRange
{
  const char* Stage;
  double Begin;
  double End;

  /** The progress when a fraction of the step, from 0 to 1, is done. */
  constexpr double At(double part) const { return this->Begin + part * (this->End - this->Begin); }
};
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Statistics.h"

#include <sys/resource.h>

namespace insideout
{
double PeakMemory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024; // ru_maxrss is in KiB
}
} // namespace insideout

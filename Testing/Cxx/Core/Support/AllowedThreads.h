// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <omp.h>

namespace testthreads
{
/** Sets the number of threads of loops during its lifetime. */
class Allowed
{
public:
  explicit Allowed(int threads)
    : Before(omp_get_max_threads())
  {
    omp_set_num_threads(threads);
  }
  ~Allowed() { omp_set_num_threads(this->Before); }
  Allowed(const Allowed&) = delete;
  Allowed& operator=(const Allowed&) = delete;

private:
  const int Before;
};
} // namespace testthreads

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "LeaveSteinerPoints.h"

#include <tetgen.h>

#include <cstdlib>

#include <dlfcn.h>

namespace
{
bool Leave = false;

/** A member function by the platform's calling convention: the object comes first. */
using RemoveVertex = int (*)(tetgenmesh*, tetgenmesh::point);

RemoveVertex TetgensOwn()
{
  void* const found = dlsym(RTLD_NEXT, "_ZN10tetgenmesh19removevertexbyflipsEPd");
  if (!found)
  {
    std::abort();
  }
  return reinterpret_cast<RemoveVertex>(found);
}
} // namespace

int tetgenmesh::removevertexbyflips(point steinerPoint)
{
  static const RemoveVertex own = TetgensOwn();
  return Leave ? 0 : own(this, steinerPoint);
}

void LeaveSteinerPoints()
{
  Leave = true;
}

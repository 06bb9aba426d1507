// SPDX-License-Identifier: GPL-3.0-or-later
#include "Data/Label.h"

#include "vtkInsideOutVersions.h"

#include <vtkObject.h>

namespace vtkInsideOut
{
std::string Label(vtkObject* object)
{
  const std::string name = NameOf(object, 0);
  return name.empty() ? name : name + ": ";
}
} // namespace vtkInsideOut

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Data/Label.h"

#include <vtkObject.h>

namespace vtkInsideOut
{
namespace
{
// VTK 9.1 has no names of objects.
template <typename Object>
auto NameOf(Object* object, int) -> decltype(object->GetObjectName())
{
  return object->GetObjectName();
}

template <typename Object>
std::string NameOf(Object*, long)
{
  return "";
}
} // namespace

std::string Label(vtkObject* object)
{
  const std::string name = NameOf(object, 0);
  return name.empty() ? name : name + ": ";
}
} // namespace vtkInsideOut

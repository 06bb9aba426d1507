// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutRange.h"

#include "Data/Label.h"

#include <vtkObject.h>

#include <sstream>

namespace vtkInsideOut
{
void WarnOfRange(vtkObject* owner, const char* option, double value, double least, double most)
{
  std::ostringstream range;
  range << (most < VTK_INT_MAX ? "from " : "at least ") << least;
  if (most < VTK_INT_MAX)
  {
    range << " to " << most;
  }
  vtkWarningWithObjectMacro(owner, << Label(owner) << option << " is " << value << ", but must be "
                                   << range.str() << ": it is taken as "
                                   << (value < least ? least : most));
}
} // namespace vtkInsideOut

// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The setter of an option that has a range.
 */
#ifndef vtkInsideOutRange_h
#define vtkInsideOutRange_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkType.h"                   // for VTK_DOUBLE_MAX

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
VTK_ABI_NAMESPACE_END

namespace vtkInsideOut
{
/** Warn that an option's value is out of its range, and that the nearest limit is used. */
VTKFILTERSINSIDEOUT_EXPORT void WarnOfRange(
  vtkObject* owner, const char* option, double value, double least, double most);

/** @return the value, or the nearest limit of its range, with a warning. VTK_DOUBLE_MAX and
 * VTK_INT_MAX stand for infinity: infinite values become them without a warning. */
template <typename Number>
Number InRange(vtkObject* owner, const char* option, Number value, Number least, Number most)
{
  if (value < least || (value > most && most < VTK_INT_MAX))
  {
    WarnOfRange(owner, option, value, least, most);
  }
  return value < least ? least : value > most ? most : value;
}
} // namespace vtkInsideOut

/** Setter and limits of an option. Unlike vtkSetClampMacro, the setter warns when it clamps. */
#define vtkInsideOutSetRangeMacro(name, type, least, most)                               \
  virtual void Set##name(type value)                                                     \
  {                                                                                      \
    const type taken = vtkInsideOut::InRange<type>(this, #name, value, (least), (most)); \
    if (this->name != taken)                                                             \
    {                                                                                    \
      this->name = taken;                                                                \
      this->Modified();                                                                  \
    }                                                                                    \
  }                                                                                      \
  virtual type Get##name##MinValue()                                                     \
  {                                                                                      \
    return least;                                                                        \
  }                                                                                      \
  virtual type Get##name##MaxValue()                                                     \
  {                                                                                      \
    return most;                                                                         \
  }

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The setter of an option that has a range.
 */
#ifndef vtkInsideOutRange_h
#define vtkInsideOutRange_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkType.h"                   // for VTK_DOUBLE_MAX

class vtkObject;

namespace vtkInsideOut
{
/** Warn that an option is given a value out of its range, of which the nearest limit is taken. */
VTKFILTERSINSIDEOUT_EXPORT void WarnOfRange(
  vtkObject* owner, const char* option, double value, double least, double most);

/** @return the value, or the nearest limit of its range, with a warning. VTK's largest number is no
 * limit: infinity becomes it without one. */
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

/** Setter and limits of an option, as vtkSetClampMacro has them, which warns of nothing. */
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

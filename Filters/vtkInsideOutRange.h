// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The setter of an option that has a range.
 */
#ifndef vtkInsideOutRange_h
#define vtkInsideOutRange_h

#include "vtkObject.h" // for warnings
#include "vtkType.h"   // for VTK_DOUBLE_MAX

#include <sstream>

namespace vtkInsideOut
{
/** @return the value, or the nearest limit of its range, with a warning. VTK's largest number is no
 * limit: infinity becomes it without one. */
template <typename Number>
Number InRange(vtkObject* owner, const char* option, Number value, Number least, Number most)
{
  const Number taken = value < least ? least : value > most ? most : value;
  const bool isBounded = most < VTK_INT_MAX;
  if (value < least || (value > most && isBounded))
  {
    std::ostringstream range;
    range << (isBounded ? "from " : "at least ") << least;
    if (isBounded)
    {
      range << " to " << most;
    }
    vtkWarningWithObjectMacro(owner, << option << " is " << value << ", but must be " << range.str()
                                     << ": it is taken as " << taken);
  }
  return taken;
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

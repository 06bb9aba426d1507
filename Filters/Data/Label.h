// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Data/VtkClasses.h"

#include <string>

namespace vtkInsideOut
{
/** The prefix of an object's messages: its name. The plugin sets labels as names of ParaView's
 * filters, because ParaView's window omits class and address. Empty without one. */
std::string Label(vtkObject* object);
} // namespace vtkInsideOut

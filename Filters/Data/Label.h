// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

class vtkObject;

namespace vtkInsideOut
{
/** The begin of each message of an object: the name that it was given, as the plugin gives
 * ParaView's filters their labels, since ParaView's window leaves out class and address. Empty
 * without one. */
std::string Label(vtkObject* object);
} // namespace vtkInsideOut

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Data/VtkClasses.h"

#include <string>
#include <vector>

namespace vtkInsideOut
{
/** Names by number from an array of field data: strings, or the names of its components, as in .vtu
 * files (ForPython/DataForXml.h). */
std::vector<std::string> NamesByNumber(vtkFieldData* data, const char* array);
} // namespace vtkInsideOut

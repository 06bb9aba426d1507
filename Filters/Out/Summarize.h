// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Data/VtkClasses.h"

#include <string>

namespace vtkInsideOut
{
/** Six lines from the statistics in the field data of a solid: the input, its defects, its holes,
 * the cells, the outliers and the verdict (Core/Verdict.h). Blocks are added up. Empty without
 * statistics. */
std::string Summarize(vtkDataObject* solid);
} // namespace vtkInsideOut

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

class vtkDataObject;

namespace vtkInsideOut
{
/** Six lines of the statistics that a solid has in its field data: of the input, what was wrong
 * with it and its holes, the cells, the outliers and the verdict (Core/Verdict.h). Blocks are added
 * up. Empty without. */
std::string Summarize(vtkDataObject* solid);
} // namespace vtkInsideOut

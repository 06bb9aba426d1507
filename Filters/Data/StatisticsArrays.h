// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "Data/VtkClasses.h"

namespace vtkInsideOut
{
/** The statistics in field data. */
insideout::Statistics StatisticsOf(vtkFieldData* fields);

/**
 * Add figures to the data's field data: the array Statistics, with names in StatisticsNames. These
 * arrays come first: ParaView's Information panel shows no field data whose first array is empty.
 * The last figure of a name counts.
 */
void AddStatistics(const insideout::Statistics& statistics, vtkDataObject* output);

/** Append the input's statistics to the output's own. */
void KeepStatistics(vtkFieldData* input, vtkDataObject* output);
} // namespace vtkInsideOut

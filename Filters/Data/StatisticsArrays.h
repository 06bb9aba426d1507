// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"

class vtkDataObject;
class vtkFieldData;

namespace vtkInsideOut
{
/** The statistics that field data has. */
insideout::Statistics StatisticsOf(vtkFieldData* fields);

/**
 * Put figures into the data's field data, beside those of other names that are there: the array
 * Statistics with their names in StatisticsNames. They come first: ParaView's Information panel
 * shows no field data whose first array is empty. The last of several with one name counts.
 */
void AddStatistics(const insideout::Statistics& statistics, vtkDataObject* output);

/** Put the statistics that the input came with behind those of the output that has its own. */
void KeepStatistics(vtkFieldData* input, vtkDataObject* output);
} // namespace vtkInsideOut

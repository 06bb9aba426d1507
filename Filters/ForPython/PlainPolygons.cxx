// SPDX-License-Identifier: GPL-3.0-or-later
#include "ForPython/PlainPolygons.h"

#include "ForPython/Listening.h"
#include "In/ReadSurface.h"
#include "Out/MakeOutputs.h"
#include "Rounding/RoundToFloats.h"

#include <vtkPolyData.h>

extern "C" void vtkInsideOutPlainPolygons(
  void* surface, void* plain, int inFloats, vtkInsideOutListener listener)
{
  vtkInsideOut::TellWhatFails(listener, "", "not enough memory for this surface",
    [&]()
    {
      vtkInsideOut::ListeningMonitor monitor(listener);
      insideout::PolygonSurface polygons =
        vtkInsideOut::ReadPolygons(vtkPolyData::SafeDownCast(static_cast<vtkObjectBase*>(surface)));
      if (inFloats)
      {
        const std::string worse = insideout::WordsOf(insideout::RoundToFloats(polygons, monitor));
        if (!worse.empty())
        {
          listener(VTK_INSIDEOUT_WARNING, worse.c_str(), 0);
        }
      }
      vtkPolyData::SafeDownCast(static_cast<vtkObjectBase*>(plain))
        ->ShallowCopy(vtkInsideOut::MakePolygons(polygons));
    });
}

# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of what each thing in the pipeline gives, in ParaView's window as they come, or of a trace.

    paraview --script=pipeline_numbers.py
    pvbatch pipeline_numbers.py TRACE.py
"""

import sys

from paraview import servermanager, simple


def tell(name, data):
    numbers = [f"{data.GetNumberOfPoints()} points", f"{data.GetNumberOfCells()} cells"]
    numbers.append("between " + " ".join(f"{bound:g}" for bound in data.GetBounds()))
    array = data.GetCellData().GetArray("w")
    if array:
        numbers.append(f"sum of w {sum(array.GetValue(i) for i in range(array.GetNumberOfTuples())):.9g}")
    print(f"{name}: {', '.join(numbers)}", flush=True)


WATCHED = set()


def watch(*_event):
    for (name, _), proxy in simple.GetSources().items():
        algorithm = proxy.GetClientSideObject()
        if name not in WATCHED and algorithm:
            WATCHED.add(name)
            algorithm.AddObserver("EndEvent", lambda done, _event, name=name: tell(name, done.GetOutputDataObject(0)))


if servermanager.vtkProcessModule.GetProcessType() == servermanager.vtkProcessModule.PROCESS_BATCH:
    with open(sys.argv[1], encoding="utf-8") as trace:
        exec(compile(trace.read(), sys.argv[1], "exec"))
    for (name, _), proxy in simple.GetSources().items():
        tell(name, servermanager.Fetch(servermanager.OutputPort(proxy, 0)))
else:
    servermanager.ProxyManager().SMProxyManager.AddObserver("RegisterEvent", watch)

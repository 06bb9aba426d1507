# SPDX-License-Identifier: GPL-3.0-or-later
"""What TestGui.py clicked together, from its state or the script of its state.

    pvbatch replay.py STATE.pvsm SCRIPT.py
    pvbatch replay.py SCRIPT.py

prints the volumes of the solid and of the hull, and Gamma; the first writes the script.
"""

import sys

from paraview import servermanager, simple, smstate


def volume(proxy, port):
    sizes = simple.CellSize(Input=servermanager.OutputPort(proxy, port))
    array = servermanager.Fetch(sizes).GetCellData().GetArray("Volume")
    return sum(array.GetValue(i) for i in range(array.GetNumberOfTuples()))


file = sys.argv[1]
if file.endswith(".pvsm"):
    simple.LoadState(file)
    with open(sys.argv[2], "w", encoding="utf-8") as script:
        script.write(smstate.get_state())
else:
    with open(file, encoding="utf-8") as script:
        exec(compile(script.read(), file, "exec"))
tetrahedralizer = simple.FindSource("RobustTetrahedralize1")
print(f"inside {volume(tetrahedralizer, 0):g}, hull {volume(tetrahedralizer, 3):g}, gamma {tetrahedralizer.Gamma:g}")

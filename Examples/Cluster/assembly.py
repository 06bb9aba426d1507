# SPDX-License-Identifier: GPL-3.0-or-later
"""The solids of an assembly's parts, on all ranks of a pvbatch.

    mpirun -np 8 pvbatch assembly.py ASSEMBLY.vtm SOLIDS.vtm

The blocks of SOLIDS.vtm have the names and the order of ASSEMBLY.vtm's; of a part that failed, which a message names,
the block is empty.
"""

import sys

from paraview import simple

assembly, solids = sys.argv[1:3]
reader = simple.OpenDataFile(assembly)
parts = simple.DistributeParts(Input=reader)
solid = simple.RobustTetrahedralize(Input=parts)
simple.SaveData(solids, proxy=solid, DataMode="Binary")

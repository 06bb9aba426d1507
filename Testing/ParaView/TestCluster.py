# SPDX-License-Identifier: GPL-3.0-or-later
"""What Examples/Cluster runs on many nodes, on the ranks of one: solids with the names and the order of their parts.

    TestCluster.py FOLDER mpirun ... pvbatch ...
"""

import subprocess
import sys
from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader, vtkXMLMultiBlockDataWriter

from insideout.pipeline import statistics_of

folder, command = Path(sys.argv[1]), sys.argv[2:]
script = Path(__file__).resolve().parents[2] / "Examples/Cluster/assembly.py"
folder.mkdir(parents=True, exist_ok=True)

PARTS = 5
blocks = vtkMultiBlockDataSet()
for part in range(PARTS):
    box = vtkCubeSource()
    box.SetXLength(1 + part)
    box.Update()
    blocks.SetBlock(part, box.GetOutput())
    blocks.GetMetaData(part).Set(vtkCompositeDataSet.NAME(), f"box {part}")
blocks.GetBlock(3).GetPoints().SetPoint(2, float("nan"), 0, 0)
writer = vtkXMLMultiBlockDataWriter()
writer.SetInputData(blocks)
writer.SetFileName(str(folder / "assembly.vtm"))
writer.SetDataModeToBinary()
writer.Write()

done = subprocess.run([*command, script, folder / "assembly.vtm", folder / "solids.vtm"], check=True, capture_output=True, text=True)
words = done.stdout + done.stderr
assert "block box 3: point 2 is not finite" in words, words

reader = vtkXMLMultiBlockDataReader()
reader.SetFileName(str(folder / "solids.vtm"))
reader.Update()
solids = reader.GetOutput()
names = [solids.GetMetaData(part).Get(vtkCompositeDataSet.NAME()) for part in range(solids.GetNumberOfBlocks())]
assert names == [f"box {part}" for part in range(PARTS)], names


def volume(block):
    """The volume of a solid, whichever rank wrote it."""
    if isinstance(block, vtkMultiBlockDataSet):
        return sum(volume(block.GetBlock(piece)) for piece in range(block.GetNumberOfBlocks()))
    return statistics_of(block).get("Volume", 0) if block else 0


volumes = [volume(solids.GetBlock(part)) for part in range(PARTS)]
assert all(abs(found - expected) < 1e-12 for found, expected in zip(volumes, (1, 2, 3, 0, 5))), volumes
print("names and volumes are right")

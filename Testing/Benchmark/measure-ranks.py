# SPDX-License-Identifier: GPL-3.0-or-later
"""What several processes (MPI ranks) gain: seconds, processor seconds and memory of a probe and of an assembly.

    measure-ranks.py [RANKS...]

Runs itself by pvbatch on each number of ranks (1, 2 and 4), one thread each, medians of three; and the assembly on one rank
with two threads that mesh a part each (BlocksAtOnce). `--facets`, `--queries`, `--parts` and `--facets-at-once` (pieces of a probe's surface, which all ranks have in turn) change the
sizes. Prints a line for each run and two targets.
"""

import argparse
import os
import statistics
import subprocess
import sys
import time

REPETITIONS = 3
LIMIT = 1.6  # how much faster two ranks are to be at least


def ball(steps, radius=1.0):
    from vtkmodules.vtkFiltersSources import vtkSphereSource

    source = vtkSphereSource()
    source.SetThetaResolution(2 * steps)
    source.SetPhiResolution(steps + 1)
    source.SetRadius(radius)
    source.SetOutputPointsPrecision(1)
    source.Update()
    return source.GetOutput()


def probe_piece(sizes, rank, ranks):
    """A filter whose update is what is measured: a piece of the ball, and as many places on each rank."""
    from vtkmodules.vtkCommonCore import vtkIdList
    from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

    import insideout

    surface = ball(max(2, int((sizes.facets / 4) ** 0.5)))
    count = surface.GetNumberOfCells()
    own = vtkIdList()
    for cell in range(rank * count // ranks, (rank + 1) * count // ranks):
        own.InsertNextId(cell)
    piece = vtkPolyData()
    piece.Allocate(own.GetNumberOfIds())
    piece.CopyCells(surface, own)
    side = max(2, int(sizes.queries ** (1 / 3)))
    places = vtkImageData()
    places.SetExtent(0, side - 1, 0, side - 1, rank * side // ranks, (rank + 1) * side // ranks - 1)
    places.SetOrigin(-1.1, -1.1, -1.1)
    places.SetSpacing(2.2 / side, 2.2 / side, 2.2 / side)
    probe = insideout.vtkProbeWindingNumber()
    probe.SetInputData(places)
    probe.SetSurfaceData(piece)
    probe.SetFacetsAtOnce(sizes.facets_at_once)
    return [probe]


def assembly_piece(sizes, rank, ranks):
    """The same for parts of 120 to 2,000 facets, all of which the first rank has read."""
    from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

    import insideout

    blocks = vtkMultiBlockDataSet()
    for part in range(sizes.parts if rank == 0 else 0):
        blocks.SetBlock(part, ball(6 + part * 7 % 17))
    parts = insideout.vtkDistributeParts()
    parts.SetInputData(blocks)
    solids = insideout.vtkRobustTetrahedralize()
    solids.SetInputConnection(parts.GetOutputPort())
    solids.ReleaseDataFlagOn()
    solids.SetBlocksAtOnce(sizes.threads)
    return [parts, solids]


def memory_now(name):
    """A figure of this process in KiB: its memory now (VmRSS), or at its peak (VmHWM)."""
    with open("/proc/self/status", encoding="utf-8") as status:
        return int(next(line for line in status if line.startswith(name)).split()[1])


def forget_peak():
    """Let VmHWM begin anew. Gives what is held now."""
    with open("/proc/self/clear_refs", "w", encoding="utf-8") as references:
        references.write("5")
    return memory_now("VmRSS")


def work(sizes):
    """On each rank; the first prints the slowest rank's seconds, the most processor seconds, and the most memory that was added, also
    by others than the first."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkParallelCore import vtkMultiProcessController

    import numpy as np

    controller = vtkMultiProcessController.GetGlobalController()
    rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    filters = (probe_piece if sizes.run == "probe" else assembly_piece)(sizes, rank, ranks)
    memory = forget_peak()
    controller.Barrier()
    began, busy = time.perf_counter(), time.process_time()
    filters[-1].UpdatePiece(rank, ranks, 0)
    busy = time.process_time() - busy
    controller.Barrier()
    memory = (memory_now("VmHWM") - memory) / 1024
    own = [time.perf_counter() - began, busy, memory, 0 if rank == 0 else memory]
    most = numpy_to_vtk(np.zeros(4))
    controller.AllReduce(numpy_to_vtk(np.array(own)), most, 0)  # vtkCommunicator.MAX_OP
    if rank == 0:
        print("measured", *vtk_to_numpy(most))


def run(name, ranks, arguments):
    """Medians of [seconds, processor seconds of the busiest rank, MiB of the largest, MiB of the largest but the first]."""
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    environment["OMP_NUM_THREADS"] = next((word.split("=")[1] for word in arguments if word.startswith("--threads=")), "1")
    # A rank that is bound to one core, as one or two are, would have both of its threads there.
    command = ["mpirun", "--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1", "-np", str(ranks), "pvbatch", "--symmetric"]
    found = []
    for _ in range(REPETITIONS):
        output = subprocess.run([*command, __file__, "--run", name, *arguments], check=True, capture_output=True, text=True,
                                env=environment).stdout
        line = next(line for line in output.splitlines() if line.startswith("measured "))
        found.append([float(word) for word in line.split()[1:]])
    return [statistics.median(column) for column in zip(*found)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("ranks", nargs="*", type=int, default=[1, 2, 4])
    parser.add_argument("--facets", type=int, default=20000)
    parser.add_argument("--queries", type=int, default=160000000)
    parser.add_argument("--parts", type=int, default=100)
    parser.add_argument("--facets-at-once", type=int, default=1 << 22, help="of a probe's surface on each rank")
    parser.add_argument("--threads", type=int, default=1, help="of each rank, which mesh a part each")
    parser.add_argument("--run", choices=("probe", "assembly"))
    sizes = parser.parse_args()
    if sizes.run:
        work(sizes)
        return
    arguments = [f"--{name.replace('_', '-')}={getattr(sizes, name)}" for name in ("facets", "queries", "parts", "facets_at_once")]
    for name in ("probe", "assembly"):
        all_found = {}
        for ranks in sizes.ranks:
            seconds, busy, memory, others = all_found[ranks] = run(name, ranks, arguments)
            print(f"ranks/{name:10} {ranks:3} ranks {seconds:8.3f} s   busiest rank {busy:8.3f} s of processor   {memory:8.1f} MiB more, of others {others:8.1f}")
        if 1 in all_found and 2 in all_found:
            print(f"ratio ranks/{name} {all_found[1][0] / all_found[2][0]:.2f} at least {LIMIT:g}", flush=True)
    one, two = (run("assembly", 1, [*arguments, f"--threads={threads}"]) for threads in (1, 2))
    print(f"ranks/threads: parts on one rank {one[0]:.3f} s by a thread, {two[0]:.3f} s by two: {one[0] / two[0]:.2f} times as fast")


if __name__ == "__main__":
    main()

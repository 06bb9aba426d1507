# SPDX-License-Identifier: GPL-3.0-or-later
"""What parts in hulls of their own (PartsApart) gain: copies of a surface, in one polydata, with and without.

    measure-parts.py SURFACE...

Takes 64 copies of each surface (--copies), side by side, and the whole filter, by turns, medians of five: off and on by one thread,
in seconds of the processor; on by one thread and by two, by the clock. Holds the volumes against each other.
"""

import argparse
import ctypes
import os
import statistics
import time

import insideout
from insideout.pipeline import statistics_of

REPETITIONS = 5
LIMIT = 1.0  # how much longer it takes at most, on one thread, to tetrahedralize apart


def side_by_side(surface, copies):
    from vtkmodules.vtkCommonTransforms import vtkTransform
    from vtkmodules.vtkFiltersCore import vtkAppendPolyData
    from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

    low_x, high_x, low_y, high_y, low_z, high_z = surface.GetBounds()
    steps = [1.25 * (high - low) for low, high in ((low_x, high_x), (low_y, high_y), (low_z, high_z))]
    side = 1
    while side**3 < copies:
        side += 1
    together = vtkAppendPolyData()
    together.SetOutputPointsPrecision(1)
    for copy in range(copies):
        transform = vtkTransform()
        transform.Translate(*(step * (copy // side**axis % side) for axis, step in enumerate(steps)))
        moved = vtkTransformPolyDataFilter()
        moved.SetInputData(surface)
        moved.SetTransform(transform)
        moved.SetOutputPointsPrecision(1)
        moved.Update()
        together.AddInputData(moved.GetOutput())
    together.Update()
    return together.GetOutput()


def run(surface, apart, threads):
    """Seconds by the clock and of the processor, and what the filter says."""
    ctypes.CDLL("libgomp.so.1").omp_set_num_threads(threads)
    filter_ = insideout.vtkRobustTetrahedralize()
    filter_.SetInputData(surface)
    filter_.SetPartsApart(apart)
    began, busy = time.perf_counter(), time.process_time()
    filter_.Update()
    found = time.perf_counter() - began, time.process_time() - busy
    figures = statistics_of(filter_.GetOutput())
    value = {name: figures[name] for name in ("Volume", "HullCells", "SecondsCDT", "SurfaceSteinerPoints")}
    value["PartsApart"] = figures["PartsApart"] if apart else 1
    return found, value


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surfaces", nargs="+")
    parser.add_argument("--copies", type=int, default=64)
    sizes = parser.parse_args()
    ways = {"off": (False, 1), "on": (True, 1), "on by two": (True, 2)}
    for path in sizes.surfaces:
        name = os.path.splitext(os.path.basename(path))[0]
        surface = side_by_side(insideout.surfaces.as_surface(path)[0], sizes.copies)
        found = {way: [] for way in ways}
        for _ in range(1 + REPETITIONS):  # the first warms up
            for way, (apart, threads) in ways.items():
                found[way].append(run(surface, apart, threads))
        clock, busy, cdt = ({way: statistics.median(column(one) for one in found[way][1:]) for way in ways}
                            for column in (lambda one: one[0][0], lambda one: one[0][1], lambda one: one[1]["SecondsCDT"]))
        for way in ways:
            said = found[way][-1][1]
            print(f"parts/{name:12} {way:9} {clock[way]:8.3f} s, processor {busy[way]:8.3f} s, CDT {cdt[way]:8.3f} s   {said['PartsApart']:.0f} parts"
                  f" {said['HullCells']:.0f} cells   volume {said['Volume']:.12g}   {said['SurfaceSteinerPoints']:.0f} points added on facets")
        print(f"ratio parts/{name} {busy['on'] / busy['off']:.2f} at most {LIMIT:g}", flush=True)
        print(f"parts/{name}: by two threads {clock['on'] / clock['on by two']:.2f} times as fast as by one,"
              f" of CDT alone {cdt['on'] / cdt['on by two']:.2f} times", flush=True)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hash what every public class makes of many surfaces, with each of its options, to compare two states of the code.

    (. build-test/env.sh; python3 Testing/OtherBuilds/hash-classes.py --output before.txt)
    ... change the code and build ...
    (. build-test/env.sh; python3 Testing/OtherBuilds/hash-classes.py --output after.txt)
    (. build-test/env.sh; python3 Testing/OtherBuilds/hash-classes.py --compare before.txt after.txt)

The listing has a line for each array of each output, sorted:

    surface | class | option=value | port and block | array | its values or their hash

Points, cells, arrays, their order and the active attributes are such lines, and so are errors, warnings and the files that
writers make. Seconds and memory are left out. Each surface is a process of its own; one that crashes or takes too long is a
line. --only REGEX chooses surfaces, --class REGEX classes; further surface files may be given. The surfaces are in
hashed_surfaces.py.

A new class or option is a row in the tables below. An option that a class does not have is the line "no such option". Lines of
the surfaces in a plane have the name of the class on the left of IN_A_PLANE, whichever class on the right works.
"""

from __future__ import annotations

import argparse
import os
import re
import signal
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

import insideout
from hashed_data import lines_of
from hashed_surfaces import Surface, add_array, all_surfaces, inputs_of, leaves_of
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow

FILTERS = Path(__file__).resolve().parents[2] / "Filters"
sys.path.insert(0, str(FILTERS / "CMake"))
from declared_options import options_of

Settings = dict[str, object]


class Length(NamedTuple):
    """A multiple of the surface's size, to a power."""

    factor: float
    power: int = 1

    def __str__(self) -> str:
        return f"{self.factor}L{self.power}"


class Table(NamedTuple):
    always: Settings  # what is set in each run; "@name" is an input of inputs_of() or UPSTREAM
    rows: list[tuple[str, list[object], Settings]]  # option, values, what else is set


# Where inputs of later stages come from: class and port, for each group of surfaces.
UPSTREAM = {
    "resolved": {"space": ("vtkResolveSelfIntersections", 0), "plane": ("vtkRobustTetrahedralize", 4)},
    "hull": {"space": ("vtkGeneralizedWindingNumber", 0), "plane": ("vtkRobustTetrahedralize", 3)},
    "solid": {"space": ("vtkRobustTetrahedralize", 0), "plane": ("vtkRobustTetrahedralize", 0)},
    "boundary": {"space": ("vtkRobustTetrahedralize", 1), "plane": ("vtkRobustTetrahedralize", 1)},
}
# Which class takes another's place where the surface lies in a plane.
IN_A_PLANE = {"vtkRobustTetrahedralize": "vtkRobustTriangulate"}
# Where options of a stage may be, if the class itself does not have them.
STAGES = ("GetWindingNumber", "GetSegmentation", "GetRefinement")
# The port of the hull, and behind it whatever else takes GenerateHull.
HULL_PORT = 3

BODIES = {"BodyArrayName": "Part"}
BLOCKS = {"BlocksAreBodies": True}
SHORT_EDGES = {"EdgeLength": Length(0.125)}
REFINE = {"Refine": True}
REFINE_SHORT = {**REFINE, **SHORT_EDGES}

ORIENTATION = [("Orientation", [1, 2, 3], {})]
MERGING = [("MergeTolerance", [Length(1 / 128)], {}), ("CountDuplicates", [True], {})]
COUNTING = [*MERGING, ("NonParticipatingArrayName", ["Accessory"], {})]
ENGINE = [("Engine", [1, 2], {}), ("TimeBudget", [3600], {}), ("MemoryBudget", [4000], {"Engine": 2})]
HULL = [*ORIENTATION, *COUNTING, *ENGINE, ("Thicken", [Length(1 / 32)], {}), ("ThickenAll", [True], {"Thicken": Length(1 / 32)}), ("QuadratureOrder", [2, 3, 4, 5], {})]
SEGMENTATION = [
    *[("Gamma", [0, 0.5, 8], {}), ("Sigma", [0.01, 1], {}), ("DataTerm", [1], {}), ("ConstrainFacets", [True], {})],
    *[("NonManifold", [1, 2], {}), ("LargestRegions", [1], {}), ("MinimumRegionVolume", [Length(1 / 64, 3)], {})],
    *[("SeededRegions", [True], {"SeedsData": "@seeds"}), ("FillCavities", [True], {}), ("Topology", [1, 2], {})],
    *[("SeedsData", ["@seeds"], {}), ("Topology", [2], {"SeedsData": "@seeds"})],
]


def refinement(on: Settings) -> list[tuple[str, list[object], Settings]]:
    short = {**on, **SHORT_EDGES}
    return [
        *[("EdgeLength", [Length(0.125)], on), ("Grading", [0.125, 2], on), ("MaximumVolume", [Length(1 / 256, 3)], on)],
        *[("SurfaceTreatment", [1, 2], short), ("SurfaceTolerance", [Length(1 / 64)], {**short, "SurfaceTreatment": 2})],
        *[("FeatureAngle", [60], {**short, "SurfaceTreatment": 2}), ("SizeRules", ["curvature=12; gap=1"], on), ("QuadraticCells", [True], on)],
    ]


TETRAHEDRALIZE = [
    *HULL,
    *SEGMENTATION,
    ("Refine", [True], {}),
    *refinement(REFINE),
    *[("Hull", [True], {}), ("ConstrainedFacetsArrayName", ["Kept"], {"ConstrainFacets": True})],
    *[("SeparateOverlaps", [True], {}), ("MergeCoplanarPieces", [True], {}), ("SplitSeams", [True], {}), ("SurfaceOnly", [True], {})],
    *[("SurfaceOnly", [True], {"MergeCoplanarPieces": True}), ("TagArrayName", ["Part"], {}), ("TagRules", ["up=normal 0 0 1"], {}), ("PartsApart", [True], {}), ("PartsApart", [True], REFINE)],
    *[("BodyArrayName", ["Part"], {}), ("RegionRule", [1], BODIES), ("Priority", ["two,one"], BODIES)],
    *[("Hull", [True], BODIES), ("SeedsData", ["@seeds"], BODIES), ("MergeTolerance", [Length(1 / 128)], BODIES), ("Topology", [2], BODIES)],
    ("TouchTolerance", [0, Length(1 / 128)], BODIES),
    *[("LargestRegions", [1], BODIES), ("TagArrayName", ["Part"], BODIES), ("SurfaceOnly", [True], BODIES), ("ConstrainFacets", [True], BODIES)],
    *[("NonManifold", [1, 2], BODIES), ("Refine", [True], BODIES), ("SurfaceTreatment", [1, 2], {**BODIES, **REFINE_SHORT})],
    *[("BlocksAtOnce", [2], {}), ("BlocksAreBodies", [True], {}), ("RegionRule", [1], BLOCKS)],
    *[("MergeTolerance", [Length(1 / 128)], BLOCKS), ("Refine", [True], BLOCKS), ("SurfaceTreatment", [2], {**BLOCKS, **REFINE_SHORT})],
]
BOOLEAN = [
    *[("Operation", [1, 2, 3], {}), ("Operation", [0, 1, 2, 3], {"Tetrahedra": True}), ("Expression", ["B - A", "(A + B", "#1 ^ #2"], {})],
    *[("AddBodyName", ["first"], {}), ("MergeCoplanarPieces", [True], {}), *ORIENTATION, *MERGING, ("TouchTolerance", [0, Length(1 / 128)], {})],
]
QUERY = [*ORIENTATION, *COUNTING, ("AreaArrayName", ["Weight"], {})]
PROBE = [
    *[("Association", [1], {}), ("Threshold", [0.25], {}), ("InsideOut", [True], {}), ("OutputWindingNumber", [False], {}), ("Distance", [True], {})],
    *[("ClosestPoints", [True], {"Distance": True}), ("Method", [1, 2, 3], {}), ("ApproximationOrder", [1, 3], {"Method": 3})],
    *[("Accuracy", [4], {"Method": 3}), ("FacetsAtOnce", [16], {}), ("SurfacePieces", [2], {}), *QUERY],
]
SIZING = [("SizingArrayName", ["Size"], {}), ("BackgroundData", ["@places"], {"SizingArrayName": "Size"})]
SOLID_FILES = [("FileName", ["x.msh", "x.inp", "x.mesh"], {}), ("MshVersion", [1], {"FileName": "x.msh"}), ("CellsOnly", [True], {"FileName": "x.msh"}), ("BoundaryData", ["@first boundary"], {"FileName": "x.msh"})]
STENCIL = [("Threshold", [0.25], {}), *ORIENTATION, *COUNTING]
SURFACE, SOLID, PLACES = ({"InputDataObject": name} for name in ("@surface", "@solid", "@places"))
SURFACE_FILES = ["x.ply", "x.obj", "x.off", "x.stl"]

LAYERS = [("Layers", [1], {}), ("FirstHeight", [Length(1 / 64)], {}), ("Growth", [2.0], {}), ("LayerTags", ["surface"], {"BoundaryData": "@first boundary"}), ("BoundaryData", ["@first boundary"], {})]

CLASSES = {
    "vtkBoundaryLayers": Table({**SOLID, "FirstHeight": Length(1 / 256)}, LAYERS),
    "vtkConstrainedDelaunay3D": Table({"InputDataObject": "@resolved"}, [*COUNTING, *ENGINE, ("CountDuplicates", [True], {"InputDataObject": "@surface"})]),
    "vtkDistributeParts": Table(SURFACE, []),
    "vtkGeneralizedWindingNumber": Table(SURFACE, HULL),
    "vtkGraphCutSegmentation": Table({"InputDataObject": "@hull"}, [*SEGMENTATION, ("ExtractInside", [False], {})]),
    "vtkImplicitWindingNumber": Table({"Input": "@first surface"}, [("SignedDistance", [True], {}), *QUERY]),
    "vtkProbeWindingNumber": Table({**PLACES, "SurfaceData": "@first surface"}, PROBE),
    "vtkRefineTetrahedra": Table(SOLID, [*refinement({}), *SIZING]),
    "vtkResolveSelfIntersections": Table(SURFACE, COUNTING),
    "vtkRobustTetrahedralize": Table(SURFACE, TETRAHEDRALIZE),
    "vtkSolidQuality": Table(SOLID, []),
    "vtkSolidWriter": Table(SOLID, SOLID_FILES),
    "vtkSolidReader": Table({}, [("FileName", ["x.msh", "x.inp", "x.mesh"], {})]),  # what the writer has written
    "vtkSurfaceDefects": Table(SURFACE, [*ORIENTATION, ("MergeTolerance", [Length(1 / 128)], {})]),
    "vtkSurfaceWriter": Table(SURFACE, [("FileName", SURFACE_FILES, {})]),
    "vtkSurfaceReader": Table({}, [("FileName", ["@file", *SURFACE_FILES], {})]),  # what the writer has written, too
    "vtkVoxelFractions": Table({**PLACES, "SolidData": "@first solid"}, []),
    "vtkWindingBoolean": Table({**SURFACE, "AddInputData": "@other"}, BOOLEAN),
    "vtkWindingNumberToImageStencil": Table({"InputData": "@first surface", "InformationInput": "@places"}, STENCIL),
}


def without_rows() -> Iterator[str]:
    """The classes, and the options that their headers declare, that the tables miss."""
    for name in sorted({name for name in insideout.__all__ if name.startswith("vtk")} - set(IN_A_PLANE.values())):
        if name not in CLASSES:
            yield name
            continue
        always, rows = CLASSES[name]
        named = {*always, *(option for row in rows for option in (row[0], *row[2]))}
        for option in options_of(FILTERS / f"{name}.h"):
            if option not in named and (option, "Hull" in named) != ("GenerateHull", True):
                yield f"{name}, {option}"


def runs_of(table: Table, has_blocks: bool) -> Iterator[tuple[str, str, Settings]]:
    """Label, option and settings of each run."""
    yield "default", "", table.always
    for option, values, others in table.rows:
        if has_blocks or not ("Blocks" in option or "BlocksAreBodies" in others):
            for value in values:
                label = ",".join(f"{name}={setting}" for name, setting in {option: value, **others}.items())
                yield label, option, {**table.always, **others, option: value}


class Runner:
    """Runs classes on one surface."""

    def __init__(self, surface: Surface):
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())
        self.group = surface.group
        self.inputs = inputs_of(surface)

    def lines(self, classes: str) -> Iterator[tuple[str, ...]]:
        has_blocks = len(leaves_of(self.inputs["surface"])) > 1
        for kind, table in CLASSES.items():
            if re.search(classes, kind):
                for label, option, settings in runs_of(table, has_blocks):
                    for line in self.lines_of_run(kind, option, settings):
                        yield kind, label, *line

    def lines_of_run(self, kind: str, option: str, settings: Settings) -> list[tuple[str, str, str]]:
        """Port and block, array and text."""
        lines, window = [], vtkStringOutputWindow()
        try:
            settings = {name: self.value(setting) for name, setting in settings.items()}
            if any(value is None for value in settings.values()):
                return [("", "run", "no input")]
            vtkOutputWindow.SetInstance(window)  # what inputs say is not of this run
            made = self.make(kind)
            if not all([set_option(made, name, value) for name, value in settings.items()]):
                return [("", "run", "no such option")]
            for port, output in outputs_of(made, option, self.inputs["places"]):
                for block, leaf in leaves_of(output).items():
                    lines += [(port + block, array, text) for array, text in lines_of(leaf)]
        except Exception as error:
            lines.append(("", "run", repr(error)))
        messages = plain(window.GetOutput())
        return lines + [("", "messages", " / ".join(messages))] * bool(messages)

    def make(self, kind: str):
        return getattr(insideout, IN_A_PLANE.get(kind, kind) if self.group == "plane" else kind)()

    def value(self, setting: object) -> object:
        """What a setting in the tables stands for; None for an input that there is not."""
        if isinstance(setting, Length):
            return setting.factor * self.inputs["size"] ** setting.power
        if not isinstance(setting, str) or not setting.startswith("@"):
            return setting
        name = setting[1:]
        if name.startswith("first "):
            return next(iter(leaves_of(self.value("@" + name[6:])).values()), None)
        if name in UPSTREAM and name not in self.inputs:
            kind, port = UPSTREAM[name][self.group]
            made = self.make(kind)
            for option, given in CLASSES[kind].always.items():
                set_option(made, option, self.value(given))
            if port >= HULL_PORT:
                made.GenerateHullOn()
            made.Update()
            self.inputs[name] = made.GetOutputDataObject(port)
        return self.inputs.get(name)


def set_option(made, name: str, value: object) -> bool:
    """Set an option of a class, or of one of its stages. False where there is none."""
    if name == "Hull":
        return set_option(made, "GenerateHull", True)
    for owner in (made, *(getattr(made, stage)() for stage in STAGES if hasattr(made, stage))):
        for setter in ("Set" + name, name):
            if hasattr(owner, setter):
                getattr(owner, setter)(value)
                return True
    return False


def outputs_of(made, option: str, places) -> Iterator[tuple[str, object]]:
    """What an object makes of its input, by port: data, or a file's bytes."""
    if made.IsA("vtkImplicitFunction"):
        yield "0", at_places(places, value=made.EvaluateFunction, gradient=made.FunctionGradient)
    elif made.IsA("vtkWriter"):
        made.Write()
        if made.GetFileName() and os.path.exists(made.GetFileName()):
            with open(made.GetFileName(), "rb") as file:
                yield "0", file.read()
    else:
        made.Update()
        hull = HULL_PORT if option == "Hull" else None
        for port in range(made.GetNumberOfOutputPorts()):
            yield "hull" if port == hull else str(port), made.GetOutputDataObject(port)


def at_places(places, **functions):
    """The places with functions of them as point arrays."""
    found = places.NewInstance()
    found.CopyStructure(places)
    points = [places.GetPoint(k) for k in range(places.GetNumberOfPoints())]
    for name, function in functions.items():
        add_array(found.GetPointData(), name, [function(point) for point in points])
    return found


def plain(output: str) -> list[str]:
    """Errors and warnings, the first line of each, without files, addresses and the names of classes."""
    found = re.findall(r"^(ERROR|Warning|Generic Warning): In .*, line \d+\n(.*)$", output, re.MULTILINE)
    told = ((kind, text) for kind, text in found if "returned failure for request" not in text)
    return [f"{kind}: " + re.sub(r"\w+ \(0x[0-9a-f]+\):? ?", "", text) for kind, text in told]


def lines_of_surface(name: str, arguments: argparse.Namespace) -> list[str]:
    """By a process of its own."""
    command = [sys.executable, os.path.abspath(__file__), "--child", name, "--class", arguments.classes, *arguments.paths]
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen(command, stdout=output, cwd=folder, start_new_session=True)
        try:
            end = f"exit status {process.wait(arguments.timeout)}"
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            end = "timeout"
        output.seek(0)
        lines = output.read().split("\n")[:-1]
    print(f"{name}: {len(lines)} lines, {end}", file=sys.stderr)
    last = " ".join(lines[-1].split(" | ")[1:3]) if lines else "nothing"
    return lines if end == "exit status 0" else [*lines, f"{name} |  |  |  | end | {end} after {last}"]


def print_lines(surface: str, runner: Runner, classes: str) -> None:
    for line in runner.lines(classes):
        print(" | ".join(part.replace("|", "!").replace("\n", "\\n") for part in (surface, *line)), flush=True)


def compare(old_path: str, new_path: str) -> int:
    """Print what differs, counted by class, port and array, and by class and option. 1 where anything does."""
    with open(old_path, encoding="utf-8") as old_file, open(new_path, encoding="utf-8") as new_file:
        old_lines, new_lines = set(old_file), set(new_file)
    old, new = (dict(line.rstrip("\n").rsplit(" | ", 1) for line in lines) for lines in (old_lines - new_lines, new_lines - old_lines))
    by_array, by_option = defaultdict(list), defaultdict(list)
    for key in sorted(old.keys() | new.keys()):
        _, kind, label, port, array = key.split(" | ")
        change = "gone" if key not in new else "new" if key not in old else "changed"
        by_array[change, kind, port.split("/")[0], array].append(key)
        by_option[change, kind, label].append(key)
    for title, groups in (("class, port and array", by_array), ("class and option", by_option)):
        print(f"\nBy {title}:")
        for group, keys in sorted(groups.items()):
            surfaces, labels = ({key.split(" | ")[part] for key in keys} for part in (0, 2))
            print(f"{len(keys):7} {' | '.join(group)}: {len(surfaces)} surfaces, {len(labels)} options, as")
            print(f"{'':8}{keys[0]}: {old.get(keys[0], 'none'):.100} -> {new.get(keys[0], 'none'):.100}")
    print(f"\n{len(old_lines)} lines before, {len(new_lines)} after, {len(old.keys() | new.keys())} differ")
    return int(old_lines != new_lines)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="*", metavar="SURFACE", help="surface files besides those of the repository")
    parser.add_argument("--compare", nargs=2, metavar=("OLD", "NEW"), help="compare two listings instead")
    parser.add_argument("--output", default="/dev/stdout", help="the listing (default: standard output)")
    parser.add_argument("--only", default="", help="surfaces whose names match this regular expression")
    parser.add_argument("--class", dest="classes", default="", help="classes whose names match this regular expression")
    parser.add_argument("--jobs", type=int, default=2, help="processes at a time")
    parser.add_argument("--timeout", type=float, default=3600, help="seconds for one surface")
    parser.add_argument("--child", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.compare:
        return compare(*arguments.compare)
    arguments.paths = [os.path.abspath(path) for path in arguments.paths]
    surfaces = all_surfaces(arguments.paths)
    if arguments.child:
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        print_lines(arguments.child, Runner(surfaces[arguments.child]), arguments.classes)
        return 0
    for missed in without_rows():
        print(f"not run, for its table has no row: {missed}", file=sys.stderr)
    os.environ.setdefault("OMP_WAIT_POLICY", "passive")
    names = [name for name in surfaces if re.search(arguments.only, name)]
    with ThreadPoolExecutor(arguments.jobs) as executor:
        listings = list(executor.map(lambda name: lines_of_surface(name, arguments), names))
    with open(arguments.output, "w", encoding="utf-8") as file:
        file.writelines(line + "\n" for line in sorted(sum(listings, [])))
    return 0


if __name__ == "__main__":
    sys.exit(main())

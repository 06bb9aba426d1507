# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a wheel of the Python package, as pip's build backend (PEP 517), for the VTK that CMake finds, without TetGen.

The wheel's version ends in that VTK's, as in 0.1.0+vtk9.1: another VTK needs another wheel.

CMake gets the options in the environment variable CMAKE_ARGS, too. The option `build-dir` of pip's `--config-settings`
is the folder to build in, relative to the root of the tree; by default build-wheel. Files that are up to date there
stay, and so do the options of a configured folder.
"""

import os
import re
import shlex
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
from importlib.util import find_spec
from pathlib import Path

from wheel.wheelfile import WheelFile

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def cmake(*arguments):
    subprocess.run(["cmake", *map(str, arguments)], check=True)


def build(folder):
    if not (folder / "build.ninja").exists():
        cmake("-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", f"-DPython3_EXECUTABLE={sys.executable}",
              "-DINSIDEOUT_USE_PARAVIEW=OFF", "-DINSIDEOUT_USE_TETGEN=OFF", *shlex.split(os.environ.get("CMAKE_ARGS", "")))
    cmake("--build", folder, "--target", "InsideOutPythonFiles")


def install(folder, prefix):
    """Returns the package's files: its library, which is found beside the wrapped classes, comes last."""
    for component in ("python", "runtime"):
        cmake("--install", folder, "--prefix", prefix, "--component", component, "--strip")
    files = [file for file in prefix.rglob("*") if file.is_file() and not file.is_symlink()]
    return sorted(files, key=lambda file: (file.name.startswith("lib"), file))


def version_file(files):
    return next(file for file in files if file.name == "version.py")


def version_in(files):
    made = {}
    exec(version_file(files).read_text(encoding="utf-8"), made)
    name, version = made["BUILT_WITH"].lower().split()
    return f"{made['__version__']}+{name}{'.'.join(version.split('.')[:2])}"


def headers(lines):
    return "".join(f"{name}: {value}\n" for name, value in lines)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Puts the wheel into a folder and returns its name."""
    project = tomllib.loads((HERE / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    folder = ROOT / (config_settings or {}).get("build-dir", "build-wheel")
    build(folder)
    with tempfile.TemporaryDirectory() as prefix:
        files = install(folder, Path(prefix))
        package = version_file(files).parent
        named = f"{project['name']}-{version_in(files)}"
        python = f"cp{sys.version_info.major}{sys.version_info.minor}"
        tag = f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
        metadata = [("Metadata-Version", "2.1"), ("Name", project["name"]), ("Version", version_in(files)),
                    ("Summary", project["description"]), ("License", project["license"]["text"]),
                    ("Requires-Python", project["requires-python"])]
        metadata += [("Requires-Dist", name) for name in project["dependencies"]]
        groups = {"console_scripts": project["scripts"], **project["entry-points"]}
        sections = [f"[{group}]\n" + "".join(f"{name} = {value}\n" for name, value in entries.items()) for group, entries in groups.items()]
        with WheelFile(Path(wheel_directory, f"{named}-{tag}.whl"), "w") as wheel:
            for file in files:
                place = file.relative_to(package) if file.is_relative_to(package) else file.name
                wheel.write(file, f"{project['name']}/{place}")
            wheel.write(ROOT / "LICENSE", f"{named}.dist-info/LICENSE")
            wheel.writestr(f"{named}.dist-info/METADATA", headers(metadata))
            wheel.writestr(f"{named}.dist-info/WHEEL",
                           headers([("Wheel-Version", "1.0"), ("Generator", __name__), ("Root-Is-Purelib", "false"), ("Tag", tag)]))
            wheel.writestr(f"{named}.dist-info/entry_points.txt", "\n".join(sections))
    return f"{named}-{tag}.whl"


def dynamic_metadata(settings, project):
    """The version, for scikit-build-core: it asks before CMake finds a VTK, so it is that of Python's."""
    from vtkmodules.vtkCommonCore import vtkVersion

    vtk = vtkVersion()
    version = re.search(r"project\(InsideOut VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    return {"version": f"{version}+vtk{vtk.GetVTKMajorVersion()}.{vtk.GetVTKMinorVersion()}"}


if find_spec("scikit_build_core"):
    from scikit_build_core.build import build_wheel, get_requires_for_build_wheel  # noqa: F401, F811

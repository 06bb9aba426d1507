# SPDX-License-Identifier: GPL-3.0-or-later
"""Both backends make the same wheel of a small tree: our own, and scikit-build-core where it is installed.

    python3 TestWheel.py

The tree itself is made into a wheel by OtherBuilds/wheel.sh.
"""

import shutil
import subprocess
import sys
import tempfile
import unittest
from email import message_from_string
from importlib.util import find_spec
from pathlib import Path
from zipfile import ZipFile

from vtkmodules.vtkCommonCore import vtkVersion

ROOT = Path(__file__).resolve().parent.parent
VTK = f"{vtkVersion().GetVTKMajorVersion()}.{vtkVersion().GetVTKMinorVersion()}"
LISTS = f"""
cmake_minimum_required(VERSION 3.18)
project(InsideOut VERSION 1.2.3 LANGUAGES C)
include(GNUInstallDirs)
set(INSIDEOUT_PYTHON_DESTINATION lib/python3/site-packages CACHE STRING "")
set(package ${{INSIDEOUT_PYTHON_DESTINATION}}/insideout)
file(WRITE ${{CMAKE_BINARY_DIR}}/inner.c "int inner(void) {{ return 1; }}")
file(WRITE ${{CMAKE_BINARY_DIR}}/outer.c "int inner(void); int outer(void) {{ return inner(); }}")
file(WRITE ${{CMAKE_BINARY_DIR}}/version.py "__version__ = '1.2.3'\\nBUILT_WITH = 'VTK {VTK}.4'\\n")
file(WRITE ${{CMAKE_BINARY_DIR}}/used.txt "${{INSIDEOUT_USE_PARAVIEW}} ${{INSIDEOUT_USE_TETGEN}}")
add_library(vtkFiltersInsideOut SHARED ${{CMAKE_BINARY_DIR}}/inner.c)
set_target_properties(vtkFiltersInsideOut PROPERTIES VERSION 1.2.3 SOVERSION 1.2.3)
add_library(outer MODULE ${{CMAKE_BINARY_DIR}}/outer.c)
target_link_libraries(outer PRIVATE vtkFiltersInsideOut)
set_target_properties(outer PROPERTIES PREFIX "" OUTPUT_NAME vtkFiltersInsideOut)
add_custom_target(InsideOutPythonFiles)
add_dependencies(InsideOutPythonFiles outer)
install(FILES ${{CMAKE_BINARY_DIR}}/version.py ${{CMAKE_BINARY_DIR}}/used.txt DESTINATION ${{package}} COMPONENT python)
install(TARGETS outer DESTINATION ${{package}} COMPONENT python)
install(TARGETS vtkFiltersInsideOut LIBRARY DESTINATION ${{CMAKE_INSTALL_LIBDIR}} COMPONENT runtime)
install(FILES CMakeLists.txt DESTINATION share COMPONENT other)
"""
HIDE = "import sys; sys.modules['scikit_build_core'] = None; "
BUILD = "import wheel_by_cmake; wheel_by_cmake.build_wheel(r'{}')"


@unittest.skipUnless(find_spec("wheel"), "python3-wheel is not installed")
class Wheels(unittest.TestCase):
    def wheel(self, before: str) -> tuple[str, dict[str, str]]:
        """The wheel's name, and the texts of its files by name."""
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        python = folder / "Filters" / "Python"
        python.mkdir(parents=True)
        (folder / "CMakeLists.txt").write_text(LISTS, encoding="utf-8")
        shutil.copy(ROOT / "LICENSE", folder)
        for name in ("pyproject.toml", "wheel_by_cmake.py"):
            shutil.copy(ROOT / "Filters" / "Python" / name, python)
        command = [sys.executable, "-c", before + BUILD.format(folder)]
        done = subprocess.run(command, cwd=python, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        (wheel,) = folder.glob("*.whl")
        with ZipFile(wheel) as files:
            return wheel.name, {name: files.read(name).decode(errors="replace") for name in files.namelist()}

    def check(self, name: str, files: dict[str, str]) -> None:
        info = f"insideout-1.2.3+vtk{VTK}.dist-info"
        python = f"cp{sys.version_info.major}{sys.version_info.minor}"
        self.assertRegex(name, rf"^insideout-1\.2\.3\+vtk{VTK}-{python}-{python}-\w+\.whl$")
        inside = {"version.py", "used.txt", "vtkFiltersInsideOut.so", "libvtkFiltersInsideOut.so.1.2.3"}
        about = {"LICENSE", "METADATA", "WHEEL", "entry_points.txt", "RECORD"}
        self.assertEqual(set(files), {f"insideout/{name}" for name in inside} | {f"{info}/{name}" for name in about})
        self.assertEqual(files["insideout/used.txt"], "OFF OFF")
        metadata = message_from_string(files[f"{info}/METADATA"])
        self.assertEqual((metadata["Name"], metadata["Version"]), ("insideout", f"1.2.3+vtk{VTK}"))
        self.assertEqual(metadata["Requires-Dist"], "numpy")
        self.assertIn("[pyvista.accessors]", files[f"{info}/entry_points.txt"])

    def test_ours(self):
        self.check(*self.wheel(HIDE))

    @unittest.skipUnless(find_spec("scikit_build_core"), "scikit-build-core is not installed")
    def test_scikit_build_core_s(self):
        self.check(*self.wheel(""))


if __name__ == "__main__":
    unittest.main()

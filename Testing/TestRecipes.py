# SPDX-License-Identifier: GPL-3.0-or-later
"""The recipes of packages are whole: their syntax, their version, and options and files of the tree that they name. None is run.

    python3 TestRecipes.py
"""

import ast
import re
import subprocess
import unittest
from fnmatch import fnmatch
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "Filters" / "CMake" / "packaging"


def text_of(name):
    return (FOLDER / name).read_text(encoding="utf-8")


class Recipes(unittest.TestCase):
    def test_conda_s_is_yaml_with_what_it_needs_and_the_version_of_the_project(self):
        recipe = yaml.safe_load(text_of("recipe.yaml"))
        self.assertLessEqual({"context", "package", "source", "build", "requirements", "tests", "about"}, set(recipe))
        version = re.search(r"VERSION\s+([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8").split("project", 1)[1])[1]
        self.assertEqual(recipe["context"]["version"], version)
        self.assertTrue((FOLDER / recipe["source"]["path"] / "CMakeLists.txt").exists())
        self.assertTrue((ROOT / recipe["about"]["license_file"]).exists())

    def test_spack_s_is_python_with_a_package(self):
        (recipe,) = (node for node in ast.parse(text_of("package.py")).body if isinstance(node, ast.ClassDef))
        self.assertEqual((recipe.name, recipe.bases[0].id), ("Insideout", "CMakePackage"))

    def test_shells_understand_the_others(self):
        dockerfile = re.sub(r"\\\n", " ", text_of("Dockerfile"))
        lines = [line for line in dockerfile.splitlines() if line and not line.startswith("#")]
        self.assertLessEqual({line.split()[0] for line in lines}, {"FROM", "RUN", "COPY", "WORKDIR", "ENTRYPOINT"})
        scripts = [line.removeprefix("RUN ") for line in lines if line.startswith("RUN ")]
        sections = re.split(r"(?m)^%(\w+)\n", text_of("insideout.def"))
        parts = dict(zip(sections[1::2], sections[2::2]))
        self.assertEqual(list(parts), ["files", "post", "runscript", "test"])
        scripts += [parts[name] for name in ("post", "runscript", "test")]
        self.assertEqual(len(scripts), 6)
        for script in scripts:
            done = subprocess.run(["sh", "-n"], input=script, text=True, capture_output=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_options_and_files_are_those_of_the_tree(self):
        cmake = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "CMakeLists.txt", ROOT / "Filters" / "Tetgen" / "CMakeLists.txt"))
        for name in ("Dockerfile", "insideout.def", "recipe.yaml", "package.py"):
            text = text_of(name)
            self.assertIn("never run here", text)
            for option in re.findall(r"INSIDEOUT_\w+", text):
                self.assertIn(f"option({option} ", cmake, name)
            for file in re.findall(r"/source/(\S+)", text):
                self.assertTrue((ROOT / file).exists(), file)

    def test_the_debian_package_is_named_as_it_is_built(self):
        packages = (FOLDER.parent / "Packages.cmake").read_text(encoding="utf-8")
        _, without_paraview = re.findall(r"set\(CPACK_PACKAGE_NAME (\S+)\)", packages)
        for name in ("Dockerfile", "insideout.def"):
            patterns = re.findall(r"[\w*.-]+\.deb\b", text_of(name))
            self.assertTrue(patterns, name)
            for pattern in patterns:
                self.assertTrue(fnmatch(f"{without_paraview}_0.1.0_amd64.deb", pattern), f"{name}: {pattern}")


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Spack's recipe. It was checked for syntax and never run here.

Put it into packages/insideout of a repository of recipes, then: spack dev-build --source-path TREE insideout@main
Spack would need a package of maxflow (Boykov and Kolmogorov, GPL) first.
"""

from spack.package import *


class Insideout(CMakePackage):
    """Tetrahedra of the solid that a broken triangle surface means."""

    license("GPL-3.0-or-later")

    version("main")

    variant("paraview", default=False, description="Build the plugin of ParaView, against ParaView's VTK")

    extends("python")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("python@3.11:", type=("build", "run"))
    depends_on("py-numpy", type=("build", "run"))
    depends_on("vtk@9.1: +python", when="~paraview")
    depends_on("paraview@5.11: +python", when="+paraview")
    depends_on("cgal@5.5:")
    depends_on("eigen@3.4:")
    depends_on("maxflow")
    depends_on("zlib-api")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define_from_variant("INSIDEOUT_USE_PARAVIEW", "paraview"),
            self.define("INSIDEOUT_USE_TETGEN", False),
            self.define("Python3_EXECUTABLE", self.spec["python"].command.path),
        ]

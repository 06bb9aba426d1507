# SPDX-License-Identifier: GPL-3.0-or-later
"""Optional packages of third parties."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from .errors import Error

OF_DEBIAN = {
    "meshio": "python3-meshio",
    "h5py": "python3-h5py",
    "pandas": "python3-pandas",
    "open3d": "python3-open3d",
    "stl": "python3-stl",
}
OF_PIP = {"stl": "numpy-stl"}
"""Names of packages that differ from the module's name."""


def import_package(name: str, why: str = "") -> Any:
    """Import a module. Raises `Error` with the remedy if it is not installed."""
    try:
        return import_module(name)
    except ImportError:
        debian = f"apt-get install {OF_DEBIAN[name]}, or " if name in OF_DEBIAN else ""
        raise Error(f"{name}{why} is not installed: {debian}pip install {OF_PIP.get(name, name)}") from None

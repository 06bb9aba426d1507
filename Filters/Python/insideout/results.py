# SPDX-License-Identifier: GPL-3.0-or-later
"""What the results of all functions have in common: they can be pickled and copied, and show themselves in a line or a table."""

from __future__ import annotations

import base64
import html
from dataclasses import fields, replace
from typing import Any, Optional, TypeVar

from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

from .data import Tetrahedra, TriangleSurface
from .panels import draw_panels
from .serializing import Plain

Self = TypeVar("Self", bound="Result")
SECONDS_TO_DRAW = 60.0


class Result:
    """The base of a dataclass that has data sets of VTK's among its fields."""

    def figures(self) -> list[tuple[str, str]]:
        """What is worth knowing about it: words, and how much or what of it."""
        raise NotImplementedError

    def seen(self) -> dict[str, Any]:
        """What a picture of it shows, as `draw_panels` takes it."""
        return {}

    def __reduce__(self) -> tuple:
        content = {field.name: getattr(self, field.name) for field in fields(self)}
        return _result, (type(self), {name: _picklable(value) for name, value in content.items()})

    def __copy__(self: Self) -> Self:
        return replace(self)

    def __repr__(self) -> str:
        words = ", ".join(f"{what} {how_much}" for what, how_much in self.figures())
        return f"<{type(self).__name__}: {' '.join(words.split())}>"

    def _repr_html_(self) -> str:
        """What a notebook shows: a table, and a picture where one can be drawn."""
        rows = "".join(
            f"<tr><td>{html.escape(what)}</td><td>{html.escape(how_much)}</td></tr>" for what, how_much in self.figures()
        )
        picture = self._picture()
        image = f'<img alt="" style="max-width: 100%" src="data:image/png;base64,{picture}">' if picture else ""
        return f"<table><caption>{type(self).__name__}</caption>{rows}</table>{image}"

    def _picture(self) -> Optional[str]:
        """In base64; none where it cannot be drawn, whatever the reason: a table will do."""
        try:
            seen = self.seen()
            return base64.b64encode(draw_panels(timeout=SECONDS_TO_DRAW, **seen)).decode("ascii") if seen else None
        except Exception:  # noqa: BLE001
            return None


def counted(count: int) -> str:
    return f"{count:,}"


def _picklable(value: Any) -> Any:
    ours = isinstance(value, (TriangleSurface, Tetrahedra))
    return Plain(value) if isinstance(value, (vtkPolyData, vtkUnstructuredGrid)) and not ours else value


def _result(result_type: type, content: dict[str, Any]) -> Any:
    return result_type(**content)

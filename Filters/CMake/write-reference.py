# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the reference of classes, options and arrays, by the headers of the classes: as Markdown, and as HTML.

    write-reference.py FILTERS REFERENCE.md REFERENCE.html
"""

from __future__ import annotations

import html
import re
import sys
from pathlib import Path
from typing import Iterator, NamedTuple

sys.dont_write_bytecode = True

from declared_options import Declared, options_of

HEAD = """\
In Python and on the command line an option of `tetrahedralize` has its name in their manner: `SurfaceTolerance` is
`surface_tolerance` and `--surface-tolerance`. Names of arrays lose their `Name`, as in `tag_array` and `--tag-array`.
Each class describes its outputs and statistics."""

ARRAY = re.compile(r"(\w+(?:, \w+)*) \(((?:int|short|double|string|\d unsigned|unsigned|signed|vtkIdType|field)\b[^)]*)\): (.*)")
"""An item of a class's comment that describes arrays: `w (double, cells): the winding number`."""

STYLE = "body{max-width:60em;margin:2em auto;padding:0 1em;font-family:sans-serif}td,th{text-align:left;vertical-align:top;padding:.2em .6em}"


class Piece(NamedTuple):
    kind: str  # heading, text, list, code or table
    lines: list[str] | list[list[str]]


def words_of(header: Path) -> tuple[str, list[Piece]]:
    """The @brief of a class, and the paragraphs, lists and formulas of its comment."""
    comment = re.search(r"/\*\*\n \* @class(.*?)\*/", header.read_text(encoding="utf-8"), re.DOTALL)
    if comment is None:
        return "", []
    text = "\n".join(line[3:] for line in comment[1].split("\n")[1:]).split("\n@sa")[0]
    brief, _, text = text.partition("\n\n")
    return " ".join(brief.removeprefix("@brief").split()), [one for block in re.split(r"\n\s*\n", text.strip("\n")) for one in pieces_of(block)]


def pieces_of(block: str) -> Iterator[Piece]:
    if block.startswith("    "):
        yield Piece("code", [line.strip() for line in block.split("\n")])
        return
    first, *items = re.split(r"^- ", block, flags=re.MULTILINE)
    if first.strip():
        yield Piece("text", [" ".join(first.split())])
    if items:
        yield Piece("list", [" ".join(item.split()) for item in items])


def values_of(option: Declared) -> str:
    """What an option can be."""
    if option.constants:
        return ", ".join(f"`{constant}`" for constant in option.constants)
    if option.least or option.most:
        return f"{option.kind}, {option.least or 'any'} to {option.most or 'infinity'}"
    return option.kind


def section(name: str, header: Path) -> list[Piece]:
    brief, pieces = words_of(header)
    rows = [[f"`{option.name}`", values_of(option), option.words] for option in options_of(header).values()]
    if not pieces and not rows:
        return []
    made = [Piece("heading", [name]), *([Piece("text", [f"{brief[:1].upper()}{brief[1:]}."])] if brief else []), *pieces]
    return [*made, Piece("table", [["option", "values", "meaning"], *rows])] if rows else made


def arrays_of(headers: list[Path]) -> Piece:
    """What the classes say of their arrays."""
    rows = []
    for header in headers:
        items = (line for piece in words_of(header)[1] if piece.kind == "list" for line in piece.lines)
        for names, kind, meaning in (found.groups() for found in map(ARRAY.fullmatch, items) if found):
            rows.append([", ".join(f"`{name}`" for name in names.split(", ")), kind, f"[{header.stem}](#{header.stem.lower()})", meaning])
    return Piece("table", [["array", "type, on", "made by", "meaning"], *sorted(rows, key=lambda row: row[0].lower())])


def as_markdown(title: str, pieces: list[Piece]) -> str:
    def row(cells: list[str]) -> str:
        return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"

    def lines(piece: Piece) -> list[str]:
        if piece.kind == "table":
            header, *rows = piece.lines
            return [row(header), "|" + "---|" * len(header), *map(row, rows)]
        before = {"heading": "## ", "list": "- ", "code": "    "}.get(piece.kind, "")
        return [before + line for line in piece.lines]

    return "\n".join([f"# {title}", "", *(line for piece in pieces for line in (*lines(piece), ""))])


def as_html(title: str, pieces: list[Piece]) -> str:
    def inline(text: str) -> str:
        code = re.sub(r"`([^`]+)`", r"<code>\1</code>", html.escape(text, quote=False))
        return re.sub(r"\[(\w+)\]\((#\w+)\)", r'<a href="\2">\1</a>', code)

    def lines(piece: Piece) -> Iterator[str]:
        if piece.kind == "table":
            for k, cells in enumerate(piece.lines):
                cell = "td" if k else "th"
                yield "<tr>" + "".join(f"<{cell}>{inline(text)}</{cell}>" for text in cells) + "</tr>"
        elif piece.kind == "heading":
            yield f'<h2 id="{piece.lines[0].lower()}">{inline(piece.lines[0])}</h2>'
        else:
            yield from (f"<li>{inline(line)}</li>" if piece.kind == "list" else inline(line) for line in piece.lines)

    around = {"table": "table", "list": "ul", "code": "pre", "text": "p"}
    body = ("\n".join(lines(piece)) for piece in pieces)
    wrapped = (f"<{around[piece.kind]}>{text}</{around[piece.kind]}>" if piece.kind in around else text for piece, text in zip(pieces, body))
    head = f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title><style>{STYLE}</style></head><body>\n<h1>{title}</h1>'
    return "\n".join([head, *wrapped, "</body></html>", ""])


if __name__ == "__main__":
    filters, markdown, page = map(Path, sys.argv[1:])
    headers = sorted(filters.glob("vtk*.h"))
    sections = [piece for header in headers for piece in section(header.stem, header)]
    pieces = [Piece("text", [HEAD.replace("\n", " ")]), Piece("heading", ["Arrays"]), arrays_of(headers), *sections]
    title = "Reference of classes, options and arrays"
    markdown.write_text(as_markdown(title, pieces), encoding="utf-8")
    page.write_text(as_html(title, pieces), encoding="utf-8")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Turn the first page and others into a page of ParaView's help.

    make-manual.py README.md|TABLE.csv... PAGE.html

Knows what they use of Markdown: headings, paragraphs, code blocks, tables, lists, images, links,
bold and italic words, and code among words. Pictures and links within the tree become their words.
"""

import csv
import re
import sys
from html import escape
from pathlib import Path

PAGE = """<!DOCTYPE html>
<html><head><meta charset="utf-8"><title>{title}</title><style>
body {{ font-family: sans-serif; max-width: 50em; }} pre {{ background: #eee; padding: 0.5em; }}
table {{ border-collapse: collapse; }} td, th {{ border: 1px solid #aaa; padding: 0.2em 0.5em; text-align: left; vertical-align: top; }}
</style></head><body>
{body}
</body></html>
"""


def inline(text: str) -> str:
    """The marks within a line. Code is not searched for marks."""
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(f"<code>{escape(part[1:-1])}</code>" if part.startswith("`") else words(part) for part in parts)


def words(text: str) -> str:
    text = escape(text, quote=False)
    text = re.sub(r"!\[([^\]]*)\]\([^)]*\)", r"<i>\1</i>", text)
    text = re.sub(r"\[([^\]]*)\]\((https?:[^)]*)\)", r'<a href="\2">\1</a>', text)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", text)
    return re.sub(r"(?<![\w*])\*([^*]+)\*(?![\w*])", r"<i>\1</i>", text)


def table(lines: list[str]) -> str:
    rows = [[inline(cell.strip()) for cell in re.split(r"(?<!\\)\|", line.strip().strip("|"))] for line in lines]
    html = ["<tr>" + "".join(f"<th>{cell}</th>" for cell in rows[0]) + "</tr>"]
    html += ["<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows[2:]]
    return "<table>\n" + "\n".join(html) + "\n</table>"


def block(text: str) -> str:
    """One block: what stands between empty lines."""
    lines = text.split("\n")
    heading = re.match(r"(#+) (.*)", text)
    if text.startswith("```"):
        return "<pre>" + escape("\n".join(lines[1:-1])) + "</pre>"
    if heading:
        level = len(heading.group(1))
        return f"<h{level}>{inline(heading.group(2))}</h{level}>"
    if text.startswith("|"):
        return table(lines)
    if text.startswith("- "):
        items = re.split(r"\n(?=- )", text)
        return "<ul>" + "".join(f"<li>{inline(item[2:])}</li>" for item in items) + "</ul>"
    return f"<p>{inline(text)}</p>"


def text_of(source: Path) -> str:
    """A page, or data as the table of one."""
    if source.suffix != ".csv":
        return source.read_text(encoding="utf-8").strip()
    with source.open(encoding="utf-8", newline="") as file:
        head, *rows = ([cell.replace(" | ", " ... or ") for cell in row] for row in csv.reader(file))
    lines = [head, ["---"] * len(head), *rows]
    return f"## {source.name}\n\n" + "\n".join(f"| {' | '.join(line)} |" for line in lines)


def main(*sources: str, target: str) -> None:
    text = "\n\n".join(text_of(Path(source)) for source in sources)
    blocks = re.findall(r"```.*?\n```|[^\n].*?(?=\n\n|\n```|\Z)", text, re.DOTALL)
    title = re.match(r"# (.*)", text)
    body = "\n".join(block(one.strip("\n")) for one in blocks)
    page = PAGE.format(title=escape(title.group(1)) if title else "", body=body)
    Path(target).parent.mkdir(parents=True, exist_ok=True)
    Path(target).write_text(page, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:-1], target=sys.argv[-1])

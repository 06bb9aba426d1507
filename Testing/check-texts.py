#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules of the texts, in pages and in the comments of headers that document: a sentence puts its subject first, names its
quantity, and is short.

    python3 check-texts.py [ROOT]

Prints a line for what breaks a rule; the exit status is then 1.
"""

import re
import sys
from collections.abc import Iterator
from pathlib import Path

MOST_WORDS = 30  # of a sentence, or of the part of one up to a colon or semicolon
PAGES = ("*.md", "Filters/**/*.md", "Plugin/**/*.md", "Testing/**/*.md", "Examples/**/*.md")

COMMENT = re.compile(r"/\*\*(?P<block>.*?)\*/|///<?(?P<line>[^\n]*)", re.DOTALL)
# What begins a paragraph of its own: an item, a heading, a quotation, a command of Doxygen's.
BEGIN = re.compile(r"(?:[-*#>]+|\d+\.|@\w+(?:\[[\w,]+\])?)(?:\s+|$)")
END = re.compile(r"(?<=[.!?])\s+(?=[A-Z(\d]|vtk|w\b)|(?<=[;:])\s+")

HABITS = (
    (re.compile(r"\(?Of\b"), 'begins with "Of": put the subject first'),
    (re.compile(r"\(?What\b(?=.*\b(?:is|are|was|were)\b)(?!.*\?$)"), 'begins with "What ... is": name the subject'),
    (re.compile(r".*\bso (?:many|often)\b", re.IGNORECASE), 'says "so many" or "so often": name the quantity'),
)


def paragraphs_of(text: str) -> Iterator[tuple[int, str]]:
    """Paragraphs, items and cells of tables, each with its first line; what stands in columns or is code is none."""
    lines: list[str] = []
    first, is_heading = 0, False
    for number, line in enumerate([*text.split("\n"), ""], 1):
        stripped = line.strip()
        begin = BEGIN.match(stripped)
        in_columns = re.search(r"\S {2,}\S", stripped)
        if lines and (not stripped or begin or in_columns or is_heading or stripped.startswith("|")):
            yield first, " ".join(lines)
            lines = []
        is_heading = stripped.startswith("#")
        if stripped.startswith("|"):
            yield from ((number, cell.strip()) for cell in stripped.strip("|").split("|"))
        elif stripped and not in_columns:
            first = first if lines else number
            lines.append(stripped[begin.end() :] if begin else stripped)


def sentences_of(paragraph: str) -> list[str]:
    """A name or command in backquotes is a word, and so is a link's text without its target."""
    words = re.sub(r"`[^`]*`", "CODE", paragraph)
    words = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", words)
    return END.split(words.replace("*", ""))


def texts_of(file: Path) -> Iterator[tuple[int, str]]:
    """The texts of a page or header, each with the line before its first."""
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".md":
        yield 0, re.sub(r"^```.*?^```$", lambda block: "\n" * block[0].count("\n"), text, flags=re.MULTILINE | re.DOTALL)
        return
    for comment in COMMENT.finditer(text):
        words = comment["block"] if comment["block"] is not None else comment["line"]
        yield text.count("\n", 0, comment.start()), re.sub(r"^[ \t]*\*[ \t]?", "", words, flags=re.MULTILINE)


def complaints_about(sentence: str) -> Iterator[str]:
    yield from (complaint for habit, complaint in HABITS if habit.match(sentence))
    count = sum(1 for word in sentence.split() if re.search(r"\w", word))
    if count > MOST_WORDS:
        yield f"has {count} words: at most {MOST_WORDS}"


def check(root: Path) -> list[str]:
    """What breaks a rule, one line each."""
    pages = {page for pattern in PAGES for page in root.glob(pattern)}
    found = []
    for file in sorted([*pages, *root.glob("Filters/**/*.h")]):
        for before, text in texts_of(file):
            for line, paragraph in paragraphs_of(text):
                for sentence in sentences_of(paragraph):
                    found += [f"{file.relative_to(root)}:{before + line}: a sentence {complaint}: {sentence[:60]}" for complaint in complaints_about(sentence)]
    return found


if __name__ == "__main__":
    complaints = check(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
    for complaint in complaints:
        print(complaint)
    sys.exit(1 if complaints else 0)

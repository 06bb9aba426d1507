#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules of the texts, in pages, comments and docstrings: a sentence puts its subject first, names its quantity, is short,
and has one word for one thing.

    python3 check-texts.py [ROOT]

Prints a line for what breaks a rule; the exit status is then 1.
"""

import ast
import io
import re
import sys
import tokenize
from collections.abc import Iterator
from pathlib import Path

MOST_WORDS = 30  # of a sentence, or of the part of one up to a colon or semicolon
ROOMS = ("Filters", "Plugin", "Testing", "Examples")
KINDS = ("*.md", "*.h", "*.cxx", "*.py", "*.sh", "*.cmake", "CMakeLists.txt")
NO_TEXTS = ("check-texts.py", "TestTextRules.py")  # they quote what they forbid

# What C++ has besides comments is matched to be passed over, lest `"//"` begin one.
COMMENT = re.compile(
    r"""R"(?P<end>[^(\s]*)\(.*?\)(?P=end)"|(?<!')"(?:\\.|[^"\\\n])*"|/\*+<?(?P<block>.*?)\*/"""
    r"""|(?P<lines>//[^\n]*(?:\n[ \t]*//[^\n]*)*)""",
    re.DOTALL,
)
CODE_OF_DOCSTRING = re.compile(r"::\n\n(?:[ \t]+[^\n]*\n|\n)+")
HASHES = re.compile(r"(?:^[ \t]*#(?!!)[^\n]*\n)+", re.MULTILINE)
# What begins a paragraph of its own: an item, a heading, a quotation, a command of Doxygen's.
BEGIN = re.compile(r"(?:[-*#>]+|\d+\.|@\w+(?:\[[\w,]+\])?)(?:\s+|$)")
END = re.compile(r"(?<=[.!?])\s+(?=[A-Z(\d]|vtk|w\b)|(?<=[;:])\s+")

HABITS = (
    (re.compile(r"\(?Of\b"), 'begins with "Of": put the subject first'),
    (re.compile(r"\(?What\b(?=.*\b(?:is|are|was|were)\b)(?!.*\?$)"), 'begins with "What ... is": name the subject'),
    (re.compile(r".*\bso (?:many|often)\b", re.IGNORECASE), 'says "so many" or "so often": name the quantity'),
    (re.compile(r".*\b(?:parted by|amid)\b", re.IGNORECASE), 'says "parted by" or "amid": say "separated by" or "mid-edge"'),
    (re.compile(r".*\b(?:neighbour|centre|colour|behaviour|licence)", re.IGNORECASE), "is not in American spelling"),
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
    """The texts of a page or source, each with the line before its first."""
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".md":
        yield 0, re.sub(r"^```.*?^```$", lambda block: "\n" * block[0].count("\n"), text, flags=re.MULTILINE | re.DOTALL)
    elif file.suffix == ".py":
        yield from texts_of_python(text)
    elif file.suffix in (".h", ".cxx"):
        for comment in COMMENT.finditer(text):
            words = re.sub(r"^[ \t]*(?:\*|///?<?)[ \t]?", "", comment["block"] or comment["lines"] or "", flags=re.MULTILINE)
            yield text.count("\n", 0, comment.start()), words
    else:
        for comment in HASHES.finditer(text):
            yield text.count("\n", 0, comment.start()), re.sub(r"^[ \t]*#[ \t]?", "", comment[0], flags=re.MULTILINE)


def texts_of_python(text: str) -> Iterator[tuple[int, str]]:
    """Comments, joined from consecutive lines, and docstrings of modules, classes, functions and attributes."""
    block: list[str] = []
    first = 0
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in (tokenize.COMMENT, tokenize.NL, tokenize.INDENT, tokenize.DEDENT) and block:
            yield first, "\n".join(block)
            block = []
        if token.type == tokenize.COMMENT:
            first = first if block else token.start[0] - 1
            block += [""] * (token.start[0] - 1 - first - len(block)) + [token.string.lstrip("#").strip()]
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            yield node.lineno - 1, CODE_OF_DOCSTRING.sub(lambda code: ":" + "\n" * code[0].count("\n"), node.value.value)


def complaints_about(sentence: str) -> Iterator[str]:
    yield from (complaint for habit, complaint in HABITS if habit.match(sentence))
    count = sum(1 for word in sentence.split() if re.search(r"\w", word))
    if count > MOST_WORDS:
        yield f"has {count} words: at most {MOST_WORDS}"


def check(root: Path) -> list[str]:
    """What breaks a rule, one line each."""
    patterns = [pattern for kind in KINDS for pattern in (kind, *(f"{room}/**/{kind}" for room in ROOMS))]
    files = {file for pattern in patterns for file in root.glob(pattern)}
    found = []
    for file in sorted(files):
        if file.name in NO_TEXTS:
            continue
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

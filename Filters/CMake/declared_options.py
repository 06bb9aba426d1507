# SPDX-License-Identifier: GPL-3.0-or-later
"""What the headers of the classes say of their options: kind, range, constants, default and words, each from its declaration.

An option is what VTK's macros give a setter (vtkSetMacro and its kin; vtkInsideOutSetRangeMacro), or what has a getter by such
a macro. Its words are the comment before it. They hold its default, "Default 30." or "Default 0: none.", and before that what
every user has to know; behind it may stand "Range 0 to 180.", and then details. The macros of SHARED headers stand for the
options that they declare. A setter and getter that are declared by hand forward an option of a stage: the stage's header tells it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

COMMENT = r"/\*\*(?P<words>(?:(?!\*/).)*)\*/"
SETTER = re.compile(
    r"(?:vtkSet|vtkInsideOutSetRange)Macro\((?P<name>\w+),\s*(?P<type>[\w:]+)(?:,\s*(?P<least>[^,()]+),\s*(?P<most>[^,()]+))?\)"
    r"|vtkSetStdStringFromCharMacro\((?P<text>\w+)\)"
    r"|vtkGetMacro\((?P<got>\w+),\s*(?P<gottype>[\w:]+)\)"
)
KINDS = {"bool": "bool", "int": "int", "double": "double", "std::string": "string"}
SHARED = ("vtkInsideOutCounting.h", "vtkInsideOutEngine.h")
NO_LIMIT = ("VTK_DOUBLE_MAX", "VTK_INT_MAX", "VTK_DOUBLE_MIN", "-VTK_DOUBLE_MAX")


@dataclass
class Declared:
    """An option as a class declares it."""

    name: str
    kind: str  # bool, int, double or string
    words: str
    least: str | None = None
    most: str | None = None
    constants: dict[str, int] = field(default_factory=dict)  # of an enumeration, in order

    @property
    def default(self) -> str:
        """As VTK's XML has it: a number, the value of a constant, or a text."""
        found = re.search(r"\bDefault ([^\s:;,]+?)[.:;,]?(?:\s|$)", self.words)
        if not found:
            raise ValueError(f"{self.name}: its comment tells no default")
        value = found[1]
        if value in self.constants:
            return str(self.constants[value])
        return {"on": "1", "off": "0", "empty": ""}.get(value, value.strip("\""))

    @property
    def brief(self) -> str:
        """The words up to the default and the range."""
        found = re.match(r".*?\bDefault .*?\.(?= |$)(?: Range .*?\.(?= |$))?", self.words)
        return found[0] if found else self.words

    def choices(self) -> dict[int, str]:
        """The values of an enumeration with words: ENGINE_EXACT is "exact", AS_GIVEN "as-given"."""
        prefix = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", self.name).upper() + "_", self.name.upper() + "_"
        return {value: constant.removeprefix(prefix[1]).removeprefix(prefix[0]).lower().replace("_", "-") for constant, value in self.constants.items()}


def options_of(header: Path) -> dict[str, Declared]:
    """The options of the class of a header, by their names, in the order of their declarations."""
    text = header.read_text(encoding="utf-8")
    for shared in SHARED:
        text = _expanded(text, header.with_name(shared))
    enumerations = {name: _values(body) for name, body in re.findall(r"enum (\w+)Type\s*\{([^}]*)\}", text)}
    found: dict[str, Declared] = {}
    comments = list(re.finditer(COMMENT, text, re.DOTALL))
    for comment, following in zip(comments, [*comments[1:], None]):
        code = text[comment.end() : following.start() if following else len(text)]
        for setter in SETTER.finditer(re.sub(r"///@\}.*", "", code, flags=re.DOTALL)):
            name = setter["name"] or setter["text"] or setter["got"]
            kind = "string" if setter["text"] else KINDS.get(setter["type"] or setter["gottype"])
            if name in found or kind is None:
                continue
            limits = [None if limit is None or limit.strip() in NO_LIMIT else limit.strip() for limit in (setter["least"], setter["most"])]
            constants = enumerations.get(name, {})
            if constants:
                limits = [None, None]
            found[name] = Declared(name, kind, _words(comment["words"], name), *limits, constants)
    return found


def _expanded(text: str, shared: Path) -> str:
    """The text of a header with the shared macros for options in their full length, each behind its comment."""
    macros = re.findall(COMMENT + r"\n#define (?P<macro>\w+)\(\)(?P<body>(?:[^\n]*\\\n)+[^\n]*)", shared.read_text(encoding="utf-8"), re.DOTALL)
    for words, macro, body in macros:
        whole = f"/**{words}*/\n" + body.replace("\\\n", "\n") + "\n"
        text = re.sub(rf"\b{macro}\(\)", lambda found, whole=whole: whole, text)
    return text


def _values(body: str) -> dict[str, int]:
    """The constants of an enumeration."""
    values: dict[str, int] = {}
    for name, value in re.findall(r"^[ \t]*([A-Z_0-9]+)[ \t]*(?:=[ \t]*(-?\d+))?", re.sub(r"///<[^\n]*|//[^\n]*", "", body).replace(",", "\n"), re.MULTILINE):
        values[name] = int(value) if value else (max(values.values()) + 1 if values else 0)
    return values


def _words(comment: str, name: str) -> str:
    """A comment as one line; that of a shared macro begins with the option's name."""
    lines = [re.sub(r"^\s*\*? ?", "", line) for line in comment.strip().splitlines()]
    words = " ".join(" ".join(lines).split()).removeprefix(f"{name}: ")
    return words[:1].upper() + words[1:]

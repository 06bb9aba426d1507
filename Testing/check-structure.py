#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules of the tree's structure: the top level, the order of the rooms, a page that names each file, short functions,
documented classes, a name of its own for each type, and VTK's ABI namespace.

    python3 check-structure.py [ROOT]

Prints a line for what breaks a rule; the exit status is then 1.
"""

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path

LONGEST_FUNCTION = 100  # lines, from the first of the declaration to the closing brace
SOURCE_FOLDERS = ("Filters", "Plugin", "Testing", "Examples")
CPP = (".h", ".cxx")

# Parts of code that may contain a brace or a keyword that is none: comments, raw strings, strings, characters, the
# preprocessor's lines. An apostrophe after a letter or digit separates digits.
NO_CODE = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|(?<!\w)'(?:\\.|[^'\\\n])+'"""
    r"|^[ \t]*\#(?:\\\n|[^\n])*",
    re.DOTALL | re.MULTILINE,
)
# What stands in front of a declaration without a semicolon.
PREFIX = re.compile(r"\s*(?:(?:public|protected|private)\s*:(?!:)|Q_OBJECT\b|vtk\w+Macro\([^()]*\))\s*")


def files_in(folder: Path, suffixes: tuple[str, ...]) -> list[Path]:
    return sorted(file for file in folder.rglob("*") if file.suffix in suffixes and file.is_file())


def read(file: Path) -> str:
    return file.read_text(encoding="utf-8")


def code_of(text: str) -> str:
    """The text without what is no code, every line where it was."""
    return NO_CODE.sub(lambda match: "\n" * match.group().count("\n") or " ", text)


# The top level

TOP_LEVEL = {"CMakeLists.txt", "Examples", "Filters", "LICENSE", "Plugin", "README.md", "Testing", "vtk.module"}


def check_top_level(root: Path) -> Iterator[str]:
    """Nothing is at the top beside what belongs there, dotfiles and build folders."""
    for entry in sorted(root.iterdir()):
        if entry.name not in TOP_LEVEL and not entry.name.startswith(".") and not (entry.is_dir() and entry.name.startswith("build")):
            yield f"{entry.name}: does not belong to the top level"


# The rooms


def rooms_of(house: Path) -> list[str]:
    """The rooms from the ground up; none where the house has no list of them."""
    file = house / "Rooms.txt"
    lines = read(file).splitlines() if file.exists() else []
    return [line.strip() for line in lines if line.strip() and not line.startswith("#")]


def check_house(root: Path, house: Path, basement: Path | None) -> Iterator[str]:
    """The rooms of a folder, and what they include: nothing above them, but all of the basement. A folder that builds
    something of its own is no room."""
    rooms = rooms_of(house)
    others = {file.parent for file in house.glob("*/CMakeLists.txt")}
    sources = [file for file in files_in(house, CPP) if others.isdisjoint(file.parents)]
    folders = {file.relative_to(house).parts[0] for file in sources if file.parent != house}
    where = house.relative_to(root)
    headers = {room for room in rooms if (house / room).is_file()}
    for room in sorted(folders.symmetric_difference(rooms) - headers):
        what = "has no folder of sources" if room in rooms else "is not in Rooms.txt"
        yield f"{where}/{room}: the room {what}"
    for file in sources:
        room = file.relative_to(house).parts[0] if file.parent != house else None
        if room is not None and room not in rooms:
            continue
        allowed = rooms if room is None else rooms[: rooms.index(room) + 1]
        for included in re.findall(r'^\s*#\s*include\s*"([^"]+)"', read(file), re.MULTILINE):
            if basement is not None and (basement / included).exists():
                continue
            if "/" not in included and (room is None or not (house / included).exists()):
                continue
            if included.split("/")[0] not in allowed:
                yield f"{file.relative_to(root)}: includes {included}, which is not below it in Rooms.txt"


def check_rooms(root: Path) -> Iterator[str]:
    filters, core = root / "Filters", root / "Filters/Core"
    yield from check_house(root, core, None)
    if rooms_of(filters):
        yield from check_house(root, filters, core)


# The pages


def names_on(page: Path) -> set[str]:
    """What a page names in backquotes, without folder and suffix."""
    names = re.findall(r"`([^`\n]+)`", read(page))
    return {re.sub(r"\.(h|cxx)$", "", name.split("/")[-1]) for name in names}


def check_pages(root: Path) -> Iterator[str]:
    core = root / "Filters/Core"
    folders = [core] + sorted(folder for folder in core.iterdir() if folder.is_dir())
    pages = [(folder / "README.md", folder) for folder in folders]
    filters = root / "Filters/README.md"
    if filters.exists():
        pages += [(filters, root / "Filters" / room) for room in (".", *rooms_of(root / "Filters"))]
    for page, folder in pages:
        stems = {file.stem for file in folder.glob("*") if file.suffix in CPP}
        if stems and not page.exists():
            yield f"{page.relative_to(root)}: is missing"
            continue
        for stem in sorted(stems - names_on(page) if stems else []):
            yield f"{page.relative_to(root)}: does not name `{stem}` of {folder.relative_to(root)}"
    for page in files_in(root / "Filters", (".md",)):
        if re.match(r"#+[^#\s]", read(page)):
            yield f"{page.relative_to(root)}: its title is none: a page that was formatted as code"


# Links


def anchors_of(page: Path) -> set[str]:
    """What GitHub calls the headings of a page."""
    headings = re.findall(r"^#+ (.+)$", re.sub(r"^```.*?^```$", "", read(page), flags=re.MULTILINE | re.DOTALL), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def check_links(root: Path) -> Iterator[str]:
    """Links and pictures of all pages lead to files that are there, and to headings that they have."""
    pages = [root / "README.md", *(page for folder in SOURCE_FOLDERS for page in files_in(root / folder, (".md",)))]
    for page in (page for page in pages if page.exists()):
        for link in re.findall(r"\]\(([^):]+)\)", read(page)):
            name, _, anchor = link.partition("#")
            target = page.parent / name if name else page
            if not target.exists() or anchor and (target.suffix != ".md" or anchor not in anchors_of(target)):
                yield f"{page.relative_to(root)}: the link {link} leads nowhere"


# Short functions


def without_template(declaration: str) -> str:
    """A declaration from behind its lists of template parameters on."""
    while re.match(r"\s*template\s*<", declaration):
        depth = 0
        for at, c in enumerate(declaration):
            depth += (c == "<") - (c == ">")
            if c == ">" and depth == 0:
                declaration = declaration[at + 1 :]
                break
        else:
            break
    return declaration


def kind_of_block(declaration: str) -> str:
    """What a brace behind this begins: a value, a scope with declarations of its own, or a function."""
    if declaration.count("(") > declaration.count(")") or not re.search(r"[^\s=,({]\s+$|^\s*$", declaration):
        return "value"
    head = without_template(declaration).split("(")[0]
    if declaration.split() in ([], ["extern"]) or re.search(r"\b(namespace|class|struct|union|enum)\b", head):
        return "scope"
    return "function" if "(" in declaration else "value"


def end_of_block(code: str, begin: int) -> int:
    """The place of the brace that closes the one at `begin`."""
    depth = 0
    for match in re.compile(r"[{}]").finditer(code, begin):
        depth += 1 if match.group() == "{" else -1
        if depth == 0:
            return match.start()
    return len(code)


def cpp_functions(text: str) -> Iterator[tuple[int, int, str]]:
    """First line, length and declaration of each function, local classes and lambdas being a part of theirs."""
    code = code_of(text)
    at = begin = 0  # of the declaration that is read
    while match := re.compile(r"[{};]").search(code, at):
        place = match.start()
        at = place + 1
        while prefix := PREFIX.match(code, begin, place):
            begin = prefix.end()
        declaration = code[begin:place]
        if match.group() == "{":
            kind = kind_of_block(declaration)
            if kind != "scope":
                at = end_of_block(code, place) + 1
            if kind == "value":
                continue  # the declaration goes on behind it
            if kind == "function":
                first = begin + len(declaration) - len(declaration.lstrip())
                length = code.count("\n", first, at) + 1
                yield code.count("\n", 0, first) + 1, length, " ".join(declaration.split())
        elif declaration.count("(") > declaration.count(")"):
            continue
        begin = at


def python_functions(text: str) -> Iterator[tuple[int, int, str]]:
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.lineno, node.end_lineno - node.lineno + 1, node.name


def check_functions(root: Path) -> Iterator[str]:
    for folder in SOURCE_FOLDERS:
        for file in files_in(root / folder, (*CPP, ".py")):
            functions = python_functions if file.suffix == ".py" else cpp_functions
            for line, length, name in functions(read(file)):
                if length > LONGEST_FUNCTION:
                    yield f"{file.relative_to(root)}:{line}: {length} lines in a function: {name[:60]}"


# Documented classes


def check_classes(root: Path) -> Iterator[str]:
    for file in files_in(root / "Filters", (".h",)):
        text = read(file)
        named = re.findall(r"@class\s+(\w+)", text)
        if file.parent == root / "Filters" and "@file" not in text:
            for command in ("@class", "@brief"):
                if not re.search(rf"{command}\s+\w", text):
                    yield f"{file.relative_to(root)}: has no {command}"
        for name in named:
            if not re.search(rf"\b(class|struct)\s+(\w+\s+)?{name}\b[^;{{]*\{{", code_of(text)):
                yield f"{file.relative_to(root)}: @class {name}, but declares no such class"


def check_names(root: Path) -> Iterator[str]:
    """Two types of one name are one to the linker, which takes the functions of either: no compiler sees it."""
    first: dict[tuple[str, str], Path] = {}
    for file in files_in(root / "Filters", (".h",)):
        code = code_of(read(file))
        spaces = re.findall(r"^namespace (\w+)\n", code, re.MULTILINE)
        for name in re.findall(r"^(?:class|struct|union|enum(?: class)?)\s+(?:\w+\s+)?(\w+)\s*(?::[^:;{][^;{]*)?\{", code, re.MULTILINE):
            other = first.setdefault((spaces[-1] if spaces else "", name), file)
            if other != file:
                yield f"{file.relative_to(root)}: {name} is declared in {other.relative_to(root)}, too"


def check_abi_namespace(root: Path) -> Iterator[str]:
    """Headers declare VTK's classes in its ABI namespace: elsewhere they would be other classes where it has a name."""
    for file in (file for folder in ("Filters", "Plugin") for file in files_in(root / folder, (".h",))):
        outside = re.sub(r"^VTK_ABI_NAMESPACE_BEGIN$.*?^VTK_ABI_NAMESPACE_END$", "", code_of(read(file)), flags=re.MULTILINE | re.DOTALL)
        for name in re.findall(r"^(?:class|struct) (?:\w+ )?(vtk[A-Z]\w*)\b", outside, re.MULTILINE):
            yield f"{file.relative_to(root)}: {name} is not in VTK's ABI namespace"


def check(root: Path) -> list[str]:
    """What breaks a rule, one line each."""
    rules = (check_top_level, check_rooms, check_pages, check_links, check_functions, check_classes, check_names, check_abi_namespace)
    return [complaint for rule in rules for complaint in rule(root)]


if __name__ == "__main__":
    complaints = check(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
    for complaint in complaints:
        print(complaint)
    sys.exit(1 if complaints else 0)

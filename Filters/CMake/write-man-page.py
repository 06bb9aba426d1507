# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the manual page of the command `insideout` from what its --help-all says: a section for each subcommand.

    write-man-page.py FILE
"""

import os
import subprocess
import sys
from pathlib import Path

USAGE = "usage: insideout "


def main(file: str) -> None:
    text = subprocess.run(
        [sys.executable, "-m", "insideout", "--help-all"],
        check=True,
        capture_output=True,
        text=True,
        env={**os.environ, "COLUMNS": "80"},
    ).stdout
    usage, _, rest = text.partition("\n\n")
    synopsis = [line.split("insideout ", 1)[1].replace("-", "\\-") for line in usage.splitlines()]
    page = [
        ".\\\" SPDX-License-Identifier: GPL-3.0-or-later",
        ".TH INSIDEOUT 1",
        ".SH NAME",
        "insideout \\- tetrahedra of the solid that a broken triangle surface means",
        ".SH SYNOPSIS",
        "\n.br\n".join(".B insideout\n" + line for line in synopsis),
        ".SH DESCRIPTION",
        ".nf",
        *(line for text in rest.splitlines() for line in lines_of(text)),
        ".fi",
    ]
    Path(file).write_text("\n".join(page) + "\n", encoding="utf-8")


def lines_of(text: str) -> list[str]:
    """A line of text in the page; a leading dot or quote would be a request, and every dash is meant as it stands."""
    plain = text.replace("\\", "\\e").replace("-", "\\-")
    if text.startswith(USAGE):
        return [".fi", ".SS insideout " + plain.removeprefix(USAGE), ".nf"]
    return ["\\&" + plain if text[:1] in (".", "'") else plain]


if __name__ == "__main__":
    main(sys.argv[1])

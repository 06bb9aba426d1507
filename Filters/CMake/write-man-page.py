# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the manual page of the command `insideout` from what its --help says.

    write-man-page.py FILE
"""

import subprocess
import sys
from pathlib import Path


def main(file: str) -> None:
    text = subprocess.run(
        [sys.executable, "-m", "insideout", "--help"], check=True, capture_output=True, text=True
    ).stdout
    usage, _, rest = text.partition("\n\n")
    # A leading dot or quote would be a request, and every dash is meant as it stands.
    lines = [("\\&" + line if line[:1] in ".'" else line) for line in rest.replace("\\", "\\e").replace("-", "\\-").splitlines()]
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
        *lines,
        ".fi",
    ]
    Path(file).write_text("\n".join(page) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])

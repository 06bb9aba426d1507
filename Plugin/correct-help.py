# SPDX-License-Identifier: GPL-3.0-or-later
"""Take out of ParaView's help pages what is not so.

    correct-help.py FOLDER

For the panels to offer arrays, an input has to have a domain of arrays. ParaView 5.11 then writes that it
must have one, even where the domain is marked as optional, as all of this plugin's are.
"""

import re
import sys
from pathlib import Path

NEEDS_ARRAY = re.compile(r"<p>\s*The dataset must contain a field array \(\w+\)[^<]*</p>")

for page in Path(sys.argv[1]).glob("filters.*.html"):
    text = page.read_text(encoding="utf-8")
    page.write_text(NEEDS_ARRAY.sub("", text), encoding="utf-8")

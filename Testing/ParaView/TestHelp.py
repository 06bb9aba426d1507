# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages that ParaView's help has of the plugin's filters.

    python3 TestHelp.py FOLDER
"""

import re
import sys
import unittest
from pathlib import Path

FOLDER = Path(sys.argv[1])


class TestHelp(unittest.TestCase):
    def test_no_filter_is_said_to_need_an_array(self):
        pages = sorted(FOLDER.glob("filters.*.html"))
        self.assertIn("Accepts input of following types", (FOLDER / "filters.RobustTetrahedralize.html").read_text(encoding="utf-8"))
        for page in pages:
            words = re.sub(r"<[^>]*>", " ", page.read_text(encoding="utf-8"))
            with self.subTest(page=page.name):
                self.assertNotIn("must contain", words)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

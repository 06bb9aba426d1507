# SPDX-License-Identifier: GPL-3.0-or-later
"""Each rule of check-structure.py complains of a small tree that breaks it, and of nothing else."""

import runpy
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parent / "check-structure.py"
check = runpy.run_path(str(SCRIPT))["check"]

# A tree that keeps every rule.
KEPT = {
    "Filters/Core/Rooms.txt": "# From the ground up.\nGround\nUpper\n",
    "Filters/Core/CMakeLists.txt": "",
    "Filters/Core/README.md": "[Ground](Ground/README.md), [Upper](Upper/Tower.h), and above them `Roof`.\n",
    "Filters/Core/Roof.h": "int Height();\n",
    "Filters/Core/Roof.cxx": '#include "Roof.h"\n#include "Upper/Tower.h"\n',
    "Filters/Core/Ground/README.md": "`Ground/Base.h`\n",
    "Filters/Core/Ground/Base.h": "#include <vector>\n",
    "Filters/Core/Upper/README.md": "`Tower`\n",
    "Filters/Core/Upper/Tower.h": '#include "Ground/Base.h"\n',
    "Filters/Core/Upper/Tower.cxx": '#include "Upper/Tower.h"\n',
    "Filters/README.md": "`vtkHouse`, `Wine`, `Beam`\n",
    "Filters/vtkHouse.h": "/**\n * @class vtkHouse\n * @brief has rooms\n */\nVTK_ABI_NAMESPACE_BEGIN\n"
    "class EXPORT vtkHouse : public vtkBuilding\n{\n};\nVTK_ABI_NAMESPACE_END\n",
    "Filters/Rooms.txt": "Cellar\nAttic\n",
    "Filters/Cellar/Wine.h": '#include "Ground/Base.h"\n#include "vtkBuilding.h"\n',
    "Filters/Attic/Beam.h": '#include "Cellar/Wine.h"\n',
    "Filters/Shed/CMakeLists.txt": "",
    "Filters/Shed/Tool.h": "int Uses();\n",
}

# Braces and keywords in places where they mean nothing to the length of a function.
DECOYS = """#define OPEN {
namespace a
{
/* { */ // {
template <class T, template <class> class U>
class House : public Base<decltype(Size())>
{
public:
  House(int rooms) : Rooms{ { rooms } }
  {
  }
  char Brace = '{';
  const char* Text = "{\\"{";
  std::array<int, 2> Numbers = { { 1'000, 2 } };
  const char* Raw = R"(
{
)";
vtkTypeMacro(House, Base)
  void operator()(int n = int{ 3 }) const { this->Call({ 1, 2 }, [](int i) { return i; }); }
};
"""


def function(lines: int, head: str = "void Long()") -> str:
    """A function of that many lines, with blocks in it."""
    inner = ["  if (true)", "  {", "    const auto f = [](int)", "    {", "    };", "  }"]
    return "\n".join([head, "{", *inner, *["  ;"] * (lines - len(inner) - 3), "}", ""])


class TestStructureRules(unittest.TestCase):
    def tree(self, changes: dict[str, str | None]) -> Path:
        """The tree that keeps the rules, with some files changed (None: without them)."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        for name, text in {**KEPT, **changes}.items():
            if text is not None:
                file = Path(folder.name, name)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")
        return Path(folder.name)

    def complaints(self, **changes: str | None) -> list[str]:
        return check(self.tree(changes))

    def expect_one(self, file: str, what: str, **changes: str | None):
        complaints = self.complaints(**changes)
        self.assertEqual(len(complaints), 1, complaints)
        self.assertTrue(complaints[0].startswith(file), complaints[0])
        self.assertIn(what, complaints[0])

    def test_a_tree_that_keeps_the_rules_is_left_in_peace(self):
        self.assertEqual(self.complaints(), [])

    def test_the_program_fails_where_it_complains(self):
        broken = self.tree({"Filters/README.md": "`vtkHouse`\n"})
        for tree, status in ((self.tree({}), 0), (broken, 1)):
            run = subprocess.run([sys.executable, SCRIPT, tree], capture_output=True, text=True, check=False)
            self.assertEqual((run.returncode, run.stdout.splitlines()), (status, check(tree)))

    def test_the_top_level_holds_nothing_else(self):
        self.expect_one("BndLayerDebug.log", "does not belong to the top level", **{"BndLayerDebug.log": ""})
        self.assertEqual(self.complaints(**{".ci/run": "", "build-test/a.log": "", "vtk.module": ""}), [])

    def test_a_room_includes_no_room_above_it(self):
        name = "Filters/Core/Ground/Base.h"
        self.expect_one(name, "includes Upper/Tower.h", **{name: '#include "Upper/Tower.h"\n'})

    def test_a_room_includes_no_file_above_all_rooms(self):
        name = "Filters/Core/Upper/Tower.cxx"
        self.expect_one(name, "includes Roof.h", **{name: ' # include "Roof.h"\n'})

    def test_a_room_of_the_filters_includes_no_class_and_no_room_above_it(self):
        name = "Filters/Cellar/Wine.h"
        for included in ("vtkHouse.h", "Attic/Beam.h", "Shed/Tool.h"):
            self.expect_one(name, f"includes {included}", **{name: f'#include "{included}"\n'})

    def test_nothing_includes_from_a_room_that_is_not_there(self):
        name = "Filters/Core/Roof.cxx"
        self.expect_one(name, "includes Attic/Beam.h", **{name: '#include "Attic/Beam.h"\n'})

    def test_every_room_is_listed(self):
        changes = {"Filters/Core/Attic/README.md": "`Beam`\n", "Filters/Core/Attic/Beam.h": '#include "Roof.h"\n'}
        self.expect_one("Filters/Core/Attic", "not in Rooms.txt", **changes)

    def test_every_listed_room_is_there(self):
        rooms = "Ground\nUpper\nAttic\n"
        self.expect_one("Filters/Core/Attic", "no folder", **{"Filters/Core/Rooms.txt": rooms})

    def test_a_header_beside_the_rooms_is_below_those_named_after_it(self):
        wine = {"Filters/Cellar/Wine.h": '#include "vtkHouse.h"\n'}
        self.expect_one("Filters/Cellar/Wine.h", "includes vtkHouse.h", **wine)
        self.assertEqual(self.complaints(**wine, **{"Filters/Rooms.txt": "vtkHouse.h\nCellar\nAttic\n"}), [])

    def test_every_room_has_a_page(self):
        name = "Filters/Core/Upper/README.md"
        self.expect_one(name, "is missing", **{name: None})

    def test_every_file_of_a_room_is_named_on_its_page(self):
        name = "Filters/Core/Upper/README.md"
        self.expect_one(name, "does not name `Tower`", **{name: "Tower, `Tow` and `er`, `Towers`\n"})

    def test_every_file_above_the_rooms_is_named_on_the_page_of_all(self):
        name = "Filters/Core/README.md"
        self.expect_one(name, "does not name `Roof`", **{name: "`Upper/Tower.h`\n"})

    def test_every_file_of_the_filters_is_named_where_they_have_a_page(self):
        name = "Filters/README.md"
        self.expect_one(name, "does not name `Wine` of Filters/Cellar", **{name: "`vtkHouse.h`, `Beam`\n"})
        self.expect_one(name, "does not name `vtkHouse` of Filters", **{name: "`Wine`, `Beam`\n"})
        self.assertEqual(self.complaints(**{name: None}), [])

    def test_no_page_was_formatted_as_code(self):
        name = "Filters/Core/Upper/README.md"
        self.expect_one(name, "its title is none", **{name: "#Upper : the `Tower`\n"})
        self.assertEqual(self.complaints(**{name: "# Upper: the `Tower`\n"}), [])

    def test_every_link_of_a_page_leads_somewhere(self):
        name = "Filters/Core/Upper/README.md"
        self.expect_one(name, "link ../Roof.hxx", **{name: "`Tower` [below](../Roof.hxx) [above](../Roof.h)\n"})
        for page in ("README.md", "Plugin/README.md", "Examples/One/README.md"):
            self.expect_one(page, "link roof.png", **{page: "![a roof](roof.png)\n"})
            self.assertEqual(self.complaints(**{page: "[elsewhere](https://example.org/roof.png)\n"}), [])

    def test_a_link_to_a_heading_finds_it(self):
        kept = "# The house: its `Tower`\n[above](#the-house-its-tower) [there](Filters/Core/Upper/README.md#stairs)\n"
        upper = {"Filters/Core/Upper/README.md": "`Tower`\n\n## Stairs\n"}
        self.assertEqual(self.complaints(**{"README.md": kept}, **upper), [])
        self.expect_one("README.md", "link #tower", **{"README.md": "# The house\n[above](#tower)\n"})
        self.expect_one("README.md", "link Filters/Core/Upper/README.md#stairs", **{"README.md": kept})
        fenced = "```sh\n# The house\n```\n[above](#the-house)\n"
        self.expect_one("README.md", "link #the-house", **{"README.md": fenced})

    def test_functions_are_no_longer_than_a_hundred_lines(self):
        heads = ("void Long()", "template <class T>\nT House<T>::Long(\n  int n) const", "TEST(House, Stands)")
        heads += ("House::House()\n  : Base{ 1 }\n  , Rooms(2)", 'extern "C" int Long()', "int operator==(int, int)")
        for folder in ("Filters/Core/Upper/Tower.cxx", "Plugin/Door.cxx", "Testing/Cxx/TestDoor.cxx", "Examples/Door.h"):
            for head in heads:
                lines = 100 - head.count("\n")
                kept, broken = (DECOYS + function(n, head) + "}\n" for n in (lines, lines + 1))
                self.assertEqual(self.complaints(**{folder: kept}), [])
                at = 1 + DECOYS.count("\n")
                self.expect_one(f"{folder}:{at}:", "101 lines", **{folder: broken})

    def test_functions_in_classes_count_and_classes_do_not(self):
        name = "Examples/Door.h"
        house = "class House\n{\npublic:\n" + function(60, "  void A()") + function(60, "  void B()") + "%s};\n"
        self.assertEqual(self.complaints(**{name: house % ""}), [])
        self.expect_one(f"{name}:124:", "101 lines", **{name: house % function(101, "  void C()")})

    def test_functions_of_python_are_no_longer_than_a_hundred_lines(self):
        name = "Filters/Python/door.py"
        text = "class Door:\n    def open(self):\n" + "        pass\n" * 99
        self.assertEqual(self.complaints(**{name: text}), [])
        self.expect_one(f"{name}:2:", "101 lines in a function: open", **{name: text + "        pass\n"})

    def test_public_classes_are_documented(self):
        name = "Filters/vtkHouse.h"
        for command in ("@class", "@brief"):
            self.expect_one(name, f"has no {command}", **{name: KEPT[name].replace(command, "")})

    def test_each_type_has_a_name_of_its_own(self):
        name = "Filters/Core/Upper/Tower.h"
        for first, second in (("struct Beam\n{\n", "class Beam : public Wood\n{\n"), ("enum class Beam\n{\n", "struct Beam { int A;\n")):
            texts = {"Filters/Core/Ground/Base.h": f"{first}}};\n", name: f"{second}}};\n"}
            self.expect_one(name, "Beam is declared in Filters/Core/Ground/Base.h, too", **texts)
        texts["Filters/Core/Ground/Base.h"] = "namespace other\n{\nstruct Beam\n{\n};\n}\n"
        self.assertEqual(self.complaints(**texts), [])
        for second in ("struct Beam;\n", "  struct Beam\n  {\n  };\n", "// struct Beam\n{\n", "Beam Make();\n"):
            texts = {"Filters/Core/Ground/Base.h": "struct Beam\n{\n};\n", name: second}
            self.assertEqual(self.complaints(**texts), [])

    def test_headers_declare_classes_of_vtk_in_its_abi_namespace(self):
        within = "VTK_ABI_NAMESPACE_BEGIN\nclass vtkBeam;\nVTK_ABI_NAMESPACE_END\n"
        kept = "class Door;\nclass vtkdoor;\n// class vtkDoor;\n" + within
        for name in ("Filters/Attic/Beam.h", "Plugin/Door.h"):
            self.assertEqual(self.complaints(**{name: kept}), [])
            for broken in ("class vtkBeam;\n", "struct EXPORT vtkBeam : public vtkWood\n{\n};\n"):
                for text in (broken + within, within + broken, within + broken + within):
                    self.expect_one(name, "vtkBeam is not in VTK's ABI namespace", **{name: text})

    def test_documented_classes_are_there(self):
        name = "Filters/vtkHouse.h"
        for declared in ("class vtkHouses\n{\n", "class vtkHouse;\n", "// class vtkHouse\n{\n"):
            text = KEPT[name].replace("class EXPORT vtkHouse : public vtkBuilding\n{\n", declared)
            self.expect_one(name, "@class vtkHouse, but", **{name: text})
        name = "Filters/Attic/Beam.h"
        self.expect_one(name, "@class Beam, but", **{name: "/** @class Beam */\nint Length();\n"})


if __name__ == "__main__":
    unittest.main()

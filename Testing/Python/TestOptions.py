# SPDX-License-Identifier: GPL-3.0-or-later
"""Every place that tells of an option says what the class does: ParaView's XML, the README, Python and the command line."""

import inspect
import math
import re
import runpy
import shutil
import sys
import typing
import unittest
import xml.etree.ElementTree as ElementTree
from dataclasses import fields, replace
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import patch

import insideout
import surfaces
from insideout import arguments
from insideout.help import screen_of
from insideout.option_kinds import Choice, Count, Decision, Dimensions, Number, Option, Order, Scale, Switch, owner_of
from insideout.options import DEFAULTS, LAYER_OPTIONS, OPTIONS, Options, flag_of, help_of
from insideout.usage import OTHER_FLAGS
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

ROOT = Path(__file__).resolve().parents[2]
PLUGIN = ROOT / "Plugin"
sys.path.insert(0, str(ROOT / "Filters/CMake"))
import declared_options as DECLARED

EXPANDED = runpy.run_path(str(PLUGIN / "make-xml.py"))["expanded"]

NOT_IN_PARAVIEW = {
    "vtkImplicitWindingNumber": "an implicit function: ParaView's filters choose among their own",
    "vtkWindingNumberToImageStencil": "image stencils are no data of ParaView's",
    "vtkSurfaceWriter": "ParaView's own writers save what the filters give",
}

STAGES = ("WindingNumber", "Segmentation", "Refinement")
"""What a class hands out that goes by the options of stages."""

STAGES_OF_CLASSES = ("vtkGeneralizedWindingNumber", "vtkGraphCutSegmentation", "vtkRefineTetrahedra")

NOT_BY_MACROS = {"FileName", "Input", "WriteNumbers"}
"""What classes let a user set by methods of their own."""

UNUSED_OF_STAGES = {
    "ExtractInside": "output 0 has the cells inside, and output 3 the hull",
    "SizingArrayName": "the grid that it would be an array of is made within",
}

UNUSED_IN_A_PLANE = {"MaximumCells", "SizeRules", "SurfaceTolerance", "FeatureAngle", "QuadraticCells"}
"""Boundaries are not remeshed there."""

NO_OPTIONS_OF_PANELS = {"ExtractInside": "tells states of before where the hull is", "ObjectName": "is what messages begin with", "Summary": "is told, not set"}

NAMES_IN_STATES = {"Surface": "SurfaceTreatment"}
"""What ParaView's states call a property that has another name now."""

NO_OPTIONS = {"Controller": "the processes that work together: all that ParaView or mpirun began, and rarely others"}

QUERIES = (insideout.winding_number, insideout.inside, insideout.distance, insideout.voxels)
HUGE = 1e200


CLASSES = [name for name in insideout.__all__ if name.startswith("vtk")]


def properties(class_name: str) -> dict[str, object]:
    """What a user of a class can set, on it or on a stage that it hands out, with the defaults."""
    return values_of(getattr(insideout, class_name)())


def values_of(made: object) -> dict[str, object]:
    own = vars(type(made))
    names = [name[3:] for name in own if name.startswith("Set") and "Get" + name[3:] in own and name[3:] not in NO_OPTIONS]
    values = {name: getattr(made, "Get" + name)() for name in names}
    stages = {name: values.pop(name) for name in STAGES if name in values}
    for stage in stages.values():
        values.update({name: value for name, value in values_of(stage).items() if name not in UNUSED_OF_STAGES})
    return {name: "" if value is None else value for name, value in values.items()}


def set_and_told(class_name: str, name: str, value: object) -> tuple[object, list[str]]:
    """A property's value after it was set, and the warnings."""
    owner, told = owner_of(getattr(insideout, class_name)(), name), []

    def listen(_owner, _event, text):
        told.append(text.rsplit(": ", 2)[1])

    listen.CallDataType = "string0"
    owner.AddObserver("WarningEvent", listen)
    getattr(owner, "Set" + name)(value)
    return getattr(owner, "Get" + name)(), told


def read_back(class_name: str, name: str, value: object) -> object:
    return set_and_told(class_name, name, value)[0]


def constants(class_name: str, name: str) -> dict[int, str]:
    """The values that a property of an enumeration can have, with the names of the class's constants as words."""
    own = vars(type(owner_of(getattr(insideout, class_name)(), name)))
    named = {int(value): constant for constant, value in own.items() if type(value).__name__ == name + "Type"}
    return {value: constant.removeprefix(name.upper() + "_").replace("_", "-").lower() for value, constant in named.items()}


def files_of_plugin() -> list[ElementTree.ElementTree]:
    """The XML that ParaView reads."""
    return [EXPANDED(ROOT / "Filters", file) for file in PLUGIN.glob("*.xml")]


@lru_cache
def proxies() -> dict[str, ElementTree.Element]:
    """The proxies of InsideOut's classes in the plugin's XML, by class; of several the last, which has the most properties."""
    found = [proxy for file in files_of_plugin() for kind in ("SourceProxy", "WriterProxy") for proxy in file.iter(kind)]
    return {proxy.get("class"): proxy for proxy in found if hasattr(insideout, proxy.get("class"))}


@lru_cache
def stage_proxies() -> dict[str, ElementTree.Element]:
    """Those that other proxies are based on, or expose properties of, by name."""
    return {proxy.get("name"): proxy for file in files_of_plugin() for proxy in file.iterfind("ProxyGroup[@name='inside_out_stages']/Proxy")}


def base_of(proxy: ElementTree.Element) -> ElementTree.Element:
    return stage_proxies().get(proxy.get("base_proxyname"), ElementTree.Element("Proxy"))


def property_elements(proxy: ElementTree.Element) -> dict[str, ElementTree.Element]:
    """Those of a proxy, of the one that it is based on, and those that it exposes of others."""
    elements = {one.get("name"): one for one in proxy if one.tag.endswith("VectorProperty")}
    stages = stage_proxies()
    elements.update(property_elements(base_of(proxy)) if proxy.get("base_proxyname") else {})
    for name, stage in exposed(proxy):
        if name not in NO_OPTIONS_OF_PANELS:
            elements[name] = property_elements(stages[stage])[NAMES_IN_STATES.get(name, name)]
    hidden = {name for name, one in elements.items() if one.get("panel_visibility") == "never"}
    return {NAMES_IN_STATES.get(name, name): one for name, one in elements.items() if name not in hidden & set(NO_OPTIONS_OF_PANELS)}


def exposed(proxy: ElementTree.Element) -> dict[tuple[str, str], ElementTree.Element]:
    """What a proxy exposes, by its name and that of the stage."""
    return {
        (one.get("name"), inner.find("Proxy").get("proxyname")): one
        for inner in proxy.iterfind("SubProxy")
        for one in inner.iterfind("ExposedProperties/Property")
    }


def words_of(element: ElementTree.Element) -> str:
    return (element.findtext("Documentation") or "").strip()


def example(option: Option) -> object:
    """A value that an option can have and does not have by default."""
    if isinstance(option, Choice):
        return option.choices[-1]
    if isinstance(option, Order):
        return int(option.most)
    if isinstance(option, Count):
        return 7
    return True if isinstance(option, (Switch, Decision)) else 7.0 if isinstance(option, (Number, Scale)) else "Some"


def plugin_properties():
    """Each property that stands in the plugin's XML: its class, name, element and the class's default."""
    for class_name, proxy in proxies().items():
        for name, element in property_elements(proxy).items():
            yield class_name, name, element, properties(class_name)[name]


class ParaView(unittest.TestCase):
    def test_each_filter_has_a_file_with_all_its_properties(self):
        self.assertEqual({*proxies(), *NOT_IN_PARAVIEW}, set(CLASSES))
        for class_name, proxy in proxies().items():
            self.assertEqual("vtk" + proxy.get("name"), class_name)
            self.assertTrue((PLUGIN / (proxy.get("name") + ".xml")).exists(), class_name)
            unused = UNUSED_IN_A_PLANE if class_name == "vtkRobustTriangulate" else set()
            self.assertEqual(set(property_elements(proxy)), set(properties(class_name)) - unused, class_name)

    def test_each_property_sets_its_namesake_and_has_its_default(self):
        kinds = {float: "Double", int: "Int", bool: "Int", str: "String"}
        for class_name, name, element, default in plugin_properties():
            with self.subTest(filter=class_name, property=name):
                self.assertEqual(element.get("command"), "Set" + name)
                self.assertEqual(element.tag, kinds[type(default)] + "VectorProperty")
                given = element.get("default_values", "")
                self.assertEqual(given if isinstance(default, str) else float(given), default)

    def test_each_stage_is_set_and_what_is_exposed_keeps_its_default(self):
        stages = stage_proxies()
        facades = {class_name: proxy for class_name, proxy in proxies().items() if proxy.find("SubProxy") is not None}
        self.assertEqual(set(facades), {"vtkRobustTetrahedralize", "vtkRobustTriangulate"})
        for class_name, proxy in facades.items():
            made = getattr(insideout, class_name)()
            for inner in proxy.iterfind("SubProxy"):
                stage = inner.find("Proxy").get("proxyname")
                self.assertEqual(inner.get("command"), "Set" + stage)
                self.assertEqual(stages[stage].get("class"), getattr(made, "Get" + stage)().GetClassName())
            for (name, stage), element in exposed(proxy).items():
                with self.subTest(filter=class_name, property=name):
                    if name == "ObjectName":
                        self.assertEqual(element.get("default_values"), proxy.get("label"), "the stage speaks for the filter")
                        continue
                    given = element.get("default_values")
                    self.assertIn(given, (None, property_elements(stages[stage])[NAMES_IN_STATES.get(name, name)].get("default_values")))

    def test_each_range_is_what_the_class_clamps_to(self):
        for class_name, name, element, default in plugin_properties():
            with self.subTest(filter=class_name, property=name):
                domain = element.find("DoubleRangeDomain") if isinstance(default, float) else element.find("IntRangeDomain")
                if isinstance(default, float) or domain is not None:
                    self.assertIsNotNone(domain)
                    huge = HUGE if isinstance(default, float) else 2**31 - 1
                    for bound, beyond in ((domain.get("min"), -huge), (domain.get("max"), huge)):
                        expected = beyond if bound is None else type(default)(float(bound))
                        self.assertEqual(read_back(class_name, name, beyond), expected)

    def test_each_enumeration_has_the_constants_of_the_class(self):
        for class_name, name, element, default in plugin_properties():
            with self.subTest(filter=class_name, property=name):
                entries = {int(entry.get("value")): re.sub("[ .]", "-", entry.get("text").lower()) for entry in element.iterfind("EnumerationDomain/Entry")}
                self.assertEqual(entries, constants(class_name, name))
                if entries:
                    self.assertEqual(read_back(class_name, name, min(entries) - 1), min(entries))
                    self.assertEqual(read_back(class_name, name, max(entries) + 1), max(entries))
                elif type(default) is int:
                    self.assertIsNotNone(element.find("IntRangeDomain"))

    def test_the_class_tells_what_is_out_of_range_with_the_range(self):
        for class_name, name, element, default in plugin_properties():
            kind = type(default)
            domain = element.find("DoubleRangeDomain" if kind is float else "IntRangeDomain")
            if domain is None or domain.get("min") is None:
                continue
            least, most = (None if domain.get(end) is None else kind(float(domain.get(end))) for end in ("min", "max"))
            words = f"at least {least:g}" if most is None else f"from {least:g} to {most:g}"
            with self.subTest(filter=class_name, property=name):
                for value in (least, most, default):
                    self.assertEqual(set_and_told(class_name, name, default if value is None else value)[1], [])
                for value in (least - 3, *([] if most is None else [most + 3])):
                    self.assertEqual(set_and_told(class_name, name, value)[1], [f"{name} is {value:g}, but must be {words}"])

    def test_each_switch_is_one(self):
        for class_name, name, element, default in plugin_properties():
            with self.subTest(filter=class_name, property=name):
                self.assertEqual(element.find("BooleanDomain") is not None, isinstance(default, bool))

    def test_a_misspelled_option_or_group_is_named_with_its_file(self):
        source = (PLUGIN / "RobustTetrahedralize.xml").read_text(encoding="utf-8")
        for right, wrong, expected in (
            ('"PartsApart"', '"PartApart"', "vtkRobustTetrahedralize.h declares no option PartApart"),
            ('"Performance" />\n      <Option', '"Perform" />\n      <Option', "the option PartsApart is in no PanelGroup"),
        ):
            with self.subTest(wrong), TemporaryDirectory() as folder:
                shutil.copytree(PLUGIN, folder, dirs_exist_ok=True)
                file = Path(folder) / "RobustTetrahedralize.xml"
                self.assertIn(right, source)
                file.write_text(source.replace(right, wrong), encoding="utf-8")
                with self.assertRaisesRegex(SystemExit, rf"^{re.escape(str(file))}: {re.escape(expected)}$"):
                    EXPANDED(ROOT / "Filters", file)

    def test_the_inputs_and_outputs_are_the_ports(self):
        for class_name, proxy in proxies().items():
            made = getattr(insideout, class_name)()
            inputs = {int(one.get("port_index", "0")): one for one in (*base_of(proxy), *proxy) if one.tag == "InputProperty"}
            self.assertEqual(sorted(inputs), list(range(made.GetNumberOfInputPorts())))
            outputs = 0 if proxy.tag == "WriterProxy" else max(1, len(proxy.findall("OutputPort")))
            self.assertEqual(outputs, made.GetNumberOfOutputPorts())
            for port, element in inputs.items():
                information = made.GetInputPortInformation(port)
                with self.subTest(filter=class_name, port=port):
                    self.assertTrue(words_of(element))
                    kinds = [kind.get("value") for kind in element.iterfind("DataTypeDomain/DataType")]
                    key = vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()
                    self.assertEqual(kinds, [information.Get(key, index) for index in range(information.Length(key))])
                    optional = bool(information.Get(vtkAlgorithm.INPUT_IS_OPTIONAL()))
                    self.assertEqual(element.find("Hints/Optional") is not None, optional)


class Headers(unittest.TestCase):
    """The declarations read from headers, and the page made from them."""

    def test_each_property_is_read_with_its_kind_range_and_default(self):
        kinds = {float: "double", int: "int", bool: "bool", str: "string"}
        for class_name in CLASSES:
            declared = DECLARED.options_of(ROOT / f"Filters/{class_name}.h")
            forwarded = {name for name in properties(class_name) if name not in declared}
            for name, option in declared.items():
                made = getattr(insideout, class_name)()
                default = getattr(made, "Get" + name)()
                with self.subTest(filter=class_name, property=name):
                    self.assertEqual(option.kind, kinds[type("" if default is None else default)])
                    self.assertEqual(option.choices(), constants(class_name, name))
                    self.assertEqual(type(default)(float(option.default)) if option.kind != "string" else option.default, "" if default is None else default)
                    self.assertRegex(option.brief, r"\.$")
                    for limit, far in ((option.least, -HUGE), (option.most, HUGE)):
                        if limit is not None:
                            self.assertEqual(read_back(class_name, name, far if option.kind == "double" else int(math.copysign(2**31 - 1, far))), float(limit))
            stages = {name for stage in STAGES_OF_CLASSES for name in DECLARED.options_of(ROOT / f"Filters/{stage}.h")}
            self.assertLessEqual(forwarded, stages | NOT_BY_MACROS, class_name)

    def test_the_page_has_each_of_them_in_a_row(self):
        text = (Path(insideout.__file__).parents[4] / "share/doc/InsideOut/Reference.md").read_text(encoding="utf-8")
        sections = dict(re.findall(r"^## (\w+)\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL))
        for class_name in CLASSES:
            declared = DECLARED.options_of(ROOT / f"Filters/{class_name}.h")
            rows = re.findall(r"^\| `(\w+)` \| .* \|$", sections.get(class_name, ""), re.MULTILINE)
            self.assertEqual(rows, list(declared), class_name)

    def test_the_page_describes_each_array_of_the_outputs(self):
        text = (Path(insideout.__file__).parents[4] / "share/doc/InsideOut/Reference.md").read_text(encoding="utf-8")
        described: dict[str, set[str]] = {}
        for names, kinds in re.findall(r"^\| (`\w+`(?:, `\w+`)*) \| ([^|]*) \| \[", text, re.MULTILINE):
            for name in re.findall(r"\w+", names):
                described.setdefault(name, set()).update(re.findall(r"\b(?:int|short|double|string|(?:un)?signed char|vtkIdType)\b", kinds))
        names = {"idtype": "vtkIdType"}
        bodies = insideout.tetrahedralize({"a": surfaces.box(), "b": surfaces.box(low=(0.5, 0, 0))})
        defects = insideout.check(surfaces.box())
        for made in (bodies.solid, bodies.boundary, bodies.outliers, bodies.hull, defects.surface, defects.lines):
            for data in (made.GetPointData(), made.GetCellData(), made.GetFieldData()):
                for array in (data.GetAbstractArray(k) for k in range(data.GetNumberOfArrays())):
                    kind = names.get(array.GetDataTypeAsString(), array.GetDataTypeAsString())
                    self.assertIn(kind, described.get(array.GetName(), ()), array.GetName())

    def test_the_readme_tells_of_those_that_are_something_else(self):
        parsed = arguments.parse(["broken.ply", "solid.vtu", "--hull", "hull.vtu", "--constrained-array", "Some"])[0]
        self.assertEqual((parsed.hull, parsed.constrained_facets_array), ("hull.vtu", "Some"))
        self.assertIn("hull", {field.name for field in fields(insideout.Tetrahedralization)})


def class_of(name: str) -> str:
    """The class that an option of `tetrahedralize` is set on."""
    return "vtkBoundaryLayers" if name in LAYER_OPTIONS else "vtkRobustTetrahedralize"


def made_for(name: str):
    return getattr(insideout, class_of(name))()


class Python(unittest.TestCase):
    """The options of `tetrahedralize`."""

    NO_OPTIONS = {
        "GenerateHull": "a result has both the solid and the hull",
        "BlocksAreBodies": "what a dict of surfaces is",
        "BlocksAtOnce": "the function takes no composite data set but one of bodies",
    }

    def setUp(self):
        self.defaults = properties("vtkRobustTetrahedralize")
        self.all_defaults = {**properties("vtkBoundaryLayers"), **self.defaults}

    def test_each_property_of_the_filter_is_an_option_or_is_left_out_for_a_reason(self):
        named = {option.vtk_property for option in OPTIONS.values()} - {"SeedsData", ""}
        self.assertEqual(named | set(self.NO_OPTIONS), set(self.all_defaults))
        self.assertEqual(named & set(self.NO_OPTIONS), set())

    def test_the_function_has_the_options_with_their_types_and_defaults(self):
        hints = typing.get_type_hints(Options)
        expected = [(name, hints[name], DEFAULTS[name]) for name in OPTIONS]
        hints = typing.get_type_hints(insideout.tetrahedralize)
        surface, *found, output, progress = inspect.signature(insideout.tetrahedralize).parameters.values()
        self.assertEqual([(one.name, hints[one.name], one.default) for one in found], expected)
        self.assertEqual((surface.name, output.name, progress.name), ("surface", "output", "progress"))
        self.assertEqual({one.kind for one in found}, {inspect.Parameter.KEYWORD_ONLY})

    def test_other_functions_that_have_them_have_the_same(self):
        for function in (insideout.check, insideout.resolve, *QUERIES, insideout.draw):
            self.assertIn("scale", inspect.signature(function).parameters)
            for parameter in inspect.signature(function).parameters.values():
                if parameter.name in OPTIONS:
                    self.assertEqual(parameter.default, DEFAULTS[parameter.name], parameter.name)

    def test_the_help_tells_all_and_leaves_no_gap(self):
        for function in (insideout.check, insideout.resolve, insideout.tetrahedralize, insideout.winding_number, insideout.distance, insideout.voxels):
            self.assertNotIn("{", function.__doc__)
        words = " ".join(insideout.tetrahedralize.__doc__.split())
        for name, option in OPTIONS.items():
            self.assertIn(f" {name} {help_of(name)}{option.more_words} ", words)

    def test_defaults_are_those_of_the_class(self):
        for name, option in OPTIONS.items():
            with self.subTest(name):
                if isinstance(option, Switch):
                    self.assertIs(self.all_defaults[option.vtk_property], DEFAULTS[name])
                elif isinstance(option, Choice) and option.vtk_property:
                    constant = constants("vtkRobustTetrahedralize", option.vtk_property)[self.defaults[option.vtk_property]]
                    self.assertEqual(DEFAULTS[name], constant)
                elif not isinstance(option, Dimensions):
                    self.assertIsNone(DEFAULTS[name])
                if isinstance(option, (Number, Order, Count)):
                    self.assertRegex(help_of(name), rf"Default {self.all_defaults[option.vtk_property]:.10g}[.:]")

    def test_values_that_vtk_would_clamp_are_errors_and_no_others(self):
        for name, option in OPTIONS.items():
            made = made_for(name)
            if isinstance(option, Number):
                with self.subTest(name):
                    option.set_on(made, name, option.least)
                    self.assertEqual(option.used_by(made, None), option.least)
                    getattr(owner_of(made, option.vtk_property), "Set" + option.vtk_property)(-HUGE)
                    self.assertEqual(option.used_by(made, None), option.least)
                    for bad in (math.nextafter(option.least, -math.inf), math.inf, math.nan, "much"):
                        with self.assertRaisesRegex(insideout.Error, f"^{name} is "):
                            Options(**{name: bad}).set_on(made)

    def test_counts_have_the_range_of_the_class(self):
        for name, option in OPTIONS.items():
            if isinstance(option, Count):
                with self.subTest(name):
                    self.assertEqual(read_back(class_of(name), option.vtk_property, -99), option.least)
                    self.assertEqual(read_back(class_of(name), option.vtk_property, option.MOST), option.MOST)
                    for bad in (option.least - 1, 1.5, option.MOST + 1, math.nan, "much"):
                        with self.assertRaisesRegex(insideout.Error, f"^{name} is "):
                            Options(**{name: bad}).set_on(made_for(name))

    def test_a_scale_is_above_0_and_no_property(self):
        for bad in (0, -1, math.inf, math.nan, "much"):
            for function in (insideout.check, insideout.resolve, insideout.tetrahedralize):
                with self.assertRaisesRegex(insideout.Error, "^scale is "):
                    function("missing.ply", scale=bad)
        made = Options(scale=0.001).set_on(insideout.vtkRobustTetrahedralize())
        self.assertEqual(values_of(made), self.defaults)
        self.assertEqual((Options().factor(), Options(scale=2).factor()), (1, 2))

    def test_orders_have_the_range_of_the_class(self):
        for name, option in OPTIONS.items():
            if isinstance(option, Order):
                with self.subTest(name):
                    self.assertEqual(read_back(class_of(name), option.vtk_property, -9999), option.least)
                    self.assertEqual(read_back(class_of(name), option.vtk_property, 9999), option.most)
                    for bad in (option.least - 1, option.most + 1, 1.5, "much"):
                        with self.assertRaisesRegex(insideout.Error, f"^{name} is "):
                            Options(**{name: bad}).set_on(made_for(name))

    def test_choices_are_the_constants_of_the_class(self):
        for name, option in OPTIONS.items():
            if isinstance(option, Choice) and option.vtk_property:
                with self.subTest(name):
                    named = constants("vtkRobustTetrahedralize", option.vtk_property)
                    self.assertEqual(list(option.choices), [named[value] for value in sorted(named)])
                    for value, choice in named.items():
                        made = Options(**{name: choice}).set_on(insideout.vtkRobustTetrahedralize())
                        self.assertEqual(values_of(made)[option.vtk_property], value)
                    with self.assertRaisesRegex(insideout.Error, f"^{name} is 'none'; it can be "):
                        Options(**{name: "none"}).set_on(insideout.vtkRobustTetrahedralize())

    def test_each_option_sets_its_property_and_no_other(self):
        for name, option in OPTIONS.items():
            value = example(option)
            if not isinstance(option, (Choice, Scale)) and name != "seeds":
                with self.subTest(name):
                    made = Options(**{name: value}).set_on(made_for(name))
                    implied = {"ConstrainFacets": True} if name == "constrained_facets_array" else {}
                    self.assertEqual(values_of(made), {**properties(class_of(name)), option.vtk_property: value, **implied})

    def test_a_switch_is_no_text(self):
        for name, option in OPTIONS.items():
            if isinstance(option, (Switch, Decision)):
                with self.assertRaisesRegex(insideout.Error, f"^{name} is 'Some'; it must be True or False"):
                    Options(**{name: "Some"}).set_on(insideout.vtkRobustTetrahedralize())

    def test_a_dimension_chooses_the_filter(self):
        square, box = surfaces.polydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]), surfaces.box()
        for surface, asked, expected in ((square, "automatic", True), (square, 3, False), (box, "automatic", False), (box, "2", True)):
            self.assertIs(Options(dimension=asked).is_planar(surface), expected)
        self.assertFalse(Options(thicken=0.1).is_planar(square))
        with self.assertRaisesRegex(insideout.Error, "^dimension is '4'; it can be "):
            Options(dimension=4).is_planar(box)


BODIES = {"body_array": "Part"}
TAKEN_BY = {
    **{"thicken_all": {"thicken": 0.5}, "priority": BODIES, "region_rule": BODIES, "touch_tolerance": BODIES, "seeded_regions": {"seeds": "seeds.csv"}},
    **dict.fromkeys(("surface_tolerance", "feature_angle"), {"surface_treatment": "remeshed"}),
}
"""The options without which others cannot matter."""


class CommandLine(unittest.TestCase):
    def parse(self, *given):
        return Options.among(vars(arguments.parse(["broken.ply", "solid.vtu", *given])[0]))

    def test_it_has_each_option(self):
        for name, option in OPTIONS.items():
            value = example(option)
            given = [flag_of(name), *([] if value is True else [str(value)])]
            with self.subTest(name):
                others = TAKEN_BY.get(name, {})
                more = [word for other, text in others.items() for word in (flag_of(other), str(text))]
                self.assertEqual(self.parse(*given, *more), Options(**{name: value}, **others))

    def test_earlier_names_of_options_are_known_and_not_told(self):
        for name, flags in OTHER_FLAGS.items():
            for flag in flags:
                self.assertNotIn(f" {flag} ", screen_of("mesh", everything=True) if flag.startswith("--") else "")
                if name in OPTIONS:
                    value = example(OPTIONS[name])
                    self.assertEqual(self.parse(flag, *([] if value is True else [str(value)])), Options(**{name: value}))

    def test_names_of_choices_have_no_spaces(self):
        for name, option in OPTIONS.items():
            if isinstance(option, Choice):
                self.assertNotIn(" ", "".join(option.choices), name)

    def test_it_leaves_what_is_not_given_to_the_filter(self):
        self.assertEqual(self.parse(), Options())


class Everywhere(unittest.TestCase):
    """Properties of several classes are described the same in each, except for what is special to a class."""

    OTHER_WORDS = {
        ("vtkRobustTriangulate", "GenerateHull"): "fills two outputs",
        ("vtkRobustTriangulate", "Refine"): "makes triangles",
        ("vtkRobustTriangulate", "TagArrayName"): "leaves the details to vtkRobustTetrahedralize",
        ("vtkSolidWriter", "FileName"): "is written",
    }

    def test_defaults(self):
        known = properties("vtkRobustTetrahedralize")
        for class_name in CLASSES:
            for name, default in properties(class_name).items():
                if name in known:
                    self.assertEqual(default, known[name], f"{class_name} {name}")

    def test_a_statistic_that_is_called_as_an_option_keeps_its_name(self):
        self.assertIn("The statistic PartsApart counts", words_of(property_elements(proxies()["vtkRobustTetrahedralize"])["PartsApart"]))
        words = "Apart. The statistic PartsApart counts what PartsApart makes."
        with patch.dict(OPTIONS, parts_apart=replace(OPTIONS["parts_apart"], words=words)):
            self.assertEqual(help_of("parts_apart", flag_of), "Apart. The statistic PartsApart counts what --parts-apart makes.")

    def test_words(self):
        known = {}
        for class_name, proxy in sorted(proxies().items()):
            for name, element in property_elements(proxy).items():
                if (class_name, name) not in self.OTHER_WORDS:
                    self.assertEqual(words_of(element), known.setdefault(name, words_of(element)), f"{class_name} {name}")


if __name__ == "__main__":
    unittest.main()

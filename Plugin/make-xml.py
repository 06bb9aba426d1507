# SPDX-License-Identifier: GPL-3.0-or-later
"""Write what ParaView reads of a filter: its XML, with the options as the headers of the classes declare them.

    make-xml.py FILTERS IN.xml OUT.xml

FILTERS is the folder of the headers. IN.xml is ParaView's, but for three elements of a proxy:

    <Option name="Sigma" />       an option of the proxy's class becomes a property with its range, default and words
    <Stage name="Refinement" />   a proxy of the group inside_out_stages, in a file beside IN.xml, becomes a subproxy whose
                                  options are exposed, except those that the attribute `except` names
    <PanelGroup name="Output" />     becomes the group of all properties that have this attribute `group`

Other attributes: `label`; `panel`, the visibility; `if`, as "Refine 1", shows a property where another one has a value; `as`
is the name that states know; `of` the class that declares an option that its filter forwards; `texts` are the entries of an enumeration; `input` has the arrays that an option chooses from.
"""

from __future__ import annotations

import re
import sys
import xml.etree.ElementTree as ElementTree
from functools import lru_cache
from pathlib import Path
from xml.etree.ElementTree import Element, SubElement

ELEMENTS = {"bool": "Int", "int": "Int", "double": "Double", "string": "String"}


def expanded(filters: Path, source: Path) -> ElementTree.ElementTree:
    """The XML that ParaView reads."""
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(filters / "CMake"))
    from declared_options import options_of

    options = {header.stem: options_of(header) for header in sorted(filters.glob("vtk*.h"))}
    words = Words([one for of_class in options.values() for one in of_class.values()])
    tree = ElementTree.parse(source)
    for proxy in tree.iter():
        members: dict[str, list[str]] = {}
        panel = {group.get("name") for group in proxy.findall("PanelGroup")}
        for at, element in enumerate(list(proxy)):
            if element.tag == "Option":
                of, name = element.get("of", proxy.get("class", "")), element.get("name", "")
                if name not in options.get(of, {}):
                    sys.exit(f"{source}: {of}.h declares no option {name}")
                if panel and element.get("group", "") not in panel:
                    sys.exit(f"{source}: the option {name} is in no PanelGroup")
                proxy[at] = property_of(element, options[of][name], words)
                members.setdefault(element.get("group", ""), []).append(proxy[at].get("name", ""))
            elif element.tag == "Stage":
                proxy[at], exposed = subproxy_of(element, source.parent, options, proxy.get("label", ""))
                for group, names in exposed.items():
                    members.setdefault(group, []).extend(names)
        for element in proxy.findall("PanelGroup"):
            fill_group(element, members)
        if proxy.get("class") in options:
            proxy.insert(0, name_in_messages(proxy))
    ElementTree.indent(tree)
    return tree


def property_of(element: Element, option, words: Words) -> Element:
    """The property of an option."""
    name, label = element.get("as", option.name), element.get("label", label_of(option.name))
    made = Element(f"{ELEMENTS[option.kind]}VectorProperty", name=name, command=f"Set{option.name}", number_of_elements="1")
    made.set("default_values", option.default)
    if label != name:
        made.set("label", label)
    if "panel" in element.attrib:
        made.set("panel_visibility", element.get("panel", ""))
    hints = Element("Hints")
    if option.kind == "bool":
        SubElement(made, "BooleanDomain", name="bool")
    elif option.constants:
        domain = SubElement(made, "EnumerationDomain", name="enum")
        texts = element.get("texts", ",".join(text_of(choice) for choice in option.choices().values())).split(",")
        for value, text in zip(option.choices(), texts, strict=True):
            SubElement(domain, "Entry", value=str(value), text=text)
    elif option.kind != "string":
        limits = {key: f"{float(limit):g}" for key, limit in (("min", option.least), ("max", option.most)) if limit}
        SubElement(made, f"{ELEMENTS[option.kind]}RangeDomain", name="range", **limits)
    elif "input" in element.attrib:
        domain = SubElement(made, "ArrayListDomain", name="array_list", none_string="")
        SubElement(SubElement(domain, "RequiredProperties"), "Property", name=element.get("input", ""), function="Input")
        SubElement(hints, "NoDefault")
    add_condition(hints, element)
    if len(hints):
        made.append(hints)
    SubElement(made, "Documentation").text = words.of(option)
    return made


def name_in_messages(proxy: Element) -> Element:
    """What lets the messages of a filter begin with its label. It is no option, and no state has it."""
    made = Element("StringVectorProperty", name="ObjectName", command="SetObjectName", number_of_elements="1")
    made.attrib.update(default_values=proxy.get("label", proxy.get("name", "")), panel_visibility="never", is_internal="1")
    if "base_proxyname" in proxy.attrib:
        made.set("override", "1")
    SubElement(made, "Documentation").text = "The name that messages begin with."
    return made


def subproxy_of(stage: Element, folder: Path, options, label: str) -> tuple[Element, dict[str, list[str]]]:
    """The subproxy of a stage, and the properties that it exposes, by their groups."""
    name = stage.get("name", "")
    made = Element("SubProxy", command=f"Set{name}")
    SubElement(made, "Proxy", name=name, proxygroup="inside_out_stages", proxyname=name)
    exposed, members = SubElement(made, "ExposedProperties"), {}
    SubElement(exposed, "Property", name="ObjectName", exposed_name=f"{name}ObjectName", default_values=label, panel_visibility="never")
    proxy = stage_proxies(folder)[name]
    for element in proxy.iterfind("Option"):
        if element.get("name") in stage.get("except", "").split():
            continue
        shown = SubElement(exposed, "Property", name=element.get("as", element.get("name", "")))
        shown.set("panel_visibility", element.get("panel", "default"))
        members.setdefault(element.get("group", ""), []).append(shown.get("name", ""))
        hints = Element("Hints")
        add_condition(hints, stage)
        add_condition(hints, element)
        if len(hints):  # ParaView then forgets the default of what is exposed
            shown.set("default_values", options[proxy.get("class", "")][element.get("name", "")].default)
            shown.append(hints)
    return made, members


@lru_cache
def stage_proxies(folder: Path) -> dict[str, Element]:
    files = [ElementTree.parse(file) for file in sorted(folder.glob("*.xml"))]
    return {proxy.get("name", ""): proxy for file in files for proxy in file.iterfind("ProxyGroup[@name='inside_out_stages']/Proxy")}


def add_condition(hints: Element, element: Element) -> None:
    """Show a property only where another has a value."""
    if "if" in element.attrib:
        other, *values = element.get("if", "").split()
        shown = {"value": values[0]} if len(values) == 1 else {"values": " ".join(values)}
        SubElement(hints, "PropertyWidgetDecorator", type="GenericDecorator", mode="visibility", property=other, **shown)


def fill_group(group: Element, members: dict[str, list[str]]) -> None:
    name = group.attrib.pop("name")
    panel = group.attrib.pop("panel", None)
    group.tag, group.attrib = "PropertyGroup", {"label": group.get("label", name)}
    if panel:
        group.set("panel_visibility", panel)
    for member in members[name]:
        SubElement(group, "Property", name=member)


def label_of(name: str) -> str:
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", name)


def text_of(choice: str) -> str:
    return choice.replace("-", " ").title()


class Words:
    """The words of headers, as the panel has them: the entries of enumerations and labels instead of constants and names."""

    def __init__(self, options):
        self.names = {option.name: label_of(option.name) for option in options}
        for option in options:
            self.names.update({name: text_of(option.choices()[value]) for name, value in option.constants.items()})

    def of(self, option) -> str:
        text = re.sub(r"(?<=[A-Z]) \(\d\)", "", option.words)
        # A statistic may be called as an option is, and keeps its name.
        return re.sub(r"(?<!\bstatistic )\b\w+\b", lambda found: self.names.get(found[0], found[0]), text)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    made = expanded(Path(sys.argv[1]), Path(sys.argv[2]))
    made.write(sys.argv[3], encoding="utf-8", xml_declaration=True)

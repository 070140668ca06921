# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Descriptions of the filters for ParaView, from the tables of properties and of panels.

Usage, in builds of the compiled plugin: paraview_xml.py OUTPUT [CLASSES TO EXCLUDE]"""

import json
import pathlib
import re
import sys
from xml.etree import ElementTree

_FOLDER = pathlib.Path(__file__).resolve().parent
# Labels, groups and default visibility. "properties" and "ports" of a filter extend those
# of its base classes, which extend those of all filters.
_PANELS = json.loads((_FOLDER / "paraview_panels.json").read_text(encoding="utf-8"))
_TAGS = {"bool": "Int", "int": "Int", "id": "IdType", "ids": "IdType", "string": "String"}
_ANY_SOURCE = (
    '<ProxyGroupDomain name="groups"><Group name="sources" /><Group name="filters" />'
    "</ProxyGroupDomain>"
)
_INPUT = """<InputProperty command="SetInputConnection" name="Input">{any_source}
<DataTypeDomain composite_data_supported="{blocks}" name="input_type">
<DataType value="vtkPolyData" /></DataTypeDomain>
<InputArrayDomain attribute_type="point" name="input_array" number_of_components="1" optional="1" />
<Documentation>A surface of polygons or triangle strips. Polygons are cut into triangles. Use
Extract Surface on volumes.</Documentation></InputProperty>"""
_LENGTH = """<BoundsDomain mode="scaled_extent" name="range" scale_factor="0.1"><RequiredProperties>
<Property function="Input" name="Input" /></RequiredProperties></BoundsDomain>"""
_ARRAYS = """<ArrayListDomain attribute_type="Any" name="array_list" none_string="{none}">
<RequiredProperties><Property function="Input" name="Input" /></RequiredProperties>
</ArrayListDomain>"""
# Properties of isolines that have several elements. The first element of the default of
# SelectInputScalars, an index that is read as 0, is the name that ParaView selects while the arrays
# of the input are unknown.
_ISOLINES = """<Properties>
<DoubleVectorProperty animateable="1" command="SetValue" label="Distances" name="Values"
number_of_elements="0" repeat_command="1" set_number_command="SetNumberOfContours" use_index="1">
<ArrayRangeDomain default_mode="mid" name="range"><RequiredProperties>
<Property function="Input" name="Input" />
<Property function="ArraySelection" name="SelectInputScalars" />
</RequiredProperties></ArrayRangeDomain>
<Documentation>Distances of the isolines, in units of the coordinates. Values outside of the range
of the distances have no isolines.</Documentation>
<Hints><AllowRestoreDefaults /></Hints></DoubleVectorProperty>
<StringVectorProperty animateable="0" command="SetInputArrayToProcess"
default_values="GeodesicDistance;0;0;0;GeodesicDistance" default_values_delimiter=";"
element_types="0 0 0 0 2" label="Contour By" name="SelectInputScalars" number_of_elements="5">
<ArrayListDomain attribute_type="Scalars" name="array_list"><RequiredProperties>
<Property function="Input" name="Input" /></RequiredProperties></ArrayListDomain>
<Documentation>Point array of distances.</Documentation></StringVectorProperty></Properties>"""


def configuration(table, python_module=None, without=()):
    """Returns the XML of all filters, with classes of a Python module or, for None, compiled ones."""
    root = ElementTree.Element("ServerManagerConfiguration")
    group = ElementTree.SubElement(root, "ProxyGroup", name="filters")
    for name, entry in table.items():
        if "inputs" in entry and name not in without:
            group.append(_proxy(table, name, python_module))
    handles = ElementTree.parse(_FOLDER / "paraview_handles.xml").getroot()
    root.extend(handles)
    return ElementTree.tostring(root, encoding="unicode")


def _proxy(table, name, python_module):
    """Returns the element of a filter."""
    panel = _PANELS["filters"][name]
    proxy = ElementTree.Element("SourceProxy", name=panel["name"], label=panel["label"])
    proxy.set("class", f"{python_module}.{name}" if python_module else name)
    if python_module:
        proxy.set("si_class", "vtkSIPythonSourceProxy")
    summary = table[name]["doc"]
    _add_text(proxy, panel["doc"]).set("short_help", f"{summary[0].upper()}{summary[1:]}.")
    _add(proxy, _INPUT.format(any_source=_ANY_SOURCE, blocks=int(not python_module)))
    parts = {}
    for port, described in _merged(table, name, "ports").items():
        if port in table[name]["inputs"]:
            parts[port] = _port(port, described)
    panels = _merged(table, name, "properties")
    for key, described in _properties(table, name).items():
        shown = panels.get(key, {})
        if not shown.get("is_hidden") and not (python_module and shown.get("is_compiled")):
            parts[key] = _property(key, described, shown)
    for key in panel["visible"]:
        if key == "Isolines":
            proxy.extend(ElementTree.fromstring(_ISOLINES))
        else:
            proxy.append(parts.pop(key))
    for part in parts.values():
        part.set("panel_visibility", "advanced")
        proxy.append(part)
    for index, output in enumerate(panel.get("outputs", ())):
        ElementTree.SubElement(proxy, "OutputPort", index=str(index), name=output)
    hints = ElementTree.SubElement(proxy, "Hints")
    menu = ElementTree.SubElement(hints, "ShowInMenu", category="Geodesics")
    if not python_module:  # icons are resources of the compiled plugin
        menu.set("icon", f":/Geodesics/{panel['name']}.svg")
        menu.set("show_in_toolbar", "1")
    ElementTree.SubElement(hints, "Visibility", replace_input=str(panel.get("replaces_input", 0)))
    return proxy


def _classes(table, name):
    """Returns the names of a class and its bases, bases first."""
    base = table[name].get("base")
    return [*(_classes(table, base) if base else ()), name]


def _merged(table, name, key):
    """Returns the panel entries of the properties or ports of a filter."""
    found = {item: dict(described) for item, described in _PANELS[key].items()}
    for kind in _classes(table, name):
        for item, described in _PANELS["filters"].get(kind, {}).get(key, {}).items():
            found[item] = {**found.get(item, {}), **described}
    return found


def _properties(table, name):
    """Returns the properties of a filter, those of its class first."""
    found = {}
    for kind in reversed(_classes(table, name)):
        found.update((k, v) for k, v in table[kind].get("properties", {}).items() if k not in found)
    return found


def _port(port, described):
    """Returns the element of an input port other than the first."""
    element = ElementTree.Element("InputProperty", command=f"Set{port}Connection")
    element.set("name", described.get("name", port))
    if "label" in described:
        element.set("label", described["label"])
    _add(element, _ANY_SOURCE)
    if "handles" in described:
        group, default = described["handles"].split("/")
        domain = f'<Group default="{default}" name="{group}" />'
        _add(element, f'<ProxyListDomain name="proxy_list">{domain}</ProxyListDomain>')
    else:
        kind = '<DataType value="vtkPolyData" />'
        _add(element, f'<DataTypeDomain name="input_type">{kind}</DataTypeDomain>')
    _add_text(element, described["doc"])
    if described.get("is_optional"):
        _add(element, "<Hints><Optional /></Hints>")
    return element


def _property(name, described, shown):
    """Returns the element of a property."""
    kind = described["type"]
    element = ElementTree.Element(f"{_TAGS.get(kind, 'Double')}VectorProperty", name=name)
    if kind == "ids":
        element.set("command", f"Add{name[:-1]}")
        element.set("clean_command", f"RemoveAll{name}")
        element.set("repeat_command", "1")
        element.set("number_of_elements_per_command", "1")
    else:
        default = shown.get("default", described["default"])
        values = default if isinstance(default, list) else [default]
        element.set("command", f"Set{name}")
        element.set("number_of_elements", str(len(values)))
        values = [int(v) if kind == "bool" else v for v in values]
        element.set("default_values", " ".join(map(str, values)))
    _add_domain(element, described, shown)
    _add_text(element, shown.get("doc", described.get("doc") or "Ids of points.").replace("`", ""))
    hints = ElementTree.SubElement(element, "Hints")
    if shown.get("is_length"):
        ElementTree.SubElement(hints, "NoDefault")
    for other, values in shown.get("if", {}).items():
        decorator = ElementTree.SubElement(hints, "PropertyWidgetDecorator", mode="visibility")
        decorator.attrib.update(type="GenericDecorator", property=other, values=values)
    return element


def _add_domain(element, described, shown):
    """Adds the values that a property may have."""
    kind = described["type"]
    if kind == "bool":
        ElementTree.SubElement(element, "BooleanDomain", name="bool")
    elif "choices" in described:
        domain = ElementTree.SubElement(element, "EnumerationDomain", name="enum")
        for choice, value in described["choices"].items():
            words = re.sub("(?<!^)(?=[A-Z])", " ", choice).capitalize()
            text = shown.get("choices", {}).get(choice, words)
            ElementTree.SubElement(domain, "Entry", text=text, value=str(value))
    elif shown.get("is_length"):
        _add(element, _LENGTH)
    elif shown.get("is_input_array"):
        _add(element, _ARRAYS.format(none=described["default"]))
    elif kind in ("int", "double"):
        low, high = described.get("range", (0, None))
        domain = ElementTree.SubElement(element, f"{_TAGS.get(kind, 'Double')}RangeDomain")
        domain.attrib.update(name="range", min=str(shown.get("minimum", low)))
        high = shown.get("maximum", high)
        if high is not None and high < 2**31 - 1:
            domain.set("max", str(high))


def _add(parent, text):
    parent.append(ElementTree.fromstring(text))


def _add_text(parent, text):
    element = ElementTree.SubElement(parent, "Documentation")
    element.text = text
    return element


if __name__ == "__main__":
    TABLE = json.loads((_FOLDER / "property_table.json").read_text(encoding="utf-8"))
    pathlib.Path(sys.argv[1]).write_text(
        configuration(TABLE, without=sys.argv[2:]), encoding="utf-8"
    )

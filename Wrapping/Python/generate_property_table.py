#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes property_table.json: ports, properties and values of all filters, by introspection of the
compiled classes.

Run it with the Python of a build with point clouds after a header of a filter has changed:
bin/vtkdgg-python Wrapping/Python/generate_property_table.py Wrapping/Python/property_table.json
"""

import json
import re
import sys

import vtkdgg
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

TYPES = {
    "bool": "bool",
    "int": "int",
    "vtkIdType": "id",
    "vtkTypeInt64": "id",
    "double": "double",
    "const char": "string",
}


def table():
    """Returns a dict of the filters that the package has, bases first."""
    root = vtkdgg.vtkGeodesicAlgorithm
    kinds = [getattr(vtkdgg, name) for name in sorted(dir(vtkdgg))]
    kinds = [kind for kind in kinds if isinstance(kind, type) and issubclass(kind, root)]
    made = {}
    for kind in kinds:
        try:
            made[kind] = kind()
        except TypeError:  # abstract
            continue
    found = {}
    for kind in sorted(kinds, key=lambda kind: (len(kind.__mro__), kind.__name__)):
        instance = made.get(kind) or next(made[k] for k in made if issubclass(k, kind))
        found[kind.__name__] = describe(kind, instance, kind in made, found)
    return found


def describe(kind, instance, is_concrete, bases):
    """Returns the entry of a class without the members of its base."""
    base = kind.__mro__[1].__name__
    own = vars(kind)
    constants = {n: int(v) for n, v in own.items() if isinstance(v, int) and n[0].isupper()}
    base = base if base in bases else None
    entry = {"base": base, "doc": sentence(kind), "constants": constants, "properties": {}}
    entry["values"] = {}
    doc = ""
    for method, function in own.items():
        # Functions without documentation share the one of the previous function.
        doc = documentation(function) or doc
        described = describe_property(kind, instance, method[3:]) if method[:3] == "Set" else None
        if described:
            entry["properties"][method[3:]] = {**described, "doc": doc}
        elif is_result(kind, method):
            value = call(getattr(instance, method))
            if isinstance(value, (bool, int, float, str)):
                entry["values"][method[3:]] = {"default": value, "doc": doc}
    entry["defaults"] = overridden(base, instance, bases)
    if is_concrete:
        entry["inputs"] = inputs(kind)
        entry["outputs"] = outputs(kind)
    return {key: value for key, value in entry.items() if value != {}}


def describe_property(kind, instance, name):
    """Returns type, default, range and choices of a property, None for other functions."""
    if name.endswith("Ids"):
        return {"type": "ids"}
    getter = getattr(instance, f"Get{name}", None)
    value = call(getter)
    signature = rf"C\+\+: .*?\bSet{name}\((.*?) ?\*?\w+\)"
    found = re.search(signature, getattr(kind, f"Set{name}").__doc__, re.DOTALL)
    declared = "vector" if isinstance(value, tuple) else TYPES.get(found and found[1])
    if declared is None:
        return None
    described = {"type": declared, "default": value}
    if hasattr(instance, f"Get{name}MinValue"):
        described["range"] = [getattr(instance, f"Get{name}{end}Value")() for end in ("Min", "Max")]
    choices = {}
    for setter in (s for s in vars(kind) if s.startswith(f"Set{name}To")):
        getattr(instance, setter)()
        choices[setter[len(name) + 5 :]] = getter()
    if choices:
        getattr(instance, f"Set{name}")(value)
        described["choices"] = choices
    return described


def is_result(kind, method):
    """Returns true if a function may return a result of an update."""
    others = "AsString$|M..Value$|^GetNumberOf.*Ids$|^GetMTime$"
    is_getter = method.startswith("Get") and not re.search(others, method)
    return is_getter and not hasattr(kind, f"S{method[1:]}")


def overridden(base, instance, bases):
    """Returns the defaults that differ from those of the base."""
    found = {}
    while base:
        for name, described in bases[base].get("properties", {}).items():
            value = call(getattr(instance, f"Get{name}", None))
            default = described.get("default")
            if value != default and value == value:  # not NaN
                found[name] = value
        base = bases[base]["base"]
    return found


def inputs(kind):
    """Returns the names of the input ports; None for the first."""
    names = [None] * kind().GetNumberOfInputPorts()
    producer = vtkTrivialProducer()
    for method in dir(kind):
        match = re.fullmatch("Set(.+)Connection", method)
        instance = kind()
        if match and match[1] != "Input":
            getattr(instance, method)(producer.GetOutputPort())
            counts = [instance.GetNumberOfInputConnections(i) for i in range(len(names))]
            names[counts.index(1)] = match[1]
    return names


def outputs(kind):
    """Returns type and functions of each output port."""
    instance = kind()
    found = []
    for port in range(instance.GetNumberOfOutputPorts()):
        kept = instance.GetOutputPortInformation(port).Get(vtkDataObject.DATA_TYPE_NAME())
        is_mesh = kept == "vtkDataObject"  # as the input
        found.append({"type": "vtkPolyData" if is_mesh else kept, "get": [], "get_port": []})
    own = {n for k in kind.__mro__ if k.__module__.startswith("vtkdgg") for n in vars(k)}
    for method in sorted(n for n in own if n.startswith("Get") and n != "GetOutput"):
        value = call(getattr(instance, method))
        if hasattr(value, "GetIndex") and value.IsA("vtkAlgorithmOutput"):
            found[value.GetIndex()]["get_port"].append(method)
        for port, output in enumerate(found):
            if value is not None and value is instance.GetOutputDataObject(port):
                output["get"].append(method)
    return found


def call(function):
    """Returns the result of a function without arguments, None if there is none."""
    try:
        return function()
    except TypeError:
        return None


def documentation(function):
    """Returns the documentation of a function as one line, without its signatures."""
    paragraphs = (function.__doc__ or "").strip().split("\n\n")[1:]
    return " ".join(" ".join(paragraphs).split())


def sentence(kind):
    """Returns the purpose of the class."""
    return " ".join(kind.__doc__.split("\n\n")[0].split(" - ", 1)[1].split())


def formatted(entries):
    """Returns the table as JSON with a line for each property."""
    lines = []
    for name, entry in entries.items():
        parts = []
        for key, value in entry.items():
            if key in ("properties", "values") and value:
                rows = (f"   {json.dumps(k)}: {json.dumps(v)}" for k, v in value.items())
                parts.append(f'  "{key}": {{\n' + ",\n".join(rows) + "\n  }")
            else:
                parts.append(f'  "{key}": {json.dumps(value)}')
        lines.append(f' "{name}": {{\n' + ",\n".join(parts) + "\n }")
    return "{\n" + ",\n".join(lines) + "\n}\n"


if __name__ == "__main__":
    if "vtkPointCloudDGG" not in vtkdgg.build_info.CLASSES:
        sys.exit("The package was built without point clouds. Configure it with DGG_WITH_PCL=ON.")
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(formatted(table()))

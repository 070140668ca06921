# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Type stubs of wrapped modules, from the signatures that VTK's wrappers put into docstrings; of the
Python filters, from the table of properties; of the package; and of Python sources whose functions
return different types, with overloads.

Usage: generate_stubs.py FOLDER MODULE... SOURCE.py...

Writes FOLDER/MODULE.pyi and FOLDER/SOURCE.pyi. Other Python sources have annotations of their own.
FOLDER contains build_info.py.
"""

import ast
import copy
import importlib
import json
import keyword
import os
import re
import runpy
import sys
from collections import defaultdict

# Modules with the classes of VTK that occur in signatures.
VTK_MODULES = (
    "vtkCommonCore",
    "vtkCommonDataModel",
    "vtkCommonExecutionModel",
    "vtkIOCore",
    "vtkParallelCore",
)
ARGUMENT = re.compile(r"(\w+)(?::(\([^)]*\)|\[[^\]]*\]|[\w.]+))?(=[^,]+)?(?:, *|$)")


class Stub:
    """The stub of one module."""

    def __init__(self, name):
        self.module = importlib.import_module(f"vtkdgg.{name}")
        self.imports = defaultdict(set)
        self.classes = {k: v for k, v in vars(self.module).items() if isinstance(v, type)}

    def text(self):
        """Returns the text of the stubs."""
        # Base classes first.
        order = sorted(self.classes.values(), key=lambda c: (len(c.__mro__), c.__name__))
        body = "\n\n".join("\n".join(self.of_class(kind)) for kind in order)
        imports = [
            f"from {module} import {', '.join(sorted(names))}"
            for module, names in sorted(self.imports.items())
        ]
        typing = "from typing import Any, MutableSequence, Sequence, Tuple, overload"
        return "\n".join([typing, "", *imports, "", "", body, ""])

    def of_class(self, kind):
        """Returns the lines of a class."""
        lines = [f"class {kind.__name__}({self.known(kind.__bases__[0].__name__)}):"]
        for name, value in vars(kind).items():
            if name.startswith("_"):
                continue
            if isinstance(value, type):  # an enumeration
                lines.append(f"    class {name}(int): ...")
            elif isinstance(value, int):
                lines.append(f"    {name}: {self.of_constant(kind, value)}")
            else:
                lines += self.of_method(name, value)
        return lines + (["    ..."] if len(lines) == 1 else [])

    def of_constant(self, kind, value):
        """Returns the type of a constant."""
        own = type(value).__name__
        return f"{kind.__name__}.{own}" if isinstance(vars(kind).get(own), type) else "int"

    def of_method(self, name, method):
        """Returns the lines of a method, one for each of its signatures.

        Signatures that differ only in types are combined: where VTK has no stubs, its classes are
        Any, and the second of two such overloads would never match.
        """
        text = re.sub(r"\n\s+", " ", method.__doc__ or "")
        found = re.findall(rf"^{name}\((.*?)\)(?: -> (.+))?\nC\+\+:", text, re.M)
        signatures = defaultdict(list)  # types of arguments by names, defaults and result
        for arguments, result in found or [("self", "Any")]:
            names, types, defaults = zip(*(ARGUMENT.findall(arguments) or [("", "", "")]))
            returned = self.of_type(result, "Tuple") if result else "None"
            signatures[names, defaults, returned].append(types)
        lines = []
        for (names, defaults, returned), types in signatures.items():
            if len(signatures) > 1:
                lines.append("    @overload")
            if names[0] != "self":
                lines.append("    @staticmethod")
            given = ", ".join(map(self.of_argument, names, zip(*types), defaults))
            lines.append(f"    def {name}({given}) -> {returned}: ...")
        return lines

    def of_argument(self, name, kinds, default):
        """Returns one argument, which has one of these types."""
        name += "_" if keyword.iskeyword(name) else ""
        known = dict.fromkeys(self.of_type(kind, "Sequence") for kind in kinds if kind)
        annotation = f": {' | '.join(known)}" if known else ""
        return name + annotation + (" = ..." if default else "")

    def of_type(self, text, sequence):
        """Returns a type: (int, ...) is a sequence that is read, [int, ...] one that is written."""
        if text[0] not in "([":
            return self.known(text)
        parts = re.findall(r"\w+", text)
        if text[0] == "[":
            return f"MutableSequence[{parts[0]}]"
        if sequence == "Tuple":
            return f"Tuple[{parts[0]}, ...]" if "..." in text else f"Tuple[{', '.join(parts)}]"
        return f"Sequence[{parts[0]}]"

    def known(self, name):
        """Returns the name of a type, and imports classes of other modules."""
        if name in self.classes or name in ("None", "bool", "float", "int", "str"):
            return name
        for module in (f"vtkmodules.{m}" for m in VTK_MODULES):
            if hasattr(importlib.import_module(module), name):
                self.imports[module].add(name)
                return name
        for module in (n for n in list(sys.modules) if n.startswith("vtkdgg.vtkDGG")):
            if hasattr(sys.modules[module], name):
                self.imports["." + module.rpartition(".")[2]].add(name)
                return name
        return "Any"


class Overloads(ast.NodeTransformer):
    """Removes bodies and private names, and gives functions that return a Union an overload for
    each type.

    `as_polydata=True` returns the vtkPolyData, `return_source=True` the tuple.
    """

    def visit_Module(self, node):
        """Adds imports to the stub of a module."""
        self.generic_visit(node)
        typing = ast.parse("from typing import Any, Literal, overload").body
        future = [i for i, part in enumerate(node.body) if isinstance(part, ast.ImportFrom)][0]
        node.body[future + 1 : future + 1] = typing
        return node

    def visit_ImportFrom(self, node):
        """Skips private modules."""
        node.names = [alias for alias in node.names if alias.name[0] != "_"]
        return node if node.names else None

    def visit_If(self, node):
        """Keeps imports for type checkers without their condition."""
        return node.body

    def visit_Assign(self, node):
        """Removes constants, of which none is public."""
        return None

    visit_Expr = visit_Assign  # removes docstrings

    def visit_ClassDef(self, node):
        """Gives a class that has only a docstring a body. Skips private classes."""
        if node.name.startswith("_"):
            return None
        self.generic_visit(node)
        node.body = node.body or [ast.Expr(ast.Constant(...))]
        return node

    def visit_FunctionDef(self, node):
        """Returns the signature, or one for each type that is returned."""
        if node.name.startswith("_") and not node.name.startswith("__"):
            return None
        node.body = [ast.Expr(ast.Constant(...))]
        checks = "arguments.with_flags"
        node.decorator_list = [d for d in node.decorator_list if ast.unparse(d) != checks]
        others = filter(None, (node.args.vararg, node.args.kwarg))
        for argument in [*node.args.args, *node.args.kwonlyargs, *others]:
            if argument.arg not in ("self", "cls"):
                argument.annotation = argument.annotation or ast.Name("Any")
        node.returns = node.returns or ast.Name("Any")
        names = [argument.arg for argument in node.args.kwonlyargs]
        if "as_polydata" not in names:
            return node
        kinds = node.returns.slice.elts
        first, *others, polydata = kinds
        found = [self._with(node, polydata, as_polydata=True)]
        for other in others:
            found.append(self._with(node, other, return_source=True, as_polydata=False))
        flags = {"return_source": False} if others else {}
        found.append(self._with(node, first, **flags, as_polydata=False))
        return [*found, self._with(node, node.returns)]  # values unknown to the checker

    @staticmethod
    def _with(node, returned, **flags):
        """Returns the overload for these values of arguments; a true one has no default."""
        node = copy.deepcopy(node)
        node.returns = returned
        node.decorator_list.insert(0, ast.Name("overload"))
        for i, argument in enumerate(node.args.kwonlyargs):
            if argument.arg in flags:
                argument.annotation = ast.parse(f"Literal[{flags[argument.arg]}]").body[0].value
                node.args.kw_defaults[i] = None if flags[argument.arg] else ast.Constant(...)
        return node


class FilterStub:
    """The stub of the Python filters. Functions of properties, ports and values come from the
    table, all others from the annotated functions of the sources."""

    SOURCES = ("python_filters", "filter_tasks", "filter_tasks_spectral")
    REMOVER = "Removes all ids and disconnects the input ports of such points."
    HEADER = """from typing import Iterable, Optional, Sequence, Tuple, Union

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdList
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData, vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithmOutput
from vtkmodules.vtkFiltersPython import vtkPythonAlgorithm

"""
    # Types of arguments and results of properties, by their types in the table.
    ARGUMENTS = {
        "string": "value: Optional[str]",
        "vector": "*values: Union[float, Sequence[float]]",
    }
    NUMBERS = {"bool": "bool", "int": "int", "id": "int", "double": "float"}
    RESULTS = {"string": "str", "vector": "Tuple[float, float, float]", **NUMBERS}

    def __init__(self, folder):
        with open(os.path.join(folder, "property_table.json"), encoding="utf-8") as file:
            self.table = json.load(file)
        trees = (parsed(os.path.join(folder, f"{name}.py")) for name in self.SOURCES)
        nodes = [node for tree in trees for node in tree.body]
        self.written = {node.name: node for node in nodes if isinstance(node, ast.ClassDef)}
        self.unavailable = {}  # values that the Python filters do not return

    def text(self):
        """Returns the text of the stub."""
        classes = [self.of_class("PythonFilter", "vtkPythonAlgorithm", {})]
        for name, entry in self.table.items():
            classes.append(self.of_class(name, entry["base"] or "PythonFilter", entry))
        return self.HEADER + "".join(classes)

    def of_class(self, name, base, entry):
        """Returns the text of a class."""
        lines = [f"\nclass {name}({base}):"]
        lines += [f"    {key}: int" for key in entry.get("constants", {})]
        for key, (arguments, returned, doc) in self.functions_of(name, base, entry).items():
            given = f"self, {arguments}" if arguments else "self"
            lines.append(f"    def {key}({given}) -> {returned}:")
            lines.append(f"        {json.dumps(doc)}" if doc else "        ...")
        return "\n".join(lines + ["    ..."] * (len(lines) == 1)) + "\n"

    def functions_of(self, name, base, entry):
        """Returns arguments, result and documentation, which may be None, of functions by name."""
        node = self.written.get(name)
        mixins = [self.written.get(ast.unparse(b)) for b in node.bases] if node else []
        parts = [part for kind in (*mixins, node) if kind for part in kind.body]
        self.unavailable[name] = self.unavailable.get(base, ())
        for part in parts:
            if isinstance(part, ast.Assign) and ast.unparse(part.targets[0]) == "unavailable":
                self.unavailable[name] = ast.literal_eval(part.value)
        found = {}
        for key, described in entry.get("properties", {}).items():
            made = self.of_ids if described["type"] == "ids" else self.of_property
            for function, signature in made(key, described).items():
                is_main = function[1:] in (f"et{key}", f"dd{key[:-1]}")  # not On(), for example
                found[function] = *signature, described["doc"] if is_main else None
        for key, described in entry.get("values", {}).items():
            if key not in self.unavailable[name]:
                kind = type(described["default"]).__name__
                found[f"Get{key}"] = "", kind, described["doc"]
        found.update(self.of_ports(entry))
        for part in parts:
            if isinstance(part, ast.FunctionDef) and part.name[0].isupper() and part.returns:
                arguments = ast.unparse(part.args).partition(", ")[2]
                returned = ast.unparse(part.returns)
                found[part.name] = arguments, returned, ast.get_docstring(part)
            elif isinstance(part, ast.Assign) and ast.unparse(part.value).startswith("remover("):
                found[ast.unparse(part.targets[0])] = "", "None", self.REMOVER
        return found

    def of_property(self, name, described):
        """Returns arguments and results of the functions of a property by name."""
        returned = self.RESULTS[described["type"]]
        argument = self.ARGUMENTS.get(described["type"], f"value: {returned}")
        found = {f"Set{name}": (argument, "None"), f"Get{name}": ("", returned)}
        if described["type"] == "bool":
            found.update({f"{name}{state}": ("", "None") for state in ("On", "Off")})
        if "choices" in described:
            found.update({f"Set{name}To{choice}": ("", "None") for choice in described["choices"]})
            found[f"Get{name}AsString"] = "", "str"
        if "range" in described:
            found.update({f"Get{name}{end}Value": ("", returned) for end in ("Min", "Max")})
        return found

    def of_ids(self, name, _described):
        """Returns arguments and results of the functions of a property with ids by name."""
        return {
            f"Set{name}": ("ids: Union[vtkIdList, Iterable[int], None]", "None"),
            f"Add{name[:-1]}": ("i: int", "None"),
            f"RemoveAll{name}": ("", "None"),
            f"GetNumberOf{name}": ("", "int"),
            f"Get{name[:-1]}": ("i: int", "int"),
        }

    def of_ports(self, entry):
        """Returns arguments, results and no documentation of the functions of ports by name."""
        found = {}
        for name in filter(None, entry.get("inputs", ())):
            argument = "output: Optional[vtkAlgorithmOutput]"
            found[f"Set{name}Connection"] = argument, "None", None
            found[f"Set{name}Data"] = "data: Optional[vtkDataObject]", "None", None
        outputs = entry.get("outputs", ())
        if outputs:
            kinds = {output["type"] for output in outputs}
            returned = kinds.pop() if len(kinds) == 1 else "vtkDataObject"
            found["GetOutput"] = "port: int = 0", returned, None
        for output in outputs:
            found.update({name: ("", output["type"], None) for name in output["get"]})
            found.update({name: ("", "vtkAlgorithmOutput", None) for name in output["get_port"]})
        return found


def parsed(path):
    """Returns the syntax tree of a Python source."""
    with open(path, encoding="utf-8") as file:
        return ast.parse(file.read())


def stub_of_source(path):
    """Returns the stub of a Python source."""
    tree = Overloads().visit(parsed(path))
    return ast.unparse(ast.fix_missing_locations(tree)) + "\n"


def stub_of_package(path, classes):
    """Returns the stub of the package, which lists its names. `classes` are the modules of compiled
    classes by name; other filters are Python filters."""
    tree = parsed(path)
    lists = [n for n in tree.body if ast.unparse(n).startswith("_WITHOUT_VTK =")]
    names = ast.literal_eval(lists[0].value)
    lines = ["from . import compat, distributed, explorer, pictures"]
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and node.level:
            kept = [alias.name for alias in node.names if alias.name in names]
            lines += [f"from .{node.module} import {', '.join(kept)}"] if kept else []
    folder = os.path.dirname(path)
    filters = {name: "python_filters" for name in FilterStub(folder).table}
    served = {"check": "pipeline", **filters, **classes}
    for module in sorted(set(served.values())):
        kept = sorted(name for name in served if served[name] == module)
        lines.append(f"from .{module} import {', '.join(kept)}")
    exported = ["compat", "distributed", "explorer", "pictures", *names, *sorted(served)]
    return "\n".join([*lines, "", "__version__: str", f"__all__ = {exported}", ""])


def main(folder, names):
    """Writes the stubs."""
    classes = runpy.run_path(os.path.join(folder, "build_info.py"))["CLASSES"]
    for name in names:
        if name.endswith(".py"):
            path = name
            name = os.path.splitext(os.path.basename(path))[0]
            if name == "__init__":
                text = stub_of_package(path, classes)
            elif name == "python_filters":
                text = FilterStub(os.path.dirname(path)).text()
            else:
                text = stub_of_source(path)
        else:
            text = Stub(name).text()
        with open(os.path.join(folder, f"{name}.pyi"), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])

# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Type stubs of the wrapped modules, from the signatures that VTK's wrappers put into docstrings, and
of Python sources whose functions return different types, with overloads.

Usage: generate_stubs.py FOLDER MODULE... SOURCE.py...

Writes FOLDER/MODULE.pyi and FOLDER/SOURCE.pyi. Other Python sources have annotations of their own.
"""

import ast
import copy
import importlib
import keyword
import os
import re
import sys
from collections import defaultdict

# Where classes of VTK that occur in signatures come from.
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
        """All of it."""
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
        """The lines of a class."""
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
        """The type of a constant."""
        own = type(value).__name__
        return f"{kind.__name__}.{own}" if isinstance(vars(kind).get(own), type) else "int"

    def of_method(self, name, method):
        """The lines of a method, one for each of its signatures."""
        text = re.sub(r"\n\s+", " ", method.__doc__ or "")
        found = re.findall(rf"^{name}\((.*?)\)(?: -> (.+))?\nC\+\+:", text, re.M)
        lines = []
        for arguments, result in found or [("self, *args", "Any")]:
            if len(found) > 1:
                lines.append("    @overload")
            if not arguments.startswith("self"):
                lines.append("    @staticmethod")
            given = ", ".join(self.of_argument(*part) for part in ARGUMENT.findall(arguments))
            given = given or arguments
            returned = self.of_type(result, "Tuple") if result else "None"
            lines.append(f"    def {name}({given}) -> {returned}: ...")
        return lines

    def of_argument(self, name, kind, default):
        """One argument."""
        name += "_" if keyword.iskeyword(name) else ""
        annotation = f": {self.of_type(kind, 'Sequence')}" if kind else ""
        return name + annotation + (" = ..." if default else "")

    def of_type(self, text, sequence):
        """(int, ...) is a sequence that is read, [int, ...] one that is written."""
        if text[0] not in "([":
            return self.known(text)
        parts = re.findall(r"\w+", text)
        if text[0] == "[":
            return f"MutableSequence[{parts[0]}]"
        if sequence == "Tuple":
            return f"Tuple[{parts[0]}, ...]" if "..." in text else f"Tuple[{', '.join(parts)}]"
        return f"Sequence[{parts[0]}]"

    def known(self, name):
        """The name of a type; classes of other modules are imported."""
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
        typing = ast.parse("from typing import Literal, overload").body
        future = [i for i, part in enumerate(node.body) if isinstance(part, ast.ImportFrom)][0]
        node.body[future + 1 : future + 1] = typing
        return node

    def visit_If(self, node):
        """Keeps imports for type checkers without their condition."""
        return node.body

    def visit_Assign(self, node):
        """Removes constants, of which none is public."""
        return None

    visit_Expr = visit_Assign  # removes docstrings

    def visit_FunctionDef(self, node):
        """Returns the signature, or one for each type that is returned."""
        if node.name.startswith("_") and not node.name.startswith("__"):
            return None
        node.body = [ast.Expr(ast.Constant(...))]
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
        return [*found, self._with(node, node.returns)]  # values that are not known to the checker

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


def stub_of_source(path):
    """Returns the stub of a Python source."""
    with open(path, encoding="utf-8") as file:
        tree = ast.parse(file.read())
    return ast.unparse(ast.fix_missing_locations(Overloads().visit(tree))) + "\n"


def main(folder, names):
    """Write them."""
    for name in names:
        if name.endswith(".py"):
            text = stub_of_source(name)
            name = os.path.splitext(os.path.basename(name))[0]
        else:
            text = Stub(name).text()
        with open(os.path.join(folder, f"{name}.pyi"), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])

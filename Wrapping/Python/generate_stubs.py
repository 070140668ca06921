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


def stub_of_source(path):
    """Returns the stub of a Python source."""
    with open(path, encoding="utf-8") as file:
        tree = ast.parse(file.read())
    return ast.unparse(ast.fix_missing_locations(Overloads().visit(tree))) + "\n"


def main(folder, names):
    """Writes the stubs."""
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

# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stubs for type checkers agree with the package."""

import ast
import importlib
import inspect
import os
import unittest

import vtkdgg
from vtkdgg import build_info, compat, python_filters
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase

FOLDER = os.path.dirname(vtkdgg.__file__)
MODULES = sorted(set(build_info.CLASSES.values()))  # none in a wheel
NAMES = ["check", *vtkdgg._WITHOUT_VTK]
CLASSES = [name for name in NAMES if inspect.isclass(getattr(vtkdgg, name))]
FUNCTIONS = [name for name in NAMES if name not in CLASSES]


def parsed(module):
    """Returns the syntax tree of a stub."""
    with open(os.path.join(FOLDER, f"{module}.pyi"), encoding="utf-8") as file:
        return ast.parse(file.read())


def stub_of(module):
    """Returns the classes of a stub, each with its names."""
    found = {}
    for node in parsed(module).body:
        if isinstance(node, ast.ClassDef):
            found[node.name] = set()
            for part in node.body:
                if isinstance(part, ast.AnnAssign):
                    found[node.name].add(part.target.id)
                elif not isinstance(part, ast.Expr):
                    found[node.name].add(part.name)
    return found


class Stubs(unittest.TestCase):
    def test_wrapped_classes(self):
        for module in MODULES:
            stub = stub_of(module)
            for name, kind in vars(importlib.import_module(f"vtkdgg.{module}")).items():
                if isinstance(kind, type):
                    with self.subTest(name):
                        own = {part for part in vars(kind) if not part.startswith("_")}
                        self.assertEqual(stub[name], own)

    def test_python_filters(self):
        stub = stub_of("python_filters")
        self.assertEqual(set(stub), {"PythonFilter", *python_filters.TABLE})
        of_vtk = set(dir(VTKPythonAlgorithmBase))
        for name, entry in python_filters.TABLE.items():
            if "outputs" in entry:
                kind = python_filters.get(name)
                declared = set().union(*(stub.get(base.__name__, ()) for base in kind.__mro__))
                names = {part for part in dir(kind) if part[0].isupper()}
                with self.subTest(name):
                    self.assertEqual(declared - of_vtk, names - of_vtk)

    def test_names_of_the_package(self):
        tree = parsed("__init__")
        exported = ast.literal_eval(tree.body[-1].value)
        modules = "compat", "distributed", "explorer", "pictures"
        self.assertEqual(set(exported), {*vtkdgg.__all__, *modules})
        imported = {a.name for n in tree.body if isinstance(n, ast.ImportFrom) for a in n.names}
        self.assertEqual(imported, set(exported))

    def test_overloads(self):
        """Arguments that choose the type of the result have an overload each."""
        fields = [
            "vtkPolyData",
            "Tuple[NDArray[np.float64], NDArray[np.intp]]",
            "NDArray[np.float64]",
        ]
        for module, name, returned in (
            ("distances", "distance", fields),
            ("queries", "distance", fields),
            ("queries", "sample", ["vtkPolyData", "Samples"]),
            ("graph", "loop", ["vtkPolyData", "List[Loop]"]),
            ("paths", "path", ["vtkPolyData", "Path"]),
            ("spectral", "interpolate", ["vtkPolyData", "NDArray[np.float64]"]),
        ):
            nodes = ast.walk(parsed(module))
            found = [n for n in nodes if isinstance(n, ast.FunctionDef) and n.name == name]
            with self.subTest(module, name=name):
                self.assertEqual([ast.unparse(node.returns) for node in found[:-1]], returned)
                self.assertRegex(ast.unparse(found[-1].returns), r"\AUnion\[")
                for node, choice in zip(found[:-1], ("True", "False", "False")):
                    flags = {a.arg: ast.unparse(a.annotation) for a in node.args.kwonlyargs}
                    self.assertEqual(flags["as_polydata"], f"Literal[{choice}]")

    def test_marker(self):
        self.assertTrue(os.path.exists(os.path.join(FOLDER, "py.typed")))

    def test_functions_are_annotated(self):
        functions = [getattr(vtkdgg, name) for name in FUNCTIONS]
        for module in (compat.potpourri3d, compat.pygeodesic.geodesic, compat.gdist):
            functions += [getattr(module, name) for name in module.__all__]
        classes = [getattr(vtkdgg, name) for name in CLASSES] + functions
        for kind in {base for c in classes if isinstance(c, type) for base in c.__mro__}:
            if kind.__module__.startswith("vtkdgg"):
                for name, member in vars(kind).items():
                    member = getattr(member, "fget", None) or getattr(member, "__func__", member)
                    if inspect.isfunction(member) and (name == "__init__" or name[0] != "_"):
                        functions.append(member)
        functions = [function for function in functions if not isinstance(function, type)]
        self.assertGreater(len(functions), 50)
        for function in functions:
            with self.subTest(function.__qualname__):
                signature = inspect.signature(function)
                self.assertIsNot(signature.return_annotation, inspect.Signature.empty)
                for name, parameter in signature.parameters.items():
                    if name not in ("self", "cls"):
                        self.assertIsNot(parameter.annotation, inspect.Parameter.empty, name)


if __name__ == "__main__":
    unittest.main()

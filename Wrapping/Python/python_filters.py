# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters for any VTK: Python classes over the kernel, with the names, ports and properties of
the compiled classes. Classes are made from property_table.json on first use.

Annotated functions are in the type stub, which generate_stubs.py makes of the same table."""

from __future__ import annotations

import functools
import math
import operator
import re
from types import SimpleNamespace
from typing import Optional, Union

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkObject, vtkOutputWindow, vtkTimeStamp
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData, vtkTable
from vtkmodules.vtkCommonExecutionModel import (
    vtkAlgorithm,
    vtkDemandDrivenPipeline,
    vtkStreamingDemandDrivenPipeline,
)

from . import _kernel as kernel
from .errors import render
from .property_table import TABLE
from .vtk_input import graph_arrays, read_only, surface_arguments, surface_points
from .vtk_output import vtk_array

USER_ERROR = 40000  # vtkErrorCode::UserError
NO_LIMIT = 1e299  # VTK_DOUBLE_MAX
# Progress when the surface is prepared.
PREPARED = 0.1
# Properties that are not arguments of functions of the kernel.
_FILTER_PROPERTIES = {
    "AcceptCoarserGraph", "GatherLimit", "MemoryLimit", "MergeCoincidentPoints", "MergeTolerance",
    "OutputPointsPrecision",
}  # fmt: skip
# Arguments that are input ports of filters.
_PORTS = {
    "curves": "input port 1", "from_points": "input port 1", "pairs": "input port 1",
    "point_values": "input port 1", "to_points": "input port 2",
}  # fmt: skip
# Properties whose arguments have other names.
_POINTS = {f"{name}s" for name in ("source", "site", "point", "row", "column")}
_POINTS |= {"first_landmarks", "second_landmarks"}
_made = {}


class Aborted(Exception):
    """The update was stopped by an observer."""


class PythonFilter(VTKPythonAlgorithmBase):
    """Base of all filters. Subclasses have a table `properties`, and a function `run` that returns
    the data of all output ports; None for an output that contains only the field data that VTK passes."""

    properties = {}
    input_names = None  # of ports other than the first; None for abstract classes
    output_types = ()
    unavailable = ()  # values in the table that the kernel does not return

    def __init__(self):
        if self.input_names is None:
            raise TypeError(f"{type(self).__name__} is abstract")
        self._values = {name: p.get("default", []) for name, p in self.properties.items()}
        self._explicit = set()
        self._found = {}
        self._surfaces = {}
        self._graph = None  # of the last update
        self._build_time = vtkTimeStamp()
        self._error_code = 0
        super().__init__(
            nInputPorts=len(self.input_names), inputType="vtkPolyData",
            nOutputPorts=len(self.output_types), outputType="vtkPolyData",
        )  # fmt: skip

    def run(self, polydata):
        """Computes the outputs; in subclasses."""
        raise NotImplementedError

    # Algorithm

    def GetClassName(self):
        """Returns the name of the class."""
        return type(self).__name__

    def IsA(self, name):
        """Returns true if the class has this name or is derived from a class with this name."""
        return any(kind.__name__ == name for kind in type(self).__mro__)

    def FillInputPortInformation(self, port, info):
        """Allows blocks as well, which are an error later: a pipeline would compute the blocks one
        by one, and an input that is missing or of another type would keep an earlier output."""
        info.Set(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData")
        info.Append(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree")
        info.Set(vtkAlgorithm.INPUT_IS_OPTIONAL(), 1)
        return 1

    def FillOutputPortInformation(self, port, info):
        """Sets the type of an output."""
        info.Set(vtkDataObject.DATA_TYPE_NAME(), self.output_types[port])
        return 1

    def SetInputData(self, *arguments: Union[int, vtkDataObject, None]) -> None:
        """Sets the data of a port; without a port, of port 0."""
        port, data = arguments if len(arguments) == 2 else (0, *arguments)
        self.SetInputDataObject(port, data)

    def GetInput(self, port: int = 0) -> Optional[vtkPolyData]:
        """Returns the input of a port."""
        return self.GetInputDataObject(port, 0) if self.GetNumberOfInputConnections(port) else None

    def GetPolyDataInput(self, port: int) -> Optional[vtkPolyData]:
        """Returns the input of a port."""
        return self.GetInput(port)

    def AddInputData(self, *arguments: Union[int, vtkDataObject]) -> None:
        """Adds data to a port; without a port, to port 0."""
        port, data = arguments if len(arguments) == 2 else (0, *arguments)
        self.AddInputDataObject(port, data)

    def GetOutput(self, port=0):
        """Returns the output of a port."""
        return self.GetOutputDataObject(port)

    def GetErrorCode(self) -> int:
        """Returns 0, or another number if the last update failed."""
        return self._error_code

    def RequestData(self, request, in_info, out_info):
        """Updates the outputs. They are empty after an error, which is reported, or an abort."""
        ports = range(len(self.output_types))
        data = [vtkDataObject.GetData(out_info, port) for port in ports]
        self._inputs = [vtkDataObject.GetData(info, 0) for info in in_info]
        pieces = vtkStreamingDemandDrivenPipeline.UPDATE_NUMBER_OF_PIECES()
        counts = [out_info.GetInformationObject(port).Get(pieces) for port in ports]
        try:
            found = self.attempt(lambda: self._compute(max(counts)))
        except BaseException:  # such as Ctrl-C
            for output in data:
                output.Initialize()
            self._error_code = USER_ERROR
            raise
        for port, output in enumerate(data):
            if found is None:
                output.Initialize()
                if not self._error_code:  # aborted: computed again in the next update
                    key = vtkDemandDrivenPipeline.DATA_NOT_GENERATED()
                    out_info.GetInformationObject(port).Set(key, 1)
            elif found[port] is not None:
                output.ShallowCopy(found[port])
        self._inputs = []
        return 1  # filters downstream must run and become empty as well

    def attempt(self, step):
        """Returns the result of a step; None after an error, which is reported, or an abort."""
        self._error_code = 0
        self._found = dict(self._found, **self.initial_results())
        self.SetAbortExecute(0)
        self._reached = 0.0
        try:
            return step()
        except Aborted:
            pass
        except (kernel.Error, ValueError, TypeError) as error:
            self._error_code = USER_ERROR
            self._show("Error", in_properties(str(error)))
        except MemoryError:
            self._error_code = USER_ERROR
            self._show("Error", "Memory is exhausted. Use a smaller mesh")
        except Exception as error:
            self._error_code = USER_ERROR
            text = f"Unexpected failure: {type(error).__name__}: {error}. Report this as a bug"
            self._show("Error", text)
        return None

    def initial_results(self):
        """Returns the results that an update sets, with their initial values."""
        return {}

    def _compute(self, number_of_pieces):
        for data in self._inputs:
            if data is not None and not data.IsA("vtkPolyData"):
                raise ValueError(
                    f"The input is a {data.GetClassName()}, but Python filters need a vtkPolyData. "
                    "Append its blocks by vtkAppendPolyData first"
                )
        if number_of_pieces > 1:
            raise ValueError(
                f"One of {number_of_pieces} pieces is requested, but distances need the whole "
                "surface. Gather the surface in one process"
            )
        polydata = self.input(0)
        if polydata is None:
            raise ValueError("There is no input. Connect input port 0")
        if polydata.GetNumberOfPoints() == 0 and polydata.GetNumberOfCells() == 0:
            lack = "neither points nor cells"
            self.warn(f"The input is empty: it has {lack}. The output is empty, too")
            self._surfaces.clear()
            return [polydata] + [None] * (len(self.output_types) - 1)
        self.surface = self.prepare(0, polydata)
        self.advance(0.0)
        return self.run(polydata)

    def input(self, port):
        """Returns the data of an input port; None if there is none."""
        return self._inputs[port]

    def advance(self, fraction):
        """Reports the progress after the preparation."""
        self._report_progress(PREPARED + (1 - PREPARED) * fraction)

    def _report_progress(self, fraction):
        """Reports progress. Stops the update if an observer requests it."""
        self._reached = max(self._reached, fraction)
        self.UpdateProgress(self._reached)
        if self.CheckAbort() if hasattr(self, "CheckAbort") else self.GetAbortExecute():
            raise Aborted

    def warn(self, text, port=0):
        """Shows a warning, once for each surface of a port."""
        kept = self._surfaces.get(port)
        if kept and text in kept.warned:
            return
        if kept:
            kept.warned.add(text)
        self._show("Warning", in_properties(text))

    def warn_about(self, results):
        """Shows the warnings of results of the kernel."""
        for result in results:
            for text in result.warnings:
                self.warn(text)

    def _show(self, kind, text):
        if not vtkObject.GetGlobalWarningDisplay():
            return
        reporter = f"{self.GetClassName()} ({id(self):#x})"
        label = "ERROR" if kind == "Error" else "Warning"
        text = f"{label}: In {__file__}, line 1\n{reporter}: {text.rstrip('.')}.\n\n"
        if self.HasObserver(f"{kind}Event"):
            self.InvokeEvent(f"{kind}Event", text)
        else:
            getattr(vtkOutputWindow.GetInstance(), f"Display{kind}Text")(text)

    # Properties

    def change(self, name, value, is_explicit=False):
        """Sets a property. The first change of an explicit property always counts."""
        old = self._values[name]
        is_same = old == value or (value != value and old != old)  # NaN
        if not is_same or (is_explicit and name not in self._explicit):
            self._values[name] = value
            self.Modified()
        self._explicit.add(name)

    def get(self, name):
        """Returns a property."""
        return self._values[name]

    def set_results(self, **values):
        """Sets values that functions like GetNumberOfFallbacks() return."""
        self._found.update(values)

    def arguments(self, *others):
        """Returns properties as arguments of the kernel, except Ids and others."""
        found = {"progress": self.advance, "memory_limit": self.get("MemoryLimit")}
        for name, described in self.properties.items():
            value = self.get(name)
            is_skipped = name in _FILTER_PROPERTIES or name in others or described["type"] == "ids"
            if not is_skipped and not (name == "MaximumDistance" and value >= NO_LIMIT):
                names = {v: k for k, v in described.get("choices", {}).items()}
                found[argument_of(name)] = names[value] if names else value
        return found

    def points(self, port, ids=None):
        """Returns the ids of a property and the points of a port, as surface points."""
        return surface_points(self.input(port), port, self.get(ids) if ids else ())

    # Surface and graph

    def is_cloud(self, polydata):
        """Returns true if the points of the input are a cloud."""
        is_used = "AcceptCoarserGraph" in self.properties
        return is_used and kernel.is_graph_of_cloud(read_only(graph_arrays(polydata)))

    def prepare(self, port, polydata, name="The input"):
        """Returns the surface of an input, which is kept until points or polygons change."""
        cloud = self.is_cloud(polydata)
        if not cloud and polydata.GetNumberOfPolys() + polydata.GetNumberOfStrips() == 0:
            self._surfaces.pop(port, None)
            raise ValueError(
                f"{name} has {polydata.GetNumberOfPoints()} points but no polygons or triangle "
                "strips. Connect a surface mesh. A point cloud needs the graph of vtkPointCloudDGG "
                "and a filter that accepts clouds, such as vtkDGGDistance"
            )
        merges = not cloud and self.get("MergeCoincidentPoints")
        domain = cloud, merges, self.get("MergeTolerance") if merges else 0.0
        key = TimeStamps(_parts(polydata, cloud))
        # Applications often call Modified() on the data object only. Another object with the same
        # arrays is not a change.
        stamp = TimeStamps([polydata])
        kept = self._surfaces.get(port)
        is_kept = kept and kept.identity[0] == domain and kept.key == key
        if is_kept and (kept.stamp == stamp or kept.stamp.objects[0] is not polydata):
            kept.stamp = stamp
            return kept.surface
        given = surface_arguments(polydata)
        counts = [given["first_cell"], polydata.GetNumberOfPolys(), polydata.GetNumberOfStrips()]
        surface = kernel.Surface(
            **given, cloud=cloud, merge_coincident_points=merges,
            merge_tolerance=self.get("MergeTolerance"), memory_limit=self.get("MemoryLimit"),
            progress=lambda fraction: self._report_progress(PREPARED * fraction),
        )  # fmt: skip
        identity = domain, surface.signature, counts
        if kept and kept.identity == identity:  # an update upstream produced the same surface
            kept.key, kept.stamp = key, stamp
            return kept.surface
        kept = SimpleNamespace(
            key=key, stamp=stamp, identity=identity, surface=surface, warned=set()
        )
        kept.time = vtkTimeStamp()
        kept.time.Modified()
        self._surfaces[port] = kept
        for text in surface.warnings:
            self.warn(text, port)
        return surface

    def graph(self, polydata):
        """Returns the graph on the input, or else one that is built and kept until the surface or
        the accuracy changes."""
        stored = graph_arrays(polydata)
        options = {"accuracy": self.get("Accuracy")}
        if stored:
            is_wanted = "Accuracy" in self._explicit and not self.get("AcceptCoarserGraph")
            options["accept_coarser_graph"] = not is_wanted
        graph = self.find_or_build(stored, **options).graph
        self.set_results(
            UsedInputGraph=graph.is_stored, GraphAccuracy=graph.accuracy,
            NumberOfGraphEdges=graph.number_of_edges, MemorySize=graph.memory_size,
            GraphIsGuaranteed=graph.is_guaranteed, GraphBuildTime=self._build_time.GetMTime(),
        )  # fmt: skip
        return graph

    def find_or_build(self, stored, **options):
        """Returns the graph in stored arrays, or one that is built, as a namespace that is kept
        until the arguments or the surface change."""
        key = TimeStamps(stored.values()), options
        kept = self._graph
        if not (kept and kept.surface is self.surface and kept.key == key):
            self._graph = None  # released before another is built
            graph = kernel.Graph(
                self.surface, stored=read_only(stored), progress=self.advance,
                memory_limit=self.get("MemoryLimit"), **options,
            )  # fmt: skip
            self.warn_about([graph])
            if not graph.is_stored:
                self._build_time.Modified()
            self._graph = SimpleNamespace(key=key, graph=graph, surface=self.surface)
        return self._graph

    # Report

    def GetMeshReport(self):
        """Returns the report as text, one item per line."""
        if 0 not in self._surfaces or self._surfaces[0].surface.number_of_triangles == 0:
            return "no surface\n"
        report = self._surfaces[0].surface.describe()
        return "".join(f"{words}: {text}\n" for words, text in report.items())

    def GetMeshReportTable(self) -> vtkTable:
        """Returns the report as a table with one row."""
        table = vtkTable()
        for name, value in self._report().items():
            table.AddColumn(vtk_array([float(value)], property_of(name)))
        return table

    def GetMeanAnisotropy(self):
        """Returns the mean anisotropy of the triangles."""
        return self._report().get("mean_anisotropy", 0.0)

    def GetMeshBuildTime(self):
        """Returns the time stamp of the surface that is kept between updates."""
        return self._surfaces[0].time.GetMTime() if 0 in self._surfaces else 0

    def _report(self):
        return self._surfaces[0].surface.report() if 0 in self._surfaces else {}


def get(name):
    """Returns the class of a filter, which is made on first use."""
    if name not in TABLE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if name not in _made:
        from .filter_tasks_spectral import TASKS  # which imports this module

        entry = TABLE[name]
        base = get(entry["base"]) if entry.get("base") else PythonFilter
        task = TASKS.get(name)
        bases = (task, base) if task else (base,)
        _made[name] = type(name, bases, _namespace(entry, bases))
    return _made[name]


def __getattr__(name):
    return get(name)


def __dir__():
    return [*globals(), *TABLE]


@functools.lru_cache(maxsize=None)
def argument_of(name):
    """Returns the argument of a property: "maximum_distance" for "MaximumDistance"."""
    return re.sub("(?<!^)(?=[A-Z])", "_", name).lower()


def property_of(argument):
    """Returns the property of an argument: "MaximumDistance" for "maximum_distance"."""
    name = argument.title().replace("_", "")
    return f"{name[:-1]}Ids" if argument in _POINTS else name


def in_properties(text):
    """Returns a message of the kernel with properties and ports in place of arguments."""
    return render(text, lambda name: _PORTS.get(name) or property_of(name), "on the input")


def _namespace(entry, bases):
    """Returns the attributes of a class."""
    own = entry.get("properties", {})
    inherited = {name: dict(described) for name, described in bases[-1].properties.items()}
    for name, value in entry.get("defaults", {}).items():
        inherited[name]["default"] = value
    found = dict(entry.get("constants", {}), __doc__=entry["doc"], __module__=__name__)
    found["properties"] = {**inherited, **own}
    if "inputs" in entry:
        found["input_names"] = entry["inputs"]
        found["output_types"] = [port["type"] for port in entry["outputs"]]
        for port, output in enumerate(entry["outputs"]):
            found.update((n, _getter("GetOutput", port)) for n in output["get"])
            found.update((n, _getter("GetOutputPort", port)) for n in output["get_port"])
        for port, name in enumerate(entry["inputs"]):
            if name:
                found[f"Set{name}Connection"] = _setter("SetInputConnection", port)
                found[f"Set{name}Data"] = _setter("SetInputDataObject", port)
    for name, described in own.items():
        made = _id_methods(name) if described["type"] == "ids" else _methods(name, described)
        found.update((k, _documented(function, described["doc"])) for k, function in made.items())
    kinds = (*bases, *bases[-1].__mro__)
    unavailable = next(b.unavailable for b in kinds if hasattr(b, "unavailable"))
    for name, value in entry.get("values", {}).items():
        if name not in unavailable:
            found[f"Get{name}"] = _documented(_result(name, value["default"]), value["doc"])
    for name in [n for n in found if n[:2] != "__" and any(n in vars(b) for b in bases)]:
        if callable(found[name]):  # a class that was written for the filter
            del found[name]
    return found


def _getter(function, port):
    return lambda self: getattr(self, function)(port)


def _setter(function, port):
    return lambda self, value: getattr(self, function)(port, value)


def _result(name, default):
    return lambda self: self._found.get(name, default)


def _documented(function, doc):
    function.__doc__ = doc
    return function


def _methods(name, described):
    """Returns the functions of a property by name."""
    is_explicit = name == "Accuracy"
    low, high = described.get("range", (None, None))
    convert = _CONVERSIONS[described["type"]]

    def set_value(self, *values):
        value = convert(*values)
        if low is not None:
            value = low if value < low else high if value > high else value
        self.change(name, value, is_explicit and "AcceptCoarserGraph" in self.properties)

    def constant(value):
        return lambda self: set_value(self, value)

    def get_value(self):
        value = self.get(name)
        return tuple(value) if isinstance(value, list) else value

    found = {f"Set{name}": set_value, f"Get{name}": get_value}
    if described["type"] == "bool":
        found.update({f"{name}On": constant(True), f"{name}Off": constant(False)})
    for choice, value in described.get("choices", {}).items():
        found[f"Set{name}To{choice}"] = constant(value)
    if "choices" in described:
        names = {value: choice for choice, value in described["choices"].items()}
        found[f"Get{name}AsString"] = lambda self: names[self.get(name)]
    if low is not None:
        found[f"Get{name}MinValue"] = lambda self: low
        found[f"Get{name}MaxValue"] = lambda self: high
    return found


def _id_methods(name):
    """Returns the functions of a property with ids."""
    one = name[:-1]

    def get_id(self, i):
        return self.get(name)[_checked_index(i, self.get(name))]

    def set_ids(self, ids):
        self.change(name, integers_of(ids))

    return {
        f"Set{name}": set_ids,
        f"Add{one}": lambda self, i: self.change(name, [*self.get(name), operator.index(i)]),
        f"RemoveAll{name}": lambda self: self.change(name, []),
        f"GetNumberOf{name}": lambda self: len(self.get(name)),
        f"Get{one}": get_id,
    }


def _checked_index(i, values):
    if not 0 <= i < len(values):
        raise ValueError(f"expected an index from 0 to {len(values) - 1}, got {i}")
    return i


def integers_of(ids):
    """Returns a vtkIdList, a sequence of integers, or None as a list."""
    if ids is None:
        return []
    if hasattr(ids, "GetNumberOfIds"):
        return [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
    if isinstance(ids, (str, bytes, dict)):
        raise TypeError(f"expected a sequence of integers, got {ids!r}")
    found = [operator.index(i) for i in ids]
    if any(not -(2**63) <= i < 2**63 for i in found):
        raise OverflowError("expected integers of 64 bits")
    return found


def _string(value):
    if not isinstance(value, (str, type(None))):
        raise TypeError(f"expected a str, got {value!r}")
    return value or ""


def _vector(*values):
    values = values[0] if len(values) == 1 else values
    if len(values) != 3:
        raise TypeError(f"expected 3 numbers, got {values!r}")
    return [math.fsum([value]) for value in values]


_CONVERSIONS = {
    "bool": lambda value: bool(operator.index(value)),
    "int": operator.index,
    "id": operator.index,
    "double": lambda value: math.fsum([value]) if math.isfinite(value) else float(value),
    "string": _string,
    "vector": _vector,
}


class TimeStamps:
    """Objects of VTK and their times of modification. References prevent reuse of addresses, and
    objects are compared by identity, because arrays of VTK 9.6 and later compare their values."""

    def __init__(self, objects):
        self.objects = list(objects)
        # Without the points and arrays of a data object.
        self.times = [
            vtkObject.GetMTime(item) if item.IsA("vtkDataObject") else item.GetMTime()
            for item in self.objects
        ]

    def __eq__(self, other):
        is_same = len(self.objects) == len(other.objects) and self.times == other.times
        return is_same and all(a is b for a, b in zip(self.objects, other.objects))


def _parts(polydata, cloud):
    """Returns the objects that points and polygons of a surface consist of."""
    objects = [polydata.GetPoints()]
    for cells in () if cloud else (polydata.GetPolys(), polydata.GetStrips()):
        objects += [cells, cells.GetOffsetsArray(), cells.GetConnectivityArray()]
    return objects

#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Record what all filters answer and refuse, and compare two such records.

Made before and after a change that is to change no result:

    record.py OLD.json --graphs GRAPHS [DATA_FOLDER]
    record.py NEW.json --graphs GRAPHS [DATA_FOLDER]
    record.py --compare OLD.json NEW.json

A record holds every output array of every filter and reader, with all methods and modes, on real
meshes and clouds (of the folder of DGG_EXTRA_DATA by default) or else on generated ones; errors and
warnings for bad inputs; methods and defaults of all classes; the peak memory of each run. Messages
are compared by kind, filter and ids, not by wording. Arrays must be the same with one and two
threads, by all means that VTK has to run them. The graphs that filters search come from files,
which the first record leaves in the folder GRAPHS for later ones.
"""

import argparse
import base64
import functools
import hashlib
import inspect
import json
import os
import re
import resource
import sys
import tempfile
import warnings
import zlib

os.environ.setdefault("DGG_TEST_OUTPUT", tempfile.gettempdir())

# pylint: disable=wrong-import-position
import numpy as np
import record_cases
import record_refusals
import sweep
import vtkdgg
from vtkmodules.util.numpy_support import get_numpy_array_type, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkSMPTools

THREADS = [("TBB", 1), ("TBB", 2), ("STDThread", 1), ("STDThread", 2)]
LIMIT, SHORT = 120.0, 5.0  # time limits of a process, seconds: in general, with one change
SAMPLE = 1000  # values of an array that are kept
MEBIBYTE = 2**20
MORE, SLACK = 1.1, 8.0  # allowed growth of memory: a factor, and MiB
# Getters whose results differ between runs, and getters that VTK reads without a check.
FLEETING = re.compile(r"BuildTime|FileName|GetValue$")
NUMBERS = (bool, int, float, str)
PLACE = re.compile(r"\A(?:ERROR|Warning): In .*, line \d+\n")
ADDRESS = re.compile(r" ?\(?0x[0-9a-fA-F]+\)?")
SUBJECT = re.compile(r"\w+:(?: vtk\w+:)?")  # subject of a message: its kind and the filter
INTEGER = re.compile(r"(?<![\w.])-?\d+(?![\w.])")


# --- One answer ----------------------------------------------------------------------------------


class Messages:
    """Errors and warnings of an algorithm and of the algorithms upstream."""

    def __init__(self, *folders):
        self.texts = []
        self.folders = folders
        self.known = []

    def add(self, kind, text):
        text = ADDRESS.sub("", PLACE.sub("", text or ""))
        text = text.split("for request:")[0].strip()  # the remainder contains times
        for folder in self.folders:
            text = text.replace(folder, "FOLDER")
        self.texts.append(f"{kind}: {text}")

    def hear(self, algorithm):
        waiting = [algorithm]
        while waiting:
            node = waiting.pop()
            if node is None or node in self.known:
                continue
            self.known.append(node)
            for target in (node, node.GetExecutive()):
                for kind in ("Error", "Warning"):

                    def heard(_, __, text, kind=kind):
                        self.add(kind, text)

                    heard.CallDataType = "string0"
                    target.AddObserver(f"{kind}Event", heard)
            for port in range(node.GetNumberOfInputPorts()):
                for i in range(node.GetNumberOfInputConnections(port)):
                    waiting.append(node.GetInputAlgorithm(port, i))


def numbers_of(algorithm):
    """Returns the results of the Get methods that are numbers or texts, or tuples of them; of
    methods with an index the result for index 0."""
    found = {}
    for name in record_cases.own_methods(algorithm):
        if name.startswith("Get") and not FLEETING.search(name):
            method = getattr(algorithm, name)
            for arguments in ((), (0,)):
                try:
                    value = method(*arguments)
                except (TypeError, ValueError):  # it wants other arguments
                    continue
                parts = value if isinstance(value, (tuple, list)) else [value]
                if all(part is None or isinstance(part, NUMBERS) for part in parts):
                    found[name] = ADDRESS.sub("", repr(value))
                break
    return found


@functools.lru_cache(maxsize=None)
def defaults_of(name):
    """Returns the numbers of a new object, none of an abstract class."""
    try:
        return numbers_of(getattr(vtkdgg, name)())
    except TypeError:
        return {}


def arrays_in(data, place):
    """Yields names and arrays of a data object."""
    if data is None:
        return
    if data.IsA("vtkPointSet") and data.GetPoints():
        yield f"{place} Points", data.GetPoints().GetData()
    if data.IsA("vtkPolyData"):
        for kind in ("Verts", "Lines", "Polys", "Strips"):
            cells = getattr(data, f"Get{kind}")()
            if cells.GetNumberOfCells() > 0:
                yield f"{place} {kind} offsets", cells.GetOffsetsArray()
                yield f"{place} {kind} ids", cells.GetConnectivityArray()
    for kind in ("PointData", "CellData", "RowData", "FieldData"):
        arrays = getattr(data, f"Get{kind}", lambda: None)()
        for i in range(arrays.GetNumberOfArrays() if arrays else 0):
            yield f"{place} {kind} {arrays.GetArrayName(i)}", arrays.GetAbstractArray(i)
        for i in range(arrays.GetNumberOfArrays() if hasattr(arrays, "IsArrayAnAttribute") else 0):
            if arrays.IsArrayAnAttribute(i) >= 0:
                kind_of = str(arrays.IsArrayAnAttribute(i))
                yield f"{place} {kind} attribute {kind_of}", str(arrays.GetArrayName(i))


def as_numpy(array):
    if isinstance(array, vtkDataArray):
        shape = array.GetNumberOfTuples(), array.GetNumberOfComponents()
        empty = np.empty(shape, dtype=get_numpy_array_type(array.GetDataType()))
        return vtk_to_numpy(array) if empty.size else empty
    if hasattr(array, "GetVariantValue"):
        values = range(array.GetNumberOfValues())
        return np.array([array.GetVariantValue(i).ToString() for i in values], dtype="U")
    return np.asarray(array)


def digest(array):
    """Returns a hash of the contents, type and shape of an array."""
    content = np.ascontiguousarray(array)
    return f"{hashlib.sha256(content.tobytes()).hexdigest()} {array.dtype} {array.shape}"


def summary(array):
    """Returns the stored part of an array, for comparisons."""
    kept = {"dtype": str(array.dtype), "shape": list(array.shape)}
    flat = np.ascontiguousarray(array).reshape(-1)
    if array.dtype.kind in "biuf" and flat.size:
        if flat.size > SAMPLE:
            with np.errstate(all="ignore"):
                for name in ("nansum", "nanmin", "nanmax"):
                    kept[name] = repr(getattr(np, name)(flat.astype(float)))
            flat = flat[np.random.default_rng(0).integers(0, flat.size, SAMPLE)]
        kept["values"] = base64.b64encode(zlib.compress(flat.tobytes(), 1)).decode()
    elif flat.size:
        kept["text"] = flat[:SAMPLE].tolist()
    return kept


def answer(build, change, folders):
    """Returns the messages and numbers of an algorithm, and its arrays. A function may also return
    a dict of results."""
    messages = Messages(*folders)
    found = {"numbers": {}, "memory": {}}
    arrays = {}
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            algorithm = build()
        for warning in caught:
            messages.add(warning.category.__name__, str(warning.message))
        if isinstance(algorithm, dict):
            arrays = algorithm
        else:
            messages.hear(algorithm)
            if change:
                change(algorithm)
                messages.hear(algorithm)
            getattr(algorithm, "Write", algorithm.Update)()
            found["code"] = algorithm.GetErrorCode()
            defaults = defaults_of(algorithm.GetClassName())
            for name, value in numbers_of(algorithm).items():
                kind = "memory" if "Memory" in name and "Limit" not in name else "numbers"
                if value != defaults.get(name):
                    found[kind][name] = value
            for port in range(algorithm.GetNumberOfOutputPorts()):
                arrays.update(arrays_in(algorithm.GetOutputDataObject(port), str(port)))
            if hasattr(algorithm, "GetMatrix"):
                arrays["matrix"] = algorithm.GetMatrix()
            if hasattr(algorithm, "Write") and os.path.exists(algorithm.GetFileName() or ""):
                arrays["file"] = np.fromfile(algorithm.GetFileName(), dtype=np.uint8)
    except Exception as error:  # pylint: disable=broad-except
        messages.add(type(error).__name__, str(error))
    found["messages"] = messages.texts
    return found, {name: as_numpy(array) for name, array in arrays.items()}


def kept(found, arrays, table):
    """Returns an answer as it is written; contents of arrays go into a table."""
    found["arrays"] = {name: digest(array) for name, array in arrays.items()}
    for name, array in arrays.items():
        if found["arrays"][name] not in table:
            table[found["arrays"][name]] = summary(array)
    return found


def use_threads(backend, threads):
    """Returns false if VTK does not have this backend."""
    if not vtkSMPTools.SetBackend(backend):
        return False
    vtkSMPTools.Initialize(threads)
    return True


# --- Processes -----------------------------------------------------------------------------------


def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / MEBIBYTE


def resident():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize() / MEBIBYTE


def run_case(function, scene, limit):
    """Returns the answer of a case for all kinds of threads, its peak memory and its time."""
    before, table, first, other = resident(), {}, None, []

    def of(found):
        return {part: found[part] for part in ("arrays", "messages", "numbers")}

    timer = sweep.Timer(limit)
    with timer:
        for backend, threads in THREADS:
            if not use_threads(backend, threads):
                continue
            build = functools.partial(function, scene)
            found, arrays = answer(build, None, (scene.folder, scene.graphs))
            if first is None:
                first = kept(found, arrays, table)
                peaks = [peak() - before]
                continue
            found["arrays"] = {name: digest(array) for name, array in arrays.items()}
            for line in differences(f"{backend} {threads}", of(first), of(found), ({}, {})):
                other.append(line)
            del arrays
    first["threads"] = other
    first["peaks"] = peaks + [peak() - before]
    return {"answer": first, "table": table, "seconds": timer.used}


def run_changes(function, changes, scene, only, limit):
    """Returns the answers of a case with each of the changes, or with the change of index `only`.
    """
    use_threads(*THREADS[0])
    os.chdir(scene.folder)
    table, answers = {}, {}
    with sweep.Timer(limit):
        for i, (name, change) in enumerate(changes(function(scene))):
            if only in (None, i):
                build = functools.partial(function, scene)
                answers[name] = kept(*answer(build, change, (scene.folder, scene.graphs)), table)
    return {"answers": answers, "table": table}


def run_builds(builds, folder, limit):
    """Returns the answers of the results of some functions."""
    use_threads(*THREADS[0])
    table = {}
    with sweep.Timer(limit):
        answers = {name: kept(*answer(build, None, (folder,)), table) for name, build in builds()}
    return {"answers": answers, "table": table}


def call_builds():
    for name, call in record_refusals.calls():

        def build(call=call):
            result = call()
            return {"result": result if isinstance(result, np.ndarray) else repr(result)}

        yield name, build


def reader_builds(kind, folder):
    for name, reader in record_refusals.readers_of(kind, folder):
        yield name, lambda reader=reader: reader


class Record:
    """All contents of a record."""

    def __init__(self, options):
        self.options = options
        self.content = {"classes": {}, "answers": {}, "refusals": {}, "seconds": {}, "arrays": {}}

    def process(self, work, *arguments, limit=LIMIT):
        outcome = sweep.in_process(functools.partial(work, *arguments, limit), limit) or {}
        self.content["arrays"].update(outcome.pop("table", {}))
        return outcome

    def record_classes(self):
        names = sorted(vtkdgg.__all__)
        self.content["classes"]["vtkdgg"] = {"methods": names}
        for name in dir(vtkdgg):
            value = getattr(vtkdgg, name)
            if inspect.isclass(value):
                methods = [method for method in dir(value) if not method.startswith("__")]
                entry = {"methods": methods, "defaults": {}}
                if name.startswith("vtk"):
                    entry["defaults"] = defaults_of(name)
                self.content["classes"][name] = entry

    def record_answers(self, scene):
        for kind in record_cases.graphs_of(scene):
            self.process(lambda limit, kind=kind: scene.write_graph(kind))
        for name, function in record_cases.cases_of(scene).items():
            if self.options.cases not in name:
                continue
            outcome = self.process(run_case, function, scene)
            key = f"{scene.name}/{name}"
            found = outcome.get("answer") or {"messages": [outcome["status"], *outcome["messages"]]}
            self.content["answers"][key] = found
            if "answer" in outcome:
                self.content["seconds"][key] = outcome["seconds"]
            if self.options.verbose:
                peaks = ", ".join(f"{value:.0f}" for value in found.get("peaks", []))
                print(f"{key}: {outcome['seconds']:.2f} s, {peaks} MiB", flush=True)
            if found.get("threads"):
                number, first = len(found["threads"]), found["threads"][0].split(":")[0]
                print(f"{key}: threads matter in {number} places, the first: {first}", flush=True)

    def record_refusals(self, scene):
        for name, function, changes in record_refusals.refusals_of(scene):
            if self.options.cases not in name:
                continue
            outcome = self.process(run_changes, function, changes, scene, None)
            if "answers" not in outcome:  # one of them ended the process: one after the other
                use = [what for what, _ in changes(function(scene))]
                outcome = {"answers": {}}
                for i, what in enumerate(use):
                    one = self.process(run_changes, function, changes, scene, i, limit=SHORT)
                    found = {what: {"messages": [one.get("status"), *one.get("messages", [])]}}
                    outcome["answers"].update(one.get("answers", found))
            for what, found in outcome["answers"].items():
                self.content["refusals"][f"{scene.name}/{name}/{what}"] = found
            if self.options.verbose:
                print(f"{scene.name}/{name}: {len(outcome['answers'])} changes", flush=True)

    def record_others(self, folder):
        """Records functions of the package and damaged files."""
        builds = {"functions": call_builds}
        for kind in record_refusals.FORMATS:
            builds[kind] = functools.partial(reader_builds, kind, folder)
        for kind, build in builds.items():
            outcome = self.process(run_builds, build, folder)
            crash = {"all": {"messages": outcome.get("messages", [])}}
            for what, found in outcome.get("answers", crash).items():
                self.content["refusals"][f"{kind}/{what}"] = found

    def run(self):
        options = self.options
        self.record_classes()
        with tempfile.TemporaryDirectory() as folder:
            graphs = os.path.abspath(options.graphs or folder)
            os.makedirs(graphs, exist_ok=True)
            for scene in record_cases.scenes(options.folder, folder, graphs, options.meshes):
                self.record_answers(scene)
                self.record_refusals(scene)
            if not options.cases and not options.meshes:
                self.record_others(folder)
        return any(found.get("threads") for found in self.content["answers"].values())


# --- Comparison ----------------------------------------------------------------------------------


def values_of(summary_):
    content = zlib.decompress(base64.b64decode(summary_["values"]))
    return np.frombuffer(content, dtype=summary_["dtype"])


def compare_arrays(old, new):
    """Returns the difference of the contents of two arrays in words."""
    for name in ("dtype", "shape"):
        if old[name] != new[name]:
            return f"{name} {old[name]}, now {new[name]}"
    if "values" not in old:
        return f"{old.get('text')}, now {new.get('text')}"
    a, b = (values_of(part).astype(float) for part in (old, new))
    same = (a == b) | (np.isnan(a) & np.isnan(b))
    with np.errstate(all="ignore"):
        absolute = np.abs(a - b)[~same]
        relative = absolute / np.maximum(np.abs(a), np.abs(b))[~same]
    text = f"{(~same).sum()} of {a.size} values differ"
    if absolute.size:
        text += f", by at most {np.nanmax(absolute):.3g}, {np.nanmax(relative):.3g} relative"
        if np.isnan(absolute).any():
            text += f", {np.isnan(absolute).sum()} are NaN in one of them"
    for name in ("nansum", "nanmin", "nanmax"):
        if old.get(name) != new.get(name):
            text += f"; {name[3:]} {old[name]}, now {new[name]}"
    return text


def identity_of(message):
    """Returns what is compared of a message: kind, filter and ids."""
    subject = SUBJECT.match(str(message))
    return " ".join([subject.group() if subject else "", *INTEGER.findall(str(message))])


def differences(key, old, new, tables):
    """Yields lines about the differences of two answers, or of the same part of two answers."""
    if old is None or new is None:
        yield f"{key}: only in the {'new' if old is None else 'old'} record"
    elif isinstance(old, dict):
        for name in {**old, **new}:
            if name not in ("peaks", "memory"):
                yield from differences(f"{key}, {name}", old.get(name), new.get(name), tables)
    elif isinstance(old, list):
        if key.endswith(", messages"):
            old, new = [identity_of(line) for line in old], [identity_of(line) for line in new]
        for line in old:
            if line not in new:
                yield f"{key}: no longer: {line}"
        for line in new:
            if line not in old:
                yield f"{key}: new: {line}"
        if sorted(old) == sorted(new) and old != new:
            yield f"{key}: in another order: {new}"
    elif old != new:
        if old in tables[0] and new in tables[1]:
            yield f"{key}: {compare_arrays(tables[0][old], tables[1][new])}"
        else:
            yield f"{key}: {old}, now {new}"


def compare_memory(old, new):
    """Prints changes of memory, and returns the number of peaks that are too high."""
    high, ratios, reported = 0, [], []
    for key in set(old) & set(new):
        for a, b in zip(old[key].get("peaks", []), new[key].get("peaks", [])):
            ratios.append((b + SLACK) / (a + SLACK))
            if b > MORE * a + SLACK:
                high += 1
                print(f"peak memory: {key}: {a:.1f} MiB, now {b:.1f} MiB")
        memory = [found.get("memory", {}) for found in (old[key], new[key])]
        for name in set(memory[0]) & set(memory[1]):
            a, b = (float(part[name]) for part in memory)
            if a != b:
                reported.append(((b + 1.0) / (a + 1.0), f"{key}, {name}: {a:.0f}, now {b:.0f} bytes"))
    if ratios:
        print(f"peak memory: {min(ratios):.2f} to {max(ratios):.2f} times, {high} too high")
    for ratio, line in sorted(reported)[:3] + sorted(reported)[3:][-3:]:
        print(f"memory that filters report: {ratio:.2f} times, {line}")
    return high


def compare(old, new):
    """Prints all differences, and returns true if there are any."""
    tables = old["arrays"], new["arrays"]
    count = 0
    for part in ("classes", "answers", "refusals"):
        for key in {**old[part], **new[part]}:
            pair = old[part].get(key), new[part].get(key)
            for line in differences(f"{part}: {key}", *pair, tables):
                print(line)
                count += 1
    count += compare_memory(old["answers"], new["answers"])
    both = set(old["seconds"]) & set(new["seconds"])
    times = [sum(record["seconds"][key] for key in both) for record in (old, new)]
    print(f"time: {times[1] / max(times[0], 1e-9):.3f} times, {times[1]:.0f} s")
    print(f"{len(new['answers'])} answers, {len(new['refusals'])} refusals, {count} differences")
    return count > 0


def load(name, renamed=()):
    """Returns a record, with replaced words."""
    with open(name, encoding="utf-8") as file:
        text = file.read()
    for words in renamed:
        text = text.replace(*words.split("=", 1))
    return json.loads(text)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("output", nargs="?", metavar="OUT.json")
    parser.add_argument("folder", nargs="?", default=os.environ.get("DGG_EXTRA_DATA", ""))
    parser.add_argument("--compare", nargs=2, metavar=("OLD.json", "NEW.json"))
    parser.add_argument("--graphs", help="folder with graphs of an earlier record, or for them")
    parser.add_argument(
        "--renamed", action="append", default=[], metavar="OLD=NEW", help="since the old record"
    )
    parser.add_argument("--meshes", default="", help="those with this in their name only")
    parser.add_argument("--cases", default="", help="those with this in their name only")
    parser.add_argument("-v", "--verbose", action="store_true", help="a line for each run")
    options = parser.parse_args()
    if options.compare:
        return compare(load(options.compare[0], options.renamed), load(options.compare[1]))
    if not options.output:
        parser.error("the name of a file for the record is missing")
    record = Record(options)
    failed = record.run()
    if not record.content["answers"]:
        parser.error(
            f"No mesh has '{options.meshes}' and no case '{options.cases}' in its name. Give the"
            " folder of the meshes, or other names."
        )
    with open(options.output, "w", encoding="utf-8") as file:
        json.dump(record.content, file, indent=0)
    return failed


if __name__ == "__main__":
    sys.exit(main())

# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A run of exhibits: meshes, benchmark programs and kept results."""

import contextlib
import functools
import hashlib
import json
import os
import signal
import subprocess
from dataclasses import dataclass
from typing import Any

import vtkdgg
from vtkdgg.vtk_data import triangulated
from vtkmodules.vtkIOPLY import vtkPLYWriter

from . import surfaces

# Models that are measured if there is a data folder; smallest first.
SCANS = ("fertility", "kitten", "gargoyle", "bunny", "armadillo")


class ProgramFailed(Exception):
    """A benchmark program failed; the text ends with its last messages."""


class TooLong(Exception):
    """An exhibit exceeded the time limit."""


@dataclass(frozen=True)
class Measured:
    """Figures, and the names of the models."""

    figures: Any
    models: list


class Run:
    """Folders, and the extent of the measurements."""

    def __init__(self, folder, programs, data=None, full=False, reuse=False):
        self.reuse = reuse  # finished exhibits are not measured again
        self.folder = folder
        self.programs = programs
        self.data = data
        self.full = full
        self._meshes = {}
        self._made = {}
        self._models = {}  # keys: models of the current exhibit, an ordered set
        os.makedirs(folder, exist_ok=True)

    def settings(self):
        """Returns the settings that a result depends on."""
        return {"full": self.full, "data": self.data is not None}

    def pick(self, default, full):
        """Returns the value of a default run or of a full run."""
        return full if self.full else default

    def uses(self, *names):
        """Records models."""
        self._models.update(dict.fromkeys(names))

    def measured(self, make):
        """Returns the result of a function, and the models that it recorded."""
        outer, self._models = self._models, {}
        try:
            return Measured(make(), list(self._models))
        finally:
            self._models = outer

    def mesh(self, name):
        """Returns a generated surface, or a model from the data folder."""
        self.uses(name if surfaces.NAME.match(name) else f"{name}.ply")
        if name not in self._meshes:
            made = surfaces.make(name)
            if made is None:
                path = os.path.join(self.data, f"{name}.ply")
                made = triangulated(vtkdgg.read(path).as_polydata(), path)
            self._meshes[name] = made
        return self._meshes[name]

    def scans(self, most=None):
        """Returns the first `most` models that the data folder contains."""
        return [name for name in SCANS if self.has(name)][:most]

    def has(self, name):
        """Returns true if the data folder contains this model."""
        return self.data is not None and os.path.isfile(os.path.join(self.data, f"{name}.ply"))

    def file(self, name):
        """Returns the path of a mesh, for programs."""
        mesh = self.mesh(name)
        path = os.path.join(self.folder, f"{name}.ply")
        if not os.path.isfile(path):
            writer = vtkPLYWriter()
            writer.SetFileTypeToBinary()
            writer.SetFileName(path)
            writer.SetInputData(mesh)
            vtkdgg.check(writer)
        return path

    def once(self, key, make):
        """Returns data that several exhibits share, computed once per run."""
        if key not in self._made:
            self._made[key] = make()
        return self._made[key]

    def path(self, name):
        """Returns the path of the results of this name."""
        return os.path.join(self.folder, f"{name}.json")

    def find(self, name):
        """Returns the results of an earlier run with the same settings, or None."""
        if not os.path.isfile(self.path(name)):
            return None
        with open(self.path(name), encoding="utf-8") as file:
            found = json.load(file)
        if found.pop("settings") != self.settings():
            return None
        return Measured(**found)

    def kept(self, name, measure):
        """Returns kept results if they may be reused; otherwise measures and keeps them."""
        found = self.find(name) if self.reuse else None
        if found is None:
            found = {"settings": self.settings(), **vars(self.measured(measure))}
            with open(self.path(name) + ".part", "w", encoding="utf-8") as file:
                json.dump(found, file, indent=1)
            os.replace(self.path(name) + ".part", self.path(name))
            found = self.find(name)  # reloaded: keys of JSON are strings
        return found

    def shared(self, name, measure):
        """Returns figures of several exhibits."""
        name = f"shared_{name}"
        found = self.once(name, lambda: self.kept(name, measure))
        self.uses(*found.models)
        return found.figures

    def program(self, name, *arguments):
        """Runs a benchmark program, and returns the path of its JSON."""
        key = (name, *arguments)
        # The same arguments use the same file, which plots of kept results read again.
        mark = hashlib.sha1(" ".join(arguments).encode()).hexdigest()[:8]
        path = os.path.join(self.folder, f"{name}-{mark}.json")

        def make():
            command = [
                os.path.join(self.programs, name),
                f"--benchmark_out={path}",
                "--benchmark_out_format=json",
                *arguments,
            ]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                last = (done.stderr or done.stdout).strip().splitlines()[-3:]
                raise ProgramFailed(f"{name}: {' '.join(last)}")
            return path

        return self.once(key, make)


def shared(measure):
    """Decorates a function of the run whose figures several exhibits show."""
    return functools.wraps(measure)(lambda run: run.shared(measure.__name__, lambda: measure(run)))


@contextlib.contextmanager
def limited_time(seconds):
    """Raises TooLong in a block after a number of seconds, on systems with alarms."""

    def leave(*_):
        raise TooLong(f"not done after {seconds} seconds")

    if not hasattr(signal, "SIGALRM"):
        yield
        return
    before = signal.signal(signal.SIGALRM, leave)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)

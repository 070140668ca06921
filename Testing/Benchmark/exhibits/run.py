# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""One run of exhibits: its meshes, the programs it calls, and results that are kept."""

import hashlib
import json
import os
import signal
import subprocess

import vtkdgg
from vtkdgg.commands import files
from vtkmodules.vtkIOPLY import vtkPLYWriter

from . import surfaces

# Models that are measured where there is a folder of data; smallest first.
SCANS = ("fertility", "kitten", "gargoyle", "bunny", "armadillo")
MOST_SECONDS = 3600  # of an exhibit


class ProgramFailed(Exception):
    """A benchmark program did not end well; the text has its last words."""


class TooLong(Exception):
    """An exhibit took more time than it may."""


class Run:
    """Where things are, and how much is measured."""

    def __init__(self, folder, programs, data=None, full=False, reuse=False):
        self.reuse = reuse  # what is finished is not measured again
        self.folder = folder
        self.programs = programs
        self.data = data
        self.full = full
        self._meshes = {}
        self._made = {}
        os.makedirs(folder, exist_ok=True)

    def settings(self):
        """What a result depends on besides the exhibit."""
        return {"full": self.full, "data": self.data is not None}

    def pick(self, default, full):
        """The one or the other."""
        return full if self.full else default

    def mesh(self, name):
        """A generated surface, or a model of the folder of data."""
        if name not in self._meshes:
            made = surfaces.make(name)
            if made is None:
                path = os.path.join(self.data, f"{name}.ply")
                made = files.triangles_of(files.read(path), path)
            self._meshes[name] = made
        return self._meshes[name]

    def scans(self, most=None):
        """The models of the folder of data that are there: the first `most` of them."""
        if self.data is None:
            return []
        paths = (os.path.join(self.data, f"{name}.ply") for name in SCANS)
        return [name for name, path in zip(SCANS, paths) if os.path.isfile(path)][:most]

    def file(self, name):
        """The path of a mesh, for programs."""
        path = os.path.join(self.folder, f"{name}.ply")
        if not os.path.isfile(path):
            writer = vtkPLYWriter()
            writer.SetFileTypeToBinary()
            writer.SetFileName(path)
            writer.SetInputData(self.mesh(name))
            vtkdgg.check(writer)
        return path

    def once(self, key, make):
        """What several exhibits share: made once in a run."""
        if key not in self._made:
            self._made[key] = make()
        return self._made[key]

    def shared(self, name, make):
        """The same for figures, which are kept for further runs as those of exhibits are."""
        path = os.path.join(self.folder, f"shared_{name}.json")

        def find_or_make():
            figures = self.read(path) if self.reuse else None
            if figures is None:
                figures = self.write(path, make())
            return figures

        return self.once(("shared", name), find_or_make)

    def read(self, path):
        """Figures from an earlier run with these settings; None without."""
        if not os.path.isfile(path):
            return None
        with open(path, encoding="utf-8") as file:
            found = json.load(file)
        return found["figures"] if found["settings"] == self.settings() else None

    def write(self, path, figures):
        """Keep figures; returns them as they will be read: keys are texts."""
        with open(path + ".part", "w", encoding="utf-8") as file:
            json.dump({"settings": self.settings(), "figures": figures}, file, indent=1)
        os.replace(path + ".part", path)
        return self.read(path)

    def program(self, name, *arguments):
        """Run a benchmark program; the path of its JSON."""
        key = (name, *arguments)
        # Of the same arguments the same file: plots of kept results read it again.
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


class Kept:
    """Results of exhibits in files, so that what is finished is not measured again."""

    def __init__(self, run):
        self.run = run

    def path(self, exhibit):
        return os.path.join(self.run.folder, f"{exhibit.name}.json")

    def find(self, exhibit):
        """Figures from an earlier run with these settings; None without."""
        return self.run.read(self.path(exhibit))

    def figures(self, exhibit, seconds=MOST_SECONDS):
        """Those that are kept, else measured now and kept."""
        figures = self.find(exhibit) if self.run.reuse else None
        if figures is None:
            with limited_time(seconds):
                figures = exhibit.measure(self.run)
            figures = self.run.write(self.path(exhibit), figures)
        return figures


class limited_time:
    """A block that is left by TooLong after so many seconds; where alarms are to be had."""

    def __init__(self, seconds):
        self.seconds = seconds
        self.before = None

    def __enter__(self):
        def leave(*_):
            raise TooLong(f"not done after {self.seconds} seconds")

        if hasattr(signal, "SIGALRM"):
            self.before = signal.signal(signal.SIGALRM, leave)
            signal.alarm(self.seconds)
        return self

    def __exit__(self, *_):
        if hasattr(signal, "SIGALRM"):
            signal.alarm(0)
            signal.signal(signal.SIGALRM, self.before)

# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The installed package works: installed_package.py PREFIX VERSION WITH_PCL."""

import importlib.metadata
import os
import pathlib
import re
import subprocess
import sys

import vtkdgg

PREFIX, VERSION, WITH_PCL = sys.argv[1:]
WHERE = os.path.realpath(vtkdgg.__file__)
if not WHERE.startswith(os.path.realpath(PREFIX) + os.sep):
    sys.exit(f"imported from {WHERE}, not from {PREFIX}")
if vtkdgg.__version__ != VERSION:
    sys.exit(f"version is {vtkdgg.__version__}, not {VERSION}")
FAR = vtkdgg.distance([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], 1)[2]
if FAR != 5.0:
    sys.exit(f"distance is {FAR}, not 5")
FAR = vtkdgg.Graph([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).distance(1)[2]
if not abs(FAR - 5.0) < 1e-6:
    sys.exit(f"distance in the graph is {FAR}, not 5")
STUBS = sorted(pathlib.Path(WHERE).parent.glob("vtkDGG*.pyi"))
CLASSES = [name for stub in STUBS for name in re.findall(r"(?m)^class (\w+)", stub.read_text())]
if len(CLASSES) < 28:
    sys.exit(f"the stubs have {len(CLASSES)} classes, expected at least 28: {CLASSES}")
for name in CLASSES:
    if not hasattr(vtkdgg, name):
        sys.exit(f"{name} is missing")
if WITH_PCL.upper() in ("ON", "1", "TRUE", "YES") and "vtkPointCloudDGG" not in CLASSES:
    sys.exit("vtkPointCloudDGG is missing")
if not pathlib.Path(WHERE).with_name("py.typed").exists():
    sys.exit("py.typed is missing")
if importlib.metadata.version("vtkdgg") != VERSION:
    sys.exit(f"metadata are of version {importlib.metadata.version('vtkdgg')}")
COMMAND = subprocess.run(
    [os.path.join(PREFIX, "bin", "vtkdgg"), "--version"],
    env={key: value for key, value in os.environ.items() if key != "PYTHONPATH"},
    capture_output=True,
    text=True,
    check=True,
)
if not COMMAND.stdout.startswith(f"vtkdgg {VERSION}, VTK "):
    sys.exit(f"the command says: {COMMAND.stdout}")

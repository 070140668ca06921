# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of ports, properties and values of all filters. This module imports no VTK."""

import json
import pathlib

#: Descriptions of filters by class.
TABLE = json.loads(pathlib.Path(__file__).with_suffix(".json").read_text(encoding="utf-8"))

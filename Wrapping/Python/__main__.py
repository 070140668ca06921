# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""``python -m vtkdgg`` is the command ``vtkdgg``."""

import sys

from .command_line import script

sys.exit(script())

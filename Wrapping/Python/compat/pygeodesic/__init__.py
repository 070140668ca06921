# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package pygeodesic, whose only module is `geodesic`."""

from . import geodesic

__all__ = ["geodesic"]

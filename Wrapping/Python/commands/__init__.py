# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of the command ``vtkdgg``: files, pictures, answers."""

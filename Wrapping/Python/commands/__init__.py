# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the command ``vtkdgg`` is made of: files, pictures, answers."""

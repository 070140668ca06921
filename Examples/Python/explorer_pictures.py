# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the explorer, controlled by clicks, drags and keys as by a user.

Usage: explorer_pictures.py FILE FOLDER [NAME...]

FILE holds a surface or a point cloud. Without names, all pictures.
"""

import os
import sys

import vtkdgg
from vtkdgg.explorer import Explorer, Scene

SIZE = (1000, 750)
# Positions on the bunny, as fractions of the window.
LEG, EAR, NOSE, BACK = (0.52, 0.36), (0.43, 0.85), (0.19, 0.57), (0.50, 0.55)
# Clicks, drags from one position to another, and keys.
PICTURES = {
    "explorer_drag": [(BACK, LEG)],
    "explorer_path": [BACK, EAR],
    "explorer_loop": [BACK, EAR, NOSE],
    "explorer_voronoi": ["v", BACK, EAR, NOSE, LEG, (0.30, 0.35)],
    "explorer_error": [LEG, "e"],
    "explorer_greens": [LEG, "g"],
}
ON_CLOUDS = ("explorer_drag", "explorer_path", "explorer_voronoi")


def play(window, act):
    """Press a key, click at a position, or drag between two positions."""
    interactor = window.interactor
    if isinstance(act, str):
        interactor.SetKeyEventInformation(0, 0, act, 0, act)
        interactor.InvokeEvent("CharEvent")
        return
    start, end = act if isinstance(act[0], tuple) else (act, None)
    steps = [("LeftButtonPressEvent", start)]
    # A drag continues until the picture is taken.
    steps += [("MouseMoveEvent", end)] if end else [("LeftButtonReleaseEvent", start)]
    for event, place in steps:
        pixel = (round(part * length) for part, length in zip(place, SIZE))
        interactor.SetEventInformation(*pixel)
        interactor.InvokeEvent(event)


def main(path, folder, names):
    """Draw the pictures."""
    contents = vtkdgg.read(path).as_polydata()
    is_cloud = contents.GetNumberOfPolys() == 0
    for name in names or (ON_CLOUDS if is_cloud else PICTURES):
        if name not in PICTURES:
            raise ValueError(f"'{name}' is none of the pictures {', '.join(PICTURES)}")
        window = Explorer(Scene(contents, is_cloud), size=SIZE)
        window.window.Render()
        for act in PICTURES[name]:
            play(window, act)
        picture = os.path.join(folder, f"{name}.png")
        window.save_picture(picture)
        print("Written:", picture)
        print("\n".join(window.scene.status()))
        window.close()


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    try:
        main(sys.argv[1], sys.argv[2], sys.argv[3:])
    except (OSError, ValueError, vtkdgg.VTKError) as problem:
        sys.exit(f"error: {problem}")

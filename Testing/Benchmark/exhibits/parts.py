# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Generated machine parts, triangulated as by CAD kernels: few long triangles on planes and
cylinders, no vertices inside of flat faces."""

import numpy as np

from .solids import Solid, edges_apart, extrude, split_edges

SEED = 7


# --- Curves --------------------------------------------------------------------------------------


def arc(radius, begin, end, segments, center=(0.0, 0.0)):
    """Returns points of an arc in the plane; angles in degrees. A full circle has no end point."""
    is_full = np.isclose(abs(end - begin), 360.0)
    angles = np.radians(np.linspace(begin, end, segments + 1)[: segments if is_full else None])
    return np.column_stack([np.cos(angles), np.sin(angles)]) * radius + center


def circle(radius, segments, center=(0.0, 0.0), phase=0.0):
    """Returns a counterclockwise circle."""
    return arc(radius, phase, phase + 360.0, segments, center)


def rectangle(width, height, radius=0.0, segments=0):
    """Returns a counterclockwise rectangle around the origin. Its corners are arcs around fixed
    centers if there are segments."""
    half = np.array([width, height]) / 2.0
    signs = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])
    if segments == 0:
        return signs * half
    return np.concatenate(
        [arc(radius, 90.0 * k, 90.0 * k + 90.0, segments, signs[k] * half) for k in range(4)]
    )


def toothed(teeth, root, tip, flank=3, land=0.3):
    """Returns the outline of a gear: `flank` segments per flank, `land` is the part of a tooth at
    the tip."""
    rise = np.linspace(0.0, 1.0, flank + 1)
    radii = root + (tip - root) * np.concatenate([rise, rise[::-1]])
    slope = (1.0 - 2.0 * land) / 2.0
    turns = np.concatenate([slope * rise**1.3, slope + land + slope * (1.0 - rise[::-1] ** 1.3)])
    angles = 2.0 * np.pi / teeth * (np.arange(teeth)[:, None] + turns).ravel()
    return np.column_stack([np.cos(angles), np.sin(angles)]) * np.tile(radii, teeth)[:, None]


def airfoil(chord, thickness, count):
    """Returns the outline of a symmetric blade with `count` points per side."""
    x = 0.5 * (1.0 - np.cos(np.pi * np.arange(1, count) / count))
    y = thickness * (2.969 * np.sqrt(x) - 1.26 * x - 3.516 * x**2 + 2.843 * x**3 - 1.036 * x**4)
    upper, lower = np.column_stack([x, y])[::-1], np.column_stack([x, -y])
    return chord * np.concatenate([[[1.0, 0.0]], upper, [[0.0, 0.0]], lower])


def mirrored(quarter):
    """Returns an outline that is symmetric about both axes, from the points of its first quadrant,
    none of which is on an axis."""
    half = np.concatenate([quarter, quarter[::-1] * [-1, 1]])
    return np.concatenate([half, half[::-1] * [1, -1]])


def rail(width, height, web, flange):
    """Returns the outline of an I-beam."""
    w, h = width / 2.0, height / 2.0
    return mirrored(np.array([[web / 2, h - flange], [w, h - flange], [w, h]]))


def at(ring, height):
    """Returns a ring of the plane at a height."""
    return np.column_stack([ring, np.full(len(ring), float(height))])


def turned_rings(profile, segments):
    """Returns circles around the axis for points (radius, height)."""
    return [at(circle(radius, segments), height) for radius, height in profile]


def path_rings(path, section):
    """Returns copies of a section along a path, each in the plane that halves the angle of the path.
    The section keeps its direction as far as possible."""
    steps = np.diff(path, axis=0)
    steps /= np.linalg.norm(steps, axis=1)[:, None]
    tangents = np.vstack([steps[:1], steps[1:] + steps[:-1], steps[-1:]])
    tangents /= np.linalg.norm(tangents, axis=1)[:, None]
    side = np.cross(tangents[0], np.eye(3)[np.argmin(np.abs(tangents[0]))])
    rings = []
    for place, tangent in zip(path, tangents):
        side = side - tangent * (side @ tangent)
        side /= np.linalg.norm(side)
        rings.append(place + section @ np.stack([side, np.cross(tangent, side)]))
    return rings


def bent_path(radius, straight, bends, segments):
    """Returns a path in the plane y = 0 of straight pieces and bends by angles in degrees."""
    place, heading, path = np.zeros(2), 0.0, [np.zeros(2)]
    for bend in (*bends, 0.0):
        place = place + straight * np.array([np.cos(heading), np.sin(heading)])
        path.append(place)
        for _ in range(segments if bend else 0):
            heading += np.radians(bend) / segments / 2.0
            step = 2.0 * radius * np.sin(abs(np.radians(bend)) / segments / 2.0)
            place = place + step * np.array([np.cos(heading), np.sin(heading)])
            heading += np.radians(bend) / segments / 2.0
            path.append(place)
    x, z = np.array(path).T
    return np.column_stack([x, np.zeros(len(x)), z])


def helix(radius, pitch, turns, segments):
    """Returns a helical path with `segments` per turn."""
    turn = np.arange(round(turns * segments) + 1) / segments
    angle = 2.0 * np.pi * turn
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), pitch * turn])


# --- Builders ------------------------------------------------------------------------------------


def plate(columns, rows, segments, height, radius=0.3, is_delaunay=True, margin=0.0):
    """Returns a plate with a hole in each cell of a grid."""
    size = np.array([columns, rows]) + 2.0 * margin
    places = np.array(list(np.ndindex(columns, rows))) + 0.5 - np.array([columns, rows]) / 2.0
    phases = np.random.default_rng(SEED).uniform(0.0, 360.0, len(places))
    holes = [circle(radius, segments, place, phase)[::-1] for place, phase in zip(places, phases)]
    return extrude([rectangle(*size), *holes], height, is_delaunay)


def turned(profile, segments, is_ring=False, is_closed=True):
    """Returns a solid of revolution of points (radius, height): a profile from bottom to top with
    discs at its ends, or the closed profile of a ring, counterclockwise."""
    rings = turned_rings(profile, segments)
    if is_ring:
        return Solid().skin([*rings, rings[0]]).arrays()
    solid = Solid().skin(rings)
    if is_closed:
        solid.fill(rings[-1]).fill(rings[0][::-1])
    return solid.arrays()


def pipe(path, radius, segments, wall=0.0, is_closed=True):
    """Returns a bar along a path, or a pipe with a wall."""
    rings = path_rings(path, circle(radius, segments))
    if wall > 0.0:
        inner = path_rings(path, circle(radius - wall, segments))
        return Solid().skin([*rings, *inner[::-1], rings[0]]).arrays()
    solid = Solid().skin(rings)
    if is_closed:
        solid.fill(rings[-1]).fill(rings[0][::-1])
    return solid.arrays()


def filleted(size, radius, segments):
    """Returns a box with rounded edges and corners."""
    width, depth, height = np.asarray(size) - 2.0 * radius
    angles = np.radians(np.linspace(0.0, 90.0, segments + 1))
    upper = [(radius * np.cos(a), height / 2.0 + radius * np.sin(a)) for a in angles]
    levels = [(inset, -z) for inset, z in upper[::-1]] + upper
    solid = Solid().skin([at(rectangle(width, depth, r, segments), z) for r, z in levels])
    top = rectangle(width, depth)
    solid.fill(at(top, levels[-1][1])).fill(at(top, levels[0][1])[::-1])
    return solid.arrays()


def block(size, features, is_delaunay=True):
    """Returns a box with features on its top and bottom: (side, outline, outline at the end, depth).
    The depth of a boss is negative."""
    solid = Solid(is_delaunay)
    outline = rectangle(*size[:2])
    heights = {"bottom": 0.0, "top": size[2]}
    solid.skin([at(outline, 0.0), at(outline, size[2])])
    for side, height in heights.items():
        sign = 1.0 if side == "top" else -1.0
        holes = []
        for _, begin, end, depth in (f for f in features if f[0] == side):
            mouth, floor = at(begin, height), at(end, height - sign * depth)
            holes.append(mouth)
            rings = [mouth, floor] if side == "top" else [floor, mouth]
            solid.skin(rings)
            solid.fill(floor if side == "top" else floor[::-1])
        face = at(outline, height)
        solid.fill(face if side == "top" else face[::-1], *holes)
    return solid.arrays()


def thread(turns, segments, pitch, depth, crest=0.2):
    """Returns the helical surface of an external thread of radius 1, open at both ends."""
    profile = np.array([[0.0, 1.0 - depth], [0.5 - crest, 1.0 - depth], [0.5 - crest / 2, 1.0]])
    profile = np.vstack(
        [profile, [[0.5 + crest / 2, 1.0], [0.5 + crest, 1.0 - depth], [1, 1 - depth]]]
    )
    angle = 2.0 * np.pi * np.arange(turns * segments + 1) / segments
    rings = [
        np.column_stack([r * np.cos(angle), r * np.sin(angle), pitch * (u + angle / (2.0 * np.pi))])
        for u, r in profile
    ]
    return Solid().skin(rings, is_closed=False).arrays()


def sheet(profile, width):
    """Returns a bent sheet without thickness, open on all sides."""
    x, z = np.asarray(profile, dtype=float).T
    rings = [np.column_stack([x, np.full(len(x), y), z]) for y in (0.0, width)]
    return Solid().skin(rings, is_closed=False).arrays()


def split(arrays, count, fraction):
    """Returns a part of which edges are split at a fraction of their lengths: needles where it is
    small, coplanar faces on planes."""
    edges = edges_apart(np.random.default_rng(SEED), arrays[1], count)
    return split_edges(*arrays, edges, np.full(len(edges), fraction))


def bored(outline, radius, segments, height, **options):
    """Returns an extruded outline with a round bore."""
    return extrude([outline, circle(radius, segments)[::-1]], height, True, **options)


def rounded_channel(bends, radius, leg, segments):
    """Returns the profile of a bent sheet."""
    return bent_path(radius, leg, bends, segments)[:, [0, 2]]


def holes_of(places, radius, end, segments, depth, side="top"):
    """Returns round features of a block; `end` is the radius at their ends."""
    return [
        (side, circle(radius, segments, place), circle(end, segments, place), depth)
        for place in places
    ]


SHAFT = [(0.3, 0), (0.3, 3), (0.5, 3), (0.5, 4), (0.8, 4.2), (0.8, 9), (0.4, 9), (0.4, 14)]
PULLEY = [(0.3, 0), (2, 0), (2, 0.2), (1.6, 0.5), (2, 0.8), (2, 1), (0.3, 1)]
FLANGE = [(0.5, 0), (2, 0), (2, 0.3), (0.7, 0.3), (0.6, 0.4), (0.6, 3), (0.5, 3)]
BOTTLE = [(1, 0), (1, 3), (0.3, 4), (0.3, 5), (0.28, 5), (0.28, 4), (0.98, 2.99), (0.98, 0.02)]
GRID4 = [(x, y) for x in (-3, -1, 1, 3) for y in (-1, 1)]
SLOT = rectangle(2.0, 0.1, 0.2, 24)
EXTRUDED = mirrored(
    np.array([[1, 0.15], [0.9, 0.15], [0.9, 0.35], [0.6, 0.35], [0.3, 0.1], [0.1, 0.3], [0.35, 0.6],
              [0.35, 0.9], [0.15, 0.9], [0.15, 1]])
)  # fmt: skip

PARTS = {
    # Plates with holes.
    "plate-1": lambda: plate(1, 1, 96, 0.02, 0.45),
    "plate-2": lambda: plate(3, 2, 48, 0.1),
    "plate-3": lambda: plate(8, 2, 24, 0.05, 0.1),
    "plate-4": lambda: plate(10, 10, 16, 0.05, 0.35),
    "plate-5": lambda: plate(4, 4, 64, 1.0, 0.48),
    "plate-6": lambda: plate(2, 1, 200, 0.2, 0.49, margin=1.0),
    "plate-7": lambda: plate(3, 2, 48, 0.1, is_delaunay=False),
    "plate-8": lambda: plate(6, 5, 20, 0.02, 0.2, is_delaunay=False, margin=3.0),
    "plate-9": lambda: plate(20, 10, 24, 0.3, 0.4),
    # Extrusions.
    "beam-1": lambda: split(extrude([rail(1, 2, 0.1, 0.1)], 20.0, True, rows=16), 60, 0.5),
    "beam-2": lambda: split(extrude([rail(1, 2, 0.02, 0.05)], 5.0, rows=20), 30, 0.01),
    "rail-1": lambda: extrude([EXTRUDED, circle(0.08, 32)[::-1]], 10.0, True, rows=3),
    "rail-2": lambda: extrude([EXTRUDED], 2.0, True, twist=90.0, rows=24),
    "blade-1": lambda: extrude([airfoil(2.0, 0.12, 100)], 6.0, True),
    "blade-2": lambda: extrude([airfoil(2.0, 0.06, 60)], 4.0, True, 40.0, 0.5, 8),
    "blade-3": lambda: extrude([airfoil(2.0, 0.05, 150)], 1.0),
    "nut-1": lambda: bored(circle(1.0, 6), 0.6, 128, 0.8),
    "nut-2": lambda: bored(circle(1.0, 6), 0.85, 200, 0.3),
    "drill-1": lambda: extrude([toothed(2, 0.3, 1.0, 12, 0.2)], 8.0, True, 720.0, 1.0, 60),
    "washer-1": lambda: bored(circle(1.0, 180), 0.95, 120, 0.05),
    "duct-1": lambda: extrude([rectangle(2, 1), rectangle(1.9, 0.9)[::-1]], 30.0, rows=24),
    "open-1": lambda: extrude([circle(1.0, 150)], 4.0, is_closed=False),
    "open-2": lambda: extrude([toothed(40, 0.9, 1.0, 2)], 3.0, taper=0.3, is_closed=False),
    # Gears.
    "gear-1": lambda: bored(toothed(24, 0.85, 1.0), 0.3, 48, 0.3),
    "gear-2": lambda: bored(toothed(60, 0.93, 1.0, 4), 0.7, 90, 0.1),
    "gear-3": lambda: bored(toothed(16, 0.8, 1.0, 6), 0.25, 24, 0.8, twist=25.0, rows=10),
    "gear-4": lambda: extrude([toothed(100, 0.96, 1.0, 2)], 0.5),
    "gear-5": lambda: bored(toothed(40, 0.9, 1.0, 5), 0.85, 80, 2.0, twist=60.0, rows=16),
    "gear-6": lambda: extrude([toothed(12, 0.5, 1.0, 8)], 0.05, True),
    # Solids of revolution.
    "shaft-1": lambda: turned(SHAFT, 48),
    "shaft-2": lambda: turned(SHAFT, 240),
    "pulley-1": lambda: turned(PULLEY, 64, True),
    "pulley-2": lambda: turned(PULLEY, 360, True),
    "flange-1": lambda: turned(FLANGE, 96, True),
    "bottle-1": lambda: turned([(0.0, 0.0), *BOTTLE, (0.0, 0.02)], 72, is_closed=False),
    "cone-1": lambda: turned([(1.0, 0.0), (0.1, 10.0)], 128),
    "cone-2": lambda: turned([(5.0, 0.0), (0.5, 0.2), (0.5, 2.0)], 100),
    "ring-1": lambda: turned(circle(0.05, 8, (1.0, 0.0)), 200, True),
    "needle-1": lambda: turned([(0.05, 0.0), (0.05, 5.0)], 100),
    "collar-1": lambda: turned([(1.0, 0.0), (1.02, 0.5), (1.0, 1.0)], 200, is_closed=False),
    # Pipes and springs.
    "pipe-1": lambda: pipe(bent_path(1.0, 10.0, (90,), 8), 0.5, 32, 0.05),
    "pipe-2": lambda: pipe(bent_path(1.0, 6.0, (90, -90, 45), 12), 0.3, 64, 0.02),
    "pipe-3": lambda: pipe(bent_path(2.0, 20.0, (180,), 24), 0.2, 24, is_closed=False),
    "pipe-4": lambda: pipe(bent_path(1.0, 8.0, (90, 90, 90), 6), 0.5, 48),
    "pipe-5": lambda: pipe(np.array([[0, 0, 0], [0, 0, 40.0]]), 0.5, 120, 0.01),
    "pipe-6": lambda: pipe(bent_path(1.0, 3.0, (-60, 60), 5), 0.8, 200, 0.1),
    "spring-1": lambda: pipe(helix(1.0, 0.5, 6, 40), 0.1, 12),
    "spring-2": lambda: pipe(helix(1.0, 1.5, 3, 24), 0.3, 40),
    # Threads.
    "thread-1": lambda: thread(8, 40, 0.15, 0.1),
    "thread-2": lambda: thread(40, 80, 0.05, 0.03),
    "thread-3": lambda: thread(3, 100, 0.6, 0.3, 0.1),
    "thread-4": lambda: thread(20, 24, 0.1, 0.02),
    # Boxes with fillets.
    "box-1": lambda: filleted((2, 1, 1), 0.05, 5),
    "box-2": lambda: filleted((10, 5, 1), 0.02, 8),
    "box-3": lambda: filleted((1, 1, 1), 0.002, 6),
    "box-4": lambda: filleted((30, 2, 0.5), 0.1, 12),
    "box-5": lambda: split(filleted((4, 3, 2), 0.05, 5), 60, 0.02),
    # Blocks with pockets, bosses, countersinks.
    "block-1": lambda: block((8, 4, 1), holes_of(GRID4, 0.4, 0.4, 32, 0.6)),
    "block-2": lambda: block((8, 4, 1), holes_of(GRID4, 0.7, 0.3, 48, 0.3)),
    "block-3": lambda: block((8, 4, 0.1), holes_of(GRID4, 0.2, 0.2, 24, -3.0)),
    "block-4": lambda: block(
        (8, 4, 2),
        holes_of(GRID4[:4], 0.5, 0.5, 36, 1.0) + holes_of(GRID4[4:], 0.5, 0.2, 36, -1.0, "bottom"),
        False,
    ),
    "block-5": lambda: block((3, 2, 1), [("top", SLOT, SLOT, 0.95)]),
    "block-6": lambda: split(block((8, 4, 1), holes_of(GRID4, 0.4, 0.3, 24, 0.6)), 100, 0.001),
    "block-7": lambda: block(
        (6, 6, 0.3),
        [("top", rectangle(5, 5, 0.1, 8), rectangle(4.9, 4.9, 0.1, 8), 0.2)]
        + holes_of([(-2.75, 0)], 0.1, 0.1, 64, 0.2, "bottom"),
    ),
    # Bent sheets.
    "sheet-1": lambda: sheet(rounded_channel((90, 90), 0.5, 3.0, 50), 4.0),
    "sheet-2": lambda: sheet(rounded_channel((60, -60, -60, 60) * 6, 0.1, 1.0, 6), 10.0),
    "sheet-3": lambda: sheet(rounded_channel((90, -90, -90, 90) * 4, 0.05, 1.0, 8), 5.0),
    "sheet-4": lambda: split(sheet(rounded_channel((170, -170), 0.02, 4.0, 40), 1.0), 60, 0.3),
}


def make_arrays(name):
    """Returns points and triangles of a part by its name, or None."""
    return PARTS[name]() if name in PARTS else None

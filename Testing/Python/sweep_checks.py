# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties of the result of each filter, on any mesh.

A check takes a Trial, runs its filter by Trial.update() and reports violations by Trial.expect().
Later checks find its return value in Trial.results.
"""

import functools
import os

import numpy as np
import support
import vtkdgg
from sweep_spectral import biharmonic, graphics, greens, movers, splines
from sweep_trial import EXACT, ON_SURFACE, ROUNDING
from sweep_trial import pieces_of, polygon_areas, to_triangles, with_points
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

ACCURACY = 0.05  # accuracy of the graph
CHORD = 2e-3  # largest distance of isolines from their curves, relative to the mean edge
SLOW = 1000  # largest number of points for slow checks
LEVELS = np.linspace(0.05, 0.95, 10)


# --- Distances -----------------------------------------------------------------------------------


def distances_from(trial, algorithm, sources):
    """Returns one row of distances for each source; infinity for unreached points."""
    rows = []
    for source in sources:
        algorithm.SetSourceIds([int(source)])
        found = support.point_array(trial.update(algorithm), "GeodesicDistance")
        connected = trial.surface.component == trial.surface.component[source]
        trial.expect(np.isfinite(found) == connected, "reached is not what is connected")
        trial.expect_most(np.abs(found[source]), 0.0, "not 0 at the source")
        rows.append(np.where(connected, found, np.inf))
    return np.array(rows)


def expect_not_below_straight(trial, rows, sources):
    points = trial.surface.points
    for row, source in zip(rows, sources):
        straight = np.linalg.norm(points - points[source], axis=1)
        trial.expect_most(straight, row + trial.slack(row), "distance below the straight one")


def expect_shortest(trial, rows, sources):
    """Checks distances that are lengths of shortest paths."""
    surface = trial.surface
    a, b = np.concatenate([surface.triangles[surface.proper][:, [i, i - 1]] for i in range(3)]).T
    edge = np.linalg.norm(surface.points[a] - surface.points[b], axis=1)
    for row in rows:
        there = np.isfinite(row)[a]
        step = np.abs(row[a[there]] - row[b[there]])
        trial.expect_most(
            step, edge[there] + trial.slack(row[a[there]]), "distance grows by more than an edge"
        )
    expect_not_below_straight(trial, rows, sources)
    expect_symmetry(trial, rows[:, sources])


def expect_symmetry(trial, matrix):
    trial.expect_close(matrix.T, matrix, "not symmetric")


def exact(trial):
    sources = trial.surface.sources
    rows = distances_from(trial, trial.make("vtkExactGeodesicDistance"), sources)
    expect_shortest(trial, rows, sources)
    return rows


def engines(trial):
    """The reference engine gives the same, on meshes for which it is not too slow."""
    if len(trial.surface.points) > SLOW or "exact" not in trial.results:
        return
    reference = vtkdgg.vtkExactGeodesicDistance.Reference
    algorithm = trial.make("vtkExactGeodesicDistance", Engine=reference)
    rows = distances_from(trial, algorithm, trial.surface.sources)
    trial.expect_close(rows, trial.results["exact"], "distances of engines differ")


def graph(trial):
    output = trial.update(trial.make("vtkDiscreteGeodesicGraph", Accuracy=ACCURACY))
    path = os.path.join(trial.folder, "graph.vtp")
    writer = support.make(vtkXMLPolyDataWriter, output, FileName=path)
    writer.SetCompressorTypeToNone()
    writer.EncodeAppendedDataOff()
    vtkdgg.check(writer)
    again = trial.graph()
    for i in range(output.GetFieldData().GetNumberOfArrays()):
        array = output.GetFieldData().GetArray(i)
        copy = again.GetFieldData().GetArray(array.GetName())
        same = copy is not None and np.array_equal(vtk_to_numpy(array), vtk_to_numpy(copy))
        trial.expect(same, f"{array.GetName()} differs after a file")
    algorithm = trial.make("vtkDGGDistance", again, Correction=False)
    sources = trial.surface.sources
    raw = distances_from(trial, algorithm, sources)
    trial.expect(algorithm.GetUsedInputGraph(), "the graph of the file is not used")
    expect_not_below_straight(trial, raw, sources)
    expect_symmetry(trial, raw[:, sources])
    algorithm.CorrectionOn()
    corrected = distances_from(trial, algorithm, sources)
    if "exact" in trial.results:
        true, relative = trial.results["exact"], ACCURACY * (1 + ROUNDING)
        expect_promise(trial, raw, true)
        trial.expect_close(corrected, true, "corrected distance beyond accuracy", relative)
    return True


def expect_promise(trial, found, true):
    reached = np.isfinite(true)
    found, true = found[reached], true[reached]
    slack = trial.slack(true)
    trial.expect_most(true - slack, found, "distance in the graph below the exact one")
    bound = (1 + ACCURACY) * true * (1 + ROUNDING) + slack
    trial.expect_most(found, bound, "distance in the graph above the promise")


def matrix(trial):
    sources = trial.surface.sources
    rows = sources.tolist()
    algorithm = trial.make("vtkGeodesicDistanceMatrix", trial.graph(), RowIds=rows)
    trial.update(algorithm)
    found = np.array(vtk_to_numpy(algorithm.GetMatrix())).reshape(len(sources), len(sources))
    found = np.where(np.isnan(found), np.inf, found)
    trial.expect(found == found.T, "not symmetric")
    trial.expect(np.diag(found) == 0.0, "not 0 on the diagonal")
    if "exact" in trial.results:
        expect_promise(trial, found, trial.results["exact"][:, sources])


def local(trial):
    """Sparse rows are the near part of dense rows, and bounded distances of unbounded distances."""
    sources, count = trial.surface.sources, len(trial.surface.points)
    ids = {"RowIds": sources.tolist(), "ColumnIds": list(range(count))}
    algorithm = trial.make("vtkGeodesicDistanceMatrix", trial.graph(), **ids)
    trial.update(algorithm)
    dense = np.array(vtk_to_numpy(algorithm.GetMatrix())).reshape(len(sources), count)
    # Between two distances, as rounding decides at the radius itself.
    radius = np.nanquantile(dense, 0.1) * (1.0 + 1e-9)
    algorithm.SetColumnIds([])
    algorithm.CompressedRowsOn()
    algorithm.SetMaximumDistance(radius)
    table = trial.update(algorithm)
    starts = vtk_to_numpy(table.GetFieldData().GetArray("RowOffsets"))
    columns = vtk_to_numpy(table.GetColumnByName("Column"))
    found = np.full(dense.shape, np.inf)
    rows = np.repeat(np.arange(len(sources)), np.diff(starts))
    found[rows, columns] = vtk_to_numpy(table.GetColumnByName("GeodesicDistance"))
    near = dense <= radius
    trial.expect(np.isfinite(found) == near, "sparse row is not the near part of the dense one")
    trial.expect_close(found[near], dense[near], "sparse distance is not the dense one")
    search = trial.make("vtkDGGDistance", trial.graph(), SourceIds=[int(sources[0])])
    fields = []
    for limit in (np.inf, radius):
        search.SetMaximumDistance(limit)
        fields.append(support.point_array(trial.update(search), "GeodesicDistance"))
    expected = np.where(fields[0] <= radius, fields[0], np.nan)
    trial.expect(
        (fields[1] == expected) | (np.isnan(fields[1]) & np.isnan(expected)),
        "bounded distance is not the near part of the unbounded one",
    )


def naming(trial):
    """Functions give the same answers for sources by id and as corners of triangles."""
    surface = trial.surface
    exact = functools.partial(vtkdgg.distance, trial.mesh, merge_coincident_points=surface.merge)
    ids = surface.sources[:2].tolist()
    pairs = []
    for i in ids:
        faces, corners = np.nonzero((surface.triangles == i) & surface.proper[:, None])
        pairs.append((int(faces[-1]), np.eye(3)[corners[-1]]))
    graph = vtkdgg.Graph(trial.graph())
    radius = np.nanquantile(graph.distance(ids), 0.1) * (1.0 + 1e-9)
    for name, answer in (
        ("exact distance", exact),
        ("bounded exact distance", functools.partial(exact, maximum_distance=radius)),
        ("distance", graph.distance),
        ("bounded distance", functools.partial(graph.distance, maximum_distance=radius)),
        ("matrix", lambda points: graph.matrix(points, surface.sources)),
        ("sparse_matrix", lambda points: graph.sparse_matrix(radius, points).toarray()),
        ("paths", lambda points: [p.length for p in graph.paths(points[:1], points) if p]),
        ("neighborhood", lambda points: graph.neighborhood(points[0], radius)[1]),
    ):
        with trial.timer:
            expected, found = np.array(answer(ids)), np.array(answer(pairs))
        trial.expect(np.isnan(found) == np.isnan(expected), f"{name}: other points are reached")
        trial.expect_close(found, expected, f"{name} of corners of triangles is not that of ids")


def files(trial):
    """A mesh that was written and read is the same, and its ids give the same distances."""
    surface, source = trial.surface, int(trial.surface.sources[0])
    for extension in (".vtp", ".vtk", ".ply", ".obj", ".off"):
        path = os.path.join(trial.folder, f"mesh{extension}")
        with trial.timer:
            vtkdgg.write(path, trial.mesh)
            mesh = vtkdgg.read(path)
            found = vtkdgg.distance(mesh, source, merge_coincident_points=surface.merge)
        trial.expect(mesh.points == surface.points, f"{extension}: other points")
        trial.expect(mesh.triangles == surface.cells, f"{extension}: other triangles")
        true = trial.results["exact"][0] if "exact" in trial.results else found
        trial.expect_close(found, true, f"{extension}: other distances")


def approximate(kind):
    def check(trial):
        rows = distances_from(trial, trial.make(kind), trial.surface.sources[:2])
        trial.expect(rows >= 0.0, "negative distance")

    return check


# --- Curves --------------------------------------------------------------------------------------


def expect_on_surface(trial, lines, what):
    """Checks that both ends of each piece lie in its face, which is convex. Returns pieces, lines,
    ends and faces."""
    pieces, line = pieces_of(lines)
    points = vtk_to_numpy(lines.GetPoints().GetData()) if len(pieces) else np.empty((0, 3))
    face = support.point_array(lines, "FaceId")[pieces[:, 0]] if len(pieces) else line
    cells = trial.surface.cells
    trial.expect((face >= 0) & (face < len(cells)), f"{what}: no such face")
    face = np.clip(face, 0, len(cells) - 1)
    corners = trial.surface.points[cells[face]]
    bound = ON_SURFACE * trial.surface.sides[face].max(axis=1) + trial.surface.rounding
    bound += 2 * trial.moved
    ends = points[pieces]
    for place, text in ((ends[:, 0], "start"), (ends[:, 1], "end")):
        trial.expect(np.isfinite(place), f"{what}: {text} is not finite")
        trial.expect_most(
            to_triangles(place, corners), bound, f"{what}: {text} of a piece is off its face"
        )
    return pieces, line, ends, face


def expect_lengths(trial, lines, what):
    """Checks that the array has the lengths of the polylines, and returns the array."""
    _, line, ends, face = expect_on_surface(trial, lines, what)
    lengths = vtk_to_numpy(lines.GetCellData().GetArray("Length")) if len(ends) else np.empty(0)
    step = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    summed = np.bincount(line, step, minlength=len(lengths))
    slack = trial.lengthened + trial.surface.rounding + trial.gained(face)
    slack = np.bincount(line, slack, minlength=len(lengths))
    trial.expect_most(
        np.abs(summed - lengths), EXACT * lengths + slack, f"{what}: Length is not of its points"
    )
    return lengths


def paths(method):
    def check(trial):
        surface = trial.surface
        sources = surface.sources
        targets = surface.rng.choice(np.unique(surface.triangles[surface.proper]), 3)
        mesh = trial.mesh if method else trial.graph()
        algorithm = trial.make("vtkDGGPath", mesh, Method=method)
        pairs = [(i, j) for i in range(len(sources)) for j in np.append(sources, targets)]
        for i, j in pairs:
            algorithm.AddPair(int(sources[i]), int(j))
        output = trial.update(algorithm)
        start, end = np.array([(sources[i], j) for i, j in pairs]).T
        connected = surface.component[start] == surface.component[end]
        status = vtk_to_numpy(output.GetFieldData().GetArray("PathStatus"))
        trial.expect((status == 0) == connected, "PathStatus is not what is connected")
        lengths = expect_lengths(trial, output, "path")
        if len(lengths) == 0:
            return
        points = vtk_to_numpy(output.GetPoints().GetData())
        offsets = vtk_to_numpy(output.GetLines().GetOffsetsArray())
        ids = vtk_to_numpy(output.GetLines().GetConnectivityArray())
        pair = vtk_to_numpy(output.GetCellData().GetArray("PairId"))
        for place, wanted in ((offsets[:-1], start), (offsets[1:] - 1, end)):
            gap = np.linalg.norm(points[ids[place]] - surface.points[wanted[pair]], axis=1)
            trial.expect_most(gap, surface.rounding, "path does not end where it should")
        if "exact" not in trial.results:
            return
        true = np.array([trial.results["exact"][i, j] for i, j in pairs])[pair]
        # Paths that pass a point closely go through it.
        slack = trial.slack(true) + ON_SURFACE * surface.sides.max()
        trial.expect_most(true - slack, lengths, "path below the exact distance")
        if method:
            trial.expect_most(lengths, true + slack, "exact path too long")
            return
        bound = vtk_to_numpy(output.GetCellData().GetArray("GraphLength"))
        trial.expect_most(lengths, bound + slack, "path above its bound")
        expect_promise(trial, bound, true)

    return check


def loops(trial):
    ids = trial.surface.inner[:2].tolist()
    algorithm = trial.make("vtkDGGLoop", trial.graph(), PointIds=ids)
    for taut in (False, True):
        algorithm.SetTaut(taut)
        expect_lengths(trial, trial.update(algorithm), "loop")
    algorithm.SetModeToAroundHandles()
    expect_lengths(trial, trial.update(algorithm), "loop around a handle")


def isolines(make, accuracy):
    """Returns a check of isolines of a distance filter; an accuracy of 0 is an exact filter."""

    def check(trial):
        source = int(trial.surface.inner[0])
        distance = make(trial)
        distance.SetSourceIds([source])
        field = trial.update(distance)
        values = support.point_array(field, "GeodesicDistance")
        algorithm = trial.make("vtkApolloniusIsolines", field, GenerateBands=True)
        levels = LEVELS * np.nanmax(values)
        for i, level in enumerate(levels):
            algorithm.SetValue(i, level)
        lines = trial.update(algorithm)
        has_windows = bool(field.GetFieldData().HasArray("GeodesicDistance.Windows"))
        trial.expect(algorithm.GetUsedWindows() == has_windows, "windows are used, or not")
        _, line, ends, face = expect_on_surface(trial, lines, "isoline")
        inside = np.isfinite(values)[trial.surface.cells].all(axis=1)
        expect_parts(trial, algorithm.GetBands(), inside, "bands")
        if len(ends) == 0:
            return
        level = vtk_to_numpy(lines.GetCellData().GetArray("IsoValue"))[line]
        expect_levels(trial, values, ends, face, level, accuracy)
        if accuracy == 0.0:
            fallbacks = algorithm.GetNumberOfFallbacks()
            expect_exact_levels(trial, source, ends, face, level, fallbacks)

    return check


def expect_levels(trial, values, ends, face, level, accuracy):
    """Checks that values differ from the values of corners by at most the distance from there.
    Values that are not exact may also lie between the values of the corners, and a value at an end
    on an edge may be that of the other face."""
    corners = trial.surface.cells[face]
    way = np.linalg.norm(ends[:, :, None] - trial.surface.points[corners][:, None], axis=3)
    excess = (np.abs(values[corners] - level[:, None])[:, None] - way).max(axis=2)
    excess = excess.min(axis=1) if accuracy > 0 else excess.max(axis=1)
    if accuracy > 0:
        least, most = values[corners].min(axis=1), values[corners].max(axis=1)
        excess[(least <= level) & (level <= most)] = 0.0
    slack = trial.slack(level) + ON_SURFACE * trial.surface.sides[face].max(axis=1)
    trial.expect_most(excess, accuracy * level + slack, "isoline where corners forbid its value")


def expect_exact_levels(trial, source, ends, face, level, fallbacks):
    """Checks that the middles of some pieces, inserted into the mesh, have the value as exact
    distance, except for the number of pieces that the filter reports."""
    surface = trial.surface
    long = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) > 1e-3 * surface.mean_edge
    fat = surface.areas[face] > 1e-3 * surface.sides[face].max(axis=1) ** 2
    chosen = np.flatnonzero(long & fat)
    chosen = surface.rng.permutation(chosen)[:100]
    _, first = np.unique(surface.first_copy[face[chosen]], return_index=True)
    chosen = chosen[first]
    middles = ends[chosen].mean(axis=1)
    found = exact_inside(trial, source, middles, surface.first_copy[face[chosen]])
    bound = CHORD * surface.mean_edge + trial.slack(level[chosen])
    excess = np.sort(np.abs(found - level[chosen]) - bound)[: max(0, len(found) - fallbacks)]
    trial.expect_most(excess, 0.0, "isoline is not at its level")


def exact_inside(trial, source, places, faces):
    """Returns exact distances of positions inside faces, one in each, inserted into the mesh."""
    mesh = support.polydata(*with_points(trial.surface, places, faces))
    algorithm = trial.make("vtkExactGeodesicDistance", mesh, SourceIds=[source])
    found = support.point_array(trial.update(algorithm), "GeodesicDistance")
    return found[len(trial.surface.points) :]


def probe(trial):
    """Probes of windows inside faces, where no other face is near."""
    surface = trial.surface
    source = int(surface.inner[0])
    fat = surface.areas > 1e-3 * surface.sides.max(axis=1) ** 2
    faces = surface.rng.permutation(np.flatnonzero(surface.once & fat))[:20]
    corners = surface.points[surface.triangles]
    places = np.einsum("ij,ijk->ik", surface.rng.dirichlet([3, 3, 3], len(faces)), corners[faces])
    away = [to_triangles(np.broadcast_to(place, (len(corners), 3)), corners) for place in places]
    alone = np.flatnonzero([(way < CHORD * surface.mean_edge).sum() == 1 for way in away])
    reached = surface.component[surface.triangles[faces[alone], 0]] == surface.component[source]
    alone = alone[reached]
    if len(alone) == 0:
        return
    distance = with_windows(trial)
    distance.SetSourceIds([source])
    data = {"ProbeData": support.polydata(places[alone])}
    algorithm = trial.make("vtkGeodesicProbe", trial.update(distance), **data)
    found = support.point_array(trial.update(algorithm), "GeodesicDistance")
    true = exact_inside(trial, source, places[alone], faces[alone])
    trial.expect_close(found, true, "probe is not the exact distance")


# --- Cells ---------------------------------------------------------------------------------------


def expect_parts(trial, polygons, wanted, what):
    """Checks that polygons fill their triangles, and a copy of each wanted triangle."""
    surface = trial.surface
    face = []
    if polygons.GetNumberOfCells() > 0:
        face = vtk_to_numpy(polygons.GetCellData().GetArray("FaceId"))
    areas = np.bincount(face, polygon_areas(polygons), len(surface.cells)) if len(face) else None
    there = np.zeros(len(surface.cells), dtype=bool)
    there[face] = True
    copies = np.zeros(len(surface.cells), dtype=bool)
    copies[surface.first_copy[there]] = True
    longest = surface.sides.max(axis=1)
    wanted = wanted & (2 * surface.areas > 4 * trial.moved * longest)
    for face in np.flatnonzero(surface.once & wanted & ~copies)[:100]:
        copies[face] = lies_in_another(trial, face, there)
    trial.expect(copies[surface.once & wanted], f"{what}: a triangle is left out")
    if areas is not None:
        bound = EXACT * surface.areas + (surface.rounding + 2 * trial.moved) * longest
        trial.expect_most(
            np.abs(areas - surface.areas)[there], bound[there], f"{what}: a triangle is not filled"
        )


def lies_in_another(trial, face, there):
    """Returns true if a triangle is a part of another one: after caps are split, it may be a
    duplicate of the rest, and counts once."""
    surface = trial.surface
    shared = np.isin(surface.triangles, surface.triangles[face]).sum(axis=1)
    corners = surface.points[surface.cells[there & (shared >= 2)]]
    own = surface.points[surface.cells[face]]
    off = [to_triangles(np.broadcast_to(place, (len(corners), 3)), corners) for place in own]
    bound = ON_SURFACE * surface.sides[face].max() + surface.rounding + 2 * trial.moved
    return (np.max(off, axis=0) <= bound).any()


def voronoi(trial):
    surface, sites = trial.surface, trial.surface.sources
    algorithm = trial.make("vtkGeodesicVoronoi", trial.graph(), SiteIds=sites.tolist())
    output = trial.update(algorithm)
    label = support.point_array(output, "GeodesicSource")
    reached = np.isin(surface.component, surface.component[sites])
    trial.expect((label >= 0) == reached, "labelled is not what is connected")
    if "exact" in trial.results:
        rows = trial.results["exact"]
        points = np.flatnonzero(reached)
        nearest = rows.min(axis=0)[points]
        own = rows[label[points], points]
        bound = nearest * (1 + ACCURACY) / (1 - ACCURACY) * (1 + ROUNDING) + trial.slack(nearest)
        trial.expect_most(own, bound, "label is not that of the nearest site")
    cells = algorithm.GetCells()
    expect_parts(trial, cells, surface.proper, "cells")
    site, index = np.unique(vtk_to_numpy(cells.GetCellData().GetArray("SiteId")), return_index=True)
    area = vtk_to_numpy(cells.GetCellData().GetArray("CellArea"))[index][site >= 0].sum()
    inside = reached[surface.cells].all(axis=1) & surface.once
    whole = surface.areas[inside].sum()
    longest = surface.sides[inside].max(axis=1)
    slack = EXACT * whole + ((trial.moved + 0.5 * trial.gained(inside)) * longest).sum()
    trial.expect_most(abs(area - whole), slack, f"areas of cells do not sum to {whole:.6g}")


def sampler(trial):
    output = trial.update(trial.make("vtkGeodesicSampler", trial.graph(), NumberOfSamples=30))
    radius = support.point_array(output, "CoveringRadius")
    ids = support.point_array(output, "vtkOriginalPointIds")
    trial.expect(radius[1:] <= radius[:-1], "covering radius grows")
    trial.expect(len(np.unique(ids)) == len(ids), "a sample is taken twice")
    surface = trial.surface
    pieces = len(np.unique(surface.component[surface.component >= 0]))
    trial.expect(np.isfinite(radius[-1]) == (len(ids) >= pieces), "a component without a sample")


# --- Correspondence ------------------------------------------------------------------------------


def patches(trial):
    """The surface and a rotated copy."""
    surface = trial.surface
    landmarks = surface.inner[:3].tolist()
    algorithm = trial.make(
        "vtkGeodesicPatchBoundaries",
        SecondSurfaceData=support.polydata(surface.points[:, [1, 2, 0]], surface.cells),
        FirstLandmarkIds=landmarks,
        SecondLandmarkIds=landmarks,
        LayoutData=support.polyline(surface.points[landmarks]),
    )
    curves = trial.update(algorithm)
    lengths = expect_lengths(trial, curves, "curve")
    trial.expect(np.isfinite(lengths), "not finite")
    edges, others = (
        vtk_to_numpy(algorithm.GetOutput(i).GetCellData().GetArray("LayoutEdge")) for i in (0, 1)
    )
    trial.expect(len(edges) == 2 and np.array_equal(edges, others), "curves do not correspond")


def with_windows(trial):
    return trial.make("vtkExactGeodesicDistance", GenerateWindows=True)


def with_fit(trial):
    return trial.make("vtkExactGeodesicDistance")


def with_virtual_sources(trial):
    return trial.make("vtkDGGDistance", trial.graph(), GenerateVirtualSource=True)


# In this order: some need the results of earlier checks. Checks on all meshes come first.
CHECKS = {
    "exact": exact,
    "engines": engines,
    "graph": graph,
    "path": paths(vtkdgg.vtkDGGPath.Graph),
    "exact-path": paths(vtkdgg.vtkDGGPath.Exact),
    "isolines": isolines(with_windows, 0.0),
    "isolines-fit": isolines(with_fit, 2 * ACCURACY),
    "isolines-graph": isolines(with_virtual_sources, 2 * ACCURACY),
    "probe": probe,
    "voronoi": voronoi,
    "sampler": sampler,
    "matrix": matrix,
    "local": local,
    "naming": naming,
    "files": files,
    "loop": loops,
    "patches": patches,
    "heat": approximate("vtkHeatGeodesicDistance"),
    "marching": approximate("vtkDGGFastMarchingDistance"),
    "propagation": approximate("vtkVirtualSourceGeodesicDistance"),
    "greens": greens("SingularitySubtraction"),
    "greens-linear": greens("Interpolated"),
    "biharmonic": biharmonic,
    "spline": splines,
    "movers": movers,
    "graphics": graphics,
}
LARGE = ["exact", "graph", "path"]  # checks on meshes of any size
# Checks that run before a check: the graph, or results to compare with.
NEEDS = {
    "engines": ["exact"],
    "graph": ["exact"],
    "path": ["exact", "graph"],
    "exact-path": ["exact"],
    "isolines-graph": ["graph"],
    "voronoi": ["exact", "graph"],
    "sampler": ["graph"],
    "matrix": ["exact", "graph"],
    "local": ["graph"],
    "naming": ["graph"],
    "files": ["exact"],
    "loop": ["graph"],
}

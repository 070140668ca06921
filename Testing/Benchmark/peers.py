# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Packages that compute geodesics, behind one interface.

A method is a class, with functions for its tasks:

  prepare()           what precedes the first of many queries on a mesh
  distance(sources)   distances of all points from the nearest source
  matrix(vertices)    distances between all pairs of vertices
  path(start, end)    points of a path between two vertices
"""

import ctypes

import numpy as np

NO_IDS = np.empty(0, dtype=np.int64)


class Method:
    """Base class: a matrix has rows that are distances from one source."""

    package = "vtkdgg"  # name on PyPI
    module = "vtkdgg"
    tasks = ("one", "many", "matrix")

    def __init__(self, library, points, triangles):
        self.library, self.points, self.triangles = library, points, triangles
        self.prepare()

    def prepare(self):
        """Does nothing: the package prepares the mesh in each query."""

    def matrix(self, vertices):
        """Returns one row per vertex."""
        return np.stack([self.distance([vertex])[vertices] for vertex in vertices])


class Exact(Method):
    """Exact distances and paths of vtkDGG."""

    module = "vtkdgg.compat.pygeodesic.geodesic"
    tasks = ("one", "many", "matrix", "path")

    def prepare(self):
        self.solver = self.library.PyGeodesicAlgorithmExact(self.points, self.triangles)

    def distance(self, sources):
        return self.solver.geodesicDistances(np.asarray(sources))[0]

    def path(self, start, end):
        return self.solver.geodesicDistance(start, end)[1]


class Pygeodesic(Exact):
    package = "pygeodesic"
    module = "pygeodesic.geodesic"


class Gdist(Method):
    package = "tvb-gdist"
    module = "gdist"

    def prepare(self):
        self.mesh = self.points, self.triangles.astype(np.int32)

    def distance(self, sources):
        ids = np.asarray(sources, dtype=np.int32)
        return self.library.compute_gdist(*self.mesh, source_indices=ids)

    def matrix(self, vertices):
        ids = np.asarray(vertices, dtype=np.int32)
        found = self.library.distance_matrix_of_selected_points(*self.mesh, ids)
        return found.tocsr()[ids][:, ids].toarray()


class LibiglExact(Method):
    package = "libigl"
    module = "igl"

    def distance(self, sources):
        all_ids = np.arange(len(self.points))
        return self.library.exact_geodesic(
            self.points, self.triangles, np.asarray(sources), NO_IDS, all_ids, NO_IDS
        )


class LibiglHeat(Method):
    package = "libigl"
    module = "igl"

    def prepare(self):
        self.data = self.library.HeatGeodesicsData()
        self.library.heat_geodesics_precompute(self.points, self.triangles, self.data)

    def distance(self, sources):
        return self.library.heat_geodesics_solve(self.data, np.asarray(sources))


class Graph(Method):
    """Distances and paths in a graph of vtkDGG."""

    tasks = ("one", "many", "matrix", "path")
    accuracy = 0.01

    def prepare(self):
        self.graph = self.library.Graph(self.points, self.triangles, accuracy=self.accuracy)

    def distance(self, sources):
        return self.graph.distance(sources)

    def matrix(self, vertices):
        return self.graph.matrix(vertices)

    def path(self, start, end):
        return self.graph.path(start, end).points


class CoarseGraph(Graph):
    accuracy = 0.1


class VirtualSources(Method):
    """Propagation from virtual sources in vtkDGG."""

    def distance(self, sources):
        return self.library.distance(self.points, self.triangles, sources, method="fast")


class Heat(Method):
    """The heat method of vtkDGG."""

    module = "vtkdgg.compat.potpourri3d"

    def prepare(self):
        self.solver = self.library.MeshHeatMethodDistanceSolver(self.points, self.triangles)
        self.distance([0])  # ours factorizes in the first query

    def distance(self, sources):
        return self.solver.compute_distance_multisource(sources)


class PotpourriHeat(Heat):
    package = "potpourri3d"
    module = "potpourri3d"


class PotpourriMarching(Method):
    package = "potpourri3d"
    module = "potpourri3d"

    def prepare(self):
        self.solver = self.library.MeshFastMarchingDistanceSolver(self.points, self.triangles)

    def distance(self, sources):
        return self.solver.compute_distance([[(source, [])] for source in sources])


class PotpourriFlips(Method):
    """Paths by edge flips."""

    package = "potpourri3d"
    module = "potpourri3d"
    tasks = ("path",)

    def prepare(self):
        self.solver = self.library.EdgeFlipGeodesicSolver(self.points, self.triangles)

    def path(self, start, end):
        return self.solver.find_geodesic_path(start, end)


class Pymeshlab(Method):
    package = "pymeshlab"
    module = "pymeshlab"

    def prepare(self):
        mesh = self.library.Mesh(self.points, self.triangles.astype(np.int32))
        self.meshes = self.library.MeshSet()
        self.meshes.add_mesh(mesh)
        # The largest value that the package accepts, in percent of the diagonal of the mesh.
        self.limit = {"maxdistance": self.library.PercentageValue(100)}
        self.calls = 0

    def distance(self, sources):
        mesh = self.meshes.current_mesh()
        if len(sources) == 1:
            self.meshes.compute_scalar_by_geodesic_distance_from_given_point_per_vertex(
                startpoint=self.points[sources[0]], **self.limit
            )
        else:
            is_source = np.zeros(len(self.points))
            is_source[sources] = 1.0
            self.calls += 1  # an attribute cannot be replaced
            mesh.add_vertex_custom_scalar_attribute(is_source, f"source{self.calls}")
            condition = f"(source{self.calls} > 0.5)"
            self.meshes.compute_selection_by_condition_per_vertex(condselect=condition)
            self.meshes.compute_scalar_by_geodesic_distance_from_selection_per_vertex(**self.limit)
        found = np.array(mesh.vertex_scalar_array())
        found[(found == 0.0) & ~np.isin(np.arange(len(found)), sources)] = np.inf  # unreached
        return found


class Meshlib(Method):
    package = "meshlib"
    module = "meshlib.mrmeshnumpy"
    tasks = ("one", "many", "matrix", "path")

    def prepare(self):
        from meshlib import mrmeshpy

        self.geometry = mrmeshpy
        self.mesh = self.library.meshFromFacesVerts(self.triangles.astype(np.int32), self.points)

    def distance(self, sources):
        is_source = np.zeros(len(self.points), dtype=bool)
        is_source[sources] = True
        bits = self.library.vertBitSetFromBools(is_source)
        found = self.geometry.computeSurfaceDistances(self.mesh, bits)
        numbers = ctypes.c_float * found.size()
        return np.array(numbers.from_address(found.vec.data_pointer()), dtype=np.float64)

    def path(self, start, end):
        geometry, mesh = self.geometry, self.mesh
        ends = [geometry.MeshTriPoint(mesh.topology, geometry.VertId(id)) for id in (start, end)]
        crossings = [mesh.edgePoint(p) for p in geometry.computeGeodesicPath(mesh, *ends)]
        inner = [(p.x, p.y, p.z) for p in crossings]
        return np.array([self.points[start], *inner, self.points[end]])


class Scipy(Method):
    """Paths along edges."""

    package = "scipy"
    module = "scipy.sparse.csgraph"
    tasks = ("one", "many", "matrix", "path")

    def prepare(self):
        from scipy.sparse import coo_matrix

        tails, heads = self.triangles.ravel(), np.roll(self.triangles, -1, axis=1).ravel()
        ends = np.unique(np.sort(np.stack([tails, heads]), axis=0), axis=1)
        lengths = np.linalg.norm(self.points[ends[0]] - self.points[ends[1]], axis=1)
        shape = (len(self.points),) * 2
        edges = coo_matrix((lengths, tuple(ends)), shape=shape).tocsr()
        self.edges = edges + edges.T

    def distance(self, sources):
        return self.library.dijkstra(self.edges, indices=sources, min_only=True)

    def matrix(self, vertices):
        return self.library.dijkstra(self.edges, indices=vertices)[:, vertices]

    def path(self, start, end):
        _, before = self.library.dijkstra(self.edges, indices=start, return_predecessors=True)
        found = [end]
        while found[-1] != start:
            found.append(before[found[-1]])
        return self.points[found]


class Lagrange(Method):
    """Engines of Lagrange take one source, a point in a facet."""

    package = "adobe-lagrange"
    module = "lagrange"
    tasks = ("one", "matrix")
    engine = "GeodesicEngineMMP"

    def prepare(self):
        self.mesh = self.library.SurfaceMesh()
        self.mesh.add_vertices(self.points)
        self.mesh.add_triangles(self.triangles.astype(np.uint32))
        self.solver = getattr(self.library.geodesic, self.engine)(self.mesh)
        self.corner = np.empty(len(self.points), dtype=np.int64)
        self.corner[self.triangles.ravel()] = np.arange(self.triangles.size)

    def place(self, vertex):
        """Returns a facet, and the coordinates of the vertex in this facet."""
        facet, corner = divmod(int(self.corner[vertex]), 3)
        return facet, ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))[corner]

    def distance(self, sources):
        (source,) = sources
        self.solver.single_source_geodesic(*self.place(source))
        return np.array(self.mesh.attribute("@geodesic_distance").data, dtype=np.float64)

    def path(self, start, end):
        (facet, weights), (last, last_weights) = self.place(start), self.place(end)
        found = self.solver.point_to_point_geodesic_path(facet, last, weights, last_weights)
        return np.array(found[0])


class LagrangeExact(Lagrange):
    tasks = ("one", "matrix", "path")


class LagrangeHeat(Lagrange):
    engine = "GeodesicEngineHeat"


class LagrangePolar(Lagrange):
    engine = "GeodesicEngineDGPC"


class LagrangeFlips(Lagrange):
    engine = "GeodesicEngineFlip"
    tasks = ("path",)


METHODS = {
    "vtkDGG, exact": Exact,
    "pygeodesic, exact": Pygeodesic,
    "tvb-gdist, exact": Gdist,
    "libigl, exact": LibiglExact,
    "Lagrange, exact (MMP)": LagrangeExact,
    "vtkDGG, graph, ε = 0.01": Graph,
    "vtkDGG, graph, ε = 0.1": CoarseGraph,
    "vtkDGG, virtual sources": VirtualSources,
    "vtkDGG, heat": Heat,
    "potpourri3d, heat": PotpourriHeat,
    "libigl, heat": LibiglHeat,
    "Lagrange, heat": LagrangeHeat,
    "potpourri3d, fast marching": PotpourriMarching,
    "MeshLib": Meshlib,
    "PyMeshLab": Pymeshlab,
    "Lagrange, polar coordinates (DGPC)": LagrangePolar,
    "potpourri3d, edge flips": PotpourriFlips,
    "Lagrange, edge flips": LagrangeFlips,
    "SciPy, Dijkstra on edges": Scipy,
}

# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""``mesh.dgg`` of the meshes of PyVista, and its reader of PCD files.

PyVista 0.48 and newer finds both by the entry points of the installed package, or after this module
is imported. PolyData and UnstructuredGrid are surfaces or clouds, PointSet is a cloud.
"""

from __future__ import annotations

from typing import Any, Optional

import pyvista

from . import distances, graphics, layouts, paths, spectral
from .arguments import with_flags
from .cloud_graph import CloudGraph
from .graph import Graph
from .reading import read


class DGGAccessor:
    """Geodesics on a mesh of PyVista; results with points are meshes of PyVista as well.

    `paths`, `isolines`, `loop`, `sample` and `voronoi`, and `distance` with an `accuracy`, use a
    graph that is built by the first call and kept until the mesh or the accuracy changes. Without
    an `accuracy` the graph on the mesh is used if there is one; otherwise the accuracy of a graph
    is 0.01, and distances are exact.
    """

    def __init__(self, dataset: Any) -> None:
        self._mesh = dataset
        self._graph = None
        self._key = None

    def graph(self, accuracy: Optional[float] = None, **options: Any) -> Any:
        """The `vtkdgg.Graph` of the mesh, or the `vtkdgg.CloudGraph` of points without polygons."""
        key = (accuracy, repr(sorted(options.items())), self._mesh.GetMTime())
        if key != self._key:
            if self._is_cloud():
                if accuracy is not None:
                    raise ValueError("accuracy: applies to meshes, not to point clouds")
                self._graph = CloudGraph(self._mesh, **options)
            else:
                self._graph = Graph(self._mesh, accuracy=accuracy, **options)
            self._key = key
        return self._graph

    def distance(self, sources: Any, accuracy: Optional[float] = None, **options: Any) -> Any:
        """The mesh with the point array "GeodesicDistance"; see `vtkdgg.distance`."""
        if accuracy is not None or self._is_cloud():
            return _wrapped(self.graph(accuracy).distance, sources, **options)
        return _wrapped(distances.distance, self._mesh, sources, **options)

    @with_flags
    def geodesic(
        self,
        start_vertex: Any,
        end_vertex: Any,
        inplace: bool = False,
        keep_order: bool = True,
        use_scalar_weights: bool = False,
        progress_bar: bool = False,
    ) -> Any:
        """A shortest path, with the arguments of PyVista's `geodesic`, which follows edges.

        The path is exact, or that of the graph on the mesh if there is one. Ends may be any surface
        points. The point array "vtkOriginalPointIds" is -1 where the path crosses edges and faces.
        There are no scalar weights, and `progress_bar` is ignored.
        """
        found = pyvista.wrap(self._path(start_vertex, end_vertex, use_scalar_weights, True))
        if not keep_order:
            found.lines = found.lines[:1].tolist() + found.lines[:0:-1].tolist()
        if not inplace:
            return found
        self._mesh.copy_from(found)
        return self._mesh

    @with_flags
    def geodesic_distance(
        self,
        start_vertex: Any,
        end_vertex: Any,
        use_scalar_weights: bool = False,
        progress_bar: bool = False,
    ) -> float:
        """The length of `geodesic`, with the arguments of PyVista's `geodesic_distance`."""
        return self._path(start_vertex, end_vertex, use_scalar_weights, False).length

    def paths(
        self, starts: Any, ends: Any, accuracy: Optional[float] = None, **options: Any
    ) -> Any:
        """Paths between many pairs of points; see `vtkdgg.Graph.paths`."""
        return _wrapped(self.graph(accuracy).paths, starts, ends, **options)

    def isolines(
        self, sources: Any, values: Any, accuracy: Optional[float] = None, **options: Any
    ) -> Any:
        """Curves of equal distance; see `vtkdgg.Graph.isolines`."""
        return _wrapped(self.graph(accuracy).isolines, sources, values, **options)

    def loop(self, points: Any = None, accuracy: Optional[float] = None, **options: Any) -> Any:
        """Closed geodesics; see `vtkdgg.Graph.loop`."""
        return _wrapped(self.graph(accuracy).loop, points, **options)

    def sample(
        self, number_of_samples: int, accuracy: Optional[float] = None, **options: Any
    ) -> Any:
        """Points that are spread evenly; see `vtkdgg.Graph.sample`."""
        return _wrapped(self.graph(accuracy).sample, number_of_samples, **options)

    def voronoi(self, sites: Any, accuracy: Optional[float] = None, **options: Any) -> Any:
        """Cells of some sites; see `vtkdgg.Graph.voronoi`."""
        return _wrapped(self.graph(accuracy).voronoi, sites, **options)

    def probe(self, values: Any, at: Any, **options: Any) -> Any:
        """Points with distances, from the distances or the point array; see `vtkdgg.probe`."""
        return _wrapped(distances.probe, self._mesh, values, at, **options)

    def patch_boundaries(
        self, second: Any, first_landmarks: Any, second_landmarks: Any, *layout: Any, **options: Any
    ) -> Any:
        """The same curves on this mesh and on a second one; see `vtkdgg.patch_boundaries`."""
        given = self._mesh, second, first_landmarks, second_landmarks, *layout
        found = layouts.patch_boundaries(*given, as_polydata=True, **options)
        return tuple(map(pyvista.wrap, found))

    def greens_function(self, sources: Any, **options: Any) -> Any:
        """Green's functions; see `vtkdgg.greens_function`."""
        return _wrapped(spectral.greens_function, self._mesh, sources, **options)

    def biharmonic(self, sources: Any, **options: Any) -> Any:
        """Smooth distances; see `vtkdgg.biharmonic`."""
        return _wrapped(spectral.biharmonic, self._mesh, sources, **options)

    def earth_movers(self, start: Any, end: Any, **options: Any) -> Any:
        """Transport of mass; see `vtkdgg.earth_movers`."""
        return _wrapped(spectral.earth_movers, self._mesh, start, end, **options)

    def interpolate(self, sites: Any, values: Any, **options: Any) -> Any:
        """A smooth function with given values; see `vtkdgg.interpolate`."""
        return _wrapped(spectral.interpolate, self._mesh, sites, values, **options)

    def vector_graphics(self, curves: Any = None, **options: Any) -> Any:
        """The surface in colors of curves and regions; see `vtkdgg.vector_graphics`."""
        return _wrapped(graphics.vector_graphics, self._mesh, curves, **options)

    def _is_cloud(self):
        if isinstance(self._mesh, pyvista.PolyData):
            return self._mesh.GetNumberOfPolys() + self._mesh.GetNumberOfStrips() == 0
        return not isinstance(self._mesh, pyvista.UnstructuredGrid) or not self._mesh.GetNumberOfCells()

    def _path(self, start, end, use_scalar_weights, as_polydata):
        if use_scalar_weights:
            raise ValueError("use_scalar_weights: geodesics of a surface have no weights")
        return paths.path(self._mesh, start, end, as_polydata=as_polydata)


def _wrapped(function, *arguments, **options):
    """Returns the vtkPolyData of a function as a mesh of PyVista."""
    return pyvista.wrap(function(*arguments, as_polydata=True, **options))


def read_pcd(path: Any, **_: Any) -> Any:
    """Reads a PCD file as a mesh of PyVista."""
    return pyvista.wrap(read(path).as_polydata())


def register() -> None:
    """Registers the accessor and the reader with versions of PyVista that support this."""
    if hasattr(pyvista, "register_dataset_accessor"):
        for kind in (pyvista.PolyData, pyvista.PointSet, pyvista.UnstructuredGrid):
            pyvista.register_dataset_accessor("dgg", kind)(DGGAccessor)
    if hasattr(pyvista, "register_reader"):
        pyvista.register_reader(".pcd", read_pcd)


register()

# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances between many points on a Dask cluster."""

from __future__ import annotations

import collections
import time
from concurrent.futures import CancelledError
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from .matrices import MatrixRequest
from .progress import Bar

if TYPE_CHECKING:
    from numpy.typing import DTypeLike, NDArray

    from .arguments import SurfacePointsLike
    from .graph_data import GraphData

__all__ = ["matrix"]

# Largest number of entries of a strip, number of strips of a smaller matrix, and rows below which
# strips are not divided because nearby rows are computed together. None depends on the cluster, so
# that every cluster returns the same bits.
_ENTRIES = 2**23
_STRIPS = 64
_ROWS = 128
# Strips that are submitted at a time, per thread: the others wait until results have been stored.
_STRIPS_OF_THREAD = 2
# Attempts to send the graph, and seconds between them.
_ATTEMPTS = 10
_PAUSE = 0.5


def matrix(
    graph: GraphData,
    rows: SurfacePointsLike,
    client: Any,
    columns: Optional[SurfacePointsLike] = None,
    *,
    out: Optional[Any] = None,
    dtype: Optional[DTypeLike] = None,
    unreached: float = np.nan,
    projection_tolerance: Optional[float] = None,
) -> NDArray[Any]:
    """Distances between two sets of points, computed by the workers of a Dask cluster.

    The distances are those of `Graph.matrix` up to rounding, and do not depend on the number of
    workers. The graph is sent to every worker once. Each thread of a worker computes a strip of
    rows at a time, and all threads of a worker share the graph. Strips are stored as they arrive.
    A worker that dies costs only the strips that it was computing.

    Parameters
    ----------
    graph : Graph or CloudGraph
        The workers need vtkdgg of the same version.
    rows, columns : surface points
        As for `Graph.matrix`.
    client : distributed.Client
        A client that is not asynchronous.
    out : numpy.ndarray, memmap, zarr.Array or similar, optional
        As for `Graph.matrix`.
    dtype, unreached, projection_tolerance : optional
        As for `Graph.matrix`.

    Returns
    -------
    numpy.ndarray of float64 or `dtype`, shape (number of rows, number of columns), or `out`
        In the unit of the points.

    Raises
    ------
    ValueError, Error
        As for `Graph.matrix`.
    TypeError
        When `client` is not a client.
    distributed.KilledWorker
        When several workers died while computing the same strip, for example because their memory
        is insufficient.
    """
    _check_client(client)
    request = MatrixRequest(graph, rows, columns, out, dtype, unreached, projection_tolerance)
    request.check_rows(graph)
    out = np.empty(request.shape, request.dtype) if out is None else out
    height = min(_ENTRIES // max(1, request.shape[1]), max(_ROWS, request.shape[0] // _STRIPS))
    strips = collections.deque(request.strips(max(1, height)))
    bar = Bar()
    done = 0
    try:
        for first, strip in _compute(client, _Job(graph, request), strips):
            request.store(out, first, strip)
            done += len(strip)
            bar.show("matrix", done / request.shape[0])
    finally:
        bar.close()
    return out


class _Job:
    """What workers need for all strips."""

    def __init__(self, graph, request):
        self.graph, self.request = graph, request

    def find(self, first, last):
        """Computes a strip on one thread of a worker."""
        return self.request.find(self.graph, first, last, number_of_threads=1)


def _check_client(client):
    if not hasattr(client, "scatter") or not hasattr(client, "nthreads"):
        raise TypeError(f"client: expected a distributed.Client, got {type(client).__name__}")
    if client.asynchronous:
        raise ValueError("client: expected a client that is not asynchronous")


def _compute(client, job, waiting):
    """Yields strips with their first rows, in the order in which workers finish them."""
    from distributed import as_completed

    running = {}
    finished = as_completed()
    sent = None
    try:
        while waiting or running:
            sent = sent or _send(client, job)
            most = _STRIPS_OF_THREAD * max(1, sum(client.nthreads().values()))
            while waiting and len(running) < most:
                rows = waiting.popleft()
                future = client.submit(_Job.find, sent, *rows, pure=False)
                running[future] = rows
                finished.add(future)
            future = next(finished)
            rows = running.pop(future)
            try:
                strip = future.result()
            except CancelledError:  # no worker has the graph any longer
                waiting.append(rows)
                sent = None
            else:
                yield rows[0], strip
    finally:
        client.cancel(list(running))


def _send(client, job):
    """Sends a job to all workers."""
    for attempt in range(_ATTEMPTS):
        try:
            return client.scatter(job, broadcast=True, hash=False)
        except TimeoutError:  # there are no workers
            raise
        except (KeyError, OSError):  # a worker died meanwhile
            if attempt == _ATTEMPTS - 1:
                raise
            time.sleep(_PAUSE)
    return None

# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances between many points on a Dask cluster."""

from __future__ import annotations

import collections
import contextlib
import time
import uuid
from concurrent.futures import CancelledError
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from .errors import Error
from .matrices import MatrixRequest
from .progress import Bar, Silence

if TYPE_CHECKING:
    from numpy.typing import DTypeLike, NDArray

    from .arguments import SurfacePointsLike
    from .graph_data import GraphData

__all__ = ["matrix"]

# Strips do not depend on the cluster, so that every cluster returns the same bits.
_ENTRIES = 2**23  # largest number of entries of a strip
_STRIPS = 64  # number of strips of a matrix with fewer entries
_ROWS = 128  # rows below which strips are not divided: nearby rows are computed together
# Strips that are submitted at a time, per thread: the others wait until results have been stored.
_STRIPS_OF_THREAD = 2
# Attempts to send the graph if workers die meanwhile, and seconds between them.
_ATTEMPTS = 10
_PAUSE = 0.5
# How often all workers that have the graph may die before one of them has finished a strip.
_DEATHS = 3


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
    workers. Each thread of a worker computes strips of at least 128 rows, which are stored as they
    arrive. The graph is sent to all workers at the start; all threads of a worker share it. If a
    worker dies, its strips are computed again by the others.

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
        As for `Graph.matrix`; a ValueError also when the client is closed or asynchronous, or has
        no workers, and an Error when workers die again and again.
    TypeError
        When `client` is not a client.
    """
    _check_client(client)
    request = MatrixRequest(graph, rows, columns, out, dtype, unreached, projection_tolerance)
    request.check_rows(graph)
    out = np.empty(request.shape, request.dtype) if out is None else out
    height = min(_ENTRIES // request.shape[1], max(_ROWS, request.shape[0] // _STRIPS))
    strips = collections.deque(request.strips(max(1, height)))
    bar = Bar()
    done = 0
    try:
        with contextlib.closing(_compute(client, _Job(graph, request), strips)) as computed:
            for first, strip in computed:
                request.store(out, first, strip)
                done += len(strip)
                bar.show("matrix", done / request.shape[0])
                del strip  # before the next one arrives
    finally:
        bar.close()
    return out


class _Job:
    """A graph and a matrix, of which workers compute strips."""

    def __init__(self, graph, request):
        self.graph, self.request = graph, request

    def __sizeof__(self):
        return self.graph.nbytes  # for the memory management of workers

    def compute(self, first, last):
        """Returns a strip, computed by one thread."""
        strip = self.request.compute(self.graph, first, last, bar=Silence, number_of_threads=1)
        return strip.astype(self.request.dtype, copy=False)


def _check_client(client):
    if not hasattr(client, "scatter") or not hasattr(client, "nthreads"):
        raise TypeError(f"client: expected a distributed.Client, got {type(client).__name__}")
    if client.status != "running":
        raise ValueError(f"client: expected a running client, got one that is {client.status}")
    if client.asynchronous:
        raise ValueError("client: expected a synchronous client, got an asynchronous one")
    if not client.nthreads():
        raise ValueError("client: the cluster has no workers. Start at least one")


def _compute(client, job, waiting):
    """Yields strips with their first rows, in the order in which workers finish them."""
    from distributed import as_completed

    running = {}
    finished = as_completed()
    sent = None
    deaths = 0
    keys = []  # of the copies of the job, also of those that could not be sent
    try:
        while waiting or running:
            sent = sent or _send(client, job, keys)
            most = _STRIPS_OF_THREAD * max(1, sum(client.nthreads().values()))
            while waiting and len(running) < most:
                rows = waiting.popleft()
                future = client.submit(_Job.compute, sent, *rows, pure=False)
                running[future] = rows, sent
                finished.add(future)
            future = next(finished)
            rows, its_job = running.pop(future)
            try:
                strip = future.result()
            except CancelledError:  # no worker has the graph any longer
                waiting.append(rows)
                if its_job is sent:
                    sent = None
                    deaths += 1
                    if deaths == _DEATHS:
                        raise _dying() from None
                continue
            deaths = 0
            del future
            yield rows[0], strip
            del strip
    finally:
        if client.status == "running":
            _forget(client, running, keys)


def _send(client, job, keys):
    """Sends a job to all workers. Adds its key to `keys`."""
    for attempt in range(_ATTEMPTS):
        keys.append(f"vtkdgg-{uuid.uuid4().hex}")
        try:
            return client.scatter({keys[-1]: job}, broadcast=True)[keys[-1]]
        except TimeoutError:
            raise _dying() from None  # there are no workers
        except (KeyError, OSError):  # a worker died meanwhile
            if attempt < _ATTEMPTS - 1:
                time.sleep(_PAUSE)
    raise _dying()


def _forget(client, futures, keys):
    """Cancels tasks, and removes data from the workers even if an exception refers to them."""
    from distributed import Future

    client.cancel([*futures, *(Future(key, client) for key in keys)])


def _dying():
    return Error(
        ["Workers of the cluster died again and again. They may need more memory"], "client"
    )

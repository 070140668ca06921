# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point-to-point searches in a graph, for the vertices that they settle: Dijkstra's from one end,
from both ends with the published and with a right end, and A*."""

import heapq

import numpy as np


class Front:
    """A search from one vertex, one step at a time; `ahead` is a lower bound of what is left."""

    def __init__(self, graph, start, ahead=None):
        self.graph = graph
        self.ahead = ahead
        self.labels = {start: 0.0}
        self.settled = set()
        self.queue = [(self.bound(start, 0.0), start)]

    def bound(self, vertex, label):
        return label + (self.ahead[vertex] if self.ahead is not None else 0.0)

    def nearest(self):
        """The smallest bound of what is not settled; infinite at the end."""
        while self.queue and self.queue[0][1] in self.settled:
            heapq.heappop(self.queue)
        return self.queue[0][0] if self.queue else np.inf

    def step(self):
        """Settle a vertex, and return it; None at the end."""
        if self.nearest() == np.inf:
            return None
        _, vertex = heapq.heappop(self.queue)
        self.settled.add(vertex)
        offsets, targets, lengths = self.graph
        for edge in range(offsets[vertex], offsets[vertex + 1]):
            target, label = int(targets[edge]), self.labels[vertex] + float(lengths[edge])
            if label < self.labels.get(target, np.inf):
                self.labels[target] = label
                heapq.heappush(self.queue, (self.bound(target, label), target))
        return vertex


def arrays(graph):
    """What a search reads of a vtkdgg.Graph."""
    return graph.offsets, graph.targets, graph.lengths


def one_sided(graph, start, end, ahead=None):
    """Length, and number of vertices settled. With a lower bound of the distance from `end` this is
    A*: no bound may be larger than an edge says."""
    front = Front(graph, start, ahead)
    while (vertex := front.step()) is not None:
        if vertex == end:
            return front.labels[end], len(front.settled)
    return np.inf, len(front.settled)


def two_sided(graph, start, end, as_published):
    """The same from both ends. As published the search ends when a vertex is settled from both
    ends, and the way through it is taken; that is not always the shortest one. Right is to go on
    until no shorter one can be left."""
    fronts = Front(graph, start), Front(graph, end)
    best = np.inf
    while max(front.nearest() for front in fronts) < np.inf:
        ahead, behind = sorted(fronts, key=Front.nearest)
        if not as_published and ahead.nearest() + behind.nearest() >= best:
            break
        vertex = ahead.step()
        if vertex in behind.labels:
            best = min(best, ahead.labels[vertex] + behind.labels[vertex])
        if as_published and vertex in behind.settled:
            best = ahead.labels[vertex] + behind.labels[vertex]
            break
    return best, sum(len(front.settled) for front in fronts)

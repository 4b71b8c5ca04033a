# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields that are continuous, of cells that are written one by one."""

import itertools

import numpy

# Numbers of corners whose middle may be a hanging node, of a quadrilateral and a hexahedron in
# VTK's order: edges, and the faces of the hexahedron.
EDGES = {4: [(0, 1), (1, 2), (2, 3), (3, 0)],
         8: [*itertools.pairwise((0, 1, 2, 3, 0)), *itertools.pairwise((4, 5, 6, 7, 4)),
             (0, 4), (1, 5), (2, 6), (3, 7)]}
FACES = {4: [], 8: [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]}


def clusters(values, tolerance):
    """A number for each value, the same one for those that are closer than the tolerance."""
    order = numpy.argsort(values)
    numbers = numpy.empty(len(values), int)
    numbers[order] = numpy.concatenate([[0], numpy.cumsum(numpy.diff(values[order]) > tolerance)])
    return numbers


def same_points(columns, tolerance):
    """A number for each row of coordinates, the same one for those at the same place."""
    places = numpy.zeros(len(columns), int)
    for column in columns.T:
        found = clusters(column, tolerance)
        places = numpy.unique(places * (found.max() + 1) + found, return_inverse=True)[1]
    return places


class Joined:
    """Makes fields continuous: the value at a node is the mean of the cells that meet there. At a
    hanging node, the middle of an edge or face of a larger cell, it is the mean of their corners,
    so that the larger cell and the smaller ones agree.

    Cells of different 'regions' (a number for each point) are not joined.
    """

    def __init__(self, points, cells, regions=None):
        n_corners = cells.shape[1]
        columns = points if regions is None else numpy.column_stack([points, regions * numpy.ptp(points)])
        groups = [cells[:, corners] for corners in (*EDGES[n_corners], *FACES[n_corners])]
        middles = numpy.concatenate([columns[group].mean(axis=1) for group in groups])
        places = same_points(numpy.concatenate([columns, middles]), 1e-6 * numpy.ptp(points))
        first, self.nodes = numpy.unique(places[:len(points)], return_inverse=True)
        self.n_nodes = len(first)
        self.counts = numpy.bincount(self.nodes, minlength=self.n_nodes)
        self.hanging = self.find_hanging(groups, numpy.searchsorted(first, places[len(points):]), first,
                                         places[len(points):])

    def find_hanging(self, groups, candidates, first, places):
        """Pairs of hanging nodes and their corners, edges and faces apart."""
        found, begin = {2: [], 4: []}, 0
        for group in groups:
            end = begin + len(group)
            nodes = candidates[begin:end].clip(max=self.n_nodes - 1)
            is_node = first[nodes] == places[begin:end]
            found[group.shape[1]].append(numpy.column_stack([nodes[is_node], self.nodes[group[is_node]]]))
            begin = end
        return [numpy.unique(numpy.concatenate(parts), axis=0) for parts in found.values() if parts]

    def __call__(self, values):
        """The continuous values at the points."""
        columns = values.reshape(len(values), -1)
        means = numpy.column_stack([numpy.bincount(self.nodes, column, self.n_nodes) / self.counts
                                    for column in columns.T])
        for _ in range(4):  # corners of a large cell can be hanging nodes of a still larger one
            for pairs in self.hanging:
                means[pairs[:, 0]] = means[pairs[:, 1:]].mean(axis=1)
        return means[self.nodes].reshape(values.shape)

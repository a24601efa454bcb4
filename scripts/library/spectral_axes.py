"""Spectral elements of air in the half plane (r, z), whose sizes grow from edges: what tools/tube_resonances and
tools/timpani_modes share. Around the air, r and z become complex, so that waves decay there (a perfectly matched layer)."""

from itertools import pairwise

import numpy
from numpy.polynomial import legendre


def from_edge(length, smallest, ratio, largest):
    """Ends of elements on the way from an edge at 0 to `length`; each is `ratio` times as long as the one before."""
    ends, size = [0.0], smallest
    while ends[-1] + 1.5 * size < length:
        ends.append(ends[-1] + size)
        size = min(ratio * size, largest)
    return numpy.array([*ends, length])


def ends_of_elements(knots, edges, **sizes):
    """Along one axis: knots are ends of elements, and elements are small at the knots that are edges."""
    ends = [knots[:1]]
    for first, last in pairwise(knots):
        length = last - first
        if first in edges and last in edges:
            half = from_edge(length / 2, **sizes)
            steps = numpy.concatenate([half, (length - half[::-1])[1:]])
        else:
            steps = from_edge(length, **sizes)
            steps = length - steps[::-1] if last in edges else steps
        ends.append(first + steps[1:])
    return numpy.concatenate(ends)


def shapes(order, points):
    """Lagrange's polynomials on Lobatto's nodes and their derivatives: two arrays [points x nodes]."""
    nodes = numpy.concatenate([[-1.0], legendre.Legendre.basis(order).deriv().roots(), [1.0]])
    to_legendre = numpy.linalg.inv(legendre.legvander(nodes, order))
    derivatives = legendre.legval(points, legendre.legder(numpy.eye(order + 1))).T
    return legendre.legvander(points, order) @ to_legendre, derivatives @ to_legendre


def axis_matrices(ends, order, air, *, layer, strength, radial):
    """Integrals of p q, of p' q' and, if radial, of p q/r^2 over each element of an axis: [elements x nodes x nodes].

    air       where the air begins and ends; beyond it, coordinates are complex
    layer     thickness of the layer, m
    strength  imaginary part of the layer's thickness over its real part
    radial    whether this is r, which also weighs the integrals
    """
    points, weights = legendre.leggauss(order + 3)
    values, slopes = shapes(order, points)
    masses, stiffnesses, turns = [], [], []
    for first, last in pairwise(ends):
        half = (last - first) / 2
        place = first + half * (1 + points)
        depth = place - numpy.clip(place, *air)
        stretch = 1 + 2j * strength * numpy.abs(depth) / layer
        around = place + 1j * strength * depth * numpy.abs(depth) / layer if radial else numpy.ones_like(place)
        masses.append(values.T @ ((weights * half * stretch * around)[:, None] * values))
        stiffnesses.append(slopes.T @ ((weights / half / stretch * around)[:, None] * slopes))
        turns.append(values.T @ ((weights * half * stretch / around)[:, None] * values))
    return masses, stiffnesses, turns

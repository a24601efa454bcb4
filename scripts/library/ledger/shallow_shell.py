"""Thin shallow shells with free edges that vibrate by more than a small part of their thickness, by Marguerre's equations
(those of von Karman for a curved plate) and Ritz's method: a code of its own, which shares nothing with the program."""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from scipy.linalg import eigh


@dataclass
class Domain:
    """Points of quadrature and their weights, on lengths over half the width of the shell."""
    x: np.ndarray
    y: np.ndarray
    weights: np.ndarray


def square(points=30):
    nodes, weights = legendre.leggauss(points)
    x, y = (grid.ravel() for grid in np.meshgrid(nodes, nodes))
    return Domain(x, y, np.outer(weights, weights).ravel())


def disc(points=24):
    nodes, weights = legendre.leggauss(points)
    radii, angles = (nodes + 1) / 2, 2 * np.pi * np.arange(2 * points) / (2 * points)
    return Domain(np.outer(radii, np.cos(angles)).ravel(), np.outer(radii, np.sin(angles)).ravel(),
                  np.repeat(weights / 2 * radii * np.pi / points, len(angles)))


class ShallowShell:
    """Its unit of length in the plane is half the width, of deflections the thickness h, and of energies D h²: D is
    the stiffness in bending. Frequencies are over sqrt(D/(density thickness half-width^4)).
    @param height  of the middle of a spherical cap over the place at one half-width from it, thicknesses"""

    def __init__(self, domain, height, poisson, degree=12):
        self.weights, self.poisson = domain.weights, poisson
        powers = [(i, total - i) for total in range(degree + 1) for i in range(total + 1)]
        def field(dx, dy):
            return np.array([self.line(i, dx, domain.x) * self.line(j, dy, domain.y) for i, j in powers])
        values, self.along, self.across = field(0, 0), field(1, 0), field(0, 1)
        bending = self.stressed(np.array([field(2, 0), field(0, 2), 2 * field(1, 1)]))
        plane = 0 * values
        in_plane = np.concatenate([[self.along, plane, self.across], [plane, self.across, self.along]], axis=1)
        self.relaxing = self.orthonormal(self.stressed(in_plane))
        slope = -2 * height * domain.x, -2 * height * domain.y  # of the cap at rest
        linear = self.relaxed(np.array([slope[0] * self.along, slope[1] * self.across,
                                        slope[0] * self.across + slope[1] * self.along]))
        squares, shapes = eigh(bending @ bending.T + linear @ linear.T, (values * self.weights) @ values.T)
        self.frequencies, self.shapes = np.sqrt(squares[3:]), shapes[:, 3:].T  # without rigid motions
        self.linear = self.shapes @ linear
        self.along, self.across = self.shapes @ self.along, self.shapes @ self.across

    @staticmethod
    def line(order, derivative, x):
        return legendre.legval(x, legendre.legder(np.eye(order + 1)[order], derivative))

    def stressed(self, strains):
        """[functions x 3 points] Strains (x, y, shear) as vectors whose products are twice energies over that of bending
        with the same stiffness."""
        root = np.linalg.cholesky([[1, self.poisson, 0], [self.poisson, 1, 0], [0, 0, (1 - self.poisson) / 2]]).T
        return np.concatenate(np.tensordot(root, strains, axes=1) * np.sqrt(self.weights), axis=1)

    @staticmethod
    def orthonormal(rows):
        _, sizes, directions = np.linalg.svd(rows, full_matrices=False)
        return directions[sizes > 1e-10 * sizes[0]]

    def relaxed(self, strains):
        """What the best displacements in the plane leave of strains of the middle surface; 12 is h² times the
        stiffness in the plane over that in bending."""
        vectors = np.sqrt(12) * self.stressed(strains)
        return vectors - vectors @ self.relaxing.T @ self.relaxing

    def stretched(self, mode, others):
        """Strains of second order of a mode with each of others."""
        along, across = self.along[mode], self.across[mode]
        return self.relaxed(np.array([along * self.along[others], across * self.across[others],
                                      along * self.across[others] + across * self.along[others]]) / 2)

    def bend_of(self, mode, modes):
        """`bend` of a mode whose root mean square deflection is one thickness, with so many of the modes."""
        strains = self.stretched(mode, np.arange(modes))
        return bend(self.frequencies[:modes], mode, self.linear[:modes], strains[mode], strains) * self.weights.sum()


def bend(frequencies, mode, linear, own, with_others):
    """By which share of itself the frequency of a mode rises for its coordinate 1, times its square in general. The energy
    of stretching is V = sum_n (a_n z_n + 1/2 z_n²). The mode drives the others and itself at twice its frequency and
    at rest (Nayfeh and Mook, Nonlinear Oscillations, 2.3 and 6.2).
    @param linear       a of each mode, [modes x strains]
    @param own          z of the mode, [strains]
    @param with_others  half of z of the mode with each, [modes x strains]"""
    square = frequencies[mode]**2
    drive = linear @ own + 2 * with_others @ linear[mode]
    answers = 1 / frequencies**2 + 0.5 / (frequencies**2 - 4 * square)
    return (1.5 * own @ own - np.sum(drive**2 * answers)) / (2 * square)

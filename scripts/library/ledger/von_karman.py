"""A thin plate with large deflections, whose edges can turn but not move, by von Karman's equations: a code of its own,
which shares nothing with the program. Deflections are cosines, and displacements in the plane follow them at rest."""

import itertools
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import j1


@dataclass
class Plate:
    """Rectangular, with its centre at the origin and symmetric vibrations only."""
    length: float     # m, along x
    width: float      # m, along y
    thickness: float  # m
    young: float      # Pa
    poisson: float
    density: float    # kg/m3
    loss: float       # 1/s: the velocities' decay by damping that is proportional to the mass

    def membrane(self):
        """Forces per strains (x, y, shear) of a unit width, N/m. [3 x 3]"""
        stiffness = self.young * self.thickness / (1 - self.poisson**2)
        return stiffness * np.array([[1, self.poisson, 0], [self.poisson, 1, 0], [0, 0, (1 - self.poisson) / 2]])

    def waves(self, limit):
        """Wave numbers along x and y of the modes cos(kx x) cos(ky y) up to a frequency in Hz, ascending, rad/m, and their
        angular frequencies, rad/s."""
        bending = self.young * self.thickness**3 / (12 * (1 - self.poisson**2))
        odd = np.arange(1, 100, 2)
        kx, ky = (pairs.ravel() for pairs in np.meshgrid(odd * np.pi / self.length, odd * np.pi / self.width))
        omega = np.sqrt(bending / (self.density * self.thickness)) * (kx**2 + ky**2)
        order = [n for n in np.argsort(omega) if omega[n] <= 2 * np.pi * limit]
        return kx[order], ky[order], omega[order]


class Stretching:
    """Energy of stretching 1/2 p . energy p, J, of the products p = q_a q_b of modal deflections in m."""

    def __init__(self, plate, kx, ky, terms=12, points=80):
        self.pairs = np.array(list(itertools.combinations_with_replacement(range(len(kx)), 2)))
        nodes, weights = np.polynomial.legendre.leggauss(points)
        x, y = (side / 4 * (nodes + 1) for side in (plate.length, plate.width))  # of a quarter
        self.weights = np.outer(weights, weights).ravel() * plate.length * plate.width / 4  # of the whole plate
        x, y = (grid.ravel() for grid in np.meshgrid(x, y, indexing="ij"))
        along, across = -np.sin(np.outer(kx, x)) * kx[:, None] * np.cos(np.outer(ky, y)), \
            -np.cos(np.outer(kx, x)) * np.sin(np.outer(ky, y)) * ky[:, None]
        strains = np.array([self.strain(along[[a, b]], across[[a, b]]) for a, b in self.pairs])
        relaxed = self.relaxed(plate, strains, self.displacements(plate, x, y, terms))
        self.energy = self.product(plate, relaxed, relaxed)

    @staticmethod
    def strain(along, across):
        """Of the product of two modes, from their slopes. [3 x points]"""
        strain = np.array([along[0] * along[1], across[0] * across[1], along[0] * across[1] + along[1] * across[0]])
        return strain / 2 if np.array_equal(along[0], along[1]) else strain

    @staticmethod
    def displacements(plate, x, y, terms):
        """Strains of displacements in the plane that vanish on all edges. [2 terms^2 x 3 x points]"""
        found = []
        for i, j in itertools.product(range(terms), repeat=2):
            even, odd = 2 * (i + 1) * np.pi, (2 * j + 1) * np.pi
            for (s, c), (long, short) in (((x, y), (plate.length, plate.width)), ((y, x), (plate.width, plate.length))):
                stretch = even / long * np.cos(even * s / long) * np.cos(odd * c / short)
                shear = -odd / short * np.sin(even * s / long) * np.sin(odd * c / short)
                zero = np.zeros_like(s)
                found.append([stretch, zero, shear] if s is x else [zero, stretch, shear])
        return np.array(found)

    def product(self, plate, one, other):
        """Work of each strain of `one` on the forces of each of `other`, J."""
        forces = np.einsum("ij,njp->nip", plate.membrane(), other) * self.weights
        return one.reshape(len(one), -1) @ forces.reshape(len(other), -1).T

    def relaxed(self, plate, strains, displacements):
        """Strains that remain after the best displacements in the plane."""
        best = np.linalg.solve(self.product(plate, displacements, displacements),
                               self.product(plate, displacements, strains))
        return strains - np.tensordot(best.T, displacements, axes=1)

    def forces(self, q):
        """On each modal deflection, N: the derivative of the energy."""
        first, second = self.pairs.T
        by_product = self.energy @ (q[first] * q[second])
        force = np.zeros_like(q)
        np.add.at(force, first, by_product * q[second])
        np.add.at(force, second, by_product * q[first])
        return force


def struck(plate, blow, limit, time):
    """Modal deflections, m, [modes x times], after a blow on a disc in the middle whose force is half a sine.
    @param blow   `force`, N, `radius` of the disc, m, and `duration`, s
    @param limit  of the modes, Hz"""
    kx, ky, omega = plate.waves(limit)
    stretching = Stretching(plate, kx, ky)
    mass = plate.density * plate.thickness * plate.length * plate.width / 4  # of each mode: the mean of cos^2 cos^2
    argument = np.hypot(kx, ky) * blow["radius"]
    share = 2 * j1(argument) / argument  # mean of the mode on the disc

    def rates(now, state):
        q, v = np.split(state, 2)
        strength = blow["force"] * np.sin(np.pi * now / blow["duration"]) if now < blow["duration"] else 0
        return np.concatenate([v, (strength * share - stretching.forces(q)) / mass - omega**2 * q - plate.loss * v])

    solution = solve_ivp(rates, (0, time[-1]), np.zeros(2 * len(kx)), t_eval=time, method="DOP853", rtol=1e-8, atol=1e-12)
    return solution.y[:len(kx)]

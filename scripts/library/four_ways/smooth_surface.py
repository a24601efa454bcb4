"""The outside of quadratic tetrahedra as a fine surface, on which their shape functions are drawn."""

import numpy as np

from library.cinema.result import FACES, MIDDLES
from library.surface_motion import normals

FINE = 6  # small triangles along the edge of a face


class SmoothSurface:
    """points: [points x 3], m; triangles: [n x 3] numbers of points; normals: [points x 3]."""

    def __init__(self, nodes, elements):
        """nodes: [nodes x 3], m; elements: [elements x 10], in VTK's order."""
        corners, middles = elements[:, FACES].reshape(-1, 3), elements[:, MIDDLES].reshape(-1, 3)
        _, first, count = np.unique(np.sort(corners, axis=1), axis=0, return_index=True, return_counts=True)
        self.faces = np.hstack([corners, middles])[first[count == 1]]
        self.weights, triangles = _grid()
        everywhere = self._on_faces(nodes)
        _, self.first, number = np.unique(np.round(everywhere / 1e-7).astype(np.int64), axis=0, return_index=True, return_inverse=True)
        self.points = everywhere[self.first]
        shifts = len(self.weights) * np.arange(len(self.faces))
        self.triangles = number.reshape(-1)[(shifts[:, None, None] + triangles).reshape(-1, 3)]
        self.normals = self._normals()

    def values(self, nodal):
        """A quantity of the nodes [nodes x 3] at the points [points x 3]."""
        return self._on_faces(nodal)[self.first]

    def edges(self):
        """Of the elements' faces: two corners and the middle between them [n x 3]."""
        ends = np.concatenate([self.faces[:, [0, 3, 1]], self.faces[:, [1, 4, 2]], self.faces[:, [2, 5, 0]]])
        _, first = np.unique(ends[:, 1], return_index=True)
        return ends[first]

    def _on_faces(self, nodal):
        return np.einsum("pk,fkc->fpc", self.weights, nodal[self.faces]).reshape(-1, 3)

    def _normals(self):
        around = np.zeros_like(self.points)
        for corner in range(3):
            np.add.at(around, self.triangles[:, corner], normals(self.points[self.triangles]))
        return around / np.linalg.norm(around, axis=1, keepdims=True)


def _grid():
    """A fine grid on a face: the weights of the face's six nodes at each point [points x 6], and triangles [n x 3]."""
    place = {key: number for number, key in enumerate((i, j) for i in range(FINE + 1) for j in range(FINE + 1 - i))}
    triangles = [[place[i, j], place[i + 1, j], place[i, j + 1]] for i, j in place if i + j < FINE]
    triangles += [[place[i + 1, j], place[i + 1, j + 1], place[i, j + 1]] for i, j in place if i + j < FINE - 1]
    b, c = np.array(list(place), float).T / FINE
    a = 1 - b - c
    weights = np.stack([a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * a * b, 4 * b * c, 4 * c * a], axis=1)
    return weights, np.array(triangles)

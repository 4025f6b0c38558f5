"""Lengths, dihedral angles and the energy of shells by their formulas, in numpy. Reference for spaces.test.ts.

Receives the mesh, its keys, and paths of shapes at the same evenly spaced times. Returns the relative decrease of the
minimised energy by Gauss-Newton steps from each fitted shape, and the bending energy of every path. Also returns, for
three shapes `step` apart, the squared second derivative of their lengths and angles, relative to the squared change
between the keys.
"""

import numpy as np

from blender_script import answer, arguments

BENDING = 1e-4
MAX_SLENDERNESS = 10


class Shell:
    def __init__(self, faces, rest):
        sides = {}
        for f in faces:
            for c in range(3):
                sides.setdefault((f[c], f[(c + 1) % 3]), []).append(f[(c + 2) % 3])
        area = lambda i, j, k: np.linalg.norm(np.cross(rest[j] - rest[i], rest[k] - rest[i])) / 2
        whole = sum(area(*f) for f in faces)
        self.edges, self.hinges, lengths, angles = [], [], [], []
        for i, j in sorted({tuple(sorted(side)) for side in sides}):
            left, right = sides.get((i, j), []), sides.get((j, i), [])
            share = sum(area(i, j, k) for k in left + right) / 3
            squared = np.sum((rest[j] - rest[i]) ** 2)
            self.edges.append((i, j))
            lengths.append(share / squared)
            if len(left) == len(right) == 1:
                self.hinges.append((i, j, left[0], right[0]))
                angles.append(BENDING * whole * min(squared / share, MAX_SLENDERNESS))
        self.weights = np.array(lengths + angles)
        self.edges, self.hinges = np.array(self.edges), np.array(self.hinges)

    def z(self, p):
        i, j = p[self.edges[:, 0]], p[self.edges[:, 1]]
        lengths = np.linalg.norm(j - i, axis=1)
        i, j, k, l = (p[self.hinges[:, c]] for c in range(4))
        edge = j - i
        left, right = np.cross(edge, k - i), np.cross(l - i, edge)
        sine = np.sum(np.cross(left, right) * edge, axis=1) / np.linalg.norm(edge, axis=1)
        return np.concatenate([lengths, np.arctan2(sine, np.sum(left * right, axis=1))])

    def difference(self, a, b):
        d = a - b
        angles = slice(len(self.edges), None)
        d[angles] = (d[angles] + np.pi) % (2 * np.pi) - np.pi
        return d

    def energy(self, p, target):
        return np.sum(self.weights * self.difference(self.z(p), target) ** 2)

    def jacobian(self, p, step=1e-6):
        columns = []
        for n in range(p.size):
            move = np.zeros(p.size)
            move[n] = step
            move = move.reshape(p.shape)
            columns.append(self.difference(self.z(p + move), self.z(p - move)) / (2 * step))
        return np.array(columns).T

    def fit(self, p, target, steps):
        damping = 1e-8
        for _ in range(steps):
            j = self.jacobian(p)
            right = j.T @ (self.weights * self.difference(self.z(p), target))
            system = j.T @ (self.weights[:, None] * j)
            change = np.linalg.solve(system + damping * np.trace(system) / p.size * np.eye(p.size), right)
            trial = p - change.reshape(p.shape)
            if self.energy(trial, target) < self.energy(p, target):
                p = trial
            else:
                damping *= 100
        return p

    def bending(self, path):
        """4 K^3 times the sum of W[s_k, m_k], where m_k is the middle of the neighbours of shape s_k."""
        k = len(path) - 1
        total = 0
        for before, here, after in zip(path, path[1:], path[2:]):
            middle = self.z(before) + self.difference(self.z(after), self.z(before)) / 2
            total += self.energy(here, self.z(self.fit(here, middle, 15)))
        return 4 * k**3 * total

    def density(self, before, here, after, step):
        second = self.difference(self.z(after), self.z(here)) - self.difference(self.z(here), self.z(before))
        return np.sum(self.weights * second**2) / step**4


given = arguments()
faces = [tuple(f) for f in np.array(given["faces"], dtype=int).reshape(-1, 3).tolist()]
paths = {name: [np.array(s).reshape(-1, 3) for s in path] for name, path in given["paths"].items()}
first, last = paths["lengths"][0], paths["lengths"][-1]
shell = Shell(faces, first)
falls = []
for n, shape in enumerate(paths["lengths"][1:-1], start=1):
    t = n / (len(paths["lengths"]) - 1)
    target = shell.z(first) + t * shell.difference(shell.z(last), shell.z(first))
    falls.append(1 - shell.energy(shell.fit(shape, target, 10), target) / shell.energy(shape, target))
around = [np.array(s).reshape(-1, 3) for s in given["around"]]
answer(
    {
        "falls": falls,
        "bending": {name: shell.bending(path) for name, path in paths.items()},
        "density": shell.density(*around, given["step"]) / shell.energy(first, shell.z(last)),
    }
)

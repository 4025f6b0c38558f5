"""Rotation-strain and RIMD by their formulas, in numpy, with dense matrices. Reference for tests/tools/spaces.test.ts.

Receives the mesh, its keys and the shapes of the LRI motion. Returns the shapes of both methods at the same times.
"""

import numpy as np

from blender_script import answer, arguments

STEPS = 3
MIN_AGREEMENT = 1e-5


def spline_weights(times, t):
    """Weight of each key at t for natural cubic splines."""
    n = len(times)
    h = np.diff(times)
    system, right = np.zeros((n, n)), np.zeros((n, n))
    system[0, 0] = system[-1, -1] = 1
    for i in range(1, n - 1):
        system[i, i - 1 : i + 2] = h[i - 1], 2 * (h[i - 1] + h[i]), h[i]
        right[i, i - 1 : i + 2] = 6 / h[i - 1], -6 / h[i - 1] - 6 / h[i], 6 / h[i]
    second = np.linalg.solve(system, right)
    i = min(max(np.searchsorted(times, t) - 1, 0), n - 2)
    a, b = (times[i + 1] - t) / h[i], (t - times[i]) / h[i]
    unit = np.eye(n)
    bend = (a**3 - a) * second[i] + (b**3 - b) * second[i + 1]
    return a * unit[i] + b * unit[i + 1] + h[i] ** 2 / 6 * bend


def exp(v):
    angle = np.linalg.norm(v)
    x, y, z = v
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    if angle < 1e-9:
        return np.eye(3) + k
    return np.eye(3) + np.sin(angle) / angle * k + (1 - np.cos(angle)) / angle**2 * k @ k


def log(r):
    skew = np.array([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]]) / 2
    sine = np.linalg.norm(skew)
    angle = np.arctan2(sine, (np.trace(r) - 1) / 2)
    return skew if sine < 1e-12 else skew * angle / sine


def polar(m):
    u, _, v = np.linalg.svd(m)
    return u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v


def frame(p):
    """The matrix of a triangle: two edges and the unit normal as columns."""
    e, f = p[1] - p[0], p[2] - p[0]
    n = np.cross(e, f)
    return np.stack([e, f, n / np.linalg.norm(n)], axis=1)


class Shape:
    def __init__(self, faces, keys, times):
        self.faces, self.keys, self.times = faces, keys, times
        rest = keys[0]
        self.inverse = [np.linalg.inv(frame(rest[f])) for f in faces]
        self.area = np.array([np.linalg.norm(np.cross(*(rest[f[1:]] - rest[f[0]]))) / 2 for f in faces])
        self.pairs = self.find_pairs()
        self.laplacian = self.assemble_laplacian()
        parts = [[self.rotation_and_stretch(key, f) for f in range(len(faces))] for key in keys]
        self.rotation = np.array([[r for r, _ in key] for key in parts])
        self.stretch = np.array([[s for _, s in key] for key in parts])

    def rotation_and_stretch(self, positions, f):
        gradient = frame(positions[self.faces[f]]) @ self.inverse[f]
        r = polar(gradient)
        return r, r.T @ gradient

    def find_pairs(self):
        """Pairs of neighbouring faces, in both orders."""
        sides, pairs = {}, []
        for f, face in enumerate(self.faces):
            for c in range(3):
                edge = frozenset((int(face[c]), int(face[(c + 1) % 3])))
                if edge in sides:
                    pairs += [(sides[edge], f), (f, sides[edge])]
                sides[edge] = f
        return pairs

    def assemble_laplacian(self):
        n = len(self.keys[0])
        matrix = np.zeros((n, n))
        for f, face in enumerate(self.faces):
            hats = self.hats(f)
            matrix[np.ix_(face, face)] += self.area[f] * hats.T @ hats
        return matrix

    def hats(self, f):
        """Gradients of the hat functions of the three corners, as columns."""
        first, second = self.inverse[f][0], self.inverse[f][1]
        return np.stack([-first - second, first, second], axis=1)

    def solve(self, gradients, mean):
        """The vertices with the given mean whose gradients fit the given ones best (least squares)."""
        right = np.zeros((len(self.keys[0]), 3))
        for f, face in enumerate(self.faces):
            right[face] += self.area[f] * self.hats(f).T @ gradients[f].T
        solution = np.zeros_like(right)
        solution[1:] = np.linalg.solve(self.laplacian[1:, 1:], right[1:])
        return solution + mean - solution.mean(axis=0)

    def at(self, t):
        weights = spline_weights(self.times, t)
        # Applied share of each step: the sum of the weights of all keys from its end on.
        shares = np.cumsum(weights[::-1])[::-1][1:]
        stretch = np.einsum("k,kfij->fij", weights, self.stretch)
        mean = np.tensordot(weights, self.keys.mean(axis=1), 1)
        return shares, stretch, mean

    # Increments of a step. Each gets the full turns that bring it nearest to a neighbour's, starting at the smallest.
    def lifted(self, step):
        increments = np.array([log(a.T @ b) for a, b in zip(self.rotation[step], self.rotation[step + 1])])
        neighbours = [[] for _ in self.faces]
        for f, g in self.pairs:
            neighbours[f].append(g), neighbours[g].append(f)
        done = {int(np.argmin(np.linalg.norm(increments, axis=1)))}
        waiting = sorted(done)
        while waiting:
            f = waiting.pop(0)
            for g in neighbours[f]:
                if g in done:
                    continue
                angle = np.linalg.norm(increments[g])
                axis = increments[g] / angle if angle > 1e-8 else np.zeros(3)
                turns = np.round((increments[f] @ axis - angle) / (2 * np.pi))
                increments[g] += 2 * np.pi * turns * axis
                done.add(g), waiting.append(g)
        return increments

    def rotation_strain(self, times):
        steps = [self.lifted(k) for k in range(len(self.keys) - 1)]
        shapes = []
        for t in times:
            shares, stretch, mean = self.at(t)
            gradients = []
            for f in range(len(self.faces)):
                gradients.append(path(self.rotation[0][f], shares, [step[f] for step in steps]) @ stretch[f])
            shapes.append(self.solve(gradients, mean))
        return shapes

    def rimd(self, times, starts):
        keys = range(len(self.keys))
        differences = [[self.rotation[k][f].T @ self.rotation[k][g] for f, g in self.pairs] for k in keys]
        steps = [[log(a.T @ b) for a, b in zip(differences[k], differences[k + 1])] for k in keys[:-1]]
        furthest = np.max([[np.linalg.norm(v) for v in step] for step in steps], axis=0)
        agreement = MIN_AGREEMENT + ((1 + np.cos(np.minimum(furthest, np.pi))) / 2) ** 6
        weight = [(self.area[f] + self.area[g]) / 4 * a for (f, g), a in zip(self.pairs, agreement)]
        return [self.improve(t, start, differences[0], steps, weight) for t, start in zip(times, starts)]

    def improve(self, t, v, first, steps, weight):
        shares, stretch, mean = self.at(t)
        difference = [path(d, shares, increments) for d, increments in zip(first, zip(*steps))]
        rotation = [self.rotation_and_stretch(v, f)[0] for f in range(len(self.faces))]
        for _ in range(STEPS):
            sums = []
            for f in range(len(self.faces)):
                r, s = self.rotation_and_stretch(v, f)
                sums.append(self.area[f] * r @ s @ stretch[f].T)
            for (f, g), d, w in zip(self.pairs, difference, weight):
                sums[f] += w * rotation[g] @ d.T
                sums[g] += w * rotation[f] @ d
            rotation = [polar(m) for m in sums]
            v = self.solve([r @ s for r, s in zip(rotation, stretch)], mean)
        return v


def path(first, shares, increments):
    """Halfway between the product of the increments from the first key and the one from the last key."""
    forward, end, back = first, first, np.eye(3)
    for share, increment in zip(shares, increments):
        forward, end = forward @ exp(share * increment), end @ exp(increment)
        back = exp((share - 1) * increment) @ back
    return forward @ exp(log(forward.T @ end @ back) / 2)


given = arguments()
faces = np.array(given["faces"], dtype=int).reshape(-1, 3)
keys = np.array(given["keys"]).reshape(len(given["keys"]), -1, 3)
shape = Shape(faces, keys, np.array(given["keyTimes"]))
starts = [np.array(start).reshape(-1, 3) for start in given["lri"]]
answer(
    {
        "rotation-strain": [v.flatten().tolist() for v in shape.rotation_strain(given["times"])],
        "rimd": [v.flatten().tolist() for v in shape.rimd(given["times"], starts)],
    }
)

# SPDX-License-Identifier: Apache-2.0
"""Soft bodies: round cones that melt into each other within one material and meet with a hem where materials change.

A body is a list of Cone; `surface` walks its distance field on a grid (surface nets) and returns vertices, triangles
and the label of every triangle. Metres. numpy only.
"""
from dataclasses import dataclass

import numpy as np


@dataclass
class Cone:
    start: tuple
    end: tuple
    start_radius: float
    end_radius: float
    label: str
    blend: float = 0.03     # how far it melts into its own label
    carve: bool = False     # taken away from its label instead of added


class Body:
    def __init__(self, cones, wrinkles=None):
        """wrinkles: label -> function of points (n x 3) giving metres to grow."""
        self.cones = cones
        self.labels = sorted({c.label for c in cones})
        self.wrinkles = wrinkles or {}

    def distance(self, points, reach=np.inf):
        """Distance of each point to the surface of every label, labels x n; not exact beyond `reach`."""
        out = np.full((len(self.labels), len(points)), 1.0, np.float32)
        for carve in (False, True):
            for cone in self.cones:
                if cone.carve == carve:
                    self._melt(out[self.labels.index(cone.label)], cone, points, reach)
        for label, grow in self.wrinkles.items():
            if label in self.labels:
                row = out[self.labels.index(label)]
                near = np.abs(row) < 0.06
                row[near] -= grow(points[near]).astype(np.float32)
        return out

    @staticmethod
    def _melt(row, cone, points, reach):
        a, b = np.array(cone.start, np.float32), np.array(cone.end, np.float32)
        margin = max(cone.start_radius, cone.end_radius) + reach
        near = np.arange(len(points)) if np.isinf(reach) else np.flatnonzero(
            np.all((points > np.minimum(a, b) - margin) & (points < np.maximum(a, b) + margin), axis=1))
        p = points[near]
        axis = b - a
        t = np.clip((p - a) @ axis / max(float(axis @ axis), 1e-9), 0, 1)
        d = np.linalg.norm(p - (a + t[:, None] * axis), axis=1) - (cone.start_radius + (cone.end_radius - cone.start_radius) * t)
        old = row[near]
        if cone.carve:
            row[near] = np.maximum(old, -d)
            return
        h = np.maximum(cone.blend - np.abs(old - d), 0)
        row[near] = np.minimum(old, d) - h * h / (4 * cone.blend)


def surface(body, cell):
    """Surface nets on a grid of `cell` metres, vertices then pulled onto the field."""
    ends = np.array([c.start for c in body.cones] + [c.end for c in body.cones])
    low, high = ends.min(0) - 0.3, ends.max(0) + 0.3
    size = np.ceil((high - low) / cell).astype(int) + 1
    axes = [low[i] + cell * np.arange(size[i]) for i in range(3)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3).astype(np.float32)
    field = np.concatenate([body.distance(part, 0.08).min(0) for part in np.array_split(grid, 8)]).reshape(size)
    inside = field < 0
    corners = [inside[i:size[0] - 1 + i, j:size[1] - 1 + j, k:size[2] - 1 + k] for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    count = np.sum(corners, axis=0)
    mixed = (count > 0) & (count < 8)
    number = np.full(mixed.shape, -1)
    number[mixed] = np.arange(mixed.sum())
    vertices = (low + cell * (np.argwhere(mixed) + 0.5)).astype(np.float32)

    quads = []
    for axis in range(3):
        one, two = [(1, 2), (2, 0), (0, 1)][axis]
        step = np.eye(3, dtype=int)
        here = inside[tuple(slice(0, size[i] - 1) if i == axis else slice(1, size[i] - 1) for i in range(3))]
        ahead = inside[tuple(slice(1, size[i]) if i == axis else slice(1, size[i] - 1) for i in range(3))]
        for crossing, flip in ((here & ~ahead, False), (~here & ahead, True)):
            at = np.argwhere(crossing) + np.array([0 if i == axis else 1 for i in range(3)])
            ring = [at - step[one] - step[two], at - step[two], at, at - step[one]]
            if flip:
                ring = ring[::-1]
            quads.append(np.stack([number[tuple(r.T)] for r in ring], 1))
    quads = np.concatenate(quads)

    for _ in range(4):   # relax along the sheet, then Newton onto the surface
        total, hits = np.zeros_like(vertices), np.zeros(len(vertices))
        for a in range(4):
            np.add.at(total, quads[:, a], vertices[quads[:, (a + 1) % 4]] + vertices[quads[:, (a + 3) % 4]])
            np.add.at(hits, quads[:, a], 2)
        vertices = 0.5 * vertices + 0.5 * total / hits[:, None].astype(np.float32)
        vertices -= np.clip(step_to_surface(body, vertices), -cell, cell)
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    return vertices, triangles


def step_to_surface(body, points, h=0.002):
    value = body.distance(points, 0.08).min(0)
    slope = np.stack([body.distance(points + np.eye(3, dtype=np.float32)[i] * h, 0.08).min(0) - value for i in range(3)], 1) / h
    return value[:, None] * slope / np.maximum((slope * slope).sum(1), 0.25)[:, None]


def labels_at(body, points):
    """Index into body.labels of the surface each point lies on."""
    return body.distance(np.asarray(points, np.float32), 0.08).argmin(0)

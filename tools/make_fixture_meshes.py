#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the yoke-and-head meshes of the VL2500 as GLB: base, yoke, head_spot, head_wash.

usage: make_fixture_meshes.py [--out FOLDER]     default: assets/fixtures/src/shared/models/gltf

GDTF frame while building: metres, X right, Y into the stage, Z up, hanging; each part around its own axis of rotation.
The files are glTF: Y up, so (x, y, z) is written as (x, z, -y). The bounding box of each mesh is exactly the Length,
Width and Height of its Model element.
"""
import argparse
import json
import math
import struct
from pathlib import Path

import numpy

OUT = Path(__file__).resolve().parent.parent / "assets/fixtures/src/shared/models/gltf"

# name: base colour (linear), metallic, roughness, emission
MATERIALS = {
    "black paint": ((0.022, 0.022, 0.024), 0.0, 0.55, (0, 0, 0)),
    "dark casting": ((0.012, 0.012, 0.013), 0.0, 0.75, (0, 0, 0)),
    "steel": ((0.35, 0.35, 0.36), 1.0, 0.35, (0, 0, 0)),
    "front glass": ((0.03, 0.035, 0.05), 0.0, 0.05, (0, 0, 0)),
    "display": ((0.01, 0.02, 0.03), 0.0, 0.2, (0.05, 0.25, 0.4)),
    "label": ((0.5, 0.5, 0.5), 0.0, 0.6, (0, 0, 0)),
}


class Mesh:
    def __init__(self):
        self.triangles = {}  # material -> list of 3x3 arrays

    def add(self, material, points, faces):
        points = numpy.asarray(points, float)
        for face in faces:
            for i in range(1, len(face) - 1):
                self.triangles.setdefault(material, []).append(points[[face[0], face[i], face[i + 1]]])

    def box(self, material, low, high, bevel=0.0):
        """A box with its eight corners and twelve edges cut by bevel."""
        low, high = numpy.asarray(low, float), numpy.asarray(high, float)
        if bevel <= 0:
            points = [[(low, high)[(i >> a) & 1][a] for a in range(3)] for i in range(8)]
            self.add(material, points, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])
            return
        centre, half = (low + high) / 2, (high - low) / 2
        points, index = [], {}
        for corner in range(8):
            sign = numpy.array([1 if (corner >> a) & 1 else -1 for a in range(3)])
            for axis in range(3):  # the corner's point on the face of this axis
                offset = half - bevel
                offset = numpy.where(numpy.arange(3) == axis, half, offset)
                index[corner, axis] = len(points)
                points.append(centre + sign * offset)
        faces = []
        for axis in range(3):
            b, c = (axis + 1) % 3, (axis + 2) % 3
            for side in (0, 1):
                ring = [(side << axis) | (u << b) | (v << c) for u, v in ((0, 0), (1, 0), (1, 1), (0, 1))]
                faces.append([index[k, axis] for k in ring])
            for u in (0, 1):  # the four edges along this axis, between the faces of b and c
                for v in (0, 1):
                    k0, k1 = (u << b) | (v << c), (1 << axis) | (u << b) | (v << c)
                    faces.append([index[k0, b], index[k1, b], index[k1, c], index[k0, c]])
        faces += [[index[corner, a] for a in range(3)] for corner in range(8)]
        self.add(material, points, [outward(points, face, centre) for face in faces])

    def loft(self, material, sections, segments=40, caps=(True, True), flip=False):
        """Closed rings of superellipses: (z, half x, half y, exponent); caps at the first and last."""
        rings = []
        for z, half_x, half_y, exponent in sections:
            angle = numpy.linspace(0, 2 * math.pi, segments, endpoint=False)
            c, s = numpy.cos(angle), numpy.sin(angle)
            x = half_x * numpy.sign(c) * numpy.abs(c) ** (2 / exponent)
            y = half_y * numpy.sign(s) * numpy.abs(s) ** (2 / exponent)
            rings.append(numpy.stack([x, y, numpy.full(segments, z)], 1))
        points = numpy.concatenate(rings)
        faces = []
        for r in range(len(rings) - 1):
            for i in range(segments):
                j = (i + 1) % segments
                a, b, c, d = r * segments + i, r * segments + j, (r + 1) * segments + j, (r + 1) * segments + i
                faces.append((a, b, c, d) if not flip else (d, c, b, a))
        if caps[0]:
            faces.append(tuple(reversed(range(segments))) if not flip else tuple(range(segments)))
        if caps[1]:
            last = range((len(rings) - 1) * segments, len(rings) * segments)
            faces.append(tuple(last) if not flip else tuple(reversed(last)))
        self.add(material, points, faces)

    def extrude_x(self, material, outline, x_low, x_high):
        """A convex outline of (y, z), counter-clockwise seen from +X, between two x."""
        n = len(outline)
        points = [(x_low, y, z) for y, z in outline] + [(x_high, y, z) for y, z in outline]
        faces = [tuple(reversed(range(n))), tuple(range(n, 2 * n))]
        faces += [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
        self.add(material, points, faces)

    def turned(self, matrix, shift=(0, 0, 0)):
        result = Mesh()
        for material, list_of in self.triangles.items():
            result.triangles[material] = [t @ numpy.asarray(matrix, float).T + numpy.asarray(shift, float) for t in list_of]
        return result

    def take(self, other):
        for material, list_of in other.triangles.items():
            self.triangles.setdefault(material, []).extend(list_of)


def outward(points, face, centre):
    p = numpy.asarray([points[i] for i in face])
    normal = numpy.cross(p[1] - p[0], p[2] - p[0])
    return face if normal @ (p.mean(0) - centre) > 0 else list(reversed(face))


X_TO_Z = [[0, 0, -1], [0, 1, 0], [1, 0, 0]]  # turns a loft along Z into one along -X


def base():
    """0.494 x 0.382 x 0.105; the top plate at z = 0 hangs under the truss."""
    mesh = Mesh()
    mesh.box("black paint", (-0.215, -0.188, -0.088), (0.215, 0.188, -0.012), 0.012)
    mesh.box("dark casting", (-0.14, -0.10, -0.012), (0.14, 0.10, 0.0), 0.003)  # clamp plate
    mesh.loft("dark casting", [(-0.105, 0.085, 0.085, 2), (-0.087, 0.1, 0.1, 2)], 40)  # pan bearing
    for side in (-1, 1):  # carrying handles
        for y in (-0.09, 0.09):
            mesh.box("dark casting", *span((side * 0.21, y - 0.014, -0.066), (side * 0.24, y + 0.014, -0.038)), 0.003)
        mesh.box("dark casting", *span((side * 0.228, -0.104, -0.069), (side * 0.247, 0.104, -0.035)), 0.006)
    mesh.box("label", (-0.12, -0.1892, -0.072), (0.12, -0.18, -0.028), 0)  # front panel
    mesh.box("display", (-0.1, -0.1902, -0.064), (-0.02, -0.186, -0.036), 0)
    for i in range(4):
        mesh.box("dark casting", (0.01 + 0.024 * i, -0.191, -0.058), (0.026 + 0.024 * i, -0.186, -0.042), 0)
    for x in (-0.13, -0.06, 0.06, 0.13):  # sockets on the back
        mesh.box("steel", (x - 0.014, 0.186, -0.064), (x + 0.014, 0.191, -0.036), 0)
    return mesh


def span(a, b):
    return tuple(map(min, a, b)), tuple(map(max, a, b))


def yoke():
    """0.423 x 0.153 x 0.354; pan axis = Z through the origin, tilt axis at z = -0.29."""
    mesh = Mesh()
    mesh.loft("dark casting", [(-0.02, 0.09, 0.0765, 2), (0.0, 0.08, 0.072, 2)], 40)
    mesh.box("black paint", (-0.2115, -0.0765, -0.046), (0.2115, 0.0765, -0.012), 0.012)
    for side in (-1, 1):
        outline = [(0.07, -0.03), (-0.07, -0.03), (-0.0765, -0.06), (-0.0745, -0.25)]
        steps = 14
        for i in range(steps + 1):  # the round end about the tilt axis
            angle = math.pi + math.pi * i / steps
            outline.append((0.064 * math.cos(angle), -0.29 + 0.064 * math.sin(angle)))
        outline += [(0.0745, -0.25), (0.0765, -0.06)]
        low, high = (0.148, 0.205) if side > 0 else (-0.205, -0.148)
        mesh.extrude_x("black paint", outline, low, high)
        cover = Mesh()  # round motor cover outside, bearing inside
        cover.loft("dark casting", [(0, 0.054, 0.054, 2), (0.004, 0.05, 0.05, 2), (0.0065, 0.04, 0.04, 2)], 32)
        turn = X_TO_Z if side < 0 else [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]
        mesh.take(cover.turned(turn, (side * 0.205, 0, -0.29)))
        bearing = Mesh()
        bearing.loft("steel", [(0, 0.03, 0.03, 2), (0.022, 0.03, 0.03, 2)], 24)
        mesh.take(bearing.turned(turn, (side * 0.127, 0, -0.29)))
        for z in (-0.10, -0.13, -0.16, -0.19):  # cooling slits of the arm
            mesh.box("dark casting", *span((side * 0.204, -0.045, z - 0.005), (side * 0.207, 0.045, z + 0.005)), 0)
    return mesh


def head(length, spot):
    """0.255 x 0.225 x length; tilt axis = X through the origin, the lens at z = -0.255 looks down."""
    mesh = Mesh()
    hx, hy = 0.1275, 0.1125
    back = length - 0.255
    sections = [(-0.235, 0.100, 0.100, 2.2), (-0.205, 0.112, 0.106, 2.4), (-0.12, 0.121, hy, 2.8), (0.02, hx, hy, 3.2)]
    if not spot:
        sections[0] = (-0.235, 0.122, 0.1115, 2.1)
        sections[1] = (-0.20, 0.124, hy, 2.3)
    fin_z, fins = 0.045, 7
    pitch = (back - 0.055 - fin_z) / fins
    mesh.loft("black paint", sections + [(fin_z, hx, hy, 3.2)], 44, caps=(True, False))
    for i in range(fins):  # cooling fins round the lamp house
        z = fin_z + i * pitch
        shrink = 1.0 - 0.012 * i
        mesh.loft("dark casting", [(z, hx * shrink, hy * shrink, 3.2), (z + pitch * 0.45, hx * shrink, hy * shrink, 3.2),
                                   (z + pitch * 0.5, 0.108 * shrink, 0.095 * shrink, 3.2),
                                   (z + pitch, 0.108 * shrink, 0.095 * shrink, 3.2)], 44, caps=(True, False))
    mesh.loft("black paint", [(back - 0.055, 0.116, 0.102, 3), (back - 0.02, 0.11, 0.096, 3), (back - 0.004, 0.085, 0.075, 2.6),
                              (back, 0.07, 0.06, 2.4)], 44, caps=(True, True))
    for side in (-1, 1):  # seams of the two covers
        mesh.box("dark casting", *span((side * 0.118, -0.003, -0.2), (side * 0.1272, 0.003, 0.04)), 0)
    # Front ring and lens: the ring is the lowest part, the glass sits a little inside.
    radius = 0.078 if spot else 0.108
    outer = radius + (0.022 if spot else 0.012)
    outer = min(outer, hy)
    mesh.loft("dark casting", [(-0.255, radius, radius, 2), (-0.255, outer, outer, 2), (-0.23, outer, outer, 2), (-0.225, 0.07, 0.07, 2)], 44,
              caps=(False, True))
    mesh.loft("dark casting", [(-0.255, radius, radius, 2), (-0.238, radius, radius, 2)], 44, caps=(False, False), flip=True)
    dome = 0.008 if spot else 0.004
    rings = [(-0.238 - dome * math.cos(a), max(radius * math.sin(a), 1e-4), max(radius * math.sin(a), 1e-4), 2)
             for a in numpy.linspace(0.02, math.pi / 2, 7)]
    mesh.loft("front glass", rings, 44, caps=(True, False))
    return mesh


def fit(mesh, size, low_z=None):
    """Scales by less than a per cent so that the box is exact; z ends at low_z or at 0 on top."""
    points = numpy.concatenate([t for part in mesh.triangles.values() for t in part])
    low, high = points.min(0), points.max(0)
    scale = numpy.asarray(size) / (high - low)
    assert numpy.all(numpy.abs(scale - 1) < 0.02), (low, high, size)
    shift = -(low + high) / 2 * scale
    shift[2] = (low_z if low_z is not None else -size[2]) - low[2] * scale[2]
    return mesh.turned(numpy.diag(scale), shift)


def smooth_normals(triangles, limit_deg=35):
    """Per corner: the mean of the face normals that meet there within the limit, weighted by area."""
    t = numpy.asarray(triangles)
    cross = numpy.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])
    area = numpy.linalg.norm(cross, axis=1)
    keep = area > 1e-10
    t, cross, area = t[keep], cross[keep], area[keep]
    unit = cross / area[:, None]
    corners = {}
    keys = numpy.round(t.reshape(-1, 3) * 1e5).astype(int)
    for i, key in enumerate(map(tuple, keys)):
        corners.setdefault(key, []).append(i // 3)
    normals = numpy.empty_like(t.reshape(-1, 3))
    for i, key in enumerate(map(tuple, keys)):
        faces = numpy.array(corners[key])
        near = faces[unit[faces] @ unit[i // 3] > math.cos(math.radians(limit_deg))]
        total = cross[near].sum(0)
        normals[i] = total / numpy.linalg.norm(total)
    return t.reshape(-1, 3), normals


def to_gltf(vectors):
    return numpy.stack([vectors[:, 0], vectors[:, 2], -vectors[:, 1]], 1).astype("<f4")


def write_glb(path, name, mesh):
    binary, views, accessors, primitives, materials = b"", [], [], [], []

    def view(data, target):
        nonlocal binary
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data), "target": target})
        binary += data + b"\0" * (-len(data) % 4)
        return len(views) - 1

    count = 0
    for material, triangles in sorted(mesh.triangles.items()):
        positions, normals = smooth_normals(triangles)
        table = numpy.round(numpy.concatenate([to_gltf(positions), to_gltf(normals)], 1), 6) + 0.0
        table, inverse = numpy.unique(table.astype("<f4"), axis=0, return_inverse=True)
        count += len(inverse) // 3
        index = inverse.reshape(-1).astype("<u2" if len(table) < 65536 else "<u4")
        corner, normal = numpy.ascontiguousarray(table[:, :3]), numpy.ascontiguousarray(table[:, 3:])
        first = len(accessors)
        accessors += [
            {"bufferView": view(corner.tobytes(), 34962), "componentType": 5126, "count": len(table), "type": "VEC3",
             "min": [float(v) for v in corner.min(0)], "max": [float(v) for v in corner.max(0)]},
            {"bufferView": view(normal.tobytes(), 34962), "componentType": 5126, "count": len(table), "type": "VEC3"},
            {"bufferView": view(index.tobytes(), 34963), "componentType": 5123 if index.itemsize == 2 else 5125,
             "count": len(index), "type": "SCALAR"}]
        color, metallic, roughness, emission = MATERIALS[material]
        materials.append({"name": material, "emissiveFactor": list(emission), "pbrMetallicRoughness": {
            "baseColorFactor": [*color, 1], "metallicFactor": metallic, "roughnessFactor": roughness}})
        primitives.append({"attributes": {"POSITION": first, "NORMAL": first + 1}, "indices": first + 2,
                           "material": len(materials) - 1})
    document = {"asset": {"version": "2.0", "generator": "make_fixture_meshes.py"}, "scene": 0,
                "scenes": [{"nodes": [0]}], "nodes": [{"name": name, "mesh": 0}],
                "meshes": [{"name": name, "primitives": primitives}], "materials": materials,
                "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(binary)}]}
    text = json.dumps(document, separators=(",", ":"), sort_keys=True).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)) +
                     struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary)
    print(f"{path.name}: {count} triangles, {path.stat().st_size} bytes")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=OUT)
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    write_glb(out / "base.glb", "base", fit(base(), (0.494, 0.382, 0.105)))
    write_glb(out / "yoke.glb", "yoke", fit(yoke(), (0.423, 0.153, 0.354)))
    write_glb(out / "head_spot.glb", "head_spot", fit(head(0.494, True), (0.255, 0.225, 0.494), -0.255))
    write_glb(out / "head_wash.glb", "head_wash", fit(head(0.497, False), (0.255, 0.225, 0.497), -0.255))


if __name__ == "__main__":
    main()

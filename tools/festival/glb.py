# SPDX-License-Identifier: Apache-2.0
"""A small glTF 2.0 writer: shapes, instances, meshes taken over from another GLB. Shapes and matrices are Z up, the file Y up."""
import json
import math
import struct
from array import array


def place(x, y, z, turn=0.0, scale=1.0, tip=0.0):
    """3 rows of 4: scaled, tipped about X, turned about Z (radians), moved."""
    c, s, k, q = math.cos(turn), math.sin(turn), math.cos(tip), math.sin(tip)
    return ((c * scale, -s * k * scale, s * q * scale, x), (s * scale, c * k * scale, -c * q * scale, y), (0.0, q * scale, k * scale, z))


def upright(x, y, z):
    """What lies along X then stands along Z."""
    return (0.0, 0.0, -1.0, x), (0.0, 1.0, 0.0, y), (1.0, 0.0, 0.0, z)


def along_y(x, y, z):
    """What lies along X then lies along Y."""
    return place(x, y, z, math.pi / 2)


def minus(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def unit(a):
    length = math.sqrt(a[0] ** 2 + a[1] ** 2 + a[2] ** 2) or 1.0
    return a[0] / length, a[1] / length, a[2] / length


class Shape:
    """Triangles with normals, by material."""

    def __init__(self):
        self.parts = {}   # material -> (positions, normals, indices)

    def add(self, material, points, faces, normals=None):
        """Without normals every face is flat. Faces counter-clockwise from outside."""
        positions, directions, indices = self.parts.setdefault(material, (array("f"), array("f"), array("I")))
        first = len(positions) // 3
        if normals:
            for p, n in zip(points, normals):
                positions.extend((p[0], p[2], -p[1]))
                directions.extend((n[0], n[2], -n[1]))
        for face in faces:
            if normals:
                corners = [first + i for i in face]
            else:
                start = len(positions) // 3
                corners = range(start, start + len(face))
                a, b, c = (points[i] for i in face[:3])
                n = unit(cross(minus(b, a), minus(c, a)))
                for i in face:
                    positions.extend((points[i][0], points[i][2], -points[i][1]))
                    directions.extend((n[0], n[2], -n[1]))
            for k in range(1, len(corners) - 1):
                indices.extend((corners[0], corners[k], corners[k + 1]))
        return self

    def box(self, material, low, high):
        points = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
        return self.add(material, points, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])

    def rod(self, material, start, end, radius, sides=6, end_radius=None, caps=False):
        """A smooth round bar, or a cone."""
        end_radius = radius if end_radius is None else end_radius
        ahead = unit(minus(end, start))
        u = unit(cross(ahead, (0, 0, 1) if abs(ahead[2]) < 0.9 else (1, 0, 0)))
        v = cross(ahead, u)
        around = [tuple(math.cos(a) * p + math.sin(a) * q for p, q in zip(u, v)) for a in (2 * math.pi * i / sides for i in range(sides))]
        points = [tuple(c + r * d for c, d in zip(centre, n)) for centre, r in ((start, radius), (end, end_radius)) for n in around]
        self.add(material, points, [(i, (i + 1) % sides, sides + (i + 1) % sides, sides + i) for i in range(sides)], around * 2)
        if caps:
            self.add(material, points, [tuple(reversed(range(sides))), tuple(range(sides, 2 * sides))])
        return self

    def ellipsoid(self, material, centre, radii, sides=8, rings=5):
        points, normals, faces = [], [], []
        for j in range(rings + 1):
            for i in range(sides):
                a, b = 2 * math.pi * i / sides, math.pi * j / rings - math.pi / 2
                n = (math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), math.sin(b))
                points.append(tuple(c + r * d for c, r, d in zip(centre, radii, n)))
                normals.append(unit(tuple(d / r for r, d in zip(radii, n))))
        for j in range(rings):
            for i in range(sides):
                a, b = j * sides + i, j * sides + (i + 1) % sides
                face = (a, b, b + sides, a + sides)
                faces.append(face[1:] if j == 0 else face[:3] if j == rings - 1 else face)
        faces[:sides] = [(i, sides + (i + 1) % sides, sides + i) for i in range(sides)]
        return self.add(material, points, faces, normals)

    def sheet(self, material, columns, rows, surface):
        """surface(u, v) -> point for u, v in 0..1; seen from the side where u goes right and v up."""
        points = [surface(i / columns, j / rows) for j in range(rows + 1) for i in range(columns + 1)]
        wide = columns + 1
        faces, normals = [], []
        for j in range(rows + 1):
            for i in range(wide):
                across = minus(points[j * wide + min(i + 1, columns)], points[j * wide + max(i - 1, 0)])
                up = minus(points[min(j + 1, rows) * wide + i], points[max(j - 1, 0) * wide + i])
                normals.append(unit(cross(across, up)))
        for j in range(rows):
            for i in range(columns):
                a = j * wide + i
                faces.append((a, a + 1, a + wide + 1, a + wide))
        return self.add(material, points, faces, normals)


class Scene:
    def __init__(self, materials):
        """materials: name -> (linear colour, roughness, metalness, seen from both sides)"""
        self.materials, self.used = materials, {}
        self.meshes, self.triangles, self.nodes, self.top = [], [], [], []
        self.views, self.accessors, self.blob = [], [], bytearray()
        self.drawn = 0

    def _material(self, name):
        return self.used.setdefault(name, len(self.used))

    def _accessor(self, data, component, kind, count, bounds=None):
        while len(self.blob) % 4:
            self.blob.append(0)
        self.views.append({"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data),
                           "target": 34963 if kind == "SCALAR" else 34962})
        self.blob += data
        entry = {"bufferView": len(self.views) - 1, "componentType": component, "count": count, "type": kind}
        if bounds:
            entry["min"], entry["max"] = bounds
        self.accessors.append(entry)
        return len(self.accessors) - 1

    def mesh(self, name, shape):
        primitives = []
        for material, (positions, normals, indices) in shape.parts.items():
            count = len(positions) // 3
            bounds = [min(positions[i::3]) for i in range(3)], [max(positions[i::3]) for i in range(3)]
            short = count < 65536
            attributes = {"POSITION": self._accessor(little(positions), 5126, "VEC3", count, bounds),
                          "NORMAL": self._accessor(little(normals), 5126, "VEC3", count)}
            where = self._accessor(little(array("H", indices) if short else indices), 5123 if short else 5125, "SCALAR", len(indices))
            primitives.append({"attributes": attributes, "indices": where, "material": self._material(material)})
        self.triangles.append(sum(len(part[2]) // 3 for part in shape.parts.values()))
        self.meshes.append({"name": name, "primitives": primitives})
        return len(self.meshes) - 1

    def borrow(self, other, name):
        """A mesh of another file with its normals; no texture coordinates, materials by their names."""
        source = next(mesh for mesh in other.json["meshes"] if mesh["name"] == name)
        primitives = []
        for part in source["primitives"]:
            attributes = {kind: self._copy(other, part["attributes"][kind]) for kind in ("POSITION", "NORMAL")}
            material = other.json["materials"][part["material"]]["name"]
            primitives.append({"attributes": attributes, "indices": self._copy(other, part["indices"]),
                               "material": self._material(material)})
        self.triangles.append(sum(self.accessors[p["indices"]]["count"] // 3 for p in primitives))
        self.meshes.append({"name": name, "primitives": primitives})
        return len(self.meshes) - 1

    def _copy(self, other, index):
        entry = other.json["accessors"][index]
        bounds = (entry["min"], entry["max"]) if "min" in entry else None
        return self._accessor(other.bytes_of(index), entry["componentType"], entry["type"], entry["count"], bounds)

    def add(self, name, what, matrix=None, parent=None, **transform):
        """Puts a shape or the number of a mesh there. transform: glTF's own translation and rotation instead of a matrix."""
        mesh = self.mesh(name, what) if isinstance(what, Shape) else what
        node = {"name": name, **transform}
        if mesh is not None:
            node["mesh"] = mesh
            self.drawn += self.triangles[mesh]
        if matrix:
            (a, b, c, x), (d, e, f, y), (g, h, i, z) = matrix
            node["matrix"] = [round(v, 6) + 0.0 for v in (a, g, -d, 0, c, i, -f, 0, -b, -h, e, 0, x, z, -y, 1)]
        self.nodes.append(node)
        number = len(self.nodes) - 1
        if parent is None:
            self.top.append(number)
        else:
            self.nodes[parent].setdefault("children", []).append(number)
        return number

    def data(self):
        listed = []
        for name in self.used:
            colour, roughness, metalness, both_sides = self.materials[name]
            listed.append({"name": name, "doubleSided": both_sides, "pbrMetallicRoughness": {
                "baseColorFactor": [*colour, 1], "metallicFactor": metalness, "roughnessFactor": roughness}})
        text = json.dumps({"asset": {"version": "2.0", "generator": "make_festival.py"}, "scene": 0, "scenes": [{"nodes": self.top}],
                           "nodes": self.nodes, "materials": listed, "meshes": self.meshes, "accessors": self.accessors,
                           "bufferViews": self.views, "buffers": [{"byteLength": len(self.blob)}]}, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        blob = bytes(self.blob) + b"\0" * (-len(self.blob) % 4)
        head = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(blob))
        return head + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(blob), b"BIN\0") + blob


def little(values):
    return struct.pack(f"<{len(values)}{values.typecode}", *values)


class Glb:
    """A GLB to take meshes from."""

    def __init__(self, data):
        length, = struct.unpack_from("<I", data, 12)
        self.json = json.loads(data[20:20 + length])
        self.blob = memoryview(data)[28 + length:]

    def bytes_of(self, accessor):
        entry = self.json["accessors"][accessor]
        view = self.json["bufferViews"][entry["bufferView"]]
        size = {5126: 4, 5125: 4, 5123: 2, 5121: 1}[entry["componentType"]] * {"SCALAR": 1, "VEC3": 3}[entry["type"]]
        start = view.get("byteOffset", 0) + entry.get("byteOffset", 0)
        return bytes(self.blob[start:start + size * entry["count"]])

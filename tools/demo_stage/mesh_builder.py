# SPDX-License-Identifier: Apache-2.0
"""Meshes from boxes, cylinders, tubes, turned profiles and grids; objects that share them. Metres; texture coordinates in metres too."""
import math

import bmesh
import bpy
from mathutils import Euler, Matrix, Vector

IDENTITY = Matrix.Identity(4)


def place(x, y, z, rz=0.0, rx=0.0, ry=0.0, scale=1.0):
    return (Matrix.Translation((x, y, z)) @ Euler((rx, ry, rz)).to_matrix().to_4x4()
            @ Matrix.Diagonal((scale, scale, scale, 1)))


def circle(n, radius=1.0):
    return [(radius * math.cos(2 * math.pi * i / n), radius * math.sin(2 * math.pi * i / n)) for i in range(n)]


class Stage:
    """The scene being built: materials by name, objects by name."""

    def __init__(self, materials):
        self.materials = materials

    def add(self, name, shape, matrix=IDENTITY):
        """Puts a builder or a finished mesh into the scene; a mesh placed twice becomes an instance in the file."""
        mesh = shape.mesh(self, name) if isinstance(shape, MeshBuilder) else shape
        item = bpy.data.objects.new(name, mesh)
        bpy.context.scene.collection.objects.link(item)
        item.matrix_local = matrix
        return item


class MeshBuilder:
    _boxes = {}

    def __init__(self):
        self.points, self.faces, self.face_material, self.face_smooth, self.face_uv = [], [], [], [], []
        self.material_names = []

    def add(self, points, faces, material, smooth=False, matrix=IDENTITY, uvs=None, uv_scale=1.0):
        """uvs: one list of (u, v) per face; without it each face is projected along its main axis, uv_scale tiles a metre."""
        first = len(self.points)
        points = [matrix @ Vector(p) for p in points]
        self.points += points
        if material not in self.material_names:
            self.material_names.append(material)
        index = self.material_names.index(material)
        for k, face in enumerate(faces):
            self.faces.append([first + i for i in face])
            self.face_material.append(index)
            self.face_smooth.append(smooth)
            self.face_uv.append(uvs[k] if uvs else projected([points[i] for i in face], uv_scale))

    def box(self, size, centre, material, bevel=0.0, segments=1, rotation=(0, 0, 0), uv_scale=1.0, matrix=IDENTITY):
        points, faces = self._box(size, bevel, segments)
        local = Matrix.Translation(centre) @ Euler(rotation).to_matrix().to_4x4()
        self.add(points, faces, material, False, matrix @ local, uv_scale=uv_scale)

    @classmethod
    def _box(cls, size, bevel, segments):
        key = (*(round(s, 4) for s in size), bevel, segments)
        if key not in cls._boxes:
            shape = bmesh.new()
            bmesh.ops.create_cube(shape, size=1)
            bmesh.ops.scale(shape, vec=size, verts=shape.verts)
            if bevel:
                bmesh.ops.bevel(shape, geom=list(shape.edges), offset=bevel, segments=segments, affect="EDGES", profile=0.5)
            shape.verts.index_update()
            cls._boxes[key] = [tuple(v.co) for v in shape.verts], [[v.index for v in f.verts] for f in shape.faces]
            shape.free()
        return cls._boxes[key]

    def cylinder(self, start, end, radius, material, sides=8, end_radius=None, caps=True, matrix=IDENTITY):
        start, end = Vector(start), Vector(end)
        end_radius = radius if end_radius is None else end_radius
        length = (end - start).length
        turn = (end - start).to_track_quat("Z", "Y")
        around = [turn @ Vector((x, y, 0)) for x, y in circle(sides)]
        lower, upper = [start + radius * a for a in around], [end + end_radius * a for a in around]
        n = sides
        girth = 2 * math.pi * max(radius, end_radius)
        faces = [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
        uvs = [[(girth * i / n, 0), (girth * (i + 1) / n, 0), (girth * (i + 1) / n, length), (girth * i / n, length)] for i in range(n)]
        self.add(lower + upper, faces, material, True, matrix, uvs)
        if caps:
            self.add(lower, [list(range(n))[::-1]], material, False, matrix)
            self.add(upper, [list(range(n))], material, False, matrix)

    def tube(self, path, radius, material, sides=8, matrix=IDENTITY):
        path = [Vector(p) for p in path]
        n, points, along = sides, [], [0.0]
        for i, p in enumerate(path):
            ahead = (path[min(i + 1, len(path) - 1)] - path[max(i - 1, 0)]).normalized()
            side = ahead.orthogonal() if i == 0 else side - ahead * side.dot(ahead)
            side.normalize()
            across = ahead.cross(side)
            points += [p + radius * (x * side + y * across) for x, y in circle(n)]
            if i:
                along.append(along[-1] + (p - path[i - 1]).length)
        faces, uvs = [], []
        girth = 2 * math.pi * radius
        for i in range(len(path) - 1):
            for k in range(n):
                nxt = (k + 1) % n
                faces.append([i * n + k, i * n + nxt, (i + 1) * n + nxt, (i + 1) * n + k])
                u0, u1, v0, v1 = girth * k / n, girth * (k + 1) / n, along[i], along[i + 1]
                uvs.append([(u0, v0), (u1, v0), (u1, v1), (u0, v1)])
        self.add(points, faces, material, True, matrix, uvs)
        self.add(points[:n], [list(range(n))[::-1]], material, False, matrix)
        self.add(points[-n:], [list(range(n))], material, False, matrix)

    def lathe(self, profile, material, sides=24, matrix=IDENTITY, smooth=True):
        """Turns (radius, z) pairs about z; going up with material on the inside makes faces look outwards."""
        n = sides
        points = [(r * x, r * y, z) for r, z in profile for x, y in circle(n)]
        faces, uvs = [], []
        for i in range(len(profile) - 1):
            for k in range(n):
                nxt = (k + 1) % n
                face = [i * n + k, i * n + nxt, (i + 1) * n + nxt, (i + 1) * n + k]
                uv = [(k / n, i * 0.1), ((k + 1) / n, i * 0.1), ((k + 1) / n, i * 0.1 + 0.1), (k / n, i * 0.1 + 0.1)]
                keep = [0, 2, 3] if profile[i][0] < 1e-6 else [0, 1, 2] if profile[i + 1][0] < 1e-6 else [0, 1, 2, 3]
                faces.append([face[j] for j in keep])
                uvs.append([uv[j] for j in keep])
        self.add(points, faces, material, smooth, matrix, uvs)

    def sphere(self, centre, radius, material, sides=12, rings=8, matrix=IDENTITY):
        profile = [(max(0.0, radius * math.sin(math.pi * i / rings)), -radius * math.cos(math.pi * i / rings)) for i in range(rings + 1)]
        self.lathe(profile, material, sides, matrix @ Matrix.Translation(centre))

    def disc(self, radius, z, material, sides=32, matrix=IDENTITY, down=False):
        """A flat round face with the whole picture on it."""
        order = range(sides)[::-1] if down else range(sides)
        uv = [(0.5 + 0.5 * x * (1 if not down else -1), 0.5 + 0.5 * y) for x, y in circle(sides)]
        self.add([(x, y, z) for x, y in circle(sides, radius)], [list(order)], material, False, matrix, [[uv[i] for i in order]])

    def grid(self, columns, rows, surface, material, tiles_u=1.0, tiles_v=1.0, matrix=IDENTITY):
        """surface(u, v) -> point for u, v in 0..1."""
        points = [surface(i / columns, j / rows) for j in range(rows + 1) for i in range(columns + 1)]
        faces, uvs = [], []
        for j in range(rows):
            for i in range(columns):
                a = j * (columns + 1) + i
                faces.append([a, a + 1, a + columns + 2, a + columns + 1])
                u0, u1 = i / columns * tiles_u, (i + 1) / columns * tiles_u
                v0, v1 = j / rows * tiles_v, (j + 1) / rows * tiles_v
                uvs.append([(u0, v0), (u1, v0), (u1, v1), (u0, v1)])
        self.add(points, faces, material, True, matrix, uvs)

    def prism(self, outline, thickness, material, matrix=IDENTITY):
        """An (x, z) outline, counter-clockwise seen from -y, given a thickness along y."""
        n, half = len(outline), thickness / 2
        points = [(x, -half, z) for x, z in outline] + [(x, half, z) for x, z in outline]
        sides = [[(i + 1) % n, i, n + i, n + (i + 1) % n] for i in range(n)]
        self.add(points, [list(range(n)), list(range(n, 2 * n))[::-1]] + sides, material, False, matrix)

    def mesh(self, stage, name, smooth_angle=35):
        made = bpy.data.meshes.new(name)
        made.from_pydata([tuple(p) for p in self.points], [], self.faces)
        for material in self.material_names:
            made.materials.append(stage.materials[material])
        made.polygons.foreach_set("material_index", self.face_material)
        made.polygons.foreach_set("use_smooth", self.face_smooth)
        layer = made.uv_layers.new(name="UVMap")
        layer.data.foreach_set("uv", [c for face in self.face_uv for uv in face for c in uv])
        made.use_auto_smooth = True
        made.auto_smooth_angle = math.radians(smooth_angle)
        made.validate()
        made.update()
        return made


def projected(corners, scale):
    """Box projection: drop the axis the face looks along (Newell's normal)."""
    normal = Vector((0, 0, 0))
    for a, b in zip(corners, corners[1:] + corners[:1]):
        normal += Vector(((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y)))
    axis = max(range(3), key=lambda i: abs(normal[i]))
    keep = ((1, 2), (0, 2), (0, 1))[axis]
    return [(scale * p[keep[0]], scale * p[keep[1]]) for p in corners]

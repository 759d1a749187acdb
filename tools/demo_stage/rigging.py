# SPDX-License-Identifier: Apache-2.0
"""What hangs and what holds it: box trusses of tubes, towers, chain hoists, cable looms, line arrays. No fixtures: a show hangs its own."""
import math

from . import backline
from .layout import CHORD_RADIUS, DECK_Z, TRUSS_SEGMENT, TRUSS_SEGMENTS, TRUSS_SIDE, TRUSSES
from .mesh_builder import MeshBuilder, place

ALUMINIUM = "truss_aluminium"


def build(stage):
    segment = truss_segment(stage)
    trusses(stage, segment)
    towers(stage, segment)
    hoists(stage)
    looms(stage)
    sound(stage)


def truss_segment(stage):
    """Two metres of box truss along x: four chords, zigzag braces on four sides, end frames with couplers."""
    made = MeshBuilder()
    side, length = TRUSS_SIDE / 2, TRUSS_SEGMENT / 2
    for y in (-side, side):
        for z in (-side, side):
            made.cylinder((-length, y, z), (length, y, z), CHORD_RADIUS, ALUMINIUM, 12)
            for x in (-length, length - 0.05):
                made.cylinder((x, y, z), (x + 0.05, y, z), CHORD_RADIUS * 1.35, ALUMINIUM, 12)
    bays = 8
    for k in range(bays):
        x0, x1 = -length + k * TRUSS_SEGMENT / bays, -length + (k + 1) * TRUSS_SEGMENT / bays
        a = side if k % 2 else -side
        for s in (-side, side):
            made.cylinder((x0, s, a), (x1, s, -a), 0.01, ALUMINIUM, 7, caps=False)
            made.cylinder((x0, a, s), (x1, -a, s), 0.01, ALUMINIUM, 7, caps=False)
    for x in (-length + 0.03, length - 0.03):
        for s in (-side, side):
            made.cylinder((x, s, -side), (x, s, side), 0.012, ALUMINIUM, 8)
            made.cylinder((x, -side, s), (x, side, s), 0.012, ALUMINIUM, 8)
    return made.mesh(stage, "truss_2m")


def trusses(stage, segment):
    start = -TRUSS_SEGMENT * (TRUSS_SEGMENTS - 1) / 2
    for name, (y, z) in TRUSSES.items():
        for k in range(TRUSS_SEGMENTS):
            stage.add(f"truss_{name}_{k}", segment, place(start + TRUSS_SEGMENT * k, y, z))


def towers(stage, segment):
    base = MeshBuilder()
    base.box((1.0, 1.0, 0.04), (0, 0, 0.02), "black_metal", 0.005)
    for a in range(4):
        x, y = math.cos(a * math.pi / 2 + math.pi / 4), math.sin(a * math.pi / 2 + math.pi / 4)
        base.tube([(0.2 * x, 0.2 * y, 0.9), (0.66 * x, 0.66 * y, 0.05)], 0.024, ALUMINIUM, 8)
    foot = base.mesh(stage, "tower_foot")
    x = TRUSS_SEGMENT * TRUSS_SEGMENTS / 2 + 0.4
    for side in (-1, 1):
        for name in ("front", "back"):
            y = TRUSSES[name][0]
            which = f"tower_{name}_{'left' if side < 0 else 'right'}"
            stage.add(which + "_foot", foot, place(side * x, y, DECK_Z))
            for k in range(3):
                stage.add(f"{which}_{k}", segment, place(side * x, y, DECK_Z + 1.0 + 2 * k, ry=math.pi / 2))


def hoists(stage):
    made = MeshBuilder()
    made.box((0.26, 0.2, 0.36), (0, 0, 0.82), "hoist_yellow", 0.03, 2)
    made.cylinder((0.13, 0, 0.82), (0.24, 0, 0.82), 0.085, "black_metal", 16)
    made.cylinder((0, 0, 0.2), (0, 0, 0.65), 0.012, "chrome", 8)
    for y in (-TRUSS_SIDE / 2, TRUSS_SIDE / 2):   # the sling
        made.tube([(0, 0, 0.42), (0, y, TRUSS_SIDE / 2), (0, y, -TRUSS_SIDE / 2 - 0.03)], 0.014, "rubber", 6)
    for k in range(52):
        flat = k % 2
        link = [(0.012 * math.cos(a) * flat, 0.012 * math.cos(a) * (1 - flat), 1.03 + 0.055 * k + 0.032 * math.sin(a))
                for a in (2 * math.pi * q / 6 for q in range(7))]
        made.tube(link, 0.006, "chrome", 4)
    mesh = made.mesh(stage, "hoist")
    for name, (y, z) in TRUSSES.items():
        for x in (-7.0, 0.9, 7.0):
            stage.add(f"hoist_{name}_{x:+.0f}", mesh, place(x, y, z))


def looms(stage):
    """Cable looms on the trusses, tied every metre, sagging in between, and a drop at one end."""
    made = MeshBuilder()
    for number, (y, z) in enumerate(TRUSSES.values()):
        for strand in range(3):
            path = []
            for i in range(129):
                x = -7.6 + 15.4 * i / 128
                sag = 0.035 * abs(math.sin(math.pi * x + strand)) * (1 + 0.4 * strand)
                path.append((x, y + 0.05 + 0.04 * strand, z + TRUSS_SIDE / 2 + 0.045 - sag))
            end = 7.9 + 0.04 * strand
            path += [(end, y + 0.05 + 0.04 * strand, z - 0.4), (end + 0.05, y + 0.1, z - 2.0), (end, y + 0.2, 1.25)]
            made.tube(path, 0.013, "rubber", 5)
    stage.add("cable_looms", made)


def sound(stage):
    """Line arrays left and right, subs on the floor."""
    box = MeshBuilder()
    corners = []
    for y, k in ((-0.24, 1.0), (0.24, 0.8)):
        corners += [(x * (k + 1) / 2, y, z * k) for x, z in ((-0.56, -0.16), (0.56, -0.16), (0.56, 0.16), (-0.56, 0.16))]
    faces = [[0, 1, 2, 3], [7, 6, 5, 4], [0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3], [3, 7, 4, 0]]
    box.add(corners, faces, "cabinet_paint", uv_scale=3)
    box.box((1.06, 0.012, 0.28), (0, -0.25, 0), "perforated_steel", 0.003, uv_scale=2)
    for x in (-0.57, 0.57):
        box.box((0.02, 0.3, 0.3), (x, 0, 0), "black_metal", 0.004)
    element = box.mesh(stage, "array_element")
    sub = MeshBuilder()
    backline.cabinet(sub, 1.3, 1.0, 0.58, front="perforated_steel", body="cabinet_paint")
    sub_mesh = sub.mesh(stage, "sub")
    bumper = MeshBuilder()
    bumper.box((1.2, 0.5, 0.08), (0, 0, 0.26), "black_metal", 0.01)
    bumper.cylinder((0, 0, 0.3), (0, 0, 3.2), 0.012, "chrome", 6)
    bumper_mesh = bumper.mesh(stage, "array_bumper")
    for side in (-1, 1):
        which = "left" if side < 0 else "right"
        y, z, angle = -0.7, 7.6, 0.04
        stage.add(f"array_{which}_bumper", bumper_mesh, place(side * 9.8, y, z, rz=-side * 0.1))
        for k in range(10):
            stage.add(f"array_{which}_{k}", element, place(side * 9.8, y, z, rz=-side * 0.1, rx=angle))
            z -= 0.335 * math.cos(angle)
            y += 0.335 * math.sin(angle)
            angle += 0.015 + 0.009 * k
        for k in range(2):
            for j in range(2):
                stage.add(f"sub_{which}_{k}{j}", sub_mesh, place(side * (10.2 + 1.4 * j), -0.6, 0.58 * k, rz=-side * 0.06))

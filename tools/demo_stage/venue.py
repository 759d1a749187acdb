# SPDX-License-Identifier: Apache-2.0
"""The house and the cloth: hall, deck, steps, cyclorama, curtains, crowd barrier."""
import math

from .layout import DECK_DEPTH, DECK_HALF_WIDTH, DECK_Z
from .mesh_builder import MeshBuilder, place

HALL_HALF_WIDTH, HALL_BACK, HALL_FRONT, HALL_HEIGHT = 16.0, -22.0, 12.5, 11.0


def build(stage):
    hall(stage)
    deck(stage)
    steps(stage)
    cyclorama(stage)
    curtains(stage)
    barrier(stage)


def hall(stage):
    w, back, front, top = HALL_HALF_WIDTH, HALL_BACK, HALL_FRONT, HALL_HEIGHT
    floor = MeshBuilder()
    floor.add([(-w, back, 0), (w, back, 0), (w, front, 0), (-w, front, 0)], [[0, 1, 2, 3]], "concrete", uv_scale=0.5)
    stage.add("hall_floor", floor)

    walls = MeshBuilder()
    corners = [(-w, front), (w, front), (w, back), (-w, back)]
    for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1]):
        walls.add([(x0, y0, 0), (x1, y1, 0), (x1, y1, top), (x0, y0, top)], [[0, 1, 2, 3]], "brick", uv_scale=0.7)
    for x in (-w + 0.4, w - 0.4):
        for y in range(-18, 13, 6):
            walls.box((0.8, 0.8, top), (x, y, top / 2), "brick", 0.03, uv_scale=0.7)
    stage.add("hall_walls", walls)

    roof = MeshBuilder()
    roof.add([(-w, back, top), (-w, front, top), (w, front, top), (w, back, top)], [[0, 1, 2, 3]], "roof_paint")
    for y in range(-21, 13, 3):
        roof.box((2 * w, 0.25, 0.5), (0, y, top - 0.3), "roof_paint")
        for x in range(-15, 15, 3):
            roof.cylinder((x, y, top - 0.8), (x + 1.5, y + 1.5, top - 0.4), 0.05, "roof_paint", 6)
    stage.add("hall_roof", roof)


def deck(stage):
    """Panels of 2 m x 1 m with a hairline gap, on legs, with a pleated skirt."""
    panel = MeshBuilder()
    panel.box((1.996, 0.997, 0.06), (0, 0, -0.03), "deck", 0.003, uv_scale=0.5)
    panel_mesh = panel.mesh(stage, "deck_panel")
    columns, rows = int(DECK_HALF_WIDTH), int(DECK_DEPTH)
    for i in range(columns):
        for j in range(rows):
            # every panel is the same mesh: turned half round now and then, so that scuffs do not repeat in rows
            turn = math.pi * ((i * 7 + j * 5 + i * j) % 2)
            stage.add(f"deck_{i}_{j}", panel_mesh, place(1 - DECK_HALF_WIDTH + 2 * i, 0.5 + j, DECK_Z, rz=turn))

    legs = MeshBuilder()
    for i in range(columns + 1):
        for j in range(6):
            x, y = 2 * i - DECK_HALF_WIDTH, 0.1 + j * 1.96
            legs.cylinder((x, y, 0), (x, y, DECK_Z - 0.06), 0.03, "truss_aluminium", 8)
    stage.add("deck_legs", legs)

    height = DECK_Z - 0.06

    def pleats(u, v):
        x = (u - 0.5) * 2 * DECK_HALF_WIDTH
        return x, 0.03 * math.sin(x * 22) * (1 - 0.3 * v) + 0.012 * math.sin(x * 59 + 1), v * height

    skirt = MeshBuilder()
    skirt.grid(640, 4, pleats, "serge_black", 18, 1.2)
    stage.add("deck_skirt", skirt, place(0, -0.06, 0))

    tape = MeshBuilder()
    tape.box((2 * DECK_HALF_WIDTH, 0.05, 0.003), (0, 0.08, DECK_Z + 0.0015), "tape_white")
    for x, y in ((0, 1.6), (-2.9, 1.9), (2.9, 1.9)):   # the marks where a singer stands
        tape.box((0.3, 0.045, 0.003), (x, y, DECK_Z + 0.0015), "tape_yellow", rotation=(0, 0, 0.7))
        tape.box((0.3, 0.045, 0.004), (x, y, DECK_Z + 0.0015), "tape_yellow", rotation=(0, 0, -0.87))
    stage.add("deck_tape", tape)


def steps(stage):
    flight = MeshBuilder()
    for i in range(5):
        flight.box((1.2, 0.3, 0.05), (0, 0.3 * i, 0.2 + 0.24 * i), "plywood", 0.005)
        flight.box((1.2, 0.02, 0.2), (0, 0.3 * i - 0.14, 0.1 + 0.24 * i), "riser_black")
    for x in (-0.6, 0.6):
        flight.tube([(x, -0.2, 0.1), (x, -0.2, 1.1), (x, 1.3, 2.3), (x, 1.3, 1.2)], 0.022, "black_metal", 10)
    mesh = flight.mesh(stage, "steps")
    for side, x in (("left", -DECK_HALF_WIDTH - 0.65), ("right", DECK_HALF_WIDTH + 0.65)):
        stage.add(f"steps_{side}", mesh, place(x, 3, 0))


def cyclorama(stage):
    """A stretched pale cloth, 14 m x 6.4 m, with a curved foot and a faint sag."""
    foot = 0.8

    def cloth(u, v):
        x, s = (u - 0.5) * 14.0, v * 6.4
        if s < foot:
            a = s / foot * math.pi / 2
            return x, 9.75 - 0.5 * math.cos(a), DECK_Z + 0.02 + 0.5 * (1 - math.cos(a))
        return x, 9.75 + 0.012 * math.sin(x * 3.1) * (v - 0.1), DECK_Z + 0.52 + (s - foot)

    made = MeshBuilder()
    made.grid(90, 48, cloth, "cyclorama", 14, 6.4)
    stage.add("cyclorama", made)


def curtains(stage):
    def leg(u, v):
        folds = 30 * (1 + 0.07 * math.sin(v * 3))
        depth = 0.085 * (0.55 + 0.45 * (1 - v))
        y = depth * math.sin(u * folds) + 0.02 * math.sin(u * folds * 2.3 + v * 2) + 0.03 * math.sin(u * 7 + v * 4)
        return u * 2.2 - 1.1 + 0.02 * math.sin(v * 5 + u * 20), y, v * 7.2

    legs = {}
    for material in ("velvet_red", "serge_black"):
        cloth = MeshBuilder()
        cloth.grid(120, 30, leg, material, 4, 7)
        legs[material] = cloth.mesh(stage, "leg_" + material)
    for i, (x, y) in enumerate(((9.3, 1.3), (8.6, 3.2), (8.1, 6.3), (7.9, 9.0))):
        mesh = legs["velvet_red" if i == 0 else "serge_black"]
        for side in (-1, 1):
            stage.add(f"leg_{i}_{'left' if side < 0 else 'right'}", mesh, place(side * x, y, DECK_Z, rz=side * 0.35))

    def border(u, v):
        y = 0.1 * math.sin(u * 280) * (1 - 0.5 * v) + 0.03 * math.sin(u * 87)
        return (u - 0.5) * 20.8, y, 1.5 * v + 0.12 * math.cos(u * 2 * math.pi * 11) * (1 - v)

    cloth = MeshBuilder()
    cloth.grid(760, 6, border, "velvet_red", 40, 1.5)
    stage.add("border", cloth, place(0, 1.3, 8.0))


def barrier(stage):
    metre = MeshBuilder()
    for x in (-0.49, 0.49):
        metre.tube([(x, 0, 0.02), (x, 0, 1.1)], 0.024, "truss_aluminium", 10)
    metre.tube([(-0.49, 0, 1.12), (0.49, 0, 1.12)], 0.03, "truss_aluminium", 12)
    metre.tube([(-0.49, 0, 0.1), (0.49, 0, 0.1)], 0.02, "truss_aluminium", 10)
    metre.tube([(0, 0, 1.0), (0, 0.5, 0.03)], 0.02, "truss_aluminium", 8)
    metre.box((0.98, 0.5, 0.01), (0, -0.3, 0.01), "truss_aluminium")
    for k in range(11):
        metre.cylinder((-0.4 + 0.08 * k, 0, 0.1), (-0.4 + 0.08 * k, 0, 1.1), 0.009, "truss_aluminium", 6)
    mesh = metre.mesh(stage, "barrier")
    for k in range(18):
        stage.add(f"barrier_{k:02d}", mesh, place(-8.5 + k, -1.9, 0))

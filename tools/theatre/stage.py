# SPDX-License-Identifier: Apache-2.0
"""The room, its cloths, the cyclorama, three actors and what they sit on. Metres, seen from the house: X right, Y up-stage, Z up."""
import math

from festival.glb import Glb, Shape, place

ROOM_X, ROOM_FRONT, ROOM_BACK, ROOM_Z = 8.5, -8.0, 9.0, 7.6
GRID_Z = 6.9
CYC_Y, CYC_HALF_WIDTH, CYC_HIGH = 7.6, 6.4, 6.5
PIPES_Y = (-4.0, 0.6, 2.6, 5.4)
DEMO_DECK_Z = 1.2

# name: (linear colour, roughness, metalness, seen from both sides)
MATERIALS = {
    "wall_black": ((0.03, 0.03, 0.031), 0.9, 0, False),
    "dance_floor": ((0.05, 0.05, 0.052), 0.4, 0, False),
    "cyc_white": ((0.82, 0.82, 0.81), 1.0, 0, True),
    "serge_black": ((0.01, 0.01, 0.012), 0.9, 0, True),
    "pipe_black": ((0.03, 0.03, 0.03), 0.5, 0.3, False),
    "sofa_white": ((0.72, 0.71, 0.68), 0.9, 0, False),
    "oak": ((0.32, 0.2, 0.11), 0.45, 0, False),
    "chair_red": ((0.5, 0.03, 0.03), 0.5, 0, False),
    "rake_carpet": ((0.05, 0.045, 0.045), 0.95, 0, False),
    "seat_grey": ((0.1, 0.1, 0.11), 0.9, 0, False),
    "hair_black": ((0.02, 0.014, 0.011), 0.5, 0, False),
    "hair_brown": ((0.08, 0.04, 0.018), 0.5, 0, False),
    "hair_fair": ((0.36, 0.24, 0.1), 0.5, 0, False),
    "skin_light": ((0.5, 0.31, 0.22), 0.5, 0, False),
    "skin_dark": ((0.18, 0.09, 0.055), 0.5, 0, False),
    "shoe": ((0.02, 0.02, 0.02), 0.35, 0, False),
    "trainer_white": ((0.6, 0.6, 0.58), 0.6, 0, False),
    "leather_black": ((0.026, 0.021, 0.018), 0.55, 0, False),
    "leather_brown": ((0.11, 0.05, 0.026), 0.55, 0, False),
    "denim": ((0.03, 0.05, 0.11), 0.85, 0, False),
    "trousers_dark": ((0.028, 0.028, 0.037), 0.85, 0, False),
    "jacket_red": ((0.36, 0.026, 0.026), 0.85, 0, False),
    "dress_green": ((0.018, 0.19, 0.1), 0.85, 0, False),
    "shirt_white": ((0.65, 0.64, 0.62), 0.85, 0, False),
    "shirt_black": ((0.02, 0.02, 0.022), 0.85, 0, False),
    "shirt_grey": ((0.14, 0.14, 0.16), 0.85, 0, False),
}
ACTORS = (("performer_singer", (0.9, 1.8), 0.2), ("performer_bassist", (-2.6, 3.4), -0.5), ("performer_guitarist", (3.3, 4.2), 0.7))


def build(scene, demo_stage):
    room(scene)
    cloths(scene)
    furniture(scene)
    rake(scene)
    demo = Glb(demo_stage.read_bytes())
    for name, (x, y), turn in ACTORS:
        mesh = next(demo.json["meshes"][node["mesh"]]["name"] for node in demo.json["nodes"] if node["name"] == name)
        scene.add(name.replace("performer", "actor"), scene.borrow(demo, mesh), place(x, y, 0, turn))


def room(scene):
    x, thick = ROOM_X, 0.2
    scene.add("floor", Shape().box("dance_floor", (-x, ROOM_FRONT, -thick), (x, ROOM_BACK, 0)))
    scene.add("ceiling", Shape().box("wall_black", (-x, ROOM_FRONT, ROOM_Z), (x, ROOM_BACK, ROOM_Z + thick)))
    walls = Shape()
    for side in (-1, 1):
        walls.box("wall_black", (min(side * x, side * (x + thick)), ROOM_FRONT, 0), (max(side * x, side * (x + thick)), ROOM_BACK, ROOM_Z))
    walls.box("wall_black", (-x, ROOM_BACK, 0), (x, ROOM_BACK + thick, ROOM_Z)).box("wall_black", (-x, ROOM_FRONT - thick, 0), (x, ROOM_FRONT, ROOM_Z))
    scene.add("walls", walls)
    grid = Shape()
    for y in PIPES_Y:
        grid.rod("pipe_black", (-6.2, y, GRID_Z), (6.2, y, GRID_Z), 0.03, 8)
    scene.add("grid", grid)


def cloths(scene):
    def cyclorama(u, v):
        """Hangs straight, its foot turned forward in a quarter circle of 0.8 m."""
        along = v * (CYC_HIGH + 0.46)
        bend = 0.8 * math.pi / 2
        if along < bend:
            a = along / 0.8
            return (2 * u - 1) * CYC_HALF_WIDTH, CYC_Y - 0.8 + 0.8 * math.sin(a), 0.01 + 0.8 * (1 - math.cos(a))
        return (2 * u - 1) * CYC_HALF_WIDTH, CYC_Y, 0.81 + along - bend

    scene.add("cyclorama", Shape().sheet("cyc_white", 8, 24, cyclorama))
    for number, y in enumerate((1.2, 3.3, 5.4)):
        for side in (-1, 1):
            scene.add(f"leg_{number}_{side}", Shape().sheet("serge_black", 24, 1, lambda u, v, y=y, s=side: (
                s * (5.0 + 1.5 * (u if s > 0 else 1 - u)), y + 0.05 * math.sin(40 * u), v * 6.6)))
    for number, y in enumerate((1.0, 3.1, 5.2)):
        scene.add(f"border_{number}", Shape().sheet("serge_black", 60, 1, lambda u, v, y=y: (
            6.6 * (2 * u - 1), y + 0.04 * math.sin(150 * u), 5.9 + 1.0 * v)))
    scene.add("ground_row", Shape().box("pipe_black", (-5.6, 5.25, 0), (5.6, 5.29, 0.75)))


def furniture(scene):
    sofa = Shape().box("sofa_white", (-1.0, -0.42, 0.12), (1.0, 0.42, 0.44)).box("sofa_white", (-1.0, 0.24, 0.44), (1.0, 0.42, 0.86))
    for side in (-1, 1):
        sofa.box("sofa_white", (min(side, side * 0.82), -0.42, 0.44), (max(side, side * 0.82), 0.42, 0.64))
    scene.add("sofa", sofa, place(-1.3, 2.3, 0, 0.25))
    table = Shape().box("oak", (-0.7, -0.4, 0.71), (0.7, 0.4, 0.75))
    for x in (-0.64, 0.64):
        for y in (-0.34, 0.34):
            table.box("oak", (x - 0.03, y - 0.03, 0), (x + 0.03, y + 0.03, 0.71))
    scene.add("table", table, place(2.5, 2.7, 0, -0.2))
    chair = Shape().box("chair_red", (-0.22, -0.22, 0.43), (0.22, 0.22, 0.46)).box("chair_red", (-0.22, 0.2, 0.46), (0.22, 0.23, 0.9))
    for x in (-0.19, 0.19):
        for y in (-0.19, 0.19):
            chair.rod("chair_red", (x, y, 0), (x, y, 0.43), 0.017, 6)
    scene.add("chair", chair, place(2.2, 1.9, 0, 2.6))


def rake(scene):
    steps, seats = Shape(), Shape()
    for row in range(4):
        front, high = -3.6 - 1.0 * row, 0.25 * (row + 1)
        steps.box("rake_carpet", (-6.5, front - 1.0, 0), (6.5, front, high))
        for k in range(20):
            x = -5.7 + 0.6 * k
            seats.box("seat_grey", (x - 0.24, front - 0.75, high + 0.38), (x + 0.24, front - 0.3, high + 0.46))
            seats.box("seat_grey", (x - 0.24, front - 0.8, high + 0.46), (x + 0.24, front - 0.72, high + 0.9))
    scene.add("rake", steps)
    scene.add("seats", seats)

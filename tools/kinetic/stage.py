# SPDX-License-Identifier: Apache-2.0
"""The objects and lamps of the kinetic stage, and its show file with movers, or without and everything in its place."""
import math

from festival import glb
from kinetic import places

MATERIALS = {
    "stage_floor": ((0.13, 0.12, 0.115), 0.55, 0, False),
    "wall": ((0.24, 0.24, 0.25), 0.9, 0, False),
    "truss_aluminium": ((0.45, 0.46, 0.48), 0.45, 0.4, False),
    "deck": ((0.2, 0.15, 0.1), 0.6, 0, False),
    "flat": ((0.5, 0.47, 0.42), 0.85, 0, False),
    "black_metal": ((0.03, 0.03, 0.032), 0.45, 0.3, False),
}
SPOT, WASH = ("Vari-Lite@VL2500_Spot.gdtf", "Standard 22 channels", 22), ("Vari-Lite@VL2500_Wash.gdtf", "Standard 15 channels", 15)


def truss_shape():
    """A box truss of 12 m along X, its lower chords at Z = 0."""
    shape, side = glb.Shape(), 0.2
    corners = [(y, z) for y in (-side, side) for z in (0.0, 2 * side)]
    for y, z in corners:
        shape.rod("truss_aluminium", (-6, y, z), (6, y, z), 0.025, 8)
    around = [corners[0], corners[1], corners[3], corners[2]]
    for bay in range(24):
        x, further = -6 + bay / 2, -5.5 + bay / 2
        for (y, z), (v, w) in zip(around, around[1:] + around[:1]):
            shape.rod("truss_aluminium", (x, y, z), (further, v, w), 0.012, 5)
            shape.rod("truss_aluminium", (x, y, z), (x, v, w), 0.012, 5)
    return shape


def objects():
    """(name, shape in the world, mover)"""
    x, y, z = places.TRUSS
    truss = truss_shape()
    for positions, _, _ in truss.parts.values():   # glTF: Y up
        for k in range(0, len(positions), 3):
            positions[k] += x
            positions[k + 1] += z
            positions[k + 2] -= y
    rx, ry, _ = places.REVOLVE
    wx, wy = places.PATH[0]
    return [
        ("Floor", glb.Shape().box("stage_floor", (-11, -6, -0.1), (11, 8, 0)), None),
        ("Back wall", glb.Shape().box("wall", (-11, 8, 0), (11, 8.2, 9)), None),
        ("Truss", truss, "Truss"),
        ("Revolve disc", glb.Shape().rod("deck", (rx, ry, 0.0), (rx, ry, 0.2), 3.0, 64, None, True), "Revolve"),
        ("Revolve flat", glb.Shape().box("flat", (rx - 2.2, ry + 0.5, 0.2), (rx + 0.6, ry + 0.6, 1.8)), "Revolve"),
        ("Revolve column", glb.Shape().rod("flat", (rx + 1.6, ry - 1, 0.2), (rx + 1.6, ry - 1, 1.7), 0.25, 24, None, True), "Revolve"),
        ("Lift deck", glb.Shape().box("deck", (4.6, 1, 0.0), (7.0, 3.4, 0.25)), "Lift"),
        ("Lift column", glb.Shape().rod("flat", (5.8, 2.2, 0.25), (5.8, 2.2, 1.5), 0.22, 24, None, True), "Lift"),
        ("Wagon deck", glb.Shape().box("deck", (wx - 0.9, wy - 0.6, 0.1), (wx + 0.9, wy + 0.6, 0.35)), "Wagon"),
        ("Wagon flat", glb.Shape().box("flat", (wx - 0.8, wy - 0.05, 0.35), (wx + 0.8, wy + 0.05, 1.5)), "Wagon"),
    ]


def write_stage(path, values):
    scene = glb.Scene(MATERIALS)
    for name, shape, mover in objects():
        matrix = places.place_of(mover, values)
        scene.add(name, shape, None if matrix == places.IDENTITY else tuple(tuple(row) for row in matrix[:3]))
    path.write_bytes(scene.data())


class Lamp:
    def __init__(self, name, kind, position, mover, stands=False, pan=0.0, tilt=0.0, level=1.0, colour=(1, 1, 1), wide=0.3):
        self.name, self.kind, self.position, self.mover, self.stands = name, kind, position, mover, stands
        self.pan, self.tilt, self.level, self.colour, self.wide = pan, tilt, level, colour, wide
        self.universe = self.address = 0

    def levels(self):
        def fine(share):
            value = round(max(0.0, min(1.0, share)) * 65535)
            return [value >> 8, value & 255]
        red, green, blue = (round(255 * (1 - part)) for part in self.colour)
        head = [round(255 * self.level), *fine(self.pan / 540 + 0.5), *fine(self.tilt / 270 + 0.5), red, blue, green, 0]
        if self.kind is WASH:
            return head + [round(255 * self.wide), 0, 0, 0, 0, 0]
        return head + [150, 0, round(255 * self.wide), 0, 0, 0, 0, 255, 0, 0, 0, 0, 0]


def lamps(on_truss):
    x, y, z = places.TRUSS
    wx, wy = places.PATH[0]
    result = []
    for k in range(on_truss):
        share = (k + 0.5) / on_truss
        warm = k % 2 == 0
        result.append(Lamp(f"Truss {k + 1}", SPOT if warm else WASH, (x - 5.6 + 11.2 * share, y, z - 0.03), "Truss", tilt=18 * math.sin(3 * k),
                           pan=25 * math.cos(k), colour=(1, 0.75, 0.4) if warm else (0.35, 0.55, 1), level=0.8 if warm else 0.5))
    for k, at in enumerate((-7.0, -2.5, 2.5, 7.0)):   # from the floor up through the truss
        result.append(Lamp(f"Floor {k + 1}", SPOT, (at, 6.5, 0.02), None, stands=True, tilt=46, colour=(0.5, 1, 0.7) if k % 2 else (1, 0.35, 0.5), wide=0.1))
    result += [
        Lamp("Pendant", SPOT, (x, y + 0.9, z - 0.6), "Winch", colour=(1, 1, 0.9), wide=0.6),
        Lamp("Revolve 1", SPOT, (-1.2, 1.2, 0.2), "Revolve", stands=True, tilt=-60, pan=40, colour=(0.5, 0.8, 1), wide=0.2),
        Lamp("Lift 1", WASH, (6.5, 2.9, 0.25), "Lift", stands=True, tilt=-50, pan=60, colour=(1, 0.5, 0.2)),
        Lamp("Wagon 1", SPOT, (wx - 0.6, wy + 0.35, 0.35), "Wagon", stands=True, tilt=-55, pan=-20, colour=(0.8, 0.6, 1), wide=0.2),
    ]
    universe, address = 1, 1
    for lamp in result:
        if address + lamp.kind[2] > 513:
            universe, address = universe + 1, 1
        lamp.universe, lamp.address = universe, address
        address += lamp.kind[2]
    return result


MOVER_UNIVERSE = 9
CAMERAS = """
[[camera]]
name = "house"
position_m = [0.0, -15.0, 4.2]
target_m = [0.0, 2.0, 3.0]
fov_y_deg = 34.0
size = [1280, 720]
ev100 = 4.5

[[camera]] # on the wagon
name = "rider"
position_m = [-7.5, -3.9, 1.9]
target_m = [0.0, 1.5, 2.5]
fov_y_deg = 60.0
size = [1280, 720]
ev100 = 4.5
"""

MOVERS = """
[[mover]] # on two hoists, which tilt it
name = "Truss"
kind = "hoists"
objects = ["Truss"]
fixtures = ["Truss *"]

[[mover.axis]]
name = "left"
point_m = [-5.0, 2.0, 6.0]
range_m = [0.0, -4.0]
universe = 9
address = 1
speed_m_s = 0.8
acceleration_m_s2 = 0.8

[[mover.axis]]
name = "right"
point_m = [5.0, 2.0, 6.0]
range_m = [0.0, -4.0]
universe = 9
address = 3
speed_m_s = 0.8
acceleration_m_s2 = 0.8

[[mover]] # a winch with a lamp, on the truss
name = "Winch"
kind = "linear"
parent = "Truss"
direction = [0.0, 0.0, -1.0]
fixtures = ["Pendant"]

[[mover.axis]]
range_m = [0.0, 2.0]
universe = 9
address = 5
speed_m_s = 1.0
acceleration_m_s2 = 1.0

[[mover]]
name = "Revolve"
kind = "revolve"
centre_m = [0.0, 2.0, 0.0]
objects = ["Revolve *"]
fixtures = ["Revolve 1"]

[[mover.axis]]
range_deg = [0.0, 360.0]
universe = 9
address = 7
bits = 24
speed_deg_s = 40.0
acceleration_deg_s2 = 20.0

[[mover]]
name = "Lift"
kind = "linear"
objects = ["Lift *"]
fixtures = ["Lift 1"]

[[mover.axis]]
range_m = [0.0, 2.5]
universe = 9
address = 10
speed_m_s = 0.6
acceleration_m_s2 = 0.6

[[mover]]
name = "Wagon"
kind = "path"
path_m = [[-7.5, -3.0, 0.0], [-3.5, -3.0, 0.0], [-1.5, -4.0, 0.0], [4.5, -4.0, 0.0]]
wheelbase_m = 1.2
objects = ["Wagon *"]
fixtures = ["Wagon 1"]
cameras = ["rider"]

[[mover.axis]]
range_m = [0.0, 12.0]
universe = 9
address = 12
speed_m_s = 1.2
acceleration_m_s2 = 0.8
"""


def show_text(rig, fixtures_folder, values, moves, motion="machine"):
    text = "# SPDX-License-Identifier: Apache-2.0\n# Made by tools/make_kinetic.py. What every key means: docs/reference/show-file.md.\n\n"
    text += f'[show]\nname = "Kinetic"\nstage = "stage.glb"\nrecording = "kinetic.show"\nmotion = "{motion}"\nambient_lux = 2.0\n\n'
    text += "[haze]\nextinction_per_m = 0.03\n" + CAMERAS
    if moves:
        text += MOVERS
    for lamp in rig:
        upright = places.about((0, 0, 0), "x", 180) if lamp.stands else places.IDENTITY
        matrix = places.times(places.IDENTITY if moves else places.place_of(lamp.mover, values), places.times(places.moved(*lamp.position), upright))
        where = ", ".join(f"{matrix[k][3]:.6f}" for k in range(3))
        turn = ", ".join(f"{round(angle, 6) + 0.0:.6f}" for angle in places.angles_of(matrix))
        text += f'\n[[fixture]]\nname = "{lamp.name}"\ngdtf = "{fixtures_folder}/{lamp.kind[0]}"\nmode = "{lamp.kind[1]}"\n'
        text += f"universe = {lamp.universe}\naddress = {lamp.address}\nposition_m = [{where}]\nrotation_deg = [{turn}]\n"
    return text


def mover_levels(values):
    def wide(share, count):
        value = round(max(0.0, min(1.0, share)) * (256 ** count - 1))
        return [value >> 8 * (count - 1 - k) & 255 for k in range(count)]
    left, right = values.get("Truss", (0, 0))
    one = {name: values.get(name, (0,))[0] for name in ("Winch", "Revolve", "Lift", "Wagon")}
    return [*wide(left / -4, 2), *wide(right / -4, 2), *wide(one["Winch"] / 2, 2), *wide(one["Revolve"] / 360, 3),
            *wide(one["Lift"] / 2.5, 2), *wide(one["Wagon"] / 12, 2)]


def write_recording(path, rig, moments):
    """moments: (seconds, values of the movers), ascending."""
    lines = ["OLA Show"]
    for universe in sorted({lamp.universe for lamp in rig}):
        levels = [level for lamp in rig if lamp.universe == universe for level in lamp.levels()]
        lines += [f"{universe} " + ",".join(map(str, levels)), "0"]
    for k, (at_s, values) in enumerate(moments):
        pause_s = moments[k + 1][0] - at_s if k + 1 < len(moments) else 1.0
        lines += [f"{MOVER_UNIVERSE} " + ",".join(map(str, mover_levels(values))), str(round(1000 * pause_s))]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")

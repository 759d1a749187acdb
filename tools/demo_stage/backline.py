# SPDX-License-Identifier: Apache-2.0
"""Risers, drum kit, amplifiers, keyboards, guitars, monitors, microphones, cases, cables."""
import math
import random

from mathutils import Matrix, Vector

from .layout import DECK_Z
from .mesh_builder import IDENTITY, MeshBuilder, circle, place

DRUM_RISER_Z = DECK_Z + 0.415
SIDE_RISER_Z = DECK_Z + 0.3


def build(stage):
    risers(stage)
    drum_kit(stage)
    amplifiers(stage)
    keyboards(stage)
    monitors(stage)
    microphones(stage)
    cases(stage)
    spare_guitars(stage)
    small_things(stage)
    cables(stage)


def risers(stage):
    drums = MeshBuilder()
    drums.box((3.2, 2.8, 0.4), (0, 0, 0.2), "riser_black", 0.01)
    drums.box((3.16, 2.76, 0.012), (0, 0, 0.406), "riser_carpet")
    rug = [(-1.4, -1.2, 0.414), (1.4, -1.2, 0.414), (1.4, 1.2, 0.414), (-1.4, 1.2, 0.414)]
    drums.add(rug, [[0, 1, 2, 3]], "carpet", uvs=[[(0, 0), (1, 0), (1, 1), (0, 1)]])
    stage.add("riser_drums", drums, place(0, 6.7, DECK_Z))
    side = MeshBuilder()
    side.box((2.8, 2.0, 0.3), (0, 0, 0.15), "riser_black", 0.01)
    side.box((2.76, 1.96, 0.01), (0, 0, 0.301), "riser_carpet")
    mesh = side.mesh(stage, "riser_side")
    stage.add("riser_keys", mesh, place(4.3, 6.2, DECK_Z - 0.006))
    stage.add("riser_voices", mesh, place(-4.6, 6.4, DECK_Z - 0.006))


def drum(made, matrix, radius, depth, shell, mark=False):
    made.lathe([(radius, 0), (radius, depth)], shell, 40, matrix)
    r, h = radius, depth
    made.lathe([(r + 0.012, h - 0.03), (r + 0.018, h - 0.03), (r + 0.018, h + 0.012), (r, h + 0.012), (r - 0.006, h + 0.004)],
               "chrome", 40, matrix)
    made.lathe([(r - 0.006, -0.004), (r, -0.012), (r + 0.018, -0.012), (r + 0.018, 0.03), (r + 0.012, 0.03)], "chrome", 40, matrix)
    made.disc(r - 0.002, h, "kick_head" if mark else "drum_skin", 40, matrix)
    made.disc(r - 0.002, 0, "drum_skin", 40, matrix, down=True)
    for i in range(8):
        a = 2 * math.pi * (i + 0.5) / 8
        x, y = (r + 0.012) * math.cos(a), (r + 0.012) * math.sin(a)
        made.box((0.03, 0.022, 0.07), (x, y, h * 0.5), "chrome", 0.006, rotation=(0, 0, a), matrix=matrix)
        made.cylinder((x * 1.01, y * 1.01, 0), (x * 1.01, y * 1.01, h), 0.004, "chrome", 6, matrix=matrix)


def tripod(made, x, y, turn, reach=0.28):
    for k in range(3):
        a = 2 * math.pi * k / 3 + turn
        c, s = math.cos(a), math.sin(a)
        knee, toe = 0.45 * reach, reach
        made.tube([(x, y, 0.42), (x + knee * c, y + knee * s, 0.24), (x + toe * c, y + toe * s, 0.012)], 0.009, "chrome", 7)


def cymbal(made, x, y, z, radius, tilt=0.25, turn=0.0):
    matrix = place(x, y, z, rz=turn, rx=tilt)
    bow = [(0, 0.034), (0.02, 0.033), (0.035, 0.026), (0.05, 0.016)]
    for i in range(10):
        t = (i + 1) / 10
        bow.append((0.05 + (radius - 0.05) * t, 0.014 - 0.026 * t * t + 0.0012 * math.sin(t * 40)))
    under = [(r, h - 0.0016) for r, h in bow[::-1]]
    made.lathe((bow + under)[::-1], "brass", 40, matrix)
    made.cylinder((x, y, 0.03), (x, y, z + 0.05), 0.011, "chrome", 10)
    made.cylinder((x, y, 0.1), (x, y, 0.45 * z + 0.2), 0.016, "chrome", 10)
    tripod(made, x, y, turn)


def drum_kit(stage):
    made = MeshBuilder()
    kick = place(0, -0.26, 0.305, rx=math.pi / 2) @ Matrix.Translation((0, 0, -0.46))
    drum(made, kick, 0.29, 0.46, "drum_lacquer", mark=True)
    drum(made, place(0.26, 0.5, 0.52, rx=-0.05), 0.178, 0.14, "chrome")                 # snare
    drum(made, place(-0.21, 0.0, 0.7, rx=0.4), 0.14, 0.2, "drum_lacquer")               # rack toms
    drum(made, place(0.21, 0.0, 0.7, rx=0.4), 0.15, 0.21, "drum_lacquer")
    drum(made, place(-0.58, 0.5, 0.2), 0.2, 0.4, "drum_lacquer")                        # floor toms
    drum(made, place(-0.95, 0.85, 0.18), 0.22, 0.42, "drum_lacquer")
    for x, y, z, radius, tilt, turn in ((0.66, 0.5, 0.88, 0.19, 0.05, 0), (0.66, -0.05, 1.22, 0.23, 0.3, 0.5),
                                        (-0.66, -0.05, 1.25, 0.24, 0.3, -0.5), (-1.1, 0.35, 1.05, 0.27, 0.22, -0.8),
                                        (1.05, 0.35, 1.3, 0.22, 0.35, 0.9)):
        cymbal(made, x, y, z, radius, tilt, turn)
    cymbal(made, 0.66, 0.5, 0.905, 0.19, 0.0, 0.0)                                      # upper hi-hat
    made.cylinder((0, 1.0, 0), (0, 1.0, 0.48), 0.025, "chrome", 10)                     # throne
    made.lathe([(0, 0.48), (0.16, 0.48), (0.175, 0.5), (0.175, 0.54), (0.15, 0.56), (0, 0.56)], "leather_black", 28, place(0, 1.0, 0))
    for k in range(3):
        a = 2.1 * k
        made.cylinder((0, 1.0, 0.2), (0.25 * math.cos(a), 1.0 + 0.25 * math.sin(a), 0.01), 0.012, "chrome", 8)
    for x, y, r in ((-0.58, 0.5, 0.2), (-0.95, 0.85, 0.22)):
        for k in range(3):
            a = 2.1 * k
            leg = (x + (r + 0.02) * math.cos(a), y + (r + 0.02) * math.sin(a))
            made.cylinder((*leg, 0), (*leg, 0.5), 0.008, "chrome", 8)
    for x in (-0.27, 0.27):                                                             # kick spurs
        made.cylinder((x, -0.1, 0.25), (x * 1.5, -0.25, 0.0), 0.009, "chrome", 8)
    stage.add("drum_kit", made, place(0, 6.3, DRUM_RISER_Z))


def cabinet(made, width, depth, height, matrix=IDENTITY, body="tolex_black", front="grille_black"):
    made.box((width, depth, height), (0, 0, height / 2), body, 0.018, 3, matrix=matrix, uv_scale=3)
    made.box((width - 0.08, 0.02, height - 0.1), (0, -depth / 2 - 0.004, height / 2), front, 0.004, matrix=matrix, uv_scale=2)
    for x in (-width / 2, width / 2):
        out = x * 1.0 + (0.03 if x > 0 else -0.03)
        made.tube([(x, -0.06, height * 0.6), (out, -0.05, height * 0.6), (out, 0.05, height * 0.6), (x, 0.06, height * 0.6)],
                  0.009, "black_metal", 6, matrix)
        for y in (-depth / 2 + 0.02, depth / 2 - 0.02):
            for z in (0.02, height - 0.02):
                inner = x - 0.02 * (1 if x > 0 else -1)
                made.box((0.05, 0.05, 0.05), (inner, y, z), "black_metal", 0.012, 1, matrix=matrix)


def amp_head(made, width, depth, height, matrix, panel="brass"):
    made.box((width, depth, height), (0, 0, height / 2), "tolex_black", 0.018, 3, matrix=matrix, uv_scale=3)
    made.box((width - 0.1, 0.02, height * 0.42), (0, -depth / 2, height * 0.35), panel, 0.003, matrix=matrix)
    for k in range(9):
        x = width * (0.09 * k - 0.36)
        knob = [(x, -depth / 2 - out, height * 0.35) for out in (0.01, 0.035)]
        made.cylinder(*knob, 0.012, "black_plastic", 12, matrix=matrix)


def amplifiers(stage):
    stack = MeshBuilder()
    cabinet(stack, 0.76, 0.36, 0.76)
    cabinet(stack, 0.76, 0.36, 0.76, place(0, 0, 0.77))
    amp_head(stack, 0.74, 0.28, 0.26, place(0, 0, 1.54))
    mesh = stack.mesh(stage, "guitar_stack")
    for i, (x, y, turn) in enumerate(((-2.45, 5.3, -0.1), (-3.25, 5.15, -0.16), (2.45, 5.35, 0.1))):
        stage.add(f"guitar_stack_{i}", mesh, place(x, y, DECK_Z, rz=turn))
    bass = MeshBuilder()
    cabinet(bass, 0.68, 0.42, 1.2, front="grille_silver")
    amp_head(bass, 0.62, 0.32, 0.18, place(0, 0, 1.21), "truss_aluminium")
    stage.add("bass_stack", bass, place(3.25, 5.2, DECK_Z, rz=0.18))
    combo = MeshBuilder()
    cabinet(combo, 0.66, 0.28, 0.5, body="tolex_cream")
    stage.add("combo", combo, place(-1.75, 4.9, DECK_Z, rz=-0.05))


def keyboards(stage):
    made = MeshBuilder()
    made.box((1.35, 0.36, 0.12), (0, 0, 0.95), "black_plastic", 0.015, 2)
    for k in range(52):
        x = -0.6 + 0.0233 * k
        made.box((0.0215, 0.15, 0.02), (x, 0.09, 1.015), "key_white", 0.002)
        if k % 7 in (0, 1, 3, 4, 5):
            made.box((0.012, 0.095, 0.016), (x + 0.012, 0.065, 1.032), "key_black", 0.002)
    for k in range(14):
        made.cylinder((-0.5 + 0.075 * k, -0.08, 1.01), (-0.5 + 0.075 * k, -0.08, 1.035), 0.012, "black_metal", 10)
    made.box((0.95, 0.3, 0.09), (-0.05, -0.12, 1.2), "drum_lacquer", 0.015, 2, (-0.25, 0, 0))
    for k in range(36):
        made.box((0.0215, 0.12, 0.018), (-0.45 + 0.0233 * k, -0.04, 1.225), "key_white", 0.002, 1, (-0.25, 0, 0))
    for side in (-1, 1):
        made.tube([(-0.55 * side, 0.15 * side, 0.02), (0.55 * side, 0.15 * side, 0.9)], 0.018, "black_metal", 8)
        made.tube([(side * 0.5, -0.3, 0.02), (side * 0.5, 0.3, 0.02)], 0.018, "black_metal", 8)
        made.cylinder((side * 0.42, -0.2, 0.9), (side * 0.42, -0.2, 1.18), 0.014, "black_metal", 8)
    stage.add("keyboards", made, place(4.3, 5.9, SIDE_RISER_Z, rz=0.2))


def guitar_mesh(stage, name, finish, neck=0.62):
    """x along the neck from the middle of the body, z across, the strings at -y."""
    made = MeshBuilder()
    outline = []
    for k in range(48):
        a = 2 * math.pi * k / 48
        r = 0.16 + 0.035 * math.cos(2 * a) + 0.02 * math.cos(3 * a + 0.4)
        outline.append((1.35 * r * math.cos(a), r * math.sin(a)))
    made.prism(outline, 0.045, finish)
    made.prism([(0.62 * x + 0.0, 0.55 * z - 0.035) for x, z in outline], 0.049, "black_plastic")
    middle, top = 0.81 * neck, 1.31 * neck
    made.box((neck, 0.022, 0.05), (middle, -0.014, 0), "maple", 0.006, uv_scale=2)
    made.box((neck, 0.006, 0.046), (middle, -0.028, 0), "leather_brown", 0.001)
    made.box((0.17, 0.018, 0.085), (top + 0.07, -0.01, 0), finish, 0.006)
    made.box((0.09, 0.014, 0.085), (-0.08, -0.028, 0), "chrome", 0.004)
    for i in range(2):
        made.box((0.035, 0.014, 0.08), (0.01 + 0.07 * i, -0.028, 0), "chrome", 0.003)
    for i in range(6):
        made.cylinder((-0.09, -0.037, -0.02 + 0.008 * i), (top, -0.034, -0.018 + 0.0072 * i), 0.0012, "chrome", 3, caps=False)
        peg = 1 if i % 2 else -1
        x = top + 0.02 + 0.022 * i
        made.cylinder((x, -0.02, 0.045 * peg), (x, -0.02, 0.065 * peg), 0.008, "chrome", 6)
    return made.mesh(stage, name)


def spare_guitars(stage):
    """Two on stands by the amplifiers."""
    stand = MeshBuilder()
    for x in (-0.16, 0.16):
        stand.tube([(0, 0.12, 0.75), (x, -0.02, 0.25), (x, -0.1, 0.02)], 0.009, "black_metal", 6)
    stand.tube([(0, 0.12, 0.75), (0, 0.3, 0.02)], 0.009, "black_metal", 6)
    for x in (-0.09, 0.09):
        stand.tube([(x, 0.06, 0.28), (x, -0.1, 0.26)], 0.009, "rubber", 6)
    stand_mesh = stand.mesh(stage, "guitar_stand")
    upright = place(0, -0.03, 0.5, rx=-0.16) @ place(0, 0, 0, ry=-math.pi / 2)
    for i, (x, y, turn, finish) in enumerate(((-4.3, 4.6, -0.3, "bass_blue"), (4.25, 4.55, 0.35, "guitar_sunburst"))):
        at = place(x, y, DECK_Z, rz=turn)
        stage.add(f"guitar_stand_{i}", stand_mesh, at)
        stage.add(f"spare_guitar_{i}", guitar_mesh(stage, f"spare_guitar_{i}", finish), at @ upright)


def monitors(stage):
    made = MeshBuilder()
    profile = [(-0.2, 0), (0.25, 0), (0.25, 0.12), (0.02, 0.38), (-0.2, 0.38)]
    points = [(x, y, z) for x in (-0.3, 0.3) for y, z in profile]
    faces = [[4, 3, 2, 1, 0], [5, 6, 7, 8, 9]] + [[i, (i + 1) % 5, 5 + (i + 1) % 5, 5 + i] for i in range(5)]
    made.add(points, faces, "cabinet_paint", uv_scale=3)
    made.box((0.54, 0.34, 0.012), (0, 0.138, 0.255), "perforated_steel", 0.003, 1, (-0.8488, 0, 0), uv_scale=2)
    mesh = made.mesh(stage, "wedge")
    places = ((-0.85, 0.75, 0.12), (0.85, 0.75, -0.12), (-3.3, 0.85, 0.25), (3.3, 0.85, -0.25), (-5.9, 1.2, 0.5), (5.9, 1.2, -0.5))
    for i, (x, y, turn) in enumerate(places):
        stage.add(f"wedge_{i}", mesh, place(x, y, DECK_Z, rz=turn))
    fill = MeshBuilder()   # side fills, turned to the middle
    cabinet(fill, 0.7, 0.6, 0.6, front="perforated_steel", body="cabinet_paint")
    cabinet(fill, 0.7, 0.55, 0.85, place(0, 0, 0.61), front="perforated_steel", body="cabinet_paint")
    fill_mesh = fill.mesh(stage, "side_fill")
    for side in (-1, 1):
        stage.add(f"side_fill_{'left' if side < 0 else 'right'}", fill_mesh, place(side * 7.3, 2.0, DECK_Z, rz=side * 1.25))


def microphone(made, tip, direction):
    tip, direction = Vector(tip), Vector(direction).normalized()
    made.cylinder(tip - direction * 0.02, tip + direction * 0.15, 0.012, "black_metal", 14, 0.017)
    made.sphere(tip + direction * 0.18, 0.026, "perforated_steel", 16, 10)


def microphone_stand(boom, height):
    made = MeshBuilder()
    made.lathe([(0, 0), (0.15, 0), (0.15, 0.012), (0.03, 0.03), (0.014, 0.05)], "black_metal", 28)
    made.cylinder((0, 0, 0.04), (0, 0, height - 0.1), 0.011, "chrome", 10)
    made.cylinder((0, 0, height * 0.5), (0, 0, height * 0.62), 0.018, "black_metal", 10)
    if boom:
        made.tube([(0, -0.12, height - 0.14), (0, 0, height - 0.1), (0, 0.32, height + 0.02)], 0.008, "black_metal", 8)
        microphone(made, (0, 0.32, height + 0.02), (0, 0.85, -0.1))
    else:
        made.tube([(0, 0, height - 0.1), (0, 0, height)], 0.008, "black_metal", 8)
        microphone(made, (0, 0, height), (0, 0.6, 0.5))
    return made


def microphones(stage):
    stage.add("mic_lead", microphone_stand(False, 1.45), place(0.45, 1.55, DECK_Z, rz=0.2))
    vocal = microphone_stand(True, 1.5).mesh(stage, "mic_boom")
    for i, (x, y, z, turn) in enumerate(((-2.95, 1.72, DECK_Z, 0.1), (2.95, 1.77, DECK_Z, -0.1), (-5.05, 5.75, SIDE_RISER_Z, 0),
                                         (-4.15, 5.75, SIDE_RISER_Z, 0))):
        stage.add(f"mic_boom_{i}", vocal, place(x, y, z, rz=turn))
    low = microphone_stand(True, 0.55).mesh(stage, "mic_low")
    for i, (x, y, z, turn) in enumerate(((-2.2, 4.65, DECK_Z, 0.2), (2.3, 4.7, DECK_Z, -0.3), (-0.1, 5.45, DRUM_RISER_Z, 0.0),
                                         (3.05, 4.5, DECK_Z, 0.1))):
        stage.add(f"mic_low_{i}", low, place(x, y, z, rz=turn))
    tall = microphone_stand(True, 1.85).mesh(stage, "mic_overhead")
    for i, (x, turn) in enumerate(((-1.3, -0.9), (1.35, 0.9))):
        stage.add(f"mic_overhead_{i}", tall, place(x, 6.5, DRUM_RISER_Z, rz=turn))


def cases(stage):
    made = MeshBuilder()
    made.box((1.1, 0.6, 0.62), (0, 0, 0.47), "flight_case", 0.004, uv_scale=2)
    for x in (-1, 1):
        for y in (-1, 1):
            made.box((0.035, 0.035, 0.64), (x * 0.545, y * 0.295, 0.47), "truss_aluminium", 0.004)
            made.cylinder((x * 0.45, y * 0.2 - 0.02, 0.06), (x * 0.45, y * 0.2 + 0.02, 0.06), 0.06, "rubber", 14)
            made.box((0.1, 0.1, 0.06), (x * 0.45, y * 0.2, 0.13), "chrome", 0.01)
            for z in (0.17, 0.77):
                made.sphere((x * 0.545, y * 0.295, z), 0.035, "chrome", 10, 8)
        made.box((0.012, 0.2, 0.12), (x * 0.555, 0, 0.5), "black_metal", 0.004)
    for z in (0.165, 0.62, 0.775):
        for y in (-1, 1):
            made.box((1.1, 0.03, 0.03), (0, y * 0.295, z), "truss_aluminium", 0.003)
        for x in (-1, 1):
            made.box((0.03, 0.6, 0.03), (x * 0.545, 0, z), "truss_aluminium", 0.003)
    mesh = made.mesh(stage, "flight_case")
    places = ((-6.3, 7.6, 0, 0.1), (-6.2, 6.7, 0, -0.15), (6.5, 7.4, 0, 0.3), (6.4, 6.4, 0, 0.0), (-6.3, 7.6, 0.8, 0.15),
              (6.45, 4.2, 0, 1.5))
    for i, (x, y, z, turn) in enumerate(places):
        stage.add(f"flight_case_{i}", mesh, place(x, y, DECK_Z + z, rz=turn))


def small_things(stage):
    """Set lists, water, a towel's worth of clutter: what tells a played stage from a drawn one."""
    made = MeshBuilder()
    for x, y, turn in ((0.15, 1.2, 0.1), (-2.6, 1.35, -0.2), (2.6, 1.4, 0.3)):
        made.box((0.21, 0.297, 0.001), (x, y, DECK_Z + 0.004), "tape_white", rotation=(0, 0, turn))
    for x, y, z in ((0.42, 0.95, DECK_Z), (0.52, 1.0, DECK_Z), (-3.4, 5.15, DECK_Z + 1.8), (3.15, 5.2, DECK_Z + 1.39),
                    (0.62, 7.6, DRUM_RISER_Z)):
        made.lathe([(0.03, 0), (0.032, 0.01), (0.032, 0.15), (0.012, 0.19), (0.012, 0.215), (0, 0.215)], "bottle", 14, place(x, y, z))
    for x, y in ((-2.9, 1.2), (2.95, 1.25), (-2.45, 1.15)):   # effect pedals
        for k in range(3):
            at, finish = x + 0.1 * k - 0.1, ("hoist_yellow", "bass_blue", "drum_lacquer")[k]
            made.box((0.075, 0.125, 0.045), (at, y, DECK_Z + 0.023), finish, 0.006)
            made.cylinder((at, y - 0.03, DECK_Z + 0.045), (at, y - 0.03, DECK_Z + 0.06), 0.01, "chrome", 8)
    stage.add("clutter", made)


def cables(stage):
    dice = random.Random(5)
    made = MeshBuilder()
    for _ in range(18):
        x, y, heading = dice.uniform(-4.5, 4.5), dice.uniform(0.9, 5.0), dice.uniform(0, 2 * math.pi)
        path = []
        for _ in range(50):
            path.append((x, y, DECK_Z + 0.008))
            heading += dice.gauss(0, 0.3)
            x = min(max(x + 0.08 * math.cos(heading), -6.5), 6.5)
            y = min(max(y + 0.08 * math.sin(heading), 0.4), 5.1)
        made.tube(path, 0.006, "rubber", 5)
    stage.add("cables", made)

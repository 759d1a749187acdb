# SPDX-License-Identifier: Apache-2.0
"""The ground, the stage and its roof, trusses, LED wall, sound, delay towers."""
import math

from . import layout
from .glb import Shape, along_y, place, upright
from .layout import DECK_DEPTH, DECK_HALF_WIDTH, DECK_Z, EAVES_Z, LEG_X, RIDGE_Z

METAL, BLACK, CLOTH = "truss_aluminium", "black_metal", "serge_black"
ROOF_FRONT, ROOF_BACK = -1.4, 14.8


def build(scene, fixtures):
    segment = scene.mesh("truss_2m", truss_segment())
    ground(scene)
    deck(scene)
    roof(scene, segment)
    rig(scene, segment, fixtures)
    led_wall(scene, segment)
    wings(scene, segment)
    for k, (x, y) in enumerate(layout.DELAY_TOWERS):
        delay_tower(scene, segment, k, x, y)
    mixing_tower(scene, segment)


def truss_segment():
    """Two metres along X: four chords and their braces."""
    made, h = Shape(), 0.2
    for y in (-h, h):
        for z in (-h, h):
            made.rod(METAL, (-1, y, z), (1, y, z), 0.026, 6)
    for k in range(4):
        x, s = -1 + 0.5 * k, h if k % 2 else -h
        for side in (-h, h):
            made.rod(METAL, (x, side, s), (x + 0.5, side, -s), 0.011, 4)
            made.rod(METAL, (x, s, side), (x + 0.5, -s, side), 0.011, 4)
    return made


def row(scene, segment, name, x0, x1, y, z):
    count = max(1, round((x1 - x0) / 2))
    for k in range(count):
        scene.add(f"{name}_{k}", segment, place(x0 + (k + 0.5) * (x1 - x0) / count, y, z))


def column(scene, segment, name, x, y, z0, z1):
    count = max(1, round((z1 - z0) / 2))
    for k in range(count):
        scene.add(f"{name}_{k}", segment, upright(x, y, z0 + (k + 0.5) * (z1 - z0) / count))


def beam(scene, segment, name, x, y0, y1, z):
    count = max(1, round((y1 - y0) / 2))
    for k in range(count):
        scene.add(f"{name}_{k}", segment, along_y(x, y0 + (k + 0.5) * (y1 - y0) / count, z))


def ground(scene):
    def field(u, v):
        x, y = -90 + 180 * u, -110 + 170 * v
        return x, y, -0.06 * (1 + math.sin(0.31 * x + 1.3) * math.sin(0.23 * y)) * min(1.0, max(0.0, (-y - 30) / 20))

    scene.add("ground", Shape().sheet("trodden_grass", 60, 60, field))
    lane = Shape().box("aluminium_track", (-0.98, -0.5, 0), (0.98, 0.5, 0.02))
    mesh = scene.mesh("track_panel", lane)
    for i in range(-9, 9):
        for j in range(2):
            scene.add(f"track_{i}_{j}", mesh, place(2 * i + 1, -1.0 - j * 1.01, 0))
    metre = Shape()
    for x in (-0.49, 0.49):
        metre.rod(METAL, (x, 0, 0), (x, 0, 1.1), 0.024)
    metre.rod(METAL, (-0.5, 0, 1.12), (0.5, 0, 1.12), 0.03, 8)
    metre.box("perforated_steel", (-0.47, -0.01, 0.08), (0.47, 0.01, 1.08))
    metre.rod(METAL, (0, 0, 1.0), (0, 0.6, 0.02), 0.02)
    mesh = scene.mesh("barrier", metre)
    for k in range(36):
        scene.add(f"barrier_{k}", mesh, place(k - 17.5, -3.0, 0))


def deck(scene):
    panel = Shape().box("deck", (-0.997, -0.497, -0.06), (0.997, 0.497, 0))
    mesh = scene.mesh("deck_panel", panel)
    for i in range(int(DECK_HALF_WIDTH)):
        for j in range(int(DECK_DEPTH)):
            scene.add(f"deck_{i}_{j}", mesh, place(1 - DECK_HALF_WIDTH + 2 * i, 0.5 + j, DECK_Z))
    under = Shape()
    for x in range(-12, 13, 2):
        for y in (0.1, 4.7, 9.3, 13.9):
            under.rod(METAL, (x * 0.99, y, 0), (x * 0.99, y, DECK_Z - 0.06), 0.03)
    scene.add("deck_legs", under)

    def pleats(u, v):
        x = (u - 0.5) * 2 * DECK_HALF_WIDTH
        return x, -0.08 + 0.035 * math.sin(x * 16) * (1 - 0.3 * v), v * (DECK_Z - 0.06)

    scene.add("deck_skirt", Shape().sheet(CLOTH, 600, 2, pleats))
    platform = Shape().box("riser_black", (-6.2, 7.2, DECK_Z), (6.2, 10.6, DECK_Z + 0.7)).box(
        "riser_carpet", (-6.15, 7.25, DECK_Z + 0.7), (6.15, 10.55, DECK_Z + 0.712))
    for k in range(13):
        platform.box("panel_frame", (-6.15 + 0.95 * k, 7.14, DECK_Z + 0.08), (-5.25 + 0.95 * k, 7.2, DECK_Z + 0.62))
    scene.add("band_platform", platform)
    steps = Shape()
    for i in range(8):
        steps.box("riser_black", (-0.7, 0.3 * i - 0.15, 0.18 + 0.22 * i), (0.7, 0.3 * i + 0.15, 0.23 + 0.22 * i))
    for x in (-0.7, 0.7):
        steps.rod(BLACK, (x, -0.2, 0), (x, -0.2, 1.1), 0.022).rod(BLACK, (x, -0.2, 1.1), (x, 2.1, 2.8), 0.022)
    mesh = scene.mesh("steps", steps)
    for side in (-1, 1):
        scene.add(f"steps_{side}", mesh, place(side * 12.8, 4.4, 0))


def roof(scene, segment):
    for side in (-1, 1):
        for y in (-0.9, 6.8, 14.4):
            which = f"leg_{side}_{y:.0f}"
            column(scene, segment, which, side * LEG_X, y, 0.0, EAVES_Z)
            scene.add(which + "_foot", Shape().box(BLACK, (-0.8, -0.8, 0), (0.8, 0.8, 0.12)).box(
                "ballast", (-0.75, 0.3, 0.12), (0.75, 0.8, 0.9)), place(side * LEG_X, y, 0))
        beam(scene, segment, f"eaves_{side}", side * LEG_X, ROOF_FRONT, ROOF_BACK, EAVES_Z)
    # rafters: an arch of eight straight pieces, one a bay
    arch = Shape()
    for k in range(16):
        (x0, z0), (x1, z1) = arch_point(k / 16), arch_point((k + 1) / 16)
        for y in (-0.2, 0.2):
            for dz in (-0.2, 0.2):
                arch.rod(METAL, (x0, y, z0 + dz), (x1, y, z1 + dz), 0.03)
            arch.rod(METAL, (x0, y, z0 - 0.2), (x1, y, z1 + 0.2), 0.014, 4)
    mesh = scene.mesh("rafter", arch)
    for k, y in enumerate((ROOF_FRONT, 2.6, 6.7, 10.7, ROOF_BACK)):
        scene.add(f"rafter_{k}", mesh, place(0, y, 0))

    def skin(u, v):
        x, z = arch_point(1 - u)
        sag = 0.12 * math.sin(math.pi * ((v * 4) % 1))
        return x * 1.03, ROOF_FRONT - 0.5 + (ROOF_BACK - ROOF_FRONT + 1) * v, z + 0.28 - sag

    def side_cloth(u, v, side=1):
        y = ROOF_BACK - 0.2 if side == 0 else 0
        return (u - 0.5) * 2 * LEG_X, y + 0.09 * math.sin(u * 210) + 0.04 * math.sin(u * 61), 0.1 + v * (EAVES_Z - 0.2)

    scene.add("roof_skin", Shape().sheet("roof_skin", 32, 16, skin))
    scene.add("back_cloth", Shape().sheet(CLOTH, 400, 8, lambda u, v: side_cloth(u, v, 0)))

    def wall(u, v):
        return 0.08 * math.sin(u * 130), ROOF_BACK - 1.5 - 8.2 * u, DECK_Z + v * 9.5

    cloth = scene.mesh("side_cloth", Shape().sheet(CLOTH, 160, 6, wall))
    for side in (-1, 1):
        scene.add(f"side_cloth_{side}", cloth, place(side * (LEG_X - 0.4), 0, 0))
    # the front lip: a valance that hides the first truss from the back of the field
    lip = Shape()
    for k in range(16):
        (x0, z0), (x1, z1) = arch_point(k / 16), arch_point((k + 1) / 16)
        y = ROOF_FRONT - 0.52
        lip.add("roof_skin", [(x1, y, z1 - 0.35), (x0, y, z0 - 0.35), (x0, y, z0 + 0.3), (x1, y, z1 + 0.3)], [(0, 1, 2, 3)])
    scene.add("roof_lip", lip)


def arch_point(k):
    """0 right .. 1 left along the arch of the roof."""
    x = LEG_X * math.cos(math.pi * k)
    return x, EAVES_Z + (RIDGE_Z - EAVES_Z) * (1 - (x / LEG_X) ** 2)


def rig(scene, segment, fixtures):
    hoist = Shape().box("hoist_yellow", (-0.13, -0.1, 0.6), (0.13, 0.1, 0.95)).rod("chrome", (0, 0, 0.95), (0, 0, 2.2), 0.014, 4)
    hoist.rod("rubber", (0, -0.2, 0.2), (0, 0, 0.6), 0.014, 4).rod("rubber", (0, 0.2, 0.2), (0, 0, 0.6), 0.014, 4)
    mesh = scene.mesh("hoist", hoist)
    for k, (y, z, upper) in enumerate(layout.trusses(fixtures)):
        row(scene, segment, f"truss_{'upper_' if upper else ''}{k}", -12, 12, y, z)
        for i in range(5):
            scene.add(f"hoist_{k}_{i}", mesh, place(-10.5 + 5.25 * i, y, z))
    for side in (-1, 1):
        for y in (3.0, 10.0):
            ladder(scene, segment, f"ladder_{side}_{y:.0f}", side * 12.55, y, side)
    if fixtures >= 700:
        for x in (7.9, 9.2, 10.5):
            for side in (-1, 1):
                column(scene, segment, f"pipe_{side}_{x}", side * x, 12.75, DECK_Z, 8.6)


def ladder(scene, segment, name, x, y, side):
    column(scene, segment, name, x + side * 0.42, y, DECK_Z, EAVES_Z - 3.2)
    arms = Shape()
    for k in range(8):
        z = 3.4 + 6.0 * k / 7
        arms.rod(BLACK, (x + side * 0.4, y, z + 0.04), (x + side * 0.12, y, z + 0.04), 0.024)
    scene.add(name + "_arms", arms)


def led_wall(scene, segment):
    w, low, high, y = layout.WALL_HALF_WIDTH, layout.WALL_LOW, layout.WALL_HIGH, layout.WALL_Y
    panel = Shape().box("panel_frame", (-0.498, 0, 0.002), (0.498, 0.12, 0.998)).box("led_face", (-0.485, -0.012, 0.015), (0.485, 0, 0.985))
    mesh = scene.mesh("led_panel", panel)
    for i in range(int(2 * w)):
        for j in range(int(high - low)):
            scene.add(f"led_{i}_{j}", mesh, place(0.5 - w + i, y, low + j))
    row(scene, segment, "wall_top", -w - 0.5, w + 0.5, y - 0.4, high + 0.75)
    row(scene, segment, "wall_low", -w - 0.5, w + 0.5, y + 0.3, low - 0.3)
    for side in (-1, 1):
        column(scene, segment, f"wall_side_{side}", side * (w + 0.35), y, DECK_Z, high + 0.6)


def wings(scene, segment):
    """Scaffolds left and right with scrim, the sound hung from them, subs on the ground."""
    inner, outer, z = layout.WING_INNER, layout.WING_OUTER, layout.WING_Z
    element = Shape()
    corners = [(x, y, h * k) for y, k in ((-0.3, 1.0), (0.3, 0.8)) for x, h in ((-0.62, -0.17), (0.62, -0.17), (0.62, 0.17), (-0.62, 0.17))]
    element.add("cabinet_paint", corners, [(0, 1, 2, 3), (7, 6, 5, 4), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)])
    element.box("perforated_steel", (-0.58, -0.315, -0.14), (0.58, -0.3, 0.14))
    speaker = scene.mesh("array_element", element)
    sub = scene.mesh("sub", Shape().box("cabinet_paint", (-0.65, -0.5, 0), (0.65, 0.5, 0.58)).box(
        "perforated_steel", (-0.6, -0.515, 0.05), (0.6, -0.5, 0.53)))
    bay = Shape()
    for x in (0.0, 2.9):
        for y in (0.0, 2.0):
            bay.rod(METAL, (x, y, 0), (x, y, 2), 0.024)
    for h in (0.0, 1.0):
        for y in (0.0, 2.0):
            bay.rod(METAL, (0, y, h), (2.9, y, h), 0.02)
        for x in (0.0, 2.9):
            bay.rod(METAL, (x, 0, h), (x, 2, h), 0.02)
    bay.rod(METAL, (0, 0, 0), (2.9, 0, 2), 0.018).rod(METAL, (0, 2, 2), (2.9, 2, 0), 0.018)
    scaffold = scene.mesh("scaffold_bay", bay)
    scrim = scene.mesh("scrim", Shape().box("scrim", (0, 0, 0), (5.8, 0.02, 9.4)))
    for side in (-1, 1):
        start = inner if side > 0 else -outer
        row(scene, segment, f"wing_{side}", start, start + outer - inner, 0.6, z)
        for i in range(2):
            for j in range(5):
                scene.add(f"scaffold_{side}_{i}_{j}", scaffold, place(start + 2.9 * i, 1.2, 2 * j))
        scene.add(f"scrim_{side}", scrim, place(start, 1.6, 0.2))
        x = side * 17.2
        column(scene, segment, f"sound_tower_{side}", x, 0.6, z, z + 2.4)
        beam(scene, segment, f"sound_arm_{side}", x, -1.4, 2.6, z + 2.6)
        for k in range(14):
            tip = 0.02 + 0.0022 * k * k
            scene.add(f"array_{side}_{k}", speaker, place(x, -1.0 + 0.0016 * k ** 3 / 2, z + 1.8 - 0.345 * k, -side * 0.1, 1, tip))
        for i in range(4):
            for j in range(2):
                scene.add(f"sub_{side}_{i}_{j}", sub, place(side * (15.0 + 1.4 * i), -0.4, 0.6 * j))


def delay_tower(scene, segment, number, x, y):
    z = layout.DELAY_Z
    for dx in (-1.0, 1.0):
        for dy in (-1.0, 1.0):
            column(scene, segment, f"delay_{number}_{dx}_{dy}", x + dx, y + dy, 0.0, z)
    beam(scene, segment, f"delay_top_{number}", x, y - 1.2, y + 1.2, z + 0.2)
    beam(scene, segment, f"delay_low_{number}", x, y - 1.2, y + 1.2, z - 1.3)
    box = Shape().box("cabinet_paint", (-0.5, -0.3, -0.16), (0.5, 0.3, 0.16))
    mesh = scene.mesh(f"delay_array_{number}", box)
    for k in range(6):
        scene.add(f"delay_array_{number}_{k}", mesh, place(x, y - 1.5, z - 0.4 - 0.33 * k))
    scene.add(f"delay_foot_{number}", Shape().box("ballast", (-1.5, -1.5, 0), (1.5, 1.5, 0.5)), place(x, y, 0))


def mixing_tower(scene, segment):
    """The house's desks: a roofed platform in the middle of the field."""
    for x in (-3.0, 3.0):
        for y in (-38.0, -34.0):
            column(scene, segment, f"mixing_{x:.0f}_{y:.0f}", x, y, 0.0, 4.2)
    desk = Shape().box("riser_black", (-3.0, -38, 0.3), (3.0, -34, 0.5)).box("roof_skin", (-3.4, -38.4, 4.2), (3.4, -33.6, 4.35))
    desk.box("black_plastic", (-2.2, -34.9, 1.2), (-0.2, -34.2, 1.35)).box("black_plastic", (0.3, -34.9, 1.2), (2.2, -34.2, 1.35))
    desk.box("flight_case", (-2.2, -34.8, 0.5), (2.2, -34.3, 1.2))
    scene.add("mixing_platform", desk)

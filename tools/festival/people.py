# SPDX-License-Identifier: Apache-2.0
"""The band, taken over from the demo's stage, and a field of people: detailed ones near the camera, simple ones elsewhere."""
import math

from .glb import Glb, Shape, place
from .layout import DECK_Z

DEMO_DECK_Z = 1.2
BAND_KINDS = ("drum_kit", "guitar_stack", "bass_stack", "combo", "keyboards", "wedge", "mic_", "spare_guitar", "guitar_stand",
              "performer_", "instrument_", "strap_", "drum_sticks")
NEAR_CAMERA_M = 7.5


def build(scene, stage_path, random, eye, crowd):
    demo = Glb(stage_path.read_bytes())
    band(scene, demo)
    field_of_people(scene, demo, random, eye, crowd)


def band(scene, demo):
    """The front line stands at the demo's places, the rest on the platform."""
    rise = DECK_Z - DEMO_DECK_Z
    front = scene.add("band_front", None, place(0, 0.9, rise))
    back = scene.add("band_back", None, place(0, 1.9, rise + 0.7 - 0.3))
    drums = scene.add("band_drums", None, place(0, 1.9, rise + 0.7))
    riser = Shape().box("riser_black", (-1.6, -1.4, 0), (1.6, 1.4, 0.4)).box("riser_carpet", (-1.55, -1.35, 0.4), (1.55, 1.35, 0.414))
    scene.add("drum_riser", riser, place(0, 8.7, DECK_Z + 0.7))
    numbers = {}
    for node in demo.json["nodes"]:
        if not node["name"].startswith(BAND_KINDS):
            continue
        mesh = demo.json["meshes"][node["mesh"]]["name"]
        if mesh not in numbers:
            numbers[mesh] = scene.borrow(demo, mesh)
        parent = {"front": front, "back": back, "drums": drums}[group_of(node)]
        transform = {key: node[key] for key in ("translation", "rotation") if key in node}
        scene.add(node["name"], numbers[mesh], None, parent, **transform)


def group_of(node):
    """Demo things that stand on a riser go to the platform; the rest, amplifiers too, stays on the deck in front of it."""
    x, height, toward_house = node["translation"]   # glTF's axes
    if -toward_house < 5.4 or abs(height - DEMO_DECK_Z) < 0.25:
        return "front"
    return "drums" if height > 1.59 and abs(x) < 2 else "back"


def simple_figures():
    """Six people of about 150 triangles, facing up-stage (+Y)."""
    found = []
    cloths = ("crowd_charcoal", "crowd_wine", "crowd_navy", "crowd_olive", "shirt_grey", "crowd_charcoal")
    hands = (((-0.34, 0.12, 1.95), (0.34, 0.12, 1.98)), ((-0.3, 0.08, 0.9), (0.3, 0.08, 0.9)), ((-0.3, 0.05, 0.9), (0.3, 0.18, 2.0)),
             ((-0.08, 0.3, 2.0), (0.08, 0.3, 2.0)), ((-0.42, 0.05, 1.9), (0.3, 0.05, 0.95)), ((-0.14, 0.38, 1.5), (0.14, 0.38, 1.5)))
    for cloth, pair in zip(cloths, hands):
        made = Shape()
        made.ellipsoid("hair_black", (0, -0.02, 1.64), (0.1, 0.115, 0.14), 7, 5)
        made.ellipsoid(cloth, (0, 0, 1.18), (0.22, 0.14, 0.36), 8, 6)
        for side, hand in zip((-1, 1), pair):
            made.rod("trousers_dark", (side * 0.1, 0, 0), (side * 0.09, 0, 0.95), 0.07, 5, 0.1)
            elbow = (side * 0.36, 0.06 + 0.3 * hand[1], (1.38 + hand[2]) / 2 - 0.08)
            made.rod(cloth, (side * 0.18, 0, 1.4), elbow, 0.06, 5, 0.05)
            made.rod("crowd_skin", elbow, hand, 0.045, 5, 0.05)
        found.append(made)
    return found


def field_of_people(scene, demo, random, eye, crowd):
    simple = [scene.mesh(f"person_{i}", shape) for i, shape in enumerate(simple_figures())]
    detailed = [scene.borrow(demo, f"crowd_{i}") for i in range(8)]
    made = 0
    tries = 0
    taken = set()
    while made < crowd and tries < 20 * crowd:
        tries += 1
        depth = random.random() ** 1.35 * 42
        y = -4.2 - depth
        half_width = min(30.0, 15.0 + 0.5 * depth)
        x = random.uniform(-half_width, half_width)
        cell = (round(x / 0.62), round(y / 0.62))
        if cell in taken or (abs(x) < 4.6 and -39.5 < y < -29) or any(math.hypot(x - dx, y + 44) < 2.6 for dx in (-16, 16)):
            continue
        away = math.hypot(x - eye[0], y - eye[1])
        if away < 1.3 or (abs(x - eye[0]) < 0.45 and 0 < y - eye[1] < 4.5):
            continue
        taken.add(cell)
        near = away < NEAR_CAMERA_M and y > eye[1] - 1
        turn = random.uniform(-0.4, 0.4)
        scale = random.uniform(0.92, 1.05)
        kind = random.randrange(8) if near else random.randrange(6)
        if near:   # they look to the house in their own file
            scene.add(f"crowd_{made}", detailed[kind], place(x, y, 0, math.pi + turn, scale))
        else:
            scene.add(f"crowd_{made}", simple[kind], place(x, y, 0, turn, scale))
        made += 1

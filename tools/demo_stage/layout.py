# SPDX-License-Identifier: Apache-2.0
"""Where things are: the numbers that stage, rig and cameras share.

Metres and degrees. Axes as Blender and as a show file: x to the right as the house sees it, y up-stage, z up.
The deck's front edge is y = 0 and its top z = DECK_Z; the audience is at y < 0. Needs no Blender.
"""

DECK_Z = 1.2
DECK_HALF_WIDTH = 9.0
DECK_DEPTH = 10.0

TRUSS_SIDE = 0.29        # between the axes of two chords
CHORD_RADIUS = 0.025
TRUSS_SEGMENT = 2.0
TRUSS_SEGMENTS = 8
TRUSSES = {"front": (0.4, 6.75), "mid": (4.3, 6.95), "back": (8.0, 6.45)}   # name: y, z of the truss axis


def clamp_z(truss):
    """Underside of the lower chords, where a clamp's hook bears."""
    return TRUSSES[truss][1] - TRUSS_SIDE / 2 - CHORD_RADIUS


# name, truss, x, a point to aim at for a first look
HANGING = [
    ("SPOT_1", "back", -5.2, (-6.5, -4.0, 1.6)),
    ("SPOT_2", "back", 0.0, (0.0, -2.5, 1.4)),
    ("SPOT_3", "back", 5.2, (6.5, -4.0, 1.6)),
    ("SPOT_4", "front", -4.6, (-2.7, 2.6, 2.2)),
    ("SPOT_5", "front", 4.6, (0.3, 2.2, 2.3)),
    ("WASH_1", "mid", -4.4, (-4.2, 9.6, 3.6)),
    ("WASH_2", "mid", 0.0, (0.0, 9.6, 3.8)),
    ("WASH_3", "mid", 4.4, (4.2, 9.6, 3.6)),
    ("WASH_4", "back", -2.6, (-2.8, 3.0, DECK_Z)),
    ("WASH_5", "back", 2.6, (2.8, 3.0, DECK_Z)),
]


def hanging_positions():
    """(name, truss, clamp point under the down-stage lower chord, aim) of every fixture."""
    return [(name, truss, (x, TRUSSES[truss][0] - TRUSS_SIDE / 2, clamp_z(truss)), aim) for name, truss, x, aim in HANGING]


# name: position, look at, vertical field of view, the picture's shape
CAMERAS = {
    "foh": ((0.0, -15.5, 4.2), (0.0, 3.0, 3.76), 23.4, (1024, 300)),
    "close": ((-1.75, -0.7, 1.75), (-0.75, 5.0, 3.15), 56.0, (1280, 720)),
    "high": ((-11.0, -8.5, 7.4), (1.0, 3.8, 2.8), 44.0, (1280, 720)),
}

# SPDX-License-Identifier: Apache-2.0
"""Where the demo's fixtures hang, their channels, and aiming in metres. Agrees with assets/demo/show.toml."""
import math

HEAD_BELOW_M = 0.395  # the tilt axis under the top of the base

# name: (x, y, z of the top of the base in metres, first address in universe 1); all hang upright, unrotated
RIG = {
    'Spot 1': (-5.2, 8.0, 6.23, 1), 'Spot 2': (0.0, 8.0, 6.23, 23), 'Spot 3': (5.2, 8.0, 6.23, 45),
    'Spot 4': (-4.6, 0.4, 6.53, 67), 'Spot 5': (4.6, 0.4, 6.53, 89),
    'Wash 1': (-4.4, 4.3, 6.73, 111), 'Wash 2': (0.0, 4.3, 6.73, 126), 'Wash 3': (4.4, 4.3, 6.73, 141),
    'Wash 4': (-2.6, 8.0, 6.23, 156), 'Wash 5': (2.6, 8.0, 6.23, 171),
}
NAMES = list(RIG)
SPOTS, WASHES = range(5), range(5, 10)

# Channels, counted from 0 (charts of the VL2500 manuals, see assets/fixtures).
DIM, PAN, TILT, CYAN, YELLOW, MAGENTA, COLOR = 0, 1, 3, 5, 6, 7, 8
EDGE, SPOT_STROBE, ZOOM, GOBO, ROTATING, ROTATION, IRIS = 9, 10, 11, 12, 13, 14, 16
DIFFUSER, WASH_STROBE = 9, 10


def pan_tilt_deg(fixture, target, near=(0.0, 0.0)):
    """Pan and tilt that point the beam Rz(pan) Rx(tilt) (0,0,-1) at the target; of the two ways and all turns within the
    range, the one nearest to the angles it has."""
    x, y, z, _ = RIG[NAMES[fixture]]
    dx, dy, dz = target[0] - x, target[1] - y, target[2] - (z - HEAD_BELOW_M)
    steep = math.degrees(math.atan2(math.hypot(dx, dy), -dz))
    turn = math.degrees(math.atan2(-dx, dy))
    ways = [(turn + 360 * k, steep) for k in (-1, 0, 1)] + [(turn + 180 + 360 * k, -steep) for k in (-2, -1, 0, 1)]
    ways = [way for way in ways if abs(way[0]) <= 270 and abs(way[1]) <= 135]
    return min(ways, key=lambda way: abs(way[0] - near[0]) + abs(way[1] - near[1]))


def pan_tilt_dmx(pan_deg, tilt_deg):
    """{channel: level} of both 16-bit pairs."""
    pan = min(65535, max(0, round((pan_deg + 270) / 540 * 65535)))
    tilt = min(65535, max(0, round((tilt_deg + 135) / 270 * 65535)))
    return {PAN: pan >> 8, PAN + 1: pan & 255, TILT: tilt >> 8, TILT + 1: tilt & 255}


def edge_dmx(distance_m):
    """Sharp at this distance: the fixture file focuses at 2 * 25^(edge) metres."""
    return min(255, max(0, round(255 * math.log(distance_m / 2) / math.log(25))))


def rotation_dmx(turns_per_s):
    """{channel: level} of the 16-bit gobo rotation; positive is counter-clockwise, at most one turn a second."""
    speed = abs(turns_per_s)
    value = round(33032 + speed * 32503) if turns_per_s > 0 else round(32535 - speed * 32535)
    if turns_per_s == 0:
        value = 32768
    return {ROTATION: value >> 8, ROTATION + 1: value & 255}

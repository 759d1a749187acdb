# SPDX-License-Identifier: Apache-2.0
"""Where the movers of the kinetic stage put their load: rigid motions as 4 x 4 lists, worked out here and not by the program. Metres, degrees."""
import math

IDENTITY = [[1.0, 0, 0, 0], [0, 1.0, 0, 0], [0, 0, 1.0, 0], [0, 0, 0, 1.0]]
HOOKS_X = (-5.0, 5.0)          # of the truss's two hoists
TRUSS = (0.0, 2.0, 6.0)        # middle of its lower chords
REVOLVE = (0.0, 2.0, 0.0)
PATH = [(-7.5, -3.0), (-3.5, -3.0), (-1.5, -4.0), (4.5, -4.0)]
WHEELBASE = 1.2
PARENTS = {"Winch": "Truss"}


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def moved(x, y, z):
    return [[1.0, 0, 0, x], [0, 1.0, 0, y], [0, 0, 1.0, z], [0, 0, 0, 1.0]]


def about(centre, axis, degrees):
    """Turned about the X, Y or Z direction through a place."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    turn = [row[:] for row in IDENTITY]
    turn[i][i], turn[i][j], turn[j][i], turn[j][j] = c, -s, s, c
    return times(moved(*centre), times(turn, moved(*(-v for v in centre))))


def truss(left, right):
    tilt = math.degrees(math.asin((right - left) / (HOOKS_X[1] - HOOKS_X[0])))
    return times(moved(0, 0, (left + right) / 2), about(TRUSS, "y", -tilt))


def on_path(at):
    for k in range(len(PATH) - 1):
        (ax, ay), (bx, by) = PATH[k], PATH[k + 1]
        length = math.hypot(bx - ax, by - ay)
        if at <= length or k + 2 == len(PATH):
            return ax + (bx - ax) * at / length, ay + (by - ay) * at / length
        at -= length
    raise AssertionError


def wagon(at):
    def axles(s):
        (fx, fy), (rx, ry) = on_path(s + WHEELBASE / 2), on_path(s - WHEELBASE / 2)
        return (fx + rx) / 2, (fy + ry) / 2, math.degrees(math.atan2(fy - ry, fx - rx))
    x0, y0, h0 = axles(0)
    x, y, h = axles(at)
    return times(moved(x - x0, y - y0, 0), about((x0, y0, 0), "z", h - h0))


OWN = {
    "Truss": truss,
    "Winch": lambda down: moved(0, 0, -down),
    "Revolve": lambda degrees: about(REVOLVE, "z", degrees),
    "Lift": lambda up: moved(0, 0, up),
    "Wagon": wagon,
}


def place_of(mover, values):
    """values: mover -> numbers of its axes; those that are left out stand at 0."""
    if mover is None:
        return IDENTITY
    own = OWN[mover](*values.get(mover, (0, 0) if mover == "Truss" else (0,)))
    return times(place_of(PARENTS.get(mover), values), own)


def angles_of(matrix):
    """The three angles of a turn about X, then Y, then Z."""
    y = math.asin(max(-1.0, min(1.0, -matrix[2][0])))
    return [math.degrees(v) for v in (math.atan2(matrix[2][1], matrix[2][2]), y, math.atan2(matrix[1][0], matrix[0][0]))]

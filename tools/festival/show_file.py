# SPDX-License-Identifier: Apache-2.0
"""show.toml of the festival. What every key means: docs/reference/show-file.md."""
import math

WIDE_EYE = (-2.5, -20.0, 2.35)


def exposure(fixtures):
    """More lamps are more light: half a stop for each doubling."""
    return round(6.4 + 0.5 * max(0.0, math.log2(fixtures / 60)), 1)


def ambient_lux(fixtures):
    """A night sky that shows roof and towers faintly, however far the cameras are stopped down."""
    return round(4.0 * 2 ** (exposure(fixtures) - 6.4), 1)


def cameras(fixtures):
    """name, why, eye, target, vertical angle, picture, exposure."""
    ev = exposure(fixtures)
    return [("house", "from the mixing tower", (0, -31.0, 4.6), (0, 3, 7.0), 25.0, (1024, 300), ev),
            ("wide", "from among the crowd", WIDE_EYE, (0.6, 4, 7.3), 54.0, (1920, 1080), ev),
            ("close", "from the pit", (-4.6, -2.6, 2.7), (0.6, 6.0, 5.6), 62.0, (1280, 720), ev),
            ("side", "high, three quarters", (-21, -17, 12), (1.2, 2.5, 5.6), 52.0, (1280, 720), ev),
            ("drone", "over the field", (7, -36, 18), (0.3, 0, 6.2), 50.0, (1920, 1080), round(ev - 0.5, 1))]


def text(fixtures, seed):
    lines = ["# SPDX-License-Identifier: Apache-2.0",
             f"# Made by tools/make_festival.py --fixtures {len(fixtures)} --seed {seed}. What every key means: docs/reference/show-file.md.", "",
             "[show]", f'name = "Festival, {len(fixtures)} lamps"', 'stage = "stage.glb"', 'recording = "festival.show"',
             f"ambient_lux = {ambient_lux(len(fixtures))}", "", "[haze]", "extinction_per_m = 0.012", ""]
    for name, why, eye, target, angle, size, ev in cameras(len(fixtures)):
        lines += [f"[[camera]] # {why}", f'name = "{name}"', f"position_m = {numbers(eye)}", f"target_m = {numbers(target)}",
                  f"fov_y_deg = {angle}", f"size = [{size[0]}, {size[1]}]", f"ev100 = {ev}", ""]
    for f in fixtures:
        lines += [f"[[fixture]] # {f.role}", f'name = "{f.name}"', f'gdtf = "{f.gdtf}"', f'mode = "{f.mode}"', f"universe = {f.universe}",
                  f"address = {f.address}", f"position_m = {numbers(f.position)}"]
        if f.standing:
            lines.append("rotation_deg = [180, 0, 0]")
        lines += [f"home_deg = {'[0, 25]' if f.standing else '[0, -60]'}", ""]
    return "\n".join(lines)


def numbers(point):
    return "[" + ", ".join(f"{c:g}" for c in point) + "]"

# SPDX-License-Identifier: Apache-2.0
"""Looks as DMX levels of the VL2500 Spot (22 channels) and Wash (15), see docs/reference/fixtures.md, and the recording of a whole show."""
from demo_show.rig import edge_dmx, pan_tilt_dmx, rotation_dmx

FIXED = {name: 18 * i for i, name in enumerate(("open", "pebbles", "dust", "circles", "night sky", "leaves", "bars", "wave", "blocks",
                                                "tribal", "liquid", "rays"))}
ROTATING = {"open": 0, "vortex": 146, "window": 169, "rings": 191, "foliage": 214, "caustics": 236}
FRAMES_PER_S = 30


class Look:
    """What one lamp does now. level, width, iris 0..1; colour linear red, green, blue; strobe 0 is open."""
    __slots__ = ("turn", "rise", "level", "colour", "width", "iris", "gobo", "rotating", "turns_per_s", "strobe_hz", "focus_m")

    def __init__(self, turn, rise, level, colour, width=0.0, iris=1.0, gobo="open", rotating="open", turns_per_s=0.0,
                 strobe_hz=0.0, focus_m=16):
        self.turn, self.rise, self.level, self.colour = turn, rise, level, colour
        self.width, self.iris, self.gobo, self.rotating = width, iris, gobo, rotating
        self.turns_per_s, self.strobe_hz, self.focus_m = turns_per_s, strobe_hz, focus_m


def byte(x):
    return 0 if x <= 0 else 255 if x >= 1 else round(255 * x)


def pan_tilt_deg(fixture, look):
    """Yoke angles of a hanging head, or of one that stands (turned by 180 degrees about X)."""
    pan, tilt = (-look.turn, 90 - look.rise) if fixture.standing else (look.turn, -90 - look.rise)
    return max(-270.0, min(270.0, pan)), max(-135.0, min(135.0, tilt))


def strobe(hz):
    """13..255 is 1 to 20 Hz; 0 open."""
    return 0 if hz <= 0 else max(13, min(255, round(13 + 242 * (hz - 1) / 19)))


def levels(fixture, look):
    """The fixture's channels in order."""
    angles = pan_tilt_dmx(*pan_tilt_deg(fixture, look))
    red, green, blue = look.colour
    head = [byte(look.level), *angles.values(), byte(1 - red), byte(1 - blue), byte(1 - green), 0]   # cyan, yellow, magenta, wheel
    if fixture.kind == "Wash":
        return bytes(head + [byte(look.width), strobe(look.strobe_hz), 0, 0, 0, 0])
    return bytes(head + [edge_dmx(look.focus_m), strobe(look.strobe_hz), byte(look.width), FIXED[look.gobo], ROTATING[look.rotating],
                         *rotation_dmx(look.turns_per_s).values(), byte(look.iris), 0, 0, 0, 0, 0])


def record(path, fixtures, show, seconds):
    """Writes an OLA show file: a line for each universe that changed, then the milliseconds until the next frame. Returns the lines."""
    universes = {}
    for fixture in fixtures:
        universes.setdefault(fixture.universe, []).append(fixture)
    text = [str(value) for value in range(256)]
    frames = max(1, round(seconds * FRAMES_PER_S))
    end_ms = round(seconds * 1000)
    last, written, at_ms = {}, 0, 0
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write("OLA Show\n")
        pending = []
        for number in range(frames):
            moment = show.at(number / FRAMES_PER_S)
            changed = []
            for universe, members in universes.items():
                data = b"".join(levels(fixture, show.look(fixture, *moment)) for fixture in members)
                if last.get(universe) != data:
                    last[universe] = data
                    changed.append(f"{universe} " + ",".join([text[value] for value in data]) + "\n")
            if number == 0:
                pending = changed
                continue
            if changed:
                now_ms = round(number * 1000 / FRAMES_PER_S)
                written += write(out, pending, now_ms - at_ms)
                pending, at_ms = changed, now_ms
        written += write(out, pending, max(1, end_ms - at_ms))
    return written


def write(out, lines, pause_ms):
    """Every line of a moment but the last is followed by a pause of 0."""
    out.write("0\n".join(lines) + f"{pause_ms}\n")
    return len(lines)

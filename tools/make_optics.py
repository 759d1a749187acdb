#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the show of docs/design/optics.md: a hall of a floor and a wall, and a recording in which every optic of the fixture
assets/fixtures/Ghostlight@Optics_Profile.gdtf has its turn; and that fixture's animation disc. Same bytes each time.

usage: make_optics.py [--out FOLDER]     default: assets/optics, and the disc into the fixture's own wheels/
"""
import argparse
import math
import struct
import zlib
from pathlib import Path

from festival import glb

ROOT = Path(__file__).resolve().parent.parent
SHOW = ROOT / "assets" / "optics"
WHEELS = ROOT / "assets" / "fixtures" / "src" / "Optics_Profile" / "wheels"

CHANNELS = ["dimmer", "zoom", "focus", "iris", "gobo1", "gobo2", "gobo2_pos", "disc", "disc_pos", "top_a", "top_b", "right_a",
            "right_b", "bottom_a", "bottom_b", "left_a", "left_b", "shaper", "prism1", "prism1_pos", "prism2", "prism2_pos",
            "frost1", "frost2", "colour"]
# Zoom 80: 19 degrees. Focus 110: gobo wheel 1 is sharp at the wall, 8 m away.
REST = {"dimmer": 255, "zoom": 80, "focus": 110, "gobo2_pos": 0, "shaper": 128}
BLADES = {"top_a": 70, "top_b": 40, "right_a": 60, "right_b": 60, "bottom_a": 40, "bottom_b": 90, "left_a": 30, "left_b": 80}
# Each begins at 4 s times its place and stands for 4 s.
SCENES = [
    ("open", {}),
    ("gobo", {"gobo1": 25}),
    ("between", {"gobo1": 37}),
    ("blades_sharp", dict(BLADES, focus=37)),
    ("blades_soft", BLADES),
    ("blades_turned", dict(BLADES, focus=37, shaper=200)),
    ("focus_gobo", {"gobo1": 25, "iris": 64}),
    ("focus_iris", {"gobo1": 25, "iris": 64, "focus": 56}),
    ("focus_near", {"gobo1": 25, "focus": 40}),
    ("disc", {"disc": 255, "disc_pos": 160, "focus": 149}),
    ("prism_linear", {"zoom": 10, "gobo1": 75, "prism1": 85, "prism1_pos": 20}),
    ("prism_circular", {"zoom": 10, "gobo1": 75, "prism1": 170}),
    ("prism_stacked", {"zoom": 4, "prism1": 170, "prism2": 128}),
    ("prism_turning", {"zoom": 10, "gobo2": 64, "prism1": 170, "prism1_pos": 200}),
    ("frost_light", {"gobo1": 25, "frost1": 255}),
    ("frost_half", {"gobo1": 25, "frost2": 90}),
    ("frost_heavy", {"gobo1": 25, "frost2": 255}),
    ("iris_pulse", {"iris": 220}),
    ("shake", {"gobo1": 150}),
    ("split", {"colour": 75}),
    ("three", {"gobo1": 25, "gobo2": 128, "disc": 255, "disc_pos": 160}),
]


def levels(values):
    slots = [0] * len(CHANNELS)
    for name, value in {**REST, **values}.items():
        slots[CHANNELS.index(name)] = value
    return ",".join(str(slot) for slot in slots)


def recording():
    lines = ["OLA Show"]
    for _, values in SCENES:
        lines += [f"1 {levels(values)}", "4000"]
    lines += [f"1 {levels({})}", "0"]
    return "\n".join(lines) + "\n"


def hall():
    scene = glb.Scene({"wall": ((0.5, 0.5, 0.5), 0.9, 0.0, True), "floor": ((0.12, 0.12, 0.12), 0.6, 0.0, True)})
    scene.add("floor", glb.Shape().add("floor", [(-8, -4, 0), (8, -4, 0), (8, 8, 0), (-8, 8, 0)], [(0, 1, 2, 3)]))
    scene.add("wall", glb.Shape().add("wall", [(-8, 8, 0), (8, 8, 0), (8, 8, 7), (-8, 8, 7)], [(0, 1, 2, 3)]))
    return scene.data()


def disc(size=512):
    """Slots that wind outwards and break up, as tongues of fire; the hub is closed. Grey and alpha."""
    rows = []
    for row in range(size):
        line = bytearray([0])
        for column in range(size):
            x, y = (2 * column + 1) / size - 1, 1 - (2 * row + 1) / size
            r, angle = math.hypot(x, y), math.atan2(y, x)
            wobble = 0.25 * math.sin(9 * r + 3 * angle) + 0.2 * math.sin(17 * r - 7 * angle)
            tongue = abs(math.sin(10 * angle + 12 * r + wobble)) - 0.42 - 0.25 * math.sin(21 * r + 4 * angle)
            light = min(max(0.5 + tongue * 6, 0.0), 1.0) if r > 0.2 else 0.0
            coded = 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055
            line += bytes([round(255 * coded), 255 if r < 0.995 else 0])
        rows.append(bytes(line))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", size, size, 8, 4, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"".join(rows), 9)) + chunk(b"IEND", b"")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path)
    out = parser.parse_args().out
    for folder, name, data in ((SHOW, "optics.show", recording().encode()), (SHOW, "stage.glb", hall()),
                               (WHEELS, "animation_flames.png", disc())):
        folder = out or folder
        folder.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    for place, (name, _) in enumerate(SCENES):
        print(f"{4 * place + 2:4d} s  {name}")


if __name__ == "__main__":
    main()

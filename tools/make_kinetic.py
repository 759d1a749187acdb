#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes assets/kinetic: a stage on which a truss with lamps, a winch, a revolve, a lift and a wagon travel, and its recording. Same arguments,
same bytes.

usage: make_kinetic.py [--out assets/kinetic] [--lamps 8]

Needs only Python and this source tree. docs/guide/kinetic.md.
"""
import argparse
import math
import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ASSETS = HERE.parent / "assets"
sys.path.insert(0, str(HERE))
from kinetic import stage  # noqa: E402

FRAMES_PER_S = 20
SECONDS = 24


def smooth(x):
    x = max(0.0, min(1.0, x))
    return x * x * (3 - 2 * x)


def values_at(at_s):
    """What the desk asks for: within what the machines can."""
    down = -2.0 * smooth(at_s / 8) + 1.0 * smooth((at_s - 14) / 6)
    tilt = 0.8 * math.sin(2 * math.pi * smooth((at_s - 6) / 16))
    return {"Truss": (min(down - tilt, 0.0), min(down + tilt, 0.0)), "Winch": (0.6 * smooth((at_s - 4) / 4) - 0.6 * smooth((at_s - 18) / 4),),
            "Revolve": (300 * smooth((at_s - 2) / 18),), "Lift": (1.4 * smooth((at_s - 3) / 7) - 0.7 * smooth((at_s - 16) / 6),),
            "Wagon": (11.0 * smooth((at_s - 1) / 18),)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=ASSETS / "kinetic", help="folder of the show; its files of the same names are replaced")
    parser.add_argument("--lamps", type=int, default=8, choices=range(1, 65), metavar="1..64", help="lamps on the truss")
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    rig = stage.lamps(given.lamps)
    fixtures = os.path.relpath(ASSETS / "fixtures", given.out.resolve())
    stage.write_stage(given.out / "stage.glb", {})
    (given.out / "show.toml").write_text(stage.show_text(rig, fixtures, {}, True), encoding="utf-8")
    stage.write_recording(given.out / "kinetic.show", rig, [(k / FRAMES_PER_S, values_at(k / FRAMES_PER_S)) for k in range(SECONDS * FRAMES_PER_S)])
    print(f"{given.out}: {len(rig)} lamps, {SECONDS} s")


if __name__ == "__main__":
    main()

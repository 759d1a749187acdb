#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the kinetic stage (tools/make_kinetic.py) while a mover goes through its places, and each place once more as a scene of its own in which
nothing moves, and prints how far the pictures are apart, in dB.

usage: kinetic_places.py BUILD [--mover Truss] [--places 10] [--size 640x360] [--lamps 8] [--least 45] [--moving-maps device]

Where things stand in the scenes that do not move is worked out in tools/kinetic/places.py. Exits 1 where a place is below --least.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from kinetic import stage  # noqa: E402

WAYS = {
    "Truss": lambda k: {"Truss": (-0.2 - 2.6 * k, -3.2 * k ** 2), "Winch": (1.5 * k,)},
    "Revolve": lambda k: {"Revolve": (330 * k,)},
    "Lift": lambda k: {"Lift": (2.4 * k,)},
    "Wagon": lambda k: {"Wagon": (11.5 * k,)},
}
WAYS["all"] = lambda k: {name: values for mover in ("Truss", "Revolve", "Lift", "Wagon") for name, values in WAYS[mover](k).items()}


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return done.stdout


def write(folder, rig, values, moments, moves):
    folder.mkdir()
    fixtures = os.path.relpath(HERE.parent / "assets" / "fixtures", folder.resolve())
    stage.write_stage(folder / "stage.glb", {} if moves else values)
    (folder / "show.toml").write_text(stage.show_text(rig, fixtures, values, moves, "commanded"), encoding="utf-8")
    stage.write_recording(folder / "kinetic.show", rig, moments)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder with ghostlight")
    parser.add_argument("--mover", action="append", choices=list(WAYS), help="these only; may be repeated")
    parser.add_argument("--places", type=int, default=10)
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--lamps", type=int, default=8)
    parser.add_argument("--least", type=float, default=45.0, help="dB")
    parser.add_argument("--moving-maps", choices=("processor", "device"), help="of the show that moves; of ghostlight render")
    given = parser.parse_args()
    program = given.build / "ghostlight"
    rig = stage.lamps(given.lamps)
    worst = 1e9
    with tempfile.TemporaryDirectory() as temporary:
        top = Path(temporary)
        for mover in given.mover or [name for name in WAYS if name != "all"]:
            ways = [WAYS[mover](k / max(given.places - 1, 1)) for k in range(given.places)]
            travels = top / mover
            write(travels, rig, {}, [(float(k), values) for k, values in enumerate(ways)], True)
            by = ("--moving-maps", given.moving_maps) if given.moving_maps else ()
            run(program, "render", travels, "--live", *by, "--from", 0, "--to", given.places, "--fps", 1, "--size", given.size, "-o", travels / "at.exr", "--quiet")
            for k, values in enumerate(ways):
                stands = top / f"{mover} {k}"
                write(stands, rig, values, [(0.0, {})], False)
                run(program, "render", stands, "--live", "--at", 0, "--size", given.size, "-o", stands / "it.exr", "--quiet")
                told = json.loads(run(program, "compare", travels / f"at-{k:05d}.exr", stands / "it.exr", "--ev", 4.5, "--json", "--quiet"))
                psnr = told["psnr"] if told["psnr"] is not None else float("inf")
                worst = min(worst, psnr)
                print(f"{mover} place {k + 1}: {psnr:.1f} dB", flush=True)
    print(f"worst: {worst:.1f} dB")
    return 0 if worst >= given.least else 1


if __name__ == "__main__":
    sys.exit(main())

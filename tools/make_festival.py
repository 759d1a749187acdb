#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a festival: a show folder with a stage, a rig of any size and a recording. Same arguments, same bytes.

usage: make_festival.py --out FOLDER [--fixtures 400] [--seconds 30] [--seed 1]

Needs only Python and this source tree (the band comes from assets/demo/stage.glb, the lamps from assets/fixtures). docs/guide/festival.md.
"""
import argparse
import random
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ASSETS = HERE.parent / "assets"
sys.path.insert(0, str(HERE))
from festival import channels, choreography, glb, layout, materials, people, show_file, venue  # noqa: E402

MAX_FIXTURES = 2000
MAX_RECORDING_BYTES = 512 << 20   # the most that ghostlight reads
BYTES_PER_CHANNEL = 3.3
CROWD = 1200


def whole(low, high):
    def convert(given):
        value = int(given) if given.lstrip("-").isdigit() else None
        if value is None or not low <= value <= high:
            raise argparse.ArgumentTypeError(f"'{given}', expected a whole number from {low} to {high}")
        return value
    return convert


def seconds(given):
    try:
        value = float(given)
    except ValueError:
        value = 0.0
    if not 0.1 <= value <= 3600:
        raise argparse.ArgumentTypeError(f"'{given}', expected seconds from 0.1 to 3600")
    return value


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fixtures", type=whole(1, MAX_FIXTURES), default=400, help="moving lights, 1 to 2000")
    parser.add_argument("--out", type=Path, required=True, help="folder of the show; its files of the same names are replaced")
    parser.add_argument("--seconds", type=seconds, default=30.0, help="length of the recording")
    parser.add_argument("--seed", type=whole(0, 2 ** 31 - 1), default=1, help="another crowd, other colours")
    given = parser.parse_args()
    if given.out.exists() and not given.out.is_dir():
        parser.error(f"argument --out: '{given.out}' is a file, expected a folder or a new name")
    expected = given.seconds * channels.FRAMES_PER_S * BYTES_PER_CHANNEL * 22 * given.fixtures
    if expected > MAX_RECORDING_BYTES:
        parser.error(f"argument --seconds: {given.fixtures} fixtures for {given.seconds:g} s would make a recording of about "
                     f"{expected / 2 ** 20:.0f} MiB, expected less than 512 MiB; take fewer seconds or fixtures")
    return given


def make(out, count, length_s, seed):
    out.mkdir(parents=True, exist_ok=True)
    fixtures = layout.hang(count)
    scene = glb.Scene(materials.MATERIALS)
    venue.build(scene, count)
    people.build(scene, ASSETS / "demo" / "stage.glb", random.Random(f"crowd {seed}"), show_file.WIDE_EYE, CROWD)
    stage = scene.data()
    (out / "stage.glb").write_bytes(stage)
    (out / "show.toml").write_text(show_file.text(fixtures, seed), encoding="utf-8", newline="\n")
    for name in sorted({f.gdtf for f in fixtures}):
        shutil.copyfile(ASSETS / "fixtures" / name, out / name)
    lines = channels.record(out / "festival.show", fixtures, choreography.Show(random.Random(f"show {seed}")), length_s)
    size = (out / "festival.show").stat().st_size
    spots = sum(f.kind == "Spot" for f in fixtures)
    print(f"{out}: {count} fixtures ({spots} Spot, {count - spots} Wash) in {fixtures[-1].universe} universes")
    print(f"stage.glb {len(stage) / 1e6:.2f} MB, {scene.drawn} triangles drawn, {sum(scene.triangles)} stored, {len(scene.nodes)} objects")
    print(f"festival.show {size / 1e6:.2f} MB, {length_s:g} s, {lines} frames of a universe")


def main():
    given = options()
    try:
        make(given.out, given.fixtures, given.seconds, given.seed)
    except OSError as problem:
        sys.exit(f"make_festival.py: {problem}")


if __name__ == "__main__":
    main()

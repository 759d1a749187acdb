#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a black box theatre with a white cyclorama: a show folder with a stage, 13 lamps and five cues of four seconds. Same bytes each time.

usage: make_theatre.py --out FOLDER

What bounces is most of its light: a white cloth, thin as paper, in a black room. Needs only Python and this source tree (the actors come
from assets/demo/stage.glb, the lamps from assets/fixtures). docs/design/bounce.md.
"""
import argparse
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ASSETS = HERE.parent / "assets"
sys.path.insert(0, str(HERE))
from festival import channels, glb  # noqa: E402
from festival.show_file import numbers  # noqa: E402
from theatre import cues, stage  # noqa: E402

# name, where from, eye, target, vertical angle, picture, exposure
CAMERAS = (("house", "from the third row", (0, -6.4, 2.4), (0, 3.0, 2.3), 46.0, (1024, 576), 6.0),
           ("wing", "from the prompt side", (-4.6, -1.6, 1.8), (1.2, 4.6, 1.9), 58.0, (1280, 720), 6.0),
           ("close", "what an actor sees of another", (0.2, -1.4, 1.6), (0.3, 3.2, 1.3), 50.0, (1280, 720), 6.0))


def text(fixtures):
    lines = ["# SPDX-License-Identifier: Apache-2.0", "# Made by tools/make_theatre.py. What every key means: docs/reference/show-file.md.", "",
             "[show]", 'name = "Black box"', 'stage = "stage.glb"', 'recording = "theatre.show"', "", "[haze]", "extinction_per_m = 0.008", "",
             "[light]", 'bounce = "normal"', ""]
    for name, why, eye, target, angle, size, ev in CAMERAS:
        lines += [f"[[camera]] # {why}", f'name = "{name}"', f"position_m = {numbers(eye)}", f"target_m = {numbers(target)}",
                  f"fov_y_deg = {angle}", f"size = [{size[0]}, {size[1]}]", f"ev100 = {ev}", ""]
    for f in fixtures:
        lines += ["[[fixture]]", f'name = "{f.name}"', f'gdtf = "{f.gdtf}"', f'mode = "{f.mode}"', f"universe = {f.universe}",
                  f"address = {f.address}", f"position_m = {numbers(f.position)}"]
        lines += (["rotation_deg = [180, 0, 0]"] if f.standing else []) + [""]
    return "\n".join(lines)


def make(out):
    out.mkdir(parents=True, exist_ok=True)
    scene = glb.Scene(stage.MATERIALS)
    stage.build(scene, ASSETS / "demo" / "stage.glb")
    fixtures = cues.hang()
    (out / "stage.glb").write_bytes(scene.data())
    (out / "show.toml").write_text(text(fixtures), encoding="utf-8", newline="\n")
    for name in sorted({f.gdtf for f in fixtures}):
        shutil.copyfile(ASSETS / "fixtures" / name, out / name)
    channels.record(out / "theatre.show", fixtures, cues.Cues(), cues.CUE_S * len(cues.CUES))
    print(f"{out}: {len(fixtures)} fixtures, {scene.drawn} triangles, {len(scene.nodes)} objects, {len(cues.CUES)} cues")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True, help="folder of the show; its files of the same names are replaced")
    given = parser.parse_args()
    if given.out.exists() and not given.out.is_dir():
        parser.error(f"argument --out: '{given.out}' is a file, expected a folder or a new name")
    try:
        make(given.out)
    except OSError as problem:
        sys.exit(f"make_theatre.py: {problem}")


if __name__ == "__main__":
    main()

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The films on the front page, docs/images/demo.webp (the demo's recording from a camera that travels from the house to the band) and
kinetic.webp (a truss that flies, a revolve, a lift and a wagon), each below its size. Usage: front_film.py BUILD_FOLDER [NAME].
Needs python3-pil; minutes without a GPU."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

from PIL import Image

SOURCE = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = pathlib.Path(sys.argv[1]).resolve() / "ghostlight"
FPS = 10
# By show: seconds of its recording, what the camera does, and the most bytes.
FILMS = {"demo": (16, 36, ["--travel", "close"], 3_000_000), "kinetic": (1, 13, [], 1_500_000)}


def frames_of(work, name, from_s, to_s, camera):
    shutil.copytree(SOURCE / "assets" / name, work / name, ignore=shutil.ignore_patterns(".ghost"))
    shutil.copytree(SOURCE / "assets/fixtures", work / "fixtures")
    subprocess.run([PROGRAM, "render", work / name, "-o", work / "f.png", "--live", "--view", "house", *camera,
                    "--from", str(from_s), "--to", str(to_s), "--fps", str(FPS), "--size", "400x225"], check=True)
    return [Image.open(frame).convert("RGB") for frame in sorted(work.glob("f-*.png"))]


def make(name, from_s, to_s, camera, largest_bytes):
    film = SOURCE / f"docs/images/{name}.webp"
    with tempfile.TemporaryDirectory() as folder:
        frames = frames_of(pathlib.Path(folder), name, from_s, to_s, camera)
    assert len(frames) == (to_s - from_s) * FPS, len(frames)
    for quality in (80, 65, 50, 35, 20):
        frames[0].save(film, save_all=True, append_images=frames[1:], duration=1000 // FPS, loop=0, quality=quality, method=4)
        if film.stat().st_size < largest_bytes:
            print(f"{film}: {len(frames)} frames, quality {quality}, {film.stat().st_size} bytes")
            return
    sys.exit(f"{film}: {film.stat().st_size} bytes, more than {largest_bytes} at the lowest quality")


def main():
    for name in sys.argv[2:] or FILMS:
        make(name, *FILMS[name])


if __name__ == "__main__":
    main()

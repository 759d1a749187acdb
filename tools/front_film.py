#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The film on the front page, docs/images/demo.webp: the demo's recording from a camera that travels from the house to the band, then the
truss of the kinetic stage as it flies; below 3 MB. Usage: front_film.py BUILD_FOLDER. Needs python3-pil; minutes without a GPU."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

from PIL import Image

SOURCE = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = pathlib.Path(sys.argv[1]).resolve() / "ghostlight"
FILM = SOURCE / "docs/images/demo.webp"
LARGEST_BYTES = 3_000_000
FPS = 10
SIZE = "400x225"
FROM_S, TO_S = 16, 36  # of the demo's recording
FLIGHT_FROM_S, FLIGHT_TO_S = 4, 12  # of that of assets/kinetic


def frames_of(work):
    for show in ("demo", "kinetic", "fixtures"):
        shutil.copytree(SOURCE / "assets" / show, work / show, ignore=shutil.ignore_patterns(".ghost"))
    for name, show, *more in (("a", "demo", "--view", "house", "--travel", "close", "--from", FROM_S, "--to", TO_S),
                              ("b", "kinetic", "--view", "house", "--from", FLIGHT_FROM_S, "--to", FLIGHT_TO_S)):
        subprocess.run([PROGRAM, "render", work / show, "-o", work / f"{name}.png", "--live", "--fps", str(FPS), "--size", SIZE, *map(str, more)],
                       check=True)
    return [Image.open(name).convert("RGB") for name in sorted(work.glob("[ab]-*.png"))]


def main():
    with tempfile.TemporaryDirectory() as folder:
        frames = frames_of(pathlib.Path(folder))
    assert len(frames) == (TO_S - FROM_S + FLIGHT_TO_S - FLIGHT_FROM_S) * FPS, len(frames)
    for quality in (80, 65, 50, 35, 20):
        frames[0].save(FILM, save_all=True, append_images=frames[1:], duration=1000 // FPS, loop=0, quality=quality, method=4)
        if FILM.stat().st_size < LARGEST_BYTES:
            print(f"{FILM}: {len(frames)} frames, quality {quality}, {FILM.stat().st_size} bytes")
            return
    sys.exit(f"{FILM}: {FILM.stat().st_size} bytes, more than {LARGEST_BYTES} at the lowest quality")


if __name__ == "__main__":
    main()

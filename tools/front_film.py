#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The film on the front page, docs/images/demo.webp: the demo's recording from a camera that travels from the house to the band,
below 3 MB. Usage: front_film.py BUILD_FOLDER. Needs python3-pil; minutes without a GPU."""
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
FROM_S, TO_S = 16, 36  # of the recording


def frames_of(work):
    shutil.copytree(SOURCE / "assets/demo", work / "demo", ignore=shutil.ignore_patterns(".ghost"))
    shutil.copytree(SOURCE / "assets/fixtures", work / "fixtures")
    subprocess.run([PROGRAM, "render", work / "demo", "-o", work / "f.png", "--live", "--view", "house", "--travel", "close",
                    "--from", str(FROM_S), "--to", str(TO_S), "--fps", str(FPS), "--size", "400x225"], check=True)
    return [Image.open(name).convert("RGB") for name in sorted(work.glob("f-*.png"))]


def main():
    with tempfile.TemporaryDirectory() as folder:
        frames = frames_of(pathlib.Path(folder))
    assert len(frames) == (TO_S - FROM_S) * FPS, len(frames)
    for quality in (80, 65, 50, 35, 20):
        frames[0].save(FILM, save_all=True, append_images=frames[1:], duration=1000 // FPS, loop=0, quality=quality, method=4)
        if FILM.stat().st_size < LARGEST_BYTES:
            print(f"{FILM}: {len(frames)} frames, quality {quality}, {FILM.stat().st_size} bytes")
            return
    sys.exit(f"{FILM}: {FILM.stat().st_size} bytes, more than {LARGEST_BYTES} at the lowest quality")


if __name__ == "__main__":
    main()

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""LED walls as a user meets them: the picture where it belongs and not mirrored, hidden by what stands before it, the floor lit in its
colours, and what a wrong key and a missing film say. Usage: walls_test.py SOURCE_FOLDER BUILD_FOLDER."""
import subprocess
import sys
import tempfile
from pathlib import Path

from lib import pictures

SOURCE, PROGRAM = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve() / "ghostlight"


def run(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout + done.stderr


def mean(rows, x0, x1, y0, y1):
    pixels = [rows[y][x] for y in range(y0, y1) for x in range(x0, x1)]
    return [sum(p[c] for p in pixels) / len(pixels) for c in range(3)]


def show(folder, media, wall, more=""):
    (folder / "dark.show").write_text("OLA Show\n1 0,0,0\n40\n1 0,0,0\n4000\n")
    (folder / "show.toml").write_text(f"""
[show]
name = "Walls"
stage = "{SOURCE / 'assets/optics/stage.glb'}"
recording = "dark.show"
[haze]
preset = "none"
[[camera]]
name = "front"
position_m = [0, -6, 2]
target_m = [0, 5, 2]
fov_y_deg = 40
size = [160, 90]
ev100 = 9
{media}
[[fixture]]
name = "Wall"
position_m = [0, 5, 3]
wall = {{ {wall} }}
{more}
""")


with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    # Red above left, green above right, red below left, blue below right.
    pictures.write(folder / "card.png", 160, 90, lambda x, y: (255, 0, 0) if x < 80 else ((0, 255, 0) if y < 45 else (0, 0, 255)))
    media = '[[media]]\nname = "card"\nfile = "card.png"\n'
    show(folder, media, 'media = "card", size_m = [4, 2.25], nits = 1000, cells = [4, 2]')
    code, text = run("render", folder, "--live", "--map-size", "128", "--at", "0", "-o", folder / "wall.png")
    assert code == 0, text
    rows = pictures.read(folder / "wall.png")[2]
    # At 11 m 90 pixels are 8.0 m: the wall is 45 x 25 pixels about (80, 34).
    for (x, y), wanted in {(62, 27): 0, (98, 27): 1, (62, 41): 0, (98, 41): 2}.items():
        colour = rows[y][x]
        assert colour[wanted] > 60 and all(c < 0.75 * colour[wanted] for k, c in enumerate(colour) if k != wanted), f"{(x, y)} is {colour}"
    beside = rows[34][150]
    assert max(beside) < 60, f"beside the wall it is {beside}"
    # The floor before it: red to the left, blue (with green) to the right.
    left, right = mean(rows, 30, 60, 70, 88), mean(rows, 100, 130, 70, 88)
    assert left[0] > 2 and left[0] > 1.3 * left[2], f"floor to the left {left}"
    assert right[2] > 2 and right[2] > 1.3 * right[0], f"floor to the right {right}"

    # What stands before it hides it: another wall, dark, nearer to the eye.
    show(folder, media, 'media = "card", size_m = [4, 2.25], nits = 1000, cells = [4, 2]',
         '[[fixture]]\nname = "Before"\nposition_m = [-1, 3, 3]\nrotation_deg = [0, 0, 180]\nwall = { media = "card", size_m = [1, 1], nits = 1 }')
    code, text = run("render", folder, "--live", "--map-size", "128", "--at", "0", "-o", folder / "hidden.png")
    assert code == 0, text
    hidden = pictures.read(folder / "hidden.png")[2]
    assert max(hidden[31][66]) < 0.4 * max(rows[31][66]), f"{hidden[31][66]} where {rows[31][66]} was hidden"

    # Baked passes show the same wall.
    show(folder, media, 'media = "card", size_m = [4, 2.25], nits = 1000, cells = [4, 2]')
    code, text = run("bake", folder, "--spp", "4")
    assert code == 0, text
    code, text = run("render", folder, "--at", "0", "-o", folder / "baked.png")
    assert code == 0, text
    baked = pictures.read(folder / "baked.png")[2]
    for x, y in ((62, 27), (98, 27), (62, 41), (98, 41)):
        assert all(abs(a - b) <= 4 for a, b in zip(baked[y][x], rows[y][x])), f"{(x, y)}: {baked[y][x]} baked, {rows[y][x]} live"

    # A missing film and wrong keys are said; the rest is there.
    show(folder, '[[media]]\nname = "sea"\nfile = "sea.mp4"\n', 'media = "sea", size_m = [4, 0], bright = 1',
         '[[wall]]\nname = "*"\n[[media]]\nname = ""\ncard = "grid"\n')
    code, text = run("check", folder)
    for part in ("[[media]] 'sea'", "size_m", "bright", "[show] has none", "name is empty"):
        assert part in text, f"'{part}' is not in\n{text}"
    code, text = run("render", folder, "--live", "--no-shadows", "--at", "0", "-o", folder / "missing.png")
    assert "'sea'" in text, text
    magenta = sum(r > 60 and b > 40 and g < 0.5 * r for row in pictures.read(folder / "missing.png")[2] for r, g, b in row)
    assert magenta > 200, f"{magenta} magenta pixels"
print("the picture upright on the wall, live as baked, hidden by what is before it; the floor in its colours; what is wrong is said")

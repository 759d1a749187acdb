#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Projectors as a user meets them: a picture on the wall where it belongs, films that are the same each time, and what a missing
film, an empty one and a wrong key say. Usage: projectors_test.py SOURCE_FOLDER BUILD_FOLDER."""
import json
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

from lib import pictures

SOURCE, PROGRAM = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve() / "ghostlight"


def run(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout + done.stderr


def index_first(film, share):
    """An MP4 with its index (moov) before its pictures (mdat), of which this share is left: what a broken download is."""
    atoms, at = {}, 0
    while at < len(film):
        size, kind = struct.unpack(">I4s", film[at:at + 8])
        assert size >= 8, f"atom {kind} of {size} bytes"
        atoms[kind] = (at, film[at:at + size])
        at += size
    moov, moved = bytearray(atoms[b"moov"][1]), len(atoms[b"ftyp"][1]) + len(atoms[b"moov"][1]) - atoms[b"mdat"][0]
    place = moov.index(b"stco")
    count = struct.unpack(">I", moov[place + 8:place + 12])[0]
    for k in range(place + 12, place + 12 + 4 * count, 4):
        moov[k:k + 4] = struct.pack(">I", struct.unpack(">I", moov[k:k + 4])[0] + moved)
    frames = atoms[b"mdat"][1]
    return atoms[b"ftyp"][1] + bytes(moov) + frames[:int(share * len(frames))]


def show(folder, media, projector):
    (folder / "dark.show").write_text("OLA Show\n1 0,0,0\n40\n1 0,0,0\n4000\n")
    (folder / "show.toml").write_text(f"""
[show]
name = "Projectors"
stage = "{SOURCE / 'assets/optics/stage.glb'}"
recording = "dark.show"
[haze]
preset = "none"
[[camera]]
name = "front"
position_m = [0, -6, 3]
target_m = [0, 10, 3]
fov_y_deg = 30
size = [160, 90]
ev100 = 7
{media}
[[fixture]]
name = "Beamer"
position_m = [0, -4, 3]
projector = {{ {projector} }}
""")


with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    # The corners of the grid: red above left, green above right, blue below right, yellow below left.
    show(folder, '[[media]]\nname = "card"\ncard = "grid"\n',
         'media = "card", throw_ratio = 1.6, target_m = [0, 10, 3], lumens = 30000, focus_m = 14')
    code, text = run("render", folder, "--live", "--no-shadows", "--at", "0", "-o", folder / "grid.png")
    assert code == 0, text
    width, height, rows = pictures.read(folder / "grid.png")
    lit = [(x, y) for y in range(height) for x in range(width) if max(rows[y][x]) > 24]
    assert len(lit) > width * height / 20, f"only {len(lit)} pixels are lit"
    left, right = min(x for x, _ in lit), max(x for x, _ in lit)
    top, bottom = min(y for _, y in lit), max(y for _, y in lit)
    assert abs((right - left) / (bottom - top) - 16 / 9) < 0.15, f"{left}..{right} x {top}..{bottom} is not 16:9"
    inset = (right - left) // 32
    corners = [rows[y][x] for y in (top + inset, bottom - inset) for x in (left + inset, right - inset)]
    for colour, wanted in zip(corners, ((1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1))):
        high = [c > 0.6 * max(colour) for c in colour]
        assert high == [bool(w) for w in wanted], f"corners are {corners}"

    # What cannot be shown: said with its name, striped magenta, and no failure of the rest.
    (folder / "empty.mp4").write_bytes(b"")
    show(folder, '[[media]]\nname = "sea"\nfile = "sea.mp4"\n[[media]]\nname = "void"\nfile = "empty.mp4"\n',
         'media = "sea", throw_ratio = 1.6, target_m = [0, 10, 3], lumens = 30000, wobble = 1')
    code, text = run("check", folder)
    assert "[[media]] 'sea'" in text and "no such file" in text and "wobble" in text, text
    code, text = run("render", folder, "--live", "--no-shadows", "--at", "0", "-o", folder / "missing.png")
    assert "'sea'" in text and "'void'" in text, text
    _, _, rows = pictures.read(folder / "missing.png")
    magenta = sum(r > 60 and b > 40 and g < 0.5 * r for row in rows for r, g, b in row)
    assert magenta > 300, f"{magenta} magenta pixels"

    # A film made by the program itself, shown twice: the same bytes.
    show(folder, '[[media]]\nname = "card"\ncard = "bars"\n', 'throw_ratio = 1.6, target_m = [0, 10, 3]')
    code, text = run("render", folder, "--live", "--no-shadows", "--from", "0", "--to", "1", "--fps", "25", "-o", folder / "film.mp4")
    assert code == 0, text
    show(folder, '[[media]]\nname = "film"\nfile = "film.mp4"\n', 'throw_ratio = 1.6, target_m = [0, 10, 3], lumens = 30000')
    drawn = []
    for k in range(2):
        code, text = run("render", folder, "--live", "--no-shadows", "--at", "2.5", "-o", folder / f"again{k}.png")
        assert code == 0, text
        drawn.append((folder / f"again{k}.png").read_bytes())
    assert drawn[0] == drawn[1], "the same command drew two pictures"

    # A film cut in the middle: said with its name, and what is there is shown.
    (folder / "cut.mp4").write_bytes(index_first((folder / "film.mp4").read_bytes(), 0.6))
    show(folder, '[[media]]\nname = "half"\nfile = "cut.mp4"\n', 'throw_ratio = 1.6, target_m = [0, 10, 3], lumens = 30000')
    code, text = run("render", folder, "--live", "--no-shadows", "--at", "0.1", "-o", folder / "cut.png")
    assert code == 0 and "'half'" in text and "cut short" in text, text
    assert max(max(pixel) for row in pictures.read(folder / "cut.png")[2] for pixel in row) > 100, "nothing of the cut film is shown"

    # What a projector cannot do is said.
    show(folder, '[[media]]\nname = "card"\ncard = "grid"\n',
         'throw_ratio = 1.6, target_m = [0, -4, 3], select = { universe = 1, address = 3 }')
    toml = (folder / "show.toml").read_text()
    (folder / "show.toml").write_text(toml.replace('name = "Beamer"', 'name = "Beamer"\naddress = 1\nmode = "None"'))
    code, text = run("check", folder)
    for part in ("target_m is where the projector itself is", "mode is not used", "' select '"):
        assert part in text, f"'{part}' is not in\n{text}"
    show(folder, '[[media]]\nname = "film"\nfile = "film.mp4"\n', 'throw_ratio = 1.6, target_m = [0, 10, 3], lumens = 30000')

    code, text = run("explain", folder, "Beamer", "--at", "0", "--json")
    assert code == 0, text
    said = " ".join(json.loads(text[text.index("{"):])["beams"][0]["optics"])
    assert "projects 'film'" in said, said
print("a card on the wall upright and 16:9, what is missing is said and striped, films repeat, explain names the medium")

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Projectors as a user meets them: a picture on the wall where it belongs, films that are the same each time, and what a missing
film, an empty one and a wrong key say. Usage: projectors_test.py SOURCE_FOLDER BUILD_FOLDER."""
import json
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

SOURCE, PROGRAM = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve() / "ghostlight"


def run(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout + done.stderr


def png(path):
    """Width, height and rows of RGB(A)."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", data[at + 8:at + 18])
        packed += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    step, raw, rows, above = {2: 3, 6: 4}[colour], zlib.decompress(packed), [], None
    for y in range(height):
        line = bytearray(raw[y * (width * step + 1) + 1:(y + 1) * (width * step + 1)])
        above = above or bytearray(len(line))
        for x, how in ((x, raw[y * (width * step + 1)]) for x in range(len(line))):
            left, up, corner = (line[x - step] if x >= step else 0), above[x], (above[x - step] if x >= step else 0)
            near = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))[2]
            line[x] = (line[x] + (0, left, up, (left + up) // 2, near)[how]) & 255
        rows.append([tuple(line[x:x + 3]) for x in range(0, len(line), step)])
        above = line
    return width, height, rows


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
    pictures = atoms[b"mdat"][1]
    return atoms[b"ftyp"][1] + bytes(moov) + pictures[:int(share * len(pictures))]


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
    width, height, rows = png(folder / "grid.png")
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
    _, _, rows = png(folder / "missing.png")
    magenta = sum(r > 60 and b > 40 and g < 0.5 * r for row in rows for r, g, b in row)
    assert magenta > 300, f"{magenta} magenta pixels"

    # A film made by the program itself, shown twice: the same bytes.
    show(folder, '[[media]]\nname = "card"\ncard = "bars"\n', 'throw_ratio = 1.6, target_m = [0, 10, 3]')
    code, text = run("render", folder, "--live", "--no-shadows", "--from", "0", "--to", "1", "--fps", "25", "-o", folder / "film.mp4")
    assert code == 0, text
    show(folder, '[[media]]\nname = "film"\nfile = "film.mp4"\n', 'throw_ratio = 1.6, target_m = [0, 10, 3], lumens = 30000')
    pictures = []
    for k in range(2):
        code, text = run("render", folder, "--live", "--no-shadows", "--at", "2.5", "-o", folder / f"again{k}.png")
        assert code == 0, text
        pictures.append((folder / f"again{k}.png").read_bytes())
    assert pictures[0] == pictures[1], "the same command drew two pictures"

    # A film cut in the middle: said with its name, and what is there is shown.
    (folder / "cut.mp4").write_bytes(index_first((folder / "film.mp4").read_bytes(), 0.6))
    show(folder, '[[media]]\nname = "half"\nfile = "cut.mp4"\n', 'throw_ratio = 1.6, target_m = [0, 10, 3], lumens = 30000')
    code, text = run("render", folder, "--live", "--no-shadows", "--at", "0.1", "-o", folder / "cut.png")
    assert code == 0 and "'half'" in text and "cut short" in text, text
    assert max(max(pixel) for row in png(folder / "cut.png")[2] for pixel in row) > 100, "nothing of the cut film is shown"

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

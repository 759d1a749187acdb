#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The contact sheet of a fixture file: every channel of the profile with all optics changes the picture, the sheet has the
size that its lines need, and what cannot be drawn is said. Usage: channel_sheet_test.py SOURCE_FOLDER BUILD_FOLDER."""
import subprocess
import sys
import tempfile
from pathlib import Path

from lib import pictures

SOURCE, PROGRAM = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve() / "ghostlight"
PROFILE = SOURCE / "assets/fixtures/Ghostlight@Optics_Profile.gdtf"


def sheet(*arguments):
    done = subprocess.run([PROGRAM, "sheet", *map(str, arguments)], capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout + done.stderr


with tempfile.TemporaryDirectory() as name:
    out = Path(name) / "sheet.png"
    code, text = sheet(PROFILE, "-o", out, "--size", "64x48")
    assert code == 0, text
    assert "changes nothing" not in text, text
    assert "25 channels" in text, text
    width, height, rows = pictures.read(out)
    assert width == 4 + 8 * 68, width
    # The first line is the dimmer: dark, then brighter from picture to picture.
    means = [sum(sum(pixel) for row in rows[19:55] for pixel in row[4 + 68 * k:68 + 68 * k]) for k in range(5)]
    assert means == sorted(means) and means[-1] > 3 * means[0], means

    code, text = sheet(PROFILE, "-o", out, "--mode", "Standart")
    assert code == 1 and "Standard" in text, text
    code, text = sheet(PROFILE, "-o", out, "--view", "top")
    assert code == 1 and "top" in text and "side" in text, text
    code, text = sheet(SOURCE / "assets/demo", "-o", out, "--mode", "Standard")
    assert code == 2 and "--mode" in text, text
    (Path(name) / "broken.gdtf").write_bytes(b"no archive")
    code, text = sheet(Path(name) / "broken.gdtf", "-o", out)
    assert code == 1 and "broken.gdtf" in text, text
print("every channel of the profile with all optics changes its pictures; wrong modes, views and files are said")

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Names that hold escapes, controls and bytes that are no UTF-8 do not reach a terminal, whatever prints them. Usage: terminal_test.py
SOURCE_FOLDER BUILD_FOLDER."""
import json
import pathlib
import subprocess
import sys
import tempfile

PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
EVIL = "\x1b]0;owned\x07\x1b[2J\x9b31m\x7f\r\x08"
CONTROLS = {chr(code) for code in [*range(32), *range(127, 160)] if chr(code) not in "\n\t"}


def check(folder):
    fixture = folder / "evil.json"
    fixture.write_text(json.dumps({"name": EVIL, "physical": {"dimensions": [EVIL]}, "availableChannels": {EVIL: {"capability": {"type": EVIL}}},
                                   "modes": [{"name": EVIL, "channels": [EVIL, EVIL + "gone"]}]}), encoding="utf-8")
    show = folder / "show"
    show.mkdir()
    key = "".join(f"\\u{ord(letter):04x}" for letter in EVIL)
    (show / "show.toml").write_text(f'[show]\nname = "{key}"\nstage = "{key}.glb"\n"{key}" = 1\n[[camera]]\nname = "{key}"\n'
                                    f'[[fixture]]\nname = "{key}"\ngdtf = "{key}.gdtf"\n', encoding="utf-8")
    commands = [["check", "--all", fixture], ["check", "--json", fixture], ["check", "--all", show], ["check", "--json", show],
                ["explain", show, "--fixture", EVIL], ["bake", show], [*["check"], folder / EVIL.replace("/", "")]]
    faults, said = [], 0
    for command in commands:
        done = subprocess.run([PROGRAM, *map(str, command)], capture_output=True, timeout=60)
        for name, data in (("stdout", done.stdout), ("stderr", done.stderr)):
            text = data.decode("utf-8", errors="surrogateescape")
            said += text.count("\\u001b")
            bad = {f"{ord(letter):#04x}" for letter in text if letter in CONTROLS or 0xDC80 <= ord(letter) <= 0xDCFF}
            if bad:
                faults.append(f"{command[0]}, {name}: {sorted(bad)}: {data[:200]!r}")
        if "--json" in command:
            json.loads(done.stdout)
    return faults, said


with tempfile.TemporaryDirectory() as at:
    found, shown = check(pathlib.Path(at))
print(f"{shown} escapes were shown instead of sent, {len(found)} faults")
for line in found:
    print(line)
sys.exit(1 if found or not shown else 0)

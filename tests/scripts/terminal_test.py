#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Names that hold escapes, controls and bytes that are no UTF-8 do not reach a terminal, whatever prints them, and no name begins a line
of its own. Usage: terminal_test.py SOURCE_FOLDER BUILD_FOLDER."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
FORGED = "forged: all is well"
EVIL = f"\x1b]0;owned\x07\x1b[2J\x9b31m\x7f\r\x08\n{FORGED}\n\t{FORGED}"
PORTS = ["--sacn-port", "25572", "--artnet-port", "26458"]
CONTROLS = {chr(code) for code in [*range(32), *range(127, 160)] if chr(code) not in "\n\t"}


def mvr(path, name, x_mm):
    """XML has no escapes; it has line breaks and C1."""
    evil = f"{name}&#10;{FORGED}&#10;&#x9b;31m"
    at = f"<Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{x_mm},0,3000}}</Matrix>"
    rows = "".join(f'<Fixture uuid="8BF13DD7-CBF4-415B-99E4-{k:012d}" name="{evil}">{at}<GDTFSpec>{evil}.gdtf</GDTFSpec><GDTFMode>{evil}</GDTFMode>'
                   f'<Addresses><Address break="0">{evil}</Address></Addresses><FixtureID>{evil}</FixtureID></Fixture>' for k in (1, 2))
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("GeneralSceneDescription.xml", '<GeneralSceneDescription verMajor="1" verMinor="6"><Scene><Layers>'
                         f'<Layer name="{evil}" uuid="{evil}"><ChildList>{rows}</ChildList></Layer></Layers></Scene></GeneralSceneDescription>')
    return path


def check(folder):
    fixture = folder / "evil.json"
    fixture.write_text(json.dumps({"name": EVIL, "physical": {"dimensions": [EVIL]}, "availableChannels": {EVIL: {"capability": {"type": EVIL}}},
                                   "modes": [{"name": EVIL, "channels": [EVIL, EVIL + "gone"]}]}), encoding="utf-8")
    show = folder / EVIL.replace("/", "")
    show.mkdir()
    shutil.copy(fixture, show / "lamp.json")
    key = "".join(f"\\u{ord(letter):04x}" for letter in EVIL)
    (show / "show.toml").write_text(f'[show]\nname = "{key}"\nstage = "{key}.glb"\n"{key}" = 1\n[[camera]]\nname = "{key}"\n'
                                    '[[fixture]]\nname = "Lamp"\ngdtf = "lamp.json"\naddress = 1\n'
                                    f'[[fixture]]\nname = "{key}"\ngdtf = "{key}.json"\n', encoding="utf-8")
    plots = [mvr(folder / f"{k}{EVIL}.mvr", f"Lamp {k}", k) for k in (1, 2)]
    imported = folder / f"imported {EVIL}"
    listen = ["--interface", "127.0.0.1", "--seconds", "1", *PORTS]
    commands = [["check", "--all", fixture], ["check", "--json", fixture], ["check", "--all", show], ["check", "--json", show],
                ["check", "--summary", fixture, show, *plots], ["check", "--summary", "--all", fixture, show, *plots],
                ["check", folder / f"{EVIL} gone"],
                ["explain", show, "Lamp"], ["explain", show, "--all"], ["explain", show, EVIL], ["explain", show, "Lamp", "--json"], ["bake", show],
                ["import", plots[0], "-o", imported], ["import", plots[1], "-o", imported], ["import", plots[1], "-o", imported, "--json"],
                ["check", "--all", imported], ["explain", imported, "--all"], ["explain", imported, "*"],
                ["monitor", "--show", show, *listen], ["monitor", "--show", imported, *listen],
                ["render", show, "-o", folder / f"{EVIL}.png"], ["export", imported, "-o", folder / f"{EVIL}.mvr"]]
    faults, said = [], 0
    for command in commands:
        done = subprocess.run([PROGRAM, *map(str, command)], capture_output=True, timeout=60)
        for name, data in (("stdout", done.stdout), ("stderr", done.stderr)):
            text = data.decode("utf-8", errors="surrogateescape")
            said += text.count("\\u001b")
            bad = {f"{ord(letter):#04x}" for letter in text if letter in CONTROLS or 0xDC80 <= ord(letter) <= 0xDCFF}
            if bad:
                faults.append(f"{command[0]}, {name}: {sorted(bad)}: {data[:200]!r}")
            faults += [f"{command[0]}, {name}: a name has a line of its own: {text[:600]!r}" for line in text.splitlines() if line.strip().startswith(FORGED)][:1]
        if "--json" in command and not done.stdout:
            faults.append(f"{command[0]} --json printed nothing: {done.stderr!r}")
        elif "--json" in command:
            json.loads(done.stdout)
    return faults, said


with tempfile.TemporaryDirectory() as at:
    found, shown = check(pathlib.Path(at))
print(f"{shown} escapes were shown instead of sent, {len(found)} faults")
for line in found:
    print(line)
sys.exit(1 if found or not shown else 0)

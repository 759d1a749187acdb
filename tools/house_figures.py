#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Counts what a change of the house is measured by, for docs/measurements/house.md: how full folders are, how far headers reach, how long
files are, how many libraries and members of Engine there are.

Usage: house_figures.py [SOURCE_ROOT]: any checkout of this project, old ones as well.
"""
import re
import sys
from collections import Counter
from pathlib import Path

root = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
sources = [file for file in sorted((root / "src").rglob("*")) if file.suffix in (".cpp", ".h")]
if not sources:
    sys.exit(f"{root}: has no src/ with sources, expected a checkout")
text = {file.relative_to(root / "src").as_posix(): file.read_text(encoding="utf-8") for file in sources}
shared = {file.relative_to(root / "shaders").as_posix(): file.read_text(encoding="utf-8") for file in (root / "shaders").rglob("*.h")}
includes = {name: re.findall(r'^\s*#\s*include\s*"([^"]+)"', content, re.M) for name, content in (text | shared).items()}


def reached_by(header):
    """The .cpp files that include it, directly or not."""
    users = {name: [] for name in includes}
    for name, those in includes.items():
        for other in those:
            users.setdefault(other, []).append(name)
    found, todo = set(), [header]
    while todo:
        for name in users.get(todo.pop(), []):
            if name not in found:
                found.add(name)
                todo.append(name)
    return sum(name.endswith(".cpp") for name in found)


def members(header):
    """Of the last class of a header: declarations that end in a name with a _, or in such a name with a value."""
    body = re.sub(r"//.*", "", text[header])
    return len(re.findall(r"^    (?!static)[^()\n]*?\b\w+_(?:\{[^;]*\}|(?: = [^;]*))?(?:, \w+_(?:\{[^;]*\}|(?: = [^;]*))?)*;", body, re.M))


def file_named(name):
    return next((file for file in text if Path(file).name == name), None)


folders = Counter(Path(name).parent.as_posix() for name in text)
folder, most = folders.most_common(1)[0]
cpp = sum(name.endswith(".cpp") for name in text)
lines = {name: content.count("\n") for name, content in text.items()}
longest = max(lines, key=lines.get)
cmake = "".join((root / name).read_text(encoding="utf-8") for name in ("CMakeLists.txt", "src/CMakeLists.txt") if (root / name).is_file())
print(f"folders with sources: {len(folders)}, the fullest: src/{folder} with {most} files")
print(f"libraries: {len(re.findall(r'^(?:ghost_room|ghost_library|add_library)[(]', cmake, re.M))}")
print(f"lines: {sum(lines.values())} in {len(text)} files, the longest: src/{longest} with {lines[longest]}")
for name in ("show.h", "beam.h"):
    header = file_named(name) if name != "beam.h" else "shared/beam.h"
    print(f".cpp that reach {header}: {reached_by(header)} of {cpp}")
print(f"members of Engine: {members(file_named('engine.h'))}")

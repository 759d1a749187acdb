#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Counts what a change of the house is measured by, for docs/measurements/house.md: how full folders are, how far headers reach, how long
files are, how many libraries and members of Engine there are; with --build also what it takes to build the program from nothing and after one
file was touched.

Usage: house_figures.py [SOURCE_ROOT] [--build [WHAT...]]: any checkout of this project, old ones as well. --build makes build/figures there by
preset release, without the cache of compilers, and takes many minutes; WHAT: clean, or ends of the paths of files to touch.
"""
import argparse
import os
import re
import resource
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

TOUCHED = ["show.h", "shared/beam.h", "look_panel.cpp"]  # what a show is; a header for C++ and shaders; one panel

parser = argparse.ArgumentParser()
parser.add_argument("root", nargs="?", default=".")
parser.add_argument("--build", nargs="*", metavar="WHAT")
arguments = parser.parse_args()
root = Path(arguments.root)
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
    reached = [name for name in found if name.endswith(".cpp")]
    return f"{len(reached)} of {cpp}, in {len({Path(name).parent for name in reached})} folders"


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
    print(f".cpp that reach {header}: {reached_by(header)}")
print(f"members of Engine: {members(file_named('engine.h'))}")


def built(what):
    """Prints how long the program takes to build now."""
    before, begin_s = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    steps = subprocess.run(["ninja", "-C", build, "ghostlight"], env=quiet, capture_output=True, text=True)
    if steps.returncode:
        sys.exit(steps.stdout[-2000:] + steps.stderr)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor_s = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    done = re.findall(r"^\[(\d+)/", steps.stdout, re.M)
    print(f"{what}: {processor_s:.0f} s of processor, {time.monotonic() - begin_s:.0f} s by the clock, {done[-1] if done else 0} steps "
          f"(load {os.getloadavg()[0]:.1f}, {os.cpu_count()} cores)", flush=True)


if arguments.build is not None:
    build, quiet = root / "build/figures", {**os.environ, "CCACHE_DISABLE": "1"}
    wanted = arguments.build or ["clean", *TOUCHED]
    subprocess.run(["cmake", "-S", root, "--preset", "release", "-B", build], cwd=root, check=True, stdout=subprocess.DEVNULL)
    if "clean" in wanted:
        subprocess.run(["ninja", "-C", build, "clean"], check=True, stdout=subprocess.DEVNULL)
    built("clean build" if "clean" in wanted else "what was not built yet")
    for name in wanted:
        if name == "clean":
            continue
        files = [file for top in ("src", "shaders") for file in (root / top).rglob(Path(name).name) if file.as_posix().endswith("/" + name)]
        if not files:
            sys.exit(f"{name}: no such file")
        files[0].touch()
        built(f"after touching {files[0].relative_to(root)}")

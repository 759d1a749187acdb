#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The installed libraries are of use to others: a project outside of the tree finds them, prints the modes of a fixture and merges two sACN
sources. Usage: install_test.py SOURCE_FOLDER BUILD_FOLDER."""
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SPOT = SOURCE / "assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, (words, done.stdout, done.stderr)
    return done.stdout


with tempfile.TemporaryDirectory(prefix="ghost-install-") as folder:
    work = pathlib.Path(folder)
    cache = (BUILD / "CMakeCache.txt").read_text(encoding="utf-8")
    compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.M)[1]
    run("cmake", "--install", BUILD, "--component", "dev", "--prefix", work / "installed")
    headers = list((work / "installed/include/ghostlight").rglob("*.h"))
    assert len(headers) > 100, headers
    for file in (work / "installed/lib").rglob("*.cmake"):
        assert str(SOURCE) not in file.read_text(encoding="utf-8"), f"{file} names the source tree"
    # CMake's own files must not lie under the source, or its headers might be found there.
    run("cmake", "-G", "Ninja", "-S", SOURCE / "tests/foreign", "-B", work / "build", f"-DCMAKE_PREFIX_PATH={work / 'installed'}",
        f"-DCMAKE_CXX_COMPILER={compiler}")
    run("cmake", "--build", work / "build")
    modes = run(work / "build/modes", SPOT)
    assert re.search(r"^.+: [1-9][0-9]* channels$", modes, re.M), modes
    print(modes, end="")
    merged = run(work / "build/merge")
    assert merged.split() == ["255", "200", "30"], merged
    print("merged:", merged, end="")

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A show in a read-only place, as one that a package installs: bake, still and check work for an ordinary user, and what they keep lies in the
user's cache. Usage: read_only_test.py SOURCE_FOLDER BUILD_FOLDER."""
import os
import pathlib
import shutil
import stat
import subprocess
import sys
import tempfile

SOURCE, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
NOBODY = 65534

work = pathlib.Path(tempfile.mkdtemp(prefix="ghost-read-only-", dir="/tmp"))
work.chmod(0o755)
home = work / "home"
home.mkdir()
user = {}
if os.geteuid() == 0:  # to root nothing is read-only
    os.chown(home, NOBODY, NOBODY)
    user = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
    shutil.copy2(BUILD / "ghostlight", work / "ghostlight")  # the build may lie where others cannot go
    program = work / "ghostlight"
else:
    program = BUILD / "ghostlight"
show = work / "demo"
shutil.copytree(SOURCE / "assets/demo", show, ignore=shutil.ignore_patterns(".ghost"))
shutil.copytree(SOURCE / "assets/fixtures", work / "fixtures")
for path in [show, *show.rglob("*")]:
    path.chmod(path.stat().st_mode & ~(stat.S_IWUSR | stat.S_IWGRP | stat.S_IWOTH) | stat.S_IROTH | (stat.S_IXOTH if path.is_dir() else 0))
environment = {**os.environ, "HOME": str(home), "XDG_CACHE_HOME": str(home / "cache"), "XDG_RUNTIME_DIR": str(home)}


def run(*words):
    done = subprocess.run([program, *words], env=environment, cwd=home, capture_output=True, text=True, timeout=300, **user)
    assert done.returncode == 0, (words, done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


try:
    run("render", show, "-o", home / "still.png", "--size", "64x36", "--at", "36")
    again = run("render", show, "-o", home / "again.png", "--size", "64x36", "--at", "36")
    assert (home / "still.png").read_bytes() == (home / "again.png").read_bytes()
    assert "baking" not in again, again
    run("render", show, "-o", home / "live.png", "--live", "--size", "64x36", "--at", "36", "--map-size", "64")
    assert not (show / ".ghost").exists()
    caches = [path for path in (home / "cache/ghostlight").iterdir() if path.name != "pipelines"]   # which are of no show
    assert len(caches) == 1, caches
    assert list(caches[0].glob("passes/*/manifest.json")) and (caches[0] / "distances/64/stage.json").exists(), list(caches[0].rglob("*"))
    print("kept in the user's cache:", sum(1 for path in caches[0].rglob("*") if path.is_file()), "files")
finally:
    for path in [show, *show.rglob("*")]:
        path.chmod(path.stat().st_mode | stat.S_IWUSR)
    shutil.rmtree(work)

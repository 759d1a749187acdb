#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Bakes and films on a real Slurm of two nodes, all on this machine, without root and systemd: a task that fails
and is made again; passes and films have the bytes of those made by one program.
Usage: farm_slurm_test.py SOURCE_FOLDER BUILD_FOLDER. Skips where Slurm is not installed (packages slurm-wlm, munge)."""
import os
import pathlib
import shutil
import signal
import sys
import tempfile
import time

SOURCE, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
from farm import FILM, Ghostlight, ends, files_of, plan_of, small_show, started, wait_for_pictures  # noqa: E402  (the folder is known only now)
from slurm import Cluster  # noqa: E402


def bakes(ghost, work):
    one, cut = small_show(SOURCE, work / "one"), small_show(SOURCE, work / "cut")
    ghost.run("bake", one, "--spp", "4")
    begun = time.monotonic()
    ghost.run("bake", cut, "--spp", "4", "--farm", "slurm", says="6 tasks given to Slurm")
    expected, found = files_of(one / ".ghost/passes"), files_of(cut / ".ghost/passes")
    assert expected == found, [name for name in expected.keys() | found.keys() if expected.get(name) != found.get(name)]
    hosts = {path.read_text().split('"host":"')[1][:2] for path in (plan_of(cut) / "done").glob("[0-9]*.json")}
    print(f"bake: 6 tasks on {sorted(hosts)} in {time.monotonic() - begun:.1f} s, the same bytes")
    return cut


def a_task_fails(ghost, work, show):
    watching, plan = started(ghost, show, "cut.mp4", "--farm", "slurm")
    wait_for_pictures(plan, 2)
    for process in pathlib.Path("/proc").iterdir():
        try:
            words = (process / "cmdline").read_bytes().split(b"\0") if process.name.isdigit() else []
        except OSError:
            continue
        # Of this show alone: other tests have farms of their own.
        if str(show).encode() in words and b"render" in words and b"240-479" in words and b"--quiet" in words:
            os.kill(int(process.name), signal.SIGKILL)
    assert "farm retry" in ends(watching, 1, "1 failed")
    assert not (work / "cut.mp4").exists()
    ghost.run("farm", "status", show, code=1, says="first failure: frames 240 to 479: exit code 137")
    assert ghost.run("farm", "tasks", show).split() == ["2"]
    ghost.run("farm", "retry", show, says="1 tasks given to Slurm")
    assert (work / "cut.mp4").read_bytes() == (work / "whole.mp4").read_bytes()
    print("a task that fails: said, made again alone, the same film")


work = pathlib.Path(tempfile.mkdtemp(prefix="ghost-slurm-"))
cluster = Cluster(work / "cluster")
try:
    cluster.up()
    ghost = Ghostlight(BUILD / "ghostlight", cluster.environment, work)
    show = bakes(ghost, work)
    ghost.run("render", show, "-o", "whole.mp4", *FILM)
    a_task_fails(ghost, work, show)
finally:
    cluster.down()
    shutil.rmtree(work, ignore_errors=True)

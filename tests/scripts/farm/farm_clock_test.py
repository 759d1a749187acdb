#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A farm whose clocks are an hour off. A node of Slurm: it is left out, and its neighbour makes the film. The program itself, an hour
ahead and an hour behind in turn: bakes and films have the same bytes, and the newest plan is the one that was asked for last.
Usage: farm_clock_test.py SOURCE_FOLDER BUILD_FOLDER. Skips where packages are missing: slurm-wlm, munge, faketime."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SOURCE, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import needs  # noqa: E402  (the folder is known only now)
from farm import FILM, Ghostlight, files_of, plan_of, small_show, wait_until  # noqa: E402
from slurm import Cluster  # noqa: E402

needs.packages("faketime")
LIBRARY = subprocess.run(["faketime", "-f", "+1h", "printenv", "LD_PRELOAD"], capture_output=True, text=True, check=True).stdout.strip()


def clock(offset):
    """Of programs alone: a shared disk tells the same times to all."""
    return {"LD_PRELOAD": LIBRARY, "FAKETIME": offset, "NO_FAKE_STAT": "1"}


def a_node_of_slurm(ghost, cluster, show, whole):
    os.kill(cluster.pid("slurmd.n2"), 9)
    configuration = (cluster.folder / "slurm.conf").read_text()
    skewed = cluster.folder / "skewed.conf"
    skewed.write_text(configuration.replace("munge.socket", "ahead.socket"))
    cluster.start_munge("ahead", **clock("+1h"))
    cluster.start_node("n2", **clock("+1h"), SLURM_CONF=str(skewed))
    ghost.run("render", show, "-o", "ahead.mp4", *FILM, "--farm", "slurm")
    assert whole == (ghost.folder / "ahead.mp4").read_bytes()
    hosts = {path.read_text().split('"host":"')[1][:2] for path in (plan_of(show) / "done").glob("[0-9]*.json")}
    log = (cluster.folder / "log/slurmctld.log").read_text() + (cluster.folder / "log/slurmd.n2.log").read_text()
    wait_until(lambda: cluster.states()["n2"].startswith("down"), 60, "Slurm leaves n2 out")
    assert "credential" in log and hosts == {"n1"}, (hosts, log)
    print("a node whose clock is an hour ahead: Slurm leaves it out, the other one makes the film, the same bytes")


def tasks_in_turn(ghost, plan, environments):
    """As many as are missing, each by another clock; then what they made is put together by the first."""
    for task in ghost.run("farm", "tasks", plan).split():
        environment = environments[int(task) % len(environments)]
        Ghostlight(ghost.program, {**ghost.environment, **environment}, ghost.folder).run("farm", "run", plan, task)
    Ghostlight(ghost.program, {**ghost.environment, **environments[0]}, ghost.folder).run("farm", "assemble", plan)


def programs(ghost, show, whole, baked):
    ahead, behind = clock("+1h"), clock("-1h")
    # Planned only: there is no Slurm in this PATH.
    planner = {"PATH": str(ghost.folder / "nowhere")}
    late = Ghostlight(ghost.program, {**ghost.environment, **planner, **ahead}, ghost.folder)
    right = Ghostlight(ghost.program, {**ghost.environment, **planner}, ghost.folder)
    late.run("render", show, "-o", "first.mp4", *FILM, "--farm", "slurm", code=1, says="Slurm is not here")
    os.utime(plan_of(show) / "plan.json", (2e9, 2e9))  # as it is where the disk takes the time of who writes
    right.run("render", show, "-o", "second.mp4", *FILM, "--farm", "slurm", code=1, says="Slurm is not here")
    right.run("farm", "status", show, code=1, says="second.mp4: 0 of 4 tasks done")
    tasks_in_turn(ghost, plan_of(show), [ahead, behind, {}])
    assert whole == (ghost.folder / "second.mp4").read_bytes()
    right.run("farm", "status", show, says="4 of 4 tasks done, all put together")
    cut = small_show(SOURCE, ghost.folder / "cut")
    right.run("bake", cut, "--view", "house", "--spp", "4", "--farm", "slurm", code=1, says="Slurm is not here")
    tasks_in_turn(ghost, plan_of(cut), [behind, ahead, {}])
    assert files_of(cut / ".ghost/passes") == baked
    print("programs an hour ahead and an hour behind: the same bake and film, and the newest plan is the last one")


work = pathlib.Path(tempfile.mkdtemp(prefix="ghost-clock-"))
cluster = Cluster(work / "cluster")
try:
    cluster.up()
    ghost = Ghostlight(BUILD / "ghostlight", cluster.environment, work)
    show = small_show(SOURCE, work / "show")
    ghost.run("bake", show, "--view", "house", "--spp", "4")
    baked = files_of(show / ".ghost/passes")
    ghost.run("render", show, "-o", "whole.mp4", *FILM)
    whole = (work / "whole.mp4").read_bytes()
    programs(ghost, show, whole, baked)
    a_node_of_slurm(ghost, cluster, show, whole)
finally:
    cluster.down()
    shutil.rmtree(work, ignore_errors=True)

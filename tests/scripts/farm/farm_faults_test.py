#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What goes wrong on a real Slurm of two nodes while a film is made: a node that dies, a controller that dies and comes back or does
not, a partition that does not exist, two submissions at once, a show that is edited. Each ends in a sentence and an exit code, and
what is made in the end has the bytes of a film that nobody disturbed.
Usage: farm_faults_test.py SOURCE_FOLDER BUILD_FOLDER. Skips where Slurm is not installed (packages slurm-wlm, munge)."""
import pathlib
import shutil
import sys
import tempfile
import time

SOURCE, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
from farm import FILM, Ghostlight, ends, plan_of, small_show, started, wait_for_pictures, wait_until  # noqa: E402  (the folder is known only now)
from slurm import Cluster  # noqa: E402


def errors_of(said):
    return [line for line in said.splitlines() if line.startswith("error: ")]


def a_wrong_partition(ghost, cluster, show):
    said = ghost.run("render", show, "-o", "part.mp4", *FILM, "--farm", "slurm", "--farm-options", "--partition=nowhere", code=1,
                     says="Slurm says: invalid partition specified: nowhere")
    assert len(errors_of(said)) == 1, said
    assert not cluster.jobs() and not (plan_of(show) / "submitted.json").exists(), cluster.jobs()
    ghost.run("farm", "status", show, code=1, says="0 of 4 tasks done")
    ghost.run("farm", "retry", show, code=1, says="was given to no farm; start the command again")
    print("a wrong partition: Slurm's sentence, exit code 1, nothing is submitted")


def a_node_dies(ghost, cluster, show, whole):
    watching, plan = started(ghost, show, "killed.mp4", "--farm", "slurm")
    wait_for_pictures(plan, 2)
    victim = next(line.split()[2] for line in cluster.jobs("R") if line.startswith("2 "))
    other = {"n1": "n2", "n2": "n1"}[victim]
    done_before = {path.name: path.read_bytes() for path in (plan / "done").iterdir()}
    begun = time.monotonic()
    count = cluster.kill_node(victim)
    assert count >= 4, f"only {count} processes: its daemon, a step, a task and what draws are four"
    assert "2.json" not in done_before
    ghost.run("farm", "status", show, code=1, says="of 4 tasks done")
    wait_until(lambda: cluster.states()[victim].startswith("down"), 60, f"{victim} is down")
    ends(watching, 0, "done, 4 tasks")
    assert whole == (ghost.folder / "killed.mp4").read_bytes()
    assert all((plan / "done" / name).read_bytes() == content for name, content in done_before.items())
    assert f'"host":"{other}"' in (plan / "done/2.json").read_text()
    assert cluster.restarts() == 1, f"one task was lost, {cluster.restarts()} were begun anew"
    print(f"{victim} dies in the middle of a film: one task was made again on {other}, the same film {time.monotonic() - begun:.0f} s later")
    cluster.start_node(victim)
    cluster.wait_for_idle()


def the_controller_dies(ghost, cluster, show, whole):
    watching, plan = started(ghost, show, "dead.mp4", "--farm", "slurm")
    wait_for_pictures(plan, 2)
    # Both have to have seen Slurm before it dies: this one, which began later, says so.
    impatient = ghost.start("--progress-every", "0.2", "farm", "wait", show, "--patience", "5")
    line = impatient.stdout.readline()
    assert "of 4 tasks done" in line, line
    cluster.kill_controller()
    said = ghost.run("farm", "status", show, code=1, says="of 4 tasks done")
    assert "Slurm says: slurm_load_jobs error: Unable to contact slurm controller" in said, said
    assert len(errors_of(ends(impatient, 1, "and Slurm does not answer any more"))) == 1
    for command in (["farm", "wait", show], ["farm", "retry", show], ["farm", "cancel", show]):
        assert len(errors_of(ghost.run(*command, code=1, says="Slurm says: "))) == 1, command
    wait_until((plan / "done/2.json").exists, 120, "task 2 ends without a controller")
    assert not (ghost.folder / "dead.mp4").exists() and watching.poll() is None
    cluster.start_controller()
    # It may have forgotten what it was given last; what it began last is held back then, and the node is drained.
    said = watching.communicate(timeout=600)[0]
    if watching.returncode != 0:
        assert "and nobody does more" in said and "farm retry" in said, said
        for node, state in cluster.states().items():
            if state.startswith("dr"):
                cluster.do("scontrol", "update", f"nodename={node}", "state=resume")
        ghost.run("farm", "retry", show)
    assert whole == (ghost.folder / "dead.mp4").read_bytes()
    print("the controller dies: one sentence each for those who ask; tasks end without it; once it is back, the same film")
    cluster.wait_for_idle()


def two_submissions(ghost, cluster, show, whole):
    # Nothing runs for longer than the second one waits where it believes that nobody works.
    words = ["render", show, "-o", "twice.mp4", *FILM, "--farm", "slurm", "--farm-options", "--begin=now+20"]
    both = [ghost.start(*words) for _ in range(2)]
    said = [ends(one, 0, "done, 4 tasks") for one in both]
    assert sum("tasks given to Slurm" in text for text in said) == 1 and sum("; following it" in text for text in said) == 1, said
    assert whole == (ghost.folder / "twice.mp4").read_bytes()
    logs = {path.stem.split("_")[0] for path in (plan_of(show) / "log").iterdir()}
    assert len(logs) in (2, 3), logs  # the first frame, the blocks, and putting together, whose log may not be there yet
    print("two submissions at once: one farm, one film, both end well")
    cluster.wait_for_idle()


def an_edit_in_the_middle(ghost, cluster, show, whole):
    watching, plan = started(ghost, show, "edited.mp4", "--farm", "slurm")
    wait_for_pictures(plan, 2)
    toml = show / "show.toml"
    before = toml.read_text(encoding="utf-8")
    assert "\nev100 = 6.0\n" in before
    toml.write_text(before.replace("\nev100 = 6.0\n", "\nev100 = 9.0\n"), encoding="utf-8")
    sentence = "the show was changed since the plan was made"
    ends(watching, 1, sentence)
    assert not (ghost.folder / "edited.mp4").exists() and not (plan / "done/2.json").exists()
    assert not list((plan / "frames").glob("2.*")), "what a task drew while the show was edited"
    for command in ("retry", "assemble"):
        ghost.run("farm", command, show, code=1, says=sentence)
    ghost.run("farm", "status", show, code=1, says=sentence)
    toml.write_text(before, encoding="utf-8")
    both = [ghost.start("farm", "retry", show) for _ in range(2)]
    for one in both:
        ends(one, 0, "edited.mp4: ")
    assert whole == (ghost.folder / "edited.mp4").read_bytes()
    print("a show that is edited in the middle: said, no film; put back, and tried again twice at once, the same film")
    cluster.wait_for_idle()


work = pathlib.Path(tempfile.mkdtemp(prefix="ghost-faults-"))
cluster = Cluster(work / "cluster")
try:
    cluster.up()
    ghost = Ghostlight(BUILD / "ghostlight", cluster.environment, work)
    show = small_show(SOURCE, work / "show")
    ghost.run("bake", show, "--view", "house", "--spp", "4")
    ghost.run("render", show, "-o", "whole.mp4", *FILM)
    whole = (work / "whole.mp4").read_bytes()
    a_wrong_partition(ghost, cluster, show)
    a_node_dies(ghost, cluster, show, whole)
    the_controller_dies(ghost, cluster, show, whole)
    two_submissions(ghost, cluster, show, whole)
    an_edit_in_the_middle(ghost, cluster, show, whole)
finally:
    cluster.down()
    shutil.rmtree(work, ignore_errors=True)

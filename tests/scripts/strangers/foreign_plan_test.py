#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A show from elsewhere that brings a farm's plan: it names a command, where its film goes, and options of an engine. Nothing of it is
done unless --trust says so; what this user made goes on without. Usage: foreign_plan_test.py SOURCE_FOLDER BUILD_FOLDER."""
import json
import os
import pathlib
import shutil
import signal
import sys
import tempfile

SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
from farm import Ghostlight, plan_of, wait_until  # noqa: E402  (the folder is known only now)
from tiny_show import tiny_show  # noqa: E402

FOREIGN = "you did not make this plan here"
# What stands in for Slurm writes down what it was asked for.
ENGINE = """#!/bin/sh
echo "$(basename $0) $@" >> {log}
[ "$(basename $0)" = sbatch ] && echo 7
exit 0
"""


def edited(file, **values):
    """What was in it before."""
    before = file.read_text()
    file.write_text(json.dumps({**json.loads(before), **values}))
    return before


def main(work):
    log, engine = work / "asked.txt", work / "engine"
    log.touch()
    engine.mkdir()
    for name in ("sbatch", "squeue", "scancel", "scontrol"):
        (engine / name).write_text(ENGINE.format(log=log))
        (engine / name).chmod(0o755)
    ghost = Ghostlight(BUILD / "ghostlight", {**os.environ, "PATH": f"{engine}:{os.environ['PATH']}"}, work)
    show, out = tiny_show(SOURCE, work / "show"), work / "letter.png"
    ghost.run("render", show, "-o", "film.png", "--live", "--from", "0", "--to", "0.1", "--farm", "local")
    plan = plan_of(show)
    film = sorted(path.name for path in work.glob("film-*.png"))
    assert len(film) == 3, film
    for name in film:
        (work / name).unlink()
    ghost.run("farm", "retry", show)  # what this user made is made again
    assert sorted(path.name for path in work.glob("film-*.png")) == film
    print("what this user gave to the farm goes on")

    # As it came with a show: the same folder, and somebody who did not make it.
    stranger = Ghostlight(ghost.program, {**ghost.environment, "XDG_STATE_HOME": str(work / "another")}, work)
    (work / film[0]).unlink()
    for words in (["retry", show], ["run", plan, "1"], ["assemble", plan]):
        said = stranger.run("farm", *words, code=1, says=FOREIGN)
        assert "film.png" in said, said
    stranger.run("farm", "status", show, code=1)  # to look is allowed
    assert not (work / film[0]).exists()
    stranger.run("farm", "retry", show, "--trust")
    assert (work / film[0]).exists()
    print("what another one made is done with --trust, and only then")

    # Of ours, with a word changed.
    (work / film[0]).unlink()
    before = edited(plan / "plan.json", out=str(out))
    for words in (["retry", show], ["run", plan, "1"], ["assemble", plan]):
        ghost.run("farm", *words, code=1, says=str(out))
    assert not list(work.glob("letter*"))
    (plan / "plan.json").write_text(before)
    before = edited(plan / "submitted.json", engine="slurm", options="--export=LD_PRELOAD=evil.so", jobs=["7", "--me"])
    log.write_text("")
    ghost.run("farm", "retry", show, code=1, says="--export=LD_PRELOAD=evil.so")
    ghost.run("farm", "cancel", show, code=1, says="you did not give it to this farm here")
    assert log.read_text() == "", log.read_text()
    ghost.run("farm", "cancel", show, "--trust")
    assert log.read_text() == "scancel 7\n", log.read_text()  # numbers only
    (plan / "submitted.json").write_text(before)
    ghost.run("farm", "retry", show)
    print("another place for the film, options of sbatch, words in place of jobs: a sentence each, and nobody is asked")

    # Links that came with it: who only looks, and a task that fails before it has begun, write nothing behind them.
    (work / film[0]).unlink()
    theirs = work / "theirs"
    shutil.copytree(plan, theirs)
    (theirs / "submitting").write_text("a letter")
    aside = plan.rename(work / "aside")
    plan.symlink_to(theirs)
    for word in ("status", "wait"):
        ghost.run("farm", word, show, code=1)
        assert (theirs / "submitting").read_text() == "a letter", word
    plan.unlink()
    aside.rename(plan)
    (theirs / "1.txt").write_text("a letter")
    shutil.rmtree(plan / "failed")
    (plan / "failed").symlink_to(theirs)
    (plan / "done/1.json").unlink()
    toml = (show / "show.toml").read_text()
    (show / "show.toml").write_text(toml.replace("Tiny", "Other"))
    ghost.run("farm", "run", plan, "1", code=1, says="is a link")
    assert (theirs / "1.txt").read_text() == "a letter"
    (show / "show.toml").write_text(toml)
    print("a plan's folder and what is in it as links: nothing is written behind them")

    # What is started for this user needs no note where it runs: a node may have another home.
    log.write_text("")
    watching = ghost.start("bake", show, "--spp", "1", "--farm", "slurm")
    wait_until(lambda: "farm assemble" in log.read_text(), 60, "all is submitted")
    watching.send_signal(signal.SIGINT)
    watching.communicate(timeout=60)
    asked = [line for line in log.read_text().splitlines() if line.startswith("sbatch")]
    assert asked and all("--trust" in line for line in asked), asked
    planted = plan_of(show) / "log" / "7_0.txt"
    planted.symlink_to(work / "diary.txt")
    ghost.run("farm", "retry", show, code=1, says="nothing is written there")
    assert log.read_text().count("sbatch") == len(asked)
    print("jobs of Slurm are trusted by who submits them; their logs go through no link")


scratch = pathlib.Path(tempfile.mkdtemp(prefix="ghost-foreign-plan-"))
try:
    main(scratch)
finally:
    shutil.rmtree(scratch)

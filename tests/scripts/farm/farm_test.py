#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A bake and films cut into tasks on this machine: the bytes of what is not cut, whoever is interrupted, and one sentence where it cannot be.
Usage: farm_test.py SOURCE_FOLDER BUILD_FOLDER."""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import zlib

SOURCE, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import full_disk  # noqa: E402  (the folder is known only now)
from farm import FILM, Ghostlight, files_of, numbered, plan_of, small_show  # noqa: E402  (the folder is known only now)

work = pathlib.Path(tempfile.mkdtemp(prefix="ghost-farm-"))
SIZE = (32, 16)
ghost = Ghostlight(BUILD / "ghostlight", dict(os.environ), work)


def bakes():
    one, cut = small_show(SOURCE, work / "one", SIZE), small_show(SOURCE, work / "cut", SIZE)
    ghost.run("bake", one, "--spp", "4")
    said = ghost.run("bake", cut, "--spp", "4", "--farm", "local", "--farm-jobs", "2")
    assert "6 tasks" in said, said  # three cameras: surroundings with eight lights, and the other two
    expected, found = files_of(one / ".ghost/passes"), files_of(cut / ".ghost/passes")
    assert expected.keys() == found.keys(), (expected.keys() ^ found.keys())
    other = [name for name in expected if expected[name] != found[name]]
    assert not other, other
    ghost.run("bake", cut, "--spp", "4", "--farm", "local", says="0 passes baked")
    # A first part of which a picture is lost makes that one again, and no other.
    shutil.rmtree(cut / ".ghost/passes")
    ghost.run("bake", cut, "--spp", "4", "--view", "house", "--surroundings", says="9 passes baked")
    lights = sorted((cut / ".ghost/passes").glob("house/**/*Wash*.exr"))
    lost = next(path for path in lights if "extra" not in path.name)
    lost.unlink()
    ghost.run("bake", cut, "--spp", "4", "--view", "house", "--surroundings", says="1 passes baked")
    ghost.run("bake", cut, "--spp", "4", "--view", "house", "--lights", "8-9", says="2 passes baked")
    ghost.run("bake", cut, "--spp", "4", "--view", "house", says="0 passes baked")
    found = files_of(cut / ".ghost/passes/house")
    assert found and all(expected["house/" + name] == bytes for name, bytes in found.items()), found.keys()
    print(f"a bake of 6 tasks: {len(expected)} files, the same bytes")
    return one


def films(show):
    ghost.run("render", show, "-o", "whole.png", *FILM)
    ghost.run("render", show, "-o", "whole.mp4", *FILM)
    whole = numbered(work, "whole")
    assert len(whole) == 480, len(whole)
    # A part, numbered as in the film from its first second on.
    ghost.run("render", show, "-o", "part.png", *FILM, "--frames", "480-500")
    assert (work / "part-00480.png").exists() and numbered(work, "part") == whole[300:321]
    ghost.run("render", show, "-o", "cut.png", *FILM, "--farm", "local", "--farm-jobs", "2", says="4 tasks")
    assert numbered(work, "cut") == whole
    # Of however many pictures the note says as much.
    assert (plan_of(show) / "done/result.json").stat().st_size < 300
    ghost.run("farm", "status", show, says="4 of 4 tasks done, all put together")
    ghost.run("render", show, "-o", "cut.mp4", *FILM, "--farm", "local")
    assert (work / "cut.mp4").read_bytes() == (work / "whole.mp4").read_bytes()
    plan = plan_of(show)
    assert not list((plan / "frames").iterdir())
    ghost.run("render", show, "-o", "cut.mp4", *FILM, "--farm", "local", says="is done already")
    ghost.run("farm", "status", show, says="4 of 4 tasks done, all put together")
    assert ghost.run("farm", "tasks", show) == ""
    (work / "cut.mp4").unlink()  # then it is to be made again
    ghost.run("farm", "status", show, code=1)
    ghost.run("farm", "retry", show)
    assert (work / "cut.mp4").read_bytes() == (work / "whole.mp4").read_bytes()
    ghost.run("render", show, "-o", "part.mp4", *FILM, "--frames", "480-500")
    assert 0 < (work / "part.mp4").stat().st_size < (work / "whole.mp4").stat().st_size
    print("a film of 4 tasks: 480 pictures and the film, the same bytes")


def the_longest_film(show):
    """A plan has 20,000 tasks: the first picture, and 19,999 pieces of 240. Planned only, on a machine without Slurm."""
    words = ["render", show, "-o", "long.mp4", "--view", "house", "--fps", "30", "--farm", "slurm", "--to"]
    bare = Ghostlight(ghost.program, {**ghost.environment, "PATH": str(work / "nothing")}, work)
    end_s = 19_999 * 240 / 30
    bare.run(*words, end_s, code=1, says="Slurm is not here")
    tasks = ghost.run("farm", "tasks", plan_of(show)).split()
    assert len(tasks) == 20_000, len(tasks)
    said = bare.run(*words, end_s + 0.1, code=1)
    assert "long.mp4: 20001 tasks are more than the 20000 of one plan; give it in parts" in said, said
    print("a film of 20,000 tasks is planned, one of 20,001 is refused")


def free_cameras(show):
    for name, words in {"free": ["--live", "--view", "close"], "fly": ["--view", "house", "--travel", "close"]}.items():
        # Smaller ones have more edges than room for them, and which are left out is chance.
        words = [*words, "--from", "7.6", "--to", "8.4", "--size", "192x108", "--map-size", "64"]
        ghost.run("render", show, "-o", name + ".png", *words)
        ghost.run("render", show, "-o", name + "cut.png", *words, "--farm", "local", says="3 tasks")
        assert numbered(work, name + "cut") == numbered(work, name) and len(numbered(work, name)) == 24, name
    print("films of a free camera, standing and flying: the same bytes")


def a_block_knows_nothing():
    """Of what was drawn before it: a lamp's table on the device kept what another one had left there at frame 1080, and the pictures are large
    enough to show it."""
    show = small_show(SOURCE, work / "larger", (256, 144))
    words = ["render", show, "--view", "house", "--from", "0", "--to", "41", "--frames"]
    ghost.run(*words, "1080-1203", "-o", "after.png")
    ghost.run(*words, "1200-1203", "-o", "alone.png")
    after, alone = numbered(work, "after"), numbered(work, "alone")
    assert len(alone) == 4 and after[-4:] == alone
    print("a block of frames: the same bytes, whatever was drawn before")


def a_show_that_lacks_something(show):
    """Drawn as without a farm: the film is there, and the exit code says that it is not all of the show."""
    poor = work / "poor/show"
    shutil.copytree(show, poor, ignore=shutil.ignore_patterns("farm"))
    shutil.copytree(work / "fixtures", poor.parent / "fixtures", ignore=shutil.ignore_patterns("*VL2500_Wash*"))
    words, said = ["render", poor, "--view", "house", "--from", "6", "--to", "9"], "made, but something that the show asks for is missing"
    ghost.run(*words, "-o", "poor.mp4", code=1, says=said)
    ghost.run(*words, "-o", "poorcut.mp4", "--farm", "local", code=1, says=said)
    assert (work / "poor.mp4").read_bytes() == (work / "poorcut.mp4").read_bytes()
    for word in ("wait", "assemble"):
        ghost.run("farm", word, poor, code=1, says=said)
    ghost.run(*words, "-o", "poorcut.mp4", "--farm", "local", code=1, says="is done already")
    ghost.run("bake", poor, "--view", "close", "--spp", "3", code=1, says=said)
    expected = files_of(poor / ".ghost/passes")
    shutil.rmtree(poor / ".ghost/passes")
    ghost.run("bake", poor, "--view", "close", "--spp", "3", "--farm", "local", code=1, says=said)
    found = files_of(poor / ".ghost/passes")
    assert found and all(found[name] == expected[name] for name in found), found.keys() ^ expected.keys()
    print("a show that lacks a fixture's file: the same film, the same passes, and the same exit code")


def a_camera_without_lights():
    show = small_show(SOURCE, work / "dark", SIZE)
    toml = show / "show.toml"
    toml.write_text(re.sub(r"^\[\[fixture\]\].*?(?=^\[|\Z)", "", toml.read_text(encoding="utf-8"), flags=re.M | re.S), encoding="utf-8")
    assert "[[fixture]]" not in toml.read_text(encoding="utf-8")
    ghost.run("bake", show, "--view", "house", "--spp", "4", "--farm", "local", says="1 tasks")
    dark = files_of(show / ".ghost/passes")
    assert "house/manifest.json" in dark, dark.keys()
    shutil.rmtree(show / ".ghost/passes")
    ghost.run("bake", show, "--view", "house", "--spp", "4")
    assert files_of(show / ".ghost/passes").items() >= {name: bytes for name, bytes in dark.items() if name.endswith(".exr") or "manifest" in name}.items()
    print("a camera without lights: its manifest is there")


def from_a_rough_start(show):
    """Whoever starts the program ignores its children's ends, or has odd words."""
    words = [str(ghost.program), "render", "-o", "rough.mp4", "--view", "house", "--from", "6", "--to", "9", "--threads", "1", "--farm", "local", "--", show.name]
    done = subprocess.run(words, cwd=show.parent, env=ghost.environment, timeout=300, preexec_fn=lambda: signal.signal(signal.SIGCHLD, signal.SIG_IGN))
    assert done.returncode == 0
    (show.parent / "rough.mp4").unlink()
    plan = plan_of(show)
    (plan / "done/result.json").unlink()
    for name in ("1.json", "2.json"):
        (plan / "done" / name).unlink()
    on_slurm = Ghostlight(ghost.program, {**ghost.environment, "SLURM_CPUS_PER_TASK": "1"}, work)
    on_slurm.run("farm", "run", plan, "1")
    on_slurm.run("farm", "run", plan, "2")
    # What one task left is not taken for what another did.
    one, two = (plan / f"done/{task}.json" for task in (1, 2))
    swapped = one.read_bytes(), two.read_bytes()
    one.write_bytes(swapped[1])
    two.write_bytes(swapped[0])
    assert ghost.run("farm", "tasks", plan).split() == ["1", "2"]
    one.write_bytes(swapped[0])
    two.write_bytes(swapped[1])
    # A part that is whole and no part: named with its node, and made again.
    part = next((plan / "frames").glob("2.*/part.mp4"))
    text = two.read_text(encoding="utf-8")
    other = (work / "whole.mp4").read_bytes()
    part.write_bytes(other)
    two.write_text(text.replace(re.search(r'"part.mp4":(\[[0-9,]+\])', text)[1], f"[{len(other)},{zlib.crc32(other)}]"), encoding="utf-8")
    ghost.run("farm", "assemble", plan, code=1, says="(made on ")
    assert ghost.run("farm", "tasks", plan).split() == ["2"]
    ghost.run("farm", "run", plan, "2")
    ghost.run("farm", "assemble", plan)
    ghost.run("render", show, "-o", "smooth.mp4", "--view", "house", "--from", "6", "--to", "9")
    assert (work / "smooth.mp4").read_bytes() == (show.parent / "rough.mp4").read_bytes()
    ghost.run("bake", show, "--view", "house", "--lights", "10-20", code=1, says="camera 'house' has 10 lights, the first is 0")
    print("ends of children ignored, names behind --, threads said twice, parts of others: the same film")


def tasks_by_hand(show):
    """As GNU parallel does, on an engine that is none; with what may go wrong in between."""
    words = ["render", show, "-o", "hand.mp4", *FILM]
    first = ghost.start(*words, "--farm", "local")
    second = ghost.start(*words, "--farm", "local")
    said = first.communicate()[0], second.communicate()[0]
    assert first.returncode == 0 and second.returncode == 0, said
    assert (work / "hand.mp4").read_bytes() == (work / "whole.mp4").read_bytes()
    print("two submissions at once: one film, both end well")
    (work / "hand.mp4").unlink()
    plan = plan_of(show)
    (plan / "done/result.json").unlink()
    assert ghost.run("farm", "tasks", plan).split() == ["1", "2", "3"]  # pictures are gone, maps and passes are not
    if full_disk.is_possible():
        words = full_disk.command(plan / "frames", [ghost.program, "farm", "run", plan, "1"])
        said = Ghostlight(words[0], ghost.environment, work).run(*words[1:], code=1)
        assert "No space left on device" in said, said
    assert "1" in ghost.run("farm", "tasks", plan).split() and not list((plan / "frames").iterdir())
    for task in "231":
        ghost.run("farm", "run", plan, task)
    ghost.run("farm", "run", plan, "1", says="is done already")
    damaged = next(path for path in (plan / "frames").iterdir() if path.name.startswith("2.")) / "part.mp4"
    bytes_before = damaged.read_bytes()
    damaged.write_bytes(bytes_before[:-1] + bytes([bytes_before[-1] ^ 1]))
    ghost.run("farm", "assemble", plan, code=1, says="is not what its task wrote")
    assert not (work / "hand.mp4").exists()
    assert ghost.run("farm", "tasks", plan).split() == ["2"]
    ghost.run("farm", "assemble", plan, code=1, says="frames 240 to 479")
    ghost.run("farm", "run", plan, "2")
    ghost.run("farm", "assemble", plan)
    assert (work / "hand.mp4").read_bytes() == (work / "whole.mp4").read_bytes()
    print("tasks by hand, a full disk and a damaged picture: never a mixed or half film")


def baked_anew(show):
    """In the middle of a film, with other samples."""
    words = ["render", show, "-o", "anew.mp4", *FILM, "--farm"]
    bare = Ghostlight(ghost.program, {**ghost.environment, "PATH": str(work / "fresh")}, work)
    bare.run(*words, "slurm", code=1, says="Slurm is not here")  # planned only
    plan = plan_of(show)
    for task in "01":
        ghost.run("farm", "run", plan, task)
    ghost.run("bake", show, "--view", "house", "--spp", "5")
    ghost.run("farm", "run", plan, "2", code=1, says="camera 'house' was baked anew since the film was begun")
    assert not list((plan / "frames").glob("2.*"))
    ghost.run("farm", "assemble", plan, code=1, says="2 of 4 tasks are missing")
    ghost.run("render", show, "-o", "other.mp4", *FILM)
    for _ in range(2):
        said = ghost.run(*words, "local")
        assert (work / "anew.mp4").read_bytes() == (work / "other.mp4").read_bytes() != (work / "whole.mp4").read_bytes()
    assert "is done already" in said, said
    ghost.run("bake", show, "--view", "house", "--spp", "4")
    ghost.run(*words, "local", says="4 tasks")
    assert (work / "anew.mp4").read_bytes() == (work / "whole.mp4").read_bytes()
    print("passes that are baked anew in the middle: said, and the same command begins anew")


def what_cannot_be(show):
    (work / "hand.mp4").unlink()
    plan = plan_of(show)
    (plan / "done/result.json").unlink()
    other = work / "other"
    shutil.copy2(BUILD / "ghostlight", other)
    with other.open("ab") as file:
        file.write(b"x")
    Ghostlight(other, ghost.environment, work).run("farm", "run", plan, "1", code=1, says="is another build")
    recording = show / "demo.show"
    before = recording.stat()
    os.utime(recording, ns=(before.st_atime_ns, before.st_mtime_ns + 1))
    ghost.run("farm", "run", plan, "1", code=1, says="was changed since the plan was made")
    ghost.run("farm", "assemble", plan, code=1, says="was changed since the plan was made")
    os.utime(recording, ns=(before.st_atime_ns, before.st_mtime_ns))
    aside = recording.rename(work / "aside.show")
    ghost.run("farm", "run", plan, "1", code=1, says=f"{recording}: ")  # names the file that is not there
    aside.rename(recording)
    restarted = Ghostlight(ghost.program, {**ghost.environment, "SLURM_RESTART_COUNT": "3"}, work)
    restarted.run("farm", "run", plan, "1", code=1, says="its node was lost 3 times")
    ghost.run("farm", "run", plan, "4", code=1, says="has 4 tasks")
    ghost.run("farm", "status", work / "nowhere", code=1, says="no such show")
    ghost.run("farm", "status", small_show(SOURCE, work / "fresh"), code=1, says="nothing of it was given to a farm")
    shutil.rmtree(plan / "frames")
    (plan / "frames").symlink_to(work / "fresh")
    ghost.run("farm", "run", plan, "1", code=1, says="is a link")
    (plan / "frames").unlink()
    theirs = work / "theirs"
    theirs.mkdir()
    (theirs / "7.txt").write_text("a letter")
    for name in ("failed", "done"):
        (plan / name).rename(work / "aside")
        (plan / name).symlink_to(theirs)
        ghost.run("farm", "retry", show, code=1, says="is a link")
        assert (theirs / "7.txt").read_text() == "a letter", "removed behind a link"
        (plan / name).unlink()
        (work / "aside").rename(plan / name)
    for words in (["--at", "6"], ["--from", "6"], ["--live-input", "--seconds", "1"], [*FILM, "--hold-fps", "10", "--live"]):
        ghost.run("render", show, "-o", "no.png", *words, "--farm", "local", code=2, says="--farm: a farm draws a film")
    ghost.run("render", show, "-o", "no.png", *FILM, "--frames", "0-100", code=1, says="the film has the frames 180 to 659")
    ghost.run("render", show, "-o", "no.png", *FILM, "--frames", "9-x", code=2, says="--frames")
    ghost.run("bake", show, "--view", "house", "--lights", "8-9", "--spp", "3", code=1, says="surroundings of camera 'house' are not baked")
    bare = Ghostlight(ghost.program, {**ghost.environment, "PATH": str(work / "fresh")}, work)
    bare.run("render", show, "-o", "no.mp4", *FILM, "--farm", "slurm", code=1, says="Slurm is not here")
    (plan / "plan.json").write_text('{"version": 1, "words": 7}')
    ghost.run("farm", "run", plan, "1", code=1, says="is no plan")
    (show / ".ghost/farm/newest").write_text("../../elsewhere")
    ghost.run("farm", "status", show, code=1, says="is not the name of a plan")
    print("another build, an edited show, links, wrong words: a sentence and an exit code each")


try:
    baked = bakes()
    films(baked)
    the_longest_film(baked)
    free_cameras(baked)
    a_block_knows_nothing()
    a_show_that_lacks_something(baked)
    a_camera_without_lights()
    from_a_rough_start(baked)
    tasks_by_hand(baked)
    baked_anew(baked)
    what_cannot_be(baked)
finally:
    shutil.rmtree(work)

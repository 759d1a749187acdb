#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A show from elsewhere whose .ghost holds links: whatever the commands write or clean there, at each level and for each file in turn a
link to somebody else's files, and these stay as they were. The paths are not listed here but found: what a first, clean run leaves.
Usage: links_test.py SOURCE_FOLDER BUILD_FOLDER."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
from tiny_show import tiny_show  # noqa: E402  (the folder is known only now)

PLOT = """<GeneralSceneDescription verMajor="1" verMinor="6"><Scene><Layers><Layer name="L" uuid="1"><ChildList>
<VideoScreen uuid="8BF13DD7-CBF4-415B-99E4-625FE4100001" name="Screen"><Geometries><Geometry3D fileName="sail.glb"/></Geometries>
<Sources><Source type="File">film.mp4</Source></Sources></VideoScreen></ChildList></Layer></Layers></Scene></GeneralSceneDescription>"""
WINDOW = ["wait opened", 'select "Par"', 'rename "Other"', "wait 1.5", "quit anyway"]
# What a run leaves on its way; and what a stranger's name may hold that a cleaner looks for.
PASSING = re.compile(r"\.part\d+_|/frames/|^look-")
DECOYS = ["holiday.exr", "letter.txt", "0123abcd-film.mp4", "1.json", "1.txt", ".old.part999999999_0.exr"]
OURS = b"somebody else's\n"
# Known to be there: the clean run did all that it should.
LEAST = {"draft.toml", "window.lock", "passes/house", "media", "plot.mvr/media.txt", "farm/newest", "farm/PLAN/plan.json",
         "farm/PLAN/done", "farm/PLAN/failed", "farm/PLAN/log", "farm/PLAN/submitted.json", "farm/PLAN/submitting", "distances", "bounce/room.bin"}


class Run:
    def __init__(self, work):
        self.work, self.show, self.others = work, work / "show", work / "others"
        self.environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "XDG_CONFIG_HOME": str(work / "config"), "XDG_STATE_HOME": str(work / "state"),
                            "XDG_DATA_HOME": str(work / "data"), "XDG_RUNTIME_DIR": str(work)}
        self.source = tiny_show(SOURCE, work / "source")
        with zipfile.ZipFile(self.source / "plot.mvr", "w") as archive:
            archive.writestr("GeneralSceneDescription.xml", PLOT)
            archive.writestr("film.mp4", "a film")
            archive.write(SOURCE / "assets/optics/stage.glb", "sail.glb")
        (work / "script").write_text("\n".join(WINDOW) + "\n")

    def fresh(self):
        for folder in (self.show, self.others, self.work / "state", self.work / "data"):
            shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.source, self.show)
        self.others.mkdir()

    def commands(self, depth=0):
        """All that writes into .ghost or cleans there; what the window writes lies at its top, and what a picture needs, three folders deep."""
        said = ""
        for deepest, words in ((9, ["bake", self.show, "--spp", "1", "--farm", "local"]), (9, ["bake", self.show, "--spp", "1"]),
                               (3, ["render", self.show, "--live", "--bounce", "room", "--at", "1", "-o", self.work / "a.png"]), (2, ["check", self.show / "plot.mvr"]),
                               (9, ["farm", "status", self.show]), (9, ["farm", "retry", self.show]),
                               (1, ["open", self.show, "--forget", "--size", "320x200", "--script", self.work / "script"])):
            if depth > deepest:
                continue
            done = subprocess.run([str(PROGRAM), *map(str, words)], env=self.environment, cwd=self.work, capture_output=True, text=True, timeout=120)
            assert done.returncode in (0, 1), (words, done.returncode, done.stderr)
            said += done.stdout + done.stderr
        return said

    def left(self):
        """Paths below .ghost, and whether each is a folder."""
        ghost = self.show / ".ghost"
        found = {path.relative_to(ghost).as_posix(): path.is_dir() for path in ghost.rglob("*")}
        return {name: is_folder for name, is_folder in found.items() if not PASSING.search(name)}


def contents(folder):
    return {path.relative_to(folder).as_posix(): path.read_bytes() if path.is_file() else None for path in sorted(folder.rglob("*"))}


def plant(run, place, known, number):
    """A link in the place of what a clean run left there, to somebody else's files of the same names, and more."""
    other, link = run.others / str(number), run.show / ".ghost" / place if place else run.show / ".ghost"
    link.parent.mkdir(parents=True, exist_ok=True)
    if not known.get(place, True):
        other.write_bytes(OURS)
    else:
        below = {name[len(place) + 1 if place else 0:]: is_folder for name, is_folder in known.items() if not place or name.startswith(place + "/")}
        for folder in ["", *(name for name, is_folder in below.items() if is_folder)]:
            (other / folder).mkdir(parents=True, exist_ok=True)
            for name in DECOYS:
                (other / folder / name).write_bytes(OURS)
                os.utime(other / folder / name, (1, 1))
        for name, is_folder in below.items():
            if not is_folder:
                (other / name).write_bytes(OURS)
    link.symlink_to(other)


def main(work):
    run = Run(work)
    run.fresh()
    said = run.commands()
    # The draft goes with the window, a lock with who has it, and a part of the links of bounced light with the whole.
    known = {**run.left(), "draft.toml": False, "window.lock": False, "bounce/room.near-0.part": False}
    assert "farm/newest" in known, said
    plan = (run.show / ".ghost/farm/newest").read_text()
    known[f"farm/{plan}/submitting"] = False
    missing = {name.replace("PLAN", plan) for name in LEAST} - known.keys()
    assert not missing, (missing, sorted(known), said)
    places = ["", *sorted(known)]
    tried = 0
    for depth in range(max(name.count("/") + 1 for name in known) + 1):
        here = [place for place in places if (place.count("/") + 1 if place else 0) == depth]
        run.fresh()
        for number, place in enumerate(here):
            plant(run, place, known, number)
        before = contents(run.others)
        said = run.commands(depth)
        after = contents(run.others)
        changed = [f"{here[int(name.split('/')[0])]}: {name}" for name in before.keys() | after.keys() if before.get(name) != after.get(name)]
        assert not changed, (changed, said[-3000:])
        for place in here:
            if known.get(place, True) and "passes" in place:
                assert f"{run.show}/.ghost{'/' if place else ''}{place}: is a link" in said, (place, said)
        tried += len(here)
        print(f"level {depth}: {len(here)} links, nothing behind them was written or removed", flush=True)
    assert tried > 30, tried


scratch = pathlib.Path(tempfile.mkdtemp(prefix="ghost-links-"))
try:
    main(scratch)
finally:
    shutil.rmtree(scratch)

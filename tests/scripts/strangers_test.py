#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Many files that mean harm or were damaged on their way, made from real ones by cuts, flipped bits and swapped members, through check,
import and a still: no crash, nothing over 10 s of the processor, and nothing changed outside of where the command writes (compared by hash).
Usage: strangers_test.py SOURCE_FOLDER BUILD_FOLDER [COUNT [SEED]]. COUNT: files, 40 as a test; 5000 takes about an hour. With ../shared
beside the checkout its fixtures and plots are used, too. A file that fails is kept under BUILD_FOLDER/strangers."""
import hashlib
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import zipfile

SOURCE = pathlib.Path(sys.argv[1]).resolve()
BUILD = pathlib.Path(sys.argv[2]).resolve()
COUNT = int(sys.argv[3]) if len(sys.argv) > 3 else 40
SEED = int(sys.argv[4]) if len(sys.argv) > 4 else 24
sys.path.insert(0, str(SOURCE / "tools"))
from fuzz_seeds import variants  # noqa: E402  (the folder is known only now)

LONGEST_S = 10  # of the processor
PATIENCE_S = 120  # by the clock: the machine may be busy with other tests
LARGEST = 4_000_000  # bytes
STILL_EVERY = 10  # of the shows and plots: a picture takes as long as fifty checks
OWN = {".gdtf", ".qxf", ".mvr", ".toml", ".glb", ".show", ".json"}
CONTROLS = {byte for byte in range(32) if chr(byte) not in "\n\t"} | {127}


def hashes(folder):
    return {path.relative_to(folder).as_posix(): "-> " + os.readlink(path) if path.is_symlink() else hashlib.sha256(path.read_bytes()).hexdigest()
            for path in folder.rglob("*") if path.is_symlink() or path.is_file()}


def processor_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def plot(path):
    """Of the project's own fixtures."""
    spot = SOURCE / "assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"
    fixtures = "".join(f'<Fixture uuid="{k}" name="Spot {k}"><Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{k}000,0,6000}}</Matrix><GDTFSpec>{spot.name}</GDTFSpec>'
                       f"<Addresses><Address>{40 * k}</Address></Addresses></Fixture>" for k in range(1, 5))
    deck = '<SceneObject uuid="9" name="Deck"><Geometries><Geometry3D fileName="stage.glb"/></Geometries></SceneObject>'
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("GeneralSceneDescription.xml", '<GeneralSceneDescription verMajor="1" verMinor="6"><Scene><Layers><Layer name="L" uuid="a">'
                         f"<ChildList>{fixtures}{deck}</ChildList></Layer></Layers></Scene></GeneralSceneDescription>")
        archive.write(spot, spot.name)
        archive.write(SOURCE / "assets/optics/stage.glb", "stage.glb")
    return path


class Trial:
    def __init__(self, work):
        self.work, self.case, self.faults, self.runs, self.slowest_s = work, work / "case", [], 0, 0.0
        self.beside = [work / "cwd", work / "neighbour"]
        for folder in self.beside:
            folder.mkdir()
            for name in ("a.obj", "stage.glb", "show.toml", "plot.mvr", "texture.png"):  # what a file may name without a path
                (folder / name).write_text(f"ours, in {folder.name}", encoding="utf-8")
        self.before = [hashes(folder) for folder in self.beside]

    def run(self, given, *arguments):
        rc = None
        before_s = processor_s()
        try:
            done = subprocess.run([BUILD / "ghostlight", *map(str, arguments)], cwd=self.work / "cwd", capture_output=True, timeout=PATIENCE_S, check=False,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (LONGEST_S, LONGEST_S)))
            rc = done.returncode
            if any(byte in CONTROLS for byte in done.stdout + done.stderr):
                self.fault(given, arguments, "a control character reached the terminal")
        except subprocess.TimeoutExpired:
            self.fault(given, arguments, f"not over after {PATIENCE_S} s")
        self.runs += 1
        self.slowest_s = max(self.slowest_s, processor_s() - before_s)
        if rc is not None and rc not in (0, 1):
            self.fault(given, arguments, f"ended with {rc}: {done.stderr[-300:]!r}")
        for folder, before in zip(self.beside, self.before):
            if hashes(folder) != before:
                self.fault(given, arguments, f"{folder.name} is not what it was")

    def fault(self, given, arguments, what):
        kept = BUILD / "strangers" / f"{len(self.faults)}{given.suffix}"
        kept.parent.mkdir(exist_ok=True)
        shutil.copy(given, kept)
        self.faults.append(f"{' '.join(map(str, arguments))}: {what}; kept as {kept}")

    def file(self, seed, data, still):
        """One file as a stranger sends it: alone, or in the place of its real one in a show."""
        shutil.rmtree(self.case, ignore_errors=True)
        self.case.mkdir()
        is_show = seed.suffix in (".toml", ".glb", ".show") and (seed.parent / "show.toml").exists()
        if is_show:
            for path in seed.parent.iterdir():
                if path.is_file() and path.stat().st_size <= LARGEST:
                    shutil.copy(path, self.case)
        given = self.case / seed.name
        given.write_bytes(data)
        sent = hashes(self.case)
        target = self.case if is_show else given
        self.run(given, "check", "--quiet", target)
        if {name: value for name, value in hashes(self.case).items() if not name.startswith(".ghost/")} != sent:
            self.fault(given, ["check"], "the files that were checked are not what they were")
        if seed.suffix == ".mvr":
            self.run(given, "import", given, "-o", self.work / "out" / "show", "--quiet")
            shutil.rmtree(self.work / "out", ignore_errors=True)
        if still:
            self.run(given, "render", target, "--live", "--no-shadows", "--size", "64x36", "--at", "0", "-o", self.work / "still.png", "--quiet")


def main():
    chance = random.Random(SEED)
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        own = sorted(path for path in (SOURCE / "assets").rglob("*") if path.suffix in OWN and path.stat().st_size <= LARGEST)
        shared = SOURCE.parent / "shared/fixtures"
        given = sorted(path for path in shared.rglob("*") if path.suffix in OWN and path.is_file() and path.stat().st_size <= LARGEST) if shared.is_dir() else []
        seeds = [plot(work / "plot.mvr")] + own
        trial = Trial(work)
        made = shown = 0
        while made < COUNT:
            seed = chance.choice(given if given and chance.random() < 0.5 else seeds)
            data = chance.choice(list(variants(seed.read_bytes() or b"\0", chance)))
            can_show = seed.suffix == ".mvr" or (seed.parent / "show.toml").exists()
            shown += can_show
            trial.file(seed, data, can_show and shown % STILL_EVERY == 1)
            made += 1
        print(f"{made} files of {len(seeds) + len(given)} real ones, {trial.runs} runs, the longest {trial.slowest_s:.1f} s of the processor, {len(trial.faults)} faults")
        for fault in trial.faults[:20]:
            print(fault)
        return 1 if trial.faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What a farm costs beside the work itself: a bake of 100 passes and a film of 2,000 frames on a Slurm of two nodes of one core each, all
on this machine, against the ideal: half of what one program takes on one core.
Usage: measure_farm.py BUILD_FOLDER [bake|film] [WIDTHxHEIGHT]. Needs slurm-wlm and munge, two cores that do nothing else, and half an hour."""
import pathlib
import re
import shutil
import sys
import tempfile
import time

SOURCE = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
from farm import Ghostlight, plan_of  # noqa: E402  (the folder is known only now)
from slurm import Cluster  # noqa: E402

CAMERAS = 10  # of ten lights each
SAMPLES = 16
FRAMES, FPS = 2000, 30
FARM = ["--farm", "slurm", "--farm-options", "--cpus-per-task=1", "--quiet"]


def large_show(folder, size):
    """The demo with ten cameras, an arm's length from each other."""
    shutil.copytree(SOURCE / "assets/demo", folder, ignore=shutil.ignore_patterns(".ghost"))
    shutil.copytree(SOURCE / "assets/fixtures", folder.parent / "fixtures")
    toml = folder / "show.toml"
    text = toml.read_text(encoding="utf-8")
    cameras = re.findall(r"^\[\[camera\]\].*?(?=^\[\[)", text, flags=re.M | re.S)
    for camera in cameras[1:]:
        text = text.replace(camera, "")
    first = re.sub(r"^size = .*$", f"size = [{size[0]}, {size[1]}]", cameras[0], flags=re.M)
    all_of_them = "".join(first.replace('"house"', f'"house {k}"').replace("[0.0, -15.5,", f"[{0.5 * k}, -15.5,") for k in range(CAMERAS))
    toml.write_text(text.replace(cameras[0], all_of_them), encoding="utf-8")
    return folder


def tasks_of(plan):
    """Seconds of each that is done, and when the last one was."""
    files = list((plan / "done").glob("[0-9]*.json"))
    return [float(re.search(r'"seconds":([0-9.e+-]+)', file.read_text())[1]) for file in files], max(file.stat().st_mtime for file in files)


def measure(ghost, show, name, *words):
    # What one program takes on one core, from where the farm begins.
    alone = show.with_name("alone")
    shutil.copytree(show, alone)
    shutil.rmtree(alone / ".ghost/farm", ignore_errors=True)
    begun = time.monotonic()
    one_core = Ghostlight("taskset", ghost.environment, ghost.folder, limit_s=7200)
    one_core.run("--cpu-list", "0", ghost.program, words[0], alone, *words[1:], "--quiet")
    alone_s = time.monotonic() - begun
    if "film.mp4" in words:
        whole = (ghost.folder / "film.mp4").read_bytes()
        (ghost.folder / "film.mp4").unlink()
    begun, begun_wall = time.monotonic(), time.time()
    ghost.run(words[0], show, *words[1:], *FARM)
    farm_s = time.monotonic() - begun
    if "film.mp4" in words:
        assert whole == (ghost.folder / "film.mp4").read_bytes()
    seconds, last = tasks_of(plan_of(show))
    print(f"{name}: one program on one core {alone_s:.0f} s; {len(seconds)} tasks of {min(seconds):.1f} to {max(seconds):.1f} s, {sum(seconds):.0f} s "
          f"together; on two nodes {farm_s:.0f} s, of which {farm_s - (last - begun_wall):.0f} s after the last task, {farm_s / (alone_s / 2):.2f} times "
          f"half of one program", flush=True)
    shutil.rmtree(alone)


def empty_tasks(cluster, count):
    """What Slurm itself takes for a task."""
    begun = time.monotonic()
    cluster.do("sbatch", "--wait", f"--array=0-{count - 1}", "--output=/dev/null", "--wrap=true", seconds=600)
    print(f"Slurm alone: {count} tasks that do nothing take {time.monotonic() - begun:.1f} s on two nodes", flush=True)


def main():
    words = sys.argv[2:]
    sizes = [word for word in words if "x" in word] or ["1024x576"]
    size = [int(number) for number in sizes[0].split("x")]
    wanted = [word for word in words if "x" not in word] or ["bake", "film"]
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        cluster = Cluster(work / "cluster")
        try:
            cluster.up()
            empty_tasks(cluster, 100)
            ghost = Ghostlight(pathlib.Path(sys.argv[1]).resolve() / "ghostlight", cluster.environment, work, limit_s=3600)
            show = large_show(work / "show", size)
            if "bake" in wanted:
                measure(ghost, show, f"bake of {10 * CAMERAS} passes, {sizes[0]}, {SAMPLES} samples", "bake", "--spp", SAMPLES)
            if "film" in wanted:
                if "bake" not in wanted:
                    ghost.run("bake", show, "--view", "house 0", "--spp", "4", "--quiet")
                words = ["--view", "house 0", "--from", "0", "--to", f"{FRAMES / FPS:.3f}", "--fps", FPS]
                measure(ghost, show, f"film of {FRAMES} frames, {sizes[0]}", "render", "-o", "film.mp4", *words)
        finally:
            cluster.down()


if __name__ == "__main__":
    main()

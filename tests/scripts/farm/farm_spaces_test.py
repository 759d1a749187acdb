#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A farm of two nodes of which one sees the world otherwise: no show, no recording, another build; its cable is pulled; and a shared
disk that is full. Each ends in a sentence and an exit code, never a mixed or half film, and once it is mended, the film has the bytes
of one that nobody disturbed. The node and the test have namespaces of their own, so nothing of this machine is touched.
Usage: farm_spaces_test.py SOURCE_FOLDER BUILD_FOLDER. Skips where Slurm is not installed (packages slurm-wlm, munge), without root,
and where there are no namespaces."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time

SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import needs  # noqa: E402  (the folder is known only now)
from farm import FILM, Ghostlight, ends, plan_of, small_show, started, wait_for_pictures, wait_until  # noqa: E402
from slurm import PATH, Cluster  # noqa: E402

needs.packages("iproute2", "util-linux", path=PATH)
os.environ["PATH"] = PATH
OWN_SPACE = "GHOST_TEST_OWN_SPACE"
HERE, THERE = "10.77.1.1", "10.77.1.2"  # two ends of a cable that nobody else sees
DISK = "8m"  # for a film's pictures, which take three


def enter_own_space():
    if OWN_SPACE in os.environ:
        return
    if os.geteuid() != 0:
        needs.skip("namespaces of nodes need root")
    tried = subprocess.run(["unshare", "--mount", "--net", "true"], capture_output=True, text=True)
    if tried.returncode != 0:
        needs.skip("no namespaces can be made here: " + tried.stderr.strip())
    os.execvpe("unshare", ["unshare", "--mount", "--net", sys.executable, *sys.argv], {**os.environ, OWN_SPACE: "1"})


def do(*words):
    subprocess.run([str(word) for word in words], check=True, timeout=60)


class Node:
    """What n2 sees."""

    def __init__(self):
        self.holder = subprocess.Popen(["unshare", "--mount", "--net", "sleep", "1800"])
        own = f"/proc/{self.holder.pid}/ns"
        wait_until(lambda: os.readlink(own + "/net") != os.readlink("/proc/self/ns/net"), 10, "n2 has a namespace")
        self.before = ["nsenter", f"--mount={own}/mnt", f"--net={own}/net"]
        do("ip", "link", "set", "lo", "up")
        do("ip", "link", "add", "cable", "type", "veth", "peer", "name", "end", "netns", self.holder.pid)
        do("ip", "address", "add", HERE + "/24", "dev", "cable")
        do("ip", "link", "set", "cable", "up")
        for words in (["link", "set", "lo", "up"], ["address", "add", THERE + "/24", "dev", "end"], ["link", "set", "end", "up"]):
            self.do("ip", *words)

    def do(self, *words):
        do(*self.before, *words)


def whole_again(ghost, show, out, whole):
    ghost.run("farm", "retry", show)
    assert whole == (ghost.folder / out).read_bytes()


def hidden(ghost, cluster, node, show, whole):
    """The folder of the show, with the plan in it; then only a file that lies elsewhere."""
    node.do("mount", "-t", "tmpfs", "none", show)
    ghost.run("render", show, "-o", "hidden.mp4", *FILM, "--farm", "slurm", code=1, says="Slurm could not begin tasks on n2, which must see this folder: ")
    assert not (ghost.folder / "hidden.mp4").exists()
    node.do("umount", show)
    whole_again(ghost, show, "hidden.mp4", whole)
    elsewhere = ghost.folder / "elsewhere"
    elsewhere.mkdir()
    shutil.copy2(show / "demo.show", elsewhere)
    node.do("mount", "-t", "tmpfs", "none", elsewhere)
    ghost.run("render", show, "-o", "replayed.mp4", *FILM, "--replay", elsewhere / "demo.show", "--farm", "slurm", code=1,
              says=f"{elsewhere}/demo.show: n2 does not see this file")
    assert not (ghost.folder / "replayed.mp4").exists()
    node.do("umount", elsewhere)
    whole_again(ghost, show, "replayed.mp4", whole)
    print("a show and a recording that n2 does not see: a sentence that names both, no film; seen again, the same film")
    cluster.wait_for_idle()


def another_build(ghost, cluster, node, show, whole):
    other = ghost.folder / "other_build"
    shutil.copy2(BUILD / "ghostlight", other)
    with other.open("ab") as file:
        file.write(b"x")
    node.do("mount", "--bind", other, BUILD / "ghostlight")
    ghost.run("render", show, "-o", "builds.mp4", *FILM, "--farm", "slurm", code=1, says="the ghostlight of n2 is another build than the one that made the plan")
    assert not (ghost.folder / "builds.mp4").exists()
    hosts = {path.read_text().split('"host":"')[1][:2] for path in (plan_of(show) / "done").glob("[0-9]*.json")}
    assert hosts == {"n1"}, hosts
    node.do("umount", BUILD / "ghostlight")
    whole_again(ghost, show, "builds.mp4", whole)
    print("another build on n2: refused in a sentence, no film; the same build again, the same film")
    cluster.wait_for_idle()


class Filler:
    """Takes what is free on a disk, and what gets free."""

    def __init__(self, folder):
        self.file, self.stops = folder / "filler", False
        self.thread = threading.Thread(target=self.fill)
        self.thread.start()

    def fill(self):
        with self.file.open("wb", buffering=0) as file:
            while not self.stops:
                try:
                    file.write(bytes(4096))
                except OSError:
                    time.sleep(0.002)

    def end(self):
        self.stops = True
        self.thread.join()
        self.file.unlink()


def a_full_disk(ghost, cluster, show, whole):
    watching, plan = started(ghost, show, "full.mp4", "--farm", "slurm")
    wait_for_pictures(plan, 2)
    filler = Filler(show / ".ghost/farm")
    try:
        said = ends(watching, 1, "full.mp4: ")
        assert re.search("the disk is full: |No space left on device", said), said
        assert not (ghost.folder / "full.mp4").exists()
        wait_until(lambda: not cluster.jobs(), 120, "the farm is at its end")
        done = {path.stem for path in (plan / "done").iterdir()}  # a task that was faster than the disk got full keeps its pictures
        left = [path.name for path in (plan / "frames").iterdir() if path.name.split(".")[0] not in done]
        assert not left, (left, done)
        ghost.run("farm", "retry", show, code=1, says="No space left on device")
        ghost.run("render", show, "-o", "more.mp4", *FILM, "--farm", "slurm", code=1, says="No space left on device")
    finally:
        filler.end()
    ghost.run("render", show, "-o", "full.mp4", *FILM, "--farm", "slurm")
    assert whole == (ghost.folder / "full.mp4").read_bytes()
    print("a shared disk that gets full in the middle: said, no film; with room again, the same film")
    cluster.wait_for_idle()


def a_pulled_cable(ghost, cluster, show, whole):
    watching, plan = started(ghost, show, "cable.mp4", "--farm", "slurm")

    def drawn_there():
        tasks = [line.split()[0] for line in cluster.jobs("R") if line.endswith(" n2")]
        return [task for task in tasks if list((plan / "frames").glob(f"{task}.*/*.mp4"))]

    wait_until(drawn_there, 180, "n2 draws")
    task = drawn_there()[0]
    do("ip", "link", "set", "cable", "down")
    wait_until(lambda: cluster.states()["n2"].startswith("down"), 90, "n2 is down")
    ends(watching, 0, "done, 4 tasks")
    assert whole == (ghost.folder / "cable.mp4").read_bytes()
    host = (plan / f"done/{task}.json").read_text().split('"host":"')[1][:2]
    do("ip", "link", "set", "cable", "up")
    cluster.wait_for_idle()
    assert whole == (ghost.folder / "cable.mp4").read_bytes() and not list((plan / "frames").iterdir())
    print(f"the cable of n2 is pulled in the middle: its task counts as done by {host}, the same film; plugged in, the node is back")


enter_own_space()
work = pathlib.Path(tempfile.mkdtemp(prefix="ghost-spaces-"))
shows = {name: small_show(SOURCE, work / name) for name in ("show", "small_disk")}
disk = shows["small_disk"] / ".ghost/farm"
disk.mkdir(parents=True)
do("mount", "-t", "tmpfs", "-o", "size=" + DISK, "none", disk)
node = Node()
cluster = Cluster(work / "cluster", HERE, THERE, node.before)
try:
    cluster.up()
    ghost = Ghostlight(BUILD / "ghostlight", cluster.environment, work)
    ghost.run("bake", shows["show"], "--view", "house", "--spp", "4")
    shutil.copytree(shows["show"] / ".ghost/passes", shows["small_disk"] / ".ghost/passes")
    ghost.run("render", shows["show"], "-o", "whole.mp4", *FILM)
    whole = (work / "whole.mp4").read_bytes()
    a_pulled_cable(ghost, cluster, shows["show"], whole)
    hidden(ghost, cluster, node, shows["show"], whole)
    another_build(ghost, cluster, node, shows["show"], whole)
    a_full_disk(ghost, cluster, shows["small_disk"], whole)
finally:
    cluster.down()
    node.holder.kill()
    node.holder.wait()
    subprocess.run(["umount", disk], check=True)
    shutil.rmtree(work, ignore_errors=True)

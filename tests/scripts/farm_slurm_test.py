#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Bakes and films on a real Slurm of two nodes, all on this machine, without root and systemd: a task that fails
and is made again; passes and films have the bytes of those made by one program.
Usage: farm_slurm_test.py SOURCE_FOLDER BUILD_FOLDER. Skips where Slurm is not installed (packages slurm-wlm, munge)."""
import getpass
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

SOURCE, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import needs  # noqa: E402  (the folder is known only now)
from farm import FILM, Ghostlight, files_of, plan_of, small_show, wait_until  # noqa: E402

PATH = os.environ["PATH"] + ":/usr/sbin:/sbin"
needs.packages("slurm-wlm", "munge", path=PATH)

CONFIG = """ClusterName=ghosttest
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort={port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={d}/munge.socket,cred_expire=5
StateSaveLocation={d}/state
SlurmctldPidFile={d}/slurmctld.pid
SlurmdPidFile={d}/slurmd.%n.pid
SlurmdSpoolDir={d}/spool.%n
SlurmctldLogFile={d}/log/slurmctld.log
SlurmdLogFile={d}/log/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,bf_interval=1,sched_min_interval=0
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SlurmdTimeout=5
KillWait=2
ReturnToService=2
NodeName=n1 NodeHostname=localhost NodeAddr=127.0.0.1 Port={one} CPUs=1
NodeName=n2 NodeHostname=localhost NodeAddr=127.0.0.1 Port={two} CPUs=1
PartitionName=farm Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Cluster:
    def __init__(self, folder):
        self.folder = folder
        for name in ("state", "spool.n1", "spool.n2", "log"):
            (folder / name).mkdir(parents=True)
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        port, one, two = free_ports(3)
        (folder / "slurm.conf").write_text(CONFIG.format(d=folder, user=getpass.getuser(), port=port, one=one, two=two))
        version = subprocess.run(["slurmd", "-V"], env={**os.environ, "PATH": PATH}, capture_output=True, text=True, check=True).stdout
        if int(version.split()[1].split(".")[0]) >= 23:  # those before refuse it
            (folder / "cgroup.conf").write_text("CgroupPlugin=disabled\n")
        self.environment = {**os.environ, "PATH": PATH, "SLURM_CONF": str(folder / "slurm.conf")}

    def do(self, *words):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, check=True, timeout=60).stdout

    def up(self):
        self.do("munged", "--force", f"--socket={self.folder}/munge.socket", f"--key-file={self.folder}/munge.key",
                f"--pid-file={self.folder}/munged.pid", f"--log-file={self.folder}/log/munged.log", f"--seed-file={self.folder}/munge.seed")
        self.do("slurmctld")
        for node in ("n1", "n2"):
            self.do("slurmd", "-N", node)
        wait_until(lambda: self.do("sinfo", "-h", "-N", "-o", "%t").split() == ["idle", "idle"], 60, "both nodes idle")

    def pid(self, name):
        return int((self.folder / f"{name}.pid").read_text())

    def down(self):
        for name in ("slurmd.n1", "slurmd.n2", "slurmctld", "munged"):
            try:
                os.kill(self.pid(name), signal.SIGTERM)
            except (OSError, ValueError):
                pass


def bakes(ghost, work):
    one, cut = small_show(SOURCE, work / "one"), small_show(SOURCE, work / "cut")
    ghost.run("bake", one, "--spp", "4")
    begun = time.monotonic()
    ghost.run("bake", cut, "--spp", "4", "--farm", "slurm", says="9 tasks given to Slurm")
    expected, found = files_of(one / ".ghost/passes"), files_of(cut / ".ghost/passes")
    assert expected == found, [name for name in expected.keys() | found.keys() if expected.get(name) != found.get(name)]
    hosts = {path.read_text().split('"host":"')[1][:2] for path in (plan_of(cut) / "done").glob("[0-9]*.json")}
    print(f"bake: 9 tasks on {sorted(hosts)} in {time.monotonic() - begun:.1f} s, the same bytes")
    return cut


def a_task_fails(ghost, work, show):
    watching = ghost.start("render", show, "-o", "cut.mp4", *FILM, "--farm", "slurm")
    wait_until(lambda: (show / ".ghost/farm").is_dir() and (plan_of(show) / "submitted.json").exists() and plan_of(show) != bake_plan, 60,
               "submitted")
    plan = plan_of(show)
    wait_until(lambda: list((plan / "frames").glob("2.*/*.png")), 120, "task 2 draws")
    for process in pathlib.Path("/proc").iterdir():
        try:
            words = (process / "cmdline").read_bytes().split(b"\0") if process.name.isdigit() else []
        except OSError:
            continue
        # Of this show alone: other tests have farms of their own.
        if str(show).encode() in words and b"render" in words and b"240-479" in words and b"--quiet" in words:
            os.kill(int(process.name), signal.SIGKILL)
    said = watching.communicate()[0]
    assert watching.returncode == 1 and "1 failed" in said and "farm retry" in said, said
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
    bake_plan = plan_of(show)
    ghost.run("render", show, "-o", "whole.mp4", *FILM)
    a_task_fails(ghost, work, show)
finally:
    cluster.down()
    time.sleep(1)
    shutil.rmtree(work, ignore_errors=True)

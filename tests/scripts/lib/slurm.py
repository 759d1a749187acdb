# SPDX-License-Identifier: Apache-2.0
"""A Slurm of two nodes of one core each, all on this machine, without systemd and apart from any other Slurm: what its tests share.
Import it after SOURCE/tests/scripts/lib is in sys.path. Skips where Slurm is not installed (packages slurm-wlm, munge)."""
import getpass
import os
import pathlib
import signal
import socket
import subprocess
import time

import needs
from farm import wait_until

PATH = os.environ["PATH"] + ":/usr/sbin:/sbin"
needs.packages("slurm-wlm", "munge", path=PATH)

CONFIG = """ClusterName=ghosttest
SlurmctldHost=localhost({host})
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
NodeName=n1 NodeHostname=localhost NodeAddr={host} Port={one} CPUs=1
NodeName=n2 NodeHostname=localhost NodeAddr={other} Port={two} CPUs=1
PartitionName=farm Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
"""
NODES = ("n1", "n2")


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def processes():
    """Of this machine: number, name, parent and what their environment was when they began."""
    found = {}
    for process in pathlib.Path("/proc").iterdir():
        if not process.name.isdigit():
            continue
        try:
            status = dict(line.split(":\t", 1) for line in (process / "status").read_text().splitlines() if ":\t" in line)
            if status["State"].startswith("Z"):
                continue  # ended, and nobody has asked how
            found[int(process.name)] = status["Name"], int(status["PPid"]), (process / "environ").read_bytes().split(b"\0")
        except (OSError, ValueError, KeyError):
            pass
    return found


class Cluster:
    """host, other: addresses of the controller with n1, and of n2; before_n2: the words before its daemon, for a namespace of its own."""

    def __init__(self, folder, host="127.0.0.1", other="127.0.0.1", before_n2=()):
        self.folder = folder
        self.before = {"n1": (), "n2": tuple(before_n2)}
        for name in ("state", "spool.n1", "spool.n2", "log"):
            (folder / name).mkdir(parents=True)
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        port, one, two = free_ports(3)
        (folder / "slurm.conf").write_text(CONFIG.format(d=folder, user=getpass.getuser(), host=host, other=other, port=port, one=one, two=two))
        version = subprocess.run(["slurmd", "-V"], env={**os.environ, "PATH": PATH}, capture_output=True, text=True, check=True).stdout
        if int(version.split()[1].split(".")[0]) >= 23:  # those before refuse it
            (folder / "cgroup.conf").write_text("CgroupPlugin=disabled\n")
        self.environment = {**os.environ, "PATH": PATH, "SLURM_CONF": str(folder / "slurm.conf")}

    def do(self, *words, seconds=60, **more):
        return subprocess.run(words, env={**self.environment, **more}, capture_output=True, text=True, check=True, timeout=seconds).stdout

    def start_munge(self, name="munge", **environment):
        """Who vouches for programs, and refuses what is older than five minutes, or not yet written."""
        self.do("munged", "--force", f"--socket={self.folder}/{name}.socket", f"--key-file={self.folder}/munge.key",
                f"--pid-file={self.folder}/{name}.pid", f"--log-file={self.folder}/log/{name}.log", f"--seed-file={self.folder}/{name}.seed",
                **environment)

    def up(self):
        self.start_munge()
        self.start_controller()
        for node in NODES:
            self.start_node(node)
        self.wait_for_idle()

    def start_controller(self):
        self.do("slurmctld")

    def start_node(self, node, **environment):
        self.do(*self.before[node], "slurmd", "-N", node, **environment)

    def states(self):
        return dict(line.split() for line in self.do("sinfo", "-h", "-N", "-o", "%N %t").splitlines())

    def wait_for_idle(self):
        wait_until(lambda: self.states() == {"n1": "idle", "n2": "idle"}, 90, "both nodes idle")

    def jobs(self, state=""):
        """Number in its array, state in short, node."""
        return self.do("squeue", "-h", "-r", "-o", "%K %t %N", *(["--states=" + state] if state else [])).splitlines()

    def restarts(self):
        """Of all tasks that Slurm remembers; what puts a film together is none."""
        tasks = [line for line in self.do("scontrol", "show", "job", "-o").splitlines() if "ArrayTaskId=" in line]
        return sum(int(word.split("=")[1]) for line in tasks for word in line.split() if word.startswith("Restarts="))

    def pid(self, name):
        return int((self.folder / f"{name}.pid").read_text())

    def kill_controller(self):
        pid = self.pid("slurmctld")
        os.kill(pid, signal.SIGKILL)
        wait_until(lambda: pid not in processes(), 10, "the controller is gone")

    def of_node(self, node):
        """Its daemon, the steps of its jobs, and all that runs in them: those that could still tell somebody come first."""
        everybody = processes()
        marks = {f"SLURM_CONF={self.folder}/slurm.conf".encode(), f"SLURMD_NODENAME={node}".encode()}
        work = {pid for pid, (_, _, environment) in everybody.items() if marks <= set(environment)}
        steps = {everybody[pid][1] for pid in work} - work
        return [self.pid(f"slurmd.{node}"), *[pid for pid in steps if everybody.get(pid, ("",))[0].startswith("slurmstepd")], *sorted(work)]

    def kill_node(self, node):
        """As if its plug were pulled."""
        pids = self.of_node(node)
        for pid in pids:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        wait_until(lambda: not set(pids) & processes().keys(), 10, "the node is gone")
        return len(pids)

    def living(self):
        """All that was started for it, and what runs in its jobs."""
        mark = f"SLURM_CONF={self.folder}/".encode()
        return [pid for pid, (_, _, environment) in processes().items() if any(word.startswith(mark) for word in environment)]

    def down(self):
        for number in (signal.SIGTERM, signal.SIGKILL):
            for pid in self.living():
                try:
                    os.kill(pid, number)
                except ProcessLookupError:
                    pass
            for _ in range(50):
                if not self.living():
                    return
                time.sleep(0.1)

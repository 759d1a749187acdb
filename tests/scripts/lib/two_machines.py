# SPDX-License-Identifier: Apache-2.0
"""Two machines on one network, as namespaces of the kernel: a desk and ours. Needs root and iproute2."""
import os
import pathlib
import signal
import subprocess


def ip(*words):
    subprocess.run(["ip", *words], check=True, capture_output=True, text=True, timeout=20)


class TwoMachines:
    """A desk and our machine, each in a namespace, a cable between them, and a second card of ours with a cable to nowhere. setup: "desk" and "vis" are
    commands of ip for each; the rest is the caller's."""

    def __init__(self, folder, number, setup):
        self.folder, self.setup = pathlib.Path(folder), {"desk": [], "vis": [], **setup}
        self.desk, self.vis = f"gl_d{os.getpid()}_{number}", f"gl_v{os.getpid()}_{number}"
        self.processes = []
        for namespace in (self.desk, self.vis):
            ip("netns", "add", namespace)
            ip("-n", namespace, "link", "set", "lo", "up")
        ip("-n", self.desk, "link", "add", "br0", "type", "bridge", "mcast_snooping", "0")
        for name, address in (("net0", "10.93.0.2"), ("net1", "10.94.0.2")):
            ip("-n", self.desk, "link", "add", f"to_{name}", "type", "veth", "peer", "name", name, "netns", self.vis)
            ip("-n", self.desk, "link", "set", f"to_{name}", "up")
            self.command(self.vis, "sysctl", "-qw", f"net.ipv4.conf.{name}.rp_filter=0")
            ip("-n", self.vis, "addr", "add", f"{address}/24", "brd", "+", "dev", name)
            ip("-n", self.vis, "link", "set", name, "up")
        ip("-n", self.desk, "link", "set", "to_net0", "master", "br0")
        self.command(self.vis, "sysctl", "-qw", "net.ipv4.conf.all.rp_filter=0")
        ip("-n", self.desk, "link", "set", "br0", "up")
        ip("-n", self.desk, "addr", "add", "10.93.0.1/24", "brd", "+", "dev", "br0")
        for words in self.setup["desk"]:
            ip("-n", self.desk, *words.split())
        for words in self.setup["vis"]:
            ip("-n", self.vis, *words.split())

    def command(self, namespace, *words):
        subprocess.run(["ip", "netns", "exec", namespace, *words], check=True, capture_output=True, text=True, timeout=20)

    def start(self, namespace, *words, **more):
        process = subprocess.Popen(["ip", "netns", "exec", namespace, *map(str, words)], text=True, start_new_session=True, **more)
        self.processes.append(process)
        return process

    def end(self):
        for process in self.processes:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
        for namespace in (self.desk, self.vis):
            subprocess.run(["ip", "netns", "del", namespace], capture_output=True)

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What ghostlight monitor says is wrong between a desk and the demo, with real packets and real other programs, on ports of its own on
the loopback interface. Arguments: source folder, build folder. Exit 77: skipped, with the reason."""
import json
import os
import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time

SOURCE = pathlib.Path(sys.argv[1]).resolve()
GHOSTLIGHT = str(pathlib.Path(sys.argv[2]).resolve() / "ghostlight")
SACN = 20000 + os.getpid() % 20000 * 2
ARTNET = SACN + 1
HOST = "127.0.0.1"

# Another program with a port open, until it is killed. Arguments: port, 1 where it shares it.
OTHER = """
import socket, sys, time
s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
s.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, int(sys.argv[2]))
s.bind(("0.0.0.0", int(sys.argv[1])))
print("bound", flush=True)
time.sleep(300)
"""


def artdmx(port_address, slots, sequence):
    return b"Art-Net\0" + struct.pack("<HBBBBHBB", 0x5000, 0, 14, sequence % 255 + 1, 0, port_address, len(slots) >> 8, len(slots) & 255) + bytes(slots)


def sacn(universe, slots, sequence, options=0, priority=100, cid=b"diagnosis test.."):
    size = 126 + len(slots)

    def layer(offset):
        return struct.pack(">H", 0x7000 | (size - offset))

    packet = struct.pack(">HH", 0x10, 0) + b"ASC-E1.17\0\0\0" + layer(16) + struct.pack(">I", 4) + cid
    packet += layer(38) + struct.pack(">I", 2) + b"Test desk".ljust(64, b"\0") + bytes([priority, 0, 0, sequence & 255, options])
    return packet + struct.pack(">H", universe) + layer(115) + bytes([2, 0xA1, 0, 0, 0, 1]) + struct.pack(">H", 1 + len(slots)) + b"\0" + bytes(slots)


class Desk(threading.Thread):
    """Sends what make(sequence) gives to a port, 40 times a second."""

    def __init__(self, port, make):
        super().__init__(daemon=True)
        self.port, self.make, self.stopping = port, make, threading.Event()
        self.start()

    def run(self):
        out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        sequence = 0
        while not self.stopping.wait(0.025):
            sequence += 1
            for packet in self.make(sequence):
                out.sendto(packet, (HOST, self.port))

    def stop(self):
        self.stopping.set()
        self.join()


class Other:
    def __init__(self, port, shares):
        self.process = subprocess.Popen([sys.executable, "-c", OTHER, str(port), str(int(shares))], stdout=subprocess.PIPE, text=True)
        assert self.process.stdout.readline() == "bound\n"
        self.name = f"{pathlib.Path(f'/proc/{self.process.pid}/comm').read_text().strip()} (pid {self.process.pid})"

    def stop(self):
        self.process.kill()
        self.process.wait()


class Monitor:
    def __init__(self, *options):
        self.log = tempfile.NamedTemporaryFile("w+", suffix=".jsonl")
        self.errors = tempfile.NamedTemporaryFile("w+", suffix=".txt")
        self.process = subprocess.Popen([GHOSTLIGHT, "monitor", "--interface", HOST, "--sacn-port", str(SACN), "--artnet-port", str(ARTNET), "--show",
                                         str(SOURCE / "assets/demo"), "--json", "--every", "0.3", *options], stdout=self.log, stderr=self.errors)

    def lines(self):
        return [json.loads(line) for line in pathlib.Path(self.log.name).read_text().split("\n")[:-1]]

    def wait(self, what, condition, limit_s=60):
        end = time.monotonic() + limit_s
        while time.monotonic() < end:
            for line in self.lines()[-3:]:
                if condition(line):
                    print("ok:", what)
                    return line
            assert self.process.poll() is None, pathlib.Path(self.errors.name).read_text()
            time.sleep(0.1)
        raise AssertionError(f"{what}: {json.dumps(self.lines()[-1:])[:3000]}")

    def stop(self):
        self.process.terminate()
        assert self.process.wait(20) == 0


def said(line, *wanted):
    """Exactly these findings, in this order."""
    return [sentence["trouble"] for sentence in line["diagnosis"]] == list(wanted)


def text(line, finding):
    return next(sentence["text"] for sentence in line["diagnosis"] if sentence["trouble"] == finding)


def sentences():
    monitor = Monitor()
    try:
        line = monitor.wait("nothing arrives", lambda l: said(l, "nothing_arrives"))
        assert [u["universe"] for u in line["patch"]] == [1], line["patch"]
        other = Other(SACN, shares=True)
        line = monitor.wait("another program has the port", lambda l: said(l, "nothing_arrives", "port_shared", "same_host"))
        assert other.name in text(line, "port_shared") and "unicast to 127.0.0.1" in text(line, "same_host"), line["diagnosis"]
        other.stop()
        monitor.wait("it is gone", lambda l: said(l, "nothing_arrives"))

        desk = Desk(ARTNET, lambda n: [artdmx(1, [n & 255] * 512, n)])
        line = monitor.wait("off by one", lambda l: said(l, "off_by_one"))
        assert "--artnet-offset 0" in text(line, "off_by_one")
        assert line["sources"][0]["universe"] == 2 and line["sources"][0]["role"] == "shown", line["sources"]
        desk.stop()
        desk = Desk(ARTNET, lambda n: [artdmx(0, [n & 255] * 512, n), artdmx(8, [0] * 16, n)])
        line = monitor.wait("one more than is patched", lambda l: said(l, "not_patched") and "universe 9 " in text(l, "not_patched"))
        assert not line["diagnosis"][0]["problem"]
        desk.stop()
        desk = Desk(SACN, lambda n: [sacn(1, [1] * 512, n, options=0x80), sacn(1, [2] * 512, n, cid=b"the other desk..")])
        line = monitor.wait("preview", lambda l: said(l, "preview"))
        assert "'Test desk' (127.0.0.1)" in text(line, "preview")
        desk.stop()
        desk = Desk(SACN, lambda n: [sacn(1, [1] * 512, n, priority=90), sacn(1, [2] * 512, n, cid=b"the other desk..")])
        monitor.wait("a backup of lower priority", lambda l: said(l, "low_priority"))
        desk.stop()
        desk = Desk(SACN, lambda n: [sacn(1, [n & 255] * 512, n)])
        line = monitor.wait("silence when all is well", lambda l: said(l))
        assert line["network"]["wire_to_store_ms"]["count"] > 100 and line["network"]["wire_to_store_ms"]["max"] > 0
        desk.stop()
        line = monitor.wait("the desk is gone", lambda l: said(l, "lost"))
        assert "last look is held" in text(line, "lost")
    finally:
        monitor.stop()


def kept_out():
    other = Other(ARTNET, shares=False)
    try:
        done = subprocess.run([GHOSTLIGHT, "monitor", "--interface", HOST, "--sacn-port", str(SACN), "--artnet-port", str(ARTNET)], capture_output=True,
                              text=True, timeout=30)
        assert done.returncode == 1, done
        assert f"UDP port {ARTNET}" in done.stderr and f"taken by {other.name}" in done.stderr, done.stderr
        print("ok: who keeps us out is named")
    finally:
        other.stop()


def learning():
    level = [0]
    # Universe 2 by our numbers, a slot that a chase moves, and a fader at the address of the demo's first fixture.
    desk = Desk(ARTNET, lambda n: [artdmx(1, [level[0], 0, 0, 0, 0, n & 255] + [0] * 506, n)])
    monitor = Monitor("--learn")
    try:
        time.sleep(4)
        level[0] = 255
        line = monitor.wait("the fader that moved", lambda l: "moved" in l)
        assert (line["moved"], line["address"], line["protocol"], line["to"]) == (2, 1, "Art-Net", 255), line
        assert "off by one? on universe 1 it would be '" in line["text"] and "--artnet-offset 0" in line["text"], line["text"]
        time.sleep(1)
        assert len(monitor.lines()) == 1, "the chase moves by itself"
    finally:
        monitor.stop()
    monitor = Monitor("--learn", "--artnet-offset", "0")
    try:
        time.sleep(4)
        level[0] = 100
        line = monitor.wait("and with the right offset", lambda l: "moved" in l)
        assert line["moved"] == 1 and len(line["fixtures"]) == 1, line
        print("  ", line["text"])
    finally:
        monitor.stop()
        desk.stop()


def main():
    if not os.access(GHOSTLIGHT, os.X_OK):
        print("skipped:", GHOSTLIGHT, "is not built")
        sys.exit(77)
    sentences()
    kept_out()
    learning()


if __name__ == "__main__":
    main()

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The stage that travels (assets/kinetic) in the window, flown by OLA, by QLC+ and by a PosiStageNet tracker of a few lines, each in network namespaces of
its own: every mover comes to where it is sent, as fast as its machine allows and no faster. Desks that are not installed are skipped by name.
Usage: desks_test.py SOURCE_FOLDER BUILD_FOLDER. Exit 77: skipped, with the reason."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

SOURCE = pathlib.Path(sys.argv[1]).resolve()
GHOSTLIGHT = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import needs  # noqa: E402  (the folder is known only now)
import real_desks  # noqa: E402
from two_machines import TwoMachines  # noqa: E402

LIMIT_S = 150  # for a desk and a window to come up on a busy machine, and the slowest mover to arrive
# Levels of universe 9 and where they send each axis: ranges and addresses of assets/kinetic/show.toml.
LEVELS = {1: 0x40, 3: 0x80, 7: 0x40, 10: 0x80, 12: 0x40}
PLACES = {"Truss": [-4.0 * 0x4000 / 0xFFFF, -4.0 * 0x8000 / 0xFFFF], "Revolve": [360.0 * 0x400000 / 0xFFFFFF], "Lift": [2.5 * 0x8000 / 0xFFFF],
          "Wagon": [12.0 * 0x4000 / 0xFFFF]}
LIFT_SPEED_M_S = 0.6
TRACKER = """
import socket, struct, sys, time
out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("10.93.0.1"))
def chunk(number, data, holds=False):
    return struct.pack("<HH", number, len(data) | (0x8000 if holds else 0)) + data
frame = 0
while True:
    head = chunk(0, struct.pack("<QBBBB", frame * 20000, 2, 0, frame & 255, 1))
    place = chunk(0, struct.pack("<fff", 0.0, float(sys.argv[1]), 0.0))  # y is up
    out.sendto(chunk(0x6755, head + chunk(1, chunk(7, place, True), True), True), ("236.10.10.10", 56565))
    frame += 1
    time.sleep(0.02)
"""


def write_show(folder, tracker):
    show = folder / "show"
    shutil.copytree(SOURCE / "assets/kinetic", show)
    toml = (show / "show.toml").read_text().replace('"../fixtures/', f'"{SOURCE}/assets/fixtures/')
    toml = "".join(line for line in toml.splitlines(True) if not line.startswith("recording"))  # the window listens
    if tracker:
        toml = toml.replace('name = "Lift"\n', 'name = "Lift"\ntracker = 7\n')
    (show / "show.toml").write_text(toml)
    return show


class Window:
    def __init__(self, machines, show, *more):
        self.folder = machines.folder / "window"
        self.folder.mkdir()
        self.seen = 0
        lines = ["wait opened"]
        for number in range(4 * LIMIT_S):
            lines += ["wait 0.25", f'state "{self.folder}/{number}.json"']
        (self.folder / "script").write_text("\n".join(lines) + "\n")
        environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", XDG_CONFIG_HOME=str(self.folder), XDG_RUNTIME_DIR=str(self.folder), LC_ALL="C.UTF-8")
        self.process = machines.start(machines.vis, GHOSTLIGHT, "open", show, "--forget", "--size", "320x240", "--script", self.folder / "script", *more,
                                      env=environment, stdout=(self.folder / "log").open("w"), stderr=subprocess.STDOUT)

    def movers(self):
        """The next state: (when it was written, the values of each mover)."""
        path = self.folder / f"{self.seen}.json"
        end = time.monotonic() + LIMIT_S
        while not path.exists():
            assert self.process.poll() is None, (self.folder / "log").read_text()[-2000:]
            assert time.monotonic() < end, "the window writes no more"
            time.sleep(0.05)
        self.seen += 1
        return path.stat().st_mtime, {name: mover["values"] for name, mover in json.loads(path.read_text())["movers"].items()}


def far(values, places):
    return {name: (values[name], wanted) for name, wanted in places.items() if any(abs(a - b) > 0.02 for a, b in zip(values[name], wanted))}


def arrives(window, places):
    """Where it is sent, by way of other places, and no faster than its machine."""
    end = time.monotonic() + LIMIT_S
    lift_m, left, began_s, on_its_way = places["Lift"][0], places, 0.0, set()
    while left:
        assert time.monotonic() < end, left
        at_s, values = window.movers()
        left = far(values, places)
        if values["Lift"][0] < 0.02:
            began_s = at_s
        elif values["Lift"][0] < lift_m - 0.02:
            on_its_way.add(values["Lift"][0])
    took_s = at_s - began_s
    # States say what was drawn a moment before they are written.
    assert on_its_way and took_s > lift_m / LIFT_SPEED_M_S - 1.0, f"the lift took {took_s} s for {lift_m} m, by {on_its_way}"


def fly(number, name, setup, places, *more):
    with tempfile.TemporaryDirectory() as folder:
        machines = TwoMachines(folder, number, {"ola": None, "qlc": None, **setup})
        try:
            show = write_show(machines.folder, "tracker" in setup)
            window = Window(machines, show, *more)
            _, values = window.movers()
            while not values:  # the first picture is not drawn yet
                _, values = window.movers()
            assert not far(values, {name: [0.0] * len(wanted) for name, wanted in places.items()}), values
            real_desks.start(machines)
            if "tracker" in setup:
                machines.start(machines.desk, sys.executable, "-c", TRACKER, setup["tracker"])
            arrives(window, places)
        finally:
            machines.end()
    print(f"ok: {name}: {places}")


def main():
    if os.geteuid() != 0:
        needs.skip("needs root for network namespaces")
    needs.packages("iproute2")
    try:
        with tempfile.TemporaryDirectory() as folder:
            TwoMachines(folder, "try", {}).end()
    except subprocess.SubprocessError as error:
        needs.skip(f"no network namespaces or veth here: {error}")
    desks = [("OLA", real_desks.ola("e131", 9, levels=LEVELS)), ("QLC+", real_desks.qlc("E1.31", levels=LEVELS, multicast=1, universe=9))]
    for number, (name, setup) in enumerate(desks):
        reason = real_desks.missing(setup)
        if reason:
            print(f"left out: {name}\nskipped: a desk of movers/desks_test: {reason}")
        else:
            fly(number, name, setup, PLACES)
    fly("psn", "a tracker of PosiStageNet", {"tracker": 1.5}, {"Lift": [1.5]}, "--psn")


if __name__ == "__main__":
    main()

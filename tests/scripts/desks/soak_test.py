#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A window that nobody spares: 512 universes at 44 Hz from a desk in a network namespace of its own, a show on a disk of 64 MB, and round
after round a plot that arrives, files that others change or damage, a full disk, a cable that is pulled, a clock that jumps by an hour,
and a graphics device that is lost. It goes on, says each, what was saved is whole, and neither memory nor descriptors grow.
Usage: soak_test.py SOURCE_FOLDER BUILD_FOLDER [FOLDER [SECONDS [TROUBLE...]]]. Two rounds as a test; an hour: ./dev soak. Of some troubles
alone, like the_device_is_lost: for whoever looks for what grows."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time
import tomllib
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "lib"))
import needs  # noqa: E402
import window as window_driver  # noqa: E402
from window import PROGRAM, SOURCE, Window  # noqa: E402

needs.packages("iproute2", "util-linux", "faketime")

SECONDS = float(sys.argv[4]) if len(sys.argv) > 4 else 0  # 0: three rounds
TROUBLES = sys.argv[5:] or ["a_plot_arrives", "others_change_files", "the_disk_is_full", "the_cable_is_pulled", "the_clock_jumps", "the_device_is_lost"]
UNIVERSES = 512
UNIVERSE_OF = [1, 100, 300, 400, 512]  # of the heads
DISK_MB = 64
COMES_BACK_S = 60
MOST_GROWTH = 0.02  # of memory, of the last rounds over the first after the warm-up
WARM_SHARE = 1 / 3
NET = SOURCE / "tools/demo_show/desk_net.sh"
LIBRARIES = [subprocess.run(["faketime", "-f", "+0", "printenv", "LD_PRELOAD"], capture_output=True, text=True, check=True).stdout.strip(),
             str(PROGRAM.parent / "tests/libfake_loss.so")]


class Network:
    """Two machines and a cable: desk_net.sh."""

    def __init__(self):
        done = subprocess.run(["bash", "-c", f'. "{NET}"; desk_net_up && echo $DESK $VIS || {{ desk_net_down; exit 1; }}'], capture_output=True, text=True)
        if done.returncode:
            needs.skip("no network namespaces or veth here")
        self.desk, self.vis = done.stdout.split()

    def cable(self, is_in):
        """Pulled out, an interface forgets its route; who plugs it in again gets it from NetworkManager."""
        self.ip("link", "set", "net0", "up" if is_in else "down")
        if is_in:
            self.ip("route", "replace", "127.1.0.0/16", "dev", "net0", "src", "127.1.0.2", "scope", "link")

    def address(self, is_there):
        self.ip("addr", "add" if is_there else "del", "127.1.0.2/16", *(["brd", "127.1.255.255"] if is_there else []), "dev", "net0")
        if is_there:
            self.ip("route", "replace", "127.1.0.0/16", "dev", "net0", "src", "127.1.0.2", "scope", "link")

    def ip(self, *arguments):
        subprocess.run(["ip", "-n", self.vis, *arguments], check=True)

    def close(self):
        for name in (self.desk, self.vis):
            subprocess.run(["ip", "netns", "del", name], check=False)


def plot(path, number):
    """Heads of the project's own, one more in every second plot, higher each time."""
    spot = SOURCE / "assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"
    heads = "".join(f'<Fixture uuid="0000000{k}-2222-4222-8222-222222222222" name="Spot {k}"><Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{k}000,0,{6000 + number}}}</Matrix>'
                    f"<GDTFSpec>{spot.name}</GDTFSpec><Addresses><Address>{512 * (UNIVERSE_OF[k - 1] - 1) + 1}</Address></Addresses></Fixture>" for k in range(1, 5 + number % 2))
    deck = '<SceneObject uuid="11111111-3333-4111-8111-111111111119" name="Deck"><Geometries><Geometry3D fileName="stage.glb"/></Geometries></SceneObject>'
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("GeneralSceneDescription.xml", '<GeneralSceneDescription verMajor="1" verMinor="6" provider="soak"><Scene><Layers><Layer name="L" '
                         f'uuid="11111111-1111-4111-8111-111111111111"><ChildList>{heads}{deck}</ChildList></Layer></Layers></Scene></GeneralSceneDescription>')
        archive.write(spot, spot.name)
        archive.write(SOURCE / "assets/optics/stage.glb", "stage.glb")
    return path


class Soak:
    def __init__(self, work, network):
        self.work, self.network, self.edits = work, network, 0
        self.disk = work / "disk"
        self.disk.mkdir()
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={DISK_MB}m", "soak", self.disk], check=True)
        self.show = self.disk / "tour"
        subprocess.run([PROGRAM, "import", plot(work / "first.mvr", 0), "-o", self.show], check=True, capture_output=True)
        self.clock, self.loss, self.plots = work / "clock", work / "loss", 0
        self.set_clock("+0")
        self.desk_log = open(work / "desk.log", "w", encoding="utf-8")
        self.desk = subprocess.Popen(["ip", "netns", "exec", network.desk, "/usr/bin/python3", SOURCE / "tests/scripts/lib/many_universes.py",
                                      "127.1.0.1", "127.1.0.2", str(UNIVERSES)], stdout=self.desk_log)
        self.window = Window("--size", "900x600", "--quiet", "--xchange", self.disk / "plots", "--group", "Soak", "--peer", "127.1.0.1:4777",
                             show=self.show, before=["ip", "netns", "exec", network.vis],
                             environment={"LD_PRELOAD": ":".join(LIBRARIES), "FAKETIME_TIMESTAMP_FILE": str(self.clock), "FAKETIME_CACHE_DURATION": "1",
                                          "FAKETIME_DONT_FAKE_MONOTONIC": "1", "NO_FAKE_STAT": "1", "FAKE_LOSS": str(self.loss)})
        self.window.do("wait opened", "resolution 25", "camera 1")

    def set_clock(self, offset):
        self.clock.write_text(offset + "\n")

    def until(self, holds, what):
        until_s = time.monotonic() + COMES_BACK_S
        while True:
            state = self.window.state()
            if holds(state):
                return
            assert time.monotonic() < until_s, f"not within {COMES_BACK_S} s: {what}; {json.dumps(state)}"
            time.sleep(0.2)

    def packets_come(self):
        self.window.do("reset-figures")
        self.until(lambda state: state["packet_to_window_ms"]["count"] > 0 and len(state["universes"]) == state["fixtures"], "packets of all universes")

    def edit(self):
        self.edits += 1
        # Of Spot 1 whatever it is called now: a plot that came knows it by its UUID.
        self.window.do("select-all")
        first = self.window.state()["selection"][0]
        self.window.do(f'select "{first}"', f'rename "N {self.edits}"')

    def is_whole(self, edit):
        """What is on the disk: TOML, and the last edit that was said to be saved."""
        text = (self.show / "show.toml").read_text(encoding="utf-8")
        tomllib.loads(text)
        assert edit == 0 or f'"N {edit}"' in text, (edit, text)

    def save(self):
        self.window.do("save")
        self.is_whole(self.edits)

    # What happens to it.

    def a_plot_arrives(self):
        self.plots += 1
        file = plot(self.work / f"plot {self.plots}.mvr", self.plots)
        before = self.window.state()["received_plot"]
        with open(self.work / "station.log", "w", encoding="utf-8") as log:
            station = subprocess.Popen(["ip", "netns", "exec", self.network.desk, PROGRAM, "xchange", "--group", "Soak", "--share", file, "--port", "4777",
                                        "--station", f"Office {self.plots}", "--interface", "127.1.0.1"], stdout=log, stderr=log)
        try:
            self.until(lambda state: state["received_plot"] not in ("", before), "the plot is here")
        finally:
            station.terminate()
            station.wait(timeout=60)
        self.window.do("take-plot")
        self.until(lambda state: state["fixtures"] == 4 + self.plots % 2, "its heads")
        file.unlink()

    def others_change_files(self):
        file = self.show / "show.toml"
        mine = file.read_text(encoding="utf-8")

        def others_write(text):
            other = file.with_name(".show.toml.other")
            other.write_text(text, encoding="utf-8")
            other.rename(file)

        theirs = mine.replace(f'"N {self.edits}"', f'"M {self.edits}"')
        others_write(theirs)
        self.until(lambda state: f"M {self.edits}" in state["patch"], "a file that another program changed")
        file.write_text(theirs[:len(theirs) // 2] + '"', encoding="utf-8")
        self.until(lambda state: "it cannot be taken" in state["notice"], "a word that the file is damaged")
        others_write(mine)
        self.until(lambda state: f"N {self.edits}" in state["patch"], "a file that is mended")
        self.edit()
        others_write(theirs)
        self.until(lambda state: "not saved" in state["notice"], "a word that both changed the file")
        answer = self.window.ask("save")
        assert "was changed by another program" in answer, answer
        self.window.do("save over")
        self.is_whole(self.edits)

    def the_disk_is_full(self):
        ballast = self.disk / "ballast"
        for _ in range(5):  # what lay in the show's cache may be given back between filling and saving
            before = self.edits
            self.edit()
            self.fill(ballast)
            answer = self.window.ask("save")
            if answer.startswith("error: "):
                break
        assert answer.startswith("error: ") and "space" in answer.lower(), answer
        self.is_whole(before)
        ballast.unlink()
        self.save()

    @staticmethod
    def fill(ballast):
        with open(ballast, "ab", buffering=0) as file:
            for size in (1 << 16, 256):
                try:
                    while True:
                        file.write(bytes(size))
                except OSError:
                    pass

    def the_cable_is_pulled(self):
        self.network.cable(False)
        time.sleep(3.5)  # sources are lost after 2.5 s
        self.network.cable(True)
        self.packets_come()
        self.network.address(False)
        time.sleep(1)
        self.network.address(True)
        self.packets_come()

    def the_clock_jumps(self):
        for offset in ("+1h", "-1h", "+0"):
            self.set_clock(offset)
            time.sleep(1.5)
            self.packets_come()
            self.edit()
            self.save()

    def the_device_is_lost(self):
        self.loss.touch()
        self.until(lambda state: not self.loss.exists(), "the loss")
        self.window.do("freeze on", "wait settled", "freeze off")

    def round(self):
        for trouble in [getattr(self, name) for name in TROUBLES]:
            print(trouble.__name__.replace("_", " "), flush=True)
            trouble()
            self.edit()
            self.save()
            self.packets_come()
        return self.figures()

    def figures(self):
        """At rest, always of a picture of the same size."""
        self.window.do("freeze on", "resolution 25", "wait settled", "wait 1")
        status = pathlib.Path(f"/proc/{self.pid()}/status").read_text(encoding="utf-8")
        found = {"memory_mb": int(status.split("VmRSS:")[1].split()[0]) / 1024, "descriptors": self.descriptors(),
                 "threads": int(status.split("Threads:")[1].split()[0]), "packets_sent": int((self.work / "desk.log").read_text(encoding="utf-8").split()[-1])}
        self.window.do("freeze off")
        return found

    def descriptors(self):
        """The least of some looks: a file that is being read, by the page of what a plot has for one, is not kept."""
        looks = []
        for _ in range(8):
            looks.append(self.open_files())
            time.sleep(0.25)
        self.least_open = min(looks, key=len)
        return len(self.least_open)

    def open_files(self):
        names = []
        for link in pathlib.Path(f"/proc/{self.pid()}/fd").iterdir():
            try:
                names.append(os.readlink(link))
            except FileNotFoundError:
                pass  # it was closed meanwhile
        return sorted(names)

    def pid(self):
        return self.window.process.pid  # ip netns exec becomes what it runs

    def close(self):
        try:
            code = self.window.close()
            done = subprocess.run([PROGRAM, "check", self.show], capture_output=True, text=True)
            return code, done
        finally:
            self.desk.kill()
            self.desk_log.close()
            self.window.process.kill()
            subprocess.run(["umount", "--lazy", self.disk], check=True)


def mean(values):
    return sum(values) / len(values)


def growth(rows, key):
    """Of the last rows over the first after the warm-up: a share."""
    rest = rows[int(len(rows) * WARM_SHARE):]
    count = max(min(5, len(rest) // 2), 1)
    return mean([row[key] for row in rest[-count:]]) / mean([row[key] for row in rest[:count]]) - 1


def main():
    if os.environ.get("GHOST_SOAK_MOUNTS") is None:  # mounts that end with this process
        os.environ["GHOST_SOAK_MOUNTS"] = "own"
        if os.geteuid() != 0 or subprocess.run(["unshare", "--mount", "true"], capture_output=True).returncode:
            needs.skip("needs root for network namespaces")
        os.execvp("unshare", ["unshare", "--mount", "--propagation", "private", sys.executable, *sys.argv])
    network = Network()
    try:
        with window_driver.begin() as work:
            soak = Soak(work, network)
            begun, rows, opened = time.monotonic(), [], []
            try:
                while len(rows) < 3 or time.monotonic() - begun < SECONDS:
                    rows.append(soak.round())
                    opened.append(soak.least_open)
                    print(f"{time.monotonic() - begun:6.0f} s, round {len(rows)}: {json.dumps(rows[-1])}", flush=True)
            except BaseException:
                print(soak.window.text()[-4000:])
                raise
            finally:
                code, check = soak.close()
            assert code == 0, (code, soak.window.text()[-4000:])
            assert check.returncode == 0, check.stdout + check.stderr
    finally:
        network.close()
    warm = int(len(rows) * WARM_SHARE) if SECONDS else 0
    memory, descriptors = growth(rows, "memory_mb"), rows[-1]["descriptors"] - rows[warm]["descriptors"]
    print(f"{len(rows)} rounds in {time.monotonic() - begun:.0f} s, {soak.edits} edits: memory {100 * memory:+.1f} %, descriptors {descriptors:+d}")
    if SECONDS:
        assert memory <= MOST_GROWTH, rows
    # One socket is made in one round or in a later one; what every round leaves open is two more in three.
    assert descriptors <= 1, (rows, opened[warm], opened[-1])
    print("ok")
    return 0


if __name__ == "__main__":
    sys.exit(main())

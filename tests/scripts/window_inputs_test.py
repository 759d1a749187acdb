#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The window and what reaches it besides DMX: a plot by MVR-xchange is offered, taken and merged while the picture goes on; a remote
control (OSC) calls cues; the recording follows the network's time code. Without a screen (Qt's offscreen platform).
Usage: window_inputs_test.py SOURCE_FOLDER BUILD_FOLDER."""
import json
import os
import pathlib
import re
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import time
import zipfile

from lib import needs

needs.packages("python3-pil")
from PIL import Image, ImageStat  # noqa: E402

SOURCE = pathlib.Path(sys.argv[1]).resolve()
BUILD = pathlib.Path(sys.argv[2]).resolve()
PROGRAM = BUILD / "ghostlight"
LONG_S = 300  # for what a busy machine may take
GDTF = "Vari-Lite@VL2500_Spot.gdtf"


def free_port(kind):
    with socket.socket(socket.AF_INET, kind) as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def plot(path, places_m):
    """A plot of spots that hang at these x."""
    spots = "".join(f"""<Fixture name="Plot spot {i + 1}" uuid="2222222{i}-2222-4222-8222-222222222222">
<Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{1000 * x},1000,6000}}</Matrix><GDTFSpec>{GDTF}</GDTFSpec><GDTFMode>Standard 22 channels</GDTFMode>
<Addresses><Address break="0">{513 + 22 * i}</Address></Addresses></Fixture>""" for i, x in enumerate(places_m))
    xml = f"""<?xml version="1.0" encoding="UTF-8"?>
<GeneralSceneDescription verMajor="1" verMinor="6" provider="test" providerVersion="1"><Scene><Layers>
<Layer name="Rig" uuid="11111111-1111-4111-8111-111111111111"><ChildList>{spots}</ChildList></Layer></Layers></Scene></GeneralSceneDescription>"""
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("GeneralSceneDescription.xml", xml)
        archive.write(SOURCE / "assets" / "fixtures" / GDTF, GDTF)


class Window:
    def __init__(self, work, *arguments, show="demo", sacn_port=None):
        self.work = work
        path = work / "socket"
        environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", XDG_CONFIG_HOME=str(work / "config"), XDG_RUNTIME_DIR=str(work))
        self.log = (work / "window.log").open("w")
        self.process = subprocess.Popen([str(PROGRAM), "open", str(work / show), "--forget", "--socket", str(path), "--size", "480x320",
                                         "--sacn-port", str(sacn_port or free_port(socket.SOCK_DGRAM)), "--interface", "127.0.0.1",
                                         *map(str, arguments)], env=environment, stderr=self.log, stdout=self.log)
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(LONG_S)
        for _ in range(LONG_S * 10):
            try:
                self.socket.connect(str(path))
                break
            except OSError:
                assert self.process.poll() is None, (work / "window.log").read_text()
                time.sleep(0.1)
        self.answers = self.socket.makefile()

    def ask(self, line):
        self.socket.sendall((line + "\n").encode())
        return self.answers.readline().strip()

    def state(self):
        answer = self.ask(f'state "{self.work / "state.json"}"')
        assert answer == "ok", answer
        return json.loads((self.work / "state.json").read_text())

    def until(self, what, holds):
        end = time.monotonic() + LONG_S
        state = None
        while time.monotonic() < end:
            state = self.state()
            if holds(state):
                return state
            time.sleep(0.1)
        raise AssertionError(f"{what}: {json.dumps(state)[:2000]}\n{(self.work / 'window.log').read_text()[-3000:]}")


def osc(port, address, *arguments):
    def padded(data):
        return data + b"\0" * (4 - len(data) % 4)
    types, values = ",", b""
    for one in arguments:
        types += "s" if isinstance(one, str) else "f"
        values += padded(one.encode()) if isinstance(one, str) else struct.pack(">f", one)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
        out.sendto(padded(address.encode()) + padded(types.encode()) + values, ("127.0.0.1", port))


def timecode(port, seconds):
    frame = round(seconds * 25)
    packet = b"Art-Net\0" + struct.pack("<H", 0x9700) + struct.pack(">H", 14) + \
        bytes([0, 0, frame % 25, frame // 25 % 60, frame // 1500 % 60, frame // 90000, 1])
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
        out.sendto(packet, ("127.0.0.1", port))


def level(port):
    """One packet of sACN, universe 1, all slots 0."""
    data = b"\x02\xa1" + struct.pack(">HHH", 0, 1, 513) + bytes(513)
    def framed(length, rest):
        return struct.pack(">H", 0x7000 | length + 2) + rest
    dmp = framed(len(data), data)
    frame = struct.pack(">I", 2) + b"a desk".ljust(64, b"\0") + struct.pack(">BHBBH", 100, 0, 0, 0, 1) + dmp
    frame = framed(len(frame), frame)
    root = struct.pack(">I", 4) + b"window test desk" + frame
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
        out.sendto(struct.pack(">HH", 0x10, 0) + b"ASC-E1.17\0\0\0" + framed(len(root), root), ("127.0.0.1", port))


def work_light(work):
    """A show that nobody sends levels to opens into light; a desk that begins puts it out."""
    shutil.copytree(work / "demo", work / "dark")
    text = (work / "dark" / "show.toml").read_text().replace('recording = "demo.show"\n', "")
    (work / "dark" / "show.toml").write_text(text)
    port = free_port(socket.SOCK_DGRAM)
    window = Window(work, show="dark", sacn_port=port)
    try:
        def brightness():
            assert window.ask("wait settled") == "ok"
            assert window.ask(f'screenshot "{work / "seen.png"}"') == "ok"
            left, top, width, height = map(round, window.state()["view"])
            picture = Image.open(work / "seen.png").convert("L")
            return ImageStat.Stat(picture.crop((left, top, left + width, top + height))).mean[0]
        assert window.ask("wait opened") == "ok"
        window.until("the work light", lambda state: state["picture"]["work_light"])
        lit = brightness()
        assert lit > 25, lit
        assert window.ask("work-light off") == "ok"
        window.until("off", lambda state: not state["picture"]["work_light"])
        dark = brightness()
        assert dark < lit / 3, (dark, lit)
        assert window.ask("work-light auto") == "ok"
        window.until("by itself", lambda state: state["picture"]["work_light"])
        end = time.monotonic() + LONG_S
        while window.state()["picture"]["work_light"]:
            assert time.monotonic() < end, "a desk sends and the work light is on"
            level(port)
            time.sleep(0.1)
        assert window.ask("work-light on") == "ok"
        window.until("by hand", lambda state: state["picture"]["work_light"])
        print(f"ok: without levels the stage is seen ({lit:.0f} of 255), without work light it is not ({dark:.0f}), and a desk puts it out")
    finally:
        window.process.kill()
        window.process.wait()


def shaders(work):
    """One that is written while a picture is shown is drawn with; one that is no shader is refused, and the picture stays."""
    folder = work / "shaders"
    folder.mkdir()
    for name in ("develop", "glare_develop"):
        shutil.copy(BUILD / f"generated/shaders/{name}.spv", folder)
    window = Window(work, "--shaders", folder)
    try:
        def means(holds):
            end = time.monotonic() + LONG_S
            while time.monotonic() < end:
                assert window.ask("wait settled") == "ok"
                assert window.ask(f'screenshot "{work / "shot.png"}"') == "ok"
                left, top, width, height = map(round, window.state()["view"])
                picture = Image.open(work / "shot.png").convert("RGB").crop((left, top + height // 4, left + width, top + height * 3 // 4))
                mean = ImageStat.Stat(picture).mean
                if holds(mean):
                    return mean
                time.sleep(0.2)
            raise AssertionError(f"{mean}\n{(work / 'window.log').read_text()[-3000:]}")
        for line in ("wait opened", "jump 36", "wait 0.2", "freeze on"):
            assert window.ask(line) == "ok"
        before = means(lambda mean: mean[2] > 5)  # a blue moment
        for name in ("develop", "glare_develop"):
            text = next((SOURCE / "shaders").rglob(f"{name}.comp")).read_text()
            green = re.sub(r"imageStore\(picture, (ivec3\(.*?\)), (.*)\);", r"imageStore(picture, \1, (\2) * vec4(0, 1, 0, 1));", text)
            assert green != text
            (work / f"{name}.comp").write_text(green)
            subprocess.run(["glslc", "--target-env=vulkan1.3", "-O", "-I", SOURCE / "shaders", "-o", work / f"{name}.spv", work / f"{name}.comp"], check=True)
            os.replace(work / f"{name}.spv", folder / f"{name}.spv")
        after = means(lambda mean: mean[2] < before[2] / 3)
        assert after[1] > before[1] / 2, (before, after)
        for name in ("develop", "glare_develop"):
            (folder / f"{name}.spv").write_text("no shader")
        means(lambda mean: max(abs(a - b) for a, b in zip(mean, before)) < 1)
        assert "is no SPIR-V; the shader that was built in is used" in (work / "window.log").read_text()
        print(f"ok: shaders were taken while it ran: {[round(m) for m in before]} -> {[round(m) for m in after]}, and back")
    finally:
        window.process.kill()
        window.process.wait()


def main():
    if not PROGRAM.exists():
        print(f"skipped: {PROGRAM} is not built")
        sys.exit(77)
    work = pathlib.Path(tempfile.mkdtemp(prefix="ghost_window_"))
    station = window = None
    try:
        shutil.copytree(SOURCE / "assets" / "demo", work / "demo", ignore=shutil.ignore_patterns(".ghost"))
        os.symlink(SOURCE / "assets" / "fixtures", work / "fixtures")
        work_light(work)
        shaders(work)
        text = (work / "demo" / "show.toml").read_text().replace('stage = "stage.glb"', 'stage = "stage.glb"\nplot = "tour.mvr"', 1)
        text += '\n[[cue]]\nname = "Walk-in"\nat_s = 3\ncamera = "house"\n[[cue]]\nname = "Solo"\nat_s = 61.5\ncamera = "high"\n'
        (work / "demo" / "show.toml").write_text(text)
        plot(work / "demo" / "tour.mvr", [-1])
        plot(work / "tour.mvr", [-1, 2])
        port, osc_port, artnet = free_port(socket.SOCK_STREAM), free_port(socket.SOCK_DGRAM), free_port(socket.SOCK_DGRAM)
        window = Window(work, "--xchange", work / "come", "--peer", f"127.0.0.1:{port}", "--osc", osc_port, "--artnet-port", artnet,
                        "--timecode", "01:00:00:00")
        assert window.ask("wait opened") == "ok"
        before = window.until("the show is open", lambda state: state["fixtures"] == 11)
        refused = window.ask("take-plot")
        assert "no plot came" in refused, refused

        osc(osc_port, "/ghostlight/cue", "Solo")
        window.until("the cue", lambda state: state["camera"]["name"] == "high" and state["at_s"] > 61)
        window.ask("play off")
        osc(osc_port, "/ghostlight/cue/back")
        state = window.until("the cue before", lambda state: state["camera"]["name"] == "house" and abs(state["at_s"] - 3) < 0.2)
        print("ok: cues go to their place in the recording and to their camera")

        for second in (3630.0, 3630.04, 3630.08):
            timecode(artnet, second)
            time.sleep(0.04)
        # It goes on for a second without time code, which may be over before a busy window is asked.
        window.until("the time code's place", lambda state: 30 <= state["at_s"] < 31.2)
        timecode(artnet, 3612.0)
        window.until("its jump", lambda state: abs(state["at_s"] - 12.0) < 0.1)
        print("ok: the recording follows the time code")

        station = subprocess.Popen([str(PROGRAM), "xchange", "--share", str(work / "tour.mvr"), "--no-find", "--port", str(port),
                                    "--station", "Desk", "--interface", "127.0.0.1", "--quiet"], stdout=subprocess.DEVNULL)
        state = window.until("the plot is offered", lambda state: state["received_plot"])
        assert state["fixtures"] == 11 and state["camera"]["name"] == "house", "nothing was taken yet"
        assert window.ask("camera close") == "ok"
        state = window.until("the camera is there", lambda state: state["camera"]["name"] == "close")
        assert window.ask("take-plot") == "ok"
        pictures = 0
        end = time.monotonic() + LONG_S
        while time.monotonic() < end:
            assert window.ask(f"master {1 - pictures % 2 / 2}") == "ok"
            state = window.state()
            if state["fixtures"] == 12:
                break
            pictures += 1
            time.sleep(0.05)
        assert state["fixtures"] == 12, "the plot was not taken: " + (work / "window.log").read_text()[-3000:]
        assert state["camera"]["name"] == "close", state["camera"]
        window.until("and the recording is where it was", lambda state: abs(state["at_s"] - 12.0) < 0.2)
        assert pictures > 0, "the window did not answer while the newer show was opened"
        assert (work / "demo" / "tour.mvr").read_bytes() == (work / "tour.mvr").read_bytes()
        window.until("it draws the newer one", lambda state: "Plot spot 2" in state["lamps"])
        print(f"ok: the plot was merged; the window answered {pictures} times meanwhile")
        assert before["device"] == state["device"]
    finally:
        for process in (station, window and window.process):
            if process:
                process.kill()
                process.wait()
        shutil.rmtree(work, ignore_errors=True)


main()

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A camera (Video4Linux) that a projector shows, as a user meets it: its colours on the wall, pulled out and plugged in while the
picture goes on, and what a silent, a busy and a strange one say. The camera is tests/camera/fake_camera.cpp.
Usage: camera_test.py SOURCE_FOLDER BUILD_FOLDER."""
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from lib import needs

needs.packages("python3-pil")
from PIL import Image  # noqa: E402

SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
LONG_S = 120  # for what a busy machine may take
RED, GREEN = "yuyv 81 90 240", "yuyv 145 54 34"
SHOW = f"""
[show]
name = "A camera"
recording = "dark.show"
stage = "{SOURCE / 'assets/optics/stage.glb'}"
[haze]
preset = "none"
[[camera]]
name = "front"
position_m = [0, -3, 3]
target_m = [0, 10, 3]
fov_y_deg = 30
size = [160, 90]
ev100 = 7
[[media]]
name = "eye"
camera = "camera0"
[[media]]
name = "still"
file = "blue.png"
[[fixture]]
name = "Beamer"
position_m = [0, -4, 4.5]
projector = {{ media = "eye", throw_ratio = 4, target_m = [0, 10, 4.5], lumens = 5000, focus_m = 14 }}
[[fixture]]
name = "Neighbour"
position_m = [0, -4, 1.5]
projector = {{ media = "still", throw_ratio = 4, target_m = [0, 10, 1.5], lumens = 5000, focus_m = 14 }}
"""


class Stage:
    """A show with a camera in a window without a screen, driven over its socket."""

    def __init__(self, folder):
        self.folder = folder
        self.device, self.does = folder / "camera0", folder / "does"
        (folder / "show.toml").write_text(SHOW)
        Image.new("RGB", (64, 48), (0, 0, 255)).save(folder / "blue.png")
        (folder / "dark.show").write_text("OLA Show\n1 0,0,0\n40\n1 0,0,0\n4000\n")
        libraries = str(BUILD / "tests/libfake_camera.so")
        self.environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", XDG_CONFIG_HOME=str(folder / "config"), LD_PRELOAD=libraries,
                                FAKE_CAMERA=str(self.device), FAKE_CAMERA_DOES=str(self.does),
                                # Those of Debian 12 want to be the first library.
                                ASAN_OPTIONS=os.environ.get("ASAN_OPTIONS", "") + ":verify_asan_link_order=0")

    def plug_in(self, does):
        self.does.write_text(does + "\n")
        if not self.device.is_symlink():
            self.device.symlink_to("/dev/null")

    def allow(self):
        if not self.device.is_symlink():
            self.device.symlink_to("/dev/null")
        subprocess.run([BUILD / "ghostlight", "capture", self.device], env=self.environment, check=True, capture_output=True)

    def pull_out(self):
        self.device.unlink()

    def render(self):
        done = subprocess.run([BUILD / "ghostlight", "render", self.folder, "--live", "--no-shadows", "--at", "0", "-o", self.folder / "still.png"],
                              env=self.environment, capture_output=True, text=True, timeout=LONG_S)
        return done.stdout + done.stderr

    def open(self):
        self.log = (self.folder / "window.log").open("w")
        path = str(self.folder / "socket")
        self.process = subprocess.Popen([BUILD / "ghostlight", "open", self.folder, "--forget", "--no-desk", "--size", "320x240", "--socket", path],
                                        env=self.environment, stdout=self.log, stderr=self.log)
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(LONG_S)
        for _ in range(10 * LONG_S):
            try:
                self.socket.connect(path)
                break
            except OSError:
                assert self.process.poll() is None, self.text()
                time.sleep(0.1)
        self.answers = self.socket.makefile()
        self.do("wait opened")
        for line in ("tone linear", "exposure 7"):
            self.do(line)
        end_s = time.monotonic() + LONG_S
        while "no picture yet" in self.ask(f'save-picture "{self.folder / "now.png"}"'):
            assert time.monotonic() < end_s, self.text()
            time.sleep(0.2)
        while not blue(*self.colours()[1]):  # a picture of before its media came is black
            assert time.monotonic() < end_s, self.text()
            time.sleep(0.2)

    def text(self):
        return (self.folder / "window.log").read_text()

    def ask(self, line):
        self.socket.sendall((line + "\n").encode())
        return self.answers.readline().strip()

    def do(self, line):
        answer = self.ask(line)
        assert answer == "ok", f"{line}: {answer}\n{self.text()}"

    def close(self):
        self.do("quit")
        for one in (self.answers, self.socket, self.log):
            one.close()
        return self.process.wait(timeout=LONG_S)

    def colours(self):
        """What the two projectors throw on the wall now: the camera's picture above, the still one below."""
        file = self.folder / "now.png"
        self.do(f'save-picture "{file}"')
        with Image.open(file) as picture:
            middle = picture.height // 2
            halves = [picture.convert("RGB").crop((0, y, picture.width, y + middle)) for y in (0, middle)]
        return [brightest(half) for half in halves]

    def until(self, holds, what):
        end_s = time.monotonic() + LONG_S
        while time.monotonic() < end_s:
            colour, neighbour = self.colours()
            assert blue(*neighbour), f"{neighbour} below a camera that should be {what}\n{self.text()}"
            if holds(*colour):
                return
            time.sleep(0.2)
        raise AssertionError(f"not {what} but {colour}\n{self.text()}")

    def until_said(self, words, times=1):
        end_s = time.monotonic() + LONG_S
        while time.monotonic() < end_s:
            if self.text().count(words) >= times:
                return
            time.sleep(0.2)
        raise AssertionError(f"never said '{words}'\n{self.text()}")


def brightest(picture):
    lit = sorted(picture.getdata(), key=sum)[-picture.width * picture.height // 20:]
    return tuple(sum(pixel[k] for pixel in lit) / len(lit) for k in range(3))


def red(r, g, b):
    return r > 60 and r > 3 * g and r > 3 * b


def green(r, g, b):
    return g > 60 and g > 3 * r and g > 3 * b


def blue(r, g, b):
    return b > 60 and b > 3 * r and b > 3 * g


def striped(r, g, b):
    return r > 60 and b > 60 and g < 0.7 * r


class Camera(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.stage = Stage(pathlib.Path(self.folder.name).resolve())
        self.addCleanup(self.folder.cleanup)

    def test_pulled_out_and_plugged_in(self):
        stage = self.stage
        stage.plug_in(RED)
        stage.open()
        stage.until(striped, "the striped card")
        stage.until_said("nobody has allowed on this machine that shows open it")
        stage.allow()
        stage.until(red, "red")
        stage.does.write_text(GREEN + "\n")
        stage.until(green, "green")
        # The driver first, the device a moment later.
        stage.does.write_text("gone\n")
        stage.until(striped, "the striped card")
        stage.pull_out()
        stage.until_said("there is no such camera")
        begin_s = time.monotonic()
        stage.plug_in(RED)
        stage.until(red, "red again")
        stage.until_said("is there again")
        print(f"plugged in, it was seen after {time.monotonic() - begin_s:.1f} s")
        stage.pull_out()
        stage.until(striped, "the striped card again")
        picture = stage.folder / "frame.jpg"
        Image.new("RGB", (64, 48), (0, 255, 0)).save(picture)
        stage.plug_in(f"jpeg {picture}")
        stage.until(green, "the green of Motion JPEG")
        picture.write_bytes(picture.read_bytes()[:60])
        stage.until_said("pictures that cannot be read")
        stage.until(striped, "the striped card for damaged pictures")
        self.assertEqual(stage.close(), 0, stage.text())

    def test_a_silent_one_is_said_and_comes_back(self):
        stage = self.stage
        stage.allow()
        stage.plug_in(GREEN)
        stage.open()
        stage.until(green, "green")
        stage.does.write_text("silent\n")
        stage.until_said("sends no pictures")
        stage.until(striped, "the striped card")
        self.assertNotIn("is there again", stage.text())
        stage.does.write_text(GREEN + "\n")
        stage.until(green, "green again")
        self.assertEqual(stage.close(), 0, stage.text())

    def test_each_trouble_has_its_sentence(self):
        for does, words in (("busy", "is in use by another program"), ("grey", "has neither Motion JPEG nor YUYV"),
                            ("short", "pictures that cannot be read"), ("gone", "the camera is gone"), ("silent", "sends no pictures")):
            self.stage.allow()
            self.stage.plug_in(does)
            text = self.stage.render()
            self.assertIn(words, text, does)
            self.assertIn("'eye'", text, does)
        self.stage.pull_out()
        self.assertIn("there is no such camera", self.stage.render())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)

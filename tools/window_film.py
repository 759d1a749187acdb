#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Films the window on a screen of its own (Xvfb) while a script works in it, and looks for flicker: a picture that differs from the
one before and is gone with the next. Frames go to FOLDER as PNG, with worst.png (before, flicker, after) and film.mp4 where ffmpeg is.

usage: window_film.py BUILD_FOLDER FOLDER [--show assets/demo] [--seconds 10] [--fps 25] [--screen 1920x1080] [--do "LINE"]...
"""
import argparse
import mmap
import os
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy
from PIL import Image

WAIT_S = 120
SMALL = (96, 54)  # of what is compared: what is smaller is no flicker


class Screen:
    """Xvfb, whose picture lies in a file."""

    def __init__(self, size):
        self.folder = tempfile.TemporaryDirectory()
        reading, writing = os.pipe()
        self.process = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{size}x24", "-fbdir", self.folder.name, "-nolisten", "tcp"],
                                        pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as line:  # whole: Xvfb ends where nobody reads its end
            number = line.readline().strip()
        if not number:
            sys.exit("Xvfb does not start (package xvfb)")
        self.name = f":{number}"
        with open(Path(self.folder.name) / "Xvfb_screen0", "rb") as file:
            self.map = mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ)
        head = struct.unpack(">25I", self.map[:100])  # XWD: X Window Dump, version 7
        self.begin, self.width, self.height, self.row = head[0] + 12 * head[19], head[4], head[5], head[12]

    def grab(self):
        pixels = numpy.frombuffer(self.map, numpy.uint8, self.row * self.height, self.begin).reshape(self.height, self.row)
        return pixels[:, :4 * self.width].reshape(self.height, self.width, 4)[..., 2::-1].copy()

    def close(self):
        self.process.terminate()
        self.process.wait()
        self.map.close()
        self.folder.cleanup()


class Window:
    def __init__(self, program, show, screen, size):
        self.folder = tempfile.TemporaryDirectory()
        path = str(Path(self.folder.name) / "socket")
        environment = dict(os.environ, DISPLAY=screen.name, XDG_CONFIG_HOME=self.folder.name)
        environment.pop("WAYLAND_DISPLAY", None)
        self.process = subprocess.Popen([program, "open", show, "--forget", "--quiet", "--language", "en", "--no-desk", "--size", size, "--socket", path], env=environment)
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(WAIT_S)
        for _ in range(WAIT_S * 10):
            try:
                self.socket.connect(path)
                break
            except OSError:
                if self.process.poll() is not None:
                    sys.exit("the window did not open")
                time.sleep(0.1)
        self.answers = self.socket.makefile()

    def send(self, line):
        self.socket.sendall(f"{line}\n".encode())

    def answer(self):
        said = self.answers.readline().strip()
        if said != "ok":
            sys.exit(f"the window: {said}")

    def close(self):
        self.send("quit anyway")
        self.process.wait(WAIT_S)
        self.folder.cleanup()


def flicker(frames):
    """Of each frame but the first and the last: how much of it is neither in the one before nor in the one after, 0 to 255."""
    small = [numpy.asarray(Image.fromarray(frame).resize(SMALL, Image.Resampling.BOX), numpy.float32) for frame in frames]
    found = []
    for before, now, after in zip(small, small[1:], small[2:]):
        low, high = numpy.minimum(before, after), numpy.maximum(before, after)
        found.append(float(numpy.maximum(numpy.maximum(low - now, now - high), 0).mean()))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--show", default="assets/demo")
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--fps", type=float, default=25)
    parser.add_argument("--screen", default="1920x1080")
    parser.add_argument("--do", action="append", default=[], help="a line of docs/guide/window.md, when the film begins")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    screen = Screen(given.screen)
    window = Window(str(given.build / "ghostlight"), given.show, screen, given.screen)
    try:
        window.send("wait opened")
        window.answer()
        window.send("jump 20")
        window.answer()
        for line in given.do:
            window.send(line)  # their waits are filmed, too
        frames, begin = [], time.monotonic()
        for k in range(int(given.seconds * given.fps)):
            time.sleep(max(begin + k / given.fps - time.monotonic(), 0))
            frames.append(screen.grab())
    finally:
        window.close()
        screen.close()
    for k, frame in enumerate(frames):
        Image.fromarray(frame).save(given.folder / f"{k:05}.png", compress_level=1)
    found = flicker(frames)
    worst = max(range(len(found)), key=found.__getitem__)
    Image.fromarray(numpy.concatenate(frames[worst:worst + 3], axis=1)).save(given.folder / "worst.png")
    if shutil.which("ffmpeg"):
        subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(given.fps), "-i", str(given.folder / "%05d.png"), "-pix_fmt", "yuv420p",
                        str(given.folder / "film.mp4")], check=True)
    pictures = 1 + sum(not numpy.array_equal(a, b) for a, b in zip(frames, frames[1:]))
    print(f"{len(frames)} frames, {pictures} of them new; flicker at most {found[worst]:.2f} of 255, in frame {worst + 1} "
          f"({(worst + 1) / given.fps:.2f} s); median {sorted(found)[len(found) // 2]:.3f}")


main()

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The window comes back where it was when it was closed, on a screen of its own: without a window manager, and with one (openbox) whose
frames have a title. Usage: window_place_test.py SOURCE_FOLDER BUILD_FOLDER."""
import os
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "lib"))
import needs  # noqa: E402

needs.packages("openbox")
import window as window_driver  # noqa: E402
from window import Window, main  # noqa: E402

WORK = None


def asked(*words):
    return subprocess.run(words, env=dict(os.environ, DISPLAY=window_driver.DISPLAY), capture_output=True, text=True, check=True).stdout


def windows(window):
    """Of its process: number, x, y, width and height on the screen; the largest is the one that is meant."""
    found = asked("xdotool", "search", "--onlyvisible", "--pid", str(window.process.pid)).split()
    for one in found:
        words = dict(line.split("=") for line in asked("xdotool", "getwindowgeometry", "--shell", one).splitlines() if "=" in line)
        yield one, tuple(int(words[key]) for key in ("X", "Y", "WIDTH", "HEIGHT"))


def largest(window):
    return max(windows(window), key=lambda one: one[1][2] * one[1][3])


def place(window):
    """Once it stays."""
    before = None
    for _ in range(100):
        now = largest(window)[1]
        if now == before:
            return now
        before = now
        time.sleep(0.5)
    raise AssertionError("it never rests")


class Place(unittest.TestCase):
    def setUp(self):
        shutil.rmtree(WORK / "config", ignore_errors=True)
        self.manager = None

    def tearDown(self):
        if self.manager:
            self.manager.terminate()
            self.manager.wait()

    def manage(self):
        self.manager = subprocess.Popen(["openbox"], env=dict(os.environ, DISPLAY=window_driver.DISPLAY), stderr=subprocess.DEVNULL)
        time.sleep(1)

    def starts(self, count, change=None):
        """Places of so many windows, one after the other; change: done to the first."""
        places = []
        for number in range(count):
            window = Window("--no-desk", "--quiet", remembers=True)
            try:
                window.do("wait opened", "wait 0.5")
                if number == 0 and change:
                    place(window)
                    change(window)
                places.append(place(window))
            finally:
                self.assertEqual(window.close(), 0)
        return places

    def move(self, *to):
        def change(window):
            one = largest(window)[0]
            if self.manager:  # it begins as large as the screen; a double click on its title changes that
                window.xdo("mousemove", 800, 8, "click", "--repeat", 2, "--delay", 80, 1)
                time.sleep(1)
            window.xdo("windowsize", one, 900, 600, "windowmove", one, *to)
            time.sleep(0.5)
        return change

    def test_without_a_window_manager(self):
        places = self.starts(3)
        self.assertEqual(len(set(places)), 1, places)

    def test_without_a_window_manager_moved(self):
        places = self.starts(3, self.move(120, 0))
        self.assertEqual(places[0][:2], (120, 0))
        self.assertEqual(len(set(places)), 1, places)

    def test_with_one_as_large_as_the_screen(self):
        self.manage()
        places = self.starts(3)
        self.assertEqual(len(set(places)), 1, places)

    def test_with_one_moved(self):
        self.manage()
        for to in ((200, 150), (300, 0)):
            shutil.rmtree(WORK / "config", ignore_errors=True)
            places = self.starts(3, self.move(*to))
            self.assertEqual(places[0][2:], (900, 600))
            self.assertEqual(len(set(places)), 1, places)


if __name__ == "__main__":
    sys.exit(main(sys.modules[__name__]))

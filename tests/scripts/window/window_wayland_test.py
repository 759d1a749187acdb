#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The window on Wayland: Weston on a screen of its own, with a real mouse and keyboard. What stands on that screen is compared with what
the window means to show. And displays, of either kind, that die. Usage: window_wayland_test.py SOURCE_FOLDER BUILD_FOLDER
[FOLDER_FOR_PICTURES]."""
import os
import pathlib
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "lib"))
import needs  # noqa: E402

needs.packages("weston", "qt6-wayland")
import window as window_driver  # noqa: E402
from window import LONG_S, Window, changed  # noqa: E402

import numpy  # noqa: E402
from PIL import Image, ImageGrab  # noqa: E402

SIZE = (1500, 900)
BESIDE = 40  # pixels of the screen
WESTON = """[core]
idle-time=0
[shell]
panel-position=none
locking=false
animation=none
startup-animation=none
close-animation=none
"""
ALIKE = 1.5  # of 255, in the mean: the picture may move on between two looks at it


def read(file):
    return numpy.asarray(Image.open(file).convert("RGB")).astype(float)


class Weston:
    def __init__(self, folder):
        self.runtime = folder / "run"
        self.runtime.mkdir(mode=0o700, exist_ok=True)
        (folder / "weston.ini").write_text(WESTON)
        # Weston follows a mouse that enters its window.
        subprocess.run(["xdotool", "mousemove", str(SIZE[0] + BESIDE // 2), "10"], env=dict(os.environ, DISPLAY=window_driver.DISPLAY), check=True)
        self.log = open(folder / "weston.log", "w")
        self.process = subprocess.Popen(
            ["weston", "--backend=x11-backend.so", f"--config={folder}/weston.ini", "--socket=ghost", f"--width={SIZE[0]}", f"--height={SIZE[1]}"],
            env=dict(os.environ, DISPLAY=window_driver.DISPLAY, XDG_RUNTIME_DIR=str(self.runtime)), stdout=self.log, stderr=self.log)
        until_s = time.monotonic() + LONG_S
        while not (self.runtime / "ghost").exists():
            assert self.process.poll() is None and time.monotonic() < until_s, pathlib.Path(self.log.name).read_text()
            time.sleep(0.5)

    def opens(self, *arguments):
        """A window on it, with the demo at rest."""
        window = Window("--no-desk", "--quiet", *arguments,
                        before=("env", "-u", "DISPLAY", "WAYLAND_DISPLAY=ghost", f"XDG_RUNTIME_DIR={self.runtime}"))
        window.do("wait opened", "jump 36", "wait 0.2", "freeze on", "resolution 12", "wait settled")
        return window

    def ends(self):
        self.process.terminate()
        self.process.wait()


class Screen:
    """What stands on it. The window's own pixels begin below its title and within its frame."""

    def __init__(self, window):
        self.window = window
        own, all_of_it = self.own(), self.seen()
        self.left = (SIZE[0] - own.shape[1]) // 2
        rows = range(all_of_it.shape[0] - own.shape[0] + 1)
        self.top = min(rows, key=lambda row: changed(all_of_it[row:row + own.shape[0], self.left:self.left + own.shape[1]], own))

    def seen(self):
        return numpy.asarray(ImageGrab.grab(xdisplay=window_driver.DISPLAY).convert("RGB")).astype(float)[:SIZE[1], :SIZE[0]]

    def own(self):
        file = window_driver.WORK / "own.png"
        self.window.do(f'screenshot "{file}"')
        return read(file)

    def differs(self):
        """From what the window means to show, in the mean of the part that differs most."""
        own = self.own()
        seen = self.seen()[self.top:self.top + own.shape[0], self.left:self.left + own.shape[1]]
        blocks = [changed(seen[y:y + 60, x:x + 60], own[y:y + 60, x:x + 60]) for y in range(0, own.shape[0], 60) for x in range(0, own.shape[1], 60)]
        return max(blocks)

    def until(self, holds, what):
        until_s = time.monotonic() + 60
        while not holds():
            assert time.monotonic() < until_s, what
            time.sleep(0.2)

    def until_alike(self, what):
        self.until(lambda: self.differs() < 3 * ALIKE, f"{what}: the screen differs from the window by {self.differs():.1f}")

    def at(self, x, y):
        """The mouse, in the window's pixels. Weston follows one that enters its own window, and not always at once: its pointer is seen
        to move."""
        before = self.seen()
        place = numpy.s_[max(y + self.top - 4, 0):y + self.top + 20, x + self.left:x + self.left + 16]
        until_s = time.monotonic() + 60
        while changed(self.seen()[place], before[place]) < 1:
            assert time.monotonic() < until_s, "Weston's pointer does not come"
            for step in (SIZE[0] + BESIDE // 2 - x - self.left, 2, 1, 0):
                self.window.xdo("mousemove", x + self.left + step, y + self.top)
                time.sleep(0.3)


class Wayland(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.weston = Weston(window_driver.WORK)

    @classmethod
    def tearDownClass(cls):
        cls.weston.ends()

    def press(self, window, holds):
        """F11, and once more where the compositor, on a busy machine, had not given its focus yet."""
        for _ in range(3):
            window.xdo("key", "F11")
            until_s = time.monotonic() + 20
            while time.monotonic() < until_s:
                if holds(window.state()):
                    return
                time.sleep(0.2)
        window.until(holds)

    def test_full_screen_and_back(self):
        window = self.weston.opens()
        try:
            screen = Screen(window)
            screen.until_alike("opened")
            before = window.place()
            self.assertGreater(screen.own().shape[1], SIZE[0] - 20, "it is opened maximised")
            screen.at(before[0] + 200, before[1] + 200)
            self.press(window, lambda state: state["view"][2:] == list(SIZE))
            self.press(window, lambda state: state["view"] == before)
            screen.until_alike("back from full screen")
            window.do("second-display window", "wait 1", "second-display off", "wait 0.5")
            screen.until_alike("a second window came and went")
        finally:
            self.assertEqual(window.close(), 0)

    def test_menus_open_at_the_mouse(self):
        window = self.weston.opens()
        try:
            screen = Screen(window)
            x, y, width, height = window.place()
            window.do('select "Spot 1"', "wait settled")
            screen.at(x + width // 2, y + height // 3)
            before = screen.seen()
            window.xdo("click", "3")
            row, column = screen.top + y + height // 3, screen.left + x + width // 2
            beside = numpy.s_[row + 20:row + 120, column + 20:column + 120]
            screen.until(lambda: changed(screen.seen()[beside], before[beside]) > 4, "no menu at the mouse")
            window.xdo("key", "Down", "Return")  # aim here
            window.until(lambda state: state["by_hand"]["fixtures"])
            window.xdo("key", "ctrl+z")
            window.until(lambda state: not state["by_hand"]["fixtures"])
        finally:
            self.assertEqual(window.close(), 0)

    def test_a_panel_is_torn_off_and_put_back(self):
        window = self.weston.opens()
        try:
            screen = Screen(window)
            left, top = window.place()[:2]
            docked = screen.own()[:, :left]
            screen.at(left - 34, top + 12)  # the button in its title
            window.xdo("click", "1")
            screen.until(lambda: screen.own()[:, :left].shape != docked.shape or changed(screen.own()[:, :left], docked) > 2, "it was not torn off")
            window.do("panels-dock", "wait 0.5")
            screen.until(lambda: window.place()[0] == left and changed(screen.own()[:, :left], docked) < ALIKE, "it is not back")
            screen.until_alike("put back")
        finally:
            self.assertEqual(window.close(), 0)


class Dying(unittest.TestCase):
    """A compositor or a server that dies takes no change with it."""

    def dies(self, open_window, kill):
        draft = window_driver.WORK / "demo/.ghost/draft.toml"
        window = open_window()
        window.do('select "Spot 1"', "move 0.5 0 0")
        window.until(lambda state: state["unsaved"])
        for _ in range(LONG_S * 10):
            if draft.exists():
                break
            time.sleep(0.5)
        kill()
        self.assertEqual(window.process.wait(timeout=LONG_S), 1)
        self.assertEqual(window.text().count("the display is gone"), 1, window.text())
        window = Window("--no-desk", "--quiet", "--size", "480x320")
        try:
            window.do("wait opened")
            self.assertTrue(window.state()["changes_wait"])
            window.do("drop-changes")
        finally:
            window.close()

    def test_wayland(self):
        weston = Weston(window_driver.WORK)
        self.dies(weston.opens, weston.ends)

    def test_x11(self):
        reader, writer = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "800x600x24", "-nolisten", "tcp"], pass_fds=[writer],
                                  stderr=subprocess.DEVNULL)
        os.close(writer)
        display = ":" + os.fdopen(reader).readline().strip()

        def opens():
            window = Window("--no-desk", "--quiet", "--size", "480x320", before=("env", f"DISPLAY={display}"))
            window.do("wait opened")
            return window

        def kill():
            server.kill()
            server.wait()
        self.dies(opens, kill)


if __name__ == "__main__":
    sys.exit(window_driver.main(sys.modules[__name__], "-screen", "0", f"{SIZE[0] + BESIDE}x{SIZE[1]}x24"))

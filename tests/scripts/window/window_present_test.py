#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The picture on a surface of the display, shown by the device itself: what stands on the screen of an X server, looked at from outside of
the program, against what the window would paint; with marks and figures over it, under a mouse and keys, in another size, in a second
window, and after the surface and the device were lost. All of it with the validation layer. Usage: window_present_test.py SOURCE_FOLDER
BUILD_FOLDER [FOLDER_FOR_PICTURES]."""
import os
import pathlib
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "lib"))
import needs  # noqa: E402

needs.packages("openbox")
import window as window_driver  # noqa: E402
from window import PROGRAM, Window, changed, main  # noqa: E402

import numpy  # noqa: E402
from PIL import Image, ImageGrab  # noqa: E402

WORK = None
SIZE = (1000, 640)
ALIKE = 2.5  # of 255, in the mean of a block: colours are rounded otherwise
BLOCK = 40
BY_DEVICE = "shown by the graphics device"


def read(file):
    return numpy.asarray(Image.open(file).convert("RGB")).astype(float)


def screen():
    return numpy.asarray(ImageGrab.grab(xdisplay=window_driver.DISPLAY).convert("RGB")).astype(float)


class Present(unittest.TestCase):
    def opens(self, *arguments, environment=None, show_it="device"):
        window = Window("--no-desk", "--quiet", "--validation", "--size", f"{SIZE[0]}x{SIZE[1]}", "--present", show_it, *arguments, environment=environment)
        window.do("wait opened", "jump 36", "wait 0.2", "freeze on", "resolution 25", "wait settled")
        return window

    def closes(self, window):
        self.assertEqual(window.close(), 0, window.text())
        self.assertNotIn("Vulkan validation", window.text())

    def seen(self, window):
        """What the screen has where the picture of the window is."""
        x, y, width, height = window.place()
        return screen()[y:y + height, x:x + width]

    def painted(self, window):
        """The same as the window itself would paint it. The picture reaches to the window's right border; what stands above it is as high
        as makes both most alike."""
        file = WORK / "painted.png"
        window.do("wait settled", f'screenshot "{file}"')
        own, seen = read(file), self.seen(window)
        height, width = seen.shape[:2]
        left = own.shape[1] - width
        if own.shape not in self.tops:
            rows = range(own.shape[0] - height + 1)
            self.tops[own.shape] = min(rows, key=lambda row: changed(own[row:row + height, left:], seen))
        top = self.tops[own.shape]
        return own[top:top + height, left:]

    def differs(self, window):
        a, b = self.seen(window), self.painted(window)
        if a.shape != b.shape:
            return 255.0
        return max(changed(a[y:y + BLOCK, x:x + BLOCK], b[y:y + BLOCK, x:x + BLOCK])
                   for y in range(0, a.shape[0], BLOCK) for x in range(0, a.shape[1], BLOCK))

    def until_alike(self, window, what):
        until_s = time.monotonic() + 60
        while (by := self.differs(window)) > ALIKE:
            if time.monotonic() > until_s:
                self.keep(window, f"unlike-{what.replace(' ', '-')}")
                raise AssertionError(f"{what}: the screen differs from the window by {by:.1f}\n{window.text()}")
            time.sleep(0.3)

    def keep(self, window, name):
        if window_driver.PICTURES:
            Image.fromarray(screen().astype(numpy.uint8)).save(window_driver.PICTURES / f"{name}.png")
            Image.fromarray(self.painted(window).astype(numpy.uint8)).save(window_driver.PICTURES / f"{name}-painted.png")

    def setUp(self):
        self.manager = None
        self.tops = {}  # of the picture in the window, by the window's size

    def tearDown(self):
        if self.manager:
            self.manager.terminate()
            self.manager.wait()

    def test_marks_figures_mouse_keys_and_sizes(self):
        self.manager = subprocess.Popen(["openbox"], env=dict(os.environ, DISPLAY=window_driver.DISPLAY), stderr=subprocess.DEVNULL)
        time.sleep(1)
        window = self.opens()
        try:
            window.until(lambda state: state["picture"]["shower"].startswith(BY_DEVICE))
            self.until_alike(window, "opened")
            without = self.seen(window)
            window.do('select "Spot 1"', "figures on", "wait settled")
            self.until_alike(window, "marks and figures")
            self.keep(window, "present-marks")
            x, y = map(int, window.state()["lamps"]["Spot 1"])
            ring = numpy.s_[max(y - 12, 0):y + 12, max(x - 12, 0):x + 12]
            self.assertGreater(changed(self.seen(window)[ring], without[ring]), 5, "no ring round the lamp")
            self.assertGreater(changed(self.seen(window)[-60:, :200], without[-60:, :200]), 5, "no figures")
            # The toast lies over the picture, and is a part of the window.
            window.do("black-out on")
            self.until_alike(window, "black-out")
            window.do("black-out off", "wait settled")
            # The mouse reaches what lies below the surface.
            left, top, width, height = window.place()
            before = window.state()["camera"]
            window.xdo("mousemove", left + width // 2, top + height // 2, "mousedown", 1, "mousemove_relative", 60, 0, "mousemove_relative", 20, 0, "mouseup", 1)
            window.until(lambda state: state["camera"] != before)
            window.xdo("key", "b")
            window.until(lambda state: state["black_out"])
            window.xdo("key", "b")
            window.until(lambda state: not state["black_out"])
            self.until_alike(window, "turned by the mouse")
            # A picture of fewer pixels is smoothed alike.
            window.do("resolution 10", "wait settled")
            self.until_alike(window, "coarse")
            one = max(subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Ghostlight"], env=dict(os.environ, DISPLAY=window_driver.DISPLAY),
                                     capture_output=True, text=True, check=True).stdout.split())
            for size in ((900, 560), (SIZE[0] + 60, SIZE[1] + 40)):
                window.xdo("windowsize", one, *size)
                time.sleep(1)
                self.until_alike(window, f"{size[0]}x{size[1]}")
        finally:
            self.closes(window)

    def test_second_window(self):
        window = self.opens()
        try:
            window.until(lambda state: state["picture"]["shower"].startswith(BY_DEVICE))
            window.do("second-display window", "wait 1", "wait settled")
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Ghostlight, the picture"], env=dict(os.environ, DISPLAY=window_driver.DISPLAY),
                                   capture_output=True, text=True, check=True).stdout.split()
            window.xdo("windowmove", found[-1], 600, 300)
            picture = window.picture("second")
            width, height = 960, 540
            high = min(height, width * picture.shape[0] // picture.shape[1])
            wide = min(width, height * picture.shape[1] // picture.shape[0])
            wanted = numpy.zeros((height, width, 3))
            top, left = (height - high) // 2, (width - wide) // 2
            wanted[top:top + high, left:left + wide] = numpy.asarray(Image.fromarray(picture.astype(numpy.uint8)).resize((wide, high), Image.BILINEAR))
            until_s = time.monotonic() + 60
            while (by := changed(screen()[300:300 + height, 600:600 + width], wanted)) > 3:
                self.assertLess(time.monotonic(), until_s, f"the second window differs by {by:.1f}")
                time.sleep(0.5)
            if window_driver.PICTURES:
                Image.fromarray(screen().astype(numpy.uint8)).save(window_driver.PICTURES / "present-second.png")
            # What it had covered is shown again.
            window.xdo("windowmove", found[-1], SIZE[0], 500)
            self.until_alike(window, "uncovered")
            window.do("second-display off", "wait 0.5")
            self.until_alike(window, "the second one went")
        finally:
            self.closes(window)

    def test_surface_and_device_are_lost(self):
        surface, device = WORK / "lose-surface", WORK / "lose-device"
        window = self.opens(environment={"LD_PRELOAD": str(PROGRAM.parent / "tests/libfake_loss.so"), "FAKE_SURFACE_LOSS": str(surface),
                                         "FAKE_LOSS": str(device)})
        try:
            window.until(lambda state: state["picture"]["shower"].startswith(BY_DEVICE))
            window.do('select "Spot 2"', "figures on")
            self.until_alike(window, "opened")
            for lost in (surface, device, surface):
                lost.touch()
                window.do("black-out on", "wait 1", "black-out off")
                until_s = time.monotonic() + 120
                while lost.exists():
                    self.assertLess(time.monotonic(), until_s)
                    time.sleep(0.2)
                window.do("wait settled")
                self.until_alike(window, f"after {lost.name}")
                state = window.state()
                self.assertEqual(state["selection"], ["Spot 2"])
                self.assertTrue(state["picture"]["shower"].startswith(BY_DEVICE), state["picture"]["shower"])
        finally:
            self.closes(window)

    def test_whoever_is_faster_shows_it(self):
        window = self.opens(show_it="measured")
        try:
            words = window.until(lambda state: state["picture"]["shower"])["picture"]["shower"]
            self.assertRegex(words, r"^shown by the (window|graphics device) in [0-9.]+ ms, by the (graphics device|window) it took [0-9.]+ ms$")
            print(words)
            window.do("figures on")
            self.until_alike(window, "measured")
        finally:
            self.closes(window)

    def test_the_window_alone(self):
        window = self.opens(show_it="window")
        try:
            self.assertEqual(window.state()["picture"]["shower"], "")
            self.until_alike(window, "painted")
        finally:
            self.closes(window)


if __name__ == "__main__":
    sys.exit(main(sys.modules[__name__], "-screen", "0", "1600x1000x24"))

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A film on an LED wall that follows the network's time code in a show without a recording: it stands with it, jumps with it, and
goes on by itself where there is none. The film is made here: it gets brighter with time. Usage: film_timecode_test.py SOURCE_FOLDER
BUILD_FOLDER."""
import pathlib
import socket
import struct
import subprocess
import sys
import time
import unittest

from lib import window
from lib.window import PROGRAM, Window, numpy

WORK = None
WALL = """
[show]
name = "A wall"
stage = "{source}/assets/optics/stage.glb"
{more}
[haze]
preset = "none"
[[camera]]
name = "front"
position_m = [0, -3, 3]
target_m = [0, 5, 3]
fov_y_deg = 20
size = [96, 54]
ev100 = {ev}
[[media]]
name = "picture"
{media}
[[fixture]]
name = "Wall"
address = 1
position_m = [0, 5, 3]
wall = {{ media = "picture", size_m = [6, 4], nits = 1000 }}
"""


def write_show(folder, more, media, ev):
    folder.mkdir()
    (folder / "show.toml").write_text(WALL.format(source=window.SOURCE, more=more, media=media, ev=ev))
    return folder


def make_film(folder):
    """Four seconds, in which a white wall goes from dark to full."""
    show = write_show(folder, 'recording = "ramp.show"\nmotion = "commanded"', 'card = "white"', 11)
    (show / "ramp.show").write_text("OLA Show\n" + "".join(f"1 {level}\n40\n" for level in range(20, 255, 2)[:100]) + "1 254\n0\n")
    subprocess.run([PROGRAM, "render", show, "--live", "--no-shadows", "--from", "0", "--to", "3.9", "--fps", "25", "-o", show / "ramp.mp4"],
                   check=True, timeout=window.LONG_S, capture_output=True)
    return show / "ramp.mp4"


def free_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Film(unittest.TestCase):
    def setUp(self):
        film = make_film(WORK / "made")
        show = write_show(WORK / "show", "", f'file = "{film}"', 12)
        self.port = free_port()
        self.window = Window("--size", "480x320", "--timecode", "10:00:00:00", "--protocols", "artnet", "--artnet-port", str(self.port),
                             "--interface", "127.0.0.1", "--no-poll-reply", show=show)
        self.window.do("wait opened", "tone linear", "resolution 50")
        self.window.until_picture()

    def send(self, at_s):
        frame = round((36000 + at_s) * 25)
        packet = b"Art-Net\0" + struct.pack("<H", 0x9700) + struct.pack(">H", 14) + \
            bytes([0, 0, frame % 25, frame // 25 % 60, frame // 1500 % 60, frame // 90000, 1])
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
            out.sendto(packet, ("127.0.0.1", self.port))

    def brightness(self):
        file = WORK / "now.png"
        self.window.do(f'save-picture "{file}"')
        picture = numpy.asarray(window.Image.open(file).convert("RGB")).astype(float)
        rows, columns = picture.shape[0] // 2, picture.shape[1] // 2
        return float(picture[rows - 5:rows + 5, columns - 5:columns + 5].mean())

    def at(self, second):
        """How bright it is where the time code stands: the same for a second, though the clock goes on."""
        seen = []
        for _ in range(40):
            self.send(second)
            time.sleep(0.05)
            seen.append(self.brightness())
        self.assertLess(max(seen[20:]) - min(seen[20:]), 1.5, f"it stands at {second} s, but the film does not: {seen}")
        return seen[-1]

    def test_it_stands_and_jumps_with_the_code(self):
        moving = {round(self.brightness()) for _ in range(20) if time.sleep(0.1) is None}
        self.assertGreater(len(moving), 3, "without a time code it runs by the clock")
        early, late, middle, again = self.at(0.6), self.at(3.4), self.at(2), self.at(0.6)
        self.assertLess(early + 6, middle)
        self.assertLess(middle + 6, late)
        self.assertAlmostEqual(early, again, delta=1.5)
        self.assertEqual(self.window.close(), 0, self.window.text())


if __name__ == "__main__":
    sys.exit(window.main(sys.modules[__name__]))

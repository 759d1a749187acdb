#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A frame rate that no processor holds: `render --live-input --hold-fps` lowers the haze of a rig that moves, says so in the
picture and in its figures, and draws at full quality where the rig rests. The demo's recording comes as real packets. Usage:
live_quality_test.py SOURCE_FOLDER BUILD_FOLDER."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from lib import needs

needs.packages("python3-pil")
from PIL import Image  # noqa: E402

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
RECORDING = SOURCE / "assets/demo/demo.show"
OFFSET = "-1000"  # universes of nobody else
WORK = None


def render(name, *arguments, seconds=8, sender=()):
    """Figures and pictures of a live input, while a player sends."""
    folder = WORK / name
    folder.mkdir()
    play = subprocess.Popen([str(PROGRAM), "play", str(RECORDING), "--protocol", "artnet", "--to", "127.0.0.1", "--artnet-offset",
                             OFFSET, "--loop", "--quiet", *sender])
    try:
        done = subprocess.run([str(PROGRAM), "render", str(WORK / "demo"), "-o", str(folder / "now.png"), "--live", "--size",
                               "320x180", "--view", "close", "--live-input", "--seconds", str(seconds), "--protocols", "artnet",
                               "--artnet-offset", OFFSET, "--no-poll-reply", "--json", *arguments],
                              capture_output=True, text=True, timeout=300)
    finally:
        play.terminate()
        play.wait()
    assert done.returncode == 0, done.stdout + done.stderr
    figures = json.loads(done.stdout)
    if "llvmpipe" not in figures["device"]:
        raise unittest.SkipTest(figures["device"] + " may be fast enough")
    return figures, done.stderr, sorted(folder.glob("now-*.png"))


def is_captioned(path):
    """A caption is light letters on a dark ground in the lower left corner; the stage has no white there."""
    picture = Image.open(path).convert("RGB")
    corner = picture.crop((0, picture.height - picture.height // 12, picture.width // 3, picture.height))
    return sum(1 for pixel in corner.getdata() if min(pixel) > 200) > 30


class LiveQuality(unittest.TestCase):
    def test_a_rig_that_moves_gets_less_haze_and_the_picture_says_so(self):
        # Heads, gobos and colours change all the time.
        figures, log, pictures = render("moving", "--fps", "60", "--hold-fps", "60", sender=("--from", "20", "--until", "40"))
        self.assertGreater(figures["frames_with_new_packets"], 0, log)
        self.assertEqual(len(pictures), 480)
        self.assertGreater(figures["quality_level"], 0, log)
        self.assertIn("60 fps", log)
        self.assertFalse(is_captioned(pictures[0]))
        self.assertTrue(is_captioned(pictures[-1]))

    def test_a_picture_without_a_caption(self):
        figures, log, pictures = render("silent", "--fps", "60", "--hold-fps", "60", "--no-caption",
                                        sender=("--from", "20", "--until", "40"))
        self.assertGreater(figures["quality_level"], 0, log)
        self.assertFalse(is_captioned(pictures[-1]))

    def test_late_pictures_are_repeated(self):
        figures, log, pictures = render("late", "--fps", "120", seconds=1, sender=("--from", "20", "--until", "40"))
        self.assertEqual(len(pictures), 120)
        self.assertEqual(figures["frames"] + figures["late_frames"], 120)
        self.assertGreater(figures["late_frames"], 0, log)
        same = sum(1 for a, b in zip(pictures, pictures[1:]) if a.read_bytes() == b.read_bytes())
        self.assertGreaterEqual(same, figures["late_frames"])


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        WORK = pathlib.Path(folder)
        shutil.copytree(SOURCE / "assets/demo", WORK / "demo", ignore=shutil.ignore_patterns(".ghost"))
        (WORK / "fixtures").symlink_to(SOURCE / "assets/fixtures")
        unittest.main(argv=sys.argv[:1], verbosity=2)

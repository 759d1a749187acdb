#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""ghostlight compare as a user sees it: figures, gates, exit codes, bad input. Usage: compare_test.py SOURCE_FOLDER BUILD_FOLDER.
The pictures are written here."""
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

from lib import pictures

PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
WIDTH, HEIGHT = 40, 24
REC709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
REC2020 = (0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290)
WORK = None  # a folder of our own


def run(*arguments):
    """stdout and stderr together are in .text."""
    done = subprocess.run([str(PROGRAM), "compare", *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, timeout=120)
    done.text = done.stdout + done.stderr
    return done


def write_exr(name, pixel, width=WIDTH, height=HEIGHT, chromaticities=REC2020, channels="BGR"):
    """pixel(x, y) -> r, g, b. OpenEXR, scan lines, not compressed, 32-bit float."""

    def attribute(key, kind, data):
        return key.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data

    box = struct.pack("<4i", 0, 0, width - 1, height - 1)
    names = b"".join(c.encode() + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for c in channels) + b"\0"
    header = struct.pack("<ii", 20000630, 2) + attribute("channels", "chlist", names)
    if chromaticities:
        header += attribute("chromaticities", "chromaticities", struct.pack("<8f", *chromaticities))
    header += attribute("compression", "compression", b"\0") + attribute("dataWindow", "box2i", box)
    header += attribute("displayWindow", "box2i", box) + attribute("lineOrder", "lineOrder", b"\0")
    header += attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    header += attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
    header += attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    line = 8 + 4 * len(channels) * width
    table = b"".join(struct.pack("<Q", len(header) + 8 * height + k * line) for k in range(height))
    body = b""
    for y in range(height):
        row = [pixel(x, y) for x in range(width)]
        body += struct.pack("<ii", y, line - 8)
        for c in channels:
            body += struct.pack(f"<{width}f", *(p["RGB".find(c)] for p in row))
    path = WORK / name
    path.write_bytes(header + table + body)
    return path


def write_png(name, pixel):
    pictures.write(WORK / name, WIDTH, HEIGHT, pixel)
    return WORK / name


def stage(x, y):
    """A pool of light on a dark floor, cd/m^2."""
    d = ((x - 20) ** 2 + (y - 12) ** 2) / 30
    return tuple(k * 80 * math.exp(-d) + 0.02 for k in (1.0, 0.7, 0.3))


def brighter(factor):
    return lambda x, y: tuple(v * factor for v in stage(x, y))


class Case(unittest.TestCase):
    def fails(self, done, code, *parts):
        self.assertEqual(done.returncode, code, done.text)
        for part in parts:
            self.assertIn(part, done.text)

    def works(self, done):
        self.assertEqual(done.returncode, 0, done.text)

    def figures(self, *arguments):
        done = run(*arguments, "--json")
        return json.loads(done.stdout)


class Figures(Case):
    def test_identical(self):
        a, b = write_exr("a.exr", stage), write_exr("b.exr", stage)
        row = self.figures(a, b, "--max", "flip=0", "--max", "relmse=0", "--max", "bias=0", "--min", "psnr=1000")
        self.assertEqual(row["failed"], [])
        for name in ("flip", "flip_max", "relmse", "relmse_trimmed", "bias", "max_error", "p99_error", "non_finite"):
            self.assertEqual(row[name], 0, name)
        self.assertIsNone(row["psnr"])
        self.assertIsNone(row["psnr_p75"])
        self.assertEqual(row["pixels"], WIDTH * HEIGHT)
        done = run(a, b)
        self.works(done)
        self.assertRegex(done.stdout, r"psnr +inf")

    def test_one_percent_brighter(self):
        row = self.figures(write_exr("a.exr", brighter(1.01)), write_exr("b.exr", stage))
        self.assertAlmostEqual(row["bias"], 0.01, 5)
        self.assertAlmostEqual(row["max_error"], 0.01, 3)
        self.assertLess(row["relmse"], 1e-4)
        self.assertGreater(row["relmse"], 1e-6)
        self.assertGreater(row["psnr"], 45)
        self.assertLess(row["psnr"], 80)
        self.assertGreater(row["flip"], 0)
        self.assertLess(row["flip"], 0.04)  # 0.024 for a grey of L* 70

    def test_exposure_changes_psnr_alone(self):
        pair = write_exr("a.exr", brighter(1.1)), write_exr("b.exr", stage)
        metered, dark = self.figures(*pair), self.figures(*pair, "--ev", 14)
        self.assertEqual(dark["ev"], 14)
        self.assertGreater(dark["psnr"], metered["psnr"] + 6)
        self.assertEqual(dark["psnr_p75"], metered["psnr_p75"])
        self.assertEqual(dark["flip"], metered["flip"])

    def test_primaries_are_honoured(self):
        def red(x, y):
            return stage(x, y)[0], 0.0, 0.0

        def red_2020(x, y):  # ITU-R BT.2087
            return tuple(stage(x, y)[0] * k for k in (0.6274, 0.0691, 0.0164))

        a = write_exr("a.exr", red, chromaticities=REC709)
        b = write_exr("b.exr", red_2020)
        self.works(run(a, b, "--max", "max_error=1e-3"))  # the published numbers have four digits
        self.fails(run(write_exr("a.exr", red), b, "--max", "max_error=0.1"), 1, "max_error is")
        done = run(write_exr("a.exr", red, chromaticities=None), b, "--max", "max_error=1e-3")
        self.works(done)
        self.assertIn("no chromaticities attribute, taken as Rec.709", done.stderr)

    def test_display_pictures(self):
        a = write_png("a.png", lambda x, y: (110, 100, 100))
        b = write_png("b.png", lambda x, y: (100, 100, 100))
        row = self.figures(a, b)
        self.assertAlmostEqual(row["psnr"], -10 * math.log10((10 / 255) ** 2 / 3), 4)
        self.assertTrue(0.01 < row["flip"] < 0.2, row)
        self.assertAlmostEqual(row["flip"], row["flip_max"], 4)
        self.assertNotIn("relmse", row)
        self.assertIn("need linear", run(a, b).stdout)
        self.assertIn("--ev changes nothing", run(a, b, "--ev", 3).stderr)
        white = write_png("white.png", lambda x, y: (255, 255, 255))
        black = write_png("black.png", lambda x, y: (0, 0, 0))
        row = self.figures(white, black)
        self.assertAlmostEqual(row["psnr"], 0, 6)
        self.assertAlmostEqual(row["flip"], 0.9675, 3)  # by hand, see tests/image/metrics_test.cpp

    def test_mask(self):
        def spoiled(x, y):
            return (900.0, 0.0, 900.0) if (x - 30) ** 2 + (y - 5) ** 2 < 9 else stage(x, y)

        a, b = write_exr("a.exr", spoiled), write_exr("b.exr", stage)
        self.fails(run(a, b, "--max", "flip=0.001"), 1, "flip is")
        gates = ("--max", "flip=0", "--max", "max_error=0")
        self.works(run(a, b, *gates, "--mask-out", "30.5,5.5,4"))
        self.fails(run(a, b, *gates, "--mask-out", "10,5,4"), 1, "max_error")
        self.works(run(a, b, *gates, "--mask-out", "10,5,4", "--mask-out", "30.5,5.5,4"))
        self.fails(run(a, b, "--mask-out", "20,12,100"), 1, "no pixel is left")

    def test_difference_picture(self):
        def spot(x, y):
            return (60.0, 60.0, 60.0) if (x, y) == (8, 6) else stage(x, y)

        picture = WORK / "difference.png"
        done = run(write_exr("a.exr", spot), write_exr("b.exr", stage), "--difference", picture, "--quiet")
        self.works(done)
        self.assertEqual(done.text, "")
        width, height, rows = pictures.read(picture)
        self.assertEqual((width, height), (WIDTH, HEIGHT))
        sums = {(x, y): sum(rows[y][x]) for y in range(height) for x in range(width)}
        self.assertEqual(max(sums, key=sums.get), (8, 6))
        self.assertEqual(rows[HEIGHT - 1][-1], (0, 0, 4))
        self.fails(run(WORK / "a.exr", WORK / "b.exr", "--difference", WORK / "no" / "such.png"), 1, "such.png")


class Gates(Case):
    def test_each_gate_is_named(self):
        a, b = write_exr("a.exr", brighter(0.9)), write_exr("b.exr", stage)
        self.works(run(a, b, "--max", "bias=0.11", "--max", "relmse=0.02", "--min", "psnr=10"))
        done = run(a, b, "--max", "bias=0.09", "--max", "relmse=0.02", "--min", "psnr=90", "--quiet")
        self.fails(done, 1, "bias is -0.1, expected at most 0.09", "psnr is", "expected at least 90")
        self.assertNotIn("relmse", done.text)
        self.assertEqual(len(self.figures(a, b, "--max", "bias=0.09", "--min", "psnr=90")["failed"]), 2)

    def test_relative_gate_of_display_pictures(self):
        a = write_png("a.png", lambda x, y: (1, 2, 3))
        self.works(run(a, a, "--max", "flip=0"))
        self.fails(run(a, a, "--max", "relmse=1"), 1, "relmse needs linear pictures")

    def test_wrong_usage(self):
        a = write_exr("a.exr", stage)
        self.fails(run(a), 2)
        self.fails(run(a, a, "--max", "flipp=1"), 2, "flipp", "did you mean 'flip'?")
        self.fails(run(a, a, "--max", "quality=1"), 2, "quality", "known: flip,")
        self.fails(run(a, a, "--max", "flip"), 2, "METRIC=VALUE")
        self.fails(run(a, a, "--max", "flip=abc"), 2, "METRIC=VALUE")
        self.fails(run(a, a, "--max", "flip=nan"), 2, "METRIC=VALUE")
        self.fails(run(a, a, "--max", "psnr=45"), 2, "--min psnr=45")
        self.fails(run(a, a, "--min", "flip=1"), 2, "--max flip=1")
        self.fails(run(a, a, "--mask-out", "1,2"), 2, "X,Y,RADIUS")
        self.fails(run(a, a, "--mask-out", "1,2,-3"), 2, "X,Y,RADIUS")
        self.fails(run(a, a, "--mask-out", "1,2,3,"), 2, "X,Y,RADIUS")
        self.fails(run(a, a, "--ppd", "0"), 2, "--ppd")
        self.fails(run(a, a, "--difference", "a.exr"), 2, ".png")
        self.assertIn("Example", run("--help").stdout)


class BadPictures(Case):
    def test_missing_and_broken_files(self):
        good = write_exr("good.exr", stage)
        self.fails(run(WORK / "none.exr", good), 1, "none.exr")
        self.fails(run(good, WORK / "none.png"), 1, "none.png")
        data = good.read_bytes()
        cut = WORK / "cut.exr"
        for size in (0, 3, 100, 300, len(data) // 2):
            cut.write_bytes(data[:size])
            self.fails(run(cut, good), 1, "cut.exr")
            self.fails(run(good, cut), 1, "cut.exr")
        png = write_png("good.png", lambda x, y: (x, y, 0))
        data = png.read_bytes()
        for size in (0, 20, len(data) // 2):
            (WORK / "cut.png").write_bytes(data[:size])
            self.fails(run(WORK / "cut.png", png), 1, "cut.png")
        (WORK / "a.gif").write_bytes(b"GIF89a")
        self.fails(run(WORK / "a.gif", good), 1, "a.gif", ".exr")

    def test_pictures_that_do_not_fit(self):
        good = write_exr("good.exr", stage)
        small = write_exr("small.exr", stage, width=20)
        self.fails(run(small, good), 1, "20 x 24", "40 x 24", "small.exr")
        self.fails(run(write_png("a.png", lambda x, y: (0, 0, 0)), good), 1, "a.png", "linear")
        grey = write_exr("grey.exr", lambda x, y: (1.0, 1.0, 1.0), channels="R")
        self.fails(run(grey, good), 1, "grey.exr", "no channel G")

    def test_not_finite(self):
        def broken(x, y):
            return (float("nan"), 1.0, 1.0) if (x, y) == (3, 3) else stage(x, y)

        good = write_exr("good.exr", stage)
        for arguments in ((write_exr("nan.exr", broken), good), (good, write_exr("nan.exr", broken))):
            self.fails(run(*arguments), 1, "1 pixels are not finite")
            row = self.figures(*arguments)
            self.assertEqual((row["non_finite"], row["pixels"]), (1, WIDTH * HEIGHT - 1))
            self.assertEqual((row["relmse"], row["flip"]), (0, 0))
        self.works(run(WORK / "nan.exr", good, "--mask-out", "3.5,3.5,0.5"))
        everything = write_exr("all.exr", lambda x, y: (float("inf"),) * 3)
        self.fails(run(everything, good), 1, "no pixel is left")

    def test_black(self):
        black = write_exr("black.exr", lambda x, y: (0.0, 0.0, 0.0))
        self.works(run(black, black, "--max", "flip=0", "--max", "relmse=0", "--max", "bias=0"))
        lit = write_exr("lit.exr", stage)
        self.fails(run(lit, black, "--max", "relmse=1e9"), 1, "relmse is inf")
        self.assertGreater(self.figures(lit, black)["flip"], 0.3)
        self.assertGreater(self.figures(black, lit)["flip"], 0.3)


def main():
    global WORK
    if not PROGRAM.exists():
        print(f"skipped: {PROGRAM} is not built")
        return 77
    with tempfile.TemporaryDirectory(prefix="ghost_compare_") as folder:
        WORK = pathlib.Path(folder)
        suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules["__main__"])
        return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())

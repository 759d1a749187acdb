#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`ghostlight measure` as a user sees it: the square law and the cosine law under one lamp, table and sheet beside the
summary, and what bad input gets. Usage: measure_test.py SOURCE_FOLDER BUILD_FOLDER."""
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
WORK = None
SHOW = """[show]
name = "One lamp"
recording = "a.show"
[haze]
intensity = 0
[[camera]]
position_m = [0, -12, 3]
target_m = [0, 2, 2]
[[fixture]]
name = "Spot"
gdtf = "%s"
universe = 1
address = 1
position_m = [0, 4, 6]
"""


def run(*arguments):
    return subprocess.run([str(PROGRAM), "measure", *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120)


class Measure(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.show = WORK / "lamp"
        cls.show.mkdir()
        (cls.show / "show.toml").write_text(SHOW % (SOURCE / "assets" / "fixtures" / "Vari-Lite@VL2500_Spot.gdtf"))
        levels = [0] * 512
        for address, value in {1: 255, 2: 128, 4: 128, 12: 255, 17: 255}.items():  # full, straight down, wide, iris open
            levels[address - 1] = value
        frame = "1 %s\n500\n" % ",".join(map(str, levels))
        (cls.show / "a.show").write_text("OLA Show\n" + 20 * frame)

    def lux(self, *arguments):
        done = run(self.show, "--at", 8, *arguments, "--json", "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_under_a_lamp_the_square_law_holds(self):
        # The root of 1 / lux grows with the distance alone: wherever the lens is, three heights lie on one line.
        roots = [1 / math.sqrt(self.lux("--line", 0, 4, z, 0, 4, z)["mean_lux"]) for z in (0, 1.5, 3)]
        self.assertAlmostEqual(roots[0] - roots[1], roots[1] - roots[2], delta=0.01 * (roots[0] - roots[2]))

    def test_a_meter_that_looks_aside_reads_the_cosine_and_one_that_looks_away_nothing(self):
        up = self.lux("--line", 0, 4, 1, 0, 4, 1)["mean_lux"]
        aslant = self.lux("--line", 0, 4, 1, 0, 4, 1, "--towards", 0, 1, 1)["mean_lux"]
        self.assertAlmostEqual(aslant / up, math.sqrt(0.5), delta=0.01)
        self.assertEqual(self.lux("--line", 0, 4, 1, 0, 4, 1, "--towards", 0, 0, -1)["mean_lux"], 0)

    def test_table_and_sheet_have_the_points_of_the_summary(self):
        table, sheet = WORK / "a.csv", WORK / "a.svg"
        area = ("--area", -2, 2, 2, 6, 1, "--step", 0.5)
        summary = self.lux(*area, "-o", table)
        self.assertEqual(self.lux(*area, "-o", sheet), summary)
        rows = list(csv.DictReader(table.read_text().splitlines()))
        self.assertEqual(len(rows), 81)
        self.assertEqual(summary["points"], 81)
        values = [float(row["lux"]) for row in rows]
        self.assertAlmostEqual(sum(values) / 81, summary["mean_lux"], delta=1e-3 * max(values))
        self.assertAlmostEqual(max(values), summary["most_lux"], delta=1e-3 * max(values))
        self.assertIn("81 points", sheet.read_text())

    def test_bad_input_is_said_in_a_sentence(self):
        for arguments, code, words in (
                ((self.show,), 1, "expected either --line or --area"),
                ((self.show, "--line", 0, 0, 0, 1, 1, 1, "--area", 0, 0, 1, 1, 1), 2, "excludes"),
                ((self.show, "--line", 0, 0, 0, 1, 1), 2, "--line"),
                ((self.show, "--line", 0, 0, 0, 1000, 0, 0, "--step", 0.01), 1, "larger step"),
                ((self.show, "--line", 0, 0, 0, 1, 0, 0, "--towards", 0, 0, 0), 1, "direction"),
                ((self.show, "--line", 0, 0, 0, "nan", 0, 0), 2, "nan"),
                ((self.show, "--line", 0, 0, 0, 1, 0, 0, "-o", "a.pdf"), 1, ".csv or .svg"),
                ((self.show, "--line", 0, 0, 0, 1, 0, 0, "-o", WORK / "no" / "a.csv"), 1, "no"),
                ((WORK / "nothing", "--line", 0, 0, 0, 1, 0, 0), 1, "nothing")):
            done = run(*arguments, "-q")
            self.assertEqual(done.returncode, code, (arguments, done.stderr))
            self.assertIn(words, done.stdout + done.stderr, arguments)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        WORK = pathlib.Path(folder)
        unittest.main(argv=sys.argv[:1], verbosity=2)

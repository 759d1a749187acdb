#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Bounced light as a user of the command line has it: a show that says so, films that wait for their links, links that are made once,
what light meters read of it, and what bad input gets. Usage: bounce_test.py SOURCE_FOLDER BUILD_FOLDER."""
import csv
import json
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
WORK = None
AREA = ("--area", -3, 2, 3, 6, 0.5, "--step", 1)


def run(*arguments):
    return subprocess.run([str(PROGRAM), *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=600)


def good(*arguments):
    done = run(*arguments)
    assert done.returncode == 0, (arguments, done.stderr)
    return done.stdout


class Bounce(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.show = WORK / "demo"
        shutil.copytree(SOURCE / "assets/demo", cls.show, ignore=shutil.ignore_patterns(".ghost"))
        (WORK / "fixtures").symlink_to(SOURCE / "assets/fixtures")
        cls.plain = (cls.show / "show.toml").read_text()
        cls.size = ("--size", "160x90", "--quiet")
        cls.before = cls.still(cls, "before.png", "--live")

    def setUp(self):
        (self.show / "show.toml").write_text(self.plain + '\n[light]\nbounce = "room"\n')

    def still(self, name, *arguments):
        good("render", self.show, "-o", WORK / name, "--view", "close", "--at", 36, *self.size, *arguments)
        return (WORK / name).read_bytes()

    def test_pictures_films_and_links(self):
        links = self.show / ".ghost/bounce/room.bin"
        # The key alone draws the picture live, and the first picture waits for the links.
        bounced = self.still("still.png")
        self.assertNotEqual(bounced, self.before)
        made = links.stat().st_mtime_ns
        self.assertEqual(self.still("again.png", "--live"), bounced)
        self.assertEqual(self.still("off.png", "--live", "--bounce", "off"), self.before)
        film = WORK / "film"
        film.mkdir()
        good("render", self.show, "-o", film / "f.png", "--view", "close", "--from", 36, "--to", 36.2, "--fps", 30, *self.size)
        pictures = sorted(film.iterdir())
        self.assertEqual(len(pictures), 6)
        self.assertEqual(pictures[0].read_bytes(), bounced)
        self.assertEqual(links.stat().st_mtime_ns, made, "links are made once")
        # A film that is the first to need links waits, too.
        shutil.rmtree(links.parent)
        for picture in pictures:
            picture.unlink()
        good("render", self.show, "-o", film / "f.png", "--view", "close", "--from", 36, "--to", 36.1, "--fps", 30, *self.size)
        self.assertEqual(sorted(film.iterdir())[0].read_bytes(), bounced)
        self.assertGreater(links.stat().st_mtime_ns, made)

    def test_links_that_were_killed_go_on(self):
        links = self.show / ".ghost/bounce/normal.bin"
        words = [str(PROGRAM), "measure", str(self.show), "--at", "36", *map(str, AREA), "--bounce", "normal", "--quiet", "--json"]
        whole = subprocess.run(words, stdout=subprocess.PIPE, check=True).stdout
        expected = links.read_bytes()
        shutil.rmtree(links.parent)
        killed = subprocess.Popen(words, stdout=subprocess.DEVNULL)
        deadline = time.monotonic() + 300
        while len(list(links.parent.glob("normal.near-*.part"))) < 3 and killed.poll() is None and time.monotonic() < deadline:
            time.sleep(0.02)
        killed.kill()
        killed.wait()
        self.assertFalse(links.exists())
        kept = {part.name: part.stat().st_mtime_ns for part in links.parent.glob("normal.*.part")}
        self.assertIn("normal.size.part", kept)
        self.assertGreaterEqual(len(kept), 4)
        # Ctrl-C while the second goes on: what the first had kept is not made again.
        second = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while len(list(links.parent.glob("normal.*.part"))) <= len(kept) and second.poll() is None and time.monotonic() < deadline:
            time.sleep(0.02)
        second.send_signal(signal.SIGINT)
        asked = time.monotonic()
        self.assertNotEqual(second.wait(timeout=60), 0)
        print(f"{len(kept)} parts kept by a kill; Ctrl-C ended the next one after {time.monotonic() - asked:.2f} s", file=sys.stderr)
        now = {part.name: part.stat().st_mtime_ns for part in links.parent.glob("normal.*.part")}
        self.assertEqual({name: now.get(name) for name in kept}, kept)
        self.assertEqual(subprocess.run(words, stdout=subprocess.PIPE, check=True).stdout, whole)
        self.assertEqual(links.read_bytes(), expected, "the same bytes as in one go")
        self.assertEqual(list(links.parent.glob("*.part")), [])

    def test_links_that_are_damaged_are_made_again_and_said(self):
        bounced = self.still("whole.png")
        links = self.show / ".ghost/bounce/room.bin"
        links.write_bytes(links.read_bytes()[:-1000])
        done = run("render", self.show, "-o", WORK / "mended.png", "--view", "close", "--at", 36, *self.size)
        self.assertIn("room.bin", done.stderr)
        self.assertEqual((WORK / "mended.png").read_bytes(), bounced)
        self.assertEqual(run("render", self.show, "-o", WORK / "mended.png", "--view", "close", "--at", 36, *self.size).stderr, "")

    def test_meters_read_it(self):
        without = json.loads(good("measure", self.show, "--at", 36, *AREA, "--bounce", "off", "--json", "-q"))
        self.assertNotIn("mean_bounced_lux", without)
        (self.show / "show.toml").write_text(self.plain)
        self.assertEqual(json.loads(good("measure", self.show, "--at", 36, *AREA, "--json", "-q")), without)
        (self.show / "show.toml").write_text(self.plain + '\n[light]\nbounce = "room"\n')
        table = WORK / "area.csv"
        with_it = json.loads(good("measure", self.show, "--at", 36, *AREA, "--json", "-q", "-o", table))
        self.assertGreater(with_it["mean_bounced_lux"], 0.5)
        # What bounced, and that light is weakened less on its way.
        self.assertGreaterEqual(with_it["mean_lux"], without["mean_lux"] + 0.99 * with_it["mean_bounced_lux"])
        rows = list(csv.DictReader(table.open()))
        self.assertEqual(len(rows), with_it["points"])
        mean = sum(float(row["bounced_lux"]) for row in rows) / len(rows)
        self.assertAlmostEqual(mean, with_it["mean_bounced_lux"], delta=1e-3 * mean)
        words = good("measure", self.show, "--at", 36, *AREA, "-q")
        self.assertIn("lx bounced", words)
        sheet = WORK / "area.svg"
        good("measure", self.show, "--at", 36, *AREA, "-q", "-o", sheet)
        self.assertIn("of which", sheet.read_text())

    def test_explain_has_it_beside_the_beam(self):
        words = good("explain", self.show, "Spot 1", "--at", 36, "--quiet")
        self.assertIn("more of all lights bounced there", words)
        self.assertNotIn("bounced", good("explain", self.show, "Spot 1", "--at", 36, "--quiet", "--bounce", "off"))
        hit = json.loads(good("explain", self.show, "Spot 1", "--at", 36, "--quiet", "--json"))["beams"][0]["hit"]
        self.assertGreater(hit["bounced_lx"], 0)
        off = json.loads(good("explain", self.show, "Spot 1", "--at", 36, "--quiet", "--json", "--bounce", "off"))["beams"][0]["hit"]
        self.assertIsNone(off.pop("bounced_lx"))
        hit.pop("bounced_lx")
        self.assertEqual(hit, off, "the beam itself is what it was")

    def test_bad_input(self):
        done = run("render", self.show, "-o", WORK / "x.png", "--bounce", "normel")
        self.assertEqual(done.returncode, 2)
        self.assertIn("did you mean 'normal'", done.stdout + done.stderr)
        (self.show / "show.toml").write_text(self.plain + '\n[light]\nbounce = "roam"\n')
        done = run("check", self.show)
        self.assertIn("[light] bounce is 'roam', expected one of", done.stdout + done.stderr)
        self.assertIn("did you mean 'room'", done.stdout + done.stderr)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        WORK = pathlib.Path(folder)
        unittest.main(argv=sys.argv[:1], verbosity=2)

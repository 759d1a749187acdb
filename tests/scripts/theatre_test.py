#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""tools/make_theatre.py: same bytes twice, `check` has nothing to say, its cues light what they say. Usage: theatre_test.py SOURCE_FOLDER
BUILD_FOLDER. Nothing but Python's own library is needed."""
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
TOOL = SOURCE / "tools" / "make_theatre.py"
LIT = {"moonlight": ("Back", "Row"), "monologue": ("Special",), "day": ("Front", "Back", "Row"), "forest": ("Special", "Row"),
       "sunset": ("Front", "Back", "Row")}
CUE_S = 4
WORK = None   # a folder of our own


def call(*arguments):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True, timeout=600)
    done.text = done.stdout + done.stderr
    return done


class Theatre(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.show = WORK / "one"
        made = call(sys.executable, TOOL, "--out", cls.show)
        assert made.returncode == 0, made.text

    def test_the_same_bytes_twice(self):
        self.assertEqual(call(sys.executable, TOOL, "--out", WORK / "two").returncode, 0)
        files = {path.name: path.read_bytes() for path in self.show.iterdir() if path.is_file()}
        self.assertEqual(files, {path.name: path.read_bytes() for path in (WORK / "two").iterdir()})

    def test_check_has_nothing_to_say(self):
        done = call(PROGRAM, "check", self.show)
        self.assertEqual(done.returncode, 0, done.text)
        self.assertNotIn("warning", done.text)

    def test_its_cues_light_what_they_say(self):
        for number, (cue, roles) in enumerate(LIT.items()):
            done = call(PROGRAM, "explain", self.show, "--all", "--at", number * CUE_S + 2, "--json")
            self.assertEqual(done.returncode, 0, done.text)
            lit = {lamp["fixture"].split()[0] for lamp in json.loads(done.stdout)["fixtures"] if lamp["state"] == "lit"}
            self.assertEqual(lit, set(roles), cue)

    def test_one_beam_on_one_actor(self):
        done = call(PROGRAM, "explain", self.show, "Special 2", "--at", CUE_S + 2)
        self.assertEqual(done.returncode, 0, done.text)
        self.assertIn("actor_singer", done.text)

    def test_another_place_than_a_folder(self):
        file = WORK / "plain"
        file.write_text("x")
        done = call(sys.executable, TOOL, "--out", file)
        self.assertEqual(done.returncode, 2)
        self.assertIn("is a file", done.stderr)
        self.assertEqual(tomllib.loads((self.show / "show.toml").read_text())["light"]["bounce"], "normal")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as made:
        WORK = pathlib.Path(made)
        unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Edits of the patch in the window that others depend on, on a screen of its own: a fixture gets another name and keeps its looks, heads are
hung beside those that hang there. Usage: window_edits_test.py SOURCE_FOLDER BUILD_FOLDER."""
import pathlib
import shutil
import sys
import tomllib
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "lib"))
from window import Window, main  # noqa: E402

WORK = None


class Edits(unittest.TestCase):
    def open(self):
        show = WORK / self.id().split(".")[-1]
        shutil.copytree(WORK / "demo", show)
        window = Window("--size", "700x480", "--no-desk", "--quiet", show=show)
        window.do("wait opened", "resolution 12", "freeze on")
        return show, window

    def looks(self, show):
        return tomllib.loads((show / "looks.toml").read_text())["look"]

    def fixtures(self, show):
        return {one["name"]: one for one in tomllib.loads((show / "show.toml").read_text())["fixture"]}

    def test_renaming(self):
        show, window = self.open()
        try:
            window.do('select "Spot 1"', "intensity 0.5", "look-store Verse", "release-all", "rename Solo")
            self.assertIn("Solo", [one["name"] for one in self.looks(show)[0]["fixture"]])
            window.do("look-recall Verse 0")
            self.assertEqual(window.state()["look"], "Verse")
            window.do("undo", "undo")  # the recall, then the name
            self.assertEqual([one["name"] for one in self.looks(show)[0]["fixture"]], ["Spot 1"])
            window.do("redo", "save")
            self.assertIn("Solo", self.fixtures(show))
            self.assertEqual([one["name"] for one in self.looks(show)[0]["fixture"]], ["Solo"])
        finally:
            self.assertEqual(window.close(), 0)

    def test_a_new_fixture_has_a_mode(self):
        show, window = self.open()
        try:
            before = len(self.fixtures(show))
            window.do(f'add-fixture "{WORK / "fixtures" / "Ghostlight@LED_Par.gdtf"}"', "save")
            added = list(self.fixtures(show).values())[before:]
            self.assertTrue(added and added[0].get("mode"), added)
            window.until(lambda state: state["explained"].get("why"))
            self.assertNotIn("mode", window.state()["explained"]["why"])
        finally:
            self.assertEqual(window.close(), 0)

    def test_hanging(self):
        show, window = self.open()
        try:
            names = list(self.fixtures(show))
            half = len(names) // 2
            for some in (names[:half], names[half:], names[:1]):
                window.do("select-none", "select " + " ".join(f'"{name}"' for name in some), "hang", "wait 0.2")
            window.do("save")
            places = sorted(one["position_m"] for one in self.fixtures(show).values())
            for a, b in zip(places, places[1:]):
                if a[1:] == b[1:]:
                    self.assertGreater(b[0] - a[0], 0.25, (a, b))
        finally:
            self.assertEqual(window.close(), 0)

    def test_another_show_while_an_edit_is_taken(self):
        show, window = self.open()
        try:
            other = WORK / "other"
            shutil.copytree(WORK / "demo", other)
            (other / "show.toml").write_text((other / "show.toml").read_text().replace('name = "Spot 1"', 'name = "Else"'))
            for _ in range(2):  # the edit is read beside what is shown, and is ready when the other show is open
                window.do('select "Spot 2"', "duplicate", "wait 0.2", f'open "{other}"', "wait opened", "wait 3", "wait settled")
                self.assertEqual(window.state()["show"], str(other / "show.toml"))
                window.do("select Else")
                window.do(f'open "{show}"', "wait opened", "drop-changes", "wait settled")
                window.do('select "Spot 1"')
        finally:
            self.assertEqual(window.close(), 0)


if __name__ == "__main__":
    sys.exit(main(sys.modules[__name__]))

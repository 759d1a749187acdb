#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The window in German: menus, what is asked for and what is chosen; scripts stay English. Usage: german_test.py SOURCE_ROOT BUILD_FOLDER"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"


class German(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.work = pathlib.Path(self.folder.name)
        (self.work / "show").mkdir()
        (self.work / "show/show.toml").write_text('[show]\nname = "Bare"\n')

    def tearDown(self):
        self.folder.cleanup()

    def run_window(self, *arguments, lines=(), environment=None):
        """The state of a window that did these lines, and what it printed."""
        script = self.work / "lines"
        script.write_text("\n".join(["wait opened", *lines, f'state "{self.work}/state.json"', "quit anyway"]) + "\n")
        clean = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "LANGUAGE")}
        clean |= {"QT_QPA_PLATFORM": "offscreen", "XDG_CONFIG_HOME": str(self.work / "config"), "XDG_DATA_HOME": str(self.work / "data"), "LC_ALL": "C.UTF-8"}
        done = subprocess.run([str(PROGRAM), "open", str(self.work / "show"), "--no-desk", "--size", "640x400", "--script", str(script), *arguments],
                              env=clean | (environment or {}), capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.work / "state.json").read_text()), done.stderr

    def test_asked_for_on_the_command_line(self):
        state, _ = self.run_window("--forget", "--language", "de", lines=["black-out on", "camera 1"])
        self.assertEqual(state["language"], "de")
        self.assertEqual(state["titles"]["undo"], "Rückgängig")
        self.assertEqual(state["titles"]["panel-fixtures"], "Geräte")
        self.assertTrue(state["black_out"], "actions have their English names")

    def test_english_is_asked_for_on_a_german_desktop(self):
        state, _ = self.run_window("--forget", "--language", "en", environment={"LC_ALL": "de_DE.UTF-8", "LANGUAGE": "de"})
        self.assertEqual((state["language"], state["titles"]["undo"]), ("en", "Undo"))

    def test_the_desktop_and_what_is_chosen(self):
        german = {"LC_ALL": "de_DE.UTF-8", "LANGUAGE": "de"}
        state, _ = self.run_window(lines=["language-en"], environment=german)
        self.assertEqual(state["language"], "de", "the desktop's, and from the next start on the chosen one")
        state, _ = self.run_window(lines=["language-de"], environment=german)
        self.assertEqual(state["language"], "en")
        state, _ = self.run_window(lines=["language-system"])
        self.assertEqual(state["language"], "de", "kept, whatever the desktop speaks")
        state, _ = self.run_window()
        self.assertEqual(state["language"], "en")

    def test_scripts_are_answered_in_english(self):
        script = self.work / "lines"
        script.write_text("wait opened\nselect nobody\n")
        clean = dict(os.environ, QT_QPA_PLATFORM="offscreen", XDG_CONFIG_HOME=str(self.work / "config"), LC_ALL="de_DE.UTF-8", LANGUAGE="de")
        done = subprocess.run([str(PROGRAM), "open", str(self.work / "show"), "--forget", "--no-desk", "--language", "de", "--script", str(script)],
                              env=clean, capture_output=True, text=True, timeout=300)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("the show has no fixtures", done.stderr)

    def test_another_language_is_refused(self):
        done = subprocess.run([str(PROGRAM), "open", "--language", "tlh"], capture_output=True, text=True, timeout=60)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("--language", done.stderr + done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

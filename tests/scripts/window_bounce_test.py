#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Bounced light in the window, on a screen of its own: a level that is an edit of the show, links in the background with a bar that can be
cancelled, what the probe reads, undo. Usage: window_bounce_test.py SOURCE_FOLDER BUILD_FOLDER [FOLDER_FOR_PICTURES]."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent / "lib"))
import window as window_driver  # noqa: E402
from window import Window, changed  # noqa: E402

WORK = None


class Bounce(unittest.TestCase):
    def test_from_off_to_normal_and_back(self):
        window = Window("--size", "1000x700", "--no-desk", "--quiet")
        try:
            window.do("wait opened", *[f"panel-{one} off" for one in ("fixtures", "values", "programmer", "scene", "looks", "export")],
                      "panel-air on", "resolution 25", "jump 36", "wait 0.2", "freeze on", "camera close", "work-light off", "wait settled")
            text = (WORK / "demo/show.toml").read_text()
            before = window.picture("before")
            window.shoot("bounce-off.png")
            state = window.state()
            self.assertEqual(state["bounce"]["state"], "off")
            _, _, width, height = state["view"]
            window.do(f"probe {width // 2} {height * 2 // 3}", "wait settled")
            probe = window.until(lambda state: state["probe"].get("lux") is not None)["probe"]
            self.assertIsNone(probe["bounced_lux"])

            # Links are made meanwhile, and that can be given up.
            window.do("bounce normal")
            state = window.until(lambda state: state["bounce"]["state"] == "makes_links" and state["bounce"]["left_s"] is not None)
            self.assertIn(" left", state["bounce"]["words"])
            if window_driver.PICTURES:
                window.do(f'screenshot "{window_driver.PICTURES / "bounce-links.png"}"')
            window.do("cancel-bounce")
            state = window.until(lambda state: state["bounce"]["state"] == "cancelled")
            self.assertEqual(state["bounce"]["show"], "normal")
            window.do("wait settled")
            self.assertLess(changed(window.picture("cancelled"), before), 0.01)
            self.assertFalse((WORK / "demo/.ghost/bounce/normal.bin").exists())

            window.do("bounce normal", "wait settled")
            state = window.state()
            self.assertEqual(state["bounce"]["state"], "bounces")
            self.assertGreater(state["bounce"]["solve_ms"], 0)
            self.assertGreater(state["bounce"]["draw_ms"], 0)
            self.assertIn("beside the picture", state["bounce"]["words"])
            self.assertIn("light bounces", state["picture"]["supply"])
            self.assertTrue((WORK / "demo/.ghost/bounce/normal.bin").exists())
            after = window.picture("after")
            self.assertGreater(changed(after, before), 0.5)
            self.assertGreater(after.mean(), before.mean())
            window.do("wait settled", "wait 0.3")
            window.shoot("bounce-normal.png")
            probe = window.until(lambda state: state["probe"].get("bounced_lux") is not None)["probe"]
            self.assertGreater(probe["bounced_lux"], 0)
            self.assertGreater(probe["lux"], probe["bounced_lux"])

            window.do("false-lux")
            lux = window.picture("lux")
            window.shoot("bounce-lux.png")
            window.do("false-lux", "save")
            self.assertIn('[light]\nbounce = "normal"', (WORK / "demo/show.toml").read_text())
            window.do("undo", "save", "wait settled")
            self.assertEqual((WORK / "demo/show.toml").read_text(), text)
            self.assertLess(changed(window.picture("back"), before), 0.01)
            window.do("false-lux")
            self.assertGreater(changed(lux, window.picture("lux-off")), 0.2)
            window.do("false-lux")
            self.assertIn("did you mean 'normal'", window.ask("bounce normel"))
        finally:
            self.assertEqual(window.close(), 0, window.text())


if __name__ == "__main__":
    sys.exit(window_driver.main(sys.modules[__name__]))

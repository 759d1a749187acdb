# SPDX-License-Identifier: Apache-2.0
"""The window beside a lighting desk that sends, under a real mouse and keyboard. Run by desk_window_test.sh in the namespace that the
desk's packets reach: SOURCE_FOLDER BUILD_FOLDER [FOLDER_FOR_PICTURES]."""
import pathlib
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import window as window_driver  # noqa: E402
from window import LONG_S, Window  # noqa: E402

import numpy  # noqa: E402
from PIL import Image  # noqa: E402

WORK = None
PANELS = ("fixtures", "values", "programmer", "scene", "network", "messages", "looks", "export", "air")


class BesideADesk(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.window = Window("--size", "1280x760", "--interface", "net0", "--universes", "1", "--quiet")
        cls.window.do("wait opened", "resolution 15")
        cls.window.until(lambda state: state["from_desk"] and state["picture"]["latency_ms"] >= 0)

    @classmethod
    def tearDownClass(cls):
        code = cls.window.close()
        assert code == 0, cls.window.text()

    def setUp(self):
        x, y, width, _ = self.window.place()
        self.window.xdo("mousemove", x + width // 2, y + 8, "click", 1, "key", "Escape", "key", "1")  # the picture has the keys
        self.window.until(lambda state: abs(state["camera"]["position_m"][1] + 15.5) < 1e-3)

    def keys(self, *keys):
        self.window.xdo("key", *keys)

    def colour(self):
        """What the desk lights the cyclorama with, as the window shows it now."""
        file = WORK / "now.png"
        self.window.do(f'save-picture "{file}"')
        picture = numpy.asarray(Image.open(file).convert("RGB")).astype(float)
        height, width = picture.shape[:2]
        red, _, blue = picture[height // 4:height * 3 // 5, width * 3 // 10:width * 7 // 10].mean(axis=(0, 1))
        return "red" if red > 40 and red > 2 * blue else "blue" if blue > 40 and blue > 2 * red else "dark" if max(red, blue) < 15 else "other"

    def comes(self, colour):
        for _ in range(100):
            if self.colour() == colour:
                return
            time.sleep(0.2)
        self.fail(f"never {colour}; the last one was {self.colour()}")

    def test_the_picture_follows_the_desk_while_the_mouse_turns_it(self):
        self.comes("red")
        self.comes("blue")
        x, y, width, height = self.window.place()
        before = self.window.state()["camera"]
        self.window.xdo("mousemove", x + width // 2, y + height - 60, "mousedown", 1)
        for step in range(12):
            self.window.xdo("mousemove", x + width // 2 + 4 * step, y + height - 60)
            time.sleep(0.1)
        self.window.xdo("mouseup", 1)
        state = self.window.until(lambda state: state["camera"]["position_m"] != before["position_m"])
        for now_m, then_m in zip(state["camera"]["target_m"], before["target_m"]):  # `before` may be the last millimetre of the flight
            self.assertAlmostEqual(now_m, then_m, places=3, msg="a drag goes around what is looked at")
        self.assertTrue(state["from_desk"])
        self.comes("red")
        self.comes("blue")
        state = self.window.state()
        self.assertGreater(state["packet_to_window_ms"]["count"], 1)
        self.assertEqual(state["universes"], [1])
        self.assertEqual([sentence for sentence in state["network"] if sentence["problem"]], [], "all is well on the network")

    def test_a_hand_takes_lamps_from_the_desk_and_gives_them_back(self):
        self.comes("blue")
        self.keys("b")
        self.window.until(lambda state: state["black_out"])
        self.comes("dark")
        self.keys("b")
        self.window.until(lambda state: not state["black_out"])
        self.keys("ctrl+a")
        self.window.until(lambda state: len(state["selection"]) == 10)
        self.window.do("colour #ff0000", "wait 2")  # from now on the desk's blue is never seen
        for _ in range(25):
            self.assertNotEqual(self.colour(), "blue")
            time.sleep(0.2)
        self.keys("r")
        self.window.until(lambda state: not state["by_hand"]["fixtures"])
        self.comes("blue")

    def test_a_lamp_is_clicked_found_and_renamed_in_the_list(self):
        x, y, _, _ = self.window.place()
        lamp = self.window.state()["lamps"]["Wash 2"]
        self.window.xdo("mousemove", x + round(lamp[0]), y + round(lamp[1]), "click", 1)
        self.window.until(lambda state: state["selection"] == ["Wash 2"])
        self.keys("ctrl+f")
        self.window.xdo("type", "--delay", "30", "Wash 3")
        self.keys("Return")
        self.window.until(lambda state: state["selection"] == ["Wash 3"])
        self.keys("F2", "ctrl+a")
        self.window.xdo("type", "--delay", "30", "Cyc right")
        self.keys("Return")
        state = self.window.until(lambda state: "Cyc right" in state["patch"])
        self.assertTrue(state["unsaved"])
        self.assertTrue(state["from_desk"], "the desk goes on meanwhile")
        self.keys("ctrl+z")
        self.window.until(lambda state: "Wash 3" in state["patch"] and not state["unsaved"])
        self.keys("ctrl+f", "ctrl+a", "BackSpace")

    def test_every_panel_comes_by_its_key(self):
        for number, name in enumerate(PANELS, 1):
            self.window.do(f"panel-{name} off")
            self.window.until(lambda state: name not in state["panels"])
            self.keys(f"ctrl+{number}")
            self.window.until(lambda state: name in state["panels"])
            self.window.do('select "Wash 2"', "wait 1.5")
            if window_driver.PICTURES:
                self.window.do(f'screenshot "{window_driver.PICTURES / f"desk-{name}.png"}"')


if __name__ == "__main__":
    sys.exit(window_driver.main(sys.modules[__name__]))

# SPDX-License-Identifier: Apache-2.0
"""A truss put on hoists in the window and flown by a desk, a lift and a wagon beside it, and a hand in between. Run by
desk_movers_test.sh in the namespace that the desks' packets reach: SOURCE_FOLDER BUILD_FOLDER [FOLDER_FOR_PICTURES]."""
import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import window as window_driver  # noqa: E402
from window import SOURCE, Window  # noqa: E402

WORK = None


def stage_without_hoists(folder):
    """The kinetic stage without its truss's and its winch's movers; the lift on another universe, the wagon on a tracker."""
    kinetic = SOURCE / "assets/kinetic"
    folder.mkdir()
    (folder / "stage.glb").write_bytes((kinetic / "stage.glb").read_bytes())
    text = (kinetic / "show.toml").read_text().replace("../fixtures/", f"{SOURCE}/assets/fixtures/").replace('recording = "kinetic.show"\n', "")
    head, *movers = re.split(r"(?=^\[\[mover\]\])", text, flags=re.M)
    movers = [mover for mover in movers if 'name = "Truss"' not in mover and 'name = "Winch"' not in mover]
    text = head + "".join(movers)
    text = text.replace("range_m = [0.0, 2.5]\nuniverse = 9\naddress = 10", "range_m = [0.0, 2.5]\nuniverse = 8\naddress = 1")
    text = text.replace('kind = "path"\n', 'kind = "path"\ntracker = 7\nhome_m = [-7.5, -3.0, 0.0]\n')
    (folder / "show.toml").write_text(text)
    return folder


class Movers(unittest.TestCase):
    def near(self, mover, key, values, within=0.02):
        def holds(state):
            now = state["movers"].get(mover, {}).get(key, [])
            return len(now) == len(values) and all(abs(a - b) <= within for a, b in zip(now, values))
        return window.until(holds)

    def test_a_truss_is_made_patched_and_flown(self):
        global window
        window = Window("--size", "1280x760", "--interface", "net0", "--universes", "8-9", "--psn", "--quiet",
                        show=stage_without_hoists(WORK / "show"))
        window.do("wait opened", "resolution 25", "work-light on", "panel-scene on", "fly-on-hoists Truss")
        window.until(lambda state: "Truss" in state["movers"])
        window.do("mover-address Truss 9.1")
        # A truss of 40 cm at 6 m goes down to a metre above the floor; 128 and 64 of 255.
        low = -5.0
        state = window.until(lambda state: state["movers"].get("Truss", {}).get("goals", [0])[0] < -1)
        left, right = state["movers"]["Truss"]["goals"]
        self.assertAlmostEqual(left / right, 128 / 64, delta=0.01)
        self.assertAlmostEqual(left, low * 128 * 256 / 65535, delta=0.4)
        self.near("Lift", "goals", [2.5 * (204 * 257) / 65535])
        self.near("Wagon", "goals", [3.0])
        if window_driver.PICTURES:
            window.do(f'screenshot "{window_driver.PICTURES / "flies.png"}"')
        self.near("Truss", "values", [left, right])  # as the machine: at 0.2 m/s
        # The mouse takes the right hoist down, and gives it back to the desk.
        x, y, _, _ = window.place()
        hook = window.state()["movers"]["Truss"]["handles"][1]
        window.xdo("mousemove", x + round(hook[0]), y + round(hook[1]), "mousedown", 1)
        for step in range(1, 9):
            window.xdo("mousemove", x + round(hook[0]), y + round(hook[1]) + 10 * step, "sleep", 0.05)
        window.xdo("mouseup", 1)
        state = window.until(lambda state: state["movers"]["Truss"]["goals"][1] < right - 0.3)
        self.assertAlmostEqual(state["movers"]["Truss"]["goals"][0], left, delta=0.02, msg="the other one stays")
        if window_driver.PICTURES:
            window.do(f'screenshot "{window_driver.PICTURES / "by_hand.png"}"')
        window.do("motion commanded", "mover Truss off")
        self.near("Truss", "values", [left, right])
        self.assertEqual(window.close(), 0, window.text())


if __name__ == "__main__":
    sys.exit(window_driver.main(sys.modules[__name__]))

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The window on a screen of its own (Xvfb), with a real mouse and keyboard (xdotool): keys, clicks and drags do what they say, each
of the thesis's controls changes the picture as it should, a desk's packets arrive, and bad input ends in a sentence. Usage:
window_test.py SOURCE_FOLDER BUILD_FOLDER [FOLDER_FOR_PICTURES]."""
import os
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent / "lib"))
import window as window_driver  # noqa: E402
from window import LONG_S, PROGRAM, SOURCE, Window, changed  # noqa: E402

import numpy  # noqa: E402

WORK = None


class MouseAndKeys(unittest.TestCase):
    def test_real_mouse_and_keys(self):
        window = Window("--size", "900x600", "--no-desk", "--quiet")
        try:
            window.do("wait opened", "panel-values off", "panel-programmer off", "panel-scene off", "panel-looks off", "resolution 10", "jump 36", "wait 0.2", "freeze on",
                      "wait settled")
            start = window.state()
            self.assertEqual(start["selection"], [])
            x, y, width, height = window.place()
            window.xdo("mousemove", x + width // 2, y + 8, "click", 1)  # the picture has the keys now
            window.xdo("key", "2")
            window.until(lambda state: state["camera"]["target_m"] == [-0.75, 5.0, 3.1500000953674316])  # the end of the travel
            self.assertAlmostEqual(window.state()["camera"]["position_m"][1], -0.7, places=5)
            window.xdo("key", "1")
            window.until(lambda state: abs(state["camera"]["position_m"][1] + 15.5) < 1e-3)

            # A lamp is where the figures say; a click there selects it, in the list as well.
            window.do("wait settled")
            lamp = window.state()["lamps"]["Spot 2"]
            window.xdo("mousemove", x + round(lamp[0]), y + round(lamp[1]), "click", 1)
            window.until(lambda state: state["selection"] == ["Spot 2"])
            window.xdo("key", "Escape")
            window.until(lambda state: state["selection"] == [])

            # All that the camera frames stays in sight, whatever a panel leaves of the window.
            fov = window.state()["camera"]["fov_y_deg"]
            for panel in ("on", "off"):
                view_before = window.state()["view"]
                window.do(f"panel-network {panel}", f"panel-scene {panel}", "wait 0.3", "wait settled")
                state = window.state()
                self.assertNotEqual(state["view"], view_before)
                left, top, wide, high = state["frame"]
                self.assertAlmostEqual(wide / high, 1024 / 300, places=2)
                self.assertTrue(-0.01 <= left and -0.01 <= top and left + wide <= state["view"][2] + 0.01 and top + high <= state["view"][3] + 0.01, state["frame"])
                self.assertEqual(state["camera"]["fov_y_deg"], fov)
                # Where the view is less wide than the frame, the picture has more above and below than the camera's own field of view.
                if state["view"][2] / state["view"][3] < 1024 / 300:
                    self.assertGreater(state["picture"]["camera"]["fov_y_deg"], fov)
                else:
                    self.assertAlmostEqual(state["picture"]["camera"]["fov_y_deg"], fov, places=3)

            before = window.state()["camera"]
            window.xdo("mousemove", x + 100, y + height - 40, "mousedown", 1)
            for step in range(1, 9):
                window.xdo("mousemove", x + 100 + 10 * step, y + height - 40)
            window.xdo("mouseup", 1)
            moved = window.until(lambda state: state["camera"]["position_m"] != before["position_m"])
            self.assertEqual(moved["camera"]["target_m"], before["target_m"])
            window.xdo("keydown", "w")
            window.until(lambda state: state["camera"]["target_m"] != before["target_m"])
            window.xdo("keyup", "w")

            # Where the mouse rests on a dark head, the picture says why it is dark.
            window.do("camera house", "select \"Spot 2\"", "intensity 0", "select-none", "wait settled")
            lamp = window.state()["lamps"]["Spot 2"]
            window.xdo("mousemove", x + round(lamp[0]), y + round(lamp[1]))
            hovered = window.until(lambda state: state["hovered"])["hovered"]
            self.assertEqual(hovered["name"], "Spot 2")
            self.assertIn("dark", hovered["why"])
            window.xdo("mousemove", x + 20, y + height - 20)
            window.until(lambda state: not state["hovered"])
            window.do("release-all")

            window.xdo("key", "b")
            window.until(lambda state: state["black_out"])
            window.xdo("key", "b")
            window.until(lambda state: not state["black_out"])
            window.xdo("key", "minus")
            window.until(lambda state: state["camera"]["ev100"] > 6.4)
            window.xdo("key", "ctrl+a")
            window.until(lambda state: len(state["selection"]) == 10)
        finally:
            code = window.close()
        self.assertEqual(code, 0, window.text())


class Popups(unittest.TestCase):
    def test_escape_closes_a_list_and_leaves_the_selection(self):
        def lists(window):
            """Windows of the program that are seen: an open list is one."""
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(window.process.pid)],
                                   env=dict(os.environ, DISPLAY=window_driver.DISPLAY), capture_output=True, text=True, timeout=60)
            return len(found.stdout.split())

        window = Window("--size", "900x600", "--no-desk", "--quiet")
        try:
            window.do("wait opened", "resolution 10", "freeze on")
            x, y, width, _ = window.place()
            window.xdo("mousemove", x + width // 2, y + 8, "click", 1)  # the picture has the keys now
            window.do('select "Spot *"')
            window.xdo("key", "ctrl+f")  # the search; the list of groups stands behind it
            window.until(lambda state: "fixtures" in state["panels"])
            alone = lists(window)
            window.xdo("key", "Tab")
            for _ in range(2):
                window.xdo("key", "F4")  # Alt+arrows and the space bar are ours
                for _ in range(100):
                    if lists(window) > alone:
                        break
                    time.sleep(0.1)
                self.assertGreater(lists(window), alone, "the list is open")
                window.xdo("key", "Escape")
                window.do("wait 0.5")
                self.assertEqual(lists(window), alone, "the list is closed")
                self.assertEqual(len(window.state()["selection"]), 5)
            self.assertIn("fixtures", window.state()["panels"])
            window.do("panel-fixtures off")
            window.xdo("key", "Escape")
            window.until(lambda state: state["selection"] == [])
        finally:
            code = window.close()
        self.assertEqual(code, 0, window.text())


class Controls(unittest.TestCase):
    """The picture before and after each control, alone; everything else rests."""

    @classmethod
    def setUpClass(cls):
        cls.window = Window("--size", "480x320", "--no-desk", "--quiet")
        cls.window.do("wait opened", *[f"panel-{one} off" for one in ("fixtures", "values", "programmer", "scene", "looks")], "resolution 12",
                      "freeze on", "jump 36", "camera close", "wait settled", "exposure 6.5", "wait settled")
        cls.show = cls.window.picture("show")

    @classmethod
    def tearDownClass(cls):
        cls.window.close()

    def after(self, *lines):
        self.window.do(*lines)
        return self.window.picture("after")

    def tearDown(self):
        self.window.do("release-all", "samples 24", "master 1", "select-none")
        self.assertLess(changed(self.window.picture("released"), self.show), 0.5, "what was released is still there")

    def test_intensity(self):
        dark = self.after("select *", "intensity 0")
        self.assertLess(dark.mean(), 0.5 * self.show.mean())
        half, full = self.after("intensity 0.5"), self.after("intensity 1")
        self.assertGreater(half.mean(), dark.mean() + 5)
        self.assertGreater(full.mean(), half.mean() + 3)

    def test_colour(self):
        red = self.after("select *", "intensity 1", "colour #ff0000")
        self.assertGreater(red[..., 0].mean(), 1.5 * red[..., 2].mean())
        blue = self.after("colour #0000ff")
        self.assertGreater(blue[..., 2].mean(), 1.5 * blue[..., 0].mean())

    def test_zoom(self):
        # The same light on less of the stage: fewer bright pixels.
        self.window.do("select \"Wash *\"", "intensity 0", "select \"Spot *\"", "gobo 0", "intensity 1")
        wide, narrow = self.after("zoom 50"), self.after("zoom 12")
        self.assertGreater((wide.mean(axis=2) > 60).sum(), 1.3 * (narrow.mean(axis=2) > 60).sum())

    def test_pan_and_tilt(self):
        self.window.do("select *", "intensity 1")
        tilted = self.after("tilt 0")
        panned = self.after("tilt 60", "pan 0")
        self.assertGreater(changed(tilted, panned), 4)
        self.assertGreater(changed(panned, self.after("pan 90")), 4)

    def test_gobo(self):
        self.window.do("select \"Wash *\"", "intensity 0", "select \"Spot *\"", "intensity 1")
        opened, gobo = self.after("gobo 0"), self.after("gobo 5")
        self.assertGreater(changed(opened, gobo), 2)
        self.assertLess(gobo.mean(), opened.mean())  # metal stops light
        self.assertGreater(changed(gobo, self.after("gobo 7")), 1)

    def test_smoke(self):
        # Without smoke the air between lamp and stage is black.
        clear, thick = self.after("smoke 0"), self.after("smoke 3")
        self.assertGreater(changed(clear, self.show), 2)
        self.assertGreater(numpy.percentile(thick, 50), numpy.percentile(clear, 50))

    def test_even_light(self):
        self.window.do("master 0")
        dark, lit = self.after("ambient 0"), self.after("ambient 150")
        self.assertLess(dark.mean(), 1)
        self.assertGreater(lit.mean(), 20)
        green = self.after("ambient 150 #00ff00")
        self.assertGreater(green[..., 1].mean(), 1.5 * green[..., 0].mean())

    def test_attenuation(self):
        # Light that does not fall off is much brighter at some metres.
        self.assertGreater(self.after("attenuation 0 1 0").mean(), self.show.mean() + 5)
        self.assertLess(changed(self.after("attenuation 0 0 1"), self.show), 0.5)

    def test_shadows(self):
        without = self.after("shadows off")
        self.assertGreater(changed(without, self.show), 0.5)
        self.assertGreater(without.mean(), self.show.mean())

    def test_objects(self):
        self.window.do("ambient 150")
        whole = self.window.picture("whole")
        self.assertGreater(changed(self.after("object * off"), whole), 5)
        self.assertLess(changed(self.after("object * on"), whole), 0.5)

    def test_specular_and_shininess(self):
        dull = self.after("surface * specular 0")
        self.assertGreater(changed(dull, self.show), 0.05)
        rough, shiny = self.after("surface * specular 1", "surface * shininess 2"), self.after("surface * shininess 2000")
        self.assertGreater(changed(rough, shiny), 0.1)

    def test_samples(self):
        coarse = self.after("samples 1")
        self.assertGreater(changed(coarse, self.show), 0.01)

    def test_master_and_exposure(self):
        self.assertLess(self.after("master 0.2").mean(), self.show.mean() - 5)
        self.window.do("master 1")
        brighter = self.after("exposure 4.5")
        self.window.do("exposure 6.5")
        self.assertGreater(brighter.mean(), self.show.mean() + 10)


    def test_tone_curve(self):
        # Without a curve highlights clip; ACES makes the dark darker.
        try:
            linear = self.after("tone linear")
            self.assertEqual(self.window.state()["tone"], "linear")
            aces = self.after("tone aces")
        finally:
            self.window.do("tone agx")
        self.assertGreater(changed(linear, self.show), 1)
        self.assertGreater((linear.max(axis=2) == 255).sum(), (self.show.max(axis=2) == 255).sum())
        dark = (self.show > 5) & (self.show < 60)
        self.assertLess(aces[dark].mean(), 0.9 * self.show[dark].mean())


class ManyHeads(unittest.TestCase):
    """Fan, hold and palettes, and what of them is in the show."""

    def test_fan_hold_and_palettes(self):
        show = WORK / "heads"
        shutil.copytree(SOURCE / "assets/demo", show, ignore=shutil.ignore_patterns(".ghost"))
        before = (show / "show.toml").read_bytes()
        window = Window("--size", "900x600", "--no-desk", "--quiet", show=show)
        try:
            def pans():
                return [one["pan_deg"] for one in window.state()["by_hand"]["fixtures"].values()]

            window.do("wait opened", "resolution 5", "jump 36", "wait 0.2", "freeze on", 'select "Spot *"', "fan pan -40 40")
            self.assertEqual(pans(), [-40, -20, 0, 20, 40])
            window.do("palette-store position Wide", "fan pan 30 0 symmetric", "fan colour #ff0000 #0000ff")
            self.assertEqual(pans(), [30, 15, 0, 15, 30])
            window.do("palette-store colour Rainbow", "release-all", "palette Wide", "palette Rainbow")
            self.assertEqual(pans(), [-40, -20, 0, 20, 40])
            self.assertEqual(window.state()["palettes"], ["Wide", "Rainbow"])
            window.do("save")
            saved = (show / "show.toml").read_bytes()
            self.assertTrue(saved.startswith(before))
            self.assertIn(b'[[palette]]\nname = "Wide"\nkind = "position"\n[[palette.fixture]]\nname = "Spot 1"\npan_deg = -40\n', saved)
            self.assertIn("there is no palette 'Wde', did you mean 'Wide'", window.ask("palette Wde"))
            window.do("palette-remove Wide", "palette-remove Rainbow", "save")
            self.assertEqual((show / "show.toml").read_bytes().rstrip(), before.rstrip())

            # What is held stays while the recording goes on.
            window.do("release-all", "select *", "hold", "wait settled")
            held = window.picture("held")
            window.do("jump 20", "wait 0.5")
            self.assertLess(changed(window.picture("later"), held), 0.5)
            window.do("release-all")
            self.assertGreater(changed(window.picture("released"), held), 2)
        finally:
            code = window.close()
        self.assertEqual(code, 0, window.text())


class Desk(unittest.TestCase):
    def test_packets_of_a_desk_come_through(self):
        offset = str(-1100 - os.getpid() % 500)  # universes of nobody else
        window = Window("--size", "640x400", "--quiet", "--protocols", "artnet", "--artnet-offset", offset, "--no-poll-reply")
        play = None
        try:
            window.do("wait opened", "resolution 10", "panel-values off", "panel-programmer off", "panel-scene off", "panel-looks off", "panel-fixtures off",
                      "panel-network on")
            self.assertFalse(window.state()["from_desk"])
            play = subprocess.Popen([str(PROGRAM), "play", str(SOURCE / "assets/demo/demo.show"), "--protocol", "artnet", "--to",
                                     "127.0.0.1", "--artnet-offset", offset, "--loop", "--quiet", "--from", "20"])
            state = window.until(lambda state: state["from_desk"] and state["picture"]["latency_ms"] >= 0)
            self.assertLess(state["picture"]["latency_ms"], 1e5)
            self.assertEqual(state["universes"], [1])
            self.assertGreater(state["packet_to_window_ms"]["count"], 0)
            self.assertGreaterEqual(state["packet_to_window_ms"]["max"], state["packet_to_window_ms"]["p50"])
            window.until(lambda state: state["network"] == [])  # all is well, as soon as what is amiss is counted again
            self.assertEqual(state["chips"][0], "LIVE DESK")

            # A desk that is gone is told; what it sent last is held, as long as the show is open.
            play.kill()
            play.wait()
            state = window.until(lambda state: state["chips"][0].startswith("DESK SILENT"))
            self.assertEqual(state["universes"], [1])
            self.assertFalse(state["picture"]["work_light"])
            bare = WORK / "bare"
            shutil.copytree(WORK / "demo", bare, ignore=shutil.ignore_patterns("*.show"))
            show = (bare / "show.toml").read_text()
            (bare / "show.toml").write_text("".join(line for line in show.splitlines(True) if not line.startswith("recording")))
            window.do(f'open "{bare}"', "wait opened")
            state = window.until(lambda state: state["show"].endswith("bare/show.toml") and state["picture"]["work_light"])
            self.assertEqual((state["chips"][0], state["universes"]), ("NO DESK YET", []))
        finally:
            if play:
                play.terminate()
                play.wait()
            code = window.close()
        self.assertEqual(code, 0, window.text())


class BadInput(unittest.TestCase):
    def run_open(self, *arguments, **environment):
        clean = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")}
        return subprocess.run([str(PROGRAM), "open", *map(str, arguments)], env={**clean, **environment}, capture_output=True, text=True,
                              timeout=LONG_S)

    def test_no_display(self):
        done = self.run_open(WORK / "demo")
        self.assertEqual(done.returncode, 1)
        self.assertIn("there is no display", done.stderr)
        self.assertIn("ghostlight render", done.stderr)

    def test_a_display_that_is_not_there(self):
        done = self.run_open(WORK / "demo", DISPLAY=":987")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("the window needs a display", done.stderr)

    def test_no_such_show(self):
        done = self.run_open(WORK / "nothing", DISPLAY=window_driver.DISPLAY)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no such file or folder", done.stderr)

    def test_a_script_that_fails_says_where(self):
        script = WORK / "bad.txt"
        later = WORK / "later.toml"
        script.write_text(f"# nothing wrong yet\nwait opened\ncamera nowhere\nsave-copy {later}\nquit\n")
        done = self.run_open(WORK / "demo", "--forget", "--no-desk", "--script", script, "--size", "400x300", DISPLAY=window_driver.DISPLAY)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("bad.txt:3: camera: ", done.stderr)
        self.assertFalse(later.exists(), "a line after the one that failed was done")

    def test_a_show_that_breaks_leaves_the_one_that_is_open(self):
        broken = WORK / "broken"
        broken.mkdir(exist_ok=True)
        (broken / "show.toml").write_text("[show\n")
        window = Window("--size", "500x400", "--no-desk", "--quiet")
        try:
            window.do("wait opened", "resolution 5", f'open "{broken}"', "wait 1", "wait settled")
            self.assertIn("demo", window.state()["show"])
        finally:
            window.close()


class Editing(unittest.TestCase):
    """The show is edited, saved, undone, and outlives a kill."""

    def setUp(self):
        self.show = WORK / self.id().split(".")[-1]
        shutil.copytree(SOURCE / "assets/demo", self.show, ignore=shutil.ignore_patterns(".ghost"))
        self.file = self.show / "show.toml"
        self.original = self.file.read_bytes()

    def open(self):
        window = Window("--size", "900x600", "--no-desk", "--quiet", show=self.show)
        window.do("wait opened", "resolution 10", "jump 36", "wait 0.2", "freeze on")
        x, y, width, _ = window.place()
        window.xdo("mousemove", x + width // 2, y + 8, "click", 1)  # the picture has the keys now
        return window

    def test_edits_are_seen_saved_and_undone(self):
        window = self.open()
        try:
            window.do("camera house", "select \"Spot 2\"", "intensity 1", "pan 0", "tilt 0")
            hung = window.picture("hung")
            window.do("move 0 0 -3")
            lowered = window.picture("lowered")
            # The frame of the camera is a tenth of so narrow a picture.
            self.assertGreater(changed(hung, lowered), 0.003, "a lamp that is moved is seen elsewhere")
            window.do("address 7.100")
            state = window.until(lambda s: s["patch"]["Spot 2"]["universe"] == 7)
            self.assertEqual(state["patch"]["Spot 2"]["address"], 100)
            self.assertEqual(state["selection"], ["Spot 2"])
            self.assertIn("Spot 2", state["by_hand"]["fixtures"], "what was done by hand stays")
            self.assertTrue(state["unsaved"])
            self.assertEqual(self.file.read_bytes(), self.original)
            window.xdo("key", "ctrl+s")
            window.until(lambda s: not s["unsaved"])
            saved = self.file.read_text()
            self.assertIn("universe = 7\naddress = 100\nposition_m = [0, 7.855, 3.26", saved)
            self.assertEqual(saved.count("# back truss"), self.original.decode().count("# back truss"))
            window.xdo("key", "ctrl+d")
            window.until(lambda s: s["selection"] == ["Spot 7"] or "Spot 2" not in s["selection"])
            self.assertEqual(len(window.state()["patch"]), saved.count("[[fixture]]") + 1)
            window.xdo("key", "Delete")
            window.until(lambda s: len(s["patch"]) == saved.count("[[fixture]]"))
            for _ in range(4):
                window.xdo("key", "ctrl+z")
            window.do("save")
            self.assertEqual(self.file.read_bytes(), self.original)
            self.assertLess(changed(hung, window.picture("again")), 0.05)
            self.assertIn("no fixture is selected", window.ask("select-none") + window.ask("remove"))
            self.assertIn("is no address like 2.101", window.ask("address 1.900"))
        finally:
            self.assertEqual(window.close(), 0)

    def test_a_kept_camera_shows_what_was_seen(self):
        window = self.open()
        try:
            window.do("camera house", "wait settled")
            seen = window.state()
            before = window.picture("seen")
            window.xdo("key", "ctrl+k")
            window.until(lambda s: s["unsaved"])
            window.do("camera close", "wait settled")
            window.xdo("key", "4")
            window.until(lambda s: s["camera"]["name"] == "Camera 4")
            after = window.picture("kept")
            state = window.state()
            for key in ("frame", "view"):
                self.assertEqual(state[key], seen[key])
            self.assertLess(changed(before, after), 0.5)
            window.do("save")
        finally:
            self.assertEqual(window.close(), 0)
        self.assertIn('name = "Camera 4"', self.file.read_text())
        self.assertEqual(self.file.read_text().count("size = [1024, 300]"), 2)
        window = self.open()
        try:
            window.do("camera 4", "wait settled")
            self.assertEqual(window.state()["frame"], seen["frame"])
        finally:
            self.assertEqual(window.close(), 0)

    def test_lamps_are_hung_under_a_truss(self):
        window = self.open()
        try:
            window.do('select "Wash *"')
            x, y, width, _ = window.place()
            window.xdo("mousemove", x + width // 2, y + 8, "key", "ctrl+h")
            # The middle truss: eight pieces from -8 to 8 m, its underside at 6.77 m; they hung at 6.76 m, two of five elsewhere.
            state = window.until(lambda s: s["patch"]["Wash 4"]["position_m"][1] < 5)
            places = [state["patch"][f"Wash {number}"]["position_m"] for number in range(1, 6)]
            for place, wanted in zip(places, (-6.406, -3.203, 0, 3.203, 6.406)):
                for is_m, wanted_m in zip(place, (wanted, 4.3, 6.771)):
                    self.assertAlmostEqual(is_m, wanted_m, places=3)
            window.do("hang truss_front_3")
            self.assertAlmostEqual(window.state()["patch"]["Wash 1"]["position_m"][1], 0.4, places=3)
            self.assertIn("is no truss or pipe", window.ask("hang tower*"))
            window.do("undo", "undo", "save")
            self.assertEqual(self.file.read_bytes(), self.original)
        finally:
            self.assertEqual(window.close(), 0)

    def test_the_air_is_edited_without_opening_the_show_again(self):
        window = self.open()
        try:
            window.do("camera close", "panel-air on")
            even = window.picture("even")
            window.do("add-hazer 0 2 0", "hazer 1 rate 40")
            plume = window.picture("plume")
            self.assertGreater(changed(even, plume), 0.1, "a plume is seen")
            window.do("clouds 1", "haze fog", "smoke 0.5")
            self.assertGreater(changed(plume, window.picture("fog")), 1)
            self.assertNotIn("taking the changes of", window.text(), "the show is not opened anew for it")
            self.assertIn("[[hazer]]", (self.show / ".ghost/draft.toml").read_text())
            window.do("save")
            saved = self.file.read_text()
            for line in ('preset = "fog"', "unevenness = 1", "rate = 40"):
                self.assertIn(line, saved)
            window.do("release-all", *["undo"] * 6, "save")
            self.assertEqual(self.file.read_bytes(), self.original)
            self.assertLess(changed(even, window.picture("even again")), 0.05, "thickness, clouds and plume are gone")
        finally:
            self.assertEqual(window.close(), 0)

    def test_what_was_not_saved_outlives_a_kill(self):
        window = self.open()
        window.do("select \"Spot 3\"", "rename Killed", "wait 2")
        window.process.kill()
        window.process.wait()
        window.socket.close()
        self.assertEqual(self.file.read_bytes(), self.original)
        window = self.open()
        try:
            self.assertTrue(window.state()["changes_wait"])
            window.do("select \"Spot 1\"")
            self.assertIn("wait: take them or drop them", window.ask("rename Other"))
            window.shoot("changes_wait.png")
            window.do("take-changes")
            window.until(lambda s: "Killed" in s["patch"])
            window.do("undo", "save")
            self.assertEqual(self.file.read_bytes(), self.original)
        finally:
            self.assertEqual(window.close(), 0)


if __name__ == "__main__":
    sys.exit(window_driver.main(sys.modules[__name__]))

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The window at work, on a screen of its own: looks that are stored, faded and undone, false colours and the probe, bakes and pictures in
the background while the view goes on, baked cameras, the picture on a second display. Usage: window_work_test.py SOURCE_FOLDER
BUILD_FOLDER [FOLDER_FOR_PICTURES]."""
import os
import pathlib
import shutil
import subprocess
import sys
import time
import tomllib
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent / "lib"))
import window as window_driver  # noqa: E402
from window import PROGRAM, SOURCE, Window, changed  # noqa: E402

import numpy  # noqa: E402
from PIL import Image  # noqa: E402

WORK = None
PANELS = ("fixtures", "values", "programmer", "scene", "looks", "export")


def read(file):
    return numpy.asarray(Image.open(file).convert("RGB")).astype(float)


class AtWork(unittest.TestCase):
    def setUp(self):
        self.show = WORK / self.id().split(".")[-1]
        shutil.copytree(SOURCE / "assets/demo", self.show, ignore=shutil.ignore_patterns(".ghost"))
        # Maps are made once for all of these tests.
        if (WORK / "maps").exists():
            shutil.copytree(WORK / "maps", self.show / ".ghost/distances")

    def open(self, *arguments, size="480x320"):
        window = Window("--size", size, "--no-desk", "--quiet", *arguments, show=self.show)
        window.do("wait opened", *[f"panel-{one} off" for one in PANELS], "resolution 12", "jump 36", "wait 0.2", "freeze on", "camera close",
                  "wait settled")
        if not (WORK / "maps").exists() and (self.show / ".ghost/distances").exists():
            shutil.copytree(self.show / ".ghost/distances", WORK / "maps")
        return window

    def test_looks(self):
        window = self.open()
        try:
            window.do("select *", "intensity 0", 'select "Spot *"', "intensity 1", "gobo 0", "colour #ff0000", "look-store Red")
            red = window.picture("red")
            window.do("colour #0000ff", "smoke 2", 'look-store "Blue haze"', 'look-fade "Blue haze" 1.5')
            blue = window.picture("blue")
            self.assertGreater(changed(red, blue), 5)
            stored = tomllib.loads((self.show / "looks.toml").read_text())
            self.assertEqual([look["name"] for look in stored["look"]], ["Red", "Blue haze"])
            self.assertEqual(stored["look"][1]["fade_s"], 1.5)
            window.do("look-recall Red 0")
            self.assertLess(changed(window.picture("again"), red), 0.5)
            self.assertEqual(window.state()["look"], "Red")
            # A fade is under way, then over.
            window.do('look-recall "Blue haze" 3', "wait 0.2")
            self.assertTrue(window.state()["fades"])
            window.do("wait settled")
            self.assertFalse(window.state()["fades"])
            self.assertLess(changed(window.picture("faded"), blue), 0.5)
            window.do("undo")
            self.assertLess(changed(window.picture("undone"), red), 0.5)
            window.do("look-next")
            window.until(lambda state: state["look"] == "Blue haze")
            window.do('look-remove "Blue haze"')
            self.assertEqual(window.state()["looks"], ["Red"])
            window.do("undo")
            self.assertEqual(window.state()["looks"], ["Red", "Blue haze"])
            self.assertIn("did you mean 'Red'", window.ask("look-recall Redd"))
            window.do("panel-looks on")
            window.shoot("looks.png")
        finally:
            self.assertEqual(window.close(), 0)
        # The command line has them, too.
        for name, wanted in (("Red", 0), ("Blue haze", 2)):
            subprocess.run([PROGRAM, "render", self.show, "-o", WORK / "look.png", "--view", "close", "--live", "--size", "240x160", "--look",
                            name, "--quiet"], check=True, timeout=window_driver.LONG_S)
            picture = read(WORK / "look.png")
            self.assertEqual(int(picture.mean(axis=(0, 1)).argmax()), wanted, name)
        subprocess.run([PROGRAM, "sheet", self.show, "-o", WORK / "sheet.png", "--size", "96x54", "--view", "close", "--view", "house",
                        "--quiet"], check=True, timeout=window_driver.LONG_S)
        self.assertEqual(read(WORK / "sheet.png").shape[:2], (2 * 58 + 4, 2 * 100 + 4))

    def test_solo_gel_and_lamp(self):
        window = self.open()
        try:
            window.do("select *", "intensity 1", "gobo 0", "colour #ffffff")
            whole = window.picture("whole")
            window.do('select "Spot 1"', "solo on")
            alone = window.picture("alone")
            self.assertLess(alone.mean(), 0.7 * whole.mean())
            self.assertEqual(window.state()["by_hand"]["solo"], ["Spot 1"])
            window.do("solo off")
            self.assertLess(changed(window.picture("all"), whole), 0.5)
            window.do("select *", "gel #2040ff")
            gelled = window.picture("gelled")
            self.assertGreater(gelled[..., 2].mean(), 1.3 * gelled[..., 0].mean())
            self.assertLess(gelled.mean(), whole.mean())
            window.do("wait 1.6", "gel off", "wait 1.6", "lamp 3 2800")  # changes that follow closely are one step
            lamp = window.picture("lamp")
            self.assertGreater(lamp.mean(), whole.mean() + 3)
            self.assertGreater((lamp[..., 0] - lamp[..., 2]).mean(), (whole[..., 0] - whole[..., 2]).mean())
            window.do("undo", "undo")
            self.assertLess(changed(window.picture("back"), gelled), 0.5)
        finally:
            self.assertEqual(window.close(), 0)

    def test_false_colours_and_probe(self):
        window = self.open()
        try:
            _, _, width, height = window.place()
            window.do(f"probe {width // 2} {height // 2}")
            probe = window.until(lambda state: state["probe"])["probe"]
            self.assertGreater(probe["lux"], 0.1)
            self.assertGreater(probe["cd_m2"], 0.001)
            self.assertLess(probe["cd_m2"], probe["lux"], "a surface sends out less than a third of what arrives, in haze a bit more")
            # Twice the light is twice the lux and not twice the exposure.
            window.do("select *", "lamp 2", "exposure 9", "wait settled")
            brighter = window.until(lambda state: state["probe"] and state["probe"]["lux"] > 1.3 * probe["lux"])["probe"]
            self.assertAlmostEqual((brighter["lux"] - 1.5) / (probe["lux"] - 1.5), 2, delta=0.05)  # 1.5 lx of even light
            window.do("release-all", "exposure 6", "false-colour lux 1 10000")
            lux = window.picture("lux")
            self.assertGreater(len(numpy.unique(lux.reshape(-1, 3), axis=0)), 100)
            # Smoke hides from the eye what a meter on the surface still sees.
            window.do("shadows off")
            self.assertGreater(changed(window.picture("open"), lux), 0.3, "shadows are in the lux")
            window.do("shadows on", "false-colour luminance 0.1 1000")
            luminance = window.picture("luminance")
            self.assertGreater(changed(luminance, lux), 10)
            window.shoot("false_luminance.png")
            window.do("false-colour lux", "wait settled")
            window.shoot("false_lux.png")
            window.do("false-colour off", "probe off")
            window.until(lambda state: state["picture"]["false_colour"] == 0)
            self.assertIn("none of lux, luminance and off", window.ask("false-colour watts"))
            # The picture in linear values.
            window.do(f'save-picture "{WORK / "now.exr"}"', "wait saved")
            self.assertEqual((WORK / "now.exr").read_bytes()[:4], b"\x76\x2f\x31\x01")
        finally:
            self.assertEqual(window.close(), 0)

    def test_bake_and_baked_picture(self):
        toml = self.show / "show.toml"
        text = toml.read_text(encoding="utf-8")
        self.assertIn("\nsize = [1024, 300]\n", text)
        toml.write_text(text.replace("\nsize = [1024, 300]\n", "\nsize = [768, 225]\n"), encoding="utf-8")
        window = self.open()
        try:
            window.do("camera house", "wait settled", "resolution 0")
            window.until(lambda state: "is not baked" in state["picture"]["supply"])
            window.do("resolution 5", "bake house 8")  # few pixels, so that the processor is left to the bake
            shares = []
            pictures = set()
            window.do("freeze off")
            while window.state()["jobs"][0]["state"] in ("waits", "runs"):
                state = window.state()
                shares.append(state["jobs"][0]["share"])
                pictures.add(round(state["at_s"], 2))
                time.sleep(0.1)
            self.assertEqual(window.state()["jobs"][0]["state"], "done", window.state()["jobs"])
            self.assertEqual(shares, sorted(shares), "progress goes on")
            self.assertGreater(len(pictures), 2, "the picture goes on meanwhile")
            window.do("resolution 0", "jump 36", "wait 0.2", "freeze on")  # the show went on meanwhile, perhaps into the dark
            state = window.until(lambda state: state["picture"]["baked"])
            self.assertIn("baked: house", state["picture"]["supply"])
            self.assertEqual(state["picture"]["camera"]["width"], 768)
            window.do("wait settled")
            window.shoot("baked.png")
            baked = window.picture("baked")
            self.assertGreater(baked.mean(), 3)
            window.do("master 0")
            self.assertLess(window.picture("dark").mean(), 0.5 * baked.mean())
            window.do("master 1", "fly 1 0 0")
            self.assertIn("free camera", window.until(lambda state: not state["picture"]["baked"])["picture"]["supply"])
            window.do("camera house", "wait settled")
            window.until(lambda state: state["picture"]["baked"])
            window.do("object * off")
            window.until(lambda state: "hidden" in state["picture"]["supply"])
            window.do("undo", "baked off")
            window.until(lambda state: "turned off" in state["picture"]["supply"])
            self.assertFalse(window.state()["picture"]["baked"])
        finally:
            self.assertEqual(window.close(), 0)

    def test_pictures_in_the_background(self):
        window = self.open()
        try:
            window.do("select *", "intensity 1", "colour #00ff00", "look-store Green", "panel-export on")
            window.do(f'export-still "{WORK / "still.png"}" 160x90', f'export-film "{WORK / "clip.mp4"}" 36 36.2 10 64x36',
                      f'export-sheet "{WORK / "all.png"}" 64x36')
            window.shoot("export.png")
            window.do("wait jobs")
            self.assertEqual([job["state"] for job in window.state()["jobs"]], ["done"] * 3, window.state()["jobs"])
            still = read(WORK / "still.png")
            self.assertEqual(still.shape, (90, 160, 3))
            self.assertGreater(still[..., 1].mean(), 1.3 * still[..., 0].mean(), "lit as hands have it")
            self.assertGreater((WORK / "clip.mp4").stat().st_size, 1000)
            self.assertEqual(read(WORK / "all.png").shape[:2], (1 * 40 + 4, 3 * 68 + 4))
            self.assertEqual(list((self.show / ".ghost").glob("*window-look*")), [])
            # The same film in tasks, and of the farm's jobs the look stays as long as the plan.
            window.do(f'export-film "{WORK / "one.mp4"}" 36 36.2 10 192x108', f'export-film "{WORK / "tasks.mp4"}" 36 36.2 10 192x108 local',
                      "wait jobs")
            self.assertEqual([job["state"] for job in window.state()["jobs"][-2:]], ["done"] * 2, window.state()["jobs"])
            self.assertEqual((WORK / "one.mp4").read_bytes(), (WORK / "tasks.mp4").read_bytes())
            self.assertEqual(len(list((self.show / ".ghost/farm").glob("look-*.toml"))), 1)
            window.shoot("farm.png")
            # Cancelled: nothing is written.
            window.do(f'export-film "{WORK / "never.mp4"}" 0 50 30 640x360', "wait 1", "cancel-jobs", "wait jobs")
            self.assertEqual(window.state()["jobs"][-1]["state"], "cancelled")
            self.assertFalse((WORK / "never.mp4").exists())
            self.assertIn("no such folder", window.ask(f'export-still "{WORK / "nowhere/x.png"}"'))
            self.assertIn("must end in", window.ask(f'export-still "{WORK / "x.txt"}"'))
            window.do('select "Spot 1"', "rename Other")
            self.assertIn("save the show first", window.ask("bake house"))
        finally:
            self.assertEqual(window.close(), 0)

    def test_an_export_of_another_shape_shows_all_of_the_frame(self):
        window = self.open()
        try:
            window.do("camera house", "wait settled", "select *", "intensity 1")
            # The frame is 1024x300; of 320x180 it is the middle band, of 180x320, too.
            for name, size in (("frame", "320x94"), ("wide", "320x180"), ("tall", "180x320")):
                window.do(f'export-still "{WORK / name}.png" {size}')
            window.do("wait jobs")
            self.assertEqual([job["state"] for job in window.state()["jobs"]], ["done"] * 3, window.state()["jobs"])
            frame, wide, tall = (read(WORK / f"{name}.png").astype(float) for name in ("frame", "wide", "tall"))
            self.assertLess(changed(wide[43:137], frame), 3)
            small = numpy.asarray(Image.fromarray(frame.astype("uint8")).resize((180, 53))).astype(float)
            self.assertLess(changed(tall[134:187], small), 6)
        finally:
            self.assertEqual(window.close(), 0)

    def test_second_display(self):
        window = self.open()
        try:
            self.assertIn("one display only", window.ask("second-display"))
            self.assertIn("there is no display '7'", window.ask("second-display 7"))
            window.do("second-display window", "wait 1")
            self.assertEqual(window.state()["second_display"], "a window of its own")
            found = subprocess.run(["xdotool", "search", "--name", "Ghostlight, the picture"], env={"DISPLAY": window_driver.DISPLAY},
                                   capture_output=True, text=True, check=True).stdout.split()
            self.assertEqual(len(found), 1)
            # The larger of the two says how many pixels there are.
            window.do("resolution 0")
            window.until(lambda state: state["camera"]["width"] == 960)
            window.do("second-display off")
            window.until(lambda state: state["second_display"] == "" and state["camera"]["width"] < 960)
        finally:
            self.assertEqual(window.close(), 0)

    def test_a_desk_is_recorded_and_played(self):
        offset = str(-1700 - os.getpid() % 500)  # universes of nobody else
        window = Window("--size", "640x400", "--quiet", "--protocols", "artnet", "--artnet-offset", offset, "--no-poll-reply", show=self.show)
        play = None
        try:
            window.do("wait opened", "resolution 5", *[f"panel-{one} off" for one in PANELS])
            play = subprocess.Popen([str(PROGRAM), "play", str(SOURCE / "assets/demo/demo.show"), "--protocol", "artnet", "--to", "127.0.0.1",
                                     "--artnet-offset", offset, "--loop", "--quiet", "--from", "20"])
            window.until(lambda state: state["from_desk"])
            window.do("record")
            window.until(lambda state: state["recorded_s"] > 1.5)
            self.assertIn("a recording runs", window.ask(f'record "{WORK / "x.show"}"'))
            window.do("record off")
            file = pathlib.Path(window.until(lambda state: state["recorded"])["recorded"])
            self.assertEqual(file.parent.resolve(), self.show.resolve())
            self.assertGreater(file.stat().st_size, 100)
            window.do("play-recorded")
            state = window.until(lambda state: not state["from_desk"] and state["recording_s"] < 30)
            self.assertGreater(state["recording_s"], 1.4)
            window.do("loop 0.2 0.6", "jump 0.2", "wait 0.3")
            places = set()
            for _ in range(20):
                places.add(round(window.state()["at_s"], 2))
                time.sleep(0.1)
            self.assertGreater(len(places), 3)
            self.assertLessEqual(max(places), 0.7)
            window.do("loop off", "play-file own", "wait 0.3")
            self.assertGreater(window.until(lambda state: state["recording_s"] > 30)["recording_s"], 90)
            self.assertIn("it needs the name", window.ask("play-file"))
        finally:
            if play:
                play.terminate()
                play.wait()
            self.assertEqual(window.close(), 0, window.text())

    def test_exposure_set_while_the_camera_flies_stays(self):
        window = self.open()
        try:
            window.do("camera house", "exposure 3.5", "wait settled")
            self.assertAlmostEqual(window.state()["camera"]["ev100"], 3.5)
        finally:
            self.assertEqual(window.close(), 0)


if __name__ == "__main__":
    sys.exit(window_driver.main(sys.modules[__name__]))

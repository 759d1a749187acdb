#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Files dropped on the window by the protocol of file managers (XDND), on a screen of its own: what becomes a part of the show, what is opened,
and what is said of the rest. Usage: window_drop_test.py SOURCE_FOLDER BUILD_FOLDER [FOLDER_FOR_PICTURES [TEST ...]]."""
import pathlib
import shutil
import sys
import unittest
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "lib"))
import window as of_window  # noqa: E402
from drop import drop  # noqa: E402
from window import Window, main  # noqa: E402

WORK = None
SCENE = """<?xml version="1.0" encoding="UTF-8"?>
<GeneralSceneDescription verMajor="1" verMinor="6" provider="test" providerVersion="1"><Scene><Layers>
<Layer name="Rig" uuid="11111111-1111-4111-8111-111111111111"><ChildList>
<Fixture name="Head" uuid="33333330-2222-4222-8222-222222222222"><Matrix>{1,0,0}{0,1,0}{0,0,1}{0,1000,6000}</Matrix>
<GDTFSpec>Ghostlight@LED_Par.gdtf</GDTFSpec><GDTFMode>RGBW</GDTFMode><Addresses><Address break="0">401</Address></Addresses></Fixture>
</ChildList></Layer></Layers></Scene></GeneralSceneDescription>"""


class Drop(unittest.TestCase):
    def setUp(self):
        self.elsewhere = WORK / self.id().split(".")[-1]
        self.elsewhere.mkdir()
        self.par = self.elsewhere / "Ghostlight@LED_Par.gdtf"
        shutil.copy(WORK / "fixtures" / self.par.name, self.par)
        self.window = None

    def tearDown(self):
        if self.window:
            self.assertEqual(self.window.close(), 0)

    def open(self, show):
        self.window = Window("--size", "900x600", "--no-desk", "--quiet", show=show)
        if show is not False:
            self.window.do("wait opened", "resolution 12", "freeze on")
        return self.window

    def demo(self):
        show = self.elsewhere / "demo"
        shutil.copytree(WORK / "demo", show)
        return show

    def plot(self):
        file = self.elsewhere / "tour.mvr"
        with zipfile.ZipFile(file, "w") as archive:
            archive.writestr("GeneralSceneDescription.xml", SCENE)
            archive.write(self.par, self.par.name)
        return file

    def drop(self, *files, at=(450, 400)):
        """On the picture; the window takes it."""
        self.assertEqual(drop(of_window.DISPLAY, *at, *files), (True, True))

    def test_a_fixture_stands_where_it_is_dropped(self):
        show = self.demo()
        window = self.open(show)
        before = set(window.state()["patch"])
        self.drop(self.par, at=(400, 400))
        state = window.until(lambda state: len(state["patch"]) == len(before) + 1)
        (left,) = set(state["patch"]) - before
        self.drop(self.par, at=(600, 400))
        state = window.until(lambda state: len(state["patch"]) == len(before) + 2)
        (right,) = set(state["patch"]) - before - {left}
        self.assertGreater(state["patch"][right]["position_m"][0], state["patch"][left]["position_m"][0] + 0.5)
        self.assertTrue((show / self.par.name).is_file(), "it is copied beside the show")
        self.assertEqual(state["notice"], "")

    def test_a_plot_becomes_that_of_a_show_without_one_and_the_next_is_opened(self):
        show = self.demo()
        window = self.open(show)
        before = len(window.state()["patch"])
        self.drop(self.plot())
        state = window.until(lambda state: len(state["patch"]) == before + 1)
        self.assertTrue(state["show"].endswith("demo/show.toml"))
        self.assertTrue((show / "tour.mvr").is_file(), "it is copied beside the show")
        self.drop(self.plot())
        state = window.until(lambda state: state["show"] and state["show"].endswith("tour.mvr"))
        self.assertEqual(list(state["patch"]), ["Head"])

    def test_a_folder_is_opened(self):
        window = self.open(None)
        other = self.demo()
        self.drop(other)
        window.until(lambda state: state["show"] == str(other / "show.toml"))
        nothing = self.elsewhere / "nothing"
        nothing.mkdir()
        self.drop(nothing)
        state = window.until(lambda state: "Not opened" in state["notice"])
        self.assertIn("nothing", state["notice"])
        self.assertEqual(state["show"], str(other / "show.toml"), "what was open stays open")

    def test_what_is_not_ours_is_said(self):
        window = self.open(None)
        text = self.elsewhere / "riders.txt"
        text.write_text("two towels\n")
        self.drop(text)
        state = window.until(lambda state: state["notice"])
        self.assertIn("riders.txt", state["notice"])
        self.assertIn("What was open stays open", state["notice"])

    def test_without_a_show(self):
        window = self.open(False)
        model = self.elsewhere / "deck.obj"
        model.write_text("v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n")
        for file in (self.par, model):
            self.drop(file)
            state = window.until(lambda state: state["notice"])
            self.assertIn("no show is open", state["notice"])
        self.drop(self.plot())
        window.do("wait opened")
        self.assertEqual(list(window.state()["patch"]), ["Head"])


if __name__ == "__main__":
    sys.exit(main(sys.modules[__name__]))

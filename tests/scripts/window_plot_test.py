#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A designer's first minutes in the window, on a screen of its own: a show that cannot be opened, one without a camera, a plot that becomes
a show and whose heads get optics, parameters by hand that are seen, cues, and heads that are dark with their reasons.
Usage: window_plot_test.py SOURCE_FOLDER BUILD_FOLDER [FOLDER_FOR_PICTURES]."""
import pathlib
import shutil
import sys
import unittest
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).parent / "lib"))
from window import SOURCE, Window, changed, main  # noqa: E402

WORK = None
SPOT = "Vari-Lite@VL2500_Spot.gdtf"
# A head whose file says nothing of its light, as some exporters write it.
STUB = """<?xml version="1.0" encoding="UTF-8"?><GDTF DataVersion="1.2"><FixtureType Name="Stub" ShortName="Stub" LongName="Stub"
 Manufacturer="Nobody" Description="" FixtureTypeID="AAAAAAAA-0000-4000-8000-000000000001" Thumbnail="">
<AttributeDefinitions><ActivationGroups/><FeatureGroups><FeatureGroup Name="Dimmer" Pretty="Dimmer"><Feature Name="Dimmer"/></FeatureGroup>
</FeatureGroups><Attributes><Attribute Name="Dimmer" Pretty="Dim" Feature="Dimmer.Dimmer"/></Attributes></AttributeDefinitions><Wheels/>
<Models/><Geometries><Geometry Name="Body" Model=""/></Geometries><DMXModes><DMXMode Name="Standard" Geometry="Body"><DMXChannels>
<DMXChannel DMXBreak="1" Offset="1" Highlight="255/1" Geometry="Body"><LogicalChannel Attribute="Dimmer"><ChannelFunction Name="Dimmer"
 Attribute="Dimmer" DMXFrom="0/1" Default="0/1"/></LogicalChannel></DMXChannel></DMXChannels></DMXMode></DMXModes></FixtureType></GDTF>"""


# The same as Capture writes it: nobody knows what its channels do.
NAMELESS = STUB.replace('Attribute="Dimmer"', 'Attribute="Dimmer1"').replace("</DMXChannels>", """<DMXChannel DMXBreak="1" Offset="2" Geometry="Body">
<LogicalChannel Attribute="Dimmer2"><ChannelFunction Attribute="Dimmer2"/></LogicalChannel></DMXChannel></DMXChannels>""")


def plot(path, has_file=True, description=STUB, specs=("Nobody@Stub.gdtf",)):
    """Three heads of the stub, in a file with their GDTF, or without; specs: the files that they ask for, in turn."""
    stub = path.parent / "stub.gdtf"
    with zipfile.ZipFile(stub, "w") as archive:
        archive.writestr("description.xml", description)
    heads = "".join(f"""<Fixture name="Head {i + 1}" uuid="3333333{i}-2222-4222-8222-222222222222">
<Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{2000 * i},1000,6000}}</Matrix><GDTFSpec>{specs[i % len(specs)]}</GDTFSpec><GDTFMode>Standard</GDTFMode>
<Addresses><Address break="0">{1 + i}</Address></Addresses></Fixture>""" for i in range(3))
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("GeneralSceneDescription.xml", f"""<?xml version="1.0" encoding="UTF-8"?>
<GeneralSceneDescription verMajor="1" verMinor="6" provider="test" providerVersion="1"><Scene><Layers>
<Layer name="Rig" uuid="11111111-1111-4111-8111-111111111111"><ChildList>{heads}</ChildList></Layer></Layers></Scene>
</GeneralSceneDescription>""")
        if has_file:
            archive.write(stub, "Nobody@Stub.gdtf")


class FirstMinutes(unittest.TestCase):
    def test_shows_with_faults(self):
        broken, without_camera = WORK / "broken", WORK / "without camera"
        for folder in (broken, without_camera):
            folder.mkdir()
        (broken / "show.toml").write_text('[show]\nname = "a"\nstage = "none.glb\n')
        (without_camera / "show.toml").write_text('[show]\nname = "a"\nstagf = 1\n[[fixture]]\nname = "Lamp"\ngdtf = "none.gdtf"\n')
        window = Window("--size", "900x600", "--no-desk", "--quiet")
        try:
            window.do("wait opened")
            window.do(f'open "{broken}"')
            state = window.until(lambda state: state["notice"])
            self.assertIn("show.toml:3: is not TOML: a quotation mark is missing", state["notice"])
            self.assertTrue(state["show"].endswith("demo/show.toml"), "what was open stays open")
            window.shoot("broken.png")
            window.do(f'open "{without_camera}"', "wait opened")
            state = window.state()
            self.assertRegex(state["notice"], r"^Opened, but: .*show\.toml:1: \[show\] stage is missing")
            self.assertEqual(state["camera"]["name"], "house")
            self.assertGreaterEqual(state["messages"], 3, "no camera, an unknown key, no fixture file")
        finally:
            self.assertEqual(window.close(), 0)

    def test_plot_with_heads_without_optics(self):
        plot(WORK / "tour.mvr")
        window = Window("--size", "900x600", "--no-desk", "--quiet")
        try:
            window.do("wait opened", f'import-plot "{WORK / "tour.mvr"}"')
            state = window.until(lambda state: state["show"] and state["show"].endswith("tour/show.toml"))
            self.assertEqual(state["fixtures"], 3)
            self.assertIn("3 heads have no optics in their files", state["notice"])
            window.shoot("plot.png")
            window.do(f'substitute Nobody@Stub.gdtf "{WORK / "fixtures" / SPOT}"', "wait settled")
            self.assertEqual(window.state()["toast"], "'Nobody@Stub.gdtf' substituted")
            window.do("save")
            self.assertIn(f'for = "Nobody@Stub.gdtf"\ngdtf = "{SPOT}"', (WORK / "tour/show.toml").read_text())
            window.do("undo", "wait settled", "redo", "wait settled")
            window.do(f'plot-text "{WORK / "plot.txt"}"')
            self.assertIn("3 fixtures of 1 type", (WORK / "plot.txt").read_text())
        finally:
            self.assertEqual(window.close(), 0)

    def test_plot_whose_fixture_file_is_missing(self):
        plot(WORK / "bare.mvr", has_file=False)
        window = Window("--size", "900x600", "--no-desk", "--quiet", show=WORK / "bare.mvr")
        try:
            window.do("wait opened")
            state = window.until(lambda state: "plot_page" in state and "plot" in state["panels"])
            page = state["plot_page"]
            self.assertEqual([(one["file"], one["heads"], one["dark"]) for one in page["lightless"]], [("Nobody@Stub.gdtf", 3, True)])
            self.assertGreaterEqual(page["missing"], 1)
            self.assertGreater(state["view"][2], 0.6 * 900, "the picture keeps its share")
            self.assertIn("3 heads have no optics and stay dark", state["notice"])
            window.do("select *", "intensity 1")
            self.assertIn("3 fixtures, of which 3 have no optics and stay dark", window.state()["toast"])
            window.do("release-all", "select-none")
            window.do("plot-select Nobody@Stub.gdtf")
            self.assertEqual(len(window.state()["selection"]), 3)
            self.assertIn("no fixtures of a file, a kind or a title", window.ask("plot-select nothing"))
            window.shoot("plot-page.png")
            # A key that edits says that it must be a show first, and offers to make one.
            x, y, width, _ = window.place()
            window.xdo("mousemove", x + width // 2, y + 8, "click", 1)  # the picture has the keys now
            window.xdo("key", "ctrl+k")
            self.assertIn("A show that is made of it", window.until(lambda state: state["notice"])["notice"])
            # It is an edit of a show, which the plot becomes by itself.
            window.do(f'substitute Nobody@Stub.gdtf "{WORK / "fixtures" / "Ghostlight@LED_Par.gdtf"}" "Dimmer RGB"')
            window.until(lambda state: state["show"].endswith("bare/show.toml") and not state.get("plot_page", page)["lightless"])
            dark = window.picture("dark")
            window.do("select *", "intensity 1")
            self.assertGreater(changed(window.picture("lit"), dark), 0.2)
            window.do("save")
            self.assertIn('gdtf = "Ghostlight@LED_Par.gdtf"\nmode = "Dimmer RGB"', (WORK / "bare/show.toml").read_text())
            window.do("undo", "undo")
            window.until(lambda state: [one["file"] for one in state["plot_page"]["lightless"]] == ["Nobody@Stub.gdtf"])
        finally:
            self.assertEqual(window.close(), 0)

    def test_files_that_are_taken_while_the_plot_becomes_a_show(self):
        plot(WORK / "two.mvr", has_file=False, specs=("Nobody@Stub.gdtf", "Nobody@Other.gdtf"))
        window = Window("--size", "900x600", "--no-desk", "--quiet", show=WORK / "two.mvr")
        try:
            window.do("wait opened")
            window.until(lambda state: "plot_page" in state)
            # The first makes a show of it. The second comes when that is made and not open yet: it is no reason to make it once more,
            # and the first one stays.
            window.do(f'substitute Nobody@Stub.gdtf "{WORK / "fixtures" / "Ghostlight@LED_Par.gdtf"}" "Dimmer RGB"', "wait jobs",
                      f'substitute Nobody@Other.gdtf "{WORK / "fixtures" / SPOT}"')
            window.until(lambda state: state["show"].endswith("two/show.toml") and not state.get("plot_page", {"lightless": 1})["lightless"])
            window.do("save")
            text = (WORK / "two/show.toml").read_text()
            self.assertIn('for = "Nobody@Stub.gdtf"', text)
            self.assertIn('for = "Nobody@Other.gdtf"', text)
            self.assertEqual(len(list((WORK / "two").glob("*.mvr"))), 1, "it was imported once")
        finally:
            self.assertEqual(window.close(), 0)

    def test_heads_whose_channels_have_no_names_are_lit_by_hand(self):
        plot(WORK / "capture.mvr", description=NAMELESS)
        window = Window("--size", "900x600", "--no-desk", "--quiet", show=WORK / "capture.mvr")
        try:
            window.do("wait opened", "work-light off", "panel-plot off")
            self.assertIn("3 heads have no optics in their files: what is seen of their light is assumed", window.state()["notice"])
            window.until(lambda state: state["picture"]["missing_maps"] == 0)  # though no picture changes by it
            dark = window.picture("dark")
            window.do("select *", "intensity 1")
            self.assertGreater(changed(window.picture("lit"), dark), 0.1)
            self.assertNotIn("stay dark", window.state()["toast"])
            window.do("intensity 0", 'select "Head 1"')
            window.until(lambda state: "hands have it so: its intensity is at 0 %" in state["explained"].get("why", ""))
            window.do("release")
            window.until(lambda state: "hands alone light it" in state["explained"].get("why", ""))
        finally:
            self.assertEqual(window.close(), 0)

    def test_a_plot_by_its_bare_name_is_printed(self):
        folder = WORK / "bare name"
        folder.mkdir()
        plot(folder / "tour.mvr")
        window = Window("--size", "900x600", "--no-desk", "--quiet", show="tour.mvr", folder=folder)
        try:
            window.do("wait opened", "paperwork", "cue-book", 'export-paper paper "--language" de', "wait jobs", "screenshot dialogs.png")
            self.assertIn("Geräteliste", (folder / "paper/index.html").read_text(encoding="utf-8"))
            self.assertEqual(window.state()["show"], "./tour.mvr")
        finally:
            self.assertEqual(window.close(), 0)

    def test_hands_and_cues(self):
        show = WORK / "cues"
        shutil.copytree(WORK / "demo", show)
        window = Window("--size", "720x480", "--no-desk", "--quiet", show=show)
        try:
            window.do("wait opened", "resolution 12", "jump 36", "wait 0.2", "freeze on", "camera close", "wait settled")
            window.do("select *", "intensity 1", "colour #ff0000", "gobo 0", "look-store Red", "colour #0000ff", "look-store Blue")
            window.do("cue-add First Red", "cue-add Second Blue", "cue-set First fade 0", "cue-set Second fade 0", "cue-go")
            red = window.picture("first")
            self.assertEqual(window.state()["cue"], "First")
            window.do("cue-go")
            blue = window.picture("second")
            self.assertGreater(changed(red, blue), 5)
            self.assertIn("this was the last cue", window.ask("cue-go"))
            window.do("cue-back")
            self.assertLess(changed(window.picture("back"), red), 0.5)
            window.do("save")
            self.assertIn('look = "Blue"', (show / "show.toml").read_text())
            # An iris by hand is seen, and kept in a look.
            window.do("select *", "look-recall Red 0")
            whole = window.picture("whole")
            window.do("parameter Iris 0", "look-store Narrow")
            narrow = window.picture("narrow")
            self.assertLess(narrow[..., 0].mean(), whole[..., 0].mean() - 1)
            self.assertIn("channels = {", (show / "looks.toml").read_text())
            window.do("parameter Iris off")
            self.assertLess(changed(window.picture("wide again"), whole), 0.5)
            self.assertIn("did you mean 'Iris'", window.ask("parameter Iriss 1"))
            window.do("release-all", "panel-cues on")
            window.shoot("cues.png")
        finally:
            self.assertEqual(window.close(), 0)


if __name__ == "__main__":
    sys.exit(main(sys.modules[__name__]))

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The first picture of a plot, on a screen of its own: heads that shine by their files alone (tubes that are bright until a desk is heard)
burn nothing out in the work light; a camera that sees nothing of the stage says so. Usage: first_picture_test.py SOURCE_FOLDER BUILD_FOLDER."""
import pathlib
import sys
import unittest
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "lib"))
from window import Window, main  # noqa: E402

WORK = None
TUBES = 24
# A tube of one cell, full without a desk, with no dimmer that is closed at home.
TUBE = """<?xml version="1.0" encoding="UTF-8"?><GDTF DataVersion="1.2"><FixtureType Name="Tube" ShortName="Tube" LongName="Tube"
 Manufacturer="Nobody" Description="" FixtureTypeID="AAAAAAAA-0000-4000-8000-000000000002" Thumbnail="">
<AttributeDefinitions><ActivationGroups/><FeatureGroups><FeatureGroup Name="Dimmer" Pretty="Dimmer"><Feature Name="Dimmer"/></FeatureGroup>
</FeatureGroups><Attributes><Attribute Name="Dimmer" Pretty="Dim" Feature="Dimmer.Dimmer"/></Attributes></AttributeDefinitions><Wheels/>
<Models/><Geometries><Geometry Name="Body" Model=""><Beam Name="Cell" Model="" LampType="LED" LuminousFlux="20000" BeamAngle="120"
 FieldAngle="150" BeamRadius="0.05" BeamType="Wash" Position="{1,0,0,0}{0,1,0,0}{0,0,1,0}{0,0,0,1}"/></Geometry></Geometries><DMXModes>
<DMXMode Name="Standard" Geometry="Body"><DMXChannels><DMXChannel DMXBreak="1" Offset="1" Geometry="Cell" Default="255/1">
<LogicalChannel Attribute="Dimmer"><ChannelFunction Name="Dimmer" Attribute="Dimmer" DMXFrom="0/1" Default="255/1"/></LogicalChannel>
</DMXChannel></DMXChannels></DMXMode></DMXModes></FixtureType></GDTF>"""


def plot(path):
    heads = "".join(f"""<Fixture name="Tube {i + 1}" uuid="333333{i:02d}-2222-4222-8222-222222222222">
<Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{400 * i - 4800},1000,5000}}</Matrix><GDTFSpec>Nobody@Tube.gdtf</GDTFSpec><GDTFMode>Standard</GDTFMode>
<Addresses><Address break="0">{1 + i}</Address></Addresses></Fixture>""" for i in range(TUBES))
    tube = path.parent / "tube.gdtf"
    with zipfile.ZipFile(tube, "w") as archive:
        archive.writestr("description.xml", TUBE)
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("GeneralSceneDescription.xml", f"""<?xml version="1.0" encoding="UTF-8"?>
<GeneralSceneDescription verMajor="1" verMinor="6" provider="test" providerVersion="1"><Scene><Layers>
<Layer name="Rig" uuid="11111111-1111-4111-8111-111111111111"><ChildList>{heads}</ChildList></Layer></Layers></Scene>
</GeneralSceneDescription>""")
        archive.write(tube, "Nobody@Tube.gdtf")


def burnt(picture):
    """The share of it that is as good as white."""
    return float((picture.min(axis=2) > 225).mean())


class FirstPicture(unittest.TestCase):
    def test_heads_that_nobody_asks(self):
        plot(WORK / "tubes.mvr")
        window = Window("--size", "700x480", "--no-desk", "--quiet", show=WORK / "tubes.mvr")
        try:
            window.do("wait opened", "resolution 25")
            window.until_picture()
            chips = window.state()["chips"]
            self.assertFalse([chip for chip in chips if "no shadows" in chip], "those that are dark need none")
            first = window.picture("first")
            self.assertTrue(window.state()["picture"]["work_light"])
            self.assertLess(burnt(first), 0.002)
            self.assertIn(f"{TUBES} heads that nobody asks left dark", window.state()["chips"])
            window.do('select "Tube 12"')
            window.until(lambda state: state["explained"].get("why", "").startswith("dark because nobody asks for it"))
            # A hand asks; and without the work light it is as the files have it.
            window.do("intensity 1")
            lit = window.picture("lit")
            self.assertGreater(lit.max(), 240)
            self.assertIn(f"{TUBES - 1} heads that nobody asks left dark", window.state()["chips"])
            window.until(lambda state: state["explained"].get("why", "").startswith("lit"))
            window.do("release-all", "work-light off")
            self.assertGreater(window.picture("alone").max(), 240)
            self.assertFalse([chip for chip in window.state()["chips"] if "nobody asks" in chip])
        finally:
            self.assertEqual(window.close(), 0)

    def test_a_camera_that_sees_nothing(self):
        window = Window("--size", "700x480", "--no-desk", "--quiet", show=WORK / "demo")
        try:
            window.do("wait opened", "resolution 12", "freeze on")
            window.until_picture()
            window.do("look 0 -60 20 0 -200 60")
            window.until(lambda state: "sees nothing of the stage" in state["notice"])
            window.do("see-all")
            window.until(lambda state: state["notice"] == "")
            # That it is dark is no reason.
            window.do("black-out on", "camera 1", "wait 2")
            self.assertEqual(window.state()["notice"], "")
        finally:
            self.assertEqual(window.close(), 0)


if __name__ == "__main__":
    sys.exit(main(sys.modules[__name__]))

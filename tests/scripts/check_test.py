#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`ghostlight check` as a user sees it: whole folders, the summary, JSON, --strict, and the same output with one thread and with
many. Usage: check_test.py SOURCE_FOLDER BUILD_FOLDER."""
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
SHARED = SOURCE.parent / "shared" / "fixtures"
WORK = None
SEVERITIES = {"note", "warning", "error"}
KEYS = {"severity", "kind", "where", "file", "line", "element", "what", "do", "times"}


def run(*arguments):
    done = subprocess.run([str(PROGRAM), "check", *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          timeout=600)
    done.text = done.stdout + done.stderr
    return done


def gdtf(path, beam='<Beam Name="Beam" BeamAngle="20" FieldAngle="25"/>', wheels="", models=""):
    xml = f"""<?xml version="1.0"?>
<GDTF DataVersion="1.2"><FixtureType Name="{path.stem}" Manufacturer="Test">
<Wheels>{wheels}</Wheels><Models>{models}</Models>
<Geometries><Geometry Name="Base">{beam}</Geometry></Geometries>
<DMXModes><DMXMode Name="M" Geometry="Base"><DMXChannels>
<DMXChannel Offset="1" Geometry="Beam"><LogicalChannel Attribute="Dimmer"><ChannelFunction Name="D" Attribute="Dimmer"/>
</LogicalChannel></DMXChannel></DMXChannels></DMXMode></DMXModes></FixtureType></GDTF>"""
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("description.xml", xml)
    return path


def mvr(path, fixtures):
    rows = "\n".join(
        f'<Fixture uuid="8BF13DD7-CBF4-415B-99E4-{k:012d}" name="Lamp {k}"><GDTFSpec>{spec}</GDTFSpec><GDTFMode>M</GDTFMode>'
        f'<Addresses><Address break="0">{address}</Address></Addresses></Fixture>' for k, (spec, address) in enumerate(fixtures, 1))
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("GeneralSceneDescription.xml", '<GeneralSceneDescription verMajor="1" verMinor="6"><Scene><Layers>'
                         f'<Layer name="L" uuid="1"><ChildList>\n{rows}\n</ChildList></Layer></Layers></Scene></GeneralSceneDescription>')
    return path


class Check(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """A folder with a sound file, one that is repaired, three with losses, and what is none of our business."""
        cls.folder = WORK / "rig"
        (cls.folder / "deep" / "er").mkdir(parents=True)
        (cls.folder / ".hidden").mkdir()
        gdtf(cls.folder / "sound.gdtf")
        gdtf(cls.folder / "deep" / "guessed.gdtf", beam='<Beam Name="Beam" BeamAngle="0" FieldAngle="0"/>')
        slots = "".join(f'<Slot Name="s{k}" MediaFileName="gone{k}"/>\n' for k in range(50))
        gdtf(cls.folder / "deep" / "er" / "pictures.gdtf", wheels=f'<Wheel Name="Gobo">{slots}</Wheel>')
        (cls.folder / "deep" / "broken.gdtf").write_text("no zip")
        mvr(cls.folder / "plot.mvr", [("Test@sound.gdtf", "1"), ("Nothing@Like it.gdtf", "2")])
        (cls.folder / "settings.json").write_text('{"colour": "dark"}')
        (cls.folder / ".hidden" / "x.gdtf").write_text("not looked at")
        (cls.folder / "readme.txt").write_text("no")
        (cls.folder / "loop").symlink_to(cls.folder)

    def test_meshes_of_a_fixture_file_are_read(self):
        """Chunks that are whole, but hold an object without one triangle: only drawing it tells."""
        def chunk(number, inside):
            return struct.pack("<HI", number, len(inside) + 6) + inside
        alone = WORK / "meshes"
        alone.mkdir()
        lamp = gdtf(alone / "lamp.gdtf", beam='<Beam Name="Beam" Model="Body" BeamAngle="20" FieldAngle="25"/>',
                    models='<Model Name="Body" Length="1" Width="1" Height="1" File="body"/>')
        points = chunk(0x4110, struct.pack("<H9f", 3, 0, 0, 0, 1, 0, 0, 0, 1, 0))
        with zipfile.ZipFile(lamp, "a") as archive:
            archive.writestr("models/3ds/body.3ds", chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, b"Body\0" + chunk(0x4100, points)))))
        done = run(lamp, "--json")
        self.assertEqual(done.returncode, 1, done.text)
        kinds = {message["kind"]: message["where"] for message in json.loads(done.stdout)[0]["messages"]}
        self.assertIn("lamp.gdtf: models/3ds/body.3ds", kinds.get("missing_media", ""), kinds)

    def test_a_folder_is_searched_and_nothing_stops_at_the_first_fault(self):
        done = run(self.folder)
        self.assertEqual(done.returncode, 1, done.text)
        for word in ("sound.gdtf: ok", "taking 25 degrees", "wheels/gone0.png is not in the archive", "broken.gdtf",
                     "'Nothing@Like it.gdtf' is not in the archive", "5 files: 1 ok, 1 repaired, 3 with losses"):
            self.assertIn(word, done.stdout)
        self.assertIn("GeneralSceneDescription.xml:3", done.stdout)
        self.assertIn("1 .json files are no fixtures", done.stderr)
        self.assertNotIn(".hidden", done.text)

    def test_fifty_equal_faults_are_one_line_and_all_of_them_on_request(self):
        name = self.folder / "deep" / "er" / "pictures.gdtf"
        done = run(name)
        lines = [line for line in done.stdout.splitlines() if "is not in the archive" in line]
        self.assertEqual(len(lines), 1, done.stdout)
        self.assertIn("and 49 more like it", lines[0])
        self.assertIn("description.xml:3", lines[0])
        done = run(name, "--all")
        self.assertEqual(sum("is not in the archive" in line for line in done.stdout.splitlines()), 50)

    def test_films_and_pictures_are_opened(self):
        show = WORK / "media"
        show.mkdir()
        (show / "empty.mp4").write_bytes(b"")
        (show / "text.mov").write_text("no film")
        (show / "noise.png").write_bytes(bytes(range(256)) * 8)
        names = ("empty.mp4", "text.mov", "noise.png", "gone.mp4")
        (show / "show.toml").write_text(
            f'[show]\nname = "Media"\nstage = "{SOURCE / "assets" / "optics" / "stage.glb"}"\n'
            '[[camera]]\nname = "front"\nposition_m = [0, -6, 2]\ntarget_m = [0, 5, 2]\n'
            + "".join(f'[[media]]\nname = "{name}"\nfile = "{name}"\n' for name in names)
            + '[[fixture]]\nname = "Wall"\nposition_m = [0, 0, 2]\nwall = { media = "gone.mp4", size_m = [4, 2] }\n')
        done = run(show)
        for name in names[:3]:
            self.assertRegex(done.stdout, rf"error: .*show.toml:\d+: \[\[media\]\] '{name}': .*{name}.*striped card", done.stdout)
        self.assertEqual(done.stdout.count("gone.mp4'"), 1, done.stdout) # said once
        self.assertNotIn("no address", done.stdout) # our own walls shine without a desk
        self.assertEqual(done.returncode, 1)

    def test_a_substitute_comes_from_the_same_folder(self):
        done = run(self.folder)
        self.assertRegex(done.stdout, r"Test@sound.gdtf' is not in the archive.*\n    do: '.*sound.gdtf' seems to be this fixture")

    def test_a_substitute_comes_from_a_folder_that_is_named(self):
        alone = WORK / "alone"
        alone.mkdir()
        plot = mvr(alone / "plot.mvr", [("Test@Wonder Wash 7.gdtf", "1")])
        library = WORK / "library"
        (library / "Test").mkdir(parents=True)
        gdtf(library / "Test" / "Test-Wonder-Wash-7.gdtf")
        self.assertNotIn("Test-Wonder-Wash-7", run(plot).stdout)
        self.assertIn("Test-Wonder-Wash-7.gdtf' seems to be this fixture", run("--fixtures", library, plot).stdout)

    def test_json(self):
        done = run(self.folder, "--json")
        files = json.loads(done.stdout)
        self.assertEqual([pathlib.Path(entry["file"]).name for entry in files],
                         ["broken.gdtf", "pictures.gdtf", "guessed.gdtf", "plot.mvr", "sound.gdtf"])
        self.assertEqual([entry["state"] for entry in files], ["lost", "lost", "repaired", "lost", "ok"])
        for entry in files:
            self.assertEqual(set(entry), {"file", "state", "lost", "readable", "counts", "facts", "messages"})
            self.assertEqual(set(entry["counts"]), SEVERITIES)
            for message in entry["messages"]:
                self.assertEqual(set(message), KEYS)
                self.assertIn(message["severity"], SEVERITIES)
        self.assertEqual(len([m for m in files[1]["messages"] if m["kind"] == "missing_media"]), 50)
        lost, = [m for m in files[3]["messages"] if "Nothing@Like" in m["what"]]
        self.assertEqual((lost["kind"], lost["line"], lost["severity"]), ("missing_fixture_file", 3, "error"))
        self.assertTrue(lost["element"].endswith("Fixture 'Lamp 2'"), lost)

    def test_one_thread_and_many_say_the_same(self):
        one = run(self.folder, "--threads", 1)
        for _ in range(3):
            self.assertEqual(run(self.folder, "--threads", 8).stdout, one.stdout)

    def test_exit_codes(self):
        self.assertEqual(run(self.folder / "sound.gdtf").returncode, 0)
        self.assertEqual(run(self.folder / "sound.gdtf", "--strict").returncode, 0)
        self.assertEqual(run(self.folder / "deep" / "guessed.gdtf").returncode, 0)
        self.assertEqual(run(self.folder / "deep" / "guessed.gdtf", "--strict").returncode, 1)
        self.assertEqual(run(self.folder / "deep" / "er").returncode, 1)
        self.assertEqual(run().returncode, 2)
        empty = WORK / "empty"
        empty.mkdir()
        done = run(empty)
        self.assertEqual(done.returncode, 1)
        self.assertIn("nothing to check", done.stderr)

    def test_the_summary_fits_a_screen(self):
        many = WORK / "many"
        many.mkdir()
        for k in range(40):
            shutil.copy(self.folder / "deep" / "guessed.gdtf", many / f"a fixture with quite a long name, and another word {k:02d}.gdtf")
        done = run(many, "--summary")
        self.fits(done.stdout)
        self.assertIn("... and 28 more (--all)", done.stdout)
        self.assertNotIn("more (--all)", run(many, "--summary", "--all").stdout)

    def test_what_cannot_be_read_comes_first(self):
        """One message of a file that is cut short weighs more than five of one that opens."""
        folder = WORK / "unreadable"
        folder.mkdir()
        gdtf(folder / "a_lossy.gdtf", models="".join(f'<Model Name="M{k}" File="gone{k}"/>' for k in range(5)))
        (folder / "z_cut.gdtf").write_bytes((folder / "a_lossy.gdtf").read_bytes()[:200])
        done = run(folder, "--summary")
        lines = [line for line in done.stdout.splitlines() if ".gdtf" in line]
        self.assertRegex(lines[0], r"^z_cut.gdtf +cannot be read at all$")
        self.assertIn("(1 cannot be read at all)", done.stdout)
        entries = {pathlib.Path(e["file"]).name: e for e in json.loads(run(folder, "--json").stdout)}
        self.assertEqual([entries[name]["readable"] for name in ("a_lossy.gdtf", "z_cut.gdtf")], [True, False])
        self.assertIn("cut short", entries["z_cut.gdtf"]["messages"][0]["what"])

    def test_optics_that_cannot_be(self):
        """Values that are numbers, but of no lens and no lamp."""
        file = WORK / "odd_optics.gdtf"
        gdtf(file, beam='<Beam Name="Beam" BeamAngle="nan" FieldAngle="200" BeamRadius="0" LuminousFlux="0"/>')
        with zipfile.ZipFile(file) as archive:
            xml = archive.read("description.xml").decode()
        zoom = ('<DMXChannel Offset="2" Geometry="Beam"><LogicalChannel Attribute="Zoom"><ChannelFunction Name="Z" Attribute="Zoom" '
                'PhysicalFrom="0" PhysicalTo="180"/></LogicalChannel></DMXChannel></DMXChannels>')
        with zipfile.ZipFile(file, "w") as archive:
            archive.writestr("description.xml", xml.replace("</DMXChannels>", zoom))
        text = run(file).stdout
        for words in ("BeamAngle is 'nan'", "BeamRadius is 0", "LuminousFlux is 0", "drawn with so many", "Zoom goes from 0 to 180 degrees"):
            self.assertIn(words, text)

    def fits(self, text):
        lines = text.splitlines()
        self.assertLessEqual(len(lines), 23, text)
        self.assertLess(max(map(len, lines)), 80, text)

    def test_all_real_files(self):
        if not SHARED.exists():
            self.skipTest("no ../shared/fixtures beside the checkout")
        start = time.monotonic()
        done = run(SHARED / "gdtf", SHARED / "mvr", "--json")
        print(f"\nreal files: {time.monotonic() - start:.1f} s", file=sys.stderr)
        self.assertEqual(done.returncode, 1)
        files = {pathlib.Path(entry["file"]).name: entry for entry in json.loads(done.stdout)}
        self.assertEqual(sum(name.endswith(".gdtf") for name in files), 77)
        self.assertEqual(sum(name.endswith(".mvr") for name in files), 10)
        summary = run(SHARED / "gdtf", SHARED / "mvr", "--summary", "--threads", 1).stdout
        self.assertEqual(summary, run(SHARED / "gdtf", SHARED / "mvr", "--summary").stdout)
        self.fits(summary)
        # A plot without any fixture file: those of the folder beside it stand in, in the mode that its patch shows.
        advice = {m["what"].split("'")[1]: m["do"] for m in files["bauke_sample_show.mvr"]["messages"]
                  if m["kind"] == "missing_fixture_file" and "GDTFSpec" not in m["what"]}
        self.assertRegex(advice["Robe Lighting@Robin Spiider.gdtf"], "Robin_Spiider.*27 channels that the patch leaves")
        self.assertRegex(advice["Martin Professional@MAC Viper AirFX.gdtf"], "MAC_Viper_AirFX.*20 channels that the patch leaves")


if __name__ == "__main__":
    if not PROGRAM.exists():
        print(f"{PROGRAM} is not built")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        WORK = pathlib.Path(folder)
        sys.exit(not unittest.main(argv=sys.argv[:1], exit=False).result.wasSuccessful())

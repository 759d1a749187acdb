#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A designer's plot as a user meets it: check, import, the next version, light_all, explain and render of an .mvr made here.
Usage: plot_test.py SOURCE_FOLDER BUILD_FOLDER."""
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest
import zipfile

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
SPOT = "Vari-Lite@VL2500_Spot.gdtf"
UUID = "8BF13DD7-CBF4-415B-99E4-625FE41000{:02}"


def run(*arguments, program=PROGRAM):
    done = subprocess.run([str(program), *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=300)
    done.text = done.stdout + done.stderr
    return done


def fixture(number, x_mm, address, spec=SPOT):
    return (
        f'<Fixture uuid="{UUID.format(number)}" name="Spot"><Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{x_mm},2000,6000}}</Matrix>'
        f"<GDTFSpec>{spec}</GDTFSpec><GDTFMode>Standard 22 channels</GDTFMode><FixtureID>{number}</FixtureID>"
        f'<Addresses><Address break="0">{address}</Address></Addresses></Fixture>'
    )


def write_mvr(path, *fixtures):
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(
            "GeneralSceneDescription.xml",
            '<?xml version="1.0"?><GeneralSceneDescription verMajor="1" verMinor="6"><Scene><Layers><Layer name="L" uuid="1"><ChildList>'
            + "".join(fixtures)
            + "</ChildList></Layer></Layers></Scene></GeneralSceneDescription>",
        )
        archive.write(SOURCE / "assets/fixtures" / SPOT, SPOT)


class Plot(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory(prefix="ghost_plot_")
        self.addCleanup(self.scratch.cleanup)
        self.folder = pathlib.Path(self.scratch.name)
        self.plot = self.folder / "tour.mvr"
        write_mvr(self.plot, fixture(1, 0, 1), fixture(2, 1500, 523))

    def test_check_says_what_is_lost_and_where(self):
        good = run("check", self.plot, "--json")
        self.assertEqual(good.returncode, 0, good.text)
        facts = json.loads(good.stdout)[0]["facts"]
        self.assertEqual((facts["fixtures"], facts["dark_fixtures"], facts["cameras"]), (2, 0, 3))
        write_mvr(self.plot, fixture(1, 0, 1), fixture(2, 1500, 523, "Nobody@Nothing.gdtf"))
        bad = run("check", self.plot)
        self.assertEqual(bad.returncode, 1)
        self.assertRegex(bad.stdout, r"error: tour\.mvr: GeneralSceneDescription\.xml:1: .*'Nobody@Nothing\.gdtf' is not in the archive")

    def test_import_and_the_next_version(self):
        show = self.folder / "show"
        first = run("import", self.plot, "-o", show, "--json")
        self.assertEqual(first.returncode, 0, first.text)
        made = json.loads(first.stdout)
        self.assertEqual((made["fixtures"], made["cameras"]), (2, 3))
        self.assertNotIn("merge", made)
        with open(show / "show.toml", "a", encoding="utf-8") as file:
            file.write(f'\n[[change]]\nuuid = "{UUID.format(1)}"\nuniverse = 7\naddress = 100\n')
        mine = (show / "show.toml").read_bytes()
        newer = self.folder / "tour v2.mvr"
        write_mvr(newer, fixture(1, 250, 1), fixture(3, 0, 60))
        second = run("import", newer, "-o", show)
        self.assertEqual(second.returncode, 0, second.text)
        self.assertIn("1 added", second.stdout)
        self.assertIn("1 removed", second.stdout)
        self.assertEqual((show / "show.toml").read_bytes(), mine)
        self.assertEqual((show / "tour.mvr").read_bytes(), newer.read_bytes())
        third = json.loads(run("import", self.plot, "-o", show, "--json").stdout)
        self.assertEqual([entry["uuid"] for entry in third["merge"]["kept"]], [UUID.format(1)])
        self.assertEqual([entry["uuid"] for entry in third["merge"]["removed"]], [UUID.format(3)])

    def test_a_look_without_a_desk(self):
        look = self.folder / "all.show"
        lit = run(self.plot, "-o", look, program=SOURCE / "tools/light_all.py")
        self.assertEqual(lit.returncode, 0, lit.text)
        self.assertIn("2 fixtures lit", lit.stdout)
        explained = run("explain", self.plot, "--all", "--replay", look, "--at", 1)
        self.assertEqual(explained.returncode, 0, explained.text)
        self.assertIn("all 2 lit", explained.stdout)
        self.assertIn("Spot #2: lit", explained.stdout)
        picture = self.folder / "tour.png"
        drawn = run("render", self.plot, "-o", picture, "--live", "--size", "160x90", "--replay", look, "--at", 1)
        self.assertEqual(drawn.returncode, 0, drawn.text)
        self.assertGreater(picture.stat().st_size, 2000)
        self.assertTrue((self.folder / ".ghost" / "tour.mvr" / "distances").is_dir())

    def test_light_all_counts_what_stays_dark(self):
        """A fixture without an address, and one whose file has no channel of light, are not called lit."""
        plot = self.folder / "unpatched.mvr"
        write_mvr(plot, fixture(1, 0, 1), fixture(2, 1500, 0))
        lit = run(plot, "-o", self.folder / "some.show", program=SOURCE / "tools/light_all.py")
        self.assertIn("1 fixtures lit, 1 dark (no address)", lit.stdout)
        left = run(self.plot, "-o", self.folder / "none.show", "--without", "*", program=SOURCE / "tools/light_all.py")
        self.assertEqual(left.returncode, 1, left.text)
        self.assertIn("0 fixtures lit, 2 dark (left out by --without)", left.stdout)

    def test_export_writes_the_changes_of_a_show(self):
        show = self.folder / "exported"
        self.assertEqual(run("import", self.plot, "-o", show).returncode, 0)
        with open(show / "show.toml", "a") as file:
            file.write('[[change]]\nuuid = "%s"\nuniverse = 7\naddress = 77\n' % UUID.format(1))
        out = self.folder / "for_the_designer.mvr"
        done = run("export", show, "-o", out)
        self.assertEqual(done.returncode, 0, done.text)
        self.assertIn("1 changes of the show", done.stdout)
        with zipfile.ZipFile(out) as archive:
            self.assertRegex(archive.read("GeneralSceneDescription.xml").decode(), r">(7\.77|3149)</Address>")

    def test_no_plot(self):
        (self.folder / "broken.mvr").write_bytes(b"PK\x03\x04 and nothing more")
        for name in ("broken.mvr", "absent.mvr"):
            for command in (["check"], ["import", "-o", self.folder / "x"], ["bake"]):
                done = run(command[0], self.folder / name, *command[1:])
                self.assertEqual(done.returncode, 1, done.text)
                self.assertIn(name, done.text)
                self.assertNotEqual(-done.returncode, signal.SIGSEGV)
                if name == "broken.mvr":
                    self.assertIn("cut short", done.text)
        self.assertFalse((self.folder / "x" / "show.toml").exists())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]], verbosity=2)

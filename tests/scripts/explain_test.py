#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`ghostlight explain` as a user sees it: verdicts of the demo against what is known of it, live input played to this machine,
and what bad input gets. Usage: explain_test.py SOURCE_FOLDER BUILD_FOLDER."""
import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
WORK = None
LAMP = """
[[fixture]]
name = "{name}"
gdtf = "{gdtf}"
universe = {universe}
address = {address}
position_m = [0, 4, 6]
"""


def run(*arguments):
    done = subprocess.run([str(PROGRAM), *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=300)
    done.text = done.stdout + done.stderr
    return done


def levels(values):
    """512 levels, {address: value}."""
    row = [0] * 512
    for address, value in values.items():
        row[address - 1] = value
    return ",".join(map(str, row))


OPEN = {1: 255, 2: 128, 4: 128, 12: 255, 17: 255}  # a VL2500 Spot at address 1: full, straight down, wide, iris open


def write_show(name, fixtures, frames, recording=True):
    """Folder of a show without a stage; frames: [(universe, {address: value}), ...], half a second each."""
    folder = WORK / name
    folder.mkdir()
    text = '[show]\nname = "%s"\n' % name + ('recording = "a.show"\n' if recording else "")
    text += '[[camera]]\nposition_m = [0, -12, 3]\ntarget_m = [0, 2, 2]\n'
    (folder / "show.toml").write_text(text + "".join(LAMP.format(**fixture) for fixture in fixtures))
    if frames is not None:
        (folder / "a.show").write_text("OLA Show\n" + "".join("%d %s\n500\n" % (u, levels(v)) for u, v in frames))
    return folder


def spot(name="Spot", universe=1, address=1, gdtf=None):
    return {"name": name, "universe": universe, "address": address,
            "gdtf": gdtf or SOURCE / "assets" / "fixtures" / "Vari-Lite@VL2500_Spot.gdtf"}


class Case(unittest.TestCase):
    def fails(self, done, code, *parts):
        self.assertEqual(done.returncode, code, done.text)
        for part in parts:
            self.assertIn(part, done.text)

    def explained(self, *arguments):
        done = run("explain", *arguments)
        self.assertEqual(done.returncode, 0, done.text)
        return done.stdout

    def facts(self, *arguments):
        return json.loads(self.explained(*arguments, "--json", "--quiet"))


class Demo(Case):
    def test_every_fixture_of_the_demo(self):
        facts = self.facts(SOURCE / "assets" / "demo", "--all", "--at", "36")
        self.assertEqual(len(facts["fixtures"]), 10)
        self.assertEqual(sum(facts["counts"].values()), 10)
        self.assertGreater(facts["counts"]["lit"], 0)
        for fixture in facts["fixtures"]:
            beam = fixture["beams"][0]
            self.assertEqual(fixture["universes"][0]["received"], True)
            self.assertTrue(all(0 <= share <= 1.01 for share in beam["shares"].values()), beam["shares"])
            self.assertAlmostEqual(beam["full_lm"], 10000, delta=60)
            if fixture["state"] == "lit":
                self.assertGreater(beam["output_lm"], 0.02 * beam["full_lm"])
                self.assertIsNotNone(beam["hit"] or beam["edge_object"])

    def test_a_wash_points_at_what_the_programmer_aimed_at(self):
        """tools/demo_show aims in metres; where explain says the beam goes must lie on the line from lamp to hit."""
        facts = self.facts(SOURCE / "assets" / "demo", "Wash 2", "--at", "36")
        beam = facts["beams"][0]
        hit, lens, way = beam["hit"], beam["lens_m"], beam["direction"]
        for k in range(3):
            self.assertAlmostEqual(hit["position_m"][k], lens[k] + way[k] * hit["distance_m"], places=2)
        self.assertGreater(len(hit["object"]), 0)

    def test_words(self):
        words = self.explained(SOURCE / "assets" / "demo", "Spot 3", "--at", "36", "--quiet")
        self.assertTrue(words.startswith("Spot 3: "), words)
        for part in ("recording", "at 36 s", "universe  1: received", "1.045 to 1.066, 22 channels", "Shutter1", "x shutter", "points", "hits"):
            self.assertIn(part, words)


class Verdicts(Case):
    def test_closed_shutter_with_channel_function_and_range(self):
        show = write_show("closed", [spot(address=1)], [(1, {**OPEN, 11: 4})])
        words = self.explained(show, "Spot", "--quiet")
        self.assertTrue(words.startswith("Spot: dark because the shutter function 'Closed' (DMX 3-5) is active on channel 11 (1.011), value 4\n"), words)

    def test_stage_of_a_model_file(self):
        """A floor in an OBJ file, 4 m below the lamp: name, distance and lux as the model and photometry have them."""
        show = write_show("floor", [spot()], [(1, OPEN)])
        (show / "floor.obj").write_text("o floor\nv -9 0 9\nv 9 0 9\nv 9 0 -9\nv -9 0 -9\nvn 0 1 0\nf 1//1 2//1 3//1 4//1\n")
        toml = show / "show.toml"
        toml.write_text(toml.read_text().replace("[show]\n", '[show]\nstage = "floor.obj"\n'))
        facts = self.facts(show, "Spot")
        hit = facts["beams"][0]["hit"]
        self.assertEqual(facts["state"], "lit")
        self.assertIn("floor", hit["object"])
        self.assertAlmostEqual(hit["position_m"][2], 0, places=3)
        self.assertAlmostEqual(hit["facing_lx"], hit["illuminance_lx"], delta=1)
        # 32969 cd in the middle at this zoom (worked out apart from this code), from the pivot of the head.
        pivot_m = (32969.4 * 0.994273 / hit["facing_lx"]) ** 0.5
        self.assertTrue(hit["distance_m"] < pivot_m < hit["distance_m"] + 0.5, (pivot_m, hit))

    def test_time_matters(self):
        show = write_show("later", [spot(), spot("Late", 2)], [(1, {}), (1, OPEN), (2, OPEN)])
        self.assertEqual(self.facts(show, "Spot", "--at", "0")["cause"], "dimmer")
        self.assertEqual(self.facts(show, "Spot", "--at", "0.6")["state"], "lit")
        late = self.facts(show, "Late", "--at", "0.6")
        self.assertEqual(late["cause"], "never_received")
        self.assertIn("universe 2 begins in the recording at 1 s", late["verdict"])
        self.assertEqual(self.facts(show, "Late", "--at", "1.2")["state"], "lit")

    def test_summary(self):
        show = write_show("many", [spot("A"), spot("B", 1, 23), spot("C", 3), spot("D", 3, 23)], [(1, OPEN)])
        out = self.explained(show, "--all", "--quiet")
        self.assertEqual(out.splitlines()[-1], "3 of 4 dark: 2 because their universe 3 never arrived, 1 because their dimmer is at 0")
        self.assertEqual(len(out.splitlines()), 5)

    def test_no_dmx(self):
        show = write_show("nothing", [spot()], None, recording=False)
        self.assertIn("there is no DMX: the show has no recording", self.explained(show, "Spot"))
        lost = write_show("lost", [spot()], None)
        words = self.explained(lost, "Spot")
        self.assertIn("a.show is missing", words)

    def test_missing_fixture_file_and_mode(self):
        show = write_show("no_file", [spot(gdtf="Vari-Lte.gdtf")], [(1, OPEN)])
        (show / "Vari-Lite.gdtf").write_bytes(b"")
        verdict = self.facts(show, "Spot")["verdict"]
        self.assertIn("its fixture file Vari-Lte.gdtf is missing or cannot be read", verdict)
        self.assertIn("did you mean 'Vari-Lite.gdtf'", verdict)
        show = write_show("no_mode", [spot()], [(1, {})])
        toml = show / "show.toml"
        toml.write_text(toml.read_text() + 'mode = "Standard 23 channels"\n')
        facts = self.facts(show, "Spot")
        self.assertEqual(facts["cause"], "no_mode")
        self.assertIn("Standard 23 channels", facts["verdict"])


class Live(Case):
    def play(self, show, *more):
        return subprocess.Popen([str(PROGRAM), "play", str(show / "a.show"), "--to", "127.0.0.1", "--loop", *map(str, more)],
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def listen(self, show, *more):
        return self.facts(show, "Spot", "--live-input", "--interface", "127.0.0.1", "--universes", "1-3", "--protocols", "sacn",
                          "--for", "2", *more)

    def test_sender_priority_and_override(self):
        show = write_show("live", [spot()], [(1, OPEN)])
        off = write_show("live_off", [spot()], [(1, {**OPEN, 1: 0})])
        players = [self.play(show, "--priority", "90")]
        try:
            time.sleep(0.5)
            facts = self.listen(show)
            if facts["input"]["packets"] == 0:
                self.skipTest("no packet of our own reaches this machine's port 5568")
            self.assertEqual(facts["state"], "lit", facts["verdict"])
            sender = facts["universes"][0]["senders"][0]
            self.assertEqual((sender["protocol"], sender["priority"], sender["from"]), ("sACN", 90, "127.0.0.1"))
            self.assertEqual(sender["channels_held"], 22)
            self.assertEqual(facts["universes"][0]["age_s"] < 2.5, True)
            players.append(self.play(off, "--priority", "120"))
            time.sleep(0.5)
            facts = self.listen(show)
            self.assertEqual(facts["cause"], "overridden", facts["verdict"])
            self.assertIn("priority 120) overrides", facts["verdict"])
            self.assertIn("on channel 1 (1.001) it sends 0 instead of 255", facts["verdict"])
        finally:
            for player in players:
                player.terminate()
                player.wait()
        facts = self.listen(write_show("other", [spot(universe=2)], None, recording=False))
        self.assertEqual(facts["cause"], "never_received", facts["verdict"])


class BadInput(Case):
    def setUp(self):
        self.demo = SOURCE / "assets" / "demo"

    def test_usage(self):
        self.fails(run("explain"), 2, "SHOW")
        self.fails(run("explain", self.demo), 2, "--all")
        self.fails(run("explain", self.demo, "Spot 1", "--all"), 2, "not both")
        for value in ("nan", "inf", "-1", "soon"):
            self.fails(run("explain", self.demo, "Spot 1", "--at", value), 2, "--at")
            self.fails(run("explain", self.demo, "Spot 1", "--live-input", "--for", value), 2, "--for")
        self.fails(run("explain", self.demo, "Spot 1", "--for", "3"), 2, "--live-input")
        self.fails(run("explain", self.demo, "Spot 1", "--live-input", "--at", "3"), 2, "--at")
        self.fails(run("explain", self.demo, "Spot 1", "--live-input", "--universes", "5-1"), 2, "5-1")

    def test_unknown_fixture_is_suggested(self):
        self.fails(run("explain", self.demo, "Spto 3"), 1, "has no fixture 'Spto 3', did you mean 'Spot", "'Wash 5'")

    def test_bad_show(self):
        self.fails(run("explain", WORK / "nowhere", "Spot 1"), 1, "nowhere")
        folder = WORK / "no_toml"
        folder.mkdir()
        (folder / "show.toml").write_text("[show\n")
        self.fails(run("explain", folder, "Spot 1"), 1, "show.toml:1")

    def test_no_such_time(self):
        self.fails(run("explain", self.demo, "Spot 1", "--at", "4000"), 1, "there is no second 4000: the recording ends at 9")

    def test_bad_recordings(self):
        for name, text, part in (("empty", "", "OLA Show"), ("frameless", "OLA Show\n", "no frame"), ("odd", "OLA Show\nfish\n", "no frame")):
            file = WORK / (name + ".show")
            file.write_text(text)
            self.fails(run("explain", self.demo, "Spot 1", "--replay", file), 1, name + ".show", part)
        self.fails(run("explain", self.demo, "Spot 1", "--replay", WORK / "none.show"), 1, "none.show")

    def test_stage_that_cannot_be_read(self):
        show = write_show("no_stage", [spot()], [(1, OPEN)])
        toml = show / "show.toml"
        toml.write_text(toml.read_text().replace("[show]\n", '[show]\nstage = "none.glb"\n'))
        done = run("explain", show, "Spot")
        self.assertEqual(done.returncode, 0, done.text)
        self.assertIn("what it hits is not known", done.stdout)
        self.assertIn("none.glb", done.stderr)


def main():
    global WORK
    if not PROGRAM.exists():
        print(f"skipped: {PROGRAM} is not built")
        return 77
    with tempfile.TemporaryDirectory(prefix="ghost_explain_") as folder:
        WORK = pathlib.Path(folder)
        suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules["__main__"])
        return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A tour as a client gets it: a folder that refers to nothing else, two looks under a slider, two versions, a film.
Usage: tour_test.py SOURCE_FOLDER BUILD_FOLDER. Works on copies of the demo show."""
import html.parser
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
from demo_show import demo_show  # noqa: E402  (the folder is known only now)

SIZE = ["--size", "96x54"]
LOOKS = '[[look]]\nname = "Blue <b>"\n[[look.fixture]]\nname = "Spot 1"\nintensity = {level}\n[[look]]\nname = "Dark"\n'
WORK = None


def run(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)
    return done.returncode, done.stdout


def show(name, level=0.8):
    folder = WORK / name
    (folder / "show.toml").write_text(demo_show(SOURCE, folder), encoding="utf-8")
    (folder / "looks.toml").write_text(LOOKS.replace("{level}", str(level)), encoding="utf-8")
    return folder


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.files, self.tags, self.text = [], [], ""
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        for name, value in attributes:
            if name in ("src", "href"):
                self.files.append(value)
            if name == "data-files":
                self.files += value.split()

    def handle_data(self, data):
        self.text += data


class Tour(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.show = show("show")
        code, text = run("tour", cls.show, "-o", WORK / "tour", "--looks", "--view", "house", "--view", "close", "--film", "0.1", "--note", "Draft <2>", *SIZE)
        assert code == 0, text

    def test_refers_to_nothing_else_and_has_two_looks_under_a_slider(self):
        page = Page(WORK / "tour/index.html")
        for file in page.files:
            self.assertTrue((WORK / "tour" / file).is_file(), file)
        self.assertEqual({file for file in page.files if file.endswith(".png")}, {f"pictures/{look:04}-{camera}.png" for look in (1, 2) for camera in (1, 2)})
        sliders = [attributes for tag, attributes in page.tags if tag == "input" and attributes["type"] == "range"]
        self.assertEqual(len(sliders), 1)
        self.assertTrue(sliders[0]["aria-label"])
        self.assertEqual([attributes.get("id") for tag, attributes in page.tags if tag == "select"], ["look-left", "look-right", "camera"])
        self.assertIn("Draft <2>", page.text)
        self.assertIn("Blue <b>", page.text)

    def test_keeps_what_is_the_crews(self):
        folder = show("noted")
        (folder / "show.toml").write_text((folder / "show.toml").read_text(encoding="utf-8") + '[[cue]]\nname = "Opening"\nat_s = 20\nnotes = "Mind the trap"\n', encoding="utf-8")
        for arguments, has_notes in (([], False), (["--notes"], True)):
            out = WORK / f"noted_{has_notes}"
            code, text = run("tour", folder, "-o", out, "--cues", "--view", "house", *arguments, *SIZE)
            self.assertEqual(code, 0, text)
            for file in ("index.html", "book.json"):
                content = (out / file).read_text(encoding="utf-8")
                self.assertEqual("Mind the trap" in content, has_notes, file)
                for secret in ("Spot 1", "addresses\": [", "VL2500"):
                    self.assertNotIn(secret, content)
        # A book against it says what it cannot compare.
        code, text = run("book", folder, "-o", WORK / "since_tour", "--view", "house", "--against", WORK / "noted_False", *SIZE)
        self.assertEqual(code, 0, text)
        page = Page(WORK / "since_tour/index.html").text
        self.assertIn("the older one is a tour, which names no fixtures", page)
        self.assertNotIn("is new", page)

    def test_shows_nothing_under_the_name_of_what_is_not_there(self):
        folder = show("gone")
        cues = ('[[cue]]\nname = "Opening"\nat_s = 20\n[[cue]]\nname = "Gone look"\nlook = "Nicht da"\n[[cue]]\nname = "Dark one"\nlook = "Dark"\n'
                '[[cue]]\nname = "Behind the end"\nat_s = 5000\n')
        (folder / "show.toml").write_text((folder / "show.toml").read_text(encoding="utf-8") + cues, encoding="utf-8")
        code, text = run("tour", folder, "-o", WORK / "gone_tour", "--cues", "--view", "house", *SIZE)
        self.assertEqual(code, 0, text)
        self.assertIn("'Gone look' is left out: the show has no look 'Nicht da'", text)
        self.assertIn("'Behind the end' is left out", text)
        for file in ("index.html", "book.json"):
            content = (WORK / "gone_tour" / file).read_text(encoding="utf-8")
            self.assertNotIn("Gone look", content, file)
            self.assertNotIn("Behind the end", content, file)
            self.assertIn("Dark one", content, file)
        code, text = run("tour", folder, "-o", WORK / "none_tour", "--only", "Gone look", *SIZE)
        self.assertEqual(code, 1, text)
        self.assertFalse((WORK / "none_tour").exists())
        # A cue book shows it, and says what it is of.
        code, text = run("book", folder, "-o", WORK / "gone_book", "--view", "house", *SIZE)
        self.assertEqual(code, 0, text)
        self.assertIn("the show has no look 'Nicht da'", Page(WORK / "gone_book/index.html").text)

    def test_names_no_lamp_of_which_something_is_not_known(self):
        folder = show("bad")
        text = (folder / "show.toml").read_text(encoding="utf-8")
        bad = re.sub(r'(name = "Spot 1"\n(?:.*\n)*?)address = \d+', r"\1address = 'none'", text, count=1)
        self.assertNotEqual(bad, text)
        (folder / "show.toml").write_text(bad, encoding="utf-8")
        for name, is_client in (("tour", True), ("book", False)):
            out = WORK / f"bad_{name}"
            code, said = run(name, folder, "-o", out, "--looks", "--view", "house", *SIZE)
            self.assertEqual(code, 0, said)
            for file in ("index.html", "book.json"):
                content = (out / file).read_text(encoding="utf-8")
                self.assertEqual("Spot 1" in content, not is_client, file)
                self.assertEqual("1 fixture address, place or mode is not known" in content, is_client, file)

    def test_has_a_film_that_browsers_play(self):
        film = (WORK / "tour/film.mp4").read_bytes()
        self.assertEqual(film[4:8], b"ftyp")
        self.assertIn(b"avc1", film)  # H.264
        self.assertIn("video", [tag for tag, _ in Page(WORK / "tour/index.html").tags])

    def test_two_versions_have_a_slider(self):
        code, text = run("tour", show("dimmed", 0.3), "-o", WORK / "tour_2", "--looks", "--view", "house", "--against", WORK / "tour", "--language", "de", *SIZE)
        self.assertEqual(code, 0, text)
        page = Page(WORK / "tour_2/index.html")
        self.assertEqual([attributes["src"] for tag, attributes in page.tags if tag == "img" and "old" in attributes.get("class", "")],
                         ["pictures/0001-1.png", "old/0001-1.png"])
        for part in ("Stimmungen", "links: vorher, rechts: jetzt", "Blue <b> von house aus"):
            self.assertIn(part, page.text)
        self.assertNotIn("(tour)", page.text, "a client is not told how our folders are called")
        self.assertTrue(all((WORK / "tour_2" / file).is_file() for file in page.files))

    def test_bad_input_is_said_and_nothing_is_written(self):
        for arguments, code, part in ((["--only", "nowhere"], 1, "Blue <b>"), (["--film", "0"], 2, "--film"),
                                      (["--film-from", "3"], 2, "--film"), (["--film", "1", "--film-from", "5000"], 1, "the recording ends at"), (["--film", "1", "--size", "33x21"], 2, "even")):
            got, text = run("tour", self.show, "-o", WORK / "bad", "--looks", *SIZE[:0 if "--size" in arguments else 2], *arguments)
            self.assertEqual(got, code, text)
            self.assertIn(part, text)
        self.assertFalse((WORK / "bad").exists())


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        WORK = pathlib.Path(name)
        unittest.main(argv=[sys.argv[0], "-v"])

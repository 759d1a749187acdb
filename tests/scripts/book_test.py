#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The cue book and the paperwork as a user makes them: equal input gives equal bytes, one lamp dimmed shows in its entry and in no other, what
is not known is said, and no book is ever half there. Usage: book_test.py SOURCE_FOLDER BUILD_FOLDER. Works on copies of the demo show."""
import csv
import html.parser
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from lib import full_disk, needs
from lib.demo_show import demo_show

needs.packages("poppler-utils")
SOURCE, PROGRAM = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
SIZE = ["--size", "96x54"]
BOOK_BYTES = 8192  # some of a book, not all
CUES = '''
[[cue]]
name = "Opening <b>"
at_s = 20
notes = "שלום"

[[cue]]
name = "Blue"
look = "Blue"

[[cue]]
name = "Finale"
number = "47.5"
page = "12"
at_s = 36
camera = "close"
'''
LOOKS = '''
[[look]]
name = "Blue"
fade_s = 2
[[look.fixture]]
name = "Spot 1"
intensity = {level}
'''
WORK = None


def run(*arguments, full=None, threads=None):
    """full: a folder whose disk has room for BOOK_BYTES only. threads: that draw, where there is no GPU."""
    words = [PROGRAM, *map(str, arguments)]
    done = subprocess.run(full_disk.command(full, words, BOOK_BYTES) if full else words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          timeout=600, env=os.environ | ({"LP_NUM_THREADS": str(threads)} if threads else {}))
    return done.returncode, done.stdout


def show(name, cues=CUES, level=0.8):
    folder = WORK / name
    text = demo_show(SOURCE, folder)
    (folder / "show.toml").write_text(text + cues, encoding="utf-8")
    if cues:
        (folder / "looks.toml").write_text(LOOKS.replace("{level}", str(level)), encoding="utf-8")
    return folder


def pdf_text(file):
    """What a reader of its own finds in it; fonts must be embedded."""
    fonts = subprocess.run(["pdffonts", file], capture_output=True, text=True, check=True).stdout.splitlines()[2:]
    assert fonts and all(font.split()[-5] == "yes" for font in fonts), fonts
    return subprocess.run(["pdftotext", "-layout", file, "-"], capture_output=True, text=True, check=True).stdout


def contents(folder):
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


class Page(html.parser.HTMLParser):
    """What a page refers to, its text, and its rows."""

    def __init__(self, file):
        super().__init__()
        self.sources, self.text, self.rows, self.is_cell = [], "", [], False
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        self.sources += [value for name, value in attributes if name in ("src", "href") and not value.startswith("#")]
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")
            self.is_cell = True

    def handle_endtag(self, tag):
        self.is_cell = self.is_cell and tag not in ("td", "th")

    def handle_data(self, data):
        self.text += data
        if self.is_cell:
            self.rows[-1][-1] += data


class Book(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.show = show("show")
        code, text = run("book", cls.show, "-o", WORK / "book", "--pdf", *SIZE)
        assert code == 0, text

    def test_has_every_cue_and_refers_to_nothing_else(self):
        book = json.loads((WORK / "book/book.json").read_text(encoding="utf-8"))
        self.assertEqual([entry["name"] for entry in book["entries"]], ["Opening <b>", "Blue", "Finale"])
        self.assertEqual([entry["at_s"] for entry in book["entries"]], [20, 20, 36])
        self.assertEqual([picture["camera"] for entry in book["entries"] for picture in entry["pictures"]], ["house", "house", "close"])
        self.assertTrue(book["entries"][1]["goes_on"])
        changes = book["entries"][1]["changes"]
        self.assertEqual([change["fixtures"] for change in changes], [["Spot 1"]])
        self.assertRegex(changes[0]["what"], r"^\d+ to 80 %")
        page = Page(WORK / "book/index.html")
        self.assertEqual(page.sources, [picture["file"] for entry in book["entries"] for picture in entry["pictures"]])
        for name in page.sources:
            self.assertTrue((WORK / "book" / name).is_file(), name)
        for part in ("Opening <b>", "שלום", "goes on where the recording is"):
            self.assertIn(part, page.text)

    def test_can_be_printed(self):
        text = pdf_text(WORK / "book/book.pdf")
        for part in ("Opening <b>", "Blue", "47.5. Finale", "page 12 of the script", "page 1 of 1", "Spot 1:"):
            self.assertIn(part, text)

    def test_says_on_paper_what_has_no_room(self):
        # Twelve lamps do twelve things: more than a fourth of a page holds; and notes that are long, but not too long.
        lamps = [f"{kind} {k}" for kind in ("Spot", "Wash") for k in range(1, 6)]
        notes = " ".join(f"note{k}" for k in range(60))
        cues = f'[[cue]]\nname = "Dark"\nat_s = 0\n[[cue]]\nname = "A name that needs more than one line of the third of a page {"w" * 30}"\nlook = "All"\n[[cue]]\nname = "Noted"\nat_s = 0\nlook = "None"\nnotes = "{notes}"\n'
        folder = show("many", cues)
        looks = '[[look]]\nname = "None"\n[[look]]\nname = "All"\n' + "".join(
            f'[[look.fixture]]\nname = "{lamp}"\nintensity = {(k + 1) / 20}\n' for k, lamp in enumerate(lamps))
        (folder / "looks.toml").write_text(looks, encoding="utf-8")
        for language, more in (("en", r"and (\d+) more: see index.html"), ("de", r"und (\d+) weitere: siehe index.html")):
            out = WORK / f"many_{language}"
            code, text = run("book", folder, "-o", out, "--pdf", "--view", "house", "--language", language, *SIZE)
            self.assertEqual(code, 0, text)
            entry = json.loads((out / "book.json").read_text(encoding="utf-8"))["entries"][1]
            self.assertEqual(len(entry["changes"]), len(lamps))
            words = " ".join(pdf_text(out / "book.pdf").split())
            drawn = words[words.index("2. A name"):words.index("3. Noted")]
            self.assertIn("w" * 10, drawn)
            left = int(re.search(more, drawn).group(1))
            self.assertEqual(sum(f"{lamp}: " in drawn for lamp in lamps) + left, len(lamps))
            self.assertIn("note59", words)

    def test_as_a_grid_it_has_the_pictures_alone(self):
        code, text = run("book", self.show, "-o", WORK / "grid", "--pdf", "--layout", "grid", *SIZE)
        self.assertEqual(code, 0, text)
        text = pdf_text(WORK / "grid/book.pdf")
        for part in ("Opening <b>", "Blue", "47.5. Finale", "page 1 of 1"):
            self.assertIn(part, text)
        self.assertNotIn("Spot 1:", text)
        page = Page(WORK / "grid/index.html")
        self.assertEqual(page.sources, ["pictures/0001-1.png", "pictures/0002-1.png", "pictures/0003-1.png"])

    def test_equal_input_gives_equal_bytes(self):
        # Whatever the order is in which workgroups are drawn.
        for threads in (1, 5):
            code, text = run("book", self.show, "-o", WORK / "again", "--pdf", *SIZE, threads=threads)
            self.assertEqual(code, 0, text)
            self.assertEqual(contents(WORK / "again"), contents(WORK / "book"))

    def test_one_lamp_dimmed_shows_in_its_entry_and_in_no_other(self):
        # The look stays in the last cue, too: another camera, where Spot 1 is in the picture as well.
        dimmed = show("dimmed", CUES.replace('camera = "close"', 'camera = "close"\nlook = "None"'), level=0.4)
        (dimmed / "looks.toml").write_text((dimmed / "looks.toml").read_text() + '\n[[look]]\nname = "None"\n')
        plain = show("plain", CUES.replace('camera = "close"', 'camera = "close"\nlook = "None"'))
        shutil.copy(dimmed / "looks.toml", plain / "looks.toml")
        (plain / "looks.toml").write_text((plain / "looks.toml").read_text().replace("0.4", "0.8"))
        code, text = run("book", plain, "-o", WORK / "plain_book", *SIZE)
        self.assertEqual(code, 0, text)
        for out, old in (("against_book", WORK / "plain_book"), ("against_show", plain)):
            code, text = run("book", dimmed, "-o", WORK / out, "--against", old, *SIZE)
            self.assertEqual(code, 0, text)
            rows = {row[0]: row for row in Page(WORK / out / "index.html").rows if len(row) == 7 and row[0] != "entry"}
            self.assertEqual(set(rows), {"Opening <b>", "Blue", "Finale"})
            self.assertIn(rows["Blue"][2], ("seen", "large", "not seen"))
            self.assertGreater(float(rows["Blue"][5]), 0)
            for name in ("Opening <b>", "Finale"):
                self.assertEqual(rows[name][2:], ["the same", "0", "0", "0", "0 %"])
            self.assertEqual(sorted(path.name for path in (WORK / out / "old").iterdir()), ["0002-1.png"])
            self.assertEqual(sorted(path.name for path in (WORK / out / "differences").iterdir()), ["0002-1.png"])
            self.assertEqual({path.name for path in (WORK / out).iterdir()}, {".ghostlight", "book.json", "difference.json", "index.html", "values.csv", "pictures", "old", "differences"})

    def test_fixtures_that_changed_are_named(self):
        moved = show("moved")
        file = moved / "show.toml"
        text = file.read_text(encoding="utf-8")
        text = text.replace("position_m = [-5.2, 7.855, 6.26]", "position_m = [-5.2, 7.855, 5.26]").replace('name = "Spot 2"', 'name = "Spot 20"')
        file.write_text(text.replace("address = 45\n", "address = 401\n"), encoding="utf-8")
        code, text = run("book", moved, "-o", WORK / "moved_book", "--against", WORK / "book", *SIZE)
        self.assertEqual(code, 0, text)
        page = Page(WORK / "moved_book/index.html").text
        for part in ("Spot 1 moved by 1 m", "Spot 20 is new", "Spot 2 is gone", "Spot 3 is patched at 1.401, was at 1.45"):
            self.assertIn(part, page)

    def test_says_in_its_language_why_pictures_are_not_compared(self):
        out = WORK / "other_size"
        code, text = run("book", self.show, "-o", out, "--against", WORK / "book", "--language", "de", "--size", "64x36")
        self.assertEqual(code, 0, text)
        reasons = {picture["why_not"] for picture in json.loads((out / "difference.json").read_text(encoding="utf-8"))["pictures"]}
        self.assertEqual(reasons, {"die Bilder sind verschieden groß: 64 x 36 und 96 x 54 Pixel"})

    def test_hears_soon_that_it_is_to_stop(self):
        book = subprocess.Popen([PROGRAM, "book", self.show, "-o", WORK / "stopped", *SIZE], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        while not list(WORK.glob(".stopped.part*")):
            self.assertIsNone(book.poll())
            time.sleep(0.01)
        book.send_signal(signal.SIGTERM)
        text = book.communicate(timeout=600)[0]
        self.assertEqual(book.returncode, 1, text)
        self.assertIn("interrupted", text)
        self.assertNotIn("drawing on", text, "before a device is opened")
        self.assertEqual(list(WORK.glob("*stopped*")), [])

    def test_leaves_what_comes_into_its_folder_meanwhile(self):
        out = WORK / "meanwhile"
        book = subprocess.Popen([PROGRAM, "book", self.show, "-o", out, *SIZE], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        while not list(WORK.glob(".meanwhile.part*")):
            self.assertIsNone(book.poll())
            time.sleep(0.01)
        out.mkdir()
        (out / "thesis.txt").write_text("mine", encoding="utf-8")
        text = book.communicate(timeout=600)[0]
        self.assertEqual(book.returncode, 1, text)
        self.assertIn("thesis.txt", text)
        self.assertEqual(contents(out), {"thesis.txt": b"mine"})
        self.assertEqual(list(WORK.glob(".meanwhile.part*")), [])

    def test_a_show_without_cues_has_a_book(self):
        bare = show("bare", cues="")
        text = (bare / "show.toml").read_text(encoding="utf-8")
        (bare / "show.toml").write_text(text.replace('recording = "demo.show"\n', ""), encoding="utf-8")
        code, text = run("book", bare, "-o", WORK / "bare_book", *SIZE)
        self.assertEqual(code, 0, text)
        self.assertIn("neither cues nor looks", Page(WORK / "bare_book/index.html").text)
        for kind in ("--cues", "--looks", "--find"):
            code, text = run("book", bare, "-o", WORK / "none", kind, *SIZE)
            self.assertEqual(code, 1, text)
            self.assertIn("bare", text)
        self.assertFalse((WORK / "none").exists())

    def test_bad_input_is_said(self):
        for arguments, code, part in ((["--size", "9x9"], 2, "--size"), (["--view", "hause"], 1, "house"), (["--cues", "--find"], 2, "--find"),
                                      (["--against", WORK / "nowhere"], 2, "nowhere"), (["--paper", "A5"], 2, "A5")):
            got, text = run("book", self.show, "-o", WORK / "bad", *SIZE, *arguments)
            self.assertEqual(got, code, text)
            self.assertIn(part, text)
        broken = WORK / "broken"
        shutil.copytree(WORK / "book", broken)
        for damage in (lambda text: text[:len(text) // 2], lambda text: text.replace("pictures/0001-1.png", "../../secret.png")):
            (broken / "book.json").write_text(damage((WORK / "book/book.json").read_text(encoding="utf-8")), encoding="utf-8")
            code, text = run("book", self.show, "-o", WORK / "bad", "--against", broken, *SIZE)
            self.assertEqual(code, 1, text)
            self.assertIn("book.json", text)
        shutil.copy(WORK / "book/book.json", broken / "book.json")
        (broken / "pictures/0001-1.png").write_bytes(b"no picture")
        code, text = run("book", self.show, "-o", WORK / "said", "--against", broken, *SIZE)
        self.assertEqual(code, 0, text)
        self.assertIn("the older picture: ", Page(WORK / "said/index.html").text)
        self.assertFalse((WORK / "bad").exists())

    def test_is_whole_or_not_there(self):
        out = WORK / "disk/whole"
        shutil.copytree(WORK / "book", out)
        before = contents(out)
        if full_disk.is_possible():
            code, text = run("book", self.show, "-o", out, *SIZE, full=out.parent)
            self.assertEqual(code, 1, text)
            self.assertEqual(contents(out), before)
            self.assertEqual(os.listdir(out.parent), ["whole"])
        process = subprocess.Popen([PROGRAM, "--progress-every", "0.05", "book", self.show, "-o", out, "--size", "1280x720"], stderr=subprocess.PIPE,
                                   stdout=subprocess.DEVNULL, text=True)
        for line in process.stderr:
            if "cue book" in line:
                process.send_signal(signal.SIGINT)
                break
        rest = process.stderr.read()
        process.stderr.close()
        self.assertEqual(process.wait(120), 1)
        self.assertIn("interrupted: nothing is written", rest)
        self.assertEqual(contents(out), before)
        self.assertEqual([path.name for path in WORK.iterdir() if ".part" in path.name], [])
        (WORK / "mine").mkdir(exist_ok=True)
        (WORK / "mine/letter.txt").write_text("x")
        code, text = run("book", self.show, "-o", WORK / "mine", *SIZE)
        self.assertEqual(code, 1, text)
        self.assertIn("is there and is no cue book", text)
        self.assertEqual((WORK / "mine/letter.txt").read_text(), "x")


class Paper(unittest.TestCase):
    def test_is_made_of_the_demo(self):
        folder = show("paper_show")
        for out in ("paper", "paper_again"):
            code, text = run("paper", folder, "-o", WORK / out, "--pdf")
            self.assertEqual(code, 0, text)
        self.assertEqual(contents(WORK / "paper"), contents(WORK / "paper_again"))
        with open(WORK / "paper/patch.csv", encoding="utf-8-sig", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["from"] for row in rows[:3]], ["1", "23", "45"])
        self.assertEqual(rows[-1]["name"], "free")
        self.assertEqual(sum(int(row["channels"]) for row in rows), 512)
        self.assertEqual({path.name for path in (WORK / "paper").iterdir()},
                         {".ghostlight", "index.html", "paper.pdf", *(name + ".csv" for name in ("instruments", "hookup", "patch", "universes", "gobos_colours", "types", "positions"))})
        text = pdf_text(WORK / "paper/paper.pdf")
        pages = int(re.search(r"^Pages: +(\d+)", subprocess.run(["pdfinfo", WORK / "paper/paper.pdf"], capture_output=True, text=True, check=True).stdout, re.M).group(1))
        for part in ("Instrument schedule", "Patch by universe", "Wash 5", "free", f"page 1 of {pages}", f"page {pages} of {pages}"):
            self.assertIn(part, text)
        page = Page(WORK / "paper/index.html")
        self.assertEqual(page.sources, [])
        self.assertIn("What they hang on: 10 fixtures do not say it.", page.text)
        self.assertTrue(re.search(r"@page\{size:A4", (WORK / "paper/index.html").read_text(encoding="utf-8")))

    def test_names_of_any_script_and_length_and_files_that_are_not_there(self):
        folder = WORK / "odd"
        folder.mkdir()
        names = ["=HYPERLINK(1)", "ש" * 20, "a, b", "灯" * 20]
        (folder / "show.toml").write_text("[show]\nname = '<i>'\n[[camera]]\n" + "".join(
            f'[[fixture]]\nname = "{name}"\ngdtf = "none.gdtf"\nuniverse = 1\naddress = {1 + 20 * k}\n' for k, name in enumerate(names)),
            encoding="utf-8")
        code, text = run("paper", folder, "-o", WORK / "odd_paper", "--quiet")
        self.assertEqual(code, 0, text)
        with open(WORK / "odd_paper/hookup.csv", encoding="utf-8-sig", newline="") as file:
            found = {row["name"] for row in csv.DictReader(file)}
        self.assertEqual(found, {"'" + names[0], *names[1:]})
        page = Page(WORK / "odd_paper/index.html").text
        self.assertIn("free at most", page)
        self.assertIn("The file of the type could not be read of 4", page)

    def test_thousands_of_fixtures_take_seconds(self):
        file = SOURCE / "assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"
        for fixtures, arguments in ((2000, ["--pdf"]), (10000, [])):
            folder = WORK / f"large_{fixtures}"
            folder.mkdir()
            (folder / "show.toml").write_text("[show]\n[[camera]]\n" + "".join(
                f'[[fixture]]\nname = "Spot {k}"\ngdtf = "{file}"\nmode = "Standard 22 channels"\nuniverse = {1 + k // 23}\n'
                f"address = {1 + 22 * (k % 23)}\nposition_m = [{k % 50}, {k // 50 % 40}, 6]\n" for k in range(fixtures)), encoding="utf-8")
            out = WORK / f"large_paper_{fixtures}"
            started = time.monotonic()
            code, text = run("paper", folder, "-o", out, *arguments)
            took = time.monotonic() - started
            self.assertEqual(code, 0, text)
            with open(out / "instruments.csv", encoding="utf-8-sig", newline="") as rows:
                self.assertEqual(sum(1 for _ in csv.DictReader(rows)), fixtures)
            print(f"paper of {fixtures:,} fixtures: {took:.1f} s")
            self.assertLess(took, 40)  # 5 s on an idle machine; tests share theirs


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        WORK = pathlib.Path(name)
        unittest.main(argv=[sys.argv[0], "-v"])

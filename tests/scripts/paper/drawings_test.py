#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Plan, section and focus charts as a crew gets them: a truss of 10 m is 100 mm at 1:100, up-stage is at the top, a sheet says what it does
not know, and nothing is half made. Usage: drawings_test.py SOURCE_FOLDER BUILD_FOLDER."""
import csv
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile
import zlib

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import needs  # noqa: E402  (the folder is known only now)

needs.packages("poppler-utils")
WORK = None
MM = 72 / 25.4  # points


def run(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)
    return done.returncode, done.stdout


def box_glb(file, boxes):
    """boxes: name, low and high corner in metres of the world (Z up)."""
    positions, indices, nodes, meshes, accessors, views = b"", b"", [], [], [], []
    for name, low, high in boxes:
        corners = [(x, z, -y) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
        faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        triangles = [k for a, b, c, d in faces for k in (a, b, c, a, c, d)]
        views += [{"buffer": 0, "byteOffset": len(positions), "byteLength": 96}]
        positions += b"".join(struct.pack("<3f", *corner) for corner in corners)
        accessors += [{"bufferView": len(accessors), "componentType": 5126, "count": 8, "type": "VEC3", "min": [min(c[k] for c in corners) for k in range(3)],
                       "max": [max(c[k] for c in corners) for k in range(3)]}]
        views += [{"buffer": 0, "byteOffset": len(positions), "byteLength": 72}]
        positions += struct.pack("<36H", *triangles)
        accessors += [{"bufferView": len(accessors), "componentType": 5123, "count": 36, "type": "SCALAR"}]
        meshes += [{"primitives": [{"attributes": {"POSITION": len(accessors) - 2}, "indices": len(accessors) - 1}]}]
        nodes += [{"name": name, "mesh": len(meshes) - 1}]
    text = json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": meshes,
                       "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(positions)}]}).encode()
    text += b" " * (-len(text) % 4)
    positions += b"\0" * (-len(positions) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(positions), 0x004E4942) + positions
    file.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)


SPOT = SOURCE / "assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"


def show(name, fixtures, stage=True):
    folder = WORK / name
    folder.mkdir()
    if stage:
        box_glb(folder / "stage.glb", [("Truss 1", (-5, 2.85, 6), (5, 3.15, 6.3)), ("Floor", (-8, -2, -0.2), (8, 8, 0))])
    (folder / "show.toml").write_text("[show]\nname = 'Demo'\n" + ("stage = 'stage.glb'\n" if stage else "") + "[[camera]]\n" + fixtures, encoding="utf-8")
    return folder


def fixture(name, position, address, file=SPOT, universe=1):
    return (f"[[fixture]]\nname = {json.dumps(name)}\ngdtf = '{file}'\nmode = 'Standard 22 channels'\nuniverse = {universe}\naddress = {address}\n"
            f"position_m = {list(position)}\n")


def segments(pdf, page):
    """Lines of a page in points, from its content as it stands in the file: cairo only turns it upside down."""
    data = pdf.read_bytes()
    contents = []
    for begin in re.finditer(rb"stream\r?\n", data):
        try:
            text = zlib.decompressobj().decompress(data[begin.end():])
        except zlib.error:
            continue
        if text.startswith(b"1 0 0 -1 0 "):
            contents.append(text.decode("latin-1"))
    found, last = [], None
    for x, y, letter in re.findall(r"(-?[\d.]+)\s+(-?[\d.]+)\s+([ml])\b", contents[page - 1]):
        point = (float(x), float(y))
        if letter == "l":
            found.append((last, point))
        last = point
    return found


def words(pdf, page):
    text = subprocess.run(["pdftotext", "-bbox", "-f", str(page), "-l", str(page), pdf, "-"], capture_output=True, text=True, check=True).stdout
    return {word: (float(x), float(y)) for x, y, word in re.findall(r'<word xMin="([\d.]+)" yMin="([\d.]+)"[^>]*>([^<]*)<', text)}


def boxes(pdf, page):
    """Every word of a page: its letters, left, top, right, bottom."""
    text = subprocess.run(["pdftotext", "-bbox", "-f", str(page), "-l", str(page), pdf, "-"], capture_output=True, text=True, check=True).stdout
    found = re.findall(r'<word xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)" yMax="([\d.]+)">([^<]*)<', text)
    return [(word, *map(float, box)) for *box, word in found]


def covered(words):
    """Pairs of words that lie on each other; lines of one text may touch."""
    return [(a, b) for k, a in enumerate(words) for b in words[:k]
            if min(a[3], b[3]) - max(a[1], b[1]) > 0.5 and min(a[4], b[4]) - max(a[2], b[2]) > 0.35 * min(a[4] - a[2], b[4] - b[2])]


def text_of(pdf):
    fonts = subprocess.run(["pdffonts", pdf], capture_output=True, text=True, check=True).stdout.splitlines()[2:]
    assert fonts and all(font.split()[-5] == "yes" for font in fonts), fonts
    return subprocess.run(["pdftotext", "-layout", pdf, "-"], capture_output=True, text=True, check=True).stdout


class Drawings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.show = show("rig", "".join(fixture(f"Spot {k + 1}", (-4 + 2 * k, 3, 5.8), 1 + 22 * k) for k in range(5)))

    def test_a_truss_of_10_m_is_100_mm_at_1_100(self):
        for scale, expected_mm in ((100, 100), (50, 200)):
            out = WORK / f"at_{scale}"
            code, text = run("paper", self.show, "-o", out, "--plan", "--scale", f"1:{scale}", "--sheet", "A3")
            self.assertEqual(code, 0, text)
            lengths = [abs(b[0] - a[0]) / MM for a, b in segments(out / "plan.pdf", 1) if abs(a[1] - b[1]) < 0.02]
            self.assertGreaterEqual(sum(abs(length - expected_mm) < 0.05 for length in lengths), 2, sorted(lengths)[-12:])
            deep = [abs(b[1] - a[1]) / MM for a, b in segments(out / "plan.pdf", 1) if abs(a[0] - b[0]) < 0.02]
            self.assertGreaterEqual(sum(abs(length - expected_mm * 0.03) < 0.05 for length in deep), 2)

    def test_the_name_of_a_truss_stands_beside_it(self):
        out = WORK / "names"
        code, text = run("paper", self.show, "-o", out, "--plan", "--scale", "1:25", "--sheet", "A1")
        self.assertEqual(code, 0, text)
        for page, length_mm in ((1, 400), (2, 12)):
            lines = [(a, b) for a, b in segments(out / "plan.pdf", page) if abs(a[1] - b[1]) < 0.02 and abs(abs(b[0] - a[0]) / MM - length_mm) < 0.05]
            self.assertGreaterEqual(len(lines), 2)
            heights = [a[1] for a, _ in lines]
            x, y = words(out / "plan.pdf", page)["Truss"]
            left = min(min(a[0], b[0]) for a, b in lines)
            self.assertTrue(y > max(heights) or y + 6 < min(heights) or x + 20 < left, (page, x, y, heights))

    def test_a_narrow_last_sheet_says_whole_where_it_goes_on(self):
        out = WORK / "narrow"
        code, text = run("paper", SOURCE / "assets/demo", "-o", out, "--plan", "--scale", "1:25", "--sheet", "A1")
        self.assertEqual(code, 0, text)
        for page, other in ((1, 2), (2, 1)):
            said = subprocess.run(["pdftotext", "-f", str(page), "-l", str(page), "-layout", out / "plan.pdf", "-"],
                                  capture_output=True, text=True, check=True).stdout
            self.assertIn(f"goes on: sheet {other}", said)

    def test_a_row_of_lamps_is_one_lamp_in_the_section(self):
        drawn = []
        for count in (1, 5):
            rig = show(f"row_of_{count}", "".join(fixture(f"Spot {k + 1}", (-4 + 2 * k, 3, 5.8), 1 + 22 * k) for k in range(count)))
            code, text = run("paper", rig, "-o", WORK / f"paper_of_{count}", "--plan", "--scale", "1:50")
            self.assertEqual(code, 0, text)
            drawn.append([len(segments(WORK / f"paper_of_{count}/plan.pdf", page)) for page in (1, 2)])
        self.assertGreater(drawn[1][0], drawn[0][0], "five in the plan")
        self.assertEqual(drawn[1][1], drawn[0][1])

    def test_up_stage_is_at_the_top_and_left_is_left(self):
        out = WORK / "ways"
        code, text = run("paper", self.show, "-o", out, "--plan")
        self.assertEqual(code, 0, text)
        at = words(out / "plan.pdf", 1)
        self.assertLess(at["UP-STAGE"][1], at["HOUSE"][1])
        self.assertLess(at["1.1"][0], at["1.89"][0])  # the addresses of Spot 1 and Spot 5
        said = text_of(out / "plan.pdf")
        for part in ("Demo", "Plan", "Section", "1:50", "A3", "1 of 2", "2 of 2", "Truss 1, underside 6 m, length 10 m", "Spot 3", "moving profile", "centre line"):
            self.assertIn(part, said)

    def test_equal_input_gives_equal_bytes(self):
        for out in ("bytes_a", "bytes_b"):
            code, text = run("paper", self.show, "-o", WORK / out, "--plan", "--focus", "--pdf", "--date", "1 May", "--language", "de")
            self.assertEqual(code, 0, text)
        for file in sorted((WORK / "bytes_a").iterdir()):
            self.assertEqual(file.read_bytes(), (WORK / "bytes_b" / file.name).read_bytes(), file.name)
        said = text_of(WORK / "bytes_a/plan.pdf") + text_of(WORK / "bytes_a/focus.pdf") + text_of(WORK / "bytes_a/paper.pdf")
        for part in ("Grundriss", "Schnitt", "Legende", "1 May", "Mittellinie", "Einleuchtplan", "Geräteliste"):
            self.assertIn(part, said)
        self.assertNotIn("Instrument", said)

    def test_focus_charts_have_true_distances(self):
        out = WORK / "focus"
        code, text = run("paper", self.show, "-o", out, "--focus", "--units", "imperial", "--paper", "Letter")
        self.assertEqual(code, 0, text)
        with open(out / "focus.csv", encoding="utf-8-sig", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["name"] for row in rows], [f"Spot {k + 1}" for k in range(5)])
        self.assertEqual({row["hits"] for row in rows}, {"Floor"})
        for row in rows:  # it hangs 5.8 m high, and its lens is a little below
            feet, inches = re.match(r"(\d+)'-(\d+)", row["throw ft"]).groups()
            self.assertTrue(4.8 < (int(feet) + int(inches) / 12) * 0.3048 < 5.8, row)
        self.assertIn("13'-1 1/2\" left", text_of(out / "focus.pdf"))  # Spot 1, 4 m

    def test_a_moment_behind_the_recording_is_said(self):
        code, text = run("paper", SOURCE / "assets/demo", "-o", WORK / "behind", "--focus", "--at", "1e6")
        self.assertEqual(code, 0, text)
        self.assertIn("the recording ends before it", text_of(WORK / "behind/focus.pdf"))

    def test_words_cover_no_words(self):
        crowd = show("crowd", "".join(fixture(f"Spot {k}", (-7.5 + k % 26 * 0.6, -1.5 + k // 26 * 0.7, 6), 1 + 22 * (k % 23), universe=1 + k // 23)
                                      for k in range(338)))
        for sheet, scale in (("A3", "fit"), ("A1", "fit"), ("A3", "1:20")):
            out = WORK / f"crowd_{sheet}_{scale[-2:]}"
            code, text = run("paper", crowd, "-o", out, "--plan", "--scale", scale, "--sheet", sheet, "--quiet")
            self.assertEqual(code, 0, text)
            for page in (1, 2):
                words = boxes(out / "plan.pdf", page)
                if page == 1:
                    self.assertTrue({"UP-STAGE", "centre"} & {word[0] for word in words}, "they find room")
                if scale != "fit":  # what is cut off at the edge of a sheet is there for pdftotext
                    words = [word for word in words if 48.2 <= word[1] and word[3] <= 982 and 30.3 <= word[2] and word[4] <= 793]
                self.assertEqual(covered(words), [], (sheet, scale, page))

    def test_letters_are_larger_on_large_sheets(self):
        heights = {}
        for sheet in ("A3", "A1"):
            code, text = run("paper", self.show, "-o", WORK / f"letters_{sheet}", "--plan", "--sheet", sheet, "--scale", "1:50", "--quiet")
            self.assertEqual(code, 0, text)
            heights[sheet] = [word[4] - word[2] for word in boxes(WORK / f"letters_{sheet}/plan.pdf", 1) if word[0] == "1.23"]
        self.assertAlmostEqual(heights["A1"][0] / heights["A3"][0], 7 / 5.5, delta=0.02)

    def test_names_of_trusses_without_room_are_counted(self):
        folder = show("bars", "".join(fixture(f"Spot {k}", (0, 0.4 * k, 5.8), 1 + 22 * k) for k in range(20)))
        box_glb(folder / "stage.glb", [(f"A truss with a name as long as a truss can have number {k}", (-5, 0.4 * k - 0.1, 6), (5, 0.4 * k + 0.1, 6.2))
                                       for k in range(20)])
        code, text = run("paper", folder, "-o", WORK / "bars_paper", "--plan", "--sheet", "A4", "--scale", "1:200")
        self.assertEqual(code, 0, text)
        said = " ".join(text_of(WORK / "bars_paper/plan.pdf").split())
        self.assertRegex(said, r"Names of trusses and hanging positions that found no room: \d+")

    def test_figures_of_a_focus_chart_stand_beside_their_arrows(self):
        places = [(0.3, 3), (-0.3, 0.3), (3, -0.5), (-4, 6), (0.05, 0.05), (0, 2), (-3, 0.2), (4, -1)]
        folder = show("figures", "".join(fixture(f"Spot {k + 1}", (x, y, 5.8), 1 + 22 * k) for k, (x, y) in enumerate(places)))
        for units in ("metric", "imperial"):
            out = WORK / f"figures_{units}"
            code, text = run("paper", folder, "-o", out, "--focus", "--units", units)
            self.assertEqual(code, 0, text)
            words = boxes(out / "focus.pdf", 1)
            self.assertEqual(covered(words), [])
            lines = segments(out / "focus.pdf", 1)
            arrows = [(a, b) for a, b in zip(lines, lines[1:]) if a[0] == b[0] and abs(a[0][1] - a[1][1]) < 0.02 and abs(b[0][0] - b[1][0]) < 0.02]
            self.assertEqual(len(arrows), sum(x != 0 for x, _ in places))  # on the centre line there is none to it
            figures = [word for word in words if word[4] - word[2] < 8 and re.match(r"[\d.]+('|$)", word[0])]
            for (aim, centre), (_, set_line) in arrows:
                for word, left, top, right, bottom in figures:
                    for end in (centre, set_line):
                        low, high = [min(aim[k], end[k]) for k in (0, 1)], [max(aim[k], end[k]) for k in (0, 1)]
                        on_it = left < high[0] and low[0] < right and top + 1 < high[1] and low[1] < bottom - 1
                        self.assertFalse(on_it, (units, word, (left, top, right, bottom), aim, end))
            if units == "metric":
                self.assertEqual(sum(word[0] == "0.3" for word in figures), 3, "short measures have their figures")
                self.assertEqual(text_of(out / "focus.pdf").count("a square: 1 m"), len(places))

    def test_a_long_name_pushes_no_figure_off_a_focus_chart(self):
        plot = WORK / "long.mvr"
        lamp = ('<Fixture uuid="00000000-0000-0000-0000-000000000001" name="Spot"><Matrix>{1,0,0}{0,1,0}{0,0,1}{1000,2000,6000}</Matrix>'
                f'<GDTFSpec>{SPOT.name}</GDTFSpec><GDTFMode>Standard 22 channels</GDTFMode><FixtureID>1</FixtureID><UnitNumber>7</UnitNumber>'
                '<Position>00000000-0000-0000-0000-00000000000a</Position><Addresses><Address break="0">1</Address></Addresses></Fixture>')
        with zipfile.ZipFile(plot, "w") as archive:
            archive.writestr("GeneralSceneDescription.xml", '<?xml version="1.0"?><GeneralSceneDescription verMajor="1" verMinor="6"><Scene><AUXData>'
                             f'<Position uuid="00000000-0000-0000-0000-00000000000a" name="{"W" * 3000}"/></AUXData><Layers>'
                             f'<Layer name="L" uuid="1"><ChildList>{lamp}</ChildList></Layer></Layers></Scene></GeneralSceneDescription>')
            archive.write(SPOT, SPOT.name)
        code, text = run("paper", plot, "-o", WORK / "long_paper", "--focus")
        self.assertEqual(code, 0, text)
        said = " ".join(text_of(WORK / "long_paper/focus.pdf").split())
        for part in ("[7] W", "place: 1 m right", "throw", "angle", "pan", "tilt", "light: dark"):
            self.assertIn(part, said)

    def test_focus_charts_are_where_movers_are(self):
        folder = show("lift", fixture("Spot 1", (0, 3, 5.8), 1) + "[[mover]]\nname = 'Lift'\nkind = 'linear'\ndirection = [0.0, 0.0, 1.0]\n"
                      "objects = ['Truss 1', 'Deck']\nfixtures = ['Spot 1']\n[[mover.axis]]\nrange_m = [0.0, -3.0]\nuniverse = 9\naddress = 1\n")
        box_glb(folder / "stage.glb", [("Truss 1", (-5, 2.85, 6), (5, 3.15, 6.3)), ("Floor", (-8, -2, -0.2), (8, 8, 0)), ("Deck", (-8, -2, 3.2), (8, 8, 3.4))])
        (folder / "looks.toml").write_text("".join(f"[[look]]\nname = '{name}'\n[[look.mover]]\nname = 'Lift'\nvalues = [{value}]\n"
                                                   for name, value in (("up", 0.0), ("down", -2.0))), encoding="utf-8")
        rows = {}
        for look in ("up", "down"):
            code, text = run("paper", folder, "-o", WORK / f"lift_{look}", "--focus", "--plan", "--look", look)
            self.assertEqual(code, 0, text)
            with open(WORK / f"lift_{look}/focus.csv", encoding="utf-8-sig", newline="") as file:
                rows[look] = next(csv.DictReader(file))
        self.assertIn("z 5.8 m", rows["up"]["place"])
        self.assertIn("z 3.8 m", rows["down"]["place"])
        self.assertIn("z 3.4 m", rows["up"]["aims at"])
        self.assertIn("z 1.4 m", rows["down"]["aims at"])
        self.assertEqual([rows[look]["hits"] for look in ("up", "down")], ["Deck", "Deck"])
        self.assertEqual(rows["up"]["throw m"], rows["down"]["throw m"])
        self.assertIn("What movers carry is drawn where the show has it", " ".join(text_of(WORK / "lift_up/plan.pdf").split()))

    def test_large_sheets_are_cut_or_refused_with_a_scale_that_fits(self):
        out = WORK / "cut"
        code, text = run("paper", self.show, "-o", out, "--plan", "--scale", "1:20", "--sheet", "A4")
        self.assertEqual(code, 0, text)
        self.assertIn("goes on: sheet 2", text_of(out / "plan.pdf"))
        code, text = run("paper", self.show, "-o", WORK / "none", "--plan", "--scale", "1:1", "--sheet", "A4")
        self.assertEqual(code, 1, text)
        self.assertRegex(text, r"1:\d+ fits on one")
        self.assertTrue((WORK / "none/instruments.csv").exists())  # a drawing that cannot be takes no table with it
        self.assertFalse((WORK / "none/plan.pdf").exists())
        shutil.rmtree(WORK / "none")
        for arguments in (["--plan", "--scale", "half"], ["--scale", "1:50"], ["--plan", "--sheet", "A9"], ["--look", "x"], ["--language", "fr"]):
            code, text = run("paper", self.show, "-o", WORK / "none", *arguments)
            self.assertEqual(code, 2, text)
        self.assertFalse((WORK / "none").exists())
        code, text = run("paper", self.show, "-o", WORK / "none", "--focus", "--look", "nowhere")
        self.assertEqual(code, 1, text)
        self.assertTrue((WORK / "none/instruments.csv").exists())
        self.assertFalse((WORK / "none/focus.pdf").exists())

    def test_names_of_any_script_and_length_and_nothing_known(self):
        names = ["ש" * 20, "灯" * 30, "x" * 5000, "<b>\\\"&'", "مصباح 1"]
        folder = show("odd", "".join(fixture(name, (k, 1, 5), 1 + 20 * k, "none.gdtf") for k, name in enumerate(names)), stage=False)
        code, text = run("paper", folder, "-o", WORK / "odd_paper", "--plan", "--focus", "--pdf", "--quiet")
        self.assertEqual(code, 0, text)
        said = " ".join(text_of(WORK / "odd_paper/plan.pdf").split())
        for part in ("not known of 5", "no stage model"):
            self.assertIn(part, said)
        self.assertIn("Without a beam, or without a file that could be read", " ".join(text_of(WORK / "odd_paper/focus.pdf").split()))
        self.assertFalse((WORK / "odd_paper/phases_proposal.csv").exists())

    def test_two_thousand_fixtures_take_seconds(self):
        folder = show("large", "".join(fixture(f"Spot {k}", (-25 + k % 100 * 0.5, k // 100, 6), 1 + 22 * (k % 23), universe=1 + k // 23) for k in range(2000)))
        started = time.monotonic()
        code, text = run("paper", folder, "-o", WORK / "large_paper", "--plan", "--focus", "--sheet", "A1")
        took = time.monotonic() - started
        self.assertEqual(code, 0, text)
        sizes = {file: (WORK / "large_paper" / file).stat().st_size for file in ("plan.pdf", "focus.pdf")}
        print(f"paper of 2,000 fixtures with plan and focus charts: {took:.1f} s, {sizes}")
        self.assertLess(took, 30)  # 5 s on an idle machine; tests share theirs
        self.assertLess(max(sizes.values()), 3_000_000)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        WORK = pathlib.Path(name)
        unittest.main(argv=[sys.argv[0], "-v"])

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
        for part in ("Demo", "Plan", "Section", "1:50", "A3", "1 of 2", "2 of 2", "Truss 1, z = 6 m, 10 m", "Spot 3", "moving profile", "centre line"):
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

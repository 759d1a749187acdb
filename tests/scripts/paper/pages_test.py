#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Pages of paperwork and tour in a browser: names of any length make neither a phone's page nor a printed one wide, and no line breaks an
address. Usage: pages_test.py SOURCE_FOLDER BUILD_FOLDER."""
import base64
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import browser  # noqa: E402  (the folder is known only now)
import needs  # noqa: E402
from demo_show import demo_show  # noqa: E402

needs.packages("chromium", "poppler-utils")
LONG = ("w" * 300, "A cue with a name of many words, as somebody writes it who has the time, and then some more of it")
PHONE = 390
WORK = None


def run(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)
    assert done.returncode == 0, done.stdout


def show(name, more="", fixtures=None):
    folder = WORK / name
    text = demo_show(SOURCE, folder)
    for old, new in (fixtures or {}).items():
        assert f'name = "{old}"' in text
        text = text.replace(f'name = "{old}"', f'name = "{new}"')
    (folder / "show.toml").write_text(text.replace("universe = 1\n", "universe = 61\n") + more, encoding="utf-8")
    return folder


def opened(file, width):
    page = pages.page(file.as_uri(), width, 800)
    page.until("document.readyState === 'complete' && location.protocol === 'file:'")
    return page


class Pages(unittest.TestCase):
    def test_a_tour_is_as_wide_as_the_phone(self):
        cues = "".join(f'[[cue]]\nname = "{name}"\nat_s = {20 + k}\n' for k, name in enumerate(LONG))
        run("tour", show("tour_show", cues), "-o", WORK / "tour", "--size", "96x54")
        page = opened(WORK / "tour/index.html", PHONE)
        self.assertEqual(page.value("document.querySelectorAll('select option').length"), 7)  # two choices of looks, one of three cameras
        self.assertEqual(page.value("document.documentElement.scrollWidth"), PHONE)

    def test_tables_break_no_address_and_no_page(self):
        run("paper", show("paper_show", fixtures={"Spot 2": LONG[0], "Wash 1": LONG[1]}), "-o", WORK / "paper")
        page = opened(WORK / "paper/index.html", PHONE)
        self.assertEqual(page.value("document.documentElement.scrollWidth"), PHONE)
        one_line = page.value("""[...document.querySelectorAll('th, td.n, td.w')].filter(
            cell => new Set([...(cell.firstElementChild ?? cell).getClientRects()].map(line => line.top)).size > 1).map(cell => cell.textContent)""")
        self.assertEqual(one_line, [])
        printed = base64.b64decode(page.call("Page.printToPDF", preferCSSPageSize=True)["data"])
        (WORK / "printed.pdf").write_bytes(printed)
        text = subprocess.run(["pdftotext", "-layout", WORK / "printed.pdf", "-"], capture_output=True, text=True, check=True).stdout
        for channel in (1, 45, 67, 89):
            self.assertRegex(text, rf"\b61\.{channel}\b")
        info = subprocess.run(["pdfinfo", WORK / "printed.pdf"], capture_output=True, text=True, check=True).stdout
        width, height = map(float, re.search(r"Page size: +([\d.]+) x ([\d.]+)", info).groups())
        self.assertGreater(width, height)
        # As large as the style sheet says: no browser made all of it smaller so that something fits.
        words = subprocess.run(["pdftotext", "-bbox", WORK / "printed.pdf", "-"], capture_output=True, text=True, check=True).stdout
        edges = [float(edge) for edge in re.findall(r'xMax="([\d.]+)"', words)]
        self.assertLess(max(edges), width)
        heads = [float(bottom) - float(top) for top, bottom in re.findall(r'yMin="([\d.]+)" xMax="[\d.]+" yMax="([\d.]+)">address<', words)]
        self.assertTrue(heads)
        self.assertGreater(min(heads), 7)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        WORK = pathlib.Path(name)
        pages = browser.Browser()
        try:
            is_well = unittest.main(argv=[sys.argv[0], "-v"], exit=False).result.wasSuccessful()
        finally:
            pages.close()
    sys.exit(not is_well)

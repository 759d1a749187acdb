#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""ghostlight-bench: a table as JSON; a report of a table, whole, and again over the one before; and what bad input gets. Usage:
bench_report_test.py SOURCE_FOLDER BUILD_FOLDER"""
import html.parser
import json
import pathlib
import subprocess
import sys
import tempfile

SOURCE, BUILD = (pathlib.Path(argument) for argument in sys.argv[1:3])
PROGRAM = BUILD / "ghostlight-bench"
VOID = {"meta", "img", "br"}


def run(*arguments, code=0):
    done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=SOURCE, capture_output=True, text=True, timeout=600)
    assert done.returncode == code, (arguments, done.returncode, done.stdout[-2000:], done.stderr[-2000:])
    return done


class Page(html.parser.HTMLParser):
    """Every element that begins ends, and nothing is fetched from elsewhere."""

    def __init__(self):
        super().__init__()
        self.open, self.words = [], []

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            assert name not in ("src", "href") or not value.startswith(("http", "//")), value
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        self.words.append(data)


def test_tables():
    rows = [json.loads(line) for line in run("thesis", "--frames", 5).stdout.splitlines()]
    assert len(rows) == 9 and rows[-1]["name"] == "gate" and rows[-1]["haze_psnr_db"] > 60, rows


def test_report(work):
    out = work / "of this machine"
    done = run("thesis", "-o", out, "--frames", 5)
    assert done.stdout.strip() == str(out / "report.html"), done.stdout
    report = json.loads((out / "report.json").read_text(encoding="utf-8"))
    assert report["device"]["name"] and int(report["device"]["maxPushDescriptors"]) >= 17, report["device"]
    assert list(report["tables"]) == ["thesis"] and report["tables"]["thesis"]["error"] == "", report["tables"].keys()
    assert len(report["tables"]["thesis"]["rows"]) == 9, report["tables"]["thesis"]
    page = Page()
    page.feed((out / "report.html").read_text(encoding="utf-8"))
    assert page.open == [], page.open
    assert any(report["device"]["name"] in words for words in page.words)
    # Over the one before: a table that cannot be made is in the report, with its reason.
    run("paper", "-o", out, "--show", work / "nothing")
    tables = json.loads((out / "report.json").read_text(encoding="utf-8"))["tables"]
    assert list(tables) == ["paper"] and "nothing" in tables["paper"]["error"], tables


def test_bad_input(work):
    taken = work / "taken"
    taken.write_text("mine", encoding="utf-8")
    assert "taken" in run("thesis", "-o", taken, code=1).stderr
    assert taken.read_text(encoding="utf-8") == "mine"
    assert "found:" in run("thesis", "-o", work / "r", "--device", "no such device", code=1).stderr
    run("no_such_table", code=2)
    wrong = run("pictures", "--against", work / "nothing", code=1)
    assert "house_8s_256x75.exr" in wrong.stderr, wrong.stderr


with tempfile.TemporaryDirectory() as folder:
    test_tables()
    test_report(pathlib.Path(folder))
    test_bad_input(pathlib.Path(folder))
print("ok")

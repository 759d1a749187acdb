#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Collects the texts of the window from src/ui into assets/translations/*.ts and lists what is not translated there. What the sources lack
now goes. A language begins as an empty file: touch assets/translations/ghostlight_fr.ts. Exit 0: all is translated; 1: not yet."""
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ENGLISH = "ghostlight_en.ts"  # plurals alone: all else is what the sources say


def collect(catalogue):
    lupdate = shutil.which("lupdate", path="/usr/lib/qt6/bin") or shutil.which("lupdate")
    if not lupdate:
        sys.exit("lupdate is missing: package qt6-l10n-tools")
    language = catalogue.stem.split("_", 1)[1]
    if catalogue.stat().st_size == 0:
        catalogue.unlink()
    only = ["-pluralonly"] if catalogue.name == ENGLISH else []
    subprocess.run([lupdate, *only, "-silent", "-no-obsolete", "-locations", "none", "-tr-function-alias", "translate+=translated",
                    "-target-language", language, "src/ui", "-ts", str(catalogue.relative_to(ROOT))], cwd=ROOT, check=True)


def unfinished(catalogue):
    """(context, text) of each that waits for a translation or for somebody who looks at it."""
    for context in ET.parse(catalogue).getroot().iter("context"):
        for message in context.iter("message"):
            if message.find("translation").get("type"):
                yield context.find("name").text, message.find("source").text


waits = 0
for file in sorted((ROOT / "assets/translations").glob("*.ts")):
    collect(file)
    for name, text in unfinished(file):
        print(f"{file.name}: {name}: {text}")
        waits += 1
print(f"{waits} texts wait for a translation")
sys.exit(waits > 0)

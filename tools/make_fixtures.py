#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Packs assets/fixtures/src/*/ into .gdtf files. Same input, same bytes: entries sorted and stored, fixed time stamps.

usage: make_fixtures.py [--out FOLDER]     default: assets/fixtures

Each folder holds description.xml; pictures and meshes that its XML names are taken from its own wheels/ and models/,
else from assets/fixtures/src/shared/. A name without a file is an error.
"""
import argparse
import sys
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent / "assets" / "fixtures"
SOURCES = ROOT / "src"


def find(folder, entry):
    for base in (folder, SOURCES / "shared"):
        if (base / entry).is_file():
            return base / entry
    sys.exit(f"{folder.name}/description.xml names {entry}, but there is no such file in {folder} or in shared/")


def entries(folder):
    """(name in the archive, file) of everything the description uses."""
    tree = ElementTree.parse(folder / "description.xml")
    names = {f"wheels/{slot.get('MediaFileName')}.png" for slot in tree.iter("Slot") if slot.get("MediaFileName")}
    names |= {f"models/gltf/{model.get('File')}.glb" for model in tree.iter("Model") if model.get("File")}
    return [("description.xml", folder / "description.xml")] + [(name, find(folder, name)) for name in sorted(names)]


def pack(folder, out):
    with zipfile.ZipFile(out, "w") as archive:
        for name, path in entries(folder):
            info = zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0))
            info.compress_type = zipfile.ZIP_STORED
            info.create_system = 3
            info.external_attr = 0o644 << 16
            archive.writestr(info, path.read_bytes())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=ROOT, help="folder of the .gdtf files")
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    for description in sorted(SOURCES.glob("*/description.xml")):
        maker = ElementTree.parse(description).find("FixtureType").get("Manufacturer")
        path = out / f"{maker}@{description.parent.name}.gdtf"
        pack(description.parent, path)
        print(f"{path} {path.stat().st_size} bytes")


if __name__ == "__main__":
    main()

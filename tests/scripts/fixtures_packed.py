#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The committed .gdtf files are what tools/make_fixtures.py packs from their sources, byte for byte."""
import subprocess
import sys
import tempfile
from pathlib import Path

root = Path(sys.argv[1])
with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.executable, root / "tools/make_fixtures.py", "--out", folder], check=True, stdout=subprocess.DEVNULL)
    made = {path.name: path.read_bytes() for path in Path(folder).glob("*.gdtf")}
committed = {path.name: path.read_bytes() for path in (root / "assets/fixtures").glob("*.gdtf")}
if made != committed or len(made) != 5:
    different = sorted(name for name in made.keys() | committed.keys() if made.get(name) != committed.get(name))
    sys.exit(f"assets/fixtures is not what its sources give: {different}; run tools/make_fixtures.py and commit")
print("5 files are identical")

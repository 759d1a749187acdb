#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Seeds for the fuzz targets, made from real files: those of the project and, where they are beside the checkout, of ../shared.
Of each file: itself, some of its beginnings, some with single bytes changed, and of archives some with members swapped. The same
each time. Usage: fuzz_seeds.py OUT [MOST_BYTES]: OUT/<target>/*; files above MOST_BYTES (1,000,000) are left out."""
import io
import pathlib
import random
import sys
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
sys.dont_write_bytecode = True
from fuzz_made import made  # noqa: E402  (the folder is known only now)

ROOT = pathlib.Path(__file__).resolve().parent.parent
ENDINGS = {  # of a target's real files
    "gdtf": [".gdtf"], "mvr": [".mvr"], "qxf": [".qxf"], "ofl": [".json"], "show": [".toml"], "looks": [".toml"], "passes": [".toml", ".json"],
    "ola_show": [".show"], "model": [".glb", ".gltf", ".3ds", ".obj"], "gltf_pack": [".gltf"], "picture": [".png", ".jpg", ".svg"], "symbol": [".svg"],
    "photometric": [".ies", ".ldt"], "exr": [".exr"], "plot_show": [".mvr"]}


def members_swapped(data, chance):
    """An archive in which two members have changed their contents."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            members = [(name, archive.read(name)) for name in archive.namelist()]
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, OSError):
        return None
    if len(members) < 2:
        return None
    a, b = chance.sample(range(len(members)), 2)
    members[a], members[b] = (members[a][0], members[b][1]), (members[b][0], members[a][1])
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members:
            archive.writestr(name, content)
    return out.getvalue()


def variants(data, chance):
    yield data
    for _ in range(2):
        yield data[:chance.randrange(1, len(data) + 1)]
    for _ in range(2):
        flipped = bytearray(data)
        for _ in range(chance.randrange(1, 9)):
            flipped[chance.randrange(len(flipped))] ^= 1 << chance.randrange(8)
        yield bytes(flipped)
    if data[:2] == b"PK":
        swapped = members_swapped(data, chance)
        if swapped:
            yield swapped


def main():
    out = pathlib.Path(sys.argv[1])
    most = int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000
    chance = random.Random(24)
    shared = ROOT.parent / "shared"
    folders = [ROOT / "assets", ROOT / "tests", shared / "fixtures", shared / "reference"]
    files = sorted(path for folder in folders if folder.is_dir() for path in folder.rglob("*") if path.is_file() and path.stat().st_size <= most)
    extra = made()
    targets = sorted(path.stem.removesuffix("_fuzz") for path in (ROOT / "tests/fuzz").rglob("*_fuzz.cpp"))
    for target in targets:
        folder = out / target
        folder.mkdir(parents=True, exist_ok=True)
        contents = [path.read_bytes() for path in files if path.suffix.lower() in ENDINGS.get(target, ())][:200] + extra.get(target, [])
        count = 0
        for content in contents:
            if not content:
                continue
            for variant in variants(content, chance):
                (folder / f"seed{count:04}").write_bytes(variant)
                count += 1
        if count == 0:
            print(f"{target}: no seeds", file=sys.stderr)
        else:
            print(f"{target}: {count} seeds")


if __name__ == "__main__":
    main()

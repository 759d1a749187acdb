#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Seeds for the fuzz targets, made from real files: those of the project and, where they are beside the checkout, of ../shared.
Of each file: itself, some of its beginnings, some with single bytes changed, and of archives some with members swapped. The same
each time. Usage: fuzz_seeds.py OUT [MOST_BYTES]: OUT/<target>/*; files above MOST_BYTES (1,000,000) are left out."""
import io
import json
import pathlib
import random
import struct
import sys
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
ENDINGS = {  # of a target's real files
    "gdtf": [".gdtf"], "mvr": [".mvr"], "qxf": [".qxf"], "ofl": [".json"], "show": [".toml"], "looks": [".toml"], "passes": [".toml", ".json"],
    "ola_show": [".show"], "model": [".glb", ".gltf", ".3ds", ".obj"], "gltf_pack": [".gltf"], "picture": [".png", ".jpg", ".svg"],
    "photometric": [".ies", ".ldt"], "ghostdmx": [".ghostdmx"], "capture": [".pcap", ".pcapng"], "exr": [".exr"]}
OBJ = b"mtllib a.mtl\no floor\nv -9 0 9\nv 9 0 9\nv 9 0 -9\nvt 0 0\nvn 0 1 0\nusemtl red\nf 1/1/1 2/1/1 3/1/1\nf -1 -2 -3\n"
GLTF = json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                   "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "buffers": [{"uri": "a.bin", "byteLength": 36}],
                   "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
                   "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]}]}).encode()
DIFFERENCE = json.dumps({"ghostlight_difference": 1, "old_name": "a", "entries": [], "fixtures": [], "unknown": [], "pictures": [
    {"name": "a", "camera": "c", "file": "pictures/0001-1.png", "old_file": "old/0001-1.png", "map_file": "", "why_not": ""}]}).encode()
BOOK = json.dumps({"ghostlight_book": 1, "show": "a", "kind": "cues", "size": [64, 36], "ev100": 6, "device": "d", "unknown": [],
                   "fixtures": [{"name": "Spot 1", "id": "1", "uuid": "", "type": "t", "mode": "m", "addresses": [[1, 1]], "position_m": [0, 0, 6]}],
                   "entries": [{"name": "a", "notes": "", "look": "", "at_s": 1.5, "goes_on": False, "fade_s": None, "follow_s": None, "unknown": [],
                                "pictures": [{"camera": "house", "file": "pictures/0001-1.png"}],
                                "changes": [{"fixtures": ["Spot 1"], "what": "0 to 80 %"}]}]}).encode()


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


def behind_sizes(packets):
    """As tests/fuzz/network_fuzz.h reads them."""
    return b"".join(struct.pack(">HBB", len(packet), 1, k & 3) + packet for k, packet in enumerate(packets))


def masked(opcode, payload):
    """A frame of a browser, WebSocket."""
    mask = b"\x37\xfa\x21\x3d"
    return bytes([0x80 | opcode, 0x80 | len(payload)]) + mask + bytes(byte ^ mask[k & 3] for k, byte in enumerate(payload))


def made():
    """Target -> files where the project has no real ones: what the standards print."""
    sacn = struct.pack(">HH12sHI16sHI64sBHBBH", 16, 0, b"ASC-E1.17\0\0\0", 0x7000 | 620, 4, b"c" * 16, 0x7000 | 598, 2, b"desk", 100, 0, 1, 0, 1)
    sacn += struct.pack(">HBBHHH", 0x7000 | 523, 2, 0xA1, 0, 1, 513) + b"\0" + bytes(range(256)) * 2
    artnet = b"Art-Net\0" + struct.pack("<H", 0x5000) + bytes([0, 14, 1, 0, 0, 0, 2, 0]) + bytes(range(256)) * 2
    join = b'{"Type":"MVR_JOIN","Provider":"P","StationName":"S","StationUUID":"u","Commits":[{"FileUUID":"f","FileName":"a.mvr"}]}'
    return {
        "sacn": [behind_sizes([sacn, sacn[:126]])], "artnet": [behind_sizes([artnet])],
        "psn": [bytes.fromhex("556714800000040001000000010008800300048000000400") + bytes(12)],
        "osc": [b"/ghost/cue\0\0,s\0\0next\0\0\0\0", b"#bundle\0" + bytes(8) + struct.pack(">I", 8) + b"/a\0\0,\0\0\0"],
        "rdm": [bytes.fromhex("4172742d4e6574000083000e01000000000000000000000001187ff0000000017a700000000107010000002000600003c8"),
                bytes.fromhex("4172742d4e6574000080000e00000000000000000000000100")],
        "http": [b"GET /a/main.js HTTP/1.1\r\nHost: localhost:8010\r\nAccept: */*\r\n\r\n",
                 b"POST /pair HTTP/1.1\r\nHost: localhost:8010\r\nOrigin: http://localhost:8010\r\nContent-Type: application/json\r\n"
                 b'Content-Length: 17\r\n\r\n{"code":"123456"}',
                 b"GET /live HTTP/1.1\r\nHost: localhost:8010\r\nOrigin: http://localhost:8010\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                 b"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
                 b"Sec-WebSocket-Protocol: ghostlight.1, t.0123456789abcdef0123456789abcdef\r\n\r\n"],
        "websocket": [masked(1, b'{"type":"watch","width":854,"calm":false}') + masked(2, bytes([1, 7, 0, 0, 0])) + masked(9, b"there?"),
                      masked(1, b'{"type":"watch","width":640,"calm":true,"camera":"house","probe":[0.5,0.25]}'),
                      masked(1, b'{"type":"watch","width":9,"calm":false,"own":{"position_m":[0,-9,2],"target_m":[0,0,1],"fov_y_deg":40}}'),
                      masked(1, b'{"type":"do","n":1,"what":"look","args":["Verse",2.5,true]}') + masked(1, b'{"type":"pictures","on":true}'),
                      masked(1, b'{"type":"explain","fixture":3}') + masked(1, b'{"type":"ping","t":1.5e3}') + masked(8, bytes([3, 232]))],
        "mdns": [bytes.fromhex("000084000000000100000000") + b"\x04_mvr\x04_tcp\x05local\0" + bytes.fromhex("000c000100000078000461616161")],
        "midi": [bytes.fromhex("0ff100f110f120f130f140f150f160f170f07f7f01010203040506f7")],
        "ltc": [b"".join(b"\x0c\x0c" if bit == "1" else b"\x18" for frame in range(4) for bit in f"{frame:04b}"[::-1] + "0" * 60 + "0011111111111101")],
        "usb_pro": [b"\x7e\x05\x03\x00\x00\x01\x02\xe7"],
        "xchange": [b"\x07" + struct.pack(">IIIIIQ", 778682, 1, 0, 1, 0, len(join)) + join],
        "merge": [bytes(8) + bytes([10, 15, 0, 0, 1, k, 100, 255]) * 3 + bytes([10, 4, 0, 0, 0, 0, 0, 0]) for k in range(3)],
        "model": [OBJ, GLTF], "gltf_pack": [GLTF], "model_wire": [struct.pack("<QQQQQQ", 1, 0, 0, 0, 0, 0)],
        "photometric": [b"IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n1000 0\n"],
        "picture": [b"<svg viewBox='0 0 9 9'><path d='M0 0L9 0A4 4 0 0 1 9 9z' fill='#fff'/></svg>"],
        "capture": [bytes.fromhex("d4c3b2a1020004000000000000000000ffff000001000000") + bytes(60)],
        "passes": [b'{"format":1,"width":4,"height":4,"folder":"a","lights":[]}'],
        "book": [BOOK, DIFFERENCE],
    }


def main():
    out = pathlib.Path(sys.argv[1])
    most = int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000
    chance = random.Random(24)
    shared = ROOT.parent / "shared"
    folders = [ROOT / "assets", ROOT / "tests", shared / "fixtures", shared / "reference"]
    files = sorted(path for folder in folders if folder.is_dir() for path in folder.rglob("*") if path.is_file() and path.stat().st_size <= most)
    extra = made()
    targets = sorted(path.stem.removesuffix("_fuzz") for path in (ROOT / "tests/fuzz").glob("*_fuzz.cpp"))
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

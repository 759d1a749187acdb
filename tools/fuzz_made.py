#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""For fuzz_seeds.py: files that the project does not hold, made as the standards and docs/reference print them: packets, messages,
captures, recordings, pictures of a bake, small films (where ffmpeg is installed)."""
import gzip
import json
import pathlib
import shutil
import struct
import subprocess
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
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
MVR = """<GeneralSceneDescription verMajor="1" verMinor="6" provider="P" providerVersion="1"><Scene><AUXData><Class uuid="c" name="Lights"/>
<Symdef uuid="s" name="Bay"><ChildList><Geometry3D fileName="a.obj"><Matrix>{1,0,0}{0,1,0}{0,0,1}{0,0,500}</Matrix></Geometry3D></ChildList></Symdef>
<Position uuid="p" name="Truss 1"/></AUXData><Layers><Layer uuid="l" name="Stage"><ChildList>
<GroupObject uuid="g" name="Rig"><Matrix>{1,0,0}{0,1,0}{0,0,1}{0,0,6000}</Matrix><ChildList>
<Fixture uuid="1" name="Spot 1"><Matrix>{1,0,0}{0,1,0}{0,0,1}{1000,0,0}</Matrix><GDTFSpec>Vari-Lite@VL2500_Spot.gdtf</GDTFSpec><GDTFMode>Standard</GDTFMode>
<Addresses><Address break="0">41</Address></Addresses><FixtureID>1</FixtureID><UnitNumber>1</UnitNumber><Color>0.3,0.3,50</Color><Focus>f</Focus>
<Position>p</Position><Classing>c</Classing></Fixture></ChildList></GroupObject>
<Truss uuid="t" name="Truss"><Geometries><Symbol uuid="y" symdef="s"/></Geometries><ChildList><Support uuid="h" name="Hoist"/></ChildList></Truss>
<SceneObject uuid="o" name="Deck"><Classing>c</Classing><Geometries><Geometry3D fileName="a.obj"/></Geometries></SceneObject>
<FocusPoint uuid="f" name="Middle"><Matrix>{1,0,0}{0,1,0}{0,0,1}{0,9000,1000}</Matrix></FocusPoint>
<VideoScreen uuid="v" name="Wall"><Geometries><Geometry3D fileName="a.obj"/></Geometries></VideoScreen>
<Projector uuid="j" name="Beamer"/></ChildList></Layer></Layers></Scene></GeneralSceneDescription>""".encode()
LDT = ("Maker\n1\n2\n4\n90\n3\n45\nreport\nLantern\n7\nfile\ndate\n" + "100\n" * 11 + "1,0\n0\n1\n1\nlamp\n2000\n3200\n1A\n1000\n" + "0.5\n" * 10 +
       "0\n90\n180\n270\n0\n45\n90\n" + "1\n" * 9).encode()  # EULUMDAT
TOML = b"""# whose show
[show] # here
name = "Fuzz"
plot = 'a.mvr'

[haze]
preset = "light" # thin

[[hazer]]
position_m = [0, 0, 0]

[[camera]]
name = "house"
position_m = [
    0, -10, # far
    2]
target_m = [0, 0, 2]

# a spot
[[fixture]]
name = "Spot 1"
gdtf = "a.gdtf"
universe = 1
address = 1
# up there
position_m = [0, 0, 6]

[[cue]]
name = "Verse"
at_s = 1.5
notes = """
# no comment
"""

[[palette]]
name = "Centre"
kind = "position"
pan_deg = 10
[palette.fixtures]
"Spot 1" = { tilt_deg = 20 }

[[object]]
name = "Deck"
move_m = [0, 0, 1]
"""


def behind_sizes(packets):
    """As tests/fuzz/network/network_fuzz.h reads them."""
    return b"".join(struct.pack(">HBB", len(packet), 1, k & 3) + packet for k, packet in enumerate(packets))


def masked(opcode, payload):
    """A frame of a browser, WebSocket."""
    mask = b"\x37\xfa\x21\x3d"
    return bytes([0x80 | opcode, 0x80 | len(payload)]) + mask + bytes(byte ^ mask[k & 3] for k, byte in enumerate(payload))


def udp_frame(port, payload):
    udp = struct.pack(">HHHH", port, port, 8 + len(payload), 0) + payload
    ip = struct.pack(">BBHHHBBHII", 0x45, 0, 20 + len(udp), 0, 0, 64, 17, 0, 0x0A000005, 0xEFFF0001)
    return bytes(12) + b"\x08\0" + ip + udp


def pcap(frames):
    out = bytes.fromhex("d4c3b2a1020004000000000000000000ffff000001000000")
    return out + b"".join(struct.pack("<IIII", 1700000000, 25000 * k, len(frame), len(frame)) + frame for k, frame in enumerate(frames))


def pcapng(frames):
    def block(kind, body):
        body += bytes(-len(body) % 4)
        return struct.pack("<II", kind, 12 + len(body)) + body + struct.pack("<I", 12 + len(body))
    out = block(0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1)) + block(1, struct.pack("<HHI", 1, 0, 65535))
    return out + b"".join(block(6, struct.pack("<IIIII", 0, 0x60A24, 25000 * k, len(frame), len(frame)) + frame) for k, frame in enumerate(frames))


def varint(number):
    out = b""
    while number >= 0x80:
        out, number = out + bytes([number & 0x7F | 0x80]), number >> 7
    return out + bytes([number])


def ghostdmx_block():
    """Unpacked: a key without universes, then frames of two."""
    frames = b""
    for k in range(20):
        universe = 1 + k % 2
        frames += varint(25000) + varint(universe << 2 | (2 if k < 2 else 0)) + (varint(512) if k < 2 else b"")
        frames += varint(2) + varint(0) + varint(3) + b"\x05\x05\x05" + varint(40) + varint(1) + b"\xff"
    return varint(0) + frames


def ghostdmx(unpacked, frames):
    """docs/reference/recording.md; its zstd stream is one block that is stored as it is."""
    def piece(kind, content, count, end):
        summed = struct.pack("<IIIQ", kind, len(content), count, end) + content
        return struct.pack("<II", 0x784D4447, zlib.crc32(summed)) + summed
    head = b"\x89GDMX\r\n\x1a" + struct.pack("<IQ", 1, 1_700_000_000_000_000)
    head += struct.pack("<I", zlib.crc32(head))
    packed = b"\x28\xb5\x2f\xfd\0\x40" + struct.pack("<I", len(unpacked) << 3 | 1)[:3] + unpacked
    end = 25000 * frames
    body = piece(1, struct.pack("<QQ", 0, 0) + packed, frames, end)
    index = piece(3, varint(end) + varint(frames) + varint(1) + varint(len(head)) + varint(0) + varint(0), 0, end)
    return head + body + index + struct.pack("<Q", len(head) + len(body)) + b"GDMXend\n"


def exr(width, height, channels, texts, values):
    """Floats in lines that are not packed."""
    def attribute(name, kind, content):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<I", len(content)) + content
    names = sorted(channels)
    box = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    head = bytes.fromhex("762f3101") + struct.pack("<I", 2)
    head += attribute("channels", "chlist", b"".join(name.encode() + b"\0" + struct.pack("<iBBBBii", 2, 0, 0, 0, 0, 1, 1) for name in names) + b"\0")
    head += attribute("compression", "compression", b"\0") + attribute("dataWindow", "box2i", box) + attribute("displayWindow", "box2i", box)
    head += attribute("lineOrder", "lineOrder", b"\0") + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    head += attribute("screenWindowCenter", "v2f", bytes(8)) + attribute("screenWindowWidth", "float", struct.pack("<f", 1))
    head += b"".join(attribute(name, "string", text.encode()) for name, text in texts.items()) + b"\0"
    line_bytes = 8 + 4 * width * len(names)
    out = head + b"".join(struct.pack("<Q", len(head) + 8 * height + y * line_bytes) for y in range(height))
    for y in range(height):
        out += struct.pack("<iI", y, 4 * width * len(names))
        out += b"".join(struct.pack("<f", values(name, x, y)) for name in names for x in range(width))
    return out


def fragments(width, height):
    """Half of the lines are extra ones, of the first pixels."""
    return exr(width, height, ["X", "Y", "Z", "coverage", "pixel"], {},
               lambda name, x, y: y * width + x if name == "pixel" and y < height // 2 else x if name == "pixel" else 0.5)


def bounce():
    """The body of docs/design/bounce.md: a room of 8 sub-voxels a side, one cell, one surfel."""
    def rows(kind, *items):
        return struct.pack("<Q", len(items)) + b"".join(struct.pack("<" + kind, *item) for item in items)
    cell, surfel = (0, 0, 0, 1, 0, 0), (0, 0, -1, 0, 0, 1, 0.5, 0.5, 0.5, 1, 0, 0, 0, 4)
    level = rows("4f2I", cell) + rows("10f4I", surfel)
    links = rows("I", *[(0,)] * 14, (0,), (1,)) + rows("IHH", (0, 0x3800, 0x4000))
    parents = rows("8I8f", (0, *[0xFFFFFFFF] * 7, 1, *[0] * 7))
    grid = struct.pack("<3ff3i", -1, -1, -1, 0.25, 8, 8, 8) + rows("I", *[(0,)] * 512)
    return grid + level + level + links + links + parents + parents


def bounce_part():
    """Of links that were stopped (src/bounce/bounce_parts.h): a cell and a surfel that see each other."""
    return struct.pack("<I2I2f", 1, 0, 14, 0.5, 2) + struct.pack("<I2I2f", 1, 14, 0, 0.5, 2)


def films():
    """A tenth of a second of each kind that shows and sounds are made of."""
    if shutil.which("ffmpeg") is None:
        return []
    picture, tone = ["-f", "lavfi", "-i", "testsrc2=size=48x32:rate=25:duration=0.2"], ["-f", "lavfi", "-i", "sine=duration=0.2"]
    kinds = {"a.mp4": picture + ["-c:v", "mpeg4"], "b.mov": picture + ["-c:v", "png"], "c.avi": picture + ["-c:v", "mjpeg"], "d.mkv": picture + ["-c:v", "ffv1"],
             "e.webm": picture + ["-c:v", "libvpx"], "f.mov": picture + ["-c:v", "prores"], "g.gif": picture, "h.mp4": picture + tone + ["-c:v", "libx264"],
             "i.wav": tone, "j.wav": tone + ["-c:a", "pcm_f32le"], "k.flac": tone, "l.mp3": tone, "m.m4a": tone, "n.ogg": tone + ["-c:a", "libvorbis"], "o.png": picture + ["-frames:v", "1"],
             "p.aiff": tone, "q.mxf": picture, "r.ts": picture + tone}
    made = []
    with tempfile.TemporaryDirectory() as folder:
        for name, how in kinds.items():
            file = pathlib.Path(folder) / name
            done = subprocess.run(["ffmpeg", "-v", "quiet", "-bitexact", *how, file], stdin=subprocess.DEVNULL, check=False)
            if done.returncode == 0 and file.exists():
                made.append(file.read_bytes())
    return made


def said(*steps):
    """As tests/fuzz/network/xchange_peers_fuzz.cpp reads them: connection, what, content."""
    return b"".join(struct.pack(">BH", connection | what << 2, len(content)) + content for connection, what, content in steps)


def made():
    """Target -> files where the project has no real ones: what the standards print."""
    sacn = struct.pack(">HH12sHI16sHI64sBHBBH", 16, 0, b"ASC-E1.17\0\0\0", 0x7000 | 620, 4, b"c" * 16, 0x7000 | 598, 2, b"desk", 100, 0, 1, 0, 1)
    sacn += struct.pack(">HBBHHH", 0x7000 | 523, 2, 0xA1, 0, 1, 513) + b"\0" + bytes(range(256)) * 2
    artnet = b"Art-Net\0" + struct.pack("<H", 0x5000) + bytes([0, 14, 1, 0, 0, 0, 2, 0]) + bytes(range(256)) * 2
    frames = [udp_frame(5568, sacn), udp_frame(6454, artnet), udp_frame(5568, sacn[:126])] * 3
    exrs = [exr(4, 4, "RGB", {"ghost.key": "a"}, lambda name, x, y: x + y), exr(4, 4, "Z", {name: "a" * size for name, size in
            (("ghost.place", 9), ("ghost.stage", 32), ("ghost.key", 32), ("ghost.sees", 16))}, lambda name, x, y: x + 1), fragments(4, 4)]
    stage = json.dumps({"version": 2, "stage": "a" * 32, "also_right": ["b" * 32], "instances": [["c" * 16, 0, 0, 0, 1, 1, 1]]}).encode()
    commit = b'{"Type":"MVR_COMMIT","FileUUID":"f","StationUUID":"u","FileName":"../a.mvr","FileSize":9,"Comment":"new"}'
    answer = b'{"Type":"MVR_JOIN_RET","OK":true,"Provider":"P","StationName":"T","StationUUID":"v","Commits":[{"FileUUID":"g","StationUUID":"v"}]}'
    request = b'{"Type":"MVR_REQUEST","FileUUID":"","FromStationUUID":"u"}'
    join = b'{"Type":"MVR_JOIN","Provider":"P","StationName":"S","StationUUID":"u","Commits":[{"FileUUID":"f","FileName":"a.mvr"}]}'
    return {
        "sacn": [behind_sizes([sacn, sacn[:126]])], "artnet": [behind_sizes([artnet])],
        "psn": [bytes.fromhex("556714800000040001000000010008800300048000000400") + bytes(12)],
        "osc": [b"/ghost/cue\0\0,s\0\0next\0\0\0\0", b"#bundle\0" + bytes(8) + struct.pack(">I", 8) + b"/a\0\0,\0\0\0"],
        "rdm": [bytes.fromhex("4172742d4e6574000083000e01000000000000000000000001187ff0000000017a700000000107010000002000600003c8"),
                bytes.fromhex("4172742d4e6574000080000e00000000000000000000000100")],
        "marks": [b'\xef\xbb\xbftime,number,name,note\r\n1:23.5,12,"Solo, ""slow""",\r\n5;3;Haze;left\n# a remark\n00:00:10:12,5,,\n0:75,6\n-1,7\n9'],
        "symbol": [b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 20"><style>.a{fill:none;stroke:#000}</style><g transform="translate(2 3) rotate(9)">'
                   b'<path class="a" d="M0 0L9 9c1 2 3 4 5 6A4 4 0 0 1 9 9z"/><circle cx="4" cy="4" r="3"/><polygon points="0,0 4,1 2 7"/></g></svg>'],
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
        "photometric": [LDT, b"IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n1000 0\n"],
        "picture": [b"<svg viewBox='0 0 9 9'><path d='M0 0L9 0A4 4 0 0 1 9 9z' fill='#fff'/></svg>"],
        "xchange_peers": [said((0, 0, join), (0, 0, commit), (0, 0, request), (0, 0, b'{"Type":"MVR_LEAVE"}')),
                          said((2, 0, answer), (0, 6, b""), (3, 1, b"PK\x03\x04" + bytes(30)), (1, 0, request), (1, 5, b"")),
                          said((0, 3, join[:20]), (0, 2, b"more"), (2, 0, answer), (3, 4, b"PK\x03\x04"), (3, 5, b""), (1, 2, b"foreign"))],
        "capture": [pcap(frames), pcapng(frames)],
        "gzip": [gzip.compress(pcap(frames), mtime=0), gzip.compress(pcapng(frames), mtime=0) + gzip.compress(b"", mtime=0), pcap(frames)],
        "ghostdmx": [ghostdmx(ghostdmx_block(), 20), ghostdmx_block()], "exr": exrs,
        "baked": exrs + [stage, bytes([3, 3, 0, 0x40, 0xFF, 4]) + b"here" + bytes([0, 0, 0]) + bytes(range(16)),
                         bytes([3, 3, 1, 0xF0, 0x80]) + bytes(80), bytes([3, 3, 0, 7, 0x81, 1]) + b"k" + bytes(range(48))],
        "bounce": [bounce(), bounce_part()], "film": films(), "mvr": [MVR], "plot_show": [MVR],
        "toml_edit": [bytes([4 * k, 0, 1, 9, 4 * k + 1, 0, 2, 9, 4 * k + 2, 0, 4, 9, 4 * k + 3, 0, 5, 9]) + text
                      for k, text in enumerate([TOML] * 6 + [path.read_bytes() for path in sorted((ROOT / "assets").rglob("show.toml"))])],
        "passes": [b'{"format":1,"width":4,"height":4,"folder":"a","lights":[]}'],
        "book": [BOOK, DIFFERENCE],
    }

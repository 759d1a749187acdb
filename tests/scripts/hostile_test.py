#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What files that mean harm cost: `ghostlight check` on each, its peak memory against a stated limit, and what it must say.
Usage: hostile_test.py SOURCE_FOLDER BUILD_FOLDER [WORDS]; WORDS: only the cases whose name has them. It prints the table of
docs/guide/import-doctor.md."""
import io
import json
import os
import pathlib
import resource
import struct
import subprocess
import sys
import tempfile
import time
import zipfile
import zlib

from lib import needs

needs.packages("python3-pil")
from PIL import Image  # noqa: E402

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
WORDS = sys.argv[3] if len(sys.argv) > 3 else ""
MB = 1 << 20
SEVERAL = 8 * 1024 * MB  # of address space: what asks for more is stopped before it takes the machine down

GDTF = """<GDTF DataVersion="1.2"><FixtureType Name="N" Manufacturer="M"><Wheels>{wheels}</Wheels><Models>{models}</Models>
<Geometries><Geometry Name="Base"><Beam Name="Beam"/></Geometry></Geometries><DMXModes>{modes}</DMXModes></FixtureType></GDTF>"""
MODE = """<DMXMode Name="M{}" Geometry="Base"><DMXChannels><DMXChannel Offset="1" Geometry="Beam"><LogicalChannel Attribute="Dimmer">
<ChannelFunction Attribute="Dimmer"/></LogicalChannel></DMXChannel></DMXChannels></DMXMode>"""
PLOT = """<GeneralSceneDescription verMajor="1" verMinor="6"><Scene><Layers><Layer name="L" uuid="1"><ChildList>{}</ChildList></Layer></Layers>
</Scene></GeneralSceneDescription>"""
OBJECT = '<SceneObject uuid="{0:032X}" name="O{0}"><Geometries><Geometry3D fileName="{1}"/></Geometries></SceneObject>'
LAUGHS = '<!DOCTYPE a [<!ENTITY a "ha">' + "".join(f'<!ENTITY {chr(98 + k)} "{("&" + chr(97 + k) + ";") * 10}">' for k in range(9)) + "]>"


class Zeros:
    """Stands for `size` bytes of a filler, packed without being made."""

    def __init__(self, size, filler=b"\0", before=b"", after=b""):
        self.size, self.filler, self.before, self.after = size, filler, before, after

    def write_to(self, out):
        block = self.filler * (MB // len(self.filler))
        out.write(self.before)
        for _ in range(self.size // MB):
            out.write(block)
        out.write(self.after)


def pack(path, members, method=zipfile.ZIP_DEFLATED):
    with zipfile.ZipFile(path, "w", method) as archive:
        for name, data in members:
            if isinstance(data, Zeros):
                with archive.open(name, "w", force_zip64=True) as out:
                    data.write_to(out)
            else:
                archive.writestr(name, data)
    return path


def gdtf(path, wheels="", models="", modes=MODE.format(0), extra=(), method=zipfile.ZIP_STORED):
    return pack(path, [("description.xml", GDTF.format(wheels=wheels, models=models, modes=modes)), *extra], method)


def mvr(path, extra, objects=None, method=zipfile.ZIP_STORED):
    objects = objects or "".join(OBJECT.format(k + 1, name) for k, (name, _) in enumerate(extra))
    return pack(path, [("GeneralSceneDescription.xml", PLOT.format(objects)), *extra], method)


def text(path, words, zeros=None):
    """A file of its own."""
    path.parent.mkdir(exist_ok=True)
    with open(path, "wb") as out:
        out.write(words.encode())
        if zeros:
            zeros.write_to(out)
    return path


def png(width, height, bits=8, colour=6, data=None, rows=None):
    """rows: of the picture that are there; data: instead of them."""
    row = 1 + (width * bits * {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[colour] + 7) // 8
    packer = zlib.compressobj(1)
    packed = bytearray()
    if data is None:
        left = row * (height if rows is None else rows)
        zeros = bytes(MB)
        while left > 0:
            packed += packer.compress(zeros[: min(left, MB)])
            left -= MB
    else:
        for _ in range(data // MB):
            packed += packer.compress(bytes(MB))
    packed += packer.flush()
    chunk = lambda kind, body: struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, bits, colour, 0, 0, 0)) + chunk(b"IDAT", bytes(packed))
            + chunk(b"IEND", b""))


def jpeg(width, height, progressive=False):
    """Of one grey, without an end of its data."""
    out = io.BytesIO()
    Image.new("RGB", (16, 16), (90, 40, 20)).save(out, "JPEG", progressive=progressive, subsampling=0)
    data = bytearray(out.getvalue())
    at = data.find(b"\xff\xc2" if progressive else b"\xff\xc0")
    data[at + 5:at + 9] = struct.pack(">HH", height, width)
    return bytes(data)


def glb(document, binary=b""):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    if binary:
        chunks += struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


def triangle(meshes=1, count=3, sparse=False, textures=(), at=0):
    """A model of `meshes` meshes that share `count` vertices; textures: their bytes, one material each."""
    positions = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0) * (1 if sparse else count // 3)
    views = [{"buffer": 0, "byteOffset": 0, "byteLength": len(positions)}]
    binary = positions
    images = []
    for picture in textures:
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(picture)})
        images.append({"bufferView": len(views) - 1, "mimeType": "image/png"})
        binary += picture + b"\0" * (-len(picture) % 4)
    accessor = {"componentType": 5126, "type": "VEC3", "count": count, "min": [0, 0, 0], "max": [1, 1, 0]}
    if sparse:
        binary += struct.pack("<HHI", 0, 1, 0)
        views.append({"buffer": 0, "byteOffset": len(binary) - 8, "byteLength": 4})
        accessor["sparse"] = {"count": 2, "indices": {"bufferView": len(views) - 1, "componentType": 5123}, "values": {"bufferView": 0}}
    else:
        accessor["bufferView"] = 0
    primitive = {"attributes": {"POSITION": 0}}
    primitives = [{**primitive, "material": k} for k in range(len(images))] or [primitive]
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(meshes))}], "nodes": [{"mesh": k} for k in range(meshes)],
                "meshes": [{"primitives": primitives}] * meshes, "accessors": [accessor], "bufferViews": views,
                "buffers": [{"byteLength": len(binary)}]}
    if images:
        document |= {"images": images, "textures": [{"source": k} for k in range(len(images))],
                     "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": k}}} for k in range(len(images))]}
    return glb(document, binary)


def chunk_3ds(kind, *inside):
    body = b"".join(inside)
    return struct.pack("<HI", kind, 6 + len(body)) + body


def overlapping(path, count, size):
    """A zip whose `count` entries are all the same data (as the bomb of David Fifield, 2019, in its plain form)."""
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    data = packer.compress(bytes(size)) + packer.flush()
    head = lambda name: struct.pack("<HHHHHIIIHH", 20, 0, 8, 0, 0x21, zlib.crc32(bytes(size)), len(data), size, len(name), 0)
    name = b"a"
    body = b"PK\3\4" + head(name) + name + data
    slots = "".join(SLOT.format(k) for k in range(count))
    description = GDTF.format(modes=MODE.format(0), models="", wheels=WHEEL.format(slots)).encode()
    xml_head = struct.pack("<HHHHHIIIHH", 20, 0, 0, 0, 0x21, zlib.crc32(description), len(description), len(description), 15, 0)
    xml_at = len(body)
    body += b"PK\3\4" + xml_head + b"description.xml" + description
    directory = b"PK\1\2" + struct.pack("<H", 20) + xml_head + struct.pack("<HHHII", 0, 0, 0, 0, xml_at) + b"description.xml"
    for k in range(count):
        entry = f"wheels/{k}.png".encode()
        directory += b"PK\1\2" + struct.pack("<H", 20) + head(entry) + struct.pack("<HHHII", 0, 0, 0, 0, 0) + entry
    path.write_bytes(body + directory + b"PK\5\6" + struct.pack("<HHHHIIH", 0, 0, count + 1, count + 1, len(directory), len(body), 0))
    return path


def lying(path, name, size):
    """An entry that says it has 100 bytes."""
    pack(path, [("description.xml", GDTF.format(modes=MODE.format(0), models="", wheels='<Wheel Name="W"><Slot Name="S" MediaFileName="a"/></Wheel>')),
                (name, bytes(size))])
    data = bytearray(path.read_bytes())
    directory = data.rfind(b"PK\1\2")
    data[directory + 24:directory + 28] = struct.pack("<I", 100)
    local = data.find(b"PK\3\4", 10)
    data[local + 22:local + 26] = struct.pack("<I", 100)
    path.write_bytes(data)
    return path


WHEEL = '<Wheel Name="W">{}</Wheel>'
SLOT = '<Slot Name="S{0}" MediaFileName="{0}"/>'
BODY = '<Model Name="Body" Length="1" Width="1" Height="1" File="body"/>'
QXF = """<?xml version="1.0"?>{}<FixtureDefinition xmlns="http://www.qlcplus.org/FixtureDefinition"><Manufacturer>M</Manufacturer><Model>N</Model>
<Type>Moving Head</Type><Channel Name="G"><Group Byte="0">Gobo</Group><Capability Min="0" Max="255" Preset="GoboMacro" Res1="{}">a</Capability></Channel>
<Mode Name="m"><Channel Number="0">G</Channel></Mode></FixtureDefinition>"""


def wheel(path, *members, name="a", method=zipfile.ZIP_STORED):
    return gdtf(path, WHEEL.format(SLOT.format(name)), extra=members, method=method)


def model(path, data, name="a.glb", method=zipfile.ZIP_STORED):
    return mvr(path, [(name, data)], method=method)


def qxf(path, picture, head=""):
    return text(path, QXF.format(head, picture))


TEXTURES = "export the model again, with its textures"
LARGEST = "at most 16384 a side and 134217728 in all are allowed"


# Each: name, what makes the file, limit in MB, what must be said.
def pictures(at):
    yield "gobo, PNG of 60,000 x 60,000", lambda: wheel(at / "a.gdtf", ("wheels/a.png", png(60000, 60000, 1, 0))), 96, "at most 4096 x 4096 pixels"
    yield "gobo, JPEG of 60,000 x 60,000", lambda: wheel(at / "b.gdtf", ("wheels/a.jpg", jpeg(60000, 60000)), name="a.jpg"), 96, "expected a PNG of at most 4096 x 4096 pixels"
    yield "texture, PNG of 60,000 x 60,000", lambda: model(at / "c.mvr", triangle(textures=[png(60000, 60000, 1, 0)])), 96, LARGEST
    yield "texture, JPEG of 60,000 x 60,000", lambda: model(at / "d.mvr", triangle(textures=[jpeg(60000, 60000)])), 96, LARGEST
    yield "texture, PNG of 16,384 x 16,384", lambda: model(at / "e.mvr", triangle(textures=[png(16384, 16384, rows=100)])), 96, LARGEST
    yield "texture, progressive JPEG of 16,384 x 16,384", lambda: model(at / "f.mvr", triangle(textures=[jpeg(16384, 16384, True)])), 96, LARGEST
    yield "texture, the largest that is read, 16 bits", lambda: model(at / "g.mvr", triangle(textures=[png(16384, 8192, 16)])), 1200, ""
    yield "100 textures of 8192 x 8192", lambda: model(at / "h.mvr", triangle(textures=[png(8192, 8192)] * 100)), 4400, "the textures need more than 2 GiB"
    yield "gobo, PNG of 1 x 1 that unpacks to 300 MB", lambda: wheel(at / "i.gdtf", ("wheels/a.png", png(1, 1, data=300 * MB))), 96, "Too much image data"
    yield "20 gobos of 4096 x 4096", lambda: gdtf(at / "j.gdtf", WHEEL.format("".join(SLOT.format(k) for k in range(20))), extra=[(f"wheels/{k}.png", data) for data in [png(4096, 4096)] for k in range(20)]), 640, "96 million pixels in all"
    yield "QXF, gobo of 16,384 x 8192 beside it", lambda: (at / "a.png").write_bytes(png(16384, 8192)) and qxf(at / "k.qxf", "a.png"), 96, "at most 4096 a side"
    shapes = '<svg viewBox="0 0 60000 60000" width="60000" height="60000">' + '<rect width="60000" height="60000"/>' * 100_000 + "</svg>"
    yield "QXF, SVG of 60,000 x 60,000, 100,000 shapes", lambda: text(at / "l.svg", shapes) and qxf(at / "l.qxf", "l.svg"), 96, "more than 2000 shapes"


def archives(at):
    deflate = zipfile.ZIP_DEFLATED
    yield "zip bomb, a gobo of 100 MB", lambda: wheel(at / "a.gdtf", ("wheels/a.png", Zeros(100 * MB)), method=deflate), 96, "at most 67108864 are allowed"
    yield "zip bomb, a gobo of 60 MB", lambda: wheel(at / "b.gdtf", ("wheels/a.png", Zeros(60 * MB)), method=deflate), 96, "taken for a zip bomb"
    yield "zip bomb, 4000 entries that are one", lambda: overlapping(at / "c.gdtf", 4000, 900_000), 96, "the archive unpacks to more than"
    yield "zip entry of 60 MB that claims 100 bytes", lambda: lying(at / "d.gdtf", "wheels/a.png", 60 * MB), 96, "damaged or cut short"
    yield "zip bomb, a mesh of 600 MB in a plot", lambda: model(at / "e.mvr", Zeros(600 * MB), "a.3ds", deflate), 96, "at most 536870912 are allowed"
    yield "zip bomb, 5 meshes of 200 MB in a plot", lambda: mvr(at / "f.mvr", [(f"{k}.3ds", Zeros(200 * MB)) for k in range(5)], method=deflate), 96, "taken for a zip bomb"
    yield "bzip2 entries", lambda: gdtf(at / "g.gdtf", method=zipfile.ZIP_BZIP2), 96, "zip method 12 is not supported"
    yield "70,000 entries", lambda: pack(at / "h.mvr", [(f"{k}.3ds", b"") for k in range(70_000)], zipfile.ZIP_STORED), 96, "at most 65535 are allowed"


def texts(at):
    spaces = lambda before, after: Zeros(200 * MB, b" " * 16, before, after)
    yield "XML of 200 MB, GDTF", lambda: pack(at / "a.gdtf", [("description.xml", spaces(b"<GDTF>", b"</GDTF>"))]), 96, "at most 33554432 are allowed"
    yield "XML of 200 MB, MVR", lambda: pack(at / "b.mvr", [("GeneralSceneDescription.xml", spaces(b"<G>", b"</G>"))]), 96, "at most 67108864 are allowed"
    yield "XML of 200 MB, QXF", lambda: text(at / "c.qxf", "", spaces(b"<FixtureDefinition>", b"</FixtureDefinition>")), 96, "more than the limit of 8388608"
    yield "JSON of 200 MB, Open Fixture Library", lambda: text(at / "d.json", "", spaces(b'{"categories": [], "modes": [', b"]}")), 96, "more than the limit of 4194304"
    yield "TOML of 200 MB, show file", lambda: text(at / "show" / "show.toml", "", spaces(b"[show]\n", b"name = 'a'\n")).parent, 96, "more than the limit of 16777216"
    yield "billion laughs, GDTF", lambda: pack(at / "e.gdtf", [("description.xml", LAUGHS + GDTF.format(wheels="", models="", modes="&j;" + MODE.format(0)))]), 96, "entities of the document type are left"
    yield "billion laughs, MVR", lambda: pack(at / "f.mvr", [("GeneralSceneDescription.xml", LAUGHS + PLOT.format('<SceneObject uuid="1" name="&j;"/>'))]), 96, "entities of the document type are left"
    yield "billion laughs, QXF", lambda: qxf(at / "g.qxf", "&j;", LAUGHS), 96, "entities of the document type are left"
    for kind, member, say in (("GDTF", "description.xml", "description.xml"), ("MVR", "GeneralSceneDescription.xml", "GeneralSceneDescription.xml")):
        yield f"XML of 2.8 million elements in each other, {kind}", lambda kind=kind, member=member: pack(at / f"deep.{kind.lower()}", [(member, b"<a>" * 2_800_000)], zipfile.ZIP_STORED), 512, say
    yield "10,000 modes", lambda: gdtf(at / "h.gdtf", modes="".join(MODE.format(k) for k in range(10_000))), 96, "more than 1024 modes, the rest is left out"
    yield "XML of 30 MB, more than 4 million elements", lambda: pack(at / "i.gdtf", [("description.xml", Zeros(30 * MB, b"<a b=''/><b/>\n<c/>\n\n\n\n\n\n\n\n\n\n", b"<GDTF>", b"</GDTF>"))], zipfile.ZIP_STORED), 160, "more than 4194304 elements"


def meshes(at):
    chain = [{"children": [k + 1]} for k in range(100_000)] + [{}]
    doubled = [{"children": [k + 1, k + 1]} for k in range(60)] + [{}]
    scene = lambda nodes: glb({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes})
    deep = b'{"asset":' + b"[" * 5_000_003
    yield "GLB, 500 million vertices without data", lambda: model(at / "a.mvr", triangle(count=500_000_000, sparse=True)), 96, "at most 1024 are allowed"
    yield "GLB, 10,000 meshes that share 300,000 vertices", lambda: model(at / "b.mvr", triangle(meshes=10_000, count=300_000)), 96, "at most 1024 are allowed"
    yield "GLB, the most vertices that are read: 29 million", lambda: model(at / "c.mvr", triangle(meshes=97, count=300_000)), 2600, ""
    yield "GLB, 5 million lists in each other", lambda: model(at / "d.mvr", struct.pack("<IIIII", 0x46546C67, 2, 20 + len(deep), len(deep), 0x4E4F534A) + deep), 96, "more than 128 deep"
    yield "GLB, 100,000 nodes in each other", lambda: model(at / "e.mvr", scene(chain)), 128, "more than 256 in each other"
    yield "GLB, 60 nodes, each twice in the one above", lambda: model(at / "f.mvr", scene(doubled)), 96, "more than 200000 nodes"
    keys = chunk_3ds(0x4D4D, chunk_3ds(0xB000, chunk_3ds(0xB002, chunk_3ds(0xB020, struct.pack("<10xI", 3_000_000_000)))))
    yield "3DS, a track of 3 billion keys", lambda: model(at / "g.mvr", keys, "a.3ds"), 96, "runs past the end of its chunk"
    corners = chunk_3ds(0x4110, struct.pack("<H9f", 3, 0, 0, 0, 1, 0, 0, 0, 1, 0))
    body = chunk_3ds(0x4100, corners, chunk_3ds(0x4120, struct.pack("<H4H", 1, 0, 1, 2, 0)))
    mesh = chunk_3ds(0x4D4D, chunk_3ds(0x3D3D, chunk_3ds(0x4000, b"a\0", body)))
    yield "3DS, a chunk of 2 GB in 100 bytes", lambda: model(at / "h.mvr", mesh[:8] + b"\xff\xff\xff\x7f" + mesh[12:], "a.3ds"), 96, "a 3DS chunk of 2147483647 bytes"
    nested = b"".join(struct.pack("<HI", 0x3D3D, 6 * (200_000 - k)) for k in range(200_000))
    yield "3DS, 200,000 chunks in each other", lambda: model(at / "i.mvr", chunk_3ds(0x4D4D, nested), "a.3ds"), 96, "a.3ds"
    nodes = b"".join(chunk_3ds(0xB002, chunk_3ds(0xB010, f"n{k}\0".encode() + struct.pack("<HHh", 0, 0, k - 1))) for k in range(32_000))
    tree = chunk_3ds(0x4D4D, chunk_3ds(0x3D3D, chunk_3ds(0x4000, b"n31999\0", body)), chunk_3ds(0xB000, nodes))
    yield "3DS, 32,000 nodes in each other", lambda: model(at / "j.mvr", tree, "a.3ds"), 96, "nodes more than 1000 deep"


def measured(path):
    """Exit code, words, peak in MB, seconds."""
    begun = time.monotonic()
    with tempfile.TemporaryFile() as out:
        child = subprocess.Popen([str(PROGRAM), "check", "--all", "--threads", "1", str(path)], stdout=out, stderr=out,
                                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (SEVERAL, SEVERAL)))
        _, status, usage = os.wait4(child.pid, 0)
        out.seek(0)
        words = out.read(MB).decode(errors="replace")
    return os.waitstatus_to_exitcode(status), words, usage.ru_maxrss / 1024, time.monotonic() - begun


def main():
    failed = []
    print("| input | bytes | peak, MB | limit, MB | s |\n|---|---|---|---|---|")
    for group in (pictures, archives, texts, meshes):
        with tempfile.TemporaryDirectory(prefix="ghost_hostile_") as scratch:
            for name, make, limit_mb, say in group(pathlib.Path(scratch)):
                if WORDS not in name:
                    continue
                path = make()
                size = path.stat().st_size if path.is_file() else (path / "show.toml").stat().st_size
                code, words, peak_mb, seconds = measured(path)
                print(f"| {name} | {size:,} | {peak_mb:.0f} | {limit_mb} | {seconds:.1f} |", flush=True)
                if os.environ.get("VERBOSE"):
                    print(code, words[:1500])
                for fault in ([f"exit code {code}"] if code not in (0, 1) else []) + ([f"more than {limit_mb} MB"] if peak_mb > limit_mb else []) + (
                        [f"does not say '{say}'"] if say not in words else []):
                    failed.append(f"{name}: {fault}\n{words[:600]}")
    for fault in failed:
        print("FAILED", fault)
    return 1 if failed else 0


sys.exit(main())

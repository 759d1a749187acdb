#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""tools/make_festival.py: the patch, the stage, the recording as our GDTF modes read it, same bytes twice, wrong arguments, one small
picture. Usage: festival_test.py SOURCE_FOLDER BUILD_FOLDER. Nothing but Python's own library is needed."""
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import tomllib
import unittest
import zlib

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
TOOL = SOURCE / "tools" / "make_festival.py"
FILES = ("show.toml", "stage.glb", "festival.show", "Vari-Lite@VL2500_Spot.gdtf", "Vari-Lite@VL2500_Wash.gdtf")
CHANNELS = {"Standard 22 channels": 22, "Standard 15 channels": 15}
HEAD_BELOW_M = 0.395
WORK = None   # a folder of our own


def call(*arguments):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True, timeout=600)
    done.text = done.stdout + done.stderr
    return done


def make(name, *arguments):
    done = call(sys.executable, TOOL, "--out", WORK / name, *arguments)
    assert done.returncode == 0, done.text
    return WORK / name


def show_of(folder):
    return tomllib.loads((folder / "show.toml").read_text())


def frames_of(folder):
    """[(milliseconds, universe, levels)] and the length, read by the rules of the format."""
    lines = (folder / "festival.show").read_text().splitlines()
    assert lines.pop(0) == "OLA Show"
    frames, now = [], 0
    for line in lines:
        universe, _, levels = line.partition(" ")
        if levels:
            frames.append((now, int(universe), bytes(map(int, levels.split(",")))))
        else:
            now += int(universe)
    return frames, now


def levels_at(frames, ms):
    return {universe: data for time, universe, data in frames if time <= ms}   # the last one of each stays


def lamp(entry, universes):
    """(where its head is, direction of its beam, its levels): pan about Z, then tilt about X, of a beam that falls along -Z."""
    data = universes[entry["universe"]][entry["address"] - 1:][:CHANNELS[entry["mode"]]]
    pan = math.radians((data[1] * 256 + data[2]) / 65535 * 540 - 270)
    tilt = math.radians((data[3] * 256 + data[4]) / 65535 * 270 - 135)
    d = (-math.sin(pan) * math.sin(tilt), math.cos(pan) * math.sin(tilt), -math.cos(tilt))
    x, y, z = entry["position_m"]
    if entry.get("rotation_deg") == [180, 0, 0]:
        return (x, y, z + HEAD_BELOW_M), (d[0], -d[1], -d[2]), data
    return (x, y, z - HEAD_BELOW_M), d, data


def pixels(path):
    """Red, green and blue of an 8-bit PNG."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        packed += body if kind == b"IDAT" else b""
        at += 12 + size
    step = {2: 3, 6: 4}[colour]
    assert depth == 8
    raw, stride, rows, above = zlib.decompress(packed), width * step, [], bytes(width * step)
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            a, b, c = (row[x - step], above[x], above[x - step]) if x >= step else (0, above[x], 0)
            paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            row[x] = (row[x] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255
        rows += [value for x, value in enumerate(row) if x % step < 3]
        above = row
    return rows


class Festival(unittest.TestCase):
    def check_patch(self, folder, count, moves=True):
        show = show_of(folder)
        fixtures = show["fixture"]
        self.assertEqual(len(fixtures), count)
        self.assertEqual(len({f["name"] for f in fixtures}), count)
        self.assertEqual(len({tuple(f["position_m"]) for f in fixtures}), count)
        taken = set()
        for f in fixtures:
            first, width = f["address"], CHANNELS[f["mode"]]
            self.assertLessEqual(first + width - 1, 512, f["name"])
            slots = {(f["universe"], first + i) for i in range(width)}
            self.assertFalse(taken & slots, f["name"])
            taken |= slots
        self.assertEqual({f["universe"] for f in fixtures}, set(range(1, max(f["universe"] for f in fixtures) + 1)))
        self.assertEqual([c["name"] for c in show["camera"]], ["house", "wide", "close", "side", "drone"])
        frames, length = frames_of(folder)
        self.assertEqual({u for t, u, _ in frames if t == 0}, {u for u, _ in taken}, "all universes in the first frame")
        for _, universe, data in frames:
            self.assertGreaterEqual(len(data), max(slot for u, slot in taken if u == universe))
        for universe in {u for u, _ in taken} if moves else ():
            self.assertGreater(len({data for _, u, data in frames if u == universe}), 1, "it moves")
        return frames, length

    def check_stage(self, folder):
        data = (folder / "stage.glb").read_bytes()
        self.assertLess(len(data), 15_000_000)
        size, = struct.unpack_from("<I", data, 12)
        gltf = json.loads(data[20:20 + size])
        triangles = [sum(gltf["accessors"][p["indices"]]["count"] // 3 for p in mesh["primitives"]) for mesh in gltf["meshes"]]
        waiting, drawn = list(gltf["scenes"][0]["nodes"]), 0
        while waiting:
            node = gltf["nodes"][waiting.pop()]
            waiting += node.get("children", [])
            drawn += triangles[node["mesh"]] if "mesh" in node else 0
        self.assertTrue(100_000 <= drawn <= 800_000, drawn)
        return drawn

    def test_twelve(self):
        folder = make("twelve", "--fixtures", 12)
        frames, length = self.check_patch(folder, 12)
        self.check_stage(folder)
        self.assertEqual(length, 30_000)
        times = sorted({t for t, _, _ in frames})
        self.assertLessEqual(min(b - a for a, b in zip(times, times[1:])), 40, "at least 25 frames a second")
        self.assertGreaterEqual(min(b - a for a, b in zip(times, times[1:])), 25, "at most 40 frames a second")
        done = call(PROGRAM, "check", folder)
        self.assertEqual(done.returncode, 0, done.text)
        self.assertIn("12 fixtures", done.text)

    def test_four_hundred(self):
        folder = make("many", "--fixtures", 400, "--seconds", 6)
        self.check_patch(folder, 400)
        drawn = self.check_stage(folder)
        done = call(PROGRAM, "check", folder)
        self.assertEqual(done.returncode, 0, done.text)
        self.assertIn(f"{drawn} triangles", done.text)

    def test_one_and_two_thousand(self):
        self.check_patch(make("one", "--fixtures", 1, "--seconds", 6), 1)
        self.check_patch(make("most", "--fixtures", 2000, "--seconds", 0.2), 2000, moves=False)

    def test_the_levels_say_what_the_show_means(self):
        folder = make("meaning", "--fixtures", 60)
        fixtures = show_of(folder)["fixture"]
        frames, _ = frames_of(folder)
        dark = levels_at(frames, 19_800)   # the black before the drop
        self.assertEqual({lamp(f, dark)[2][0] for f in fixtures}, {0})
        fans = levels_at(frames, 8_000)
        self.assertGreater(sum(lamp(f, fans)[2][0] > 200 for f in fixtures), 30)
        floor = [lamp(f, fans)[1] for f in fixtures if "rotation_deg" in f]
        self.assertGreater(len(floor), 5)
        for direction in floor:
            self.assertGreater(direction[2], 0.4, "from the floor into the sky")
        for x_sign in (-1, 1):   # the fan opens to its own side
            outer = [d for f, d in ((f, lamp(f, fans)[1]) for f in fixtures if "rotation_deg" in f) if f_side(f) == x_sign]
            self.assertTrue(all(d[0] * x_sign > 0 for d in outer))
        back = [lamp(f, fans)[1] for f in fixtures if "rotation_deg" not in f and f["position_m"][1] > 8 and "Spot" in f["name"]
                and abs(f["position_m"][0]) < 11.8]
        self.assertGreater(len(back), 3)
        for direction in back:
            self.assertLess(direction[1], 0, "from the back towards the house")
        front = [lamp(f, fans) for f in fixtures if f["position_m"][1] < 0.6 and "Wash" in f["name"]]
        self.assertGreater(len(front), 1)
        for head, direction, data in front:   # on the band: at breast height over the deck or the platform, inside the band's places
            self.assertGreater(data[0], 90)
            far = min((4.3 - head[2]) / direction[2], (3.2 - head[2]) / direction[2])
            hit = [p + far * d for p, d in zip(head, direction)]
            self.assertTrue(abs(hit[0]) < 5.5 and 2 < hit[1] < 10, hit)

    def test_heads_move_as_heads_can(self):
        folder = make("moving", "--fixtures", 24, "--seconds", 40)
        frames, length = frames_of(folder)
        self.assertEqual(length, 40_000)
        fixtures = show_of(folder)["fixture"]
        before, time_before = None, 0
        now = {}
        for time in sorted({t for t, _, _ in frames}):
            now = {**now, **{u: data for t, u, data in frames if t == time}}
            state = [(d[1] * 256 + d[2], d[3] * 256 + d[4]) for d in (lamp(f, now)[2] for f in fixtures)]
            if before:
                seconds = (time - time_before) / 1000
                for f, old, new in zip(fixtures, before, state):
                    pan, tilt = abs(new[0] - old[0]) / 65535 * 540, abs(new[1] - old[1]) / 65535 * 270
                    self.assertLess(max(pan, tilt) / seconds, 300, f"{f['name']} at {time} ms")
            before, time_before = state, time

    def test_same_bytes_twice_and_another_seed(self):
        one = make("first", "--fixtures", 12, "--seconds", 8, "--seed", 5)
        two = make("second", "--fixtures", 12, "--seconds", 8, "--seed", 5)
        other = make("third", "--fixtures", 12, "--seconds", 8, "--seed", 6)
        for name in FILES:
            self.assertEqual((one / name).read_bytes(), (two / name).read_bytes(), name)
        for name in ("stage.glb", "festival.show"):
            self.assertNotEqual((one / name).read_bytes(), (other / name).read_bytes(), name)
        self.assertEqual(sorted(p.name for p in one.iterdir()), sorted(FILES))

    def test_wrong_arguments(self):
        (WORK / "file").write_text("")
        for arguments, part in ((["--fixtures", "0"], "1 to 2000"), (["--fixtures", "2001"], "1 to 2000"), (["--fixtures", "many"], "'many'"),
                                (["--seconds", "0"], "0.1 to 3600"), (["--seconds", "nan"], "'nan'"), (["--seed", "-1"], "--seed"),
                                (["--fixtures", "2000", "--seconds", "3600"], "512 MiB"), (["--lamps", "4"], "--lamps")):
            done = call(sys.executable, TOOL, "--out", WORK / "never", *arguments)
            self.assertEqual(done.returncode, 2, done.text)
            self.assertIn(part, done.text)
            self.assertNotIn("Traceback", done.text)
        self.assertFalse((WORK / "never").exists())
        self.assertEqual(call(sys.executable, TOOL).returncode, 2)
        done = call(sys.executable, TOOL, "--out", WORK / "file")
        self.assertEqual(done.returncode, 2, done.text)
        self.assertIn("is a file", done.text)

    def test_a_small_picture(self):
        folder = make("picture", "--fixtures", 12, "--seconds", 20)
        means = []
        for name, at in (("fans", 8), ("black", 19.8)):
            done = call(PROGRAM, "render", folder, "-o", WORK / f"{name}.png", "--view", "wide", "--size", "96x54", "--at", at,
                        "--ev", 4)
            self.assertEqual(done.returncode, 0, done.text)
            values = pixels(WORK / f"{name}.png")
            means.append(sum(values) / len(values))
        self.assertGreater(means[0], 2 * means[1])
        self.assertGreater(means[0], 8)


def f_side(entry):
    """-1 or 1 well off the middle, else 0."""
    x = entry["position_m"][0]
    return 0 if abs(x) < 3 else int(math.copysign(1, x))


def main():
    global WORK
    if not PROGRAM.exists():
        print(f"skipped: {PROGRAM} is not built")
        return 77
    with tempfile.TemporaryDirectory(prefix="ghost_festival_") as folder:
        WORK = pathlib.Path(folder)
        suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules["__main__"])
        return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())

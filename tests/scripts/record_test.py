#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""record and play as a user has them: killed in the middle, converted, cut into parts. Usage: record_test.py
SOURCE_FOLDER BUILD_FOLDER. Sends to 127.0.0.1 on UDP ports of its own."""
import json
import pathlib
import random
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
DEMO = pathlib.Path(sys.argv[1]).resolve() / "assets" / "demo" / "demo.show"
LOOKS = 240


def run(*arguments):
    """stdout and stderr together are in .text."""
    done = subprocess.run([str(PROGRAM), *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=300)
    done.text = done.stdout + done.stderr
    return done


def free_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
        one.bind(("127.0.0.1", 0))
        return str(one.getsockname()[1])


def looks_of(path):
    """(universe, level of slot 1) of every frame of an OLA show file."""
    frames = [line.split(" ", 1) for line in path.read_text().splitlines()[1:] if " " in line]
    return [(int(universe), int(levels.split(",")[0])) for universe, levels in frames]


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=WORK))

    def fails(self, done, code, *parts):
        self.assertEqual(done.returncode, code, done.text)
        for part in parts:
            self.assertIn(part, done.text)

    def works(self, done):
        self.assertEqual(done.returncode, 0, done.text)
        return done


class Recording(Case):
    def setUp(self):
        super().setUp()
        # Slot 1 of three universes counts 1 to 240, a step each 50 ms: nothing may be left out between two.
        lines = ["OLA Show"]
        for look in range(1, LOOKS + 1):
            for universe in (1, 2, 3):
                lines += [f"{universe} {look},{255 - look},{universe}", "50" if universe == 3 else "0"]
        self.show = self.folder / "count.show"
        self.show.write_text("\n".join(lines) + "\n")
        self.port = free_port()
        self.desk = subprocess.Popen([str(PROGRAM), "play", str(self.show), "--to", "127.0.0.1", "--sacn-port", self.port, "--loop", "--quiet"])
        self.addCleanup(self.stop, self.desk)

    @staticmethod
    def stop(process):
        process.kill()
        process.wait()

    def record(self, name, *more):
        path = self.folder / name
        recorder = subprocess.Popen([str(PROGRAM), "record", "-o", str(path), "--protocols", "sacn", "--sacn-port", self.port,
                                     "--interface", "127.0.0.1", "--universes", "1-3", *more],
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.stop, recorder)
        return recorder, path

    def wait_for_bytes(self, path, count):
        end = time.monotonic() + 120
        while time.monotonic() < end:
            if path.exists() and path.stat().st_size >= count:
                return
            time.sleep(0.01)
        self.fail(f"{path} did not grow to {count} bytes")

    def counts_without_gaps(self, path, least):
        out = self.folder / "out.show"
        done = self.works(run("play", path, "-o", out))
        looks = looks_of(out)
        for universe in (1, 2, 3):
            counts = [level for number, level in looks if number == universe]
            self.assertGreaterEqual(len(counts), least)
            for before, after in zip(counts, counts[1:]):
                self.assertEqual(after, before % LOOKS + 1)
        return done

    def test_killed_at_any_moment_what_was_recorded_plays(self):
        chance = random.Random(3)
        for attempt in range(4):
            recorder, path = self.record(f"killed{attempt}.ghostdmx")
            part = path.with_name(path.name + ".part")
            self.wait_for_bytes(part, chance.randrange(300, 3000))
            recorder.send_signal(signal.SIGKILL)
            recorder.communicate()
            self.assertFalse(path.exists())
            done = self.counts_without_gaps(part, 2)
            self.assertIn("was not finished", done.text)
            self.assertIn("0 bytes behind that are no whole piece", done.text)
            print(f"killed with {part.stat().st_size} bytes written:", done.stderr.splitlines()[-1])

    def test_an_ended_one_is_whole(self):
        recorder, path = self.record("whole.ghostdmx", "--json")
        self.wait_for_bytes(path.with_name(path.name + ".part"), 1500)
        recorder.send_signal(signal.SIGINT)
        stdout, stderr = recorder.communicate(timeout=60)
        self.assertEqual(recorder.returncode, 0, stderr)
        report = json.loads(stdout)
        self.assertEqual(report["bytes"], path.stat().st_size)
        self.assertEqual((report["frames_lost"], report["missed"]), (0, 0))
        done = self.counts_without_gaps(path, 3)
        self.assertNotIn("warning", done.text)
        self.assertFalse(path.with_name(path.name + ".part").exists())


class Playing(Case):
    def test_there_and_back_is_the_same(self):
        packed, text = self.folder / "demo.ghostdmx", self.folder / "demo.show"
        report = json.loads(self.works(run("play", DEMO, "-o", packed, "--json", "--quiet")).stdout)
        self.assertEqual(report["bytes"], packed.stat().st_size)
        self.works(run("play", packed, "-o", text))
        self.assertEqual(text.read_bytes(), DEMO.read_bytes())
        print(f"demo.show: {DEMO.stat().st_size} bytes as text, {packed.stat().st_size} packed")

    def test_a_part_at_another_speed(self):
        show = self.folder / "a.show"
        show.write_text("OLA Show\n1 1\n1000\n1 2\n1000\n2 3\n1000\n1 4\n1000\n")
        out = self.folder / "b.show"
        self.works(run("play", show, "--from", "1.5", "--until", "3", "-o", out))
        self.assertEqual(out.read_text(), "OLA Show\n1 2\n500\n2 3\n1000\n1 4\n0\n")
        self.works(run("play", show, "--from", "1.5", "--until", "3", "--speed", "2", "-o", out))
        self.assertEqual(out.read_text(), "OLA Show\n1 2\n250\n2 3\n500\n1 4\n0\n")
        packed = self.folder / "a.ghostdmx"
        self.works(run("play", show, "-o", packed))
        self.works(run("play", packed, "--from", "1.5", "--until", "3", "-o", out))
        self.assertEqual(out.read_text(), "OLA Show\n1 2\n500\n2 3\n1000\n1 4\n0\n")

    def test_speed_is_that_of_sending(self):
        show = self.folder / "a.show"
        show.write_text("OLA Show\n1 1\n20000\n1 2\n0\n")
        arguments = ("play", show, "--to", "127.0.0.1", "--sacn-port", free_port(), "--rate", "50", "--speed", "100", "--json")
        report = json.loads(self.works(run(*arguments)).stdout)
        self.assertEqual((report["seconds"], report["packets"]), (20.0, 11))

    def test_wrong_usage(self):
        out = self.folder / "out.ghostdmx"
        self.fails(run("play", DEMO, "-o", out, "--to", "127.0.0.1"), 2, "--to")
        self.fails(run("play", DEMO, "-o", out, "--loop"), 2, "--loop")
        self.fails(run("play", DEMO, "-o", out, "--speed", "0"), 2, "--speed")
        self.fails(run("play", DEMO, "-o", out, "--speed", "nan"), 2, "--speed")
        self.fails(run("play", DEMO, "-o", out, "--from", "5", "--until", "3"), 2, "--until")
        self.fails(run("play", DEMO, "-o", self.folder / "out.wav"), 1, "out.wav", ".ghostdmx")
        self.fails(run("play", DEMO, "-o", out, "--from", "4000"), 1, "--from", "demo.show")
        self.fails(run("play", PROGRAM, "-o", out), 1, "expected one of Ghostlight", "pcap")
        self.fails(run("record", "-o", self.folder / "out.wav"), 1, "out.wav", ".show")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_damage_is_said_and_the_rest_plays(self):
        # Noise, so that it has three blocks; what is damaged is in the middle.
        chance = random.Random(4)
        looks = [",".join(map(str, chance.choices(range(256), k=512))) for _ in range(1200)]
        show, packed, out = self.folder / "noise.show", self.folder / "noise.ghostdmx", self.folder / "out.show"
        show.write_text("OLA Show\n" + "".join(f"1 {look}\n25\n" for look in looks))
        self.works(run("play", show, "-o", packed))
        data = bytearray(packed.read_bytes())
        data[len(data) // 2] ^= 1
        packed.write_bytes(data)
        done = self.works(run("play", packed, "-o", out))
        self.assertIn("noise.ghostdmx, byte ", done.text)
        self.assertIn("the levels stand still", done.text)
        left = out.read_text().splitlines()
        self.assertTrue(f"1 {looks[0]}" in left and f"1 {looks[-1]}" in left and f"1 {looks[600]}" not in left)

    def test_what_is_damaged_as_a_whole_is_an_error(self):
        show, packed, out = self.folder / "a.show", self.folder / "a.ghostdmx", self.folder / "out.show"
        show.write_text("OLA Show\n1 1\n100\n1 2\n100\n")
        self.works(run("play", show, "-o", packed))
        data = bytearray(packed.read_bytes())
        data[28 + 28 + 20] ^= 1  # behind the header and that of the only block
        packed.write_bytes(data)
        self.fails(run("play", packed, "-o", out), 1, "a.ghostdmx: nothing of it can be read")
        self.assertFalse(out.exists())
        self.fails(run("play", packed, "--to", "127.0.0.1", "--sacn-port", free_port()), 1, "a.ghostdmx: nothing of it can be read")

    def test_one_port_for_two_protocols(self):
        self.fails(run("play", DEMO, "--to", "127.0.0.1", "--sacn-port", "6454"), 2, "--sacn-port", "6454", "two ports")
        self.fails(run("monitor", "--artnet-port", "5568", "--seconds", "1"), 2, "--artnet-port", "5568", "two ports")
        self.fails(run("monitor", "--artnet-offset", "40000", "--universes", "1-4", "--seconds", "1"), 2, "--artnet-offset", "Port-Addresses")


class Storm(Case):
    def test_universes_nobody_asked_for_take_no_place_of_those_that_were(self):
        port, path = free_port(), self.folder / "storm.ghostdmx"
        recorder = subprocess.Popen([str(PROGRAM), "record", "-o", str(path), "--protocols", "sacn", "--sacn-port", port,
                                     "--interface", "127.0.0.1", "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: (recorder.kill(), recorder.wait()))
        out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

        def send(universe, level, sequence):
            packet = struct.pack(">HH", 0x10, 0) + b"ASC-E1.17\0\0\0" + struct.pack(">HI", 0x706F, 4) + bytes(range(16))
            packet += struct.pack(">HI", 0x7059, 2) + b"Storm".ljust(64, b"\0") + bytes([100, 0, 0, sequence & 255, 0])
            packet += struct.pack(">HH", universe, 0x700C) + bytes([2, 0xA1, 0, 0, 0, 1, 0, 2, 0, level])
            out.sendto(packet, ("127.0.0.1", int(port)))

        time.sleep(1.5)
        for turn in range(2):  # 4600 universes that nobody asked for, then one of 1 to 64
            for universe in range(100, 4700):
                send(universe, 1 + turn, turn)
                if universe % 50 == 0:
                    time.sleep(0.005)
        for sequence in range(60):
            send(7, 100 + sequence, sequence)
            time.sleep(0.025)
        recorder.send_signal(signal.SIGINT)
        text, said = recorder.communicate(timeout=60)
        self.assertEqual(recorder.returncode, 0, said)
        self.assertIn("--universes", said)
        report = json.loads(text)
        self.assertEqual(report["frames_lost"], 0)
        shown = self.folder / "storm.show"
        self.works(run("play", path, "-o", shown))
        looks = looks_of(shown)
        universes = {universe for universe, _ in looks}
        self.assertIn((7, 159), looks)
        self.assertGreater(len([1 for universe, _ in looks if universe == 7]), 30)
        self.assertEqual(len(universes), 4096 - 63, "those of 1 to 64 have a place that nobody else takes")
        self.assertGreater(report["universes_left_out"], 0)
        print(f"{len(universes)} universes recorded, {report['universes_left_out']} left out")


def main():
    global WORK
    if not PROGRAM.exists():
        print(f"skipped: {PROGRAM} is not built")
        return 77
    with tempfile.TemporaryDirectory(prefix="ghost_record_") as folder:
        WORK = pathlib.Path(folder)
        suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules["__main__"])
        return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""play --timecode --midi: what is sent belongs to the MIDI time code that comes by a port: quarter frames run, stand and go back, a full
frame jumps, and a port that was pulled out is opened again. The port is a pseudo-terminal. Usage: midi_test.py SOURCE_FOLDER
BUILD_FOLDER. On 127.0.0.1, at UDP ports of its own."""
import json
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import threading
import time
import tty

PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
BEGIN_S = 36000  # 10:00:00:00
EBU = 1


class Port:
    """A MIDI port that is at `link`, as a device file is."""

    def __init__(self, link):
        self.master, self.slave = os.openpty()
        tty.setraw(self.master)
        link.unlink(missing_ok=True)
        link.symlink_to(os.ttyname(self.slave))

    def send(self, *data):
        os.write(self.master, bytes(data))

    def pull_out(self):
        os.close(self.slave)
        os.close(self.master)

    @staticmethod
    def fields(frame):
        second = frame // 25
        return frame % 25, second % 60, second // 60 % 60, second // 3600

    def run(self, at_s, frames, direction=1):
        """Quarter frames, 10 ms each, with a clock and a note between them. frames: even."""
        frame = round((BEGIN_S + at_s) * 25)
        start = time.monotonic()
        for quarter in range(4 * frames):
            time.sleep(max(0.0, start + quarter * 0.01 - time.monotonic()))
            f, s, m, h = self.fields(frame + direction * 2 * (quarter // 8))
            nibbles = [f & 15, f >> 4, s & 15, s >> 4, m & 15, m >> 4, h & 15, h >> 4 | EBU << 1]
            piece = quarter % 8 if direction > 0 else 7 - quarter % 8
            self.send(0xF1, piece << 4 | nibbles[piece], 0xF8)
            if quarter % 16 == 5:
                self.send(0x90, 60, 100)
        return time.monotonic()

    def locate(self, at_s):
        f, s, m, h = self.fields(round((BEGIN_S + at_s) * 25))
        self.send(0xF0, 0x7F, 0x7F, 1, 1, EBU << 5 | h, m, s, f, 0xF7)


class Levels:
    """(time, level of slot 1) of what is played; a level is a tenth of a second of the recording."""

    def __init__(self):
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.list = []
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        while True:
            data = self.socket.recv(2048)
            if len(data) > 126 and not data[112] & 0x40:
                self.list.append((time.monotonic(), data[126]))

    def soon(self, level, limit_s=5):
        end = time.monotonic() + limit_s
        while time.monotonic() < end:
            if self.list and abs(self.list[-1][1] - level) <= 1:
                return
            time.sleep(0.02)
        raise AssertionError((level, self.list[-5:]))


def start(*arguments):
    return subprocess.Popen([str(PROGRAM), *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def wait_for(player, text, limit_s=30):
    """What the player says until this is in it."""
    killer = threading.Timer(limit_s, player.kill)
    killer.start()
    said = ""
    for line in player.stderr:
        said += line
        if text in line:
            break
    killer.cancel()
    assert text in said, said


def play(work):
    lines = ["OLA Show"] + [line for level in range(200) for line in (f"1 {level},7", "100")]
    (work / "count.show").write_text("\n".join(lines) + "\n")
    levels = Levels()
    device = work / "midi"
    player = start("play", work / "count.show", "--timecode", "10:00:00:00", "--midi", device, "--freewheel", "0", "--to", "127.0.0.1",
                   "--sacn-port", levels.socket.getsockname()[1])
    try:
        wait_for(player, f"{device}: is not plugged in; it is looked for once a second")
        port = Port(device)  # plugged in later
        time.sleep(1.5)
        assert player.poll() is None and not levels.list, "nothing is sent before the first time code"
        port.run(0.0, 4)
        levels.list.clear()
        begun = time.monotonic()
        ended = port.run(5.0, 50)
        wrong = [(moment - begun, level) for moment, level in levels.list
                 if begun + 0.25 < moment < ended and abs(level / 10 - (5.0 + moment - begun)) > 0.25]
        assert len(levels.list) > 40 and len(wrong) <= 2, wrong
        time.sleep(0.5)
        levels.soon(70)
        stood = len(levels.list)
        time.sleep(0.5)
        assert {level for _, level in levels.list[stood:]} == {levels.list[-1][1]}, "it stands where the time code does"
        port.locate(15.0)
        levels.soon(150)
        port.run(12.0, 26, direction=-1)
        levels.soon(110)
        port.pull_out()
        time.sleep(1.5)
        assert player.poll() is None and abs(levels.list[-1][1] - 110) <= 1
        port = Port(device)
        time.sleep(1.5)
        port.locate(3.0)
        levels.soon(30)
    finally:
        player.kill()
        player.communicate()
    port.pull_out()
    print("ok: what is played follows quarter frames, full frames and a port that comes, goes and comes")


def monitor(work):
    device = work / "midi2"
    port = Port(device)
    watcher = start("monitor", "--protocols", "none", "--midi", device, "--json", "--every", "0.2", "--seconds", "3")
    first = watcher.stdout.readline()  # it watches
    port.run(1.0, 10)
    port.send(0xF0, 0x7F, 0x7F, 1, 1, EBU << 5 | 1, 61, 0, 0, 0xF7)
    out, said = watcher.communicate(timeout=30)
    reports = [json.loads(line)["midi"] for line in (first + out).splitlines()]
    assert watcher.returncode == 0 and reports[0]["state"] == "no time code", (said, reports[:1])
    last = reports[-1]
    assert last["state"] == "ok" and last["time"] == "10:00:01:09 EBU 25" and last["quarter_frames"] == 40, last
    assert last["full_frames"] == 1 and last["malformed"] == 1 and last["openings"] == 1, last
    port.pull_out()
    (work / "file").write_text("no port")
    watcher = start("monitor", "--protocols", "none", "--midi", work / "file", "--seconds", "0.7", "--every", "0.5")
    out, said = watcher.communicate(timeout=30)
    assert "is no MIDI port, expected a device like /dev/snd/midiC1D0" in said and "is no MIDI port" in out, (said, out)
    for wrong in (("play", work / "count.show", "--midi", device), ("open", "--midi", device)):
        done = start(*wrong)
        said = done.communicate(timeout=30)[1]
        assert done.returncode != 0 and "--timecode" in said, said
    print("ok: monitor says what a MIDI port brings")


def main():
    if not PROGRAM.exists():
        print(f"skipped: {PROGRAM} is not built")
        return 77
    try:
        for end in os.openpty():
            os.close(end)
    except OSError as problem:
        print(f"skipped: no pseudo-terminals here (/dev/pts): {problem}")
        return 77
    with tempfile.TemporaryDirectory(prefix="ghost_midi_") as folder:
        play(pathlib.Path(folder))
        monitor(pathlib.Path(folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())

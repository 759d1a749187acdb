#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""play --timecode: what is sent belongs to the Art-Net time code that comes: it runs, stands, jumps and goes back with it.
Usage: timecode_test.py SOURCE_FOLDER BUILD_FOLDER. On 127.0.0.1, at UDP ports of its own."""
import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time

PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
BEGIN_S = 36000  # 10:00:00:00


def free_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def timecode(frame, rate=25, kind=1, stream=0):
    """ArtTimeCode, Art-Net 4: frame of the day."""
    second = frame // rate
    return b"Art-Net\0" + struct.pack("<H", 0x9700) + struct.pack(">H", 14) + \
        bytes([0, stream, frame % rate, second % 60, second // 60 % 60, second // 3600, kind])


class Desk:
    """Sends a time code each 40 ms; keeps (time, level of slot 1) of what is played."""

    def __init__(self, artnet_port, listener):
        self.out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.to = ("127.0.0.1", artnet_port)
        self.listener = listener
        self.levels = []
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        while True:
            data = self.listener.recv(2048)
            if len(data) > 126 and data[40:44] == b"\0\0\0\2" and not data[112] & 0x40:
                self.levels.append((time.monotonic(), data[126]))

    def run(self, at_s, frames, step=1):
        """Returns (time, position) of each."""
        sent = []
        start = time.monotonic()
        for i in range(frames):
            time.sleep(max(0.0, start + i * 0.04 - time.monotonic()))
            position = at_s + i * step / 25
            self.out.sendto(timecode(round((BEGIN_S + position) * 25)), self.to)
            sent.append((time.monotonic(), position))
        return sent


def position_at(sent, now):
    """Where the show was by what was sent: (least, most), a frame and the scheduling of a busy machine either way."""
    past = [position for moment, position in sent if moment <= now + 0.01]
    late = [position for moment, position in sent if moment <= now - 0.15]
    ends = [past[-1], (late or past)[-1]]
    return min(ends) - 0.05, max(ends) + 0.05


def freewheels(work, artnet, desk, listener):
    """Without --freewheel it goes on for a second; what the player said."""
    player = subprocess.Popen([str(PROGRAM), "play", str(work / "count.show"), "--timecode", "10:00:00:00", "--to", "127.0.0.1",
                               "--interface", "127.0.0.1", "--sacn-port", str(listener.getsockname()[1]), "--artnet-port", str(artnet),
                               "--seconds", "7"], stderr=subprocess.PIPE, text=True)
    time.sleep(1.5)
    ended = desk.run(5.0, 51)[-1][0]  # 5 to 7 s
    time.sleep(2.2)
    seen = {after_s: [level for now, level in desk.levels if abs(now - ended - after_s) < 0.06] for after_s in (0.5, 1.6, 2.0)}
    said = player.communicate(timeout=30)[1]
    for after_s, level in ((0.5, 75), (1.6, 80), (2.0, 80)):
        assert seen[after_s] and min(abs(one - level) for one in seen[after_s]) <= 1, (after_s, seen)
    return said


def main():
    work = pathlib.Path(tempfile.mkdtemp())
    # Level n from n/10 s on: 20 s.
    lines = ["OLA Show"] + [line for level in range(200) for line in (f"1 {level},7", "100")]
    (work / "count.show").write_text("\n".join(lines) + "\n")
    listener = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    listener.bind(("127.0.0.1", 0))
    artnet = free_port()
    desk = Desk(artnet, listener)
    player = subprocess.Popen([str(PROGRAM), "play", str(work / "count.show"), "--timecode", "10:00:00:00", "--freewheel", "0", "--to", "127.0.0.1",
                               "--interface", "127.0.0.1", "--sacn-port", str(listener.getsockname()[1]), "--artnet-port", str(artnet),
                               "--quiet"], stderr=subprocess.PIPE, text=True)
    try:
        time.sleep(1.5)
        assert player.poll() is None, player.stderr.read()
        assert not desk.levels, "nothing is sent before the first time code"
        sent = desk.run(5.0, 50)  # 5 to 7 s
        began = len(desk.levels)
        assert began > 20, began
        wrong = 0
        for now, level in desk.levels:
            low, high = position_at(sent, now)
            wrong += not int(low * 10) <= level <= int(high * 10)
        assert wrong <= began // 50, f"{wrong} of {began} levels do not belong to the time code"
        assert len({level for _, level in desk.levels}) >= 15, "every look is sent"
        # It stops: the look is held, and goes on being sent.
        time.sleep(1.0)
        held = {level for now, level in desk.levels if now > sent[-1][0] + 0.3}
        assert len(held) == 1 and abs(held.pop() - 69) <= 1, desk.levels[-20:]
        assert len(desk.levels) > began + 20
        # A desk that pauses sends the same one again and again.
        for _ in range(10):
            desk.run(6.96, 1)
            time.sleep(0.04)
        time.sleep(0.2)
        assert desk.levels[-1][1] == 69, desk.levels[-1]
        # Jumps, ahead and back, and backwards.
        desk.run(15.0, 5)
        time.sleep(0.3)
        assert abs(desk.levels[-1][1] - 151) <= 1, desk.levels[-1]
        desk.run(2.0, 5)
        time.sleep(0.3)
        assert abs(desk.levels[-1][1] - 21) <= 1, desk.levels[-1]
        desk.run(12.0, 25, step=-1)
        time.sleep(0.3)
        assert abs(desk.levels[-1][1] - 110) <= 1, desk.levels[-1]
        # Another stream is not ours; before the beginning and behind the end the ends stand.
        desk.out.sendto(timecode((BEGIN_S + 3) * 25, stream=7), desk.to)
        time.sleep(0.2)
        assert abs(desk.levels[-1][1] - 110) <= 1, desk.levels[-1]
        for at_s, level in ((-100.0, 0), (500.0, 199)):
            desk.run(at_s, 3)
            time.sleep(0.3)
            assert desk.levels[-1][1] == level, (at_s, desk.levels[-1])
    finally:
        player.kill()
        player.wait()
    said = freewheels(work, artnet, desk, listener)
    for words in ("time code runs", "time code freewheels since 0.", "time code dropped out 1 s ago"):
        assert words in said, (words, said)
    for wrong in ("10:00", "25:00:00:00", "x"):
        done = subprocess.run([str(PROGRAM), "play", str(work / "count.show"), "--timecode", wrong], capture_output=True, text=True, timeout=30)
        assert done.returncode == 2 and "--timecode" in done.stderr, (wrong, done)
    print(f"ok: {len(desk.levels)} packets follow the time code")


main()

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""play --timecode --ltc: what is sent belongs to the time code that is a sound: of a file, and of an input of ALSA. It runs, jumps,
freewheels where the sound drops out and then stands. The LTC is written here, bit by bit. The input is ALSA's plugin that reads samples
of a pipe, in the place of a sound card. Usage: ltc_test.py SOURCE_FOLDER BUILD_FOLDER. On 127.0.0.1, at UDP ports of its own."""
import json
import os
import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import wave

PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
BEGIN_S = 36000  # 10:00:00:00
RATE_HZ = 48000
PIECE = 480  # samples that the input gives at once


def bits(frame):
    """Those of a frame of the day, 25 a second, the first one first (SMPTE 12M-1)."""
    second = frame // 25
    f, s, m, h = frame % 25, second % 60, second // 60 % 60, second // 3600
    number = 0
    for at, value in ((0, f % 10), (8, f // 10), (16, s % 10), (24, s // 10), (32, m % 10), (40, m // 10), (48, h % 10), (56, h // 10),
                      (64, 0xBFFC)):
        number |= value << at
    return [number >> k & 1 for k in range(80)]


class Tape:
    """Samples of one channel: a frame is 1920, a bit 24."""

    def __init__(self):
        self.samples, self.level = [], 12000

    def run(self, at_s, frames):
        first = round((BEGIN_S + at_s) * 25)
        for frame in range(first, first + frames):
            for bit in bits(frame):
                self.level = -self.level
                self.samples += [self.level] * 12
                self.level = -self.level if bit else self.level
                self.samples += [self.level] * 12
        return self

    def silence(self, seconds):
        self.samples += [0] * round(seconds * RATE_HZ)
        return self

    def stereo(self, right=True):
        pairs = ((0, value) if right else (value, value) for value in self.samples)
        return b"".join(struct.pack("<hh", *pair) for pair in pairs)


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

    def at(self, moment):
        return [level for when, level in self.list if abs(when - moment) < 0.06]


def start(*arguments, environment=None):
    return subprocess.Popen([str(PROGRAM), *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            env={**os.environ, **(environment or {})})


def tape():
    """Runs two seconds, drops out for three, of which it freewheels one, and goes on elsewhere."""
    return Tape().silence(1).run(5, 50).silence(3).run(15, 50).silence(0.5)


def check(levels, begun):
    """begun: when the tape began to play."""
    wrong = []
    for after_s, position_s in ((1.5, 5.5), (2.0, 6.0), (2.9, 6.9), (3.5, 7.5), (4.5, 8.0), (5.5, 8.0), (6.5, 15.5), (7.8, 16.8)):
        seen = levels.at(begun + after_s)
        if not seen or min(abs(level / 10 - position_s) for level in seen) > 0.16:
            wrong.append((after_s, position_s, seen))
    assert not levels.at(begun + 0.8), "nothing is sent before the first time code"
    assert len(wrong) <= 1, wrong  # a busy machine may be late once
    return len(levels.list)


def plays(show, levels, *words, environment=None):
    return start("play", show, "--timecode", "10:00:00:00", "--to", "127.0.0.1", "--sacn-port", levels.socket.getsockname()[1], *words,
                 environment=environment)


def of_a_file(work, show):
    with wave.open(str(work / "ltc.wav"), "wb") as file:
        file.setparams((2, 2, RATE_HZ, 0, "NONE", ""))
        file.writeframes(tape().stereo())
    levels = Levels()
    player = plays(show, levels, "--ltc", work / "ltc.wav", "--seconds", "9.5")
    out, said = player.communicate(timeout=60)
    assert player.returncode == 0, said
    # The file began to play a second before the first level.
    count = check(levels, levels.list[0][0] - 1.08)
    for words in ("time code runs", "time code freewheels", "time code dropped out"):
        assert words in said, (words, said)
    print(f"ok: {count} levels follow LTC of a file: it runs, freewheels, stands and jumps")


class Card:
    """An input of ALSA that hears what is written into it."""

    def __init__(self, work):
        self.pipe = work / "card"
        os.mkfifo(self.pipe)
        config = work / "asound.conf"
        config.write_text("pcm.card {\n type file\n file /dev/null\n infile \"" + str(self.pipe) + "\"\n format raw\n slave.pcm {\n  type null\n }\n}\n")
        self.environment = {"ALSA_CONFIG_PATH": str(config)}

    def play(self, samples, done):
        with open(self.pipe, "wb", buffering=0) as out:
            begun = time.monotonic()
            done["begun"] = begun
            size = PIECE * 4
            for k in range(len(samples) // size):
                time.sleep(max(0.0, begun + (k + 1) * PIECE / RATE_HZ - time.monotonic()))
                out.write(samples[k * size:(k + 1) * size])


def of_a_card(work, show):
    card, levels, done = Card(work), Levels(), {}
    sound = threading.Thread(target=card.play, args=(tape().stereo(), done), daemon=True)
    sound.start()
    player = plays(show, levels, "--ltc", "card", "--seconds", "10.5", environment=card.environment)
    out, said = player.communicate(timeout=60)
    assert player.returncode == 0 and "begun" in done, said
    count = check(levels, done["begun"])
    print(f"ok: {count} levels follow LTC of an input of ALSA")


def what_cannot_be(work, show):
    levels = Levels()
    player = plays(show, levels, "--ltc", "no_such_card", "--seconds", "1")
    said = player.communicate(timeout=60)[1]
    assert "no_such_card: is neither a file nor an input of ALSA that is there (arecord -L lists them); it is looked for once a second" in said, said
    (work / "no_sound.wav").write_bytes(b"nothing")
    player = plays(show, levels, "--ltc", work / "no_sound.wav", "--seconds", "1")
    said = player.communicate(timeout=60)[1]
    assert "no_sound.wav: cannot be opened as a sound" in said and said.count("no_sound.wav") == 1, said
    for wrong in (("play", show, "--ltc", "x"), ("play", show, "--timecode", "0", "--ltc", "x", "--midi", "y"),
                  ("play", show, "--timecode", "0", "--freewheel", "-1")):
        player = start(*wrong)
        player.communicate(timeout=60)
        assert player.returncode != 0, wrong


def monitor(work):
    watcher = start("monitor", "--protocols", "none", "--ltc", work / "ltc.wav", "--json", "--every", "0.5", "--seconds", "3")
    out, said = watcher.communicate(timeout=60)
    reports = [json.loads(line)["ltc"] for line in out.splitlines()]
    assert watcher.returncode == 0 and reports[0]["state"] == "no time code", (said, reports[:1])
    last = reports[-1]
    assert last["state"] == "ok" and last["channel"] == 2 and -12 < last["level_dbfs"] < -6 and last["frames"] > 30, last
    assert last["time"].startswith("10:00:06:") and last["time"].endswith("EBU 25"), last
    watcher = start("monitor", "--protocols", "none", "--ltc", work / "ltc.wav", "--every", "0.5", "--seconds", "2.5")
    out, said = watcher.communicate(timeout=60)
    assert "ltc.wav: silent: is the cable in" in out and "ltc.wav: LTC 10:00:0" in out, (said, out)
    print("ok: monitor says what a sound brings")


def main():
    if not PROGRAM.exists():
        print(f"skipped: {PROGRAM} is not built")
        return 77
    with tempfile.TemporaryDirectory(prefix="ghost_ltc_") as folder:
        work = pathlib.Path(folder)
        lines = ["OLA Show"] + [line for level in range(200) for line in (f"1 {level},7", "100")]
        (work / "count.show").write_text("\n".join(lines) + "\n")
        of_a_file(work, work / "count.show")
        of_a_card(work, work / "count.show")
        monitor(work)
        what_cannot_be(work, work / "count.show")
    return 0


if __name__ == "__main__":
    sys.exit(main())

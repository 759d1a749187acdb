#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The window plays the sound of the show in time with the time code that its recording follows: claps, one in each second of the sound, are
heard when the time code says so, after a jump, too; where it drops out they go on for a second, and then it is silent. What is heard is
what PulseAudio's null sink gets, where there is no sound card. Without a screen (Qt's offscreen platform). Usage: window_sound_test.py
SOURCE_FOLDER BUILD_FOLDER."""
import array
import math
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

SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import needs  # noqa: E402  (the folder is known only now)

needs.packages("pulseaudio", "pulseaudio-utils", "libasound2-plugins")
LONG_S = 300  # for what a busy machine may take
RATE_HZ = 48000
OFFSET_S = 0.5  # second of the recording at which the sound begins
SHOW = f"""
[show]
name = "Claps"
stage = "{SOURCE}/assets/optics/stage.glb"
recording = "dark.show"
sound = "claps.wav"
sound_offset_s = {OFFSET_S}
[[camera]]
name = "front"
position_m = [0, -3, 3]
target_m = [0, 5, 3]
size = [96, 54]
ev100 = 11
"""


def write_show(folder):
    folder.mkdir()
    (folder / "show.toml").write_text(SHOW)
    (folder / "dark.show").write_text("OLA Show\n1 0\n60000\n1 0\n0\n")
    with wave.open(str(folder / "claps.wav"), "wb") as sound:
        sound.setparams((2, 2, RATE_HZ, 0, "NONE", ""))
        clap = b"".join(struct.pack("<hh", value, value) for value in (round(26000 * math.cos(k / 8)) for k in range(RATE_HZ // 50)))
        sound.writeframes((clap + bytes(4 * (RATE_HZ - RATE_HZ // 50))) * 40)
    return folder


class Ears:
    """PulseAudio with a sink that nobody has, and what it hears: the moments at which claps begin."""

    def __init__(self, work):
        folder = work / "pulse"
        folder.mkdir(mode=0o700)
        self.environment = {**os.environ, "PULSE_RUNTIME_PATH": str(folder), "HOME": str(folder), "XDG_RUNTIME_DIR": str(folder),
                            "XDG_CONFIG_HOME": str(folder), "QT_QPA_PLATFORM": "offscreen",
                            "ALSA_CONFIG_PATH": f"/usr/share/alsa/alsa.conf:{work / 'asound.conf'}"}
        (work / "asound.conf").write_text("pcm.heard { type pulse device heard }\n")
        self.server = subprocess.Popen(["pulseaudio", "-n", "--daemonize=no", "--exit-idle-time=-1", "-L",
                                        f"module-null-sink sink_name=heard rate={RATE_HZ}", "-L", "module-native-protocol-unix"],
                                       env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for _ in range(100):
            time.sleep(0.1)
            if subprocess.run(["pactl", "info"], env=self.environment, capture_output=True, timeout=20).returncode == 0:
                break
        else:
            self.close()
            needs.skip("PulseAudio does not start here")
        self.recorder = subprocess.Popen(["parec", "-d", "heard.monitor", "--latency-msec=5", f"--rate={RATE_HZ}", "--format=s16le",
                                          "--channels=1"], env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.claps, self.loud_at = [], 0.0
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        while True:
            piece = array.array("h", os.read(self.recorder.stdout.fileno(), 1024))
            end = time.monotonic()
            if not piece:
                return
            for k, value in enumerate(piece):
                if abs(value) > 12000:
                    moment = end - (len(piece) - k) / RATE_HZ
                    if moment - self.loud_at > 0.3:
                        self.claps.append(moment)
                    self.loud_at = moment

    def close(self):
        for process in (getattr(self, "recorder", None), self.server):
            if process:
                process.kill()
                process.wait()


class Window:
    def __init__(self, work, show, ears):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
            one.bind(("127.0.0.1", 0))
            self.port = one.getsockname()[1]
        path = work / "socket"
        self.log = (work / "window.log").open("w+")
        self.process = subprocess.Popen([str(BUILD / "ghostlight"), "open", str(show), "--forget", "--socket", str(path), "--size", "480x320",
                                         "--sound", "heard", "--timecode", "10:00:00:00", "--protocols", "artnet", "--artnet-port",
                                         str(self.port), "--interface", "127.0.0.1", "--no-poll-reply"], env=ears.environment,
                                        stdout=self.log, stderr=self.log)
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(LONG_S)
        for _ in range(LONG_S * 10):
            try:
                self.socket.connect(str(path))
                break
            except OSError:
                assert self.process.poll() is None, (work / "window.log").read_text()
                time.sleep(0.1)
        self.answers = self.socket.makefile()

    def do(self, line):
        self.socket.sendall((line + "\n").encode())
        answer = self.answers.readline().strip()
        assert answer == "ok", (line, answer)

    def run(self, at_s, seconds):
        """Time code from this second of the recording on; returns when it was there."""
        begun = time.monotonic()
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
            for k in range(round(25 * seconds)):
                time.sleep(max(0.0, begun + k / 25 - time.monotonic()))
                frame = round((36000 + at_s) * 25) + k
                out.sendto(b"Art-Net\0" + struct.pack("<H", 0x9700) + struct.pack(">H", 14) +
                           bytes([0, 0, frame % 25, frame // 25 % 60, frame // 1500 % 60, frame // 90000, 1]), ("127.0.0.1", self.port))
        return begun


def offsets(claps, begun, at_s, from_s, to_s):
    """By how many seconds claps in this part of the run are later than the time code says."""
    late = []
    for clap in claps:
        if from_s <= clap - begun < to_s:
            sound_s = at_s + clap - begun - OFFSET_S
            late.append(sound_s - round(sound_s))
    return late


def main():
    if not (BUILD / "ghostlight").exists():
        needs.skip("ghostlight is not built")
    with tempfile.TemporaryDirectory(prefix="ghost_sound_") as folder:
        work = pathlib.Path(folder)
        ears = Ears(work)
        try:
            window = Window(work, write_show(work / "show"), ears)
            window.do("wait opened")
            for at_s in (5.0, 25.2, 3.7):
                begun = window.run(at_s, 6)
                time.sleep(2.5)  # it freewheels for a second
                late = offsets(ears.claps, begun, at_s, 1.5, 6)
                text = ", ".join(f"{1000 * one:.1f}" for one in late)
                print(f"from {at_s} s: heard {text} ms later than the time code says")
                assert len(late) >= 4 and max(map(abs, late)) < 0.060, (late, ears.claps)
                assert offsets(ears.claps, begun, at_s, 6, 7) and not offsets(ears.claps, begun, at_s, 7.2, 8.5), ears.claps
            window.do("quit")
            assert window.process.wait(timeout=LONG_S) == 0, (work / "window.log").read_text()
        finally:
            window.process.kill()
            ears.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())

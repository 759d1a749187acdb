#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A mover by keys in a film that follows the network's time code: it is where the recording has it at that second, it stands with the code,
and it goes back with it. And how long `check` watches movers by keys. Usage: keys_test.py SOURCE_FOLDER BUILD_FOLDER. On 127.0.0.1, at a UDP port of its own."""
import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
import threading

SOURCE, GHOST = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]) / "ghostlight"
SHOW = """[show]
name = "Keys"
stage = "{source}/assets/kinetic/stage.glb"
recording = "silence.show"
motion = "commanded"
ambient_lux = 50

[haze]
preset = "none"

[[camera]]
name = "front"
position_m = [0, -15, 4.2]
target_m = [0, 2, 3]
fov_y_deg = 34
size = [96, 54]
ev100 = 4

[[mover]]
name = "Truss"
kind = "linear"
objects = ["Truss"]
[[mover.axis]]
range_m = [-5, 0]
[[mover.key]]
at_s = 0
values = [0]
[[mover.key]]
at_s = 10
values = [-5]
"""


def free_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def timecode(at_s):
    frame = round((36000 + at_s) * 25)
    return b"Art-Net\0" + struct.pack("<H", 0x9700) + struct.pack(">H", 14) + \
        bytes([0, 0, frame % 25, frame // 25 % 60, frame // 1500 % 60, frame // 90000, 1])


def film_at(top, at_s):
    """The last picture of a short film while the code stands there."""
    port, ends = free_port(), threading.Event()

    def send():
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
            while not ends.wait(0.04):
                out.sendto(timecode(at_s), ("127.0.0.1", port))
    sender = threading.Thread(target=send)
    sender.start()
    try:
        subprocess.run([GHOST, "render", top, "--live", "--live-input", "--timecode", "10:00:00:00", "--protocols", "artnet", "--artnet-port",
                        str(port), "--interface", "127.0.0.1", "--no-poll-reply", "--no-caption", "--seconds", "1.5", "--fps", "4", "--quiet",
                        "-o", top / "film.exr"], check=True, timeout=300)
    finally:
        ends.set()
        sender.join()
    return sorted(top.glob("film-*.exr"))[-1].read_bytes()


LONG = """[show]
stage = "stage.obj"
[[camera]]
name = "front"
position_m = [0, -12, 3]
target_m = [0, 2, 2]
[[mover]]
name = "Lift"
kind = "linear"
objects = ["lift"]
[[mover.axis]]
range_m = [0, 2]
[[mover.key]]
at_s = 0
values = [0]
[[mover.key]]
at_s = {end_s}
values = [1]
"""


def the_longest_watch(top):
    """500,000 steps, 20 a second, of which the first is at 0 s."""
    (top / "stage.obj").write_text("o lift\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    for end_s, is_said in ((24999.96, False), (25000.5, True)):
        (top / "show.toml").write_text(LONG.format(end_s=end_s))
        done = subprocess.run([GHOST, "check", top], capture_output=True, text=True, timeout=300)
        said = done.stdout + done.stderr
        assert "the movers are watched for" not in said or is_said, said
        assert not is_said or "show.toml: the movers are watched for 25000 s, from 0 s on; what they do up to " in said, said
    print("ok: check watches 500,000 steps of movers, and says where it ends")


def main():
    with tempfile.TemporaryDirectory() as temporary:
        top = pathlib.Path(temporary)
        (top / "show.toml").write_text(SHOW.format(source=SOURCE))
        (top / "silence.show").write_text("OLA Show\n1 0\n12000\n1 0\n0\n")
        seen = {}
        for at_s in (2, 7, 2):
            subprocess.run([GHOST, "render", top, "--live", "--at", str(at_s), "--quiet", "-o", top / "still.exr"], check=True, timeout=300)
            still, film = (top / "still.exr").read_bytes(), film_at(top, at_s)
            assert film == still, f"at {at_s} s the film is not as the recording has it"
            seen[at_s] = film
        assert seen[2] != seen[7], "it travels"
        (top / "long").mkdir()
        the_longest_watch(top / "long")
        print("ok: at 2, 7 and again 2 s of time code, each as the recording has it")
    return 0


if __name__ == "__main__":
    sys.exit(main())

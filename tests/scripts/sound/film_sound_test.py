#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Films with sound: a lamp flashes in the recording when a clap is in the sound; FFmpeg's own program finds both in the film within
10 ms, of the demo, too. A film made in parts has the bytes of the whole; a show without the key makes films without a sound; a sound that cannot be read is
one sentence. Usage: film_sound_test.py SOURCE_FOLDER BUILD_FOLDER."""
import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import wave

SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import needs  # noqa: E402
from farm import Ghostlight  # noqa: E402  (the folder is known only now)

FLASH_S, FROM_S, OFFSET_S = 1.2, 0.4, 0.25  # seconds of the recording
SHOW = """
[show]
name = "A clap"
stage = "{source}/assets/optics/stage.glb"
recording = "flash.show"
motion = "commanded"
{sound}
[haze]
preset = "none"
[[camera]]
name = "front"
position_m = [0, -3, 3]
target_m = [0, 5, 3]
fov_y_deg = 20
size = [96, 54]
ev100 = 11
[[media]]
name = "picture"
card = "white"
[[fixture]]
name = "Wall"
address = 1
position_m = [0, 5, 3]
wall = {{ media = "picture", size_m = [6, 4], nits = 1000 }}
"""
FILM = ["--live", "--no-shadows", "--from", str(FROM_S), "--to", "2.4", "--fps", "25"]


def write_clap(path, clap_s, rate=44100, length_s=3):
    with wave.open(str(path), "wb") as sound:
        sound.setparams((2, 2, rate, 0, "NONE", ""))
        begin = round(clap_s * rate)
        values = (round(24000 * math.cos(2 * math.pi * 1000 * (k - begin) / rate)) if begin <= k < begin + rate // 20 else 0
                  for k in range(length_s * rate))
        sound.writeframes(b"".join(struct.pack("<hh", value, value) for value in values))


def output(*words):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, timeout=120).stdout


def times(film, kind):
    """Seconds at which its pictures, or pieces of sound, are shown."""
    frames = json.loads(output("ffprobe", "-v", "error", "-select_streams", kind, "-show_entries", "frame=best_effort_timestamp_time", "-of",
                               "json", film))["frames"]
    return [float(frame["best_effort_timestamp_time"]) for frame in frames]


def seen_s(film, width=96, height=54):
    pixels = output("ffmpeg", "-v", "error", "-i", film, "-f", "rawvideo", "-pix_fmt", "gray", "-")
    middle = [pixels[frame * width * height + height // 2 * width + width // 2] for frame in range(len(pixels) // (width * height))]
    dark, bright = min(middle), max(middle)
    assert bright > dark + 60, (dark, bright)
    return times(film, "v")[next(k for k, value in enumerate(middle) if value > (dark + bright) / 2)]


def heard_s(film):
    samples = output("ffmpeg", "-v", "error", "-i", film, "-f", "s16le", "-ac", "1", "-ar", "48000", "-")
    values = struct.unpack(f"<{len(samples) // 2}h", samples)
    return times(film, "a")[0] + next(k for k, value in enumerate(values) if abs(value) > 8000) / 48000


def kinds(film):
    return output("ffprobe", "-v", "error", "-show_entries", "stream=codec_type,codec_name", "-of", "csv=p=0", film).decode().split()


def demo_with_a_clap(folder):
    """The demo, whose washes light the cyclorama when the clap is heard."""
    sys.path.insert(0, str(SOURCE / "tools/demo_show"))
    from desk_looks import red_and_blue  # noqa: E402  (the folder is known only now)
    from rig import DIM, NAMES, RIG  # noqa: E402
    shutil.copytree(SOURCE / "assets/demo", folder / "demo", ignore=shutil.ignore_patterns(".ghost"))
    (folder / "fixtures").symlink_to(SOURCE / "assets/fixtures")
    lit = red_and_blue()[0]
    dark = list(lit)
    for wash in (5, 6, 7):
        dark[RIG[NAMES[wash]][3] - 1 + DIM] = 0
    looks = ((dark, round(FLASH_S * 1000)), (lit, 1500), (lit, 0))
    (folder / "demo/demo.show").write_text("OLA Show\n" + "".join(f"1 {','.join(map(str, look))}\n{ms}\n" for look, ms in looks))
    text = (folder / "demo/show.toml").read_text()
    (folder / "demo/show.toml").write_text(text.replace("[show]", '[show]\nsound = "clap.wav"', 1))
    write_clap(folder / "demo/clap.wav", FLASH_S)
    return folder / "demo"


needs.packages("ffmpeg")
work = pathlib.Path(tempfile.mkdtemp(prefix="ghost-sound-"))
ghost = Ghostlight(BUILD / "ghostlight", dict(os.environ), work)
try:
    show = work / "show"
    show.mkdir()
    (show / "flash.show").write_text(f"OLA Show\n1 0\n{round(FLASH_S * 1000)}\n1 255\n100\n1 0\n1500\n1 0\n0\n")
    write_clap(show / "clap.wav", FLASH_S - OFFSET_S)

    def say(sound):
        (show / "show.toml").write_text(SHOW.format(source=SOURCE, sound=sound))

    say("")
    ghost.run("render", show, "-o", "silent.mp4", *FILM)
    assert len(kinds(work / "silent.mp4")) == 1, kinds(work / "silent.mp4")

    say(f'sound = "clap.wav"\nsound_offset_s = {OFFSET_S}')
    ghost.run("check", show)
    ghost.run("render", show, "-o", "whole.mp4", *FILM)
    assert any("aac" in kind for kind in kinds(work / "whole.mp4")), kinds(work / "whole.mp4")
    seen, heard = seen_s(work / "whole.mp4"), heard_s(work / "whole.mp4")
    print(f"seen at {1000 * seen:.1f} ms, heard at {1000 * heard:.1f} ms of the film")
    assert abs(seen - (FLASH_S - FROM_S)) < 1e-3, seen
    assert abs(heard - seen) < 0.010, (seen, heard)
    ghost.run("render", show, "-o", "again.mp4", *FILM)
    assert (work / "again.mp4").read_bytes() == (work / "whole.mp4").read_bytes()
    ghost.run("render", show, "-o", "cut.mp4", *FILM, "--farm", "local")
    assert (work / "cut.mp4").read_bytes() == (work / "whole.mp4").read_bytes()
    print("made once more, and by a farm: the same bytes")

    ghost.run("render", demo_with_a_clap(work), "-o", "demo.mp4", "--view", "house", "--size", "96x54", *FILM)
    seen, heard = seen_s(work / "demo.mp4"), heard_s(work / "demo.mp4")
    print(f"the demo: seen at {1000 * seen:.1f} ms, heard at {1000 * heard:.1f} ms of the film")
    assert abs(seen - (FLASH_S - FROM_S)) < 1e-3 and abs(heard - seen) < 0.010, (seen, heard)

    write_clap(show / "clap.wav", FLASH_S)
    ghost.run("render", show, "-o", "moved.mp4", *FILM)
    assert abs(heard_s(work / "moved.mp4") - seen_s(work / "moved.mp4") - OFFSET_S) < 0.010

    (show / "broken.wav").write_bytes(b"RIFF\xff\xff\xff\x7fWAVEfmt " + bytes(200))
    say('sound = "broken.wav"')
    said = ghost.run("render", show, "-o", "broken.mp4", *FILM, code=1, says="the film is silent")
    assert "show.toml:" in said and "broken.wav" in said, said
    assert (work / "broken.mp4").read_bytes() == (work / "silent.mp4").read_bytes()
    ghost.run("check", show, code=1, says="broken.wav")
    ghost.run("render", show, "-o", "no.mp4", *FILM, "--farm", "local", code=1, says="broken.wav")
    say('sound = "clab.wav"')
    ghost.run("check", show, code=1, says="did you mean 'clap.wav'?")
    say("sound_offset_s = 1")
    ghost.run("check", show, says="there is no sound")
    print("without a sound: as before; one that cannot be read: a sentence")
finally:
    shutil.rmtree(work)

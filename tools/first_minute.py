#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The first minute with the window as a film: a window on a screen of its own (Xvfb) does the lines below, and ffmpeg records that screen.
Another plot or show: its path behind the film. Needs xvfb and ffmpeg.

usage: first_minute.py BUILD_FOLDER FILM.mp4 [SHOW]
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
SIZE = "1280x720"
OPENS = 'wait 2\nopen "{}"\nwait opened\nwait 5\n'
LINES = """freeze on
wait 4
select "Spot *"
wait 2
intensity 1
aim 0 2 1.5
wait 5
colour #ff8000
wait 5
panel-looks on
look-store "All at the singer"
wait 3
release-all
wait 4
look-recall "All at the singer" 2
wait 5
false-lux on
wait 5
false-lux off
camera 2
wait 6
"""
ANY_LINES = """wait 6
select-all
intensity 1
wait 8
camera 2
wait 8
release-all
wait 4
"""


def main():
    program, film = Path(sys.argv[1]).resolve() / "ghostlight", Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        if len(sys.argv) > 3:
            show, lines = Path(sys.argv[3]).resolve(), ANY_LINES
        else:  # looks are stored beside the show
            show, lines = work / "demo", LINES
            shutil.copytree(SOURCE / "assets/demo", show, ignore=shutil.ignore_patterns(".ghost"))
            (work / "fixtures").symlink_to(SOURCE / "assets/fixtures")
            lines = "jump 55\nwait 6\n" + lines
        (work / "lines").write_text(OPENS.format(show) + lines + "quit anyway\n")
        reading, writing = os.pipe()
        screen = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{SIZE}x24", "-nolisten", "tcp"], pass_fds=[writing],
                                  stderr=subprocess.DEVNULL)
        os.close(writing)
        name = os.fdopen(reading).readline().strip()
        if not name:
            sys.exit("Xvfb does not start (package xvfb)")
        environment = dict(os.environ, DISPLAY=f":{name}", XDG_CONFIG_HOME=str(work / "config"), XDG_DATA_HOME=str(work / "data"))
        environment.pop("WAYLAND_DISPLAY", None)
        raw = work / "raw.mkv"  # a light encoding while it runs, a small one afterwards
        records = subprocess.Popen(["ffmpeg", "-loglevel", "error", "-f", "x11grab", "-draw_mouse", "0", "-framerate", "10", "-video_size", SIZE, "-i", f":{name}",
                                    "-c:v", "libx264", "-preset", "ultrafast", "-crf", "12", str(raw)], stdin=subprocess.PIPE)
        try:
            code = subprocess.run([str(program), "open", "--forget", "--quiet", "--language", "en", "--no-desk", "--size", SIZE, "--script", str(work / "lines")],
                                  env=environment, check=False).returncode
        finally:
            records.communicate(b"q")
            screen.terminate()
            screen.wait()
        if code != 0:
            sys.exit(f"the window ended with {code}")
        subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-i", str(raw), "-c:v", "libx264", "-preset", "slow", "-crf", "30", "-pix_fmt", "yuv420p",
                        "-movflags", "+faststart", str(film)], check=True)
    print(f"{film}: {film.stat().st_size / 1e6:.2f} MB")


main()

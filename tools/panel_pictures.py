#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every panel and every dialog of the window, of the demo, on screens of its own (Xvfb), each a picture of the whole screen in a folder to be
looked at; with --sheets also the sheets of docs/images/panels. A size is in pixels of the screen, the scale behind the @.
Needs xvfb, xdotool and python3-pil.

usage: panel_pictures.py BUILD_FOLDER FOLDER [--sizes 1366x768@1 ...] [--only NAME ...] [--language de] [--sheets]
"""
import argparse
import contextlib
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont, ImageGrab

SOURCE = Path(__file__).resolve().parent.parent
SHEETS = SOURCE / "docs/images/panels"
SIZES = ("1366x768@1", "1920x1080@1", "2560x1440@1", "2732x1536@2", "1920x1080@2", "2560x1440@2")
COLUMNS, THUMB_PX, MOST_BYTES = 5, 460, 300_000

SETUP = """jump 36
wait 0.3
freeze on
camera house
select "Spot *"
colour #ff8000
palette-store colour Amber
look-store "All amber"
release-all
select "Wash *"
colour #3060ff
intensity 0.8
look-store "Blue wash"
release-all
cue-add Opening "All amber"
cue-add Chorus "Blue wash"
select "Spot 2"
save"""
# Name: what is done before, what afterwards. A line behind a ! is one for xdotool, with places of its screen.
PANELS = {name: (f"panel-{name} on", f"panel-{name} off") for name in
          ("fixtures", "values", "programmer", "looks", "cues", "scene", "air", "plot", "network", "messages", "export", "browsers")}
STAYS = {"fixtures", "values", "programmer", "looks", "scene"}  # tabs of the columns of a wide window
AWAY, CLOSES = "!mousemove {x} {low}", "!mousemove {mid_x} {mid_y} click 1\n!key Escape"  # without a window manager keys follow clicks
OTHERS = {
    "by-hand": ("select *\npanel-programmer on\nintensity 0.5\ncolour #ff3000", 'undo\nundo\nselect "Spot 2"'),
    "figures": ("figures on\nnames on\naddresses on\naims on", "figures off\nnames off\naddresses off\naims off"),
    "strip": ("camera-strip on\nwait 12", "camera-strip off"),
    "lux": ("false-lux on\nprobe on\n!mousemove {x} {y}\nwait 2", f"probe off\nfalse-lux off\n{AWAY}"),
    "wipe": ('camera close\nwait settled\nwipe 0.5\nlook-recall "Blue wash" 0', "wipe off\nundo\ncamera house"),
    "refused": ("!mousemove {x} {y} click 1\nselect-none\n!key ctrl+d\nwait 1", f'select "Spot 2"\n{AWAY}'),
    "context": ("!mousemove {x} {y} click 3\nwait 1", f"!key Escape\n{AWAY}"),
    "keys": ("shortcuts\nwait 1", CLOSES),
    "paperwork": ("paperwork\nwait 1", CLOSES),
    "cue-book": ("cue-book\nwait 1", CLOSES),
    "quit": ('!mousemove {x} {low} click 1\nselect "Spot 2"\nmove 0.1 0 0\n!key ctrl+q\nwait 1', ""),
}


class Window:
    def __init__(self, program, work, display, scale, arguments):
        environment = dict(os.environ, DISPLAY=display, HOME=str(work), XDG_CONFIG_HOME=str(work / "config"), XDG_DATA_HOME=str(work / "data"),
                           QT_SCALE_FACTOR=scale, LC_ALL="C.UTF-8")
        for name in ("WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
            environment.pop(name, None)
        path = work / "socket"
        self.display = display
        self.scale = int(scale)
        self.process = subprocess.Popen([str(program), "open", *arguments, "--forget", "--quiet", "--no-desk", "--socket", str(path)], env=environment)
        self.socket = socket.socket(socket.AF_UNIX)
        while True:
            try:
                self.socket.connect(str(path))
                break
            except OSError:
                if self.process.poll() is not None:
                    sys.exit("the window ended")
                time.sleep(0.1)
        self.answers = self.socket.makefile()

    def do(self, lines):
        for line in filter(None, lines.splitlines()):
            if line.startswith("!"):
                words = [word.format(**self.places) for word in line[1:].split()]
                subprocess.run(["xdotool", *words], env=dict(os.environ, DISPLAY=self.display), check=True)
                time.sleep(0.5)
                continue
            self.socket.sendall((line + "\n").encode())
            if (answer := self.answers.readline().strip()) != "ok":
                print(f"{line}: {answer}", file=sys.stderr)

    def shoot(self, file, waits=True):
        if waits:
            self.do("wait settled")
        time.sleep(0.3)
        ImageGrab.grab(xdisplay=self.display).save(file)

    def close(self):
        self.do("quit anyway")
        self.process.wait(timeout=60)


@contextlib.contextmanager
def screen(size):
    reading, writing = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{size}x24", "-nolisten", "tcp"], pass_fds=[writing],
                              stderr=subprocess.DEVNULL)
    os.close(writing)
    try:
        yield ":" + os.fdopen(reading).readline().strip()
    finally:
        server.terminate()
        server.wait()


def take(program, sized, folder, language, only):
    """The pictures of one size, in their order."""
    pixels, _, scale = sized.partition("@")
    width, height = (int(number) // int(scale) for number in pixels.split("x"))
    arguments = ["--size", f"{width}x{height}", "--language", language]
    folder.mkdir(parents=True, exist_ok=True)
    wanted = [name for name in ("start", *PANELS, *OTHERS) if not only or name in only]
    with screen(pixels) as display, tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        shutil.copytree(SOURCE / "assets/demo", work / "demo", ignore=shutil.ignore_patterns(".ghost"))
        (work / "fixtures").symlink_to(SOURCE / "assets/fixtures")
        if "start" in wanted:
            window = Window(program, work, display, scale, arguments)
            time.sleep(3)
            window.shoot(folder / "start.png", waits=False)
            window.close()
        window = Window(program, work, display, scale, [str(work / "demo"), *arguments])
        across, down = width * int(scale), height * int(scale)
        window.places = {"x": round(0.6 * across), "y": round(0.4 * down), "mid_x": across // 2, "mid_y": down // 2, "low": round(0.8 * down)}
        window.do("wait opened\n" + SETUP)
        for name in wanted[wanted[0] == "start":]:
            before, after = {**PANELS, **OTHERS}[name]
            window.do(before)
            window.shoot(folder / f"{name}.png")
            if name not in STAYS or width < 1340:
                window.do(after)
        window.close()
    return [folder / f"{name}.png" for name in wanted]


def sheet(pictures, file):
    """All pictures small beside each other, with their names."""
    first = Image.open(pictures[0])
    height = round(THUMB_PX * first.height / first.width)
    rows = -(-len(pictures) // COLUMNS)
    whole = Image.new("RGB", (COLUMNS * (THUMB_PX + 8) + 8, rows * (height + 30) + 8), (24, 24, 26))
    draw = ImageDraw.Draw(whole)
    font = ImageFont.load_default()
    for number, one in enumerate(pictures):
        x, y = 8 + number % COLUMNS * (THUMB_PX + 8), 8 + number // COLUMNS * (height + 30)
        whole.paste(Image.open(one).convert("RGB").resize((THUMB_PX, height), Image.LANCZOS), (x, y))
        draw.text((x, y + height + 4), one.stem, font=font, fill=(220, 220, 220))
    for quality in range(85, 20, -5):
        whole.save(file, quality=quality, method=6)
        if file.stat().st_size < MOST_BYTES:
            return
    sys.exit(f"{file}: more than {MOST_BYTES} bytes")


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("build", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--sizes", nargs="+", default=SIZES)
    parser.add_argument("--only", nargs="+", default=[])
    parser.add_argument("--language", default="en")
    parser.add_argument("--sheets", action="store_true")
    asked = parser.parse_args()
    for sized in asked.sizes:
        pictures = take(asked.build.resolve() / "ghostlight", sized, asked.folder / sized, asked.language, asked.only)
        if asked.sheets:
            SHEETS.mkdir(parents=True, exist_ok=True)
            sheet(pictures, SHEETS / f"{sized.replace('@', '-at-')}.webp")
        print(sized, len(pictures))


main()

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The pictures of the window in docs/images, of the demo, without a screen (Qt's offscreen platform). Words behind the folder choose
among them. Usage: window_pictures.py BUILD_FOLDER [NAME ...]. Needs python3-pil."""
import contextlib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from PIL import Image

SOURCE = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = pathlib.Path(sys.argv[1]).resolve() / "ghostlight"
IMAGES = SOURCE / "docs/images"
BEGIN = "wait opened\njump 36\nwait 0.3\nfreeze on\n"
ALONE = "".join(f"panel-{one} off\n" for one in ("values", "programmer", "scene", "looks"))

# Name: size of the window, lines; {} is where the picture goes.
WINDOWS = {
    "window.png": ("1760x1100", 'panel-programmer on\ncamera close\nselect "Spot 2"\nwait settled\nscreenshot {}\n'),
    "window-looks.jpg": ("1760x1100", 'panel-looks on\ncamera close\nselect "Spot *"\ncolour #00ff80\nintensity 1\nlook-store Chorus\nselect *\n'
                                      'intensity 0.05\nlook-store "Blackout, nearly"\nselect "Spot *"\ncolour #ff3820\nintensity 1\n'
                                      'select "Wash *"\ncolour #5070ff\nintensity 1\nselect *\nlook-store Verse\nlook-recall Verse 0\n'
                                      "wait settled\nscreenshot {}\n"),
    "window-lux.jpg": ("1760x1100", "panel-looks on\ncamera close\nresolution 50\nfalse-colour lux\nprobe 520 790\nwait settled\nwait 2\nscreenshot {}\n"),
    "window-narrow.jpg": ("960x540", 'panel-programmer on\ncamera house\nselect "Spot 2"\nwait settled\nscreenshot {}\n'),
    "guide-baking.jpg": ("1366x768", ALONE + "panel-export on\ncamera house\nwait settled\nbake house 64\nwait 12\nscreenshot {}\ncancel-jobs\n"),
    "guide-network.jpg": ("1760x760", ALONE + "panel-network on\ncamera house\nresolution 6\nwait 25\nreset-figures\nwait 10\nscreenshot {}\n"),
    "guide-patching.jpg": ("1366x768", ALONE + 'camera house\nselect "Spot *"\naddress 2.101\nwait settled\nscreenshot {}\n'),
}


# What is cut out of the picture of the window: the panel alone.
CROPS = {"guide-network.jpg": (286, 330, 1760, 692)}


@contextlib.contextmanager
def desk(plays):
    """The demo's recording as a desk, on this machine alone."""
    sender = subprocess.Popen([str(PROGRAM), "play", str(SOURCE / "assets/demo/demo.show"), "--to", "127.0.0.1", "--loop", "--quiet",
                               "--from", "20"]) if plays else None
    try:
        yield
    finally:
        if sender:
            sender.terminate()
            sender.wait()


def run(work, size, lines, hears=False):
    shutil.rmtree(work / "demo", ignore_errors=True)
    shutil.copytree(SOURCE / "assets/demo", work / "demo", ignore=shutil.ignore_patterns(".ghost"))
    script = work / "script.txt"
    script.write_text(("wait opened\n" if hears else BEGIN) + lines + "quit\n")
    subprocess.run([str(PROGRAM), "open", str(work / "demo"), "--forget", "--quiet", "--language", "en", *(("--interface", "lo") if hears else ("--no-desk",)), "--size", size, "--script", str(script)],
                   env=dict(os.environ, QT_QPA_PLATFORM="offscreen", XDG_CONFIG_HOME=str(work)), check=True)


def main():
    wanted = sys.argv[2:] or [*WINDOWS, "guide-haze.jpg"]
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / "fixtures").symlink_to(SOURCE / "assets/fixtures")
        shot = work / "shot.png"
        for name in wanted:
            if name in WINDOWS:
                size, lines = WINDOWS[name]
                hears = "panel-network" in lines
                with desk(hears):
                    run(work, size, lines.replace("{}", f'"{shot}"'), hears)
                picture = Image.open(shot).convert("RGB").crop(CROPS.get(name))
            else:  # guide-haze.jpg: smoke 0, 1 and 3 beside each other
                parts = [work / f"smoke-{smoke}.png" for smoke in (0, 1, 3)]
                run(work, "480x600", ALONE + "panel-fixtures off\ncamera close\n" +
                    "".join(f'smoke {part.stem[-1]}\nwait settled\nsave-picture "{part}"\n' for part in parts))
                picture = Image.new("RGB", (1208, 447))
                for i, part in enumerate(parts):
                    one = Image.open(part).convert("RGB")
                    one = one.resize((round(one.width * 447 / one.height), 447), Image.LANCZOS)
                    left = max(one.width - 400, 0) // 2
                    picture.paste(one.crop((left, 0, left + 400, 447)), (404 * i, 0))
            picture.save(IMAGES / name, quality=88, optimize=True)
            print(name)


main()

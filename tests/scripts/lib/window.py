# SPDX-License-Identifier: Apache-2.0
"""For tests of the window: a screen of its own (Xvfb), a copy of the demo, and the window as a process that is driven over its socket,
with a real mouse and keyboard (xdotool). Used by window_test.py and window_work_test.py: main() sets their WORK, the folder of
begin(), and runs their tests, which open Window()s."""
import contextlib
import json
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import needs  # noqa: E402

needs.packages("xvfb", "xdotool", "python3-numpy", "python3-pil")
import numpy  # noqa: E402
from PIL import Image  # noqa: E402

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
PICTURES = pathlib.Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None

WORK = None
DISPLAY = None
LONG_S = 600  # for what a busy machine may take


class Window:
    """A window of its own process, with the demo, driven over its socket."""

    def __init__(self, *arguments, show=None, before=(), environment=None, folder=None, remembers=False):
        """show: False for none; before: a command that runs it, like ip netns exec; environment: more of it; folder: in which it runs; remembers: what the
        window before it kept."""
        self.socket_path = str(WORK / f"socket-{os.getpid()}-{time.monotonic_ns()}")
        environment = dict(os.environ, DISPLAY=DISPLAY, XDG_CONFIG_HOME=str(WORK / "config"), LC_ALL="C.UTF-8", LANGUAGE="en",
                           **(environment or {}))
        environment.pop("WAYLAND_DISPLAY", None)
        environment.pop("QT_QPA_PLATFORM", None)
        self.log = open(WORK / "window.log", "w+")
        self.process = subprocess.Popen([*before, str(PROGRAM), "open", *([] if show is False else [str(show or WORK / "demo")]), *([] if remembers else ["--forget"]),
                                         "--socket", self.socket_path, *map(str, arguments)], env=environment, cwd=folder, stderr=self.log, stdout=self.log)
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(LONG_S)
        for _ in range(LONG_S * 10):
            try:
                self.socket.connect(self.socket_path)
                break
            except OSError:
                assert self.process.poll() is None, self.text()
                time.sleep(0.1)
        self.answers = self.socket.makefile()

    def text(self):
        self.log.flush()
        return pathlib.Path(self.log.name).read_text()

    def ask(self, line):
        self.socket.sendall((line + "\n").encode())
        return self.answers.readline().strip()

    def do(self, *lines):
        for line in lines:
            answer = self.ask(line)
            assert answer == "ok", f"{line}: {answer}\n{self.text()}"

    def state(self):
        self.do(f'state "{WORK / "state.json"}"')
        return json.loads((WORK / "state.json").read_text())

    def until(self, holds):
        """Waits for a state that holds: keys and clicks take their way through the screen."""
        for _ in range(LONG_S * 5):
            state = self.state()
            if holds(state):
                return state
            time.sleep(0.2)
        raise AssertionError(json.dumps(state, indent=1))

    def until_picture(self):
        """Waits for the first one of a show."""
        file = WORK / "first.png"
        until_s = time.monotonic() + LONG_S
        while "no picture yet" in self.ask(f'save-picture "{file}"'):
            assert time.monotonic() < until_s, self.text()
            time.sleep(0.1)

    def picture(self, name):
        """The picture of the stage, at rest; values 0..255 as floats."""
        file = WORK / f"{name}.png"
        self.do("wait settled", f'save-picture "{file}"')
        return numpy.asarray(Image.open(file).convert("RGB")).astype(float)

    def shoot(self, name):
        if PICTURES:
            self.do("wait settled", f'screenshot "{PICTURES / name}"')

    def xdo(self, *arguments):
        subprocess.run(["xdotool", *map(str, arguments)], env=dict(os.environ, DISPLAY=DISPLAY), check=True, timeout=60)

    def place(self):
        """Of the picture on the screen: x, y, width, height."""
        return self.state()["view"]

    def close(self):
        if self.process.poll() is None:
            self.do("quit")
        code = self.process.wait(timeout=LONG_S)
        self.socket.close()
        return code


def changed(a, b):
    return float(numpy.abs(a - b).mean())


@contextlib.contextmanager
def begin(*screen_arguments):
    """Sets WORK, a folder that goes away, with a copy of the demo in it, and DISPLAY."""
    global WORK, DISPLAY
    with tempfile.TemporaryDirectory() as folder:
        WORK = pathlib.Path(folder)
        shutil.copytree(SOURCE / "assets/demo", WORK / "demo", ignore=shutil.ignore_patterns(".ghost"))
        (WORK / "fixtures").symlink_to(SOURCE / "assets/fixtures")
        reader, writer = os.pipe()
        screen = subprocess.Popen(["Xvfb", "-displayfd", str(writer), *(screen_arguments or ("-screen", "0", "1600x1000x24")), "-nolisten", "tcp"],
                                  pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        try:
            DISPLAY = ":" + os.fdopen(reader).readline().strip()
            yield WORK
        finally:
            screen.terminate()
            screen.wait()


def main(tests, *screen_arguments):
    """Runs the tests of a module; words behind the three folders choose among them. Returns the exit code."""
    with begin(*screen_arguments) as tests.WORK:
        program = unittest.main(module=tests, argv=[sys.argv[0], *sys.argv[4:]], exit=False, verbosity=2)
    return 0 if program.result.wasSuccessful() else 1

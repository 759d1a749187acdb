# SPDX-License-Identifier: Apache-2.0
"""A show for browsers to look at, hostile in its names, with a book and a desk that plays, and `ghostlight serve` of it."""
import pathlib
import re
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import xml.sax.saxutils
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
LOOKS = """
[[look]]
name = "<b>Verse</b>"
fade_s = 1.5
[[look.fixture]]
name = "Wash 1"
intensity = 1.0
[[look]]
name = "Dark"
[[look.fixture]]
name = "Wash 1"
intensity = 0.0
"""
LONG_S = 300  # for what a busy machine may take
SCREENS = ("picture", "rig", "looks", "stage", "book", "state")
EVIL = "<img src=x onerror=window.hacked=1><script>hacked=1</script>"  # 64 bytes at most, as the name of a source


def free_port(kind=socket.SOCK_STREAM):
    with socket.socket(socket.AF_INET, kind) as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def sacn(number, levels):
    """A packet of universe 1 (ANSI E1.31)."""
    head = struct.pack(">HH12sHI16s", 0x10, 0, b"ASC-E1.17\0\0\0", 0x7000 | 622, 4, b"ghostlight-tests")
    frame = struct.pack(">HI64sBHBBH", 0x7000 | 600, 2, EVIL.encode(), 100, 0, number & 255, 0, 1)
    return head + frame + struct.pack(">HBBHHHB", 0x7000 | 523, 2, 0xA1, 0, 1, 513, 0) + levels


def make_show(source, work):
    """The demo with a hostile name, looks and cues; a fixture may not have one."""
    show = work / "demo"
    shutil.copytree(source / "assets/demo", show, ignore=shutil.ignore_patterns(".ghost"))
    (work / "fixtures").symlink_to(source / "assets/fixtures")
    toml = show / "show.toml"
    text = toml.read_text(encoding="utf-8")
    assert 'name = "Demo"' in text
    text = text.replace('name = "Demo"', f"name = '{EVIL}'", 1)
    toml.write_text(f"{text}\n[[cue]]\nname = '{EVIL}'\nat_s = 20\n[[cue]]\nname = 'Close'\ncamera = 'close'\n", encoding="utf-8")
    (show / "looks.toml").write_text(LOOKS, encoding="utf-8")
    return show


def make_book(program, show, work):
    """One whose entry differs from an older one."""
    book, old = work / "book", work / "old"
    small = ["--size", "160x90", "--looks", "--view", "house", "--quiet"]
    subprocess.run([program, "book", show, "-o", old, *small], check=True)
    (show / "looks.toml").write_text(LOOKS.replace("intensity = 1.0", "intensity = 0.4"), encoding="utf-8")
    subprocess.run([program, "book", show, "-o", book, "--against", old, *small], check=True)
    (show / "looks.toml").write_text(LOOKS, encoding="utf-8")
    return book


class Desk(threading.Thread):
    """Sends a look of the demo by sACN to one port, until it is told to end."""

    def __init__(self, source, port):
        super().__init__(daemon=True)
        sys.path.insert(0, str(source / "tools/demo_show"))
        from desk_looks import red_and_blue
        self.port = port
        self.levels = bytes(red_and_blue()[0])
        self.ends = threading.Event()

    def run(self):
        out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        number = 0
        while not self.ends.wait(1 / 30):
            number += 1
            out.sendto(sacn(number, self.levels), ("127.0.0.1", self.port))


ADDRESS = r"(http://127\.0\.0\.1:\d+/#t=[0-9a-f]{32})"


class Serve:
    def __init__(self, program, show, port, *arguments, view="house"):
        self.path = show.parent / f"serve-{port}-{time.monotonic_ns()}.out"
        self.out = self.path.open("w")
        self.process = subprocess.Popen([str(program), "serve", str(show), "--web", str(port), "--size", "640x360", *(["--view", view] if view else []),
                                         "--interface", "127.0.0.1", *map(str, arguments)], stdout=self.out, stderr=self.out)
        self.port = port
        self.address = self.until(ADDRESS)
        self.token = self.address.rpartition("=")[2]
        self.control = self.until(r"with control[^\n]*\n\s*" + ADDRESS) if "--control" in arguments else None
        self.digits = self.until(r"the digits (\d{6})")

    def text(self):
        return self.path.read_text(encoding="utf-8")

    def until(self, pattern):
        for _ in range(LONG_S * 10):
            if found := re.search(pattern, self.text()):
                return found[1]
            assert self.process.poll() is None, self.text()
            time.sleep(0.1)
        raise AssertionError(f"never {pattern}: {self.text()}")

    def close(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        self.out.close()
        return self.process.wait(timeout=LONG_S)


class WebShow:
    """All of it, in a folder of its own."""

    def __init__(self, source, build, with_book=True):
        self.program = pathlib.Path(build) / "ghostlight"
        self.work = pathlib.Path(tempfile.mkdtemp(prefix="ghost-web-"))
        self.show = make_show(pathlib.Path(source), self.work)
        self.book = make_book(self.program, self.show, self.work) if with_book else None
        self.sacn = free_port(socket.SOCK_DGRAM)
        self.desk = Desk(pathlib.Path(source), self.sacn)
        self.desk.start()

    @classmethod
    def of_evil_names(cls, source, build):
        """A plot with script in the names of fixtures, layer and position; show files allow no such fixtures."""
        made = cls(source, build, with_book=False)
        type_file = pathlib.Path(source) / "assets/fixtures/Vari-Lite@VL2500_Wash.gdtf"
        evil = xml.sax.saxutils.quoteattr(EVIL)
        fixtures = "".join(
            f'<Fixture uuid="00000000-0000-0000-0000-{number:012}" name={evil}><Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{1000 * number},2000,6000}}</Matrix>'
            f"<GDTFSpec>{type_file.name}</GDTFSpec><FixtureID>{number}</FixtureID><Addresses><Address break=\"0\">{1 + 20 * number}</Address></Addresses></Fixture>"
            for number in range(1, 4))
        made.show = made.work / "plot.mvr"
        with zipfile.ZipFile(made.show, "w") as archive:
            archive.writestr("GeneralSceneDescription.xml", '<?xml version="1.0"?><GeneralSceneDescription verMajor="1" verMinor="6"><Scene><Layers>'
                             f'<Layer name={evil} uuid="1"><ChildList>{fixtures}</ChildList></Layer></Layers></Scene></GeneralSceneDescription>')
            archive.write(type_file, type_file.name)
        return made

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def serve(self, *arguments, port=None, view="house"):
        return Serve(self.program, self.show, port or free_port(), *arguments, view=view)

    def serve_desk(self, *arguments, port=None):
        """What the desk plays; with the book, where there is one."""
        book = ["--book", self.book] if self.book else []
        return self.serve("--sacn-port", self.sacn, "--protocols", "sacn", *book, *arguments, port=port)

    def close(self):
        self.desk.ends.set()
        shutil.rmtree(self.work)

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Browsers that look on: ghostlight serve and a real Chromium. A red lamp is red in the page, every screen is walked through by keys, on a
phone and on a laptop, with an empty console; foreign pages and rebound names see nothing; the server goes and comes back.
Usage: web_test.py SOURCE_FOLDER BUILD_FOLDER [FOLDER_FOR_PICTURES]."""
import base64
import http.server
import io
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
import unittest

from lib import needs

needs.packages("chromium", "python3-numpy", "python3-pil")
import numpy  # noqa: E402
from PIL import Image  # noqa: E402

from lib.browser import Browser  # noqa: E402

SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
PICTURES = pathlib.Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None
PROGRAM = BUILD / "ghostlight"
WORK = pathlib.Path(tempfile.mkdtemp(prefix="ghost-web-"))
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


def make_show():
    """The demo with a hostile name, looks and cues; a fixture may not have one."""
    show = WORK / "demo"
    shutil.copytree(SOURCE / "assets/demo", show, ignore=shutil.ignore_patterns(".ghost"))
    (WORK / "fixtures").symlink_to(SOURCE / "assets/fixtures")
    toml = show / "show.toml"
    text = toml.read_text(encoding="utf-8")
    assert 'name = "Demo"' in text
    text = text.replace('name = "Demo"', f"name = '{EVIL}'", 1)
    toml.write_text(f"{text}\n[[cue]]\nname = '{EVIL}'\nat_s = 20\n[[cue]]\nname = 'Close'\ncamera = 'close'\n", encoding="utf-8")
    (show / "looks.toml").write_text(LOOKS, encoding="utf-8")
    return show


def make_book(show):
    """One whose entry differs from an older one."""
    book, old = WORK / "book", WORK / "old"
    small = ["--size", "160x90", "--looks", "--view", "house", "--quiet"]
    subprocess.run([PROGRAM, "book", show, "-o", old, *small], check=True)
    (show / "looks.toml").write_text(LOOKS.replace("intensity = 1.0", "intensity = 0.4"), encoding="utf-8")
    subprocess.run([PROGRAM, "book", show, "-o", book, "--against", old, *small], check=True)
    (show / "looks.toml").write_text(LOOKS, encoding="utf-8")
    return book


class Desk(threading.Thread):
    """Sends a look of the demo by sACN to one port, until it is told to end."""

    def __init__(self, port):
        super().__init__(daemon=True)
        sys.path.insert(0, str(SOURCE / "tools/demo_show"))
        from lib.desk_looks import red_and_blue
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
    def __init__(self, show, port, *arguments):
        self.path = WORK / f"serve-{port}-{time.monotonic_ns()}.out"
        self.out = self.path.open("w")
        self.process = subprocess.Popen([str(PROGRAM), "serve", str(show), "--web", str(port), "--size", "640x360", "--view", "house",
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


class Web(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.show = make_show()
        cls.sacn = free_port(socket.SOCK_DGRAM)
        cls.desk = Desk(cls.sacn)
        cls.desk.start()
        cls.book = make_book(cls.show)
        cls.serve = Serve(cls.show, free_port(), "--sacn-port", cls.sacn, "--protocols", "sacn", "--control", "--book", cls.book)
        cls.browser = Browser("--host-resolver-rules=MAP rebound.example 127.0.0.1")

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        code = cls.serve.close()
        cls.desk.ends.set()
        assert code == 0, cls.serve.text()
        log = re.sub(r"http://127\S+", "", cls.serve.text())
        for token in (cls.serve.token, cls.serve.control.rpartition("=")[2]):
            assert token not in log, "the token is in an address alone, in no other output"
        shutil.rmtree(WORK)

    def home(self):
        return f"http://127.0.0.1:{self.serve.port}/"

    def picture(self, page):
        """The canvas of the page, as the server's picture."""
        url = page.value("document.querySelector('canvas').toDataURL('image/png')")
        return numpy.asarray(Image.open(io.BytesIO(base64.b64decode(url.partition(",")[2]))).convert("RGB")).astype(float)

    def until_red(self, page):
        for _ in range(LONG_S * 2):
            picture = self.picture(page)
            height, width = picture.shape[:2]
            red, green, blue = picture[height // 4:height * 3 // 5, width * 3 // 10:width * 7 // 10].mean(axis=(0, 1))
            if red > 40 and red > 2 * blue and red > 2 * green:
                return
            time.sleep(0.5)
        self.fail(f"never red: {red}, {green}, {blue}")

    def test_a_red_lamp_is_red_and_every_screen_is_there(self):
        for name, width, height in (("phone", 390, 844), ("laptop", 1280, 800)):
            with self.subTest(name):
                page = self.browser.page(self.serve.address, width, height)
                page.until("document.querySelector('.line').textContent === 'live'")
                self.assertEqual(page.value("location.hash"), "", "the token is wiped from the address")
                page.until("document.querySelector('.under .grow').textContent.includes('from the desk')")
                self.until_red(page)
                for number, screen in enumerate(SCREENS, 1):
                    page.value("document.activeElement.blur()")
                    page.key(str(number))
                    page.until(f"!document.querySelector('ghost-{screen}').hidden")
                    if screen == "rig":
                        page.until("[...document.querySelectorAll('.does')].some(does => does.textContent.startsWith('lit'))")
                        page.value("[...document.querySelectorAll('.lamps button')].find(button => button.textContent.includes('Wash 1')).click()")
                        page.until("document.querySelector('.why pre')?.textContent.length > 100")
                    if screen == "looks":
                        page.until("document.querySelectorAll('ghost-looks .card img').length === 2")
                        self.assertEqual(page.value("document.querySelectorAll('ghost-looks button:not([hidden])').length - "
                                                    "document.querySelectorAll('ghost-looks .tools button').length"), 0, "who looks on recalls nothing")
                    if screen == "stage":
                        page.until("document.querySelectorAll('ghost-stage .card img').length === 3")
                        page.value("[...document.querySelectorAll('ghost-stage .card button')].find(one => one.textContent === 'high').click()")
                        page.until("document.querySelector('ghost-stage .grow').textContent.includes('Camera high')")
                        page.until("document.querySelector('ghost-stage canvas').width > 16")
                    if screen == "book":
                        page.until("[...document.querySelectorAll('ghost-book img')].filter(one => one.naturalWidth > 0).length >= 2")
                    if screen == "state":
                        page.until("document.querySelector('ghost-state').innerText.includes('sACN')")
                    time.sleep(0.5)
                    self.assertFalse(page.value("document.documentElement.scrollWidth > innerWidth"), f"{screen} is wider than a {name}")
                    self.assertEqual(page.nameless(), [], screen)
                    small = page.value("[...document.querySelectorAll('button, input')].filter(one => one.offsetParent && "
                                       "(one.offsetHeight < 44 || one.offsetWidth < 44)).map(one => one.textContent)")
                    self.assertEqual(small, [], f"{screen}: targets below 44 px")
                    if PICTURES:
                        page.screenshot(PICTURES / f"web-{screen}-{name}.png")
                self.assertEqual(page.console(), [])
                self.assertEqual(page.value("document.querySelector('#show').textContent"), EVIL)
                self.assertIn(EVIL, page.value("document.querySelector('ghost-state').textContent"), "the name of the source")
                self.assertEqual(page.value("typeof window.hacked"), "undefined")
                self.assertEqual(page.value("[...document.querySelectorAll('main img, main script, main b')].filter(one => !one.src?.startsWith('blob:') && !one.dataset.file).length"), 0)
                page.call("Page.close")

    def test_all_is_reached_by_keys(self):
        page = self.browser.page(self.serve.address, 1280, 800)
        page.until("document.querySelectorAll('.lamps button').length === 10 && document.querySelector('canvas').width > 16")
        reached = []
        for _ in range(20):
            page.key("Tab")
            reached.append(page.value("document.activeElement.textContent.slice(0, 12) || document.activeElement.className || document.activeElement.type"))
        for what in ("To the scree", "Picture", "Rig", "Looks", "Stage", "Book", "State", "stage", "Calm", "search"):
            self.assertIn(what, reached)
        page.value("document.querySelector('.stage').focus()")
        page.key("Enter")
        page.until("document.body.classList.contains('alone') && getComputedStyle(document.querySelector('header')).display === 'none'")
        page.key("Escape")
        page.until("!document.body.classList.contains('alone')")
        page.value("document.querySelector('input[type=search]').focus()")
        page.type("wash 1")
        page.until("document.querySelector('.count').textContent === '1 of 10 lamps'")
        page.call("Page.close")

    def test_who_controls_recalls_looks_and_calls_cues(self):
        page = self.browser.page(self.serve.control, 1280, 800)
        page.until("document.querySelector('.line').textContent === 'live'")
        page.key("3")
        page.until("document.querySelectorAll('ghost-looks .card button').length === 2")
        self.assertEqual(page.value("document.querySelector('ghost-looks .card .name').textContent"), "<b>Verse</b>")
        page.value("document.querySelector('ghost-looks input').value = '0'")
        page.value("document.querySelector('ghost-looks .card button').focus()")
        page.key("Enter")
        page.until("document.querySelector('ghost-looks .card.now .name')?.textContent === '<b>Verse</b>'")
        self.assertEqual(page.value("document.querySelector('.badge:not([hidden])').textContent"), "Now")
        self.assertEqual(page.nameless(), [])
        if PICTURES:
            page.screenshot(PICTURES / "web-looks-control-laptop.png")
            page.size(390, 844)
            page.screenshot(PICTURES / "web-looks-control-phone.png")
            page.size(1280, 800)
        page.key("2")
        page.until("[...document.querySelectorAll('.lamps button')].find(one => one.textContent.includes('Wash 1')).textContent.includes('100 %')")
        page.key("4")
        page.value("[...document.querySelectorAll('ghost-stage .card button')].find(one => one.textContent === 'close').click()")
        page.value("[...document.querySelectorAll('ghost-stage button')].find(one => one.textContent === 'Put the picture there').click()")
        page.key("6")
        page.until("document.querySelector('ghost-state').innerText.includes('close')")
        # What nobody knows is refused, with the reason, and the line stays.
        said = page.value("""import('/a/wire.js').then(({doIt}) => Promise.all([doIt('nothing', []), doIt('haze', [1000]), doIt('look', ['x']),
                             doIt('camera', ['house', 0]), doIt('look', ['Dark', 0])]))""")
        for refused, part in zip(said, ("no address of ours", "0 to 20", "no such look", "", "")):
            self.assertTrue(part in refused if part else refused == "", said)
        page.until("document.querySelector('.line').textContent === 'live'")
        self.assertEqual(page.console(), [])
        page.call("Page.close")

    def test_ones_own_view_orbits_and_measures(self):
        page = self.browser.page(self.serve.address, 1280, 800)
        page.until("document.querySelector('.line').textContent === 'live'")
        page.key("4")
        page.until("document.querySelectorAll('ghost-stage .card').length === 3")
        page.value("[...document.querySelectorAll('ghost-stage button')].find(one => one.textContent === 'My own view').click()")
        page.until("document.querySelector('ghost-stage .grow').textContent.includes('a still')")
        before = page.value("document.querySelector('ghost-stage canvas').toDataURL()")
        page.value("document.querySelector('ghost-stage .stage').focus()")
        for _ in range(3):
            page.key("ArrowRight")
        page.until(f"document.querySelector('ghost-stage canvas').toDataURL() !== {before!r}")
        page.key("Enter")
        page.until("/cd.m\u00b2.*(lux .* on|nothing)/.test(document.querySelector('.measured').textContent)")
        if PICTURES:
            page.screenshot(PICTURES / "web-own-laptop.png")
        # Round a point, by known answers.
        self.assertEqual(page.value("""import('/a/orbit.js').then(({orbitOf, cameraOf, turn, slide, dolly}) => {
            const orbit = orbitOf({position_m: [0, -10, 2], target_m: [0, 0, 2], fov_y_deg: 90});
            turn(orbit, Math.PI / 2, 0); dolly(orbit, 2); slide(orbit, 0.5, 0); return cameraOf(orbit); })"""),
                         {"position_m": [5, 5, 2], "target_m": [0, 5, 2], "fov_y_deg": 90})
        page.value("[...document.querySelectorAll('nav button')][0].click()")
        number = page.value("document.querySelector('ghost-picture canvas').width")
        self.assertGreater(number, 16, "the window's picture again")
        self.assertEqual(page.console(), [])
        page.call("Page.close")

    def test_the_book_is_for_those_with_a_token(self):
        page = self.browser.page(self.serve.address, 1280, 800)
        page.until("document.querySelector('.line').textContent === 'live'")
        page.key("5")
        page.until("document.querySelector('ghost-book h2').textContent.startsWith('Since')")
        page.until("document.querySelectorAll('ghost-book article').length === 2")
        self.assertIn("<b>Verse</b>", page.value("document.querySelector('ghost-book article').textContent"))
        page.until("document.querySelector('ghost-book .old-one')?.naturalWidth > 0")
        page.value("document.querySelector('ghost-book input').focus()")
        page.key("ArrowRight")
        self.assertIn("49%", page.value("document.querySelector('ghost-book .old-one').style.clipPath"))
        for path in ("book/book.json", "book/pictures/0001-1.png"):
            self.assertEqual(page.value(f"fetch('/{path}').then(answer => answer.status)"), 401)
        self.assertEqual(page.value("document.querySelectorAll('ghost-book b').length"), 0)
        page.call("Page.close")

    def test_six_digits_let_in_and_wrong_ones_do_not(self):
        serve = Serve(self.show, free_port(), "--no-desk")  # the digits hold for two minutes
        home = f"http://127.0.0.1:{serve.port}/"
        page = self.browser.page(home, 390, 844)
        page.until("!document.querySelector('ghost-pair').hidden")
        if PICTURES:
            page.screenshot(PICTURES / "web-pair-phone.png")
        for digits in ("000000" if serve.digits != "000000" else "111111", serve.digits):
            page.value("document.querySelector('ghost-pair input').value = ''; document.querySelector('ghost-pair input').focus()")
            page.type(digits)
            page.key("Enter")
            if digits != serve.digits:
                page.until("document.querySelector('.wrong').textContent.includes('not the digits')")
        page.until("document.querySelector('.line').textContent === 'live'")
        page.go(home)
        page.until("document.querySelector('.line').textContent === 'live'")  # this tab keeps it
        page.call("Page.close")
        self.assertEqual(serve.close(), 0)

    def test_a_wrong_token_is_told_so(self):
        page = self.browser.page(self.home() + "#t=" + "0" * 32)
        page.until("document.querySelector('.line').textContent.includes('no longer the right one')")
        self.assertFalse(page.value("Boolean(sessionStorage.length)"))
        page.call("Page.close")

    def test_a_foreign_page_with_the_right_token_sees_nothing(self):
        folder = WORK / "foreign"
        folder.mkdir()
        (folder / "index.html").write_text(f"<!DOCTYPE html><iframe src='{self.home()}'></iframe><p>foreign</p>", encoding="utf-8")
        handler = type("Quiet", (http.server.SimpleHTTPRequestHandler,), {"log_message": lambda *_: None})
        with http.server.ThreadingHTTPServer(("127.0.0.1", 0), lambda *words: handler(*words, directory=str(folder))) as foreign:
            threading.Thread(target=foreign.serve_forever, daemon=True).start()
            page = self.browser.page(f"http://127.0.0.1:{foreign.server_port}/")
            page.until("document.body.innerText.includes('foreign')")
            socket_ends = f"""new Promise(done => {{
                const one = new WebSocket('ws://127.0.0.1:{self.serve.port}/live', ['ghostlight.1', 't.{self.serve.token}']);
                one.onopen = () => done('open'); one.onclose = () => done('closed'); }})"""
            self.assertEqual(page.value(socket_ends), "closed")
            for path in ("", "a/main.js", "right"):
                self.assertEqual(page.value(f"fetch('{self.home()}{path}').then(() => 'read', () => 'refused')"), "refused", path)
            self.assertEqual(page.value(f"""fetch('{self.home()}pair', {{method: 'POST', headers: {{'Content-Type': 'application/json'}},
                body: '{{"code":"{self.serve.digits}"}}'}}).then(() => 'read', () => 'refused')"""), "refused")
            self.assertTrue(any("frame-ancestors" in said for said in page.console()), "it is not framed")
            foreign.shutdown()
            page.call("Page.close")

    def test_a_rebound_name_gets_no_page(self):
        page = self.browser.page(f"http://rebound.example:{self.serve.port}/")
        page.until("document.body.innerText.includes('not called so')")
        page.call("Page.close")

    def test_the_line_is_lost_said_and_found_again(self):
        port = free_port()
        more = ("--sacn-port", self.sacn, "--protocols", "sacn")
        serve = Serve(self.show, port, *more)
        page = self.browser.page(serve.address)
        page.until("document.querySelector('canvas').width > 16")
        serve.process.kill()
        serve.process.wait()
        page.until("document.querySelector('.line').textContent.includes('trying again')")
        page.until("document.querySelector('ghost-picture').classList.contains('old')")
        self.assertTrue(page.value("document.querySelector('#spoken').textContent.includes('lost')"))
        if PICTURES:
            page.screenshot(PICTURES / "web-lost-laptop.png")
        again = Serve(self.show, port, *more)  # with another token
        page.until("document.querySelector('.line').textContent.includes('no longer the right one')")
        page.go(again.address)
        page.until("document.querySelector('.line').textContent === 'live'")
        self.assertEqual(again.close(), 0)
        page.call("Page.close")


if __name__ == "__main__":
    program = unittest.main(argv=[sys.argv[0], *sys.argv[4:]], exit=False, verbosity=2)
    sys.exit(0 if program.result.wasSuccessful() else 1)

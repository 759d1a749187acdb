#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Browsers that look on: ghostlight serve and a real Chromium. A red lamp is red in the page, every screen is walked through by keys, on a
phone and on a laptop, with an empty console; foreign pages and rebound names see nothing; the server goes and comes back.
Usage: web_test.py SOURCE_FOLDER BUILD_FOLDER [FOLDER_FOR_PICTURES]."""
import base64
import http.server
import io
import json
import pathlib
import re
import subprocess
import sys
import threading
import time
import unittest

from lib import needs

needs.packages("chromium", "python3-numpy", "python3-pil")
import numpy  # noqa: E402
from PIL import Image  # noqa: E402

from lib.browser import LOW_CONTRAST, Browser  # noqa: E402
from lib.web_show import EVIL, LONG_S, SCREENS, WebShow, free_port  # noqa: E402

SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
PICTURES = pathlib.Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None
class Web(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.show = WebShow(SOURCE, BUILD)
        cls.serve = cls.show.serve_desk("--control")
        cls.browser = Browser("--host-resolver-rules=MAP rebound.example 127.0.0.1")

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        code = cls.serve.close()
        assert code == 0, cls.serve.text()
        log = re.sub(r"http://127\S+", "", cls.serve.text())
        for token in (cls.serve.token, cls.serve.control.rpartition("=")[2]):
            assert token not in log, "the token is in an address alone, in no other output"
        cls.show.close()

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
                    self.assertEqual(page.value(LOW_CONTRAST), [], f"{screen} on a {name}: less than 4.5 to 1")
                    self.assertEqual(page.not_reached_by_tab(), [], f"{screen} on a {name}: by keys")
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

    def test_text_of_twice_the_size_fits(self):
        page = self.browser.page(self.serve.address, 1280, 800)
        page.until("document.querySelector('.line').textContent === 'live'")
        page.value("document.documentElement.style.fontSize = '200%'")
        for number, screen in enumerate(SCREENS, 1):
            page.value("document.activeElement.blur()")
            page.key(str(number))
            page.until(f"!document.querySelector('ghost-{screen}').hidden")
            time.sleep(0.3)
            self.assertFalse(page.value("document.documentElement.scrollWidth > innerWidth"), f"{screen} is wider than the page")
            cut = page.value("[...document.querySelectorAll('button')].filter(one => one.offsetParent && one.scrollWidth > one.clientWidth + 1)"
                             ".map(one => one.textContent)")
            self.assertEqual(cut, [], f"{screen}: words of buttons are cut")
            if PICTURES:
                page.screenshot(PICTURES / f"web-{screen}-twice.png")
        page.call("Page.close")

    def test_a_show_with_script_in_every_name(self):
        with WebShow.of_evil_names(SOURCE, BUILD) as show:
            serve = show.serve("--no-desk", view=None)
            page = self.browser.page(serve.address, 390, 844)
            page.until("document.querySelector('.line').textContent === 'live'")
            for number, screen in enumerate(SCREENS, 1):
                page.value("document.activeElement.blur()")
                page.key(str(number))
                page.until(f"!document.querySelector('ghost-{screen}').hidden")
                if screen == "rig":
                    page.until("document.querySelectorAll('.lamps button').length === 3")
                    page.value("document.querySelector('.lamps button').click()")
                    page.until("document.querySelector('.why pre')?.textContent.length > 100")
                time.sleep(0.3)
                self.assertFalse(page.value("document.documentElement.scrollWidth > innerWidth"), screen)
            self.assertIn(EVIL, page.value("document.querySelector('ghost-rig').textContent"))
            self.assertEqual(page.value("typeof window.hacked"), "undefined")
            self.assertEqual(page.value("[...document.querySelectorAll('main img, main script')].filter(one => !one.src?.startsWith('blob:')).length"), 0)
            # Of this show no cue book was made; the screen says so.
            self.assertIn("no cue book is given", page.value("document.querySelector('ghost-book').textContent"))
            self.assertEqual(page.console(), [])
            page.call("Page.close")
            self.assertEqual(serve.close(), 0)

    def test_a_clients_tour_opens_from_a_stick(self):
        tour = self.show.work / "tour"
        subprocess.run([self.show.program, "tour", self.show.show, "-o", tour, "--looks", "--view", "house", "--size", "160x90", "--quiet"], check=True)
        for name, width, height in (("phone", 390, 844), ("laptop", 1280, 800)):
            page = self.browser.page((tour / "index.html").as_uri(), width, height)
            page.until("document.images.length >= 2 && [...document.images].slice(0, 2).every(one => one.naturalWidth === 160)")
            page.value("document.querySelector('input[type=range]').focus()")
            page.key("ArrowRight")
            page.until("document.querySelector('.slide .old').style.clipPath.includes('49%')")
            page.value("document.querySelector('.slide + input + button').click()")
            for share in ("100%", "0px 0%", "100%"):  # by turns
                page.until(f"document.querySelector('.slide .old').style.clipPath.includes('{share}')")
            page.value("document.querySelector('.slide + input + button').click()")
            self.assertFalse(page.value("document.documentElement.scrollWidth > innerWidth"), name)
            self.assertEqual(page.nameless(), [])
            self.assertEqual(page.value(LOW_CONTRAST), [])
            self.assertEqual(page.not_reached_by_tab(), [])
            self.assertEqual(page.console(), [])
            self.assertEqual(page.value("typeof window.hacked"), "undefined")
            if PICTURES:
                page.screenshot(PICTURES / f"web-tour-{name}.png")
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
        page.key("6")
        page.until("!document.querySelector('ghost-state').hidden")
        page.key("5")
        page.until("!document.querySelector('ghost-book').hidden")
        page.value("document.querySelector('ghost-book .slide + input + button').click()")
        for share in ("0", "100", "0"):
            page.until(f"document.querySelector('ghost-book .slide + input').value === '{share}'")
        page.value("document.querySelector('ghost-book .slide + input + button').click()")
        for path in ("book/book.json", "book/pictures/0001-1.png"):
            self.assertEqual(page.value(f"fetch('/{path}').then(answer => answer.status)"), 401)
        self.assertEqual(page.value("document.querySelectorAll('ghost-book b').length"), 0)
        difference = self.show.book / "difference.json"
        good = difference.read_text(encoding="utf-8")
        try:
            difference.write_text(json.dumps({**json.loads(good), "entries": "abc"}), encoding="utf-8")
            page.value("document.querySelector('ghost-book .tools button').click()")
            page.until("document.querySelector('ghost-book .bad') !== null")
            self.assertIn("'entries' is not a list", page.value("document.querySelector('ghost-book .bad').textContent"))
            self.assertEqual(page.value("document.querySelectorAll('ghost-book article').length"), 2, "the book itself is well")
        finally:
            difference.write_text(good, encoding="utf-8")
        page.call("Page.close")

    def test_the_book_of_another_server_is_read_anew(self):
        port = free_port()
        serve = self.show.serve_desk(port=port)
        page = self.browser.page(serve.address)
        page.until("document.querySelector('.line').textContent === 'live'")
        page.key("5")
        page.until("document.querySelector('ghost-book h2')?.textContent.startsWith('Since')")
        serve.process.kill()
        serve.process.wait()
        page.until("document.querySelector('.line').textContent.includes('trying again')")
        again = self.show.serve("--sacn-port", self.show.sacn, "--protocols", "sacn", "--book", self.show.work / "old", port=port)
        page.go(again.address)
        page.until("document.querySelector('.line').textContent === 'live'")
        page.until("document.querySelectorAll('ghost-book article').length === 2 && !document.querySelector('ghost-book h2').textContent.startsWith('Since')")
        page.until("document.querySelector('ghost-book img').naturalWidth > 0")
        self.assertEqual(again.close(), 0)
        page.call("Page.close")

    def test_a_page_of_which_a_file_did_not_come_opens_itself_again(self):
        for missing in ("book.js", "main.js", "style.css"):
            page = self.browser.page()
            page.call("Network.setBlockedURLs", urls=[f"*/a/{missing}"])
            page.go(self.serve.address)
            page.until("performance.getEntriesByType('navigation')[0].type === 'reload'")
            page.call("Network.setBlockedURLs", urls=[])
            page.until("document.querySelector('.line').textContent === 'live' && getComputedStyle(document.querySelector('.skip')).position === 'absolute'")
            page.call("Page.close")

    def test_six_digits_let_in_and_wrong_ones_do_not(self):
        serve = self.show.serve("--no-desk")  # the digits hold for two minutes
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
        folder = self.show.work / "foreign"
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
        serve = self.show.serve_desk(port=port)
        page = self.browser.page(serve.address)
        page.until("document.querySelector('canvas').width > 16")
        serve.process.kill()
        serve.process.wait()
        page.until("document.querySelector('.line').textContent.includes('trying again')")
        page.until("document.querySelector('ghost-picture').classList.contains('old')")
        self.assertTrue(page.value("document.querySelector('#spoken').textContent.includes('lost')"))
        if PICTURES:
            page.screenshot(PICTURES / "web-lost-laptop.png")
        again = self.show.serve_desk(port=port)  # with another token
        page.until("document.querySelector('.line').textContent.includes('no longer the right one')")
        page.go(again.address)
        page.until("document.querySelector('.line').textContent === 'live'")
        self.assertEqual(again.close(), 0)
        page.call("Page.close")


if __name__ == "__main__":
    program = unittest.main(argv=[sys.argv[0], *sys.argv[4:]], exit=False, verbosity=2)
    sys.exit(0 if program.result.wasSuccessful() else 1)

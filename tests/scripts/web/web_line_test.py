#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What a page says when its server falls silent, and what it keeps: ghostlight serve, stopped and continued, and a real Chromium.
Usage: web_line_test.py SOURCE_FOLDER BUILD_FOLDER."""
import pathlib
import signal
import sys
import threading
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
from lib import needs  # noqa: E402

needs.packages("chromium")
from lib.browser import Browser  # noqa: E402
from lib.web_show import WebShow  # noqa: E402

SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
LIVE = "document.querySelector('.line').textContent === 'live'"
SILENT = "document.querySelector('.line').textContent === 'nothing is heard; trying again'"
SEEN_AS = "Object.defineProperty(document, 'visibilityState', {get: () => '%s', configurable: true}); document.dispatchEvent(new Event('visibilitychange'))"
HELLO = "import('/a/store.js').then(({put}) => put('hello', {type: 'hello', right: '%s'}))"
MOTION = "Emulation.setEmulatedMedia"
PRESSED = "document.querySelector('ghost-picture button').getAttribute('aria-pressed') === '%s'"


class Line(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.show = WebShow(SOURCE, BUILD, with_book=False)
        cls.serve = cls.show.serve_desk("--control")
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        assert cls.serve.close() == 0, cls.serve.text()
        cls.show.close()

    def setUp(self):
        self.page = self.browser.page(self.serve.control, 1280, 800)
        self.page.until(f"{LIVE} && document.querySelector('canvas').width > 16")

    def tearDown(self):
        self.serve.process.send_signal(signal.SIGCONT)
        self.page.value("localStorage.clear()")
        self.page.call("Page.close")

    def stop(self):
        self.serve.process.send_signal(signal.SIGSTOP)

    def test_a_server_that_stands_still_is_not_live(self):
        page = self.page
        page.until("document.querySelectorAll('.lamps button').length === 10")
        page.value("document.querySelectorAll('nav button')[3].click()")
        page.until("document.querySelectorAll('ghost-stage .card button').length === 3")
        page.value("[...document.querySelectorAll('ghost-stage .card button')].find(one => one.querySelector('.name').textContent === 'high').click()")
        page.until("document.querySelector('ghost-stage canvas').width > 16")
        self.stop()
        began_s = time.monotonic()
        page.value("document.querySelector('ghost-stage .stage').focus()")
        page.key("Enter")
        page.until("document.querySelector('.measured').textContent === 'measuring ...'")
        page.until(SILENT, 20)
        self.assertGreater(time.monotonic() - began_s, 2)
        self.assertIn("lost", page.value("document.querySelector('#spoken').textContent"))
        self.assertIn("not measured", page.value("document.querySelector('.measured').textContent"))
        page.until("document.querySelector('ghost-stage .frame').classList.contains('old') && "
                   "/^[0-9]+ s old$/.test(document.querySelector('ghost-stage .under .bad:not([hidden])').textContent)", 20)
        page.value("document.querySelectorAll('nav button')[0].click()")
        page.until("document.querySelector('ghost-picture').classList.contains('old') && document.querySelector('ghost-rig').classList.contains('old') && "
                   "/^[0-9]+ s old$/.test(document.querySelector('ghost-rig > .bad:not([hidden])').textContent)", 20)
        self.serve.process.send_signal(signal.SIGCONT)
        page.until(f"{LIVE} && !document.querySelector('.old')")
        page.value("document.querySelectorAll('nav button')[3].click()")
        page.until("document.querySelector('.measured').textContent.includes('cd/m')")  # it is asked again

    def test_what_is_still_and_calm_is_live(self):
        for press in (False, True):
            if press:
                self.page.value("document.querySelector('ghost-picture button').click()")
            for screen in range(6):
                self.page.value(f"document.querySelectorAll('nav button')[{screen}].click()")
                for _ in range(40):
                    self.assertTrue(self.page.value(LIVE))
                    time.sleep(0.1)

    def test_a_tab_that_was_hidden_is_listened_to_anew(self):
        self.page.value(SEEN_AS % "hidden")
        self.stop()
        time.sleep(7)
        self.assertTrue(self.page.value(LIVE), "a hidden tab expects nothing")
        self.page.value(SEEN_AS % "visible")
        self.page.until(SILENT, 20)
        self.serve.process.send_signal(signal.SIGCONT)
        self.page.until(LIVE)

    def test_what_was_asked_of_a_silent_server_may_be_done(self):
        self.page.value("document.querySelectorAll('nav button')[2].click()")
        self.page.until("document.querySelectorAll('ghost-looks .card button').length === 2")
        self.stop()
        self.page.value("document.querySelector('ghost-looks .card button').click()")
        said = "document.querySelector('ghost-looks .said-now').textContent"
        self.page.until(f"{said} === 'Perhaps not done: the line was lost.'", 20)
        self.serve.process.send_signal(signal.SIGCONT)
        self.page.until(f"{LIVE} && {said} === ''")

    def test_calm_calms_the_rig_and_is_kept(self):
        stops = threading.Event()
        levels = self.show.desk.levels

        def strobe():
            while not stops.wait(0.1):
                self.show.desk.levels = bytes(512) if self.show.desk.levels == levels else levels

        threading.Thread(target=strobe, daemon=True).start()
        try:
            count = """new Promise(done => { let most = 0; const of = new Map(); const watch = new MutationObserver(all => { for (const one of all) {
                       of.set(one.target, (of.get(one.target) ?? 0) + 1); most = Math.max(most, of.get(one.target)); } });
                       for (const dot of document.querySelectorAll('.dot')) watch.observe(dot, {attributes: true});
                       setTimeout(() => { watch.disconnect(); done(most); }, 6000); })"""
            self.page.until("[...document.querySelectorAll('.does')].some(one => one.textContent.startsWith('lit'))")
            self.page.value("document.querySelector('ghost-picture button').click()")
            self.assertLessEqual(self.page.value(count), 13)
            self.page.call("Page.reload")
            self.page.until(f"{LIVE} && {PRESSED % 'true'}")
            self.page.until("document.querySelectorAll('.dot').length > 0")
            self.page.value("document.querySelector('ghost-picture button').click()")
            self.assertGreater(self.page.value(count), 13, "or the desk is no strobe")
        finally:
            stops.set()
            self.show.desk.levels = levels

    def test_a_system_that_asks_for_less_motion_is_heard_at_once(self):
        self.page.until(PRESSED % "false")
        for wish, pressed in (("reduce", "true"), ("no-preference", "false")):
            self.page.call(MOTION, features=[{"name": "prefers-reduced-motion", "value": wish}])
            self.page.until(PRESSED % pressed)

    def test_control_that_is_taken_back_is_told(self):
        page = self.page
        page.value("document.querySelectorAll('nav button')[2].click()")
        page.until("document.querySelectorAll('ghost-looks .card button').length === 2")
        page.value("document.querySelector('ghost-looks .card button').focus()")
        page.value(HELLO % "view")
        self.assertIn("taken back", page.value("document.querySelector('#spoken').textContent"))
        self.assertIn("taken back", page.value("document.querySelector('.line').textContent"))
        self.assertFalse(page.value("document.querySelector('.line').classList.contains('lost')"))
        self.assertEqual(page.value("document.activeElement.id"), "screens")
        page.value(HELLO % "control")
        self.assertTrue(page.value(LIVE))

    def test_a_wrong_address_leaves_who_is_in(self):
        for is_loaded in (False, True):
            if is_loaded:
                self.page.go("about:blank")
                self.page.until("location.href === 'about:blank'")
            self.page.go(self.serve.control.partition("#")[0] + "#t=" + "0" * 32)
            self.page.until(f"location.hash === '' && {LIVE} && document.querySelector('#spoken').textContent.includes('the one before')")
            self.page.value("document.querySelector('#spoken').textContent = ''")


if __name__ == "__main__":
    program = unittest.main(argv=[sys.argv[0], *sys.argv[3:]], exit=False, verbosity=2)
    sys.exit(0 if program.result.wasSuccessful() else 1)

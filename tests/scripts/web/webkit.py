# SPDX-License-Identifier: Apache-2.0
"""WebKitGTK, the nearest to an iPhone that Debian has, driven by its WebDriver (JSON over HTTP) on a screen of Xvfb's."""
import glob
import json
import os
import shutil
import signal
import socket
import struct
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

from PIL import Image

LONG_S = 300  # for what a busy machine may take

# The driver tells nothing of a console, so the page keeps what it complains of.
LISTEN = """window.complaints = []; for (const kind of ['error', 'warn']) { const before = console[kind];
  console[kind] = (...said) => { complaints.push(said.join(' ')); before.apply(console, said); }; }
  addEventListener('error', event => complaints.push(String(event.message)));
  addEventListener('unhandledrejection', event => complaints.push(String(event.reason)));
  addEventListener('securitypolicyviolation', event => complaints.push(`${event.violatedDirective} ${event.blockedURI}`)); return null;"""


class WebKit:
    def __init__(self):
        self.folder = tempfile.mkdtemp(prefix="ghost-webkit-")
        self.log = open(os.path.join(self.folder, "log"), "w")
        took, tells = os.pipe()
        self.screen = subprocess.Popen(["Xvfb", "-displayfd", str(tells), "-screen", "0", "1400x1000x24", "-fbdir", self.folder], pass_fds=[tells], stdout=self.log, stderr=self.log)
        os.close(tells)
        with os.fdopen(took) as numbers:
            display = numbers.readline().strip()
        with socket.socket() as one:
            one.bind(("127.0.0.1", 0))
            self.port = one.getsockname()[1]
        self.driver = subprocess.Popen(["WebKitWebDriver", f"--port={self.port}"], stdout=self.log, stderr=self.log, start_new_session=True,
                                       env={**os.environ, "DISPLAY": f":{display}", "HOME": self.folder})
        browser = glob.glob("/usr/lib/*/webkit2gtk-4.*/MiniBrowser")[0]
        options = {"webkitgtk:browserOptions": {"binary": browser, "args": ["--automation"]}}
        end_s = time.monotonic() + LONG_S
        while True:
            try:
                self.session = self.ask("POST", "/session", {"capabilities": {"alwaysMatch": options}})["sessionId"]
                break
            except ConnectionError:
                assert time.monotonic() < end_s, "WebKitWebDriver never answered"
                time.sleep(0.2)

    def ask(self, method, path, body=None):
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}{path}", method=method, data=None if body is None else json.dumps(body).encode(),
                                         headers={"Content-Type": "application/json"})
        try:
            with urllib.request.urlopen(request, timeout=LONG_S) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as problem:
            raise AssertionError((method, path, problem.read().decode()[:600])) from None
        except urllib.error.URLError as problem:
            raise ConnectionError(str(problem)) from None

    def call(self, method, path, body=None):
        return self.ask(method, f"/session/{self.session}{path}", body)

    def size(self, width, height):
        """Of the page: the window's own edges come on top."""
        for _ in range(3):
            inner = self.value("[innerWidth, innerHeight]")
            rect = self.call("GET", "/window/rect")
            if inner == [width, height]:
                return
            self.call("POST", "/window/rect", {"width": rect["width"] + width - inner[0], "height": rect["height"] + height - inner[1]})
            time.sleep(0.5)

    def go(self, address):
        """Comes in as a page that is open already does, so that its complaints are heard from the beginning."""
        home, _, fragment = address.partition("#")
        self.call("POST", "/url", {"url": home})
        self.call("POST", "/execute/sync", {"script": LISTEN, "args": []})
        if fragment:
            self.call("POST", "/execute/sync", {"script": f"location.hash = '{fragment}';", "args": []})

    def value(self, expression):
        return self.call("POST", "/execute/sync", {"script": f"return {expression};", "args": []})

    def console(self):
        return self.value("complaints")

    def screen_at_rest(self):
        """A busy machine paints long after the page has changed."""
        self.call("POST", "/execute/async", {"script": "requestAnimationFrame(() => requestAnimationFrame(arguments[0]));", "args": []})
        before = b""
        for _ in range(20):
            time.sleep(0.5)
            with open(os.path.join(self.folder, "Xvfb_screen0"), "rb") as screen:
                data = screen.read()
            if data == before:
                break
            before = data
        return data

    def screenshot(self, path):
        """What Xvfb shows (XWD, as it keeps it in a file): the driver's own waits for a frame that a page at rest does not draw."""
        data = self.screen_at_rest()
        fields = struct.unpack(">25I", data[:100])
        begin, width, height, line = fields[0] + 12 * fields[19], fields[4], fields[5], fields[12]
        whole = Image.frombuffer("RGB", (width, height), data[begin:begin + line * height], "raw", "BGRX", line, 1)
        rect = self.call("GET", "/window/rect")
        whole.crop((rect["x"], rect["y"], min(rect["x"] + rect["width"], width), min(rect["y"] + rect["height"], height))).save(path)

    def close(self):
        try:
            self.call("DELETE", "")
        except (AssertionError, ConnectionError):
            pass
        for process in (self.driver, self.screen):
            process.send_signal(signal.SIGTERM)
            try:
                process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self.log.close()
        shutil.rmtree(self.folder, ignore_errors=True)

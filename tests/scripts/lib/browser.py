# SPDX-License-Identifier: Apache-2.0
"""Debian's Chromium, without a screen, driven over two pipes (DevTools protocol, JSON)."""
import base64
import json
import os
import select
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(__file__))
import needs  # noqa: E402

needs.packages("chromium")
LONG_S = 120  # for what a busy machine may take


# Every text that is seen, and what it stands on: WCAG's contrast; below 4.5, or 3 where it is large.
LOW_CONTRAST = """(() => {
  const channels = text => (text.match(/[0-9.]+/g) ?? []).map(Number);
  const light = ([r, g, b]) => [r, g, b].map(c => c / 255).map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
      .reduce((sum, c, k) => sum + c * [0.2126, 0.7152, 0.0722][k], 0);
  const over = (top, under) => { const a = top[3] ?? 1; return [0, 1, 2].map(k => top[k] * a + under[k] * (1 - a)); };
  const ground = one => {
    if (!one) return [255, 255, 255];
    const own = channels(getComputedStyle(one).backgroundColor);
    return (own[3] ?? 1) >= 1 ? own : over(own, ground(one.parentElement));
  };
  const found = [];
  for (const one of document.querySelectorAll('body *')) {
    const text = [...one.childNodes].filter(node => node.nodeType === 3).map(node => node.textContent.trim()).join('');
    if (!text || !one.checkVisibility({checkVisibilityCSS: true}) || one.closest('.spoken') || one.disabled) continue;
    const style = getComputedStyle(one), under = ground(one);
    const [a, b] = [light(over(channels(style.color), under)), light(under)];
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    const size = parseFloat(style.fontSize), isLarge = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    let shows = 1;
    for (let up = one; up; up = up.parentElement) shows *= Number(getComputedStyle(up).opacity);
    if (ratio < (isLarge ? 3 : 4.5) || shows < 1) found.push(`${text.slice(0, 30)}: ${ratio.toFixed(2)}, opacity ${shows}`);
  }
  return found; })()"""


class Browser:
    """arguments: more of Chromium's own."""

    def __init__(self, *arguments):
        self.folder = tempfile.mkdtemp(prefix="ghost-browser-")
        to_browser, self.out = os.pipe()
        self.incoming, from_browser = os.pipe()
        words = ["chromium", "--headless=new", "--remote-debugging-pipe", "--no-first-run", "--no-default-browser-check", "--disable-gpu",
                 "--disable-background-networking", "--disable-component-update", "--disable-sync", "--password-store=basic",
                 f"--user-data-dir={self.folder}", *(["--no-sandbox"] if os.geteuid() == 0 else []), *arguments]

        # Chromium reads the pipes at 3 and 4.
        shell = f'exec 3<&{to_browser} 4>&{from_browser}; exec "$@"'
        self.log = open(os.path.join(self.folder, "log"), "w+")
        self.process = subprocess.Popen(["/bin/bash", "-c", shell, "bash", *words], pass_fds=[to_browser, from_browser], stdin=subprocess.DEVNULL,
                                        stdout=self.log, stderr=self.log)
        os.close(to_browser)
        os.close(from_browser)
        self.unread = b""
        self.number = 0
        self.events = []

    def read(self, until_s):
        while b"\0" not in self.unread:
            left_s = until_s - time.monotonic()
            if left_s <= 0 or not select.select([self.incoming], [], [], left_s)[0]:
                return None
            more = os.read(self.incoming, 1 << 20)
            assert more, "the browser has ended"
            self.unread += more
        message, _, self.unread = self.unread.partition(b"\0")
        return json.loads(message)

    def call(self, method, session=None, **parameters):
        self.number += 1
        call = {"id": self.number, "method": method, "params": parameters, **({"sessionId": session} if session else {})}
        data = json.dumps(call).encode() + b"\0"
        while data:
            data = data[os.write(self.out, data):]
        until_s = time.monotonic() + LONG_S
        while True:
            message = self.read(until_s)
            assert message, f"no answer to {method}"
            if message.get("id") == self.number:
                assert "error" not in message, (method, message)
                return message["result"]
            self.events.append(message)

    def page(self, address="about:blank", width=1280, height=800, scale=1):
        return Page(self, address, width, height, scale)

    def close(self):
        try:
            self.call("Browser.close")
        except (AssertionError, OSError):
            pass
        try:
            self.process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.out)
        os.close(self.incoming)
        self.log.close()
        shutil.rmtree(self.folder, ignore_errors=True)


class Page:
    def __init__(self, browser, address, width, height, scale):
        self.browser = browser
        self.target = browser.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=self.target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network", "Accessibility"):
            self.call(f"{domain}.enable")
        self.size(width, height, scale)
        self.go(address)

    def call(self, method, **parameters):
        return self.browser.call(method, self.session, **parameters)

    def size(self, width, height, scale=1):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=width < 600)

    def go(self, address):
        self.call("Page.navigate", url=address)

    def value(self, expression):
        """Of an expression of JavaScript, waited for where it is a promise."""
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in result, (expression, result["exceptionDetails"])
        return result["result"].get("value")

    def until(self, expression, seconds=LONG_S):
        """Waits until an expression is true; its value."""
        end_s = time.monotonic() + seconds
        while time.monotonic() < end_s:
            value = self.value(f"(() => {{ try {{ return {expression}; }} catch {{ return null; }} }})()")  # the page may not be there yet
            if value:
                return value
            time.sleep(0.1)
        raise AssertionError(f"never: {expression}; the page says: {self.value('document.body.innerText')}\n{self.console()}")

    def key(self, key, text=""):
        codes = {"Tab": 9, "Enter": 13, "Escape": 27}
        more = {"text": text or "\r"} if text or key == "Enter" else {}
        code = codes.get(key, ord(key[0].upper()) if len(key) == 1 else 0)
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, windowsVirtualKeyCode=code, **more)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key, windowsVirtualKeyCode=code)

    def type(self, text):
        self.call("Input.insertText", text=text)

    def screenshot(self, path=None):
        data = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        if path:
            with open(path, "wb") as out:
                out.write(data)
        return data

    def console(self):
        """What it complained of so far: errors, warnings, exceptions, broken rules of the page's security policy."""
        said = []
        for event in self.browser.events:
            if event.get("sessionId") != self.session:
                continue
            what, with_ = event["method"], event.get("params", {})
            if what == "Runtime.exceptionThrown":
                said.append(json.dumps(with_["exceptionDetails"])[:600])
            elif what == "Runtime.consoleAPICalled" and with_["type"] in ("error", "warning", "assert"):
                said.append(json.dumps(with_["args"])[:600])
            elif what == "Log.entryAdded" and with_["entry"]["level"] in ("error", "warning"):
                said.append(f"{with_['entry']['text']} {with_['entry'].get('url', '')}")
        return said

    def not_reached_by_tab(self):
        """Controls that are seen and that the Tab key never comes to."""
        self.value("""document.activeElement.blur(); window.asked = [...document.querySelectorAll('a[href], button, input, select, summary, [tabindex="0"]')]
            .filter(one => one.checkVisibility({checkVisibilityCSS: true}) && !one.disabled); window.reached = new Set(); null""")
        for _ in range(self.value("asked.length") + 3):
            self.key("Tab")
            self.value("reached.add(document.activeElement); null")
        return self.value("asked.filter(one => !reached.has(one)).map(one => one.outerHTML.slice(0, 120))")

    def nameless(self):
        """Controls that the accessibility tree has no name for."""
        nodes = self.call("Accessibility.getFullAXTree")["nodes"]
        controls = ("button", "textbox", "searchbox", "link", "checkbox", "slider", "image", "img")
        return [node for node in nodes if not node.get("ignored") and node["role"]["value"] in controls and not node.get("name", {}).get("value")]

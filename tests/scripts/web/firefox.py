# SPDX-License-Identifier: Apache-2.0
"""Firefox without a screen, driven by what it speaks itself: WebDriver BiDi (JSON over a WebSocket), by Python's standard library."""
import base64
import json
import os
import re
import shutil
import socket
import struct
import subprocess
import tempfile
import time

LONG_S = 120  # for what a busy machine may take


class Line:
    """A WebSocket of ours (RFC 6455), text alone."""

    def __init__(self, port, path):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=LONG_S)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall(f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode())
        self.unread = b""
        while b"\r\n\r\n" not in self.unread:
            self.more()
        head, _, self.unread = self.unread.partition(b"\r\n\r\n")
        assert b" 101 " in head.split(b"\r\n")[0], head

    def more(self):
        got = self.socket.recv(1 << 20)
        assert got, "the browser has ended"
        self.unread += got

    def take(self, count):
        while len(self.unread) < count:
            self.more()
        taken, self.unread = self.unread[:count], self.unread[count:]
        return taken

    def say(self, text):
        data, mask = text.encode(), os.urandom(4)
        size = struct.pack(">B", 0x80 | len(data)) if len(data) < 126 else struct.pack(">BH", 0xFE, len(data)) if len(data) < 65536 else \
            struct.pack(">BQ", 0xFF, len(data))
        self.socket.sendall(b"\x81" + size + mask + bytes(byte ^ mask[k % 4] for k, byte in enumerate(data)))

    def hear(self):
        whole = b""
        while True:
            first, second = self.take(2)
            size = second & 127
            if size >= 126:
                size = int.from_bytes(self.take(2 if size == 126 else 8), "big")
            payload = self.take(size)
            if first & 15 in (0, 1):
                whole += payload
                if first & 128:
                    return whole.decode()
            assert first & 15 != 8, "the browser has closed the line"


class Firefox:
    def __init__(self):
        self.folder = tempfile.mkdtemp(prefix="ghost-firefox-")
        self.path = os.path.join(self.folder, "log")
        with open(self.path, "w") as log:
            self.process = subprocess.Popen(["firefox-esr", "--headless", "--no-remote", "--profile", self.folder, "--remote-debugging-port=0"],
                                            stdin=subprocess.DEVNULL, stdout=log, stderr=log, env={**os.environ, "HOME": self.folder})
        self.line = Line(self.port(), "/session")
        self.number = 0
        self.said = []
        self.call("session.new", capabilities={})
        self.call("session.subscribe", events=["log.entryAdded"])
        self.context = self.call("browsingContext.getTree")["contexts"][0]["context"]

    def port(self):
        end_s = time.monotonic() + LONG_S
        while time.monotonic() < end_s:
            with open(self.path) as log:
                if found := re.search(r"WebDriver BiDi listening on ws://127\.0\.0\.1:(\d+)", log.read()):
                    return int(found[1])
            assert self.process.poll() is None, "Firefox has ended"
            time.sleep(0.1)
        raise AssertionError("Firefox never listened")

    def call(self, method, **parameters):
        self.number += 1
        self.line.say(json.dumps({"id": self.number, "method": method, "params": parameters}))
        while True:
            message = json.loads(self.line.hear())
            if message.get("id") == self.number:
                assert message["type"] == "success", (method, message)
                return message["result"]
            if message.get("method") == "log.entryAdded":
                entry = message["params"]
                if entry["level"] in ("error", "warn"):
                    self.said.append(entry.get("text") or json.dumps(entry)[:400])

    def size(self, width, height):
        self.call("browsingContext.setViewport", context=self.context, viewport={"width": width, "height": height})

    def go(self, address):
        self.call("browsingContext.navigate", context=self.context, url=address, wait="interactive")

    def value(self, expression):
        """Of an expression of JavaScript that JSON can hold."""
        result = self.call("script.evaluate", expression=f"JSON.stringify({expression})", target={"context": self.context}, awaitPromise=True)
        assert result["type"] == "success", (expression, result)
        return json.loads(result["result"]["value"]) if result["result"]["type"] == "string" else None

    def console(self):
        return self.said

    def screenshot(self, path):
        with open(path, "wb") as out:
            out.write(base64.b64decode(self.call("browsingContext.captureScreenshot", context=self.context)["data"]))

    def close(self):
        try:
            self.call("browser.close")
        except (AssertionError, OSError):
            pass
        try:
            self.process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

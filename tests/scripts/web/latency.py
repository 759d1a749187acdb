#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""How long a picture takes from drawn to the screen of Chromium on the same machine, and how soon a page has its first one: figures of
docs/measurements/performance.md, no test. `serve` plays the demo's own recording; a page says when it painted a picture, and its next frame is
the screen. Usage: latency.py SOURCE_FOLDER BUILD_FOLDER [SECONDS]."""
import pathlib
import statistics
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "lib"))
from browser import Browser  # noqa: E402
from web_show import WebShow  # noqa: E402

SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
SECONDS = float(sys.argv[3]) if len(sys.argv) > 3 else 30
# Between the page and its line: when each picture was drawn (the server's clock), and when the frame after it was painted came.
LISTEN = """(() => {
  const drawn = new Map(), send = WebSocket.prototype.send;
  window.seen = []; window.firstMs = window.showMs = null;
  window.WebSocket = class extends WebSocket {
    constructor(...words) {
      super(...words);
      this.addEventListener('message', ({data}) => {
        if (typeof data === 'string' && JSON.parse(data).type === 'show') showMs ??= performance.now();
        if (typeof data === 'string') return;
        const bytes = new DataView(data);
        if (bytes.getUint8(0) === 1) drawn.set(bytes.getUint32(4, true), bytes.getFloat64(8, true));
      });
    }
    send(data) {
      send.call(this, data);
      if (typeof data === 'string' || data.byteLength !== 5) return;
      const number = new DataView(data).getUint32(1, true);
      requestAnimationFrame(() => {
        const now = performance.now();
        firstMs ??= now;
        if (window.ageMs) seen.push(ageMs(drawn.get(number)));
      });
    }
  };
})()"""


def part(values, share):
    return sorted(values)[int(share * (len(values) - 1))]


def main():
    browser = Browser()
    with WebShow(SOURCE, BUILD, with_book=False) as show:
        serve = show.serve("--no-desk")
        firsts, shows = [], []
        try:
            for _ in range(6):
                page = browser.page()
                page.call("Page.addScriptToEvaluateOnNewDocument", source=LISTEN)
                page.go(serve.address)
                page.until("firstMs !== null")
                firsts.append(page.value("firstMs"))
                shows.append(page.value("showMs"))
                if len(firsts) < 6:
                    page.call("Page.close")
            page.value("import('/a/wire.js').then(wire => { window.ageMs = wire.ageMs; return true; })")
            time.sleep(6)  # sixteen pings
            page.value("(seen.length = 0, true)")
            time.sleep(SECONDS)
            ages = [age for age in page.value("seen") if age is not None]
        finally:
            browser.close()
            serve.close()
    print(f"first picture after the page was opened, ms: {', '.join(f'{first:.0f}' for first in firsts[1:])}")
    print(f"of the first page, opened as soon as serve had said its address: {firsts[0]:.0f} ms, of which {shows[0]:.0f} until the show was open")
    print(f"drawn to the screen: {len(ages)} pictures in {SECONDS:.0f} s, median {statistics.median(ages):.0f} ms, p95 {part(ages, 0.95):.0f}, "
          f"longest {max(ages):.0f}")


if __name__ == "__main__":
    main()

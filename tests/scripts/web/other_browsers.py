#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Each screen in Firefox and in WebKitGTK, on a phone and on a laptop: the picture comes and is red, the console stays empty, nothing is wider
than the page. Not in the suite, for it wants both browsers: ./dev browsers.
Usage: other_browsers.py SOURCE_FOLDER BUILD_FOLDER [FOLDER_FOR_PICTURES [firefox|webkit]]."""
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "lib"))
import needs  # noqa: E402

needs.packages("firefox-esr", "webkit2gtk-driver", "xvfb", "python3-pil")
from firefox import Firefox  # noqa: E402
from web_show import SCREENS, WebShow  # noqa: E402
from webkit import WebKit  # noqa: E402

SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
PICTURES = pathlib.Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None
BROWSERS = {"firefox": Firefox, "webkit": WebKit}
LONG_S = 180
IN = "document.querySelector('.line').textContent === 'live'"
# The middle of the picture, as the page has it: mean red, green, blue.
MIDDLE = """(() => { const canvas = document.querySelector('ghost-picture canvas'); const {width, height} = canvas; if (width < 100) return null;
  const {data} = canvas.getContext('2d').getImageData(width * 0.3, height * 0.25, width * 0.4, height * 0.35); const sum = [0, 0, 0];
  for (let k = 0; k < data.length; k += 4) for (let c = 0; c < 3; ++c) sum[c] += data[k + c];
  return sum.map(one => one * 4 / data.length); })()"""
READY = {
    "picture": "document.querySelector('ghost-picture canvas').width > 16",
    "rig": "[...document.querySelectorAll('.does')].some(does => does.textContent.startsWith('lit'))",
    "looks": "document.querySelectorAll('ghost-looks .card img').length === 2",
    "stage": "document.querySelectorAll('ghost-stage .card img').length === 3",
    "book": "[...document.querySelectorAll('ghost-book img')].filter(one => one.naturalWidth > 0).length >= 2",
    "state": "document.querySelector('ghost-state').innerText.includes('sACN')",
}


def until(browser, expression):
    end_s = time.monotonic() + LONG_S
    while time.monotonic() < end_s:
        if value := browser.value(expression):
            return value
        time.sleep(0.2)
    raise AssertionError(f"never: {expression}; the page says: {browser.value('document.body.innerText')}; {browser.console()}")


def look_at(name, browser, serve):
    for size, width, height in (("phone", 390, 844), ("laptop", 1280, 800)):
        browser.go("about:blank" if name == "firefox" else f"http://127.0.0.1:{serve.port}/")
        browser.size(width, height)
        begin_s = time.monotonic()
        browser.go(serve.address)
        until(browser, IN)
        until(browser, READY["picture"])
        first_s = time.monotonic() - begin_s
        red, green, blue = until(browser, f"(() => {{ const [r, g, b] = {MIDDLE} ?? [0, 0, 0]; return r > 40 && r > 2 * g && r > 2 * b ? [r, g, b] : null; }})()")
        for screen in SCREENS:
            browser.value(f"(document.querySelector('nav [data-screen={screen}]').click(), true)")
            until(browser, READY[screen])
            time.sleep(0.3)
            wide = browser.value("[document.documentElement.scrollWidth, innerWidth]")
            assert wide[0] <= wide[1], f"{name}: {screen} is wider than a {size}: {wide}"
            if PICTURES:
                browser.screenshot(PICTURES / f"{name}-{screen}-{size}.png")
        assert browser.console() == [], (name, browser.console())
        print(f"{name}, {size} {browser.value('[innerWidth, innerHeight]')}: first picture after {1e3 * first_s:.0f} ms, "
              f"red {red:.0f} {green:.0f} {blue:.0f}, six screens, console empty", flush=True)


def main():
    with WebShow(SOURCE, BUILD) as show:
        serve = show.serve_desk()
        for name in sys.argv[4:] or BROWSERS:
            browser = BROWSERS[name]()
            try:
                look_at(name, browser, serve)
            finally:
                browser.close()
        assert serve.close() == 0, serve.text()


if __name__ == "__main__":
    main()

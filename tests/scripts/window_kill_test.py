#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The real window, killed (-9) at random moments while it is edited and saved over its socket: the show opens again each time, what was
said to be saved is there, and at most the last seconds of edits are lost. Usage: window_kill_test.py SOURCE_FOLDER BUILD_FOLDER [FOLDER
[KILLS]]; six kills if nothing else is said, in about two minutes."""
import os
import pathlib
import random
import re
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent / "lib"))
import window as window_driver  # noqa: E402
from window import Window  # noqa: E402

KILLS = int(sys.argv[4]) if len(sys.argv) > 4 else 6
MOST_LOST_S = 2.0
LONGEST_S = 4.0  # of edits before a kill
RESTED_S = 90.0  # longer than a minute, after which what a killed program left is removed (disk/leftovers.h)


def first_lamp(window):
    """Edit number K calls it "N K"."""
    return next((name for name in window.state()["patch"] if name.startswith("N ")), "Spot 1")


def number_of(name):
    return int(name.split()[1]) if name.startswith("N ") else 0


def unfinished(show, pid):
    return list(show.rglob(f"*.part{pid}_*"))


def newest(text):
    found = re.search(r'name = "N (\d+)"', text)
    return int(found.group(1)) if found else 0


def edit_until_killed(window, first, edited, saved, refused):
    """Edits of all weights: those that are seen with the next frame, and those for which the show is opened anew."""
    try:
        for number in range(first, first + 100000):
            for line in (f'rename "N {number}"', f"move 0 0 {0.01 if number % 2 else -0.01}" if number % 5 == 0 else "", "save" if number % 41 == 0 else ""):
                if not line:
                    continue
                answer = window.ask(line)
                if answer != "ok":
                    refused.append(answer)  # an empty one is the kill
                    return
                if line == "save":
                    saved.append(number)
                elif line.startswith("rename"):
                    edited.append((number, time.monotonic()))
            if number % 11 == 0:
                time.sleep(0.3)  # a person thinks
    except OSError:
        pass


def main():
    chance = random.Random(5)
    edits = saves = drafts = leftovers = 0
    worst_s = 0.0
    with window_driver.begin() as work:
        show = work / "demo"
        previous = None
        for kill in range(KILLS + 1):
            window = Window("--size", "400x300", "--no-desk", "--quiet", show=show)
            window.do("wait opened", "freeze on", "resolution 1")
            if previous:
                edited, saved, killed_s, pid = previous
                in_file = newest((show / "show.toml").read_text())
                assert in_file >= max(saved, default=0), f"kill {kill}: what was said to be saved is not in the file"
                if window.state()["changes_wait"]:
                    drafts += 1
                    window.do("take-changes")
                there = number_of(first_lamp(window))
                lost = [killed_s - at_s for number, at_s in edited if number > there]
                worst_s = max([worst_s, *lost])
                assert worst_s <= MOST_LOST_S, f"kill {kill}: an edit of {worst_s:.1f} s before it is lost"
                left = unfinished(show, pid)
                assert not left, f"unfinished files stay: {left}"
            if kill == KILLS:
                assert window.close() == 0, window.text()
                break
            lamp = first_lamp(window)
            window.do(f'select "{lamp}"')
            edited, saved, refused = [], [], []
            writer = threading.Thread(target=edit_until_killed, args=(window, number_of(lamp) + 1, edited, saved, refused))
            writer.start()
            while not edited and writer.is_alive():
                time.sleep(0.01)
            time.sleep(chance.uniform(0, LONGEST_S))
            killed_s = time.monotonic()
            window.process.kill()
            window.process.wait()
            writer.join()
            window.socket.close()
            for file in unfinished(show, window.process.pid):
                leftovers += 1
                os.utime(file, times=(time.time() - RESTED_S,) * 2)
            assert edited and not any(refused), refused or window.text()
            edits += len(edited)
            saves += len(saved)
            previous = (edited, saved, killed_s, window.process.pid)
    print(f"ok: {KILLS} kills, {edits} edits, {saves} saves, {drafts} times changes waited, {leftovers} unfinished files removed; the "
          f"oldest edit that was lost was {worst_s:.2f} s old")
    assert edits > KILLS
    return 0


if __name__ == "__main__":
    sys.exit(main())

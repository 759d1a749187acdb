# SPDX-License-Identifier: Apache-2.0
"""What the plain output of `monitor` and `explain` and the window say of a mistake of mistakes_test.py: the sentence of their JSON."""
import json
import os
import re
import subprocess
import time

LIMIT_S = 150  # for a sentence to come, and for a window to open on a busy machine


def same(text):
    """Rates and counts go on meanwhile; lines are broken where they are."""
    return " ".join(re.sub(r"# packets?", "# packets", re.sub(r"\d+(\.\d+)?", "#", text)).split())


def until(holds):
    end = time.monotonic() + LIMIT_S
    while time.monotonic() < end:
        if holds():
            return True
        time.sleep(0.3)
    return False


def in_words(stage, program, text, explained):
    if explained:
        return same(text) in same(stage.begin_explain().communicate(timeout=LIMIT_S)[0])
    log = stage.folder / "words.txt"
    plain = stage.start(stage.vis, program, "monitor", "--show", stage.show, "--every", "0.5", *stage.setup["options"], stdout=log.open("w"))
    try:
        return until(lambda: same(text) in same(log.read_text()))
    finally:
        plain.kill()
        plain.wait()


def in_window(stage, program, text, explained):
    folder = stage.folder / "window"
    folder.mkdir()
    lines = ["wait opened", 'select "Spot"']
    for number in range(LIMIT_S):
        lines += ["wait 1", f'state "{folder}/{number}.json"']
    (folder / "script").write_text("\n".join(lines) + "\n")
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", XDG_CONFIG_HOME=str(folder), XDG_RUNTIME_DIR=str(folder), LC_ALL="C.UTF-8", LANGUAGE="en")
    window = stage.start(stage.vis, program, "open", stage.show, "--forget", "--size", "320x240", "--script", folder / "script", *stage.setup["options"],
                         env=environment, stdout=(folder / "log").open("w"), stderr=subprocess.STDOUT)

    seen = []

    def says():
        assert window.poll() is None, (folder / "log").read_text()[-2000:]
        while (folder / f"{len(seen)}.json").exists():
            state = json.loads((folder / f"{len(seen)}.json").read_text())
            seen.append(state)
            said = [state["explained"].get("why", "")] if explained else [one["text"] for one in state["network"]]
            if same(text) in map(same, said):
                return True
        return False

    try:
        return until(says)
    finally:
        window.kill()
        window.wait()


def faults(stage, program, text, explained):
    """explained: the text is the verdict of `explain`, else a sentence of `monitor`. By unicast a port has one owner: one after the other."""
    if stage.setup["show"] is None:
        stage.running.kill()
        stage.running.wait()
    found = [] if in_words(stage, program, text, explained) else ["its words without --json"]
    return found + ([] if in_window(stage, program, text, explained) else ["the window's words"])

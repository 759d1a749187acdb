#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Files that are one byte larger than their kind may be (docs/reference/limits.md): a sentence with both numbers, at once, and no memory for
what is in them. They are holes, and take no room on the disk. Usage: sizes_test.py SOURCE_FOLDER BUILD_FOLDER."""
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
from tiny_show import tiny_show  # noqa: E402  (the folder is known only now)

MIB = 1 << 20
LONGEST_S = 10
MOST_MEMORY = 3 << 30  # of addresses; the largest file is as large


def said_of(*words):
    begun = time.monotonic()
    done = subprocess.run([str(PROGRAM), *map(str, words)], capture_output=True, text=True, timeout=60, errors="replace",
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY)))
    took_s = time.monotonic() - begun
    assert took_s < LONGEST_S, (words, took_s)
    assert done.returncode in (0, 1), (words, done.returncode, done.stderr)
    return done.stdout + done.stderr


def main(work):
    show, alone = tiny_show(SOURCE, work / "show"), work / "alone"
    kept, book = show / ".ghost", work / "book"
    for folder in (alone, book, kept / "distances/64", kept / "farm/0123456789ab"):
        folder.mkdir(parents=True)
    (kept / "farm/newest").write_text("0123456789ab")
    toml = (show / "show.toml").read_text()
    (show / "show.toml").write_text(toml.replace("universe = 1", 'photometry = "a.ies"\nuniverse = 1'))
    drawn = ["render", show, "--live", "--at", "0", "-o", work / "a.png"]
    rows = [  # file, how it begins, bytes, what reads it
        (show / "show.toml", (show / "show.toml").read_bytes(), 16 * MIB, ["check", show]),
        (alone / "a.mvr", b"PK\3\4", 3 << 30, ["check", alone / "a.mvr"]),
        (alone / "a.gdtf", b"PK\3\4", 128 * MIB, ["check", alone / "a.gdtf"]),
        (alone / "a.qxf", b"<?xml", 8 * MIB, ["check", alone / "a.qxf"]),
        (show / "desk.show", b"OLA Show\n", 512 * MIB, ["check", show]),
        (show / "stage.obj", b"v 0 0 0\n", 512 * MIB, ["check", show]),
        (show / "a.ies", b"IESNA", 4 * MIB, ["check", show]),
        (alone / "a.png", b"\x89PNG\r\n\x1a\n", 512 * MIB, ["compare", alone / "a.png", alone / "a.png"]),
        (alone / "looks.toml", b"", 16 * MIB, [*drawn, "--looks", alone / "looks.toml", "--look", "A"]),
        (kept / "distances/64/stage.json", b"{", 256 * MIB, drawn),
        (kept / "farm/0123456789ab/plan.json", b"{", 16 * MIB, ["farm", "status", show]),
        (alone / "marks.json", b"[", 8 * MIB, ["book", show, "-o", work / "new", "--marks", alone / "marks.json"]),
        (book / "book.json", b"{", 256 * MIB, ["book", show, "-o", work / "new", "--against", book]),
    ]
    for path, begin, most, words in rows:
        before = path.read_bytes() if path.exists() else None
        path.write_bytes(begin)
        os.truncate(path, most + 1)
        said = said_of(*words)
        assert path.name in said and str(most + 1) in said and str(most) in said.replace(str(most + 1), ""), (path.name, said)
        path.unlink()
        if before is not None:
            path.write_bytes(before)
        print(f"{path.name}: {most} bytes and no more", flush=True)


scratch = pathlib.Path(tempfile.mkdtemp(prefix="ghost-sizes-"))
try:
    main(scratch)
finally:
    shutil.rmtree(scratch)

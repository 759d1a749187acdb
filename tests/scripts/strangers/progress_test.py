#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Large plots in a terminal: check and import are never silent for 2 s of the processor. What is silent because others have the
processor does not count. Usage: progress_test.py SOURCE_FOLDER BUILD_FOLDER."""
import os
import pathlib
import pty
import select
import shutil
import sys
import tempfile
import time
import zipfile

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
SPOT = "Vari-Lite@VL2500_Spot.gdtf"
LONGEST_S = 2
TICKS = os.sysconf("SC_CLK_TCK")


def plot(path, fixtures, objects):
    matrix = "<Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{},{},6000}}</Matrix>"
    heads = "".join(f'<Fixture uuid="{k:032X}" name="Spot {k}">{matrix.format(k % 100 * 1000, k // 100 * 1000)}<GDTFSpec>{SPOT}</GDTFSpec>'
                    f"<Addresses><Address>{1 + 40 * k}</Address></Addresses></Fixture>" for k in range(1, fixtures + 1))
    things = "".join(f'<SceneObject uuid="{10**6 + k:032X}" name="Deck {k}">{matrix.format(k % 100 * 1000, 0)}<Geometries>'
                     f'<Geometry3D fileName="deck.glb"/></Geometries></SceneObject>' for k in range(objects))
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("GeneralSceneDescription.xml", '<GeneralSceneDescription verMajor="1" verMinor="6"><Scene><Layers><Layer name="L" uuid="a">'
                         f"<ChildList>{heads}{things}</ChildList></Layer></Layers></Scene></GeneralSceneDescription>")
        archive.write(SOURCE / "assets/fixtures" / SPOT, SPOT)
        archive.write(SOURCE / "assets/optics/stage.glb", "deck.glb")


def processor_s(process):
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def longest_silence_s(*words):
    process, terminal = pty.fork()
    if process == 0:
        os.execv(PROGRAM, [str(PROGRAM), *map(str, words)])
    longest_s = said_s = said_processor_s = now_s = 0.0
    said, begun = b"", time.monotonic()
    while True:
        is_saying = bool(select.select([terminal], [], [], 0.1)[0])
        now_s = time.monotonic() - begun
        used_s = processor_s(process)
        longest_s = max(longest_s, min(now_s - said_s, used_s - said_processor_s))
        if not is_saying:
            continue
        try:
            part = os.read(terminal, 65536)
        except OSError:  # it has ended
            part = b""
        if not part:
            break
        said += part
        said_s, said_processor_s = now_s, used_s
    status = os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
    assert status in (0, 1), (words, status, said[-500:])
    return longest_s, now_s, said


def main(work):
    plot(work / "large.mvr", 5_000, 30_000)
    for words in (["check", work / "large.mvr"], ["import", work / "large.mvr", "-o", work / "show"], ["check", work / "show"]):
        silent_s, all_s, said = longest_silence_s(*words)
        assert silent_s < LONGEST_S, (words, silent_s, said[-500:])
        print(f"{words[0]}: {all_s:.1f} s, silent for {silent_s:.1f} s of the processor at most", flush=True)


scratch = pathlib.Path(tempfile.mkdtemp(prefix="ghost-progress-"))
try:
    main(scratch)
finally:
    shutil.rmtree(scratch)

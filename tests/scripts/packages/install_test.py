#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The installed libraries are of use to others: a project outside of the tree finds them, reads a datagram, merges two sACN sources, prints the
modes of a fixture and the fixtures of a plot, and what a lamp sends out. Usage: install_test.py SOURCE_FOLDER BUILD_FOLDER."""
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

SOURCE, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SPOT = SOURCE / "assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"
LAMP = SOURCE / "assets/fixtures/Ghostlight@Dimmer_Lamp.gdtf"
PLOT = """<GeneralSceneDescription verMajor="1" verMinor="6"><Scene><Layers><Layer name="L" uuid="1"><ChildList>
<Fixture uuid="2" name="Spot 1"><GDTFSpec>Spot.gdtf</GDTFSpec><Addresses><Address break="0">515</Address></Addresses></Fixture>
</ChildList></Layer></Layers></Scene></GeneralSceneDescription>"""


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, (words, done.stdout, done.stderr)
    return done.stdout


with tempfile.TemporaryDirectory(prefix="ghost-install-") as folder:
    work = pathlib.Path(folder)
    cache = (BUILD / "CMakeCache.txt").read_text(encoding="utf-8")
    compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.M)[1]
    run("cmake", "--install", BUILD, "--component", "dev", "--prefix", work / "installed")
    headers = list((work / "installed/include/ghostlight").rglob("*.h"))
    assert len(headers) > 100, headers
    ours = [str(SOURCE / name) for name in ("src", "shaders", "build", "cmake")]  # the tree itself may be called as what is installed: /ghostlight
    for file in (work / "installed/lib").rglob("*.cmake"):
        text = file.read_text(encoding="utf-8")
        assert not [path for path in ours if re.search(re.escape(path) + r"\b", text)], f"{file} names the source tree"
    # CMake's own files must not lie under the source, or its headers might be found there.
    run("cmake", "-G", "Ninja", "-S", SOURCE / "tests/foreign", "-B", work / "build", f"-DCMAKE_PREFIX_PATH={work / 'installed'}",
        f"-DCMAKE_CXX_COMPILER={compiler}")
    run("cmake", "--build", work / "build")
    modes = run(work / "build/modes", SPOT)
    assert re.search(r"^.+: [1-9][0-9]* channels$", modes, re.M), modes
    print(modes, end="")
    merged = run(work / "build/merge")
    assert merged.split() == ["255", "200", "30"], merged
    print("merged:", merged, end="")
    (work / "datagram").write_bytes(b"Art-Net\0\0\x50\0\x0e\1\0\6\0\0\4\xff\x80\0\7")  # ArtDmx of Port-Address 6, four slots
    wire = run(work / "build/wire", work / "datagram")
    assert wire == "Art-Net, universe 7: 255 128 0 7\n", wire
    with zipfile.ZipFile(work / "tour.mvr", "w") as archive:
        archive.writestr("GeneralSceneDescription.xml", PLOT)
    plot = run(work / "build/plot", work / "tour.mvr")
    assert plot == "Spot 1, Spot.gdtf: 2.3\n", plot
    light = dict(re.findall(r"^(0|255): (\d+) cd$", run(work / "build/light", LAMP), re.M))
    assert light["0"] == "0" and int(light["255"]) > 1000, light
    print(wire, plot, f"a dimmer lamp at full: {light['255']} cd", sep="")

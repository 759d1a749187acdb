#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The optics show is what tools/make_optics.py writes, and explain says what is in its light."""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

root, build = Path(sys.argv[1]), Path(sys.argv[2])
FILES = {"optics.show": "assets/optics", "stage.glb": "assets/optics",
         "animation_flames.png": "assets/fixtures/src/Optics_Profile/wheels"}
with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.executable, root / "tools/make_optics.py", "--out", folder], check=True, stdout=subprocess.DEVNULL)
    for name, where in FILES.items():
        # Another zlib packs a picture otherwise.
        if name.endswith(".png"):
            assert (Path(folder) / name).stat().st_size > 10000
        elif (Path(folder) / name).read_bytes() != (root / where / name).read_bytes():
            sys.exit(f"{where}/{name} is not what tools/make_optics.py writes")


def beam_at(second):
    done = subprocess.run([build / "ghostlight", "explain", root / "assets/optics", "Profile", "--at", str(second), "--json"],
                          check=True, capture_output=True, text=True)
    beam = json.loads(done.stdout)["beams"][0]
    return beam["shares"], " / ".join(beam["optics"])


def expect(second, words, share=None, low=0.0, high=1.0):
    shares, text = beam_at(second)
    for word in words:
        assert word in text, f"at {second} s: '{word}' is not in '{text}'"
    if share:
        assert low < shares[share] < high, f"at {second} s: {share} is {shares[share]}"


assert beam_at(2)[1] == "", "an open beam has nothing in it"
expect(14, ["blades in: top 27 % to 16 %", "left 12 % to 31 %"], "blades", 0.2, 0.6)
expect(38, ["animation wheel 1 'Flames'"], "animation", 0.2, 0.9)
expect(46, ["prism 1 '8 circular'", "8 pictures"])
expect(50, ["prism 1 '8 circular'", "prism 2 '3 circular'", "24 pictures of all prisms"])
expect(66, ["frost 100 %: scatters by 8 deg"])
expect(58, ["scatters by 1 deg"])
expect(70, ["the iris pulses at"])
# A laser's figure is among its optics, a plain beam's is not.
done = subprocess.run([build / "ghostlight", "explain", root / "assets/lasers", "Fan", "--at", "1", "--json"],
                      check=True, capture_output=True, text=True)
said = " / ".join(json.loads(done.stdout)["beams"][0]["optics"])
assert "draws a fan of 16 rays, 90 deg" in said, said
print("the optics show is as it is written, explain names what is in the light")

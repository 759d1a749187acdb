#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""cmake/embed.cmake gives a shader's bindings their names, refuses what it does not understand, and C++ that names them wrongly does
not compile. The arguments are the source root and the folder of a build."""
import re
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

root, build = Path(sys.argv[1]), Path(sys.argv[2])
scratch = tempfile.TemporaryDirectory()
folder = Path(scratch.name)
cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")


def setting(name):
    return re.search(rf"^{name}:\w+=(.*)$", cache, re.M).group(1)


def embed(glsl, numbers, name="made_up_frag"):
    """The header made of a preprocessed GLSL and of a SPIR-V that binds these numbers, or the error."""
    words = [0x07230203, 0x10600, 0, 100, 0]
    for number in numbers:
        words += [4 << 16 | 71, 10 + number, 33, number]
    (folder / "a.spv").write_bytes(struct.pack(f"<{len(words)}I", *words))
    (folder / "a.glsl").write_text(glsl, encoding="utf-8")
    (folder / "a.h").unlink(missing_ok=True)
    done = subprocess.run([setting("CMAKE_COMMAND"), f"-DINPUT={folder}/a.spv", f"-DGLSL={folder}/a.glsl", f"-DOUTPUT={folder}/a.h",
                           f"-DNAME={name}", "-P", root / "cmake/embed.cmake"], capture_output=True, text=True)
    made = (folder / "a.h").exists()
    if (done.returncode == 0) != made:
        sys.exit(f"embed.cmake ended with {done.returncode}, and its header is {'' if made else 'not '}there: {done.stderr}")
    return (folder / "a.h").read_text(encoding="utf-8") if made else " ".join(done.stderr.split())


def compiles(members):
    source = folder / "a.cpp"
    source.write_text('#include "a.h"\nstd::vector<ghost::gpu::Binding> given(const ghost::gpu::Buffer& a, const ghost::gpu::Texture& b) {\n'
                      f"    return ghost::render::shaders::MadeUpFragBindings{{{members}}};\n}}\n", encoding="utf-8")
    done = subprocess.run([setting("CMAKE_CXX_COMPILER"), "-std=c++20", "-Wall", "-Werror", "-fsyntax-only", f"-I{folder}", f"-I{root}/src",
                           source], capture_output=True, text=True)
    return done.returncode == 0, done.stderr


BLOCK = "layout(binding = 0, scalar)uniform ViewBlock { View view;};\n"
LIST = "layout(scalar, binding = 1)readonly buffer\nTileList { uint count;uint list[];}tiles;\n"
IMAGE = "layout(rgba16f, binding = 1 + 1) writeonly uniform image2DArray out_image;\n"
OTHERS = "layout(location = 0)out vec4 colour;\nlayout(constant_id = 1)const uint kKind = 0u;\nlayout(push_constant)uniform Push { uint p;};\n"
WRONG = []

header = embed(OTHERS + IMAGE + BLOCK + LIST, [0, 2])
for part in ["Binding view;\n", "Binding tile_list;\n", "Binding out_image;\n", "return {view, tile_list, out_image};"]:
    if part not in header:
        WRONG.append(f"the header has no '{part.strip()}': {header}")

given = {"view": "gpu::uniform(a)", "tile_list": "gpu::storage(a)", "out_image": "gpu::stored(b)"}
for names, right in [("view tile_list out_image", True), ("tile_list view out_image", False), ("view tile_list", False),
                     ("tile_list out_image", False), ("view tiles out_image", False)]:
    good, said = compiles(", ".join(f".{name} = ghost::{given.get(name, 'gpu::storage(a)')}" for name in names.split()))
    if good != right:
        WRONG.append(f"bindings given as {names}: {'compiles' if good else said}")

if "Bindings" in embed(OTHERS, []):
    WRONG.append("a shader without bindings has a struct of them")

for glsl, numbers, expected in [
        (BLOCK + IMAGE, [0, 2], "shader made_up_frag: it has 2 bindings, but none at 1"),
        (BLOCK + BLOCK.replace("ViewBlock", "Other"), [0], "binding 0 is there twice, as view and as other"),
        (BLOCK + LIST.replace("TileList", "View"), [0, 1], "two bindings are called view"),
        (BLOCK, [0, 1], "the compiled one has a binding 1"),
        (BLOCK + "layout(binding = (1))uniform sampler2D image;\n", [0], "2 bindings are set and 1 understood"),
        (BLOCK + "layout(binding = 1)uniform sampler2D image[4];\n", [0], "expected a number and a name in"),
        (BLOCK + "layout(binding = kPlace)uniform sampler2D image;\n", [0], "expected a number and a name in")]:
    said = embed(glsl, numbers)
    if expected not in said:
        WRONG.append(f"expected '{expected}' of {glsl}got: {said}")

print("\n".join([*WRONG, "names of bindings: made, checked, refused"]))
sys.exit(1 if WRONG else 0)

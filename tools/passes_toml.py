#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes passes.toml (docs/reference/foreign-passes.md), the list of pictures that another renderer made for one camera.

    python3 tools/passes_toml.py DIR/passes.json [-o DIR/passes.toml]

converts the passes.json of a Blender bake: its camera, its lights (position_blender, intensity_W_per_sr: watts per steradian of
Cycles count as candela, one to one). The pictures stay where they are; names are relative to the TOML. Python only, no Blender.
"""
import argparse
import json
import os
import sys


def quoted(text):
    return json.dumps(text, ensure_ascii=False)   # a JSON string is a TOML basic string


def row(numbers):
    return "[" + ", ".join(repr(float(n)) for n in numbers) + "]"


def passes_toml(camera_to_world, fov_y_deg, lights, position="P.exr", comment="passes rendered elsewhere"):
    """camera_to_world: 4 rows of 4, z up. lights: (fixture, file, position in metres, candela of the point source)."""
    lines = [f"# {comment}", f"position = {quoted(position)}", 'axes = "z-up"', 'primaries = "rec709"', "", "[camera]", "matrix_world = ["]
    lines += [f"    {row(r)}," for r in camera_to_world]
    lines += ["]", f"fov_y_deg = {float(fov_y_deg)!r}"]
    for fixture, file, position_m, intensity_cd in lights:
        lines += ["", "[[light]]", f"name = {quoted(fixture)}", f"file = {quoted(file)}", f"position_m = {row(position_m)}",
                  f"intensity_cd = {float(intensity_cd)!r}"]
    return "\n".join(lines) + "\n"


def write(path, text):
    """Whole or not at all."""
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    os.replace(path + ".part", path)


def from_blender_json(bake):
    camera = bake["camera"]
    if not str(camera.get("axes", "blender")).startswith("blender"):
        raise ValueError(f"camera.axes is {camera['axes']!r}, expected Blender's (z up)")
    lights = [(light["name"], light["file"], light["position_blender"], light["intensity_W_per_sr"]) for light in bake["lights"]]
    return passes_toml(camera["matrix_world"], camera["fov_y_deg"], lights,
                       comment=f"from passes.json: Blender {bake['blender']}, {bake['spp']} samples a pixel")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("json", help="passes.json of a Blender bake")
    parser.add_argument("-o", "--out", help="default: passes.toml beside it")
    wanted = parser.parse_args()
    try:
        with open(wanted.json, encoding="utf-8") as file:
            text = from_blender_json(json.load(file))
        out = wanted.out or os.path.join(os.path.dirname(wanted.json), "passes.toml")
        write(out, text)
    except (OSError, ValueError, KeyError, TypeError) as problem:
        missing = "has no entry " if isinstance(problem, KeyError) else ""
        print(f"{wanted.json}: {missing}{problem}", file=sys.stderr)
        return 1
    print(out)
    return 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The shaders of a live picture, 128 lights at once, compiled for two families of AMD's hardware that is not there (Mesa's RADV does that):
nothing is spilled, and as many of them run side by side as hide the way to memory. Usage: shaders_test.py SOURCE_FOLDER BUILD_FOLDER"""
import json
import os
import pathlib
import subprocess
import sys

SOURCE, BUILD = (pathlib.Path(argument) for argument in sys.argv[1:3])
FAMILIES = {"navi21": 8, "polaris10": 2}  # RDNA 2, GCN 4: least waves on a SIMD, of 32 and of 10; none fewer than when this was written
SPILLS = {"Spilled VGPRs", "Scratch size"}

if not any(pathlib.Path("/usr/share/vulkan/icd.d").glob("radeon_icd*")):
    print("skipped: Mesa's driver for AMD (radeon_icd of mesa-vulkan-drivers) is not installed")
    sys.exit(77)
for family, least_waves in FAMILIES.items():
    done = subprocess.run([BUILD / "ghostlight-bench", "shaders", "--device", "llvmpipe", "--lights-per-dispatch", "128", "--compile-for", family],
                          cwd=SOURCE, env={**os.environ, "RADV_FORCE_FAMILY": family}, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr[-2000:]
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    names = {row["name"].split()[0] for row in rows}
    assert {"gate", "cull", "fan", "fan_shade", "surface_live", "visibility", "sum", "coarse_points", "glare_develop"} <= names, names
    for row in rows:
        assert all(row[name] == 0 for name in SPILLS), row
        assert row["Subgroups per SIMD"] >= least_waves, row
    print(f"{family}: {len(rows)} shaders, {min(row['Subgroups per SIMD'] for row in rows):.0f} waves at least, none spilled")
print("ok")

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes assets/demo/stage.glb, the stage of the demo show, inside Blender. All of it is drawn by these scripts: no outside assets.

    apt-get install --no-install-recommends blender python3-numpy
    blender -b -noaudio --factory-startup --python-exit-code 1 --python tools/make_demo_stage.py -- [--out assets/demo/stage.glb]

Prints the hanging positions and cameras that a show file needs (Blender's axes: metres, z up; the GLB is y up, as glTF demands).
Options: --size of the large textures, --crowd heads, --seed, --blend FILE to keep the Blender scene as well.
"""
import argparse
import os
import sys
import tempfile

import bpy
import numpy

numpy.bool = bool   # Debian's glTF add-on for Blender 3.4 still says np.bool, gone since numpy 1.24

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
from demo_stage import backline, layout, materials, people, rigging, textures, venue  # noqa: E402
from demo_stage.mesh_builder import Stage  # noqa: E402


def options():
    parser = argparse.ArgumentParser(prog="make_demo_stage.py")
    parser.add_argument("--out", default=os.path.join(HERE, "..", "assets", "demo", "stage.glb"))
    parser.add_argument("--size", type=int, default=1024)
    parser.add_argument("--crowd", type=int, default=190)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--blend")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])


def export(path):
    bpy.ops.export_scene.gltf(filepath=path, export_format="GLB", export_cameras=False, export_lights=False, export_apply=False,
                              export_yup=True, export_image_format="AUTO", export_animations=False, export_skins=False,
                              export_morph=False, export_extras=False)


def report(path):
    drawn, stored = 0, {}
    items = [o for o in bpy.data.objects if o.type == "MESH"]
    for item in items:
        mesh = item.data
        if mesh.name not in stored:
            stored[mesh.name] = sum(len(p.vertices) - 2 for p in mesh.polygons)
        drawn += stored[mesh.name]
    print(f"STAGE {os.path.getsize(path) / 1e6:.2f} MB, {drawn} triangles drawn, {sum(stored.values())} stored, "
          f"{len(items)} objects, {len(stored)} meshes, {len(bpy.data.materials)} materials")
    print("\nHanging positions: the point under the truss where the clamp bears, metres, z up")
    print(f"{'name':<8} {'truss':<6} {'x':>7} {'y':>7} {'z':>7}   aim")
    for name, truss, (x, y, z), aim in layout.hanging_positions():
        print(f"{name:<8} {truss:<6} {x:7.3f} {y:7.3f} {z:7.3f}   {aim}")
    print("\nCameras: position, look at, vertical field of view in degrees, picture")
    for name, (position, target, fov, shape) in layout.CAMERAS.items():
        print(f"{name:<8} {position} {target} {fov} {shape[0]}x{shape[1]}")


def main():
    wanted = options()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with tempfile.TemporaryDirectory() as folder:
        stage = Stage(materials.make_all(textures.paint_all(wanted.seed, wanted.size, folder)))
        venue.build(stage)
        rigging.build(stage)
        backline.build(stage)
        people.build(stage, wanted.crowd, wanted.seed)
        if wanted.blend:
            bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(wanted.blend), compress=True)
        path = os.path.abspath(wanted.out)
        export(path)
    report(path)


main()

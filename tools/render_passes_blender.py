#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders the passes of one camera with Blender's Cycles: one linear picture per fixture as a bare point source, and world positions.

    apt-get install --no-install-recommends blender python3-numpy
    blender -b -noaudio --factory-startup --python-exit-code 1 --python tools/render_passes_blender.py -- \\
        --stage assets/demo/stage.glb --from assets/demo/.ghost/passes/house/manifest.json --out DIR

In:   --stage   .glb, .gltf or .blend, metres
      --from    camera and lights: the manifest.json of `ghostlight bake`, or a passes.toml (rendered again)
      --size WxH, --spp N, --bounces N (0: direct light only), --radius METRES of the source (0: a point, hard shadows),
      --intensity CANDELA of the source, --only NAME,NAME
Out:  DIR/P.exr            float RGBA: world X Y Z of the surface at the pixel's centre, metres, z up; A is 1 on a surface, 0 beside it
      DIR/light_000.exr ..  half RGB, radiance in linear Rec.709
      DIR/passes.toml       what they are (docs/reference/foreign-passes.md)

Units. A Cycles point light of P watts sends P / (4 pi) W/sr everywhere, and a matt surface of albedo rho at distance d and angle t then
shows rho / pi * P / (4 pi) * cos t / d^2, with no other factor. So I candela are rendered with 4 pi I watts. The default, 1024 cd, keeps
dim pixels clear of the half floats' denormals. The world, the scene's own lights, emission and volumes are switched off.
"""
import argparse
import json
import math
import os
import sys
import tomllib

import bpy
import numpy
from mathutils import Matrix, Vector

numpy.bool, numpy.object = bool, object   # Debian's glTF add-on for Blender 3.4 needs names that its numpy has dropped
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import passes_toml  # noqa: E402

Y_UP_TO_Z_UP = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))


def options():
    parser = argparse.ArgumentParser(prog="render_passes_blender.py")
    parser.add_argument("--stage", required=True)
    parser.add_argument("--from", dest="source", required=True)
    parser.add_argument("--out", required=True)
    parser.add_argument("--size")
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--bounces", type=int, default=0)
    parser.add_argument("--radius", type=float, default=0.0)
    parser.add_argument("--intensity", type=float, default=1024.0)
    parser.add_argument("--only")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])


def read_request(path):
    """(camera to world, vertical field of view in degrees, (width, height) or None, [(fixture, position)]), all z up."""
    if path.endswith(".toml"):
        with open(path, "rb") as file:
            request = tomllib.load(file)
        turn = Y_UP_TO_Z_UP if request.get("axes", "z-up") == "y-up" else Matrix.Identity(4)
        lights = [(light["name"], turn @ Vector(light["position_m"])) for light in request["light"]]
        return turn @ Matrix(request["camera"]["matrix_world"]), request["camera"]["fov_y_deg"], None, lights
    with open(path, encoding="utf-8") as file:
        manifest = json.load(file)
    columns = manifest["camera_to_world"]
    to_world = Matrix([columns[4 * i:4 * i + 4] for i in range(4)]).transposed()
    lights = [(light["fixture"], Vector(light["position_m"])) for light in manifest["lights"] if light["stop"] == 0]
    later = len(manifest["lights"]) - len(lights)
    if later:
        print(f"PASSES {later} lights at later stops of a track are left out: passes.toml has one place per fixture")
    return to_world, manifest["fov_y_deg"], (manifest["width"], manifest["height"]), lights


def open_stage(path):
    if path.endswith(".blend"):
        bpy.ops.wm.open_mainfile(filepath=path)
    else:
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.import_scene.gltf(filepath=path)
    scene = bpy.context.scene
    scene.world = scene.world or bpy.data.worlds.new("dark")
    return scene


def darken(scene):
    """Nothing may shine but the one source."""
    for item in [o for o in bpy.data.objects if o.type == "LIGHT"]:
        bpy.data.objects.remove(item)
    scene.world.use_nodes = True
    scene.world.node_tree.nodes.clear()
    scene.world.node_tree.nodes.new("ShaderNodeOutputWorld")
    for tree in [m.node_tree for m in bpy.data.materials if m.use_nodes]:
        for node in tree.nodes:
            cut = []
            if node.type == "OUTPUT_MATERIAL":
                cut = list(node.inputs["Volume"].links)
            strength = node.inputs.get({"BSDF_PRINCIPLED": "Emission Strength", "EMISSION": "Strength"}.get(node.type, ""))
            if strength:
                cut += list(strength.links)
                strength.default_value = 0.0
            for link in cut:
                tree.links.remove(link)


def add_camera(scene, to_world, fov_y_deg):
    data = bpy.data.cameras.new("pass_camera")
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(fov_y_deg)
    data.clip_start, data.clip_end = 0.01, 1000
    camera = bpy.data.objects.new("pass_camera", data)
    camera.matrix_world = to_world
    scene.collection.objects.link(camera)
    scene.camera = camera


def set_up(scene, size, spp, bounces):
    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = size
    render.resolution_percentage = 100
    render.pixel_aspect_x = render.pixel_aspect_y = 1
    render.use_border = render.use_motion_blur = render.use_sequencer = render.film_transparent = False
    render.use_persistent_data = True   # the scene is built once for all lights
    cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = spp, False, False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.light_sampling_threshold = 0
    cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = False
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = bounces
    cycles.volume_bounces, cycles.transparent_max_bounces = 0, 16
    cycles.film_exposure, cycles.use_fast_gi = 1, False
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1.0
    scene.view_settings.view_transform = "Raw"
    scene.view_settings.exposure, scene.view_settings.gamma = 0, 1
    picture = render.image_settings
    picture.file_format, picture.color_mode, picture.color_depth, picture.exr_codec = "OPEN_EXR", "RGB", "16", "ZIP"


def render_positions(scene, folder):
    """One ray through each pixel's centre; through the compositor, because only it gives the pass an alpha."""
    layer, cycles = scene.view_layers[0], scene.cycles
    kept = cycles.samples
    cycles.samples, cycles.pixel_filter_type, cycles.filter_width = 1, "BLACKMAN_HARRIS", 0.01
    scene.render.film_transparent, layer.use_pass_position, scene.use_nodes = True, True, True
    tree = scene.node_tree
    tree.nodes.clear()
    rendered = tree.nodes.new("CompositorNodeRLayers")
    split = tree.nodes.new("CompositorNodeSeparateXYZ")
    joined = tree.nodes.new("CompositorNodeCombineColor")
    tree.links.new(rendered.outputs["Position"], split.inputs[0])
    for k in range(3):
        tree.links.new(split.outputs[k], joined.inputs[k])
    tree.links.new(rendered.outputs["Alpha"], joined.inputs[3])
    out = tree.nodes.new("CompositorNodeOutputFile")
    out.base_path = folder
    out.format.file_format, out.format.color_depth, out.format.color_mode, out.format.exr_codec = "OPEN_EXR", "32", "RGBA", "ZIP"
    out.file_slots[0].path = "P_"
    tree.links.new(joined.outputs[0], out.inputs[0])
    tree.links.new(rendered.outputs["Image"], tree.nodes.new("CompositorNodeComposite").inputs[0])
    bpy.ops.render.render()
    os.replace(os.path.join(folder, f"P_{scene.frame_current:04d}.exr"), os.path.join(folder, "P.exr"))
    tree.nodes.clear()
    scene.render.film_transparent, layer.use_pass_position, scene.use_nodes = False, False, False
    cycles.samples, cycles.pixel_filter_type, cycles.filter_width = kept, "BOX", 1.0


def main():
    wanted = options()
    to_world, fov_y_deg, size, lights = read_request(wanted.source)
    if wanted.size:
        size = tuple(int(n) for n in wanted.size.split("x"))
    if size is None:
        sys.exit(f"{wanted.source} has no picture size: give --size WxH")
    if wanted.only:
        lights = [light for light in lights if light[0] in wanted.only.split(",")]
    folder = os.path.abspath(wanted.out)
    os.makedirs(folder, exist_ok=True)
    scene = open_stage(os.path.abspath(wanted.stage))
    darken(scene)
    add_camera(scene, to_world, fov_y_deg)
    set_up(scene, size, wanted.spp, wanted.bounces)
    render_positions(scene, folder)

    data = bpy.data.lights.new("point", "POINT")
    data.shadow_soft_size = wanted.radius
    data.energy = 4 * math.pi * wanted.intensity
    source = bpy.data.objects.new("point", data)
    scene.collection.objects.link(source)
    made = []
    for number, (fixture, position) in enumerate(lights):
        source.location = position
        file = f"light_{number:03d}.exr"
        scene.render.filepath = os.path.join(folder, file)
        bpy.ops.render.render(write_still=True)
        made.append((fixture, file, position, wanted.intensity))
        print(f"PASSES {file} {fixture}", flush=True)
    comment = f"Blender {bpy.app.version_string}, Cycles, {wanted.spp} samples a pixel, {wanted.bounces} bounces"
    passes_toml.write(os.path.join(folder, "passes.toml"), passes_toml.passes_toml(to_world, fov_y_deg, made, comment=comment))


main()

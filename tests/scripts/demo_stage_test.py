#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The demo stage keeps its promises: size, triangles, instances, textures, and nothing that belongs to a show or lies outside the file.

Reads the GLB itself (glTF 2.0, clause 4.4: 12-byte header, JSON chunk, BIN chunk). The argument is the source root (or another GLB).
"""
import json
import os
import re
import struct
import sys

MAX_BYTES = 15_000_000
MIN_TRIANGLES = 150_000
MIN_TEXTURED = 24


def read_glb(path):
    """(glTF JSON, length of the binary chunk, length of the file)."""
    with open(path, "rb") as file:
        data = file.read()
    magic, version, length = struct.unpack_from("<4sII", data, 0)
    assert (magic, version) == (b"glTF", 2), f"{path}: not a glTF 2 binary"
    assert length == len(data), f"{path}: header says {length} bytes, the file has {len(data)}"
    json_length, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON", f"{path}: first chunk is {kind}"
    bin_length, kind = struct.unpack_from("<I4s", data, 20 + json_length)
    assert kind == b"BIN\0", f"{path}: second chunk is {kind}"
    assert 28 + json_length + bin_length == len(data), f"{path}: bytes after the last chunk"
    return json.loads(data[20:20 + json_length]), bin_length, len(data)


def mesh_triangles(gltf, mesh):
    total = 0
    for primitive in mesh["primitives"]:
        assert primitive.get("mode", 4) == 4, f"{mesh['name']}: not triangles"
        assert {"POSITION", "NORMAL", "TEXCOORD_0"} <= set(primitive["attributes"]), f"{mesh['name']}: an attribute is missing"
        assert "material" in primitive, f"{mesh['name']}: no material"
        count = gltf["accessors"][primitive["indices"]]["count"]
        assert count % 3 == 0
        total += count // 3
    return total


def drawn_triangles(gltf):
    """Triangles over every node that the scene reaches, and how many nodes share a mesh with another."""
    per_mesh = [mesh_triangles(gltf, mesh) for mesh in gltf["meshes"]]
    waiting, drawn, uses = list(gltf["scenes"][gltf.get("scene", 0)]["nodes"]), 0, [0] * len(per_mesh)
    while waiting:
        node = gltf["nodes"][waiting.pop()]
        waiting += node.get("children", [])
        if "mesh" in node:
            drawn += per_mesh[node["mesh"]]
            uses[node["mesh"]] += 1
    return drawn, sum(per_mesh), sum(n for n in uses if n > 1)


def factors(material):
    surface = material.get("pbrMetallicRoughness", {})
    return surface.get("baseColorFactor", [1]) + [surface.get(k, 1) for k in ("metallicFactor", "roughnessFactor")]


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else "."
    path = root if root.endswith(".glb") else os.path.join(root, "assets", "demo", "stage.glb")
    gltf, bin_length, size = read_glb(path)
    drawn, stored, shared = drawn_triangles(gltf)
    textured = [m for m in gltf["materials"] if "baseColorTexture" in m.get("pbrMetallicRoughness", {})]
    fixtures = [n["name"] for n in gltf["nodes"] if re.match(r"FXB?_", n.get("name", ""))]
    uris = [item["uri"] for kind in ("buffers", "images") for item in gltf.get(kind, []) if "uri" in item]
    outside = [v for v in gltf["bufferViews"] if v.get("byteOffset", 0) + v["byteLength"] > bin_length]
    floor = next((m for m in gltf["materials"] if m["name"] == "deck"), {})
    print(f"{size / 1e6:.2f} MB, {drawn} triangles drawn, {stored} stored, {shared} instanced nodes, "
          f"{len(textured)} textured of {len(gltf['materials'])} materials")
    checks = {
        f"under {MAX_BYTES} bytes": size < MAX_BYTES,
        f"{MIN_TRIANGLES} triangles or more drawn": drawn >= MIN_TRIANGLES,
        "meshes are instanced": shared >= 100 and stored * 2 < drawn,
        f"{MIN_TEXTURED} textured materials or more": len(textured) >= MIN_TEXTURED,
        f"no fixture nodes {fixtures[:3]}": not fixtures,
        f"no outside files {uris[:3]}": not uris,
        "every buffer view inside the file": not outside,
        "no required extensions": not gltf.get("extensionsRequired"),
        "no lights, no cameras": "cameras" not in gltf and "KHR_lights_punctual" not in gltf.get("extensionsUsed", []),
        "factors between 0 and 1": all(0 <= f <= 1 for m in gltf["materials"] for f in factors(m)),
        "the floor's gloss is a map": "metallicRoughnessTexture" in floor.get("pbrMetallicRoughness", {}),
    }
    failed = [name for name, passed in checks.items() if not passed]
    for name in failed:
        print("FAILED:", name)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

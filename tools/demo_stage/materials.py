# SPDX-License-Identifier: Apache-2.0
"""The materials: Principled surfaces that glTF can carry. A tint multiplies its texture; both stay linear factors in the file."""
import bpy

# name: texture set, tint (linear RGB), roughness, metal; the last two hold where the set has no map of its own
TEXTURED = {
    "deck": ("deck", (1, 1, 1), 0.3, 0),
    "brick": ("brick", (0.7, 0.7, 0.7), 0.8, 0),
    "concrete": ("concrete", (0.6, 0.6, 0.6), 0.6, 0),
    "roof_paint": ("painted", (0.03, 0.03, 0.032), 0.7, 0),
    "riser_black": ("painted", (0.035, 0.035, 0.035), 0.5, 0),
    "riser_carpet": ("cloth", (0.03, 0.03, 0.035), 0.95, 0),
    "velvet_red": ("velvet", (1, 1, 1), 0.9, 0),
    "serge_black": ("cloth", (0.012, 0.012, 0.014), 0.9, 0),
    "cyclorama": ("muslin", (0.82, 0.82, 0.8), 0.85, 0),
    "carpet": ("carpet", (1, 1, 1), 0.95, 0),
    "grille_black": ("grille", (1, 1, 1), 0.8, 0),
    "grille_silver": ("cloth", (0.3, 0.3, 0.32), 0.6, 0),
    "perforated_steel": ("perforated", (1, 1, 1), 0.45, 0),
    "tolex_black": ("leatherette", (0.022, 0.022, 0.024), 0.5, 0),
    "tolex_cream": ("leatherette", (0.55, 0.47, 0.33), 0.5, 0),
    "cabinet_paint": ("leatherette", (0.03, 0.03, 0.033), 0.5, 0),
    "flight_case": ("leatherette", (0.04, 0.06, 0.11), 0.5, 0),
    "leather_black": ("leatherette", (0.03, 0.024, 0.02), 0.4, 0),
    "leather_brown": ("leatherette", (0.13, 0.06, 0.03), 0.4, 0),
    "truss_aluminium": ("brushed", (0.62, 0.63, 0.65), 0.3, 1),
    "chrome": ("brushed", (0.9, 0.9, 0.92), 0.1, 1),
    "brass": ("brushed", (0.83, 0.6, 0.22), 0.22, 1),
    "black_metal": ("painted", (0.035, 0.035, 0.037), 0.45, 0),
    "hoist_yellow": ("painted", (0.55, 0.33, 0.02), 0.45, 0),
    "maple": ("wood", (1, 1, 1), 0.3, 0),
    "plywood": ("wood", (0.5, 0.45, 0.4), 0.6, 0),
    "drum_lacquer": ("wood", (0.75, 0.03, 0.03), 0.12, 0),
    "guitar_sunburst": ("wood", (0.9, 0.32, 0.08), 0.12, 0),
    "bass_blue": ("wood", (0.05, 0.25, 0.9), 0.15, 0),
    "kick_head": ("kick", (1, 1, 1), 0.5, 0),
    "denim": ("denim", (1, 1, 1), 0.85, 0),
    "shirt_white": ("cloth", (0.75, 0.74, 0.72), 0.8, 0),
    "shirt_black": ("cloth", (0.022, 0.022, 0.025), 0.8, 0),
    "shirt_grey": ("cloth", (0.16, 0.16, 0.18), 0.8, 0),
    "jacket_red": ("cloth", (0.42, 0.03, 0.03), 0.6, 0),
    "dress_green": ("cloth", (0.02, 0.22, 0.12), 0.6, 0),
    "trousers_dark": ("cloth", (0.03, 0.03, 0.04), 0.8, 0),
    "skin_light": ("skin", (0.56, 0.35, 0.25), 0.5, 0),
    "skin_dark": ("skin", (0.2, 0.1, 0.06), 0.5, 0),
    "hair_black": ("hair", (0.025, 0.018, 0.014), 0.45, 0),
    "hair_brown": ("hair", (0.11, 0.055, 0.025), 0.45, 0),
    "hair_fair": ("hair", (0.5, 0.33, 0.14), 0.45, 0),
    "crowd_charcoal": ("cloth", (0.03, 0.03, 0.036), 0.85, 0),
    "crowd_wine": ("cloth", (0.07, 0.015, 0.018), 0.85, 0),
    "crowd_navy": ("cloth", (0.015, 0.03, 0.08), 0.85, 0),
    "crowd_olive": ("cloth", (0.06, 0.055, 0.035), 0.85, 0),
    "crowd_skin": ("skin", (0.26, 0.15, 0.1), 0.6, 0),
}
PLAIN = {   # name: colour, roughness, metal
    "black_plastic": ((0.02, 0.02, 0.022), 0.35, 0),
    "drum_skin": ((0.8, 0.79, 0.75), 0.6, 0),
    "rubber": ((0.015, 0.015, 0.015), 0.9, 0),
    "key_white": ((0.8, 0.8, 0.76), 0.25, 0),
    "key_black": ((0.015, 0.015, 0.015), 0.2, 0),
    "shoe": ((0.02, 0.02, 0.02), 0.35, 0),
    "trainer_white": ((0.6, 0.6, 0.58), 0.6, 0),
    "tape_white": ((0.6, 0.6, 0.57), 0.6, 0),
    "tape_yellow": ((0.7, 0.5, 0.03), 0.6, 0),
    "bottle": ((0.35, 0.45, 0.5), 0.1, 0),
}
DOUBLE_SIDED = {"velvet_red", "serge_black", "cyclorama"}
NORMAL_STRENGTH = {"cyclorama": 0.15, "deck": 0.5, "skin_light": 0.6, "skin_dark": 0.6, "serge_black": 0.5}


def make_all(sets):
    """name -> bpy material."""
    made = {}
    for name, (texture, tint, roughness, metal) in TEXTURED.items():
        made[name] = textured(name, sets[texture], tint, roughness, metal)
    for name, (colour, roughness, metal) in PLAIN.items():
        made[name] = principled(name, colour, roughness, metal)[0]
    for name, material in made.items():
        material.use_backface_culling = name not in DOUBLE_SIDED
    return made


def principled(name, colour, roughness, metal):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    surface = material.node_tree.nodes["Principled BSDF"]
    surface.inputs["Base Color"].default_value = (*colour, 1)
    surface.inputs["Roughness"].default_value = roughness
    surface.inputs["Metallic"].default_value = metal
    return material, surface


def textured(name, images, tint, roughness, metal):
    material, surface = principled(name, tint, roughness, metal)
    tree = material.node_tree

    def picture(image):
        node = tree.nodes.new("ShaderNodeTexImage")
        node.image = image
        return node.outputs["Color"]

    base, normal, gloss = images
    if base:
        if tint == (1, 1, 1):
            tree.links.new(picture(base), surface.inputs["Base Color"])
        else:
            multiply = tree.nodes.new("ShaderNodeMix")
            multiply.data_type = "RGBA"
            multiply.blend_type = "MULTIPLY"
            factor, a, b = multiply.inputs[0], multiply.inputs[6], multiply.inputs[7]   # names repeat; the colours are the last pair
            factor.default_value = 1
            b.default_value = (*tint, 1)
            tree.links.new(picture(base), a)
            tree.links.new(multiply.outputs[2], surface.inputs["Base Color"])
    if normal:
        node = tree.nodes.new("ShaderNodeNormalMap")
        node.inputs["Strength"].default_value = NORMAL_STRENGTH.get(name, 1.0)
        tree.links.new(picture(normal), node.inputs["Color"])
        tree.links.new(node.outputs["Normal"], surface.inputs["Normal"])
    if gloss:
        split = tree.nodes.new("ShaderNodeSeparateColor")
        tree.links.new(picture(gloss), split.inputs["Color"])
        tree.links.new(split.outputs["Green"], surface.inputs["Roughness"])
        tree.links.new(split.outputs["Blue"], surface.inputs["Metallic"])
    return material

# SPDX-License-Identifier: Apache-2.0
"""Performers and audience: jointed figures, dressed, then skinned by a distance field. A figure faces -y and stands on z = 0."""
import math
import random
from dataclasses import dataclass

import bpy
import numpy as np
from mathutils import Euler, Vector

from . import backline, sdf
from .layout import DECK_Z
from .mesh_builder import MeshBuilder, place
from .sdf import Cone

UPPER_ARM, FOREARM, THIGH, SHIN = 0.30, 0.27, 0.43, 0.43


@dataclass
class Pose:
    """Joint targets in metres, left = the figure's left = +x; turns in radians."""
    right_hand: tuple
    left_hand: tuple
    right_foot: tuple = (-0.14, 0.0, 0.0)
    left_foot: tuple = (0.14, 0.0, 0.0)
    hip: tuple = (0.0, 0.0, 0.93)
    lean: tuple = (0.0, 0.0)            # how far the chest is ahead of the hip
    shoulders: float = 0.0              # turn of the shoulder line
    head: tuple = (0.0, 0.0)            # nod (down is positive), turn
    elbow_out: float = 0.6
    knee_out: float = 0.15
    grip: bool = True


@dataclass
class Dress:
    top: str = "shirt_black"
    legs: str = "denim"
    skin: str = "skin_light"
    hair: str = "hair_black"
    shoe: str = "shoe"
    sleeve: float = 1.0                 # 0 bare, 0.5 to the elbow, 1 to the wrist
    coat: float = 0.0                   # how far the top hangs below the hip
    skirt: float = 0.0                  # length of a skirt, in the colour of `legs`
    long_hair: bool = False
    woman: bool = False
    hat: bool = False
    beard: bool = False


def bend(root, tip, first, second, pole):
    """The middle joint of a limb; a tip out of reach is pulled in."""
    reach = tip - root
    length = min(max(reach.length, 0.05), (first + second) * 0.998)
    ahead = reach.normalized()
    tip = root + ahead * length
    along = (first * first - second * second + length * length) / (2 * length)
    side = pole - ahead * pole.dot(ahead)
    return root + ahead * along + side.normalized() * math.sqrt(max(first * first - along * along, 0)), tip


def figure(pose, dress):
    """The cones of one dressed person."""
    cones = []

    def add(start, end, r0, r1, label, blend=0.03, carve=False):
        cones.append(Cone(tuple(start), tuple(end), r0, r1, label, blend, carve))

    hip = Vector(pose.hip)
    chest = hip + Vector((pose.lean[0], pose.lean[1], 0.36))
    turn = Euler((0, 0, pose.shoulders)).to_matrix()
    up = (chest - hip).normalized()
    neck = chest + up * 0.18 + Vector((0, 0.015, 0))
    chest_at = lambda x, y, z: chest + turn @ Vector((x, y, 0)) + up * z
    hip_turn = Euler((0, 0, pose.shoulders * 0.4)).to_matrix()
    hip_at = lambda x, y, z: hip + hip_turn @ Vector((x, y, z))
    wide = 0.9 if dress.woman else 1.0

    # trunk: two columns side by side, because a chest is wider than deep
    for s in (-1, 1):
        waist = (hip + chest) / 2
        waist_x = 0.05 if dress.woman else 0.07
        add(hip_at(s * 0.072, 0, 0.02), waist + turn @ Vector((s * waist_x, 0, 0)), 0.108, 0.094, "top", 0.06)
        add(waist + turn @ Vector((s * waist_x, 0, 0)), chest_at(s * 0.085 * wide, 0, 0.0), 0.094, 0.11, "top", 0.06)
        add(chest_at(s * 0.085 * wide, 0, 0), chest_at(s * 0.1 * wide, 0.01, 0.09), 0.112, 0.085, "top", 0.06)
        add(chest_at(s * 0.165 * wide, 0.01, 0.1), chest_at(s * 0.05, 0.02, 0.16), 0.062, 0.05, "top", 0.05)
        add(hip_at(s * 0.072, 0.0, 0.02), hip_at(s * 0.08, 0.0, -0.06), 0.1, 0.098, "legs", 0.05)
        add(hip_at(s * 0.06, 0.045, -0.02), hip_at(s * 0.065, 0.045, -0.06), 0.084, 0.084, "legs", 0.05)
        if dress.woman:
            add(chest_at(s * 0.075, -0.075, -0.02), chest_at(s * 0.075, -0.08, -0.02), 0.062, 0.06, "top", 0.05)
        if dress.coat:
            add(hip_at(s * 0.075, 0, 0.05), hip_at(s * 0.085, 0.0, -dress.coat), 0.11, 0.116, "top", 0.06)
    add(chest_at(0, -0.04, 0.02), chest_at(0, -0.03, -0.12), 0.085, 0.08, "top", 0.06)
    if dress.skirt:
        for s in (-1, 1):
            for y in (-0.04, 0.05):
                add(hip_at(s * 0.07, y, 0.06), hip_at(s * 0.14, y * 3.0 - 0.02, -dress.skirt), 0.085, 0.13, "legs", 0.1)

    # neck and head
    tilt = Euler((pose.head[0], 0, pose.shoulders * 0.5 + pose.head[1])).to_matrix()
    head = neck + Vector((0, -0.02, 0.0)) + up * 0.175
    head_at = lambda x, y, z: head + tilt @ Vector((x, y, z))
    add(neck - up * 0.04, head_at(0, 0.02, -0.06), 0.06, 0.052, "skin", 0.03)
    add(head_at(0, 0.03, 0.05), head_at(0, -0.015, 0.06), 0.088, 0.078, "skin", 0.03)
    add(head_at(0, -0.03, 0.0), head_at(0, -0.052, -0.075), 0.07, 0.04, "skin", 0.04)
    add(head_at(-0.03, -0.03, -0.05), head_at(0.03, -0.03, -0.05), 0.042, 0.042, "skin", 0.03)
    add(head_at(0, -0.098, 0.03), head_at(0, -0.122, -0.012), 0.009, 0.014, "skin", 0.014)
    for s in (-1, 1):
        add(head_at(s * 0.018, -0.088, 0.042), head_at(s * 0.045, -0.078, 0.04), 0.014, 0.012, "skin", 0.014)
        add(head_at(s * 0.082, 0.015, 0.02), head_at(s * 0.08, 0.01, -0.02), 0.016, 0.011, "skin", 0.012)
        add(head_at(s * 0.033, -0.104, 0.02), head_at(s * 0.038, -0.1, 0.02), 0.0135, 0.0135, "skin", 0.01, carve=True)
        add(head_at(s * 0.02, -0.1, 0.044), head_at(s * 0.05, -0.088, 0.043), 0.0065, 0.006, "hair", 0.003)
    add(head_at(-0.018, -0.094, -0.045), head_at(0.018, -0.094, -0.045), 0.009, 0.009, "skin", 0.012)
    if dress.beard:
        add(head_at(-0.04, -0.05, -0.065), head_at(0, -0.075, -0.085), 0.036, 0.032, "hair", 0.03)
        add(head_at(0.04, -0.05, -0.065), head_at(0, -0.075, -0.085), 0.036, 0.032, "hair", 0.03)
    if dress.hat:
        add(head_at(0, 0.02, 0.08), head_at(0, 0.01, 0.09), 0.1, 0.096, "top", 0.03)
        add(head_at(-0.04, -0.1, 0.075), head_at(0.04, -0.1, 0.075), 0.012, 0.012, "top", 0.02)
        add(head_at(-0.03, -0.15, 0.068), head_at(0.03, -0.15, 0.068), 0.01, 0.01, "top", 0.03)
    add(head_at(0, 0.045, 0.07), head_at(0, 0.005, 0.098), 0.094, 0.078, "hair", 0.03)
    add(head_at(0, 0.055, 0.05), head_at(0, 0.06, -0.02), 0.085, 0.06, "hair", 0.03)
    for s in (-1, 1):
        add(head_at(s * 0.05, 0.03, 0.06), head_at(s * 0.07, 0.03, 0.0), 0.05, 0.025, "hair", 0.03)
        if dress.long_hair:
            add(head_at(s * 0.06, 0.04, 0.03), head_at(s * 0.085, 0.05, -0.14), 0.048, 0.04, "hair", 0.04)
            add(head_at(s * 0.085, 0.05, -0.14), chest_at(s * 0.1, 0.09, 0.0), 0.042, 0.02, "hair", 0.04)
            add(head_at(0, 0.075, 0.0), chest_at(s * 0.03, 0.115, 0.0), 0.07, 0.03, "hair", 0.05)

    arms(pose, dress, chest_at, up, wide, add)
    legs(pose, dress, hip_at, add)
    return cones


def arms(pose, dress, chest_at, up, wide, add):
    for s, hand in ((-1, pose.right_hand), (1, pose.left_hand)):
        lift = max(0.0, min(1.0, (Vector(hand).z - chest_at(0, 0, 0.1).z) / 0.4))
        shoulder = chest_at(s * (0.19 - 0.02 * lift) * wide, 0.01, 0.095 + 0.05 * lift)
        elbow, wrist = bend(shoulder, Vector(hand), UPPER_ARM, FOREARM, Vector((s * pose.elbow_out, 0.45, -0.6 - 0.3 * lift)))
        add(shoulder, elbow, 0.053, 0.04, "skin", 0.03)
        add(elbow, elbow.lerp(wrist, 0.35), 0.04, 0.043, "skin", 0.03)
        add(elbow.lerp(wrist, 0.35), wrist, 0.043, 0.027, "skin", 0.03)
        if dress.sleeve > 0:
            add(chest_at(s * 0.14 * wide, 0.01, 0.1), shoulder, 0.066, 0.06, "top", 0.04)
            cut = min(dress.sleeve * 2, 1.0)
            add(shoulder, shoulder.lerp(elbow, cut), 0.06, 0.052 + 0.014 * (1 - cut), "top", 0.03)
            if dress.sleeve > 0.5:
                cuff = elbow.lerp(wrist, (dress.sleeve - 0.5) * 1.86)
                add(elbow, cuff, 0.051, 0.042, "top", 0.03)
        else:
            add(shoulder + Vector((0, 0, 0.005)), shoulder.lerp(elbow, 0.1), 0.06, 0.052, "skin", 0.04)
        palm(wrist, (wrist - elbow).normalized(), s, pose.grip, add)


def palm(wrist, ahead, s, grip, add):
    """Knuckles lie across the arm; a gripping hand curls towards the body's middle."""
    across = ahead.cross(Vector((0, 0, 1)))
    across = across.normalized() if across.length > 0.1 else Vector((0, 1, 0))
    curl = ahead.cross(across) * (1 if ahead.cross(across).y < 0 else -1)
    for k in (-1, 1):
        add(wrist, wrist + ahead * 0.075 + across * 0.022 * k, 0.023, 0.02, "skin", 0.02)
    for k in (-1.5, -0.5, 0.5, 1.5):
        knuckle = wrist + ahead * 0.085 + across * 0.017 * k
        if grip:
            middle = knuckle + ahead * 0.022 + curl * 0.022
            add(knuckle, middle, 0.012, 0.011, "skin", 0.006)
            add(middle, middle - ahead * 0.012 + curl * 0.026, 0.011, 0.01, "skin", 0.006)
        else:
            add(knuckle, knuckle + ahead * (0.075 - 0.008 * abs(k)) + across * 0.008 * k + curl * 0.012, 0.012, 0.009, "skin", 0.005)
    thumb = wrist + ahead * 0.035 + across * 0.03 * s
    add(thumb, thumb + ahead * 0.04 + across * 0.018 * s + curl * 0.015, 0.015, 0.011, "skin", 0.012)


def legs(pose, dress, hip_at, add):
    skin = "skin" if dress.skirt else "legs"
    for s, foot in ((-1, pose.right_foot), (1, pose.left_foot)):
        ankle_at = Vector(foot) + Vector((0, 0.0, 0.085))
        top = hip_at(s * 0.095, 0, -0.04)
        knee, ankle = bend(top, ankle_at, THIGH, SHIN, Vector((s * pose.knee_out, -1, 0.1)))
        slim = 0.9 if dress.woman else 1.0
        add(top, knee, 0.088 * slim, 0.062 * slim, skin, 0.04)
        calf = knee.lerp(ankle, 0.35) + Vector((0, 0.018, 0))
        add(knee, calf, 0.064 * slim, 0.062 * slim, skin, 0.04)
        add(calf, ankle, 0.062 * slim, 0.05 if skin == "legs" else 0.036, skin, 0.04)
        if skin == "legs":
            add(ankle + (knee - ankle).normalized() * 0.04, ankle - Vector((0, 0, 0.02)), 0.054, 0.058, "legs", 0.03)
        out = Vector((s * 0.25, -1, 0)).normalized()
        heel = Vector((ankle.x, ankle.y + 0.035, ankle.z - 0.045))
        add(ankle, heel, 0.045, 0.042, "shoe", 0.02)
        for k in (-1, 1):
            side = Vector((-out.y, out.x, 0)) * 0.014 * k
            add(heel + side * 0.6, heel + out * 0.16 + side - Vector((0, 0, 0.004)), 0.04, 0.037, "shoe", 0.02)
            add(heel + out * 0.16 + side, heel + out * 0.225 + side * 0.6 - Vector((0, 0, 0.01)), 0.037, 0.03, "shoe", 0.02)


def folds(amount):
    """Cloth wrinkles: slanted waves that never line up."""
    def grow(p):
        x, y, z = p[:, 0], p[:, 1], p[:, 2]
        wave = np.sin(48 * z + 19 * x + 4 * np.sin(17 * y + 11 * x)) + 0.7 * np.sin(37 * z - 41 * x + 3 * np.sin(29 * z + 9 * y))
        return amount * wave
    return grow


def strands(p):
    return 0.004 * np.sin(110 * p[:, 0] + 7 * np.sin(20 * p[:, 2])) + 0.003 * np.sin(90 * p[:, 1] + 30 * p[:, 2])


def skin_over(stage, name, cones, dress, cell, triangles):
    """Mesh of a figure with its materials."""
    body = sdf.Body(cones, {"top": folds(0.002), "legs": folds(0.0016), "hair": strands})
    points, faces = sdf.surface(body, cell)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points.tolist(), [], faces.tolist())
    item = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(item)
    shrink = item.modifiers.new("decimate", "DECIMATE")
    shrink.ratio = min(1.0, triangles / len(faces))
    made = bpy.data.meshes.new_from_object(item.evaluated_get(bpy.context.evaluated_depsgraph_get()))
    bpy.data.objects.remove(item)
    made.name = name
    named = dict(top=dress.top, legs=dress.legs, skin=dress.skin, hair=dress.hair, shoe=dress.shoe)
    made.materials.clear()
    for label in body.labels:
        made.materials.append(stage.materials[named[label]])
    centres = np.array([p.center for p in made.polygons])
    made.polygons.foreach_set("material_index", sdf.labels_at(body, centres))
    made.polygons.foreach_set("use_smooth", [True] * len(made.polygons))
    if not made.uv_layers:
        made.uv_layers.new(name="UVMap")
    # wrapped once round the figure's axis, 2.5 tiles a metre: cloth needs grain, not a pattern
    corners = np.array([made.vertices[loop.vertex_index].co for loop in made.loops])
    made.uv_layers[0].data.foreach_set("uv", (corners[:, [0, 2]] * 2.5 + corners[:, [1, 1]] * (1.7, 0.6)).ravel())
    made.validate()
    return made


def build(stage, crowd_size, seed):
    performers(stage)
    crowd(stage, crowd_size, random.Random(seed))


def performers(stage):
    cast = [
        ("singer", Pose((-0.06, -0.24, 1.50), (0.60, -0.22, 1.62), (-0.24, -0.06, 0), (0.22, 0.12, 0), lean=(-0.02, 0.05),
                        shoulders=0.2, head=(-0.12, -0.1)),
         Dress("shirt_white", "leather_black", sleeve=0.62, hair="hair_brown", long_hair=True), place(0, 2.0, DECK_Z)),
        ("guitarist", Pose((-0.12, -0.27, 1.05), (0.47, -0.3, 1.27), (-0.27, -0.12, 0), (0.22, 0.1, 0), lean=(0.0, -0.05),
                           shoulders=-0.15, head=(0.3, 0.25)),
         Dress("jacket_red", "denim", coat=0.04, long_hair=True, hair="hair_fair"), place(-2.9, 2.15, DECK_Z, rz=0.15)),
        ("bassist", Pose((-0.14, -0.27, 0.98), (0.52, -0.28, 1.3), (-0.2, 0.05, 0), (0.27, -0.12, 0), lean=(0.0, 0.0), shoulders=-0.1,
                         head=(0.1, 0.2)),
         Dress("shirt_black", "trousers_dark", "skin_dark", sleeve=0.4, hat=True, beard=True, shoe="leather_brown"),
         place(2.9, 2.2, DECK_Z, rz=-0.15)),
        ("drummer", Pose((-0.25, -0.5, 1.22), (0.36, -0.45, 0.9), (-0.24, -0.5, 0.06), (0.3, -0.48, 0.06), hip=(0, 0, 0.64),
                         lean=(0, -0.06), knee_out=0.5, head=(0.05, -0.2)),
         Dress("shirt_grey", "denim", sleeve=0.0, hair="hair_black", shoe="trainer_white", beard=True),
         place(0, 7.3, backline.DRUM_RISER_Z)),
        ("keys", Pose((-0.28, -0.46, 1.05), (0.25, -0.46, 1.05), lean=(0, -0.07), head=(0.35, 0.1), grip=False),
         Dress("dress_green", "dress_green", sleeve=0.0, skirt=0.55, woman=True, long_hair=True, hair="hair_brown"),
         place(4.3 - 0.12, 6.48, backline.SIDE_RISER_Z, rz=0.2)),
        ("voice_1", Pose((-0.3, -0.2, 1.22), (0.16, -0.3, 1.3), (-0.12, 0, 0), (0.16, -0.06, 0), lean=(0.03, 0), shoulders=0.15,
                         grip=False),
         Dress("jacket_red", "leather_black", "skin_dark", sleeve=0.0, woman=True, long_hair=True),
         place(-5.05, 6.35, backline.SIDE_RISER_Z)),
        ("voice_2", Pose((-0.26, -0.1, 1.02), (0.3, -0.2, 1.86), (-0.16, 0, 0), (0.12, -0.05, 0), lean=(-0.04, 0),
                         head=(-0.1, -0.2), grip=False),
         Dress("jacket_red", "jacket_red", sleeve=0.0, skirt=0.5, woman=True, hair="hair_fair", long_hair=True),
         place(-4.15, 6.35, backline.SIDE_RISER_Z)),
    ]
    for name, pose, dress, at in cast:
        mesh = skin_over(stage, "performer_" + name, figure(pose, dress), dress, 0.0085, 15000)
        stage.add("performer_" + name, mesh, at)
        if name in ("guitarist", "bassist"):
            play(stage, name, at)
        if name == "singer":
            held = MeshBuilder()
            backline.microphone(held, (-0.05, -0.275, 1.535), (0.05, 0.6, 0.45))
            stage.add("mic_in_hand", held, at)
        if name == "drummer":
            sticks = MeshBuilder()
            for hand, tip in (((-0.25, -0.57, 1.24), (-0.45, -0.86, 1.36)), ((0.34, -0.53, 0.9), (0.28, -0.85, 0.76))):
                sticks.cylinder(hand, tip, 0.009, "maple", 8, 0.006)
            stage.add("drum_sticks", sticks, at)


def play(stage, name, at):
    """The instrument on its strap."""
    finish, neck, z = ("guitar_sunburst", 0.62, 1.06) if name == "guitarist" else ("bass_blue", 0.78, 1.0)
    hung = place(-0.05, -0.235, z, ry=-0.36, rz=0.06)
    stage.add("instrument_" + name, backline.guitar_mesh(stage, "instrument_" + name, finish, neck), at @ hung)
    strap = MeshBuilder()
    path = [(-0.24, -0.2, z - 0.08), (-0.23, -0.05, z + 0.0), (-0.14, 0.13, z + 0.12), (0.02, 0.15, 1.4), (0.1, 0.08, 1.52),
            (0.11, -0.03, 1.535), (0.11, -0.12, 1.45), (0.12, -0.17, 1.33), (0.12, -0.215, z + 0.17)]
    strap.tube(path, 0.014, "leather_brown", 8)
    stage.add("strap_" + name, strap, at)


def crowd(stage, size, dice):
    raised = [
        (Pose((-0.3, -0.12, 1.98), (0.32, -0.1, 1.94), elbow_out=1.0, grip=False), False),
        (Pose((-0.28, -0.05, 0.86), (0.3, -0.05, 0.88)), True),
        (Pose((-0.2, -0.3, 1.2), (0.3, -0.14, 2.02), elbow_out=1.0), False),
        (Pose((-0.07, -0.2, 1.92), (0.07, -0.2, 1.92), elbow_out=1.2, grip=False), True),
        (Pose((-0.36, -0.02, 2.0), (0.26, -0.1, 0.9), elbow_out=0.9), False),
        (Pose((-0.1, -0.35, 1.6), (0.12, -0.35, 1.6), head=(-0.15, 0)), True),
        (Pose((-0.25, -0.08, 0.88), (0.26, -0.06, 0.9), lean=(0.05, 0), head=(0, 0.3)), False),
        (Pose((-0.45, -0.05, 1.88), (0.5, -0.02, 1.84), elbow_out=1.4, grip=False, lean=(0.03, 0)), True),
    ]
    cloth = ("crowd_charcoal", "crowd_wine", "crowd_navy", "crowd_olive")
    hair = ("hair_black", "hair_brown", "hair_fair")
    meshes = []
    for i, (pose, woman) in enumerate(raised):
        dress = Dress(cloth[i % 4], ("denim", "trousers_dark", "trousers_dark")[i % 3], "crowd_skin", hair[i % 3], "shoe",
                      (0.4, 1.0, 0.45, 0.0, 1.0, 0.4, 0.4, 0.3)[i], coat=0.06,
                      long_hair=woman, woman=woman, hat=i == 4)
        meshes.append(skin_over(stage, f"crowd_{i}", figure(pose, dress), dress, 0.014, 2400))
    weights = (2, 3, 3, 2, 2, 2, 4, 1)
    rows, width = 11, 18.0
    per_row = math.ceil(size / rows)
    for k in range(size):
        row, seat = divmod(k, per_row)
        x = (seat + 0.5 * (row % 2) + 0.25) / per_row * width - width / 2 + dice.uniform(-0.2, 0.2)
        y = -2.75 - row * 0.85 + dice.uniform(-0.2, 0.2)
        kind = dice.choices(range(len(meshes)), weights)[0]
        stage.add(f"crowd_{k:03d}", meshes[kind], place(x, y, 0, rz=math.pi + dice.uniform(-0.35, 0.35), scale=dice.uniform(0.92, 1.05)))

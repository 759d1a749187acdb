#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes tests/references: small pictures of beams in haze that tests hold the renderers against, by an integrator that shares nothing with
them. Needs Debian's python3-numpy. Usage: make_references.py; the same bytes each time, in some minutes.

Each NAME.json says what is seen (Z up, metres, matrices row by row). I0 in candela, primaries linear Rec.709, light and paint multiplied
channel by channel:
    I(w)   = I0 rgb S(cos) G(u,v);  S = smoothstep(cos_outer, cos_inner, cos)
    u,v    = .5 + .5 (x,y)/(-z)/tan(cone/2)    the lamp shines along its -Z, v up; bilinear, linear 8 bit / 255, 0 outside
    L_surf = rho/pi I cos/d^2 V exp(-st d)     st = sigma_s + sigma_a
    L_air  = int_0^D exp(-st (s + d(s))) sigma_s p(g,cos) I/d(s)^2 V(s) ds      p = Henyey-Greenstein, g > 0 forward
    pixel  = L_air + exp(-st D) L_surf, the mean of 4 x 4 rays
NAME.numpy.exr is that, free of noise. NAME.multi.exr adds light that was scattered more than once, in the haze (between domain_min and
domain_max) and on matt surfaces, as often as it is: particles from the lamp, each seen from the eye where it is scattered. check.json says where the lamp is in the picture, and by what a display multiplies it; hall.glb the boxes."""
import json
import pathlib
import struct
import zlib

import numpy as np

OUT = pathlib.Path(__file__).resolve().parent.parent / "tests/references"
WIDTH, HEIGHT = 96, 54
RAYS = 4      # times as many, in a pixel
STEPS = 2048  # along a ray
PARTICLES, AT_ONCE = 12_000_000, 100_000
DOMAIN = np.asarray(((-9, -7, 0), (9, 6, 8)), float)  # of the haze

# Name: low corner, high corner, colour.
BOXES = {
    "floor": ((-9, -7, -0.2), (9, 6, 0), (0.45, 0.42, 0.4)),
    "wall": ((-9, 6, -0.2), (9, 6.2, 8), (0.6, 0.6, 0.65)),
    "crate": ((0.4, 2.2, 0), (1.6, 3.4, 1.1), (0.55, 0.35, 0.2)),
    "bar": ((-1.1, 0.5, 2.6), (-0.85, 4.5, 2.95), (0.3, 0.3, 0.3)),
    "post": ((2.3, 1.2, 0), (2.5, 1.4, 3.4), (0.2, 0.4, 0.5)),
}
EYE, LOOKS_AT, FOV_Y_DEG = (0, -5, 2.1), (0, 3, 1.9), 36
# What of it the pictures are of; the lamps stand outside of them, where 1/d^2 is tame.
SCENES = {
    "across": {"lamp": (-5.4, 1.6, 5.2), "aim": (1.6, 3.2, 0.3), "cone_deg": 17, "blend": 0.3, "I0": 900, "rgb": (1, 1, 1), "gobo": None,
               "sigma_s": 0.06, "sigma_a": 0, "g": 0},
    "towards": {"lamp": (2.2, 5.2, 6.6), "aim": (-0.7, -0.6, 0.2), "cone_deg": 24, "blend": 0.5, "I0": 700, "rgb": (0.55, 0.75, 1),
                "gobo": "rings.png", "sigma_s": 0.04, "sigma_a": 0.01, "g": 0.7},
}


def unit(v):
    v = np.asarray(v, float)
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def matrix(at, to):
    """Looks along its -Z, +Y as far up as it goes."""
    back = -unit(np.subtract(to, at))
    right = unit(np.cross((0, 0, 1), back))
    m = np.eye(4)
    m[:3, 0], m[:3, 1], m[:3, 2], m[:3, 3] = right, np.cross(back, right), back, at
    return m


def rings():
    """32 x 32: three rings, the middle one with a gap, in colours."""
    y, x = np.mgrid[0:32, 0:32] / 15.5 - 1
    r, turn = np.hypot(x, y), np.degrees(np.arctan2(y, x))
    open_ = ((r > 0.2) & (r < 0.38)) | ((r > 0.5) & (r < 0.68) & (np.abs(turn) > 40)) | ((r > 0.8) & (r < 0.95))
    picture = np.where(open_[..., None], [255, 230, 255], [20, 0, 10])
    picture[(r <= 0.45) & open_] = [255, 120, 60]
    return picture.astype(np.uint8)


def write_png(path, rgb):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + row.tobytes() for row in rgb)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", rgb.shape[1], rgb.shape[0], 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def write_exr(path, rgb):
    """Half floats in blocks of 16 rows, ZIP."""
    height, width, _ = rgb.shape

    def attribute(name, kind, data):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<I", len(data)) + data
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channels = b"".join(name + b"\0" + struct.pack("<IB3xII", 1, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    head = struct.pack("<II", 20000630, 2) + attribute("channels", "chlist", channels) + attribute("compression", "compression", b"\3")
    head += attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", b"\0")
    head += attribute("pixelAspectRatio", "float", struct.pack("<f", 1)) + attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
    head += attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    blocks = []
    for top in range(0, height, 16):
        raw = np.frombuffer(b"".join(rgb[y, :, c].astype("<f2").tobytes() for y in range(top, min(top + 16, height)) for c in (2, 1, 0)), np.uint8)
        halves = np.concatenate([raw[0::2], raw[1::2]]).astype(int)
        halves[1:] = (np.diff(halves) + 128) & 255
        packed = zlib.compress(halves.astype(np.uint8).tobytes(), 9)
        packed = packed if len(packed) < len(raw) else raw.tobytes()
        blocks.append(struct.pack("<iI", top, len(packed)) + packed)
    at, table = len(head) + 8 * len(blocks), b""
    for block in blocks:
        table += struct.pack("<Q", at)
        at += len(block)
    path.write_bytes(head + table + b"".join(blocks))


def write_glb(path):
    """One cube, a mesh and a node of it for each box."""
    faces, normals = [], []
    for axis in range(3):
        for side in (-1, 1):
            n, a = np.zeros(3), np.zeros(3)
            n[axis], a[(axis + 1) % 3] = side, 1
            b = np.cross(n, a)
            faces += [(n + s * a + t * b) / 2 for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
            normals += [n] * 4
    indices = [4 * face + k for face in range(6) for k in (0, 1, 2, 0, 2, 3)]
    binary = np.asarray(faces, "<f4").tobytes() + np.asarray(normals, "<f4").tobytes() + np.asarray(indices, "<u2").tobytes()
    nodes = []
    for k, (name, (low, high, _)) in enumerate(BOXES.items()):
        low, high = np.asarray(low, float), np.asarray(high, float)
        middle, size = (low + high) / 2, high - low
        nodes.append({"name": name, "mesh": k, "translation": [middle[0], middle[2], -middle[1]], "scale": [size[0], size[2], size[1]]})
    meshes = [{"name": name, "primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2, "material": k}]} for k, name in enumerate(BOXES)]
    views = [{"buffer": 0, "byteOffset": 0, "byteLength": 288}, {"buffer": 0, "byteOffset": 288, "byteLength": 288},
             {"buffer": 0, "byteOffset": 576, "byteLength": 72}]
    accessors = [{"bufferView": 0, "componentType": 5126, "count": 24, "type": "VEC3", "min": [-0.5] * 3, "max": [0.5] * 3},
                 {"bufferView": 1, "componentType": 5126, "count": 24, "type": "VEC3"},
                 {"bufferView": 2, "componentType": 5123, "count": 36, "type": "SCALAR"}]
    text = json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": meshes,
                       "materials": [{"name": name} for name in BOXES], "accessors": accessors, "bufferViews": views,
                       "buffers": [{"byteLength": len(binary)}]}).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(struct.pack("<III", 0x46546C67, 2, 20 + len(text) + 8 + len(binary)) + struct.pack("<II", len(text), 0x4E4F534A) + text
                     + struct.pack("<II", len(binary), 0x004E4942) + binary)


class Scene:
    def __init__(self, name):
        own = SCENES[name]
        self.own = own
        self.lamp = matrix(own["lamp"], own["aim"])
        self.lamp_m = self.lamp[:3, 3]
        self.tan_half = np.tan(np.radians(own["cone_deg"] / 2))
        self.cos_outer = np.cos(np.radians(own["cone_deg"] / 2))
        self.cos_inner = self.cos_outer + own["blend"] * (1 - self.cos_outer)
        self.candela = own["I0"] * np.asarray(own["rgb"], float)
        self.sigma_s, self.sigma_t, self.g = own["sigma_s"], own["sigma_s"] + own["sigma_a"], own["g"]
        self.gobo = rings() / 255 if own["gobo"] else None
        self.low = np.asarray([box[0] for box in BOXES.values()], float)
        self.high = np.asarray([box[1] for box in BOXES.values()], float)
        self.colour = np.asarray([box[2] for box in BOXES.values()], float)

    def intensity(self, way):
        """Candela along ways from the lamp."""
        own = unit(way) @ self.lamp[:3, :3]
        t = np.clip((-own[..., 2] - self.cos_outer) / (self.cos_inner - self.cos_outer), 0, 1)
        shine = (t * t * (3 - 2 * t))[..., None] * self.candela
        if self.gobo is None:
            return shine
        with np.errstate(divide="ignore", invalid="ignore"):
            gate = np.where(t[..., None] > 0, own[..., :2] / -own[..., 2:] / self.tan_half, 0)
        side = self.gobo.shape[0]
        u, v = (0.5 + 0.5 * gate[..., 0]) * side - 0.5, (0.5 - 0.5 * gate[..., 1]) * side - 0.5
        through = 0
        for k in range(4):
            x, y = np.floor(u).astype(int) + k % 2, np.floor(v).astype(int) + k // 2
            inside = (x >= 0) & (y >= 0) & (x < side) & (y < side)
            weight = (1 - np.abs(u - x)) * (1 - np.abs(v - y)) * inside
            through = through + weight[..., None] * self.gobo[np.clip(y, 0, side - 1), np.clip(x, 0, side - 1)]
        return shine * through

    def hit(self, origin, way):
        """The first box along rays: distance (inf: none), which, the normal."""
        with np.errstate(divide="ignore", invalid="ignore"):
            a = (self.low - origin[..., None, :]) / way[..., None, :]
            b = (self.high - origin[..., None, :]) / way[..., None, :]
        near, far = np.fmin(a, b), np.fmax(a, b)
        enters, leaves = near.max(-1), far.min(-1)
        distance = np.where((enters <= leaves) & (enters > 1e-6), enters, np.inf)
        which = distance.argmin(-1)
        first = np.take_along_axis(distance, which[..., None], -1)[..., 0]
        axis = np.take_along_axis(near, which[..., None, None], -2)[..., 0, :].argmax(-1)
        normal = np.zeros(way.shape)
        np.put_along_axis(normal, axis[..., None], -np.sign(np.take_along_axis(way, axis[..., None], -1)), -1)
        return first, which, normal

    def lit(self, places):
        """Lux at places square to the light, haze on the way left out, 0 in shadow; ways from the lamp, and distances."""
        way = places - self.lamp_m
        distance = np.linalg.norm(way, axis=-1)
        lux = self.intensity(way) / (distance * distance)[..., None]
        bright = np.flatnonzero(lux.reshape(-1, 3).max(-1) > 0)
        ways, flat = way.reshape(-1, 3)[bright], lux.reshape(-1, 3)
        first, _, _ = self.hit(np.broadcast_to(self.lamp_m, ways.shape), ways)  # 1: at the place itself
        flat[bright[first < 1 - 1e-6]] = 0
        return lux, way / distance[..., None], distance

    def phase(self, cosine):
        g = self.g
        return (1 - g * g) / (4 * np.pi * (1 + g * g - 2 * g * cosine) ** 1.5)


def camera_rays(dx, dy):
    """Through (dx, dy) of every pixel."""
    m = matrix(EYE, LOOKS_AT)
    tan_y = np.tan(np.radians(FOV_Y_DEG / 2))
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    own = np.stack([(2 * (x + dx) / WIDTH - 1) * tan_y * WIDTH / HEIGHT, (1 - 2 * (y + dy) / HEIGHT) * tan_y, -np.ones(x.shape)], -1)
    return unit(own @ m[:3, :3].T)


def single(scene):
    eye = np.asarray(EYE, float)
    picture = np.zeros((HEIGHT, WIDTH, 3))
    for k in range(RAYS * RAYS):
        ways = camera_rays((k % RAYS + 0.5) / RAYS, (k // RAYS + 0.5) / RAYS).reshape(-1, 3)
        depth, which, normal = scene.hit(np.broadcast_to(eye, ways.shape), ways)
        assert np.all(np.isfinite(depth)), "a ray leaves the hall"
        places = eye + depth[:, None] * ways
        lux, from_lamp, away = scene.lit(places)
        cosine = np.maximum(-(from_lamp * normal).sum(-1), 0)
        seen = scene.colour[which] / np.pi * lux * (cosine * np.exp(-scene.sigma_t * (away + depth)))[:, None]
        for part in range(0, len(ways), 128):
            way, far = ways[part:part + 128], depth[part:part + 128]
            at = (np.arange(STEPS) + 0.5) / STEPS * far[:, None]
            lux, from_lamp, away = scene.lit(eye + at[..., None] * way[:, None])
            weight = scene.sigma_s * scene.phase(-(from_lamp * way[:, None]).sum(-1)) * np.exp(-scene.sigma_t * (at + away))
            seen[part:part + 128] += (lux * weight[..., None]).sum(1) * (far / STEPS)[:, None]
        picture += seen.reshape(picture.shape) / RAYS ** 2
    return picture


def frame(w):
    """Two directions square to w and to each other."""
    aside = np.where(np.abs(w[:, 2:]) < 0.9, (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
    u = unit(np.cross(aside, w))
    return u, np.cross(w, u)


def around(w, cosine, turn):
    u, v = frame(w)
    sine = np.sqrt(np.maximum(1 - cosine * cosine, 0))
    return cosine[:, None] * w + (sine * np.cos(turn))[:, None] * u + (sine * np.sin(turn))[:, None] * v


def show(scene, picture, places, ways, normals, power):
    """What the eye sees of light of such power (lumens) that is scattered there; normals: 0 in the air."""
    to_eye = np.asarray(EYE, float) - places
    distance = np.linalg.norm(to_eye, axis=-1)
    own = -to_eye @ matrix(EYE, LOOKS_AT)[:3, :3]
    tan_y = np.tan(np.radians(FOV_Y_DEG / 2))
    with np.errstate(divide="ignore", invalid="ignore"):
        x = (own[:, 0] / -own[:, 2] / tan_y * HEIGHT / WIDTH + 1) / 2 * WIDTH
        y = (1 - own[:, 1] / -own[:, 2] / tan_y) / 2 * HEIGHT
    on_surface = normals.any(-1)
    cosine = (normals * to_eye).sum(-1) / distance
    seen = np.flatnonzero((own[:, 2] < 0) & (x >= 0) & (x < WIDTH) & (y >= 0) & (y < HEIGHT) & (~on_surface | (cosine > 0)))
    first, _, _ = scene.hit(np.broadcast_to(np.asarray(EYE, float), (len(seen), 3)), -to_eye[seen])
    seen = seen[first > 1 - 1e-6]
    d, cosine = distance[seen], cosine[seen]
    weight = np.where(on_surface[seen], cosine / np.pi, scene.phase((ways[seen] * to_eye[seen]).sum(-1) / d))
    pixel = (2 * tan_y / HEIGHT) ** 2 * (-own[seen, 2] / d) ** 3  # its solid angle
    weight *= np.exp(-scene.sigma_t * d) / (d * d * pixel)
    at = y[seen].astype(int) * WIDTH + x[seen].astype(int)
    for c in range(3):
        picture[:, c] += np.bincount(at, weight * power[seen, c], WIDTH * HEIGHT)


def bounced(scene, count, seed):
    """Light that was scattered more than once."""
    random = np.random.default_rng(seed)
    picture = np.zeros((WIDTH * HEIGHT, 3))
    for _ in range(count // AT_ONCE):
        cosine = 1 - random.random(AT_ONCE) * (1 - scene.cos_outer)
        ways = around(np.broadcast_to(-scene.lamp[:3, 2], (AT_ONCE, 3)), cosine, 2 * np.pi * random.random(AT_ONCE))
        power = scene.intensity(ways) * (2 * np.pi * (1 - scene.cos_outer) / count)
        places = np.broadcast_to(scene.lamp_m, ways.shape)
        order = 0
        while len(ways):
            depth, which, normals = scene.hit(places, ways)
            with np.errstate(divide="ignore", invalid="ignore"):
                leaves = np.fmax((DOMAIN[0] - places) / ways, (DOMAIN[1] - places) / ways).min(-1)
            flight = -np.log(1 - random.random(len(ways))) / scene.sigma_t
            in_air = flight < np.minimum(depth, leaves)
            there = in_air | (depth < leaves + 1e-3)
            far = np.where(in_air, flight, depth)[there]
            in_air, ways, which = in_air[there], ways[there], which[there]
            places = places[there] + far[:, None] * ways
            normals = np.where(in_air[:, None], 0, normals[there])
            kept = np.where(in_air[:, None], scene.sigma_s / scene.sigma_t, scene.colour[which])
            power = power[there] * kept
            order += 1
            if order > 1:
                show(scene, picture, places, ways, normals, power)
            chance = kept.max(-1)  # to go on: power stays what it was
            on = random.random(len(ways)) < chance
            power, places, ways, normals, in_air = power[on] / chance[on, None], places[on], ways[on], normals[on], in_air[on]
            a, turn = random.random(len(ways)), 2 * np.pi * random.random(len(ways))
            forward = 1 - 2 * a if scene.g == 0 else (1 + scene.g ** 2 - ((1 - scene.g ** 2) / (1 - scene.g + 2 * scene.g * a)) ** 2) / (2 * scene.g)
            ways = around(np.where(in_air[:, None], ways, normals), np.where(in_air, forward, np.sqrt(a)), turn)
    return picture.reshape(HEIGHT, WIDTH, 3)


def rounded(value):
    """Last digits of sines and square roots are the processor's own."""
    if isinstance(value, dict):
        return {key: rounded(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(item) for item in value]
    return round(float(value), 10) + 0.0 if isinstance(value, float) else value


def describe(name, scene, picture):
    """Writes NAME.json; returns its part of check.json."""
    own = scene.own
    shown = {"resolution": [WIDTH, HEIGHT], "geometry_glb": "hall.glb",
             "camera": {"matrix_world": matrix(EYE, LOOKS_AT).tolist(), "fov_y_deg": FOV_Y_DEG},
             "light": {"matrix_world": scene.lamp.tolist(), "cone_full_deg": own["cone_deg"], "cos_outer": scene.cos_outer,
                       "cos_inner": scene.cos_inner, "I0_W_per_sr": own["I0"], "rgb": own["rgb"], "gobo": own["gobo"]},
             "medium": {"sigma_s": own["sigma_s"], "sigma_a": own["sigma_a"], "g": own["g"], "domain_min": DOMAIN[0].tolist(), "domain_max": DOMAIN[1].tolist()},
             "objects": [{"name": box, "material": {"base_color": colour}} for box, (_, _, colour) in BOXES.items()]}
    (OUT / f"{name}.json").write_text(json.dumps(rounded(shown), indent=1) + "\n", encoding="utf-8")
    at = (scene.lamp_m - EYE) @ matrix(EYE, LOOKS_AT)[:3, :3]
    at = at[:2] / -at[2] / np.tan(np.radians(FOV_Y_DEG / 2)) * (HEIGHT / WIDTH, -1)
    return {"preview_scale": 1 / float(np.percentile(picture, 98)), "light_pixel": ((at + 1) / 2 * (WIDTH, HEIGHT)).tolist()}


def main():
    OUT.mkdir(exist_ok=True)
    write_glb(OUT / "hall.glb")
    write_png(OUT / "rings.png", rings())
    check = {}
    for name in SCENES:
        scene = Scene(name)
        picture = single(scene)
        write_exr(OUT / f"{name}.numpy.exr", picture)
        halves = [bounced(scene, PARTICLES // 2, seed) for seed in (1, 2)]
        more = (halves[0] + halves[1]) / 2
        write_exr(OUT / f"{name}.multi.exr", picture + more)
        noise = np.abs(halves[0] - halves[1]).mean() / 2 / (picture + more).mean()
        check[name] = describe(name, scene, picture)
        print(f"{name}: mean {picture.mean():.4g} cd/m^2, with bounces {(picture + more).mean():.4g}, noise {noise:.2g} of it")
    (OUT / "check.json").write_text(json.dumps(rounded(check), indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()

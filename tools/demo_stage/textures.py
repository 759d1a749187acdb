# SPDX-License-Identifier: Apache-2.0
"""Tileable textures made with numpy: base colour (sRGB), normal (OpenGL, +Y up), and roughness/metal in G/B as glTF packs them."""
import os

import bpy
import numpy as np


class Painter:
    """Makes noise from one seed and stores pictures as packed JPEGs."""

    def __init__(self, seed, folder):
        self.random = np.random.default_rng(seed)
        self.folder = folder
        os.makedirs(folder, exist_ok=True)

    def noise(self, n, falloff, stretch_x=1.0, stretch_y=1.0, lowest=1.0):
        """Tileable fractal noise, 0..1. A stretch below 1 draws it out along that axis."""
        fy = np.fft.fftfreq(n)[:, None] * n * stretch_y
        fx = np.fft.fftfreq(n)[None, :] * n * stretch_x
        frequency = np.hypot(fx, fy)
        frequency[frequency < lowest] = np.inf if lowest > 1 else 1
        spectrum = np.fft.fft2(self.random.standard_normal((n, n))) / frequency ** falloff
        spectrum[0, 0] = 0
        field = np.fft.ifft2(spectrum).real
        low, high = np.percentile(field, [1, 99])
        return np.clip((field - low) / (high - low), 0, 1)

    def save(self, name, pixels, data=False, quality=85):
        pixels = np.clip(pixels, 0, 1)
        if pixels.ndim == 2:
            pixels = np.repeat(pixels[..., None], 3, 2)
        height, width = pixels.shape[:2]
        image = bpy.data.images.new(name, width, height)
        image.colorspace_settings.name = "Non-Color" if data else "sRGB"
        image.pixels.foreach_set(np.dstack([pixels, np.ones((height, width))]).astype(np.float32).ravel())
        image.filepath_raw = os.path.join(self.folder, name + ".jpg")
        image.file_format = "JPEG"
        bpy.context.scene.render.image_settings.file_format = "JPEG"
        bpy.context.scene.render.image_settings.quality = quality
        image.save()
        image.source = "FILE"
        image.reload()
        image.pack()
        return image

    def colour(self, name, pixels):
        return self.save(name + "_base", pixels)

    def normal(self, name, height, strength):
        dx = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) * strength
        dy = (np.roll(height, -1, 0) - np.roll(height, 1, 0)) * strength
        n = np.dstack([-dx, -dy, np.ones_like(dx)])
        n /= np.linalg.norm(n, axis=2, keepdims=True)
        return self.save(name + "_nrm", n * 0.5 + 0.5, True)

    def gloss(self, name, roughness, metal=0.0):
        zero = np.zeros_like(roughness)
        return self.save(name + "_orm", np.dstack([zero + 1, roughness, zero + metal]), True)


def rgb(code):
    return np.array([int(code[i:i + 2], 16) / 255 for i in (0, 2, 4)])


def mix(a, b, t):
    return rgb(a) * (1 - t[..., None]) + rgb(b) * t[..., None]


def unit_square(n):
    y, x = np.mgrid[0:n, 0:n] / n
    return x, y


def deck(p, n):
    """Black painted stage floor, one tile = 2 m x 2 m: semi-gloss, scuffed, scratched, with shoe marks."""
    x, y = unit_square(n)
    grain = p.noise(n, 1.0, 0.08, 1.5)
    worn = np.clip(p.noise(n, 1.5) - 0.62, 0, 1) * 2.4
    scuff = np.clip(p.noise(n, 1.15, 0.3, 1) - 0.74, 0, 1) * 3
    scratch = np.zeros((n, n))
    for _ in range(90):
        x0, y0, angle, length = p.random.random(4) * (1, 1, np.pi, 0.25)
        t = np.linspace(0, length, int(length * n * 1.5) + 2)
        bend = y0 + t * np.sin(angle) + 0.02 * np.sin(t * 9)
        scratch[(bend * n).astype(int) % n, ((x0 + t * np.cos(angle)) * n).astype(int) % n] = 1
    base = mix("332f2d", "474340", 0.6 * grain + 0.4 * worn)
    base = base + (scuff * 0.09 + scratch * 0.1)[..., None]
    roughness = np.clip(0.25 + 0.06 * grain + 0.10 * worn + 0.08 * scuff + 0.12 * scratch, 0.2, 0.6)
    height = 0.16 * grain + 0.12 * worn - 0.25 * scratch
    return p.colour("deck", base), p.normal("deck", height, 0.9), p.gloss("deck", roughness)


def brick(p, n):
    x, y = unit_square(n)
    rows, columns = 12, 5
    row = np.floor(y * rows).astype(int)
    along = (x * columns + 0.5 * (row % 2)) % columns
    edge_x = np.minimum(along % 1, 1 - along % 1) * 0.24
    edge_y = np.minimum((y * rows) % 1, 1 - (y * rows) % 1) * 0.083
    face = np.clip((np.minimum(edge_x, edge_y) - 0.006) / 0.006, 0, 1)
    tone = p.random.random((rows, columns))[row, np.floor(along).astype(int)]
    grit = p.noise(n, 1.0)
    clay = mix("4a2820", "74402f", np.clip(0.6 * tone + 0.4 * grit, 0, 1))
    base = clay * face[..., None] + rgb("5d584f") * (1 - face[..., None]) * (0.7 + 0.3 * grit[..., None])
    return p.colour("brick", base), p.normal("brick", face * 0.9 + 0.35 * grit, 2.0), p.gloss("brick", 0.72 + 0.25 * grit)


def concrete(p, n):
    coarse, fine = p.noise(n, 1.4), p.noise(n, 0.7)
    base = mix("3b3a38", "625f5b", 0.7 * coarse + 0.3 * fine)
    return p.colour("concrete", base), p.normal("concrete", 0.5 * coarse + 0.2 * fine, 1.2), p.gloss("concrete", 0.45 + 0.4 * coarse)


def velvet(p, n):
    x, _ = unit_square(n)
    pile = p.noise(n, 0.6, 1, 0.15)
    height = pile * 0.5 + 0.15 * np.sin(x * 2 * np.pi * 128)
    return (p.colour("velvet", mix("2b0508", "5c0d14", pile)), p.normal("velvet", height, 0.7),
            p.gloss("velvet", 0.82 + 0.15 * pile))


def carpet(p, n):
    x, y = unit_square(n)
    u, v = np.abs(x - 0.5) * 2, np.abs(y - 0.5) * 2
    figure = np.sin(u * 21) * np.cos(v * 17) + np.sin((u + v) * 25) * 0.6 + np.cos(u * v * 60) * 0.5
    border = np.maximum(u, v)
    field = np.where(figure > 0.9, 2, np.where(figure < -0.7, 1, 0))
    index = np.where(border > 0.94, 3, np.where(border > 0.9, 2, np.where(border > 0.76, np.where(figure > 0.3, 4, 1), field)))
    palette = np.array([rgb(c) for c in ("6b1218", "0f1c3a", "b98d3b", "3c0a10", "d8c9a0")])
    tuft = p.noise(n, 0.4)
    return p.colour("carpet", palette[index] * (0.75 + 0.35 * tuft[..., None])), p.normal("carpet", tuft, 0.6), None


def grille(p, n):
    x, y = unit_square(n)
    weave = (0.5 + 0.5 * np.sin(x * 2 * np.pi * 64)) * (0.5 + 0.5 * np.sin(y * 2 * np.pi * 64))
    return p.colour("grille", mix("0c0c0c", "3a3833", weave)), p.normal("grille", weave, 0.8), None


def perforated(p, n):
    x, y = unit_square(n)
    shift = 0.5 * (np.floor(x * 40) % 2)
    hole = ((x * 40) % 1 - 0.5) ** 2 + ((y * 40 + shift) % 1 - 0.5) ** 2
    base = mix("232325", "030303", (hole < 0.12).astype(float))
    return p.colour("perforated", base), p.normal("perforated", np.clip(hole, 0, 0.2) * 5, 1), None


def leatherette(p, n):
    grain = p.noise(n, 0.9, lowest=20)
    return p.colour("leatherette", 0.8 + 0.2 * grain), p.normal("leatherette", grain, 1.5), p.gloss("leatherette", 0.42 + 0.3 * grain)


def brushed(p, n):
    line = p.noise(n, 1.2, 1, 0.1)
    return p.colour("brushed", 0.78 + 0.22 * line), None, p.gloss("brushed", 0.24 + 0.3 * line, 1.0)


def painted_metal(p, n):
    grain, chip = p.noise(n, 0.8), np.clip(p.noise(n, 1.3) - 0.8, 0, 1) * 4
    return (p.colour("painted", 0.8 + 0.1 * grain + 0.3 * chip), p.normal("painted", grain * 0.4, 0.8),
            p.gloss("painted", 0.4 + 0.15 * grain, 0.3))


def cloth(p, n):
    x, y = unit_square(n)
    weave = np.sin(x * 2 * np.pi * 96) * np.sin(y * 2 * np.pi * 96)
    crease = p.noise(n, 1.4)
    return (p.colour("cloth", 0.74 + 0.2 * crease + 0.06 * weave), p.normal("cloth", crease * 1.2 + 0.12 * weave, 1.6),
            p.gloss("cloth", 0.78 + 0.15 * crease))


def muslin(p, n):
    """Seamless cyclorama cloth: nearly even, so that it shows the light and not itself."""
    _, y = unit_square(n)
    weave, stain = p.noise(n, 0.3), p.noise(n, 1.6)
    height = 0.1 * weave + 0.3 * np.sin(2 * np.pi * y + 2 * stain)
    return p.colour("muslin", 0.955 + 0.025 * stain + 0.02 * weave), p.normal("muslin", height, 0.6), None


def denim(p, n):
    x, y = unit_square(n)
    twill = 0.5 + 0.5 * np.sin((x + y) * 2 * np.pi * 64)
    fade = p.noise(n, 1.5)
    return p.colour("denim", mix("161f36", "43557c", 0.3 * twill + 0.7 * fade)), p.normal("denim", twill * 0.3 + fade * 0.4, 1.0), None


def grain_wood(p, n):
    ring = p.noise(n, 1.3, 0.1, 1.4)
    return p.colour("wood", mix("7a5a38", "c39a66", ring)), None, p.gloss("wood", 0.22 + 0.15 * ring)


def skin(p, n):
    tone, pore = p.noise(n, 1.5), p.noise(n, 0.5)
    return p.colour("skin", 0.86 + 0.14 * tone - 0.05 * pore), p.normal("skin", pore * 0.12, 1.0), p.gloss("skin", 0.42 + 0.2 * tone)


def hair(p, n):
    strand = p.noise(n, 0.9, 1.0, 0.05)
    return p.colour("hair", 0.45 + 0.55 * strand), p.normal("hair", strand, 1.6), p.gloss("hair", 0.35 + 0.2 * strand)


def kick_head(p, n):
    """The band's mark on the bass drum: a star in a ring."""
    x, y = unit_square(n)
    radius = np.hypot(x - 0.5, y - 0.5)
    angle = np.arctan2(y - 0.5, x - 0.5)
    tip, valley, half = 0.33, 0.135, np.pi / 5
    turn = np.abs((((angle - np.pi / 2) / (2 * half) + 0.5) % 1) - 0.5) * 2 * half   # from the nearest tip
    star = radius < tip * valley * np.sin(half) / (tip * np.sin(turn) + valley * np.sin(half - turn))
    base = mix("e8e2d0", "b3261e", star.astype(float))
    return p.colour("kick", base * np.where(np.abs(radius - 0.42) < 0.015, 0.1, 1)[..., None]), None, None


def paint_all(seed, size, folder):
    """name -> (base colour, normal, roughness/metal), each an image or None."""
    p = Painter(seed, folder)
    large = dict(deck=deck, brick=brick, velvet=velvet, carpet=carpet)
    small = dict(concrete=concrete, grille=grille, perforated=perforated, leatherette=leatherette, brushed=brushed,
                 painted=painted_metal, cloth=cloth, muslin=muslin, denim=denim, wood=grain_wood, skin=skin, hair=hair, kick=kick_head)
    sets = {name: make(p, size) for name, make in large.items()}
    sets.update({name: make(p, size // 2) for name, make in small.items()})
    return sets

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the gobo pictures of our fixtures: 512 x 512 PNG, grey and alpha, four samples a side for smooth edges.

usage: make_gobos.py [--out FOLDER] [--sheet FILE] [NAME...]     default: assets/fixtures/src/shared/wheels

GDTF Annex E: white passes, black blocks, outside of the round picture alpha is 0. Every pattern is a function of the
position in the picture's unit disc (x right, y up) that returns the transmission 0..1, so none is anybody's artwork.
"""
import argparse
import math
from pathlib import Path

import numpy as np
from PIL import Image

OUT = Path(__file__).resolve().parent.parent / "assets/fixtures/src/shared/wheels"
SIZE, SUPER = 512, 4
GRID = (np.arange(SIZE * SUPER, dtype=np.float32) + 0.5) / (SIZE * SUPER) * 2 - 1


def field():
    return np.meshgrid(GRID, -GRID)


def rotate(x, y, angle):
    c, s = math.cos(angle), math.sin(angle)
    return c * x + s * y, -s * x + c * y


def smooth(edge, value, width=0.004):
    """0 below the edge, 1 above it."""
    t = np.clip((value - edge) / width + 0.5, 0, 1)
    return t * t * (3 - 2 * t)


def scatter(random, count, gap, radius=1.05, tries=4000):
    """Points of the disc with at least `gap` between them (dart throwing)."""
    points = []
    for _ in range(tries):
        p = random.uniform(-radius, radius, 2)
        if p @ p < radius * radius and all((p - q) @ (p - q) > gap * gap for q in points):
            points.append(p)
            if len(points) == count:
                break
    return np.array(points, np.float32)


def noise(random, x, y, scale):
    """Value noise with smooth interpolation, about 0 +- 1."""
    table = random.uniform(-1, 1, (64, 64)).astype(np.float32)
    u, v = x * scale + 37.3, y * scale + 11.7
    i, j = np.floor(u).astype(int), np.floor(v).astype(int)
    fu, fv = u - i, v - j
    fu, fv = fu * fu * fu * (fu * (6 * fu - 15) + 10), fv * fv * fv * (fv * (6 * fv - 15) + 10)
    a, b = table[j % 64, i % 64], table[j % 64, (i + 1) % 64]
    c, d = table[(j + 1) % 64, i % 64], table[(j + 1) % 64, (i + 1) % 64]
    return (a + (b - a) * fu) * (1 - fv) + (c + (d - c) * fu) * fv


def fractal(random, x, y, scale, octaves=4, fall=0.5):
    total = 0
    for k in range(octaves):
        u, v = rotate(x, y, 0.7 * k)
        total = total + noise(random, u, v, scale * 2**k) * fall**k
    return total


def two_nearest(x, y, points):
    first = np.full_like(x, 9.0)
    second = np.full_like(x, 9.0)
    for px, py in points:
        d = np.hypot(x - px, y - py)
        second = np.minimum(second, np.maximum(first, d))
        first = np.minimum(first, d)
    return first, second


def pebbles(random, x, y):
    warp = 0.02
    u = x + warp * noise(random, x, y, 6)
    v = y + warp * noise(random, x, y, 6)
    first, second = two_nearest(u, v, scatter(random, 110, 0.155))
    border = (second - first) / 2
    return smooth(0.021, border + 0.006 * noise(random, x, y, 22))


def dust_breakup(random, x, y):
    # Specks whose density follows a cloud, so that the light looks torn, not sprinkled.
    cloud = fractal(random, x, y, 2.2, 3)
    speck = fractal(random, x, y, 11, 3, 0.6)
    light = smooth(0.46, speck + 0.55 * cloud, 0.02)
    fine = smooth(0.62, fractal(random, x, y, 27, 2, 0.6) + 0.35 * cloud, 0.03)
    return np.maximum(light, fine)


def medium_circles(random, x, y):
    light = np.zeros_like(x)
    for px, py in scatter(random, 46, 0.245, 1.0):
        radius = random.uniform(0.075, 0.118)
        d = np.hypot(x - px, y - py)
        light = np.maximum(light, 1 - smooth(radius, d))
        if random.random() < 0.22:  # a few are rings
            light = np.minimum(light, 1 - (1 - smooth(radius * 0.55, d)) * (d < radius))
    return light


def night_sky(random, x, y):
    light = np.zeros_like(x)
    for size, count, gap in ((0.030, 9, 0.42), (0.017, 34, 0.17), (0.009, 150, 0.06)):
        for px, py in scatter(random, count, gap, 0.97):
            near = np.maximum(np.abs(x - px), np.abs(y - py)) < 5 * size
            u, v = x[near] - px, y[near] - py
            r = size * random.uniform(0.8, 1.25)
            star = 1 - smooth(r, np.hypot(u, v))
            if size > 0.02:  # the bright ones have four rays
                u, v = rotate(u, v, random.uniform(0, 1.5))
                ray = np.minimum(np.abs(u) + 9 * np.abs(v), 9 * np.abs(u) + np.abs(v))
                star = np.maximum(star, 1 - smooth(4.2 * r, ray, 0.01))
            light[near] = np.maximum(light[near], star)
    return light


def leaf(u, v, length, width, vein=True):
    """Pointed leaf from (0,0) to (length,0): signed value, above 0 inside, and its vein."""
    t = np.clip(u / length, 0, 1)
    half = width * np.power(np.clip(np.sin(math.pi * np.power(t, 0.75)), 0, 1), 1.15)
    inside = np.where((u > 0) & (u < length), half - np.abs(v), -1)
    if vein:
        inside = np.where((np.abs(v) < 0.0055 * (1.2 - t)) & (t < 0.86), -1, inside)
        side = np.abs(((u - 0.75 * np.abs(v)) / length * 6.0) % 1 - 0.5) * length / 6.0
        inside = np.where((side < 0.0035) & (np.abs(v) < half * 0.72) & (t > 0.1) & (t < 0.85), -1, inside)
    return inside


def draw_leaves(random, x, y, points, long, vein, bend=0.5):
    light = np.zeros_like(x)
    for px, py in points:
        angle = random.uniform(0, 2 * math.pi)
        length = long * random.uniform(0.75, 1.25)
        near = np.maximum(np.abs(x - px), np.abs(y - py)) < length
        u, v = rotate(x[near] - px, y[near] - py, angle)
        u = u + length / 2
        v = v - bend * random.uniform(-1, 1) * u * (length - u) / length
        value = leaf(u, v, length, length * random.uniform(0.2, 0.27), vein)
        light[near] = np.maximum(light[near], smooth(0.0, value))
    return light


def leaves(random, x, y):
    light = draw_leaves(random, x, y, scatter(random, 34, 0.27, 1.02), 0.40, True)
    return np.maximum(light, draw_leaves(random, x, y, scatter(random, 40, 0.2, 1.02), 0.13, False))


def vertical_bars(random, x, y):
    light = np.zeros_like(x)
    left = -1.05
    while left < 1.05:
        width = random.uniform(0.045, 0.11)
        light = np.maximum(light, smooth(left, x) * (1 - smooth(left + width, x)))
        left += width + random.uniform(0.05, 0.1)
    return light


def wave(random, x, y):
    bend = y + 0.10 * np.sin(5.2 * x + 0.6) + 0.045 * np.sin(11 * x - 1.5 * y + 2)
    phase = bend * 5.2
    part = phase - np.floor(phase)
    thick = 0.30 + 0.16 * np.sin(3.1 * x + 2.1 * np.floor(phase)) + 0.05 * noise(random, x, y, 5)
    return 1 - smooth(thick, np.abs(part - 0.5) * 2, 0.03)


def block_breakup(random, x, y):
    u, v = rotate(x, y, 0.32)
    light = np.zeros_like(x)

    def split(x0, y0, x1, y1, depth):
        nonlocal light
        w, h = x1 - x0, y1 - y0
        if depth == 0 or (max(w, h) < 0.34 and random.random() < 0.45) or max(w, h) < 0.16:
            if random.random() < 0.7:
                gap = 0.017
                d = np.minimum(np.minimum(u - x0, x1 - u), np.minimum(v - y0, y1 - v))
                light = np.maximum(light, smooth(gap, d))
            return
        at = random.uniform(0.35, 0.65)
        if w > h:
            split(x0, y0, x0 + at * w, y1, depth - 1)
            split(x0 + at * w, y0, x1, y1, depth - 1)
        else:
            split(x0, y0, x1, y0 + at * h, depth - 1)
            split(x0, y0 + at * h, x1, y1, depth - 1)

    split(-1.3, -1.3, 1.3, 1.3, 8)
    return light


def claw(x, y, px, py, angle, size, hook):
    """A tapering hook: between two arcs that meet in a point."""
    u, v = rotate(x - px, y - py, angle)
    u, v = u / size, v / size
    v = v - hook * (u * u - 0.25)
    half = 0.17 * np.clip(0.5 + u, 0, 1) ** 0.75 * np.sqrt(np.clip((0.5 - u) * 3, 0, 1))
    return np.where(np.abs(u) < 0.5, half - np.abs(v), -1) * size


def tribal_breakup(random, x, y):
    light = np.full_like(x, -1)
    for px, py in scatter(random, 44, 0.235, 1.0):
        swirl = math.atan2(py, px) + math.pi / 2 + random.uniform(-0.45, 0.45)
        hook = random.choice([-1, 1]) * random.uniform(0.9, 1.4)
        size = random.uniform(0.36, 0.5)
        light = np.maximum(light, claw(x, y, px, py, swirl, size, hook))
        light = np.maximum(light, claw(x, y, px + 0.07 * math.cos(swirl), py + 0.07 * math.sin(swirl), swirl + 1.1,
                                       size * 0.5, -hook))
    return smooth(0.0, light)


def liquid_breakup(random, x, y):
    """Contour bands of a warped height field, as oil on water."""
    push, pull = fractal(random, x, y, 1.7, 2, 0.4), fractal(random, x, y, 1.7, 2, 0.4)
    height = fractal(random, x + 0.3 * push, y + 0.3 * pull, 1.5, 2, 0.35)
    band = np.abs((height * 4.2) % 1 - 0.5) * 2
    return smooth(0.5 + 0.28 * noise(random, x, y, 2.4), band, 0.06)


def alpha_rays(random, x, y):
    angle = np.arctan2(y, x)
    distance = np.hypot(x, y)
    light = np.zeros_like(x)
    count = 17
    for i in range(count):
        centre = 2 * math.pi * (i + random.uniform(-0.18, 0.18)) / count
        half = random.uniform(0.055, 0.115)
        start, end = random.uniform(0.14, 0.34), random.uniform(0.72, 0.98)
        off = np.abs((angle - centre + math.pi) % (2 * math.pi) - math.pi)
        ray = np.minimum((half - off) * distance, np.minimum(distance - start, (end - distance)))
        light = np.maximum(light, smooth(0, ray))
    return light


def vortex(random, x, y):
    distance, angle = np.hypot(x, y), np.arctan2(y, x)
    arms = 7
    turn = (angle + 2.1 * np.log(distance + 0.06)) * arms / (2 * math.pi)
    part = np.abs(turn - np.floor(turn) - 0.5) * 2
    width = 0.30 + 0.22 * distance
    light = 1 - smooth(width, part, 0.02 / (distance + 0.03))
    light *= smooth(0.10, distance)
    return np.maximum(light, 1 - smooth(0.055, distance))


def gothic_window(random, x, y):
    def arch(cx, half, foot, spring):
        """Pointed arch: signed distance, above 0 inside."""
        u = np.abs(x - cx)
        radius = 2 * half
        body = np.minimum(half - u, y - foot)
        top = radius - np.hypot(u + half, y - spring)
        return np.where(y < spring, body, np.minimum(top, y - foot))

    light = np.zeros_like(x)
    for cx in (-0.235, 0.235):
        pane = arch(cx, 0.2, -0.80, 0.10)
        lattice = np.minimum(np.abs(((x - cx + y * 0.62) * 6.2) % 1 - 0.5), np.abs(((x - cx - y * 0.62) * 6.2) % 1 - 0.5))
        light = np.maximum(light, smooth(0, pane) * smooth(0.055, lattice, 0.03))
    whole = arch(0, 0.47, -0.80, 0.12)
    above = np.minimum(whole, -np.maximum(arch(-0.235, 0.235, -2, 0.10), arch(0.235, 0.235, -2, 0.10)))
    rose_d = np.hypot(x, y - 0.535)
    petal = np.maximum.reduce([0.062 - np.hypot(x - 0.082 * math.cos(a), y - 0.535 - 0.082 * math.sin(a))
                               for a in np.arange(6) * math.pi / 3 + math.pi / 6])
    light = np.maximum(light, smooth(0, petal))
    light = np.maximum(light, 1 - smooth(0.018, rose_d))
    tracery = np.minimum(np.minimum(above - 0.03, rose_d - 0.175), 1)
    return np.maximum(light, smooth(0, tracery))


def dot_rings(random, x, y):
    light = 1 - smooth(0.05, np.hypot(x, y))
    for ring in range(1, 7):
        radius = 0.155 * ring
        count = 6 * ring if ring < 6 else 30
        size = 0.026 + 0.0058 * ring
        for i in range(count):
            a = 2 * math.pi * (i + 0.5 * (ring % 2)) / count
            light = np.maximum(light, 1 - smooth(size, np.hypot(x - radius * math.cos(a), y - radius * math.sin(a))))
    return light


def foliage(random, x, y):
    """The canopy itself is steel, the light falls through the gaps."""
    shade = draw_leaves(random, x, y, scatter(random, 130, 0.115, 1.08), 0.30, False, 0.8)
    twig = np.abs(fractal(random, x, y, 1.6, 2)) - 0.018
    return (1 - shade) * smooth(0, twig, 0.01)


def caustics(random, x, y):
    """Rippled glass: bright nets on grey, as light through moving water."""
    light = np.zeros_like(x)
    for count, gap, weight, power in ((46, 0.2, 0.75, 7.0), (90, 0.13, 0.45, 6.0)):
        u = x + 0.05 * noise(random, x, y, 3.3)
        v = y + 0.05 * noise(random, x, y, 3.3)
        first, second = two_nearest(u, v, scatter(random, count, gap, 1.15))
        light = light + weight * np.exp(-power * (second - first) / gap)
    return np.clip(0.05 + light, 0, 1)


GOBOS = {
    "fixed_pebbles": pebbles, "fixed_dust_breakup": dust_breakup, "fixed_medium_circles": medium_circles,
    "fixed_night_sky": night_sky, "fixed_leaves": leaves, "fixed_vertical_bars": vertical_bars, "fixed_wave": wave,
    "fixed_block_breakup": block_breakup, "fixed_tribal_breakup": tribal_breakup,
    "fixed_liquid_breakup": liquid_breakup, "fixed_alpha_rays": alpha_rays, "rotating_vortex": vortex,
    "rotating_gothic_window": gothic_window, "rotating_dot_rings": dot_rings, "rotating_foliage": foliage,
    "rotating_caustics": caustics,
}


def draw(name, seed):
    x, y = field()
    light = GOBOS[name](np.random.RandomState(seed), x, y)
    disc = 1 - smooth(0.992, np.hypot(x, y), 0.004)
    picture = np.stack([np.clip(light, 0, 1) * disc, disc])
    small = picture.reshape(2, SIZE, SUPER, SIZE, SUPER).mean((2, 4))
    grey = np.where(small[1] > 1e-6, small[0] / np.maximum(small[1], 1e-6), 0)
    # Transmission is linear, PNG is sRGB.
    coded = np.where(grey <= 0.0031308, 12.92 * grey, 1.055 * np.power(np.maximum(grey, 1e-9), 1 / 2.4) - 0.055)
    both = np.stack([coded, small[1]], 2)
    return Image.fromarray(np.round(both * 255).astype(np.uint8), "LA"), float((small[0]).sum() / small[1].sum())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=OUT)
    parser.add_argument("--sheet", type=Path, help="also write a contact sheet")
    parser.add_argument("names", nargs="*", help="only these")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    sheet = Image.new("L", (4 * 300, 4 * 300), 40)
    for i, name in enumerate(GOBOS):
        if options.names and name not in options.names:
            continue
        picture, open_share = draw(name, 2500 + i)
        picture.save(options.out / f"{name}.png", optimize=True)
        print(f"{name}: {open_share:.0%} open, {(options.out / f'{name}.png').stat().st_size} bytes")
        grey, alpha = picture.resize((290, 290)).split()
        sheet.paste(grey, (300 * (i % 4) + 5, 300 * (i // 4) + 5), alpha)
    if options.sheet:
        sheet.save(options.sheet)


if __name__ == "__main__":
    main()

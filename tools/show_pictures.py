#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The pictures of docs/images that need a show of their own: an LED wall, lanterns with measured light, bars and sticks of many
cells. The shows, their fixtures, media and photometric files are made in a folder that is thrown away; --keep FOLDER keeps them.
Needs python3-pil.
Usage: show_pictures.py BUILD_FOLDER [--keep FOLDER] [NAME ...]."""
import colorsys
import math
import pathlib
import subprocess
import sys
import tempfile
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import pictures

IMAGES = SOURCE / "docs/images"


def show(stage, ambient_lux, extinction, camera, rest, recording="dark.show"):
    position, target, fov, size, ev = camera
    return (f'[show]\nname = "Picture"\nstage = "{SOURCE / stage}"\nrecording = "{recording}"\nambient_lux = {ambient_lux}\n'
            f'[haze]\nextinction_per_m = {extinction}\n'
            f'[[camera]]\nname = "camera"\nposition_m = {position}\ntarget_m = {target}\nfov_y_deg = {fov}\nsize = {size}\nev100 = {ev}\n'
            + rest)


def recording(path, universes):
    """Levels that stay, as an OLA show: {universe: levels}."""
    lines = ["OLA Show"]
    for last in (False, True):
        for universe, levels in universes.items():
            lines += [f"{universe} {','.join(map(str, levels))}", "40" if not last else "4000"]
    path.write_text("\n".join(lines) + "\n")


def gdtf(path, title, beams, channels):
    """beams: (name, x in metres, attributes of Beam); channels: (beam, attribute), one byte each, in their order."""
    geometries = "".join(f'<Beam Name="{name}" Position="{{1,0,0,{x:.4f}}}{{0,1,0,0}}{{0,0,1,-0.03}}{{0,0,0,1}}" {more}/>' for name, x, more in beams)
    rows = "".join(f'<DMXChannel Offset="{k}" Geometry="{beam}"><LogicalChannel Attribute="{attribute}"><ChannelFunction Attribute="{attribute}"/>'
                   "</LogicalChannel></DMXChannel>" for k, (beam, attribute) in enumerate(channels, 1))
    xml = (f'<GDTF DataVersion="1.2"><FixtureType Name="{title}" Manufacturer="Ghostlight"><Geometries><Geometry Name="Base">{geometries}</Geometry>'
           f'</Geometries><DMXModes><DMXMode Name="M" Geometry="Base"><DMXChannels>{rows}</DMXChannels></DMXMode></DMXModes></FixtureType></GDTF>')
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("description.xml", xml)


def swirl(path):
    def colour(x, y):
        u, v = (x - 320) / 180, (y - 180) / 180
        arms = 0.08 + 0.92 * (0.5 + 0.5 * math.sin(2 * math.atan2(v, u) + 9 * math.hypot(u, v))) ** 1.5
        return tuple(round(255 * arms * (a + (b - a) * x / 639)) for a, b in ((1, 0.3), (0.45, 0.55), (0.25, 1)))

    pictures.write(path, 640, 360, colour)


def wall(folder):
    recording(folder / "dark.show", {1: [0]})
    swirl(folder / "swirl.png")
    return show("assets/demo/stage.glb", 0.3, 0.012, ([-2.5, -10.5, 2.6], [0.2, 6, 3.0], 34, [960, 540], 8.3),
                '[[media]]\nname = "swirl"\nfile = "swirl.png"\n'
                '[[fixture]]\nname = "Wall"\nposition_m = [0, 7.7, 3.8]\nwall = { media = "swirl", size_m = [8, 4.5], nits = 1500, pitch_mm = 3.9 }\n')


def ies(path):
    """A ring with a dark middle: 1 degree apart, the same all round."""
    candela = [40000 * math.exp(-((g - 9) / 3.5) ** 2) for g in range(31)]
    path.write_text("IESNA:LM-63-2002\n[LUMINAIRE] Ring\nTILT=NONE\n1 -1 1 31 1 1 2 0.1 0.1 0\n1 1 500\n" + " ".join(map(str, range(31))) + "\n0\n"
                    + "\n".join(f"{value:.1f}" for value in candela) + "\n")


def ldt(path):
    """An oval, 26 by 10 degrees to half its peak, of 10 planes from C0 to C90 (symmetry 4); candela a thousand lumens."""
    gammas, planes = list(range(0, 46, 2)), range(0, 91, 10)
    width = [1 / math.hypot(math.cos(math.radians(c)) / 13, math.sin(math.radians(c)) / 5) for c in planes]
    head = ["Ghostlight", "1", "4", "36", "10", str(len(gammas)), "2", "", "Oval", "", "oval.ldt", "2026", "100", "100", "100", "100", "100", "0", "0", "0", "0",
            "100", "100", "1", "0", "1", "1", "Lamp", "10000", "3200", "1", "500"] + ["0"] * 10
    levels = [f"{4000 * math.exp(-math.log(2) * (g / w) ** 2):.1f}" for w in width for g in gammas]
    path.write_text("\n".join(head + [str(10 * k) for k in range(36)] + [str(g) for g in gammas] + levels) + "\n")


def lanterns(folder):
    recording(folder / "dark.show", {1: [255]})
    gdtf(folder / "lantern.gdtf", "Lantern", [("Beam", 0, 'BeamType="PC" BeamAngle="22" FieldAngle="30" LuminousFlux="12000" ColorTemperature="3200" BeamRadius="0.08"')],
         [("Beam", "Dimmer")])
    ies(folder / "ring.ies")
    ldt(folder / "oval.ldt")
    fixtures = "".join(f'[[fixture]]\nname = "{name}"\ngdtf = "lantern.gdtf"\naddress = 1\nposition_m = [{x}, 1, 6.5]\nrotation_deg = [64, 0, {turn}]\n{more}'
                       for name, x, turn, more in (("By its angles", -3.9, 0, ""), ("Oval", 0, 0, 'photometry = "oval.ldt"\n'), ("Ring", 3.9, 0, 'photometry = "ring.ies"\n')))
    return show("assets/optics/stage.glb", 0.3, 0.03, ([0, -4, 2.5], [0, 8, 3.1], 36, [960, 480], 7.5), fixtures)


def cells(folder):
    def colours(count, turn):
        return [round(255 * part) for k in range(count) for part in colorsys.hsv_to_rgb((turn + 0.9 * k / count) % 1, 1, 1)]

    def make(name, count, length, beam):
        beams = [(f"Cell {k + 1}", length * ((k + 0.5) / count - 0.5), beam) for k in range(count)]
        gdtf(folder / f"{name}.gdtf", name, beams, [(cell, f"ColorAdd_{c}") for cell, _, _ in beams for c in "RGB"])

    make("stick", 32, 1.0, 'BeamType="Glow" LuminousFlux="40" BeamAngle="120" FieldAngle="160" BeamRadius="0.012"')
    make("tube", 48, 2.0, 'BeamType="Wash" LuminousFlux="60" BeamAngle="5" FieldAngle="8" BeamRadius="0.016"')
    universes, fixtures = {}, ""

    def place(name, file, levels, universe, position, rotation):
        nonlocal fixtures
        address = len(universes.setdefault(universe, [])) + 1
        universes[universe] += levels
        fixtures += (f'[[fixture]]\nname = "{name}"\ngdtf = "{file}.gdtf"\nuniverse = {universe}\naddress = {address}\nposition_m = {position}\n'
                     f'rotation_deg = {rotation}\n')

    for k in range(11):
        place(f"Stick {k + 1}", "stick", colours(32, k / 11), 1 + k // 5, [round(-4.5 + 0.9 * k, 3), 6.6, 3.5], [-90, -90, 0])
    for k in range(5):
        hue = 0.58 + 0.42 * k / 4
        place(f"Tube {k + 1}", "tube", [round(255 * part) for i in range(48) for part in colorsys.hsv_to_rgb((hue + 0.1 * i / 48) % 1, 1, 1)], 4 + k // 3,
              [-6 + 3 * k, 4.3, 6.5], [0, 0, 0])
    recording(folder / "cells.show", universes)
    return show("assets/demo/stage.glb", 0.8, 0.03, ([-1.75, -1.0, 1.9], [-0.3, 5, 3.45], 60, [800, 450], 4.6), fixtures, "cells.show")


PICTURES = {"led-walls/wall.png": wall, "photometry/lanterns.png": lanterns, "multi-cell.png": cells}


def main():
    words = sys.argv[2:]
    keep = pathlib.Path(words.pop(words.index("--keep") + 1)).resolve() if "--keep" in words else None
    wanted = [word for word in words if word != "--keep"] or list(PICTURES)
    with tempfile.TemporaryDirectory() as name:
        for picture in wanted:
            folder = (keep or pathlib.Path(name)) / pathlib.Path(picture).stem
            folder.mkdir(parents=True, exist_ok=True)
            (folder / "show.toml").write_text(PICTURES[picture](folder))
            subprocess.run([str(pathlib.Path(sys.argv[1]).resolve() / "ghostlight"), "render", str(folder), "--live", "--at", "1", "-o", str(IMAGES / picture)],
                           check=True)
            print(picture)


main()

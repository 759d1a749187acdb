#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a recording (OLA show file) in which every patched fixture of a plot shines: dimmers full, shutters open,
colours on, everything else at its GDTF's default. For a first look at a plot without a desk:

    tools/light_all.py festival.mvr -o all.show
    ghostlight render festival.mvr -o festival.png --live --replay all.show

Takes the folder of a show, too, with its [[change]] addresses and [[substitute]] files (GDTF only). A plot whose
fixtures have no addresses gets some by --changes FILE: [[change]] entries for the show.toml that `ghostlight import`
makes.

--tilt leans heads forwards and backwards in turn (degrees), --colours gives every type of fixture a colour of its
own. Standard library only; same arguments, same bytes.
"""
import argparse
import fnmatch
import io
import re
import sys
import tomllib
import xml.etree.ElementTree as ET
import zipfile
from pathlib import Path

UNIVERSE = 512
# As speaks_of_light of src/fixture_files/gdtf/gdtf_modes.cpp: a file without a Beam shines where it has one of these.
LIGHT = re.compile(r"(Dimmer|Dim|Shutter\d+\w*|ColorAdd_\w+|ColorSub_C|Color\d+|ColorRGB_\w+|HSB_Hue|CIE_X|CTO|CTC|CTB|CCT|Gobo\d+|Zoom|Iris)$", re.I)
COLOURS = [(1.0, 0.55, 0.15), (0.15, 0.35, 1.0), (1.0, 0.1, 0.5), (0.1, 0.9, 0.8), (0.6, 0.2, 1.0), (1.0, 1.0, 1.0)]


def dmx_value(text, size):
    """GDTF's DMXValue ("128/1", "255/1s") in a channel of `size` bytes."""
    match = re.fullmatch(r"\s*(\d+)(?:/(\d+)(s?))?\s*", text or "")
    if not match:
        return None
    value, own = int(match[1]), int(match[2] or size)
    if own == size:
        return value
    if own > size:
        return value >> (8 * (own - size))
    if match[3]:
        return value << (8 * (size - own))
    return round(value * (256**size - 1) / (256**own - 1))


class Channel:
    def __init__(self, element):
        offsets = [part for part in (element.get("Offset") or "").split(",") if part.strip().isdigit()]
        self.offsets = [int(part) - 1 for part in offsets]
        self.size = max(1, len(self.offsets))
        self.top = 256**self.size - 1
        text = element.get("DMXBreak") or "1"
        self.dmx_break = int(text) if text.isdigit() else 1
        self.geometry = element.get("Geometry") or ""
        self.functions = []
        for logical in element.findall("LogicalChannel"):
            for function in logical.findall("ChannelFunction"):
                self.functions.append((dmx_value(function.get("DMXFrom"), self.size) or 0, function))
        self.functions.sort(key=lambda entry: entry[0])
        first = element.find("LogicalChannel")
        self.attribute = (first.get("Attribute") if first is not None else "") or ""
        initial = (element.get("InitialFunction") or "").rsplit(".", 1)[-1]
        chosen = [f for _, f in self.functions if f.get("Name") == initial] or [f for _, f in self.functions[:1]]
        default = dmx_value(element.get("Default"), self.size)
        if default is None and chosen:
            default = dmx_value(chosen[0].get("Default"), self.size)
        self.default = min(default or 0, self.top)

    def end_of(self, index):
        return self.functions[index + 1][0] - 1 if index + 1 < len(self.functions) else self.top

    def number(self, function, key, fallback):
        try:
            return float(function.get(key))
        except (TypeError, ValueError):
            return fallback

    def physical(self, wanted, attribute):
        """The raw value at which the function of this attribute gives the wanted physical value."""
        for index, (start, function) in enumerate(self.functions):
            if function.get("Attribute") != attribute:
                continue
            low, high = self.number(function, "PhysicalFrom", 0.0), self.number(function, "PhysicalTo", 1.0)
            if low == high:
                continue
            share = min(1.0, max(0.0, (wanted - low) / (high - low)))
            return round(start + share * (self.end_of(index) - start))
        return self.default

    def open_shutter(self):
        for index, (start, function) in enumerate(self.functions):
            sets = [(dmx_value(s.get("DMXFrom"), self.size) or 0, s.get("Name") or "") for s in function.findall("ChannelSet")]
            for at, name in sorted(sets):
                if re.search(r"\bopen", name, re.I) and not re.search("pulse|strob|close|shut", name, re.I):
                    return at
        for index, (start, function) in enumerate(self.functions):
            if re.fullmatch(r"Shutter\d+", function.get("Attribute") or "") and self.number(function, "PhysicalTo", 1.0) >= 1.0:
                return start if self.number(function, "PhysicalFrom", 0.0) >= 1.0 else self.end_of(index)
        return self.default

    def value(self, colour, tilt):
        attribute = self.attribute
        if attribute.startswith("Dimmer"):
            return self.top
        if re.match(r"Shutter\d*$", attribute) or attribute.startswith("Shutter") and "Strobe" not in attribute:
            return self.open_shutter()
        if attribute == "Tilt" and tilt:
            return self.physical(tilt, "Tilt")
        red, green, blue = colour
        mixed = {"R": red, "G": green, "B": blue, "C": min(green, blue), "M": min(red, blue), "Y": min(red, green)}
        match = re.match(r"Color(Add|RGB)_(\w+)$", attribute)
        if match:
            letter = match[2][0] if match[2] in ("R", "G", "B", "Red", "Green", "Blue", "C", "M", "Y") else ""
            return round(self.top * (mixed[letter] if letter else min(colour)))
        match = re.match(r"ColorSub_([CMY])$", attribute)
        if match:
            return round(self.top * (1.0 - {"C": red, "M": green, "Y": blue}[match[1]]))
        return self.default


    def speaks_of_light(self):
        return any(LIGHT.match(function.get("Attribute") or "") for _, function in self.functions)


def modes_of(data):
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        root = ET.fromstring(archive.read("description.xml"))
    modes = {}
    for mode in root.iter("DMXMode"):
        modes[mode.get("Name") or ""] = [Channel(channel) for channel in mode.iter("DMXChannel")]
    return modes


def why_dark(channels, addresses):
    """What keeps a fixture dark whatever is sent; "" where it shines."""
    if not channels:
        return "no GDTF file, or none with channels"
    if not addresses:
        return "no address"
    light = [channel for channel in channels if channel.offsets and channel.speaks_of_light()]
    if not light:
        return "no channel of light"
    if not any(addresses.get(channel.dmx_break) for channel in light):
        return "no address for the break of its light"
    return ""


def find_member(names, spec):
    wanted = spec.lower()
    by_name = {name.lower(): name for name in names if name.lower().endswith(".gdtf")}
    for name in (wanted, wanted + ".gdtf"):
        if name in by_name:
            return by_name[name]
    last = [name for small, name in by_name.items() if small.removesuffix(".gdtf").rsplit("@", 1)[-1] == wanted]
    return last[0] if len(last) == 1 else None


def absolute(text):
    match = re.fullmatch(r"\s*(\d+)(?:\.(\d+))?\s*", text or "")
    if not match:
        return 0
    return int(match[1]) if match[2] is None else (int(match[1]) - 1) * UNIVERSE + int(match[2])


def footprint(channels, dmx_break):
    return max((max(c.offsets) + 1 for c in channels if c.offsets and c.dmx_break == dmx_break), default=0)


def last_universe(root):
    highest = max((absolute(address.text) for address in root.iter("Address")), default=0)
    return (highest + UNIVERSE - 1) // UNIVERSE


class Show:
    """An .mvr as it is, or what a show.toml makes of one."""

    def __init__(self, path):
        self.folder, self.plot, self.patch, self.substitutes = path.parent, path, {}, []
        if path.is_dir() or path.suffix == ".toml":
            file = path / "show.toml" if path.is_dir() else path
            settings = tomllib.loads(file.read_text(encoding="utf-8"))
            self.folder = file.parent
            self.plot = self.folder / settings["show"]["plot"]
            self.substitutes = settings.get("substitute", [])
            for change in settings.get("change", []):
                if "address" in change:
                    absolute_place = (change.get("universe", 1) - 1) * UNIVERSE + change["address"]
                    places = self.patch.setdefault(change["uuid"].lower(), {})
                    places[change.get("break", 1)] = absolute_place if change["address"] else 0

    def substitute(self, spec, member):
        for entry in self.substitutes:
            if any(fnmatch.fnmatchcase(name.lower(), entry["for"].lower()) for name in (spec, member or "") if name):
                return entry
        return None


def light(show, colours, tilt, changes, without=()):
    universes, lit, dark = {}, 0, {}
    with zipfile.ZipFile(show.plot) as archive:
        names = archive.namelist()
        description = next(name for name in names if name.lower() == "generalscenedescription.xml")
        root = ET.fromstring(archive.read(description))
        types, kinds = {}, {}
        free = last_universe(root) * UNIVERSE + 1
        for index, fixture in enumerate(root.iter("Fixture")):
            spec = (fixture.findtext("GDTFSpec") or "").strip()
            member = find_member(names, spec)
            mode = fixture.findtext("GDTFMode") or ""
            if substitute := show.substitute(spec, member):
                member = show.folder / substitute["gdtf"]
                mode = substitute.get("mode", mode)
            if member and member not in types:
                data = member.read_bytes() if isinstance(member, Path) else archive.read(member)
                types[member] = modes_of(data)
            modes = types.get(member) or {}
            channels = modes.get(mode) or next(iter(modes.values()), [])
            addresses = {int(a.get("break") or 0): absolute(a.text) for a in fixture.findall("Addresses/Address")}
            lowest = min(addresses, default=0)
            addresses = {key - lowest + 1 if lowest == 0 else key: value for key, value in addresses.items()}
            addresses |= show.patch.get((fixture.get("uuid") or "").lower(), {})
            addresses = {key: value for key, value in addresses.items() if value > 0}
            if channels and not addresses and changes is not None:
                for dmx_break in sorted({channel.dmx_break for channel in channels if channel.offsets}):
                    needed = footprint(channels, dmx_break)
                    if (free - 1) % UNIVERSE + needed > UNIVERSE:
                        free += UNIVERSE - (free - 1) % UNIVERSE
                    addresses[dmx_break] = free
                    changes.append(
                        f'[[change]]\nuuid = "{fixture.get("uuid")}"\nbreak = {dmx_break}\n'
                        f"universe = {(free - 1) // UNIVERSE + 1}\naddress = {(free - 1) % UNIVERSE + 1}\n"
                    )
                    free += needed
            if any(fnmatch.fnmatchcase(spec.lower(), pattern.lower()) for pattern in without):
                dark["left out by --without"] = dark.get("left out by --without", 0) + 1
                continue
            if reason := why_dark(channels, addresses):
                dark[reason] = dark.get(reason, 0) + 1
                continue
            lit += 1
            kind = kinds.setdefault(spec, len(kinds))
            colour = COLOURS[kind % len(COLOURS)] if colours else (1.0, 1.0, 1.0)
            lean = tilt if index % 2 else -tilt
            for channel in channels:
                base = addresses.get(channel.dmx_break, 0)
                if not base:
                    continue
                value = channel.value(colour, lean)
                for place, offset in enumerate(channel.offsets):
                    at = base - 1 + offset
                    levels = universes.setdefault(at // UNIVERSE + 1, bytearray(UNIVERSE))
                    levels[at % UNIVERSE] = value >> (8 * (channel.size - 1 - place)) & 255
    return universes, lit, dark


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("show", type=Path, help=".mvr file, or a show with one")
    parser.add_argument("-o", "--out", type=Path, required=True, help="recording to write")
    parser.add_argument("--tilt", type=float, default=0.0, help="degrees that heads lean, in turn both ways")
    parser.add_argument("--colours", action="store_true", help="a colour for each type of fixture")
    parser.add_argument("--without", action="append", default=[], help="fixture files that stay dark, with * and ?")
    parser.add_argument("--changes", type=Path, help="write addresses for fixtures that have none, as [[change]] entries")
    arguments = parser.parse_args()
    changes = [] if arguments.changes else None
    universes, lit, dark = light(Show(arguments.show), arguments.colours, arguments.tilt, changes, arguments.without)
    if arguments.changes:
        arguments.changes.write_text("\n".join(changes), encoding="utf-8", newline="\n")
    lines = ["OLA Show"]
    for moment in range(2):
        for number in sorted(universes):
            lines.append(f"{number} {','.join(str(value) for value in universes[number])}")
            lines.append("0" if number != max(universes) else "2000")
    arguments.out.write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")
    reasons = "".join(f", {count} dark ({reason})" for reason, count in sorted(dark.items()))
    print(f"{arguments.out}: {lit} fixtures lit{reasons}, {len(universes)} universes")
    return 0 if lit else 1


if __name__ == "__main__":
    sys.exit(main())

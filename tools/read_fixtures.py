#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A second reading of our own GDTF files, with nothing but Python's library: writes tests/references/fixtures.json, which
tests/fixture_files/gdtf/oracle_test.cpp holds the reader against. Usage: read_fixtures.py"""
import json
import pathlib
import re
import xml.etree.ElementTree as xml
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FILES = sorted((ROOT / "assets/fixtures").glob("*.gdtf")) + [ROOT / "tests/references/pixel_bar.xml"]
VIRTUAL = 4  # bytes of a channel that has no address
TREE = ("Geometry", "Axis", "Beam", "GeometryReference")


def places(top, tops):
    """Geometry name -> the offsets, per break, at which it stands below a top geometry; and how many beams there are."""
    found, beams = {}, 0

    def walk(node, offsets):
        nonlocal beams
        if node.tag == "GeometryReference":
            own = {int(one.get("DMXBreak", 1)): int(one.get("DMXOffset", 1)) for one in node.findall("Break")}
            walk(tops[node.get("Geometry")], own)
            return
        beams += node.tag == "Beam"
        found.setdefault(node.get("Name"), []).append(offsets)
        for child in node:
            if child.tag in TREE:
                walk(child, offsets)
    walk(tops[top], {})
    return found, beams


def dmx(text, size):
    """"value/bytes" in a channel of `size` bytes: the value's bytes again and again, coarse first."""
    value, _, length = text.partition("/")
    own = int(value).to_bytes(int(length), "big")
    return int.from_bytes((own * size)[:size], "big")


def functions(channel, size):
    """Each ends where the next of its logical channel begins that counts under the same values of its master."""
    found = []
    for logical in channel.findall("LogicalChannel"):
        own = logical.findall("ChannelFunction")
        begins = [dmx(one.get("DMXFrom", "0/1"), size) for one in own]
        masters = [(one.get("ModeMaster"), one.get("ModeFrom"), one.get("ModeTo")) for one in own]
        for k, function in enumerate(own):
            after = [begins[n] for n in range(k + 1, len(own)) if masters[n] == masters[k]]
            found.append({"name": function.get("Name"), "attribute": function.get("Attribute"), "from": begins[k],
                          "to": after[0] - 1 if after else 256 ** size - 1, "default": dmx(function.get("Default", "0/1"), size),
                          "physical": [float(function.get("PhysicalFrom", 0)), float(function.get("PhysicalTo", 1))],
                          "sets": [[one.get("Name"), dmx(one.get("DMXFrom", "0/1"), size)] for one in function.findall("ChannelSet")]})
    return found


def mode(element, tops):
    found, beams = places(element.get("Geometry"), tops)
    channels, used = [], {}
    for channel in element.findall("DMXChannels/DMXChannel"):
        own = [int(part) for part in re.findall(r"\d+", channel.get("Offset") or "")]
        at = int(channel.get("DMXBreak", 1))
        for offsets in found[channel.get("Geometry")]:
            bytes_ = [offset + offsets.get(at, 1) - 1 for offset in own]
            used.setdefault(at, set()).update(bytes_)
            channels.append({"break": at, "bytes": bytes_, "functions": functions(channel, len(own) or VIRTUAL)})
    return {"name": element.get("Name"), "beams": beams, "channels": channels,
            "footprint": {str(at): max(bytes_) for at, bytes_ in used.items() if bytes_}}


def reading(path):
    text = zipfile.ZipFile(path).read("description.xml") if path.suffix == ".gdtf" else path.read_bytes()
    kind = xml.fromstring(text).find("FixtureType")
    tops = {node.get("Name"): node for node in kind.find("Geometries")}
    physical = "PhysicalDescriptions/"
    return {"name": kind.get("Name"), "manufacturer": kind.get("Manufacturer"), "modes": [mode(one, tops) for one in kind.findall("DMXModes/DMXMode")],
            "wheels": [{"name": wheel.get("Name"), "slots": [slot.get("Name") for slot in wheel.findall("Slot")],
                        "media": sum(bool(slot.get("MediaFileName")) for slot in wheel.findall("Slot")),
                        "facets": len(wheel.findall("Slot/Facet"))} for wheel in kind.findall("Wheels/Wheel")],
            "emitters": len(kind.findall(physical + "Emitters/Emitter")), "filters": len(kind.findall(physical + "Filters/Filter")),
            "measurements": len(kind.findall(physical + "*/*/Measurement")), "dmx_profiles": len(kind.findall(physical + "DMXProfiles/DMXProfile")),
            "models": len(kind.findall("Models/Model"))}


def main():
    out = {path.relative_to(ROOT).as_posix(): reading(path) for path in FILES}
    (ROOT / "tests/references/fixtures.json").write_text(json.dumps(out, separators=(",", ":")).replace('{"name"', '\n{"name"') + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()

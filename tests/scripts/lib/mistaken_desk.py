# SPDX-License-Identifier: Apache-2.0
"""A desk for mistakes_test.py, in a namespace of its own: sends what its argument (JSON) lists, 40 times a second. Printed:
"sending", when the first round is out."""
import json
import socket
import struct
import sys
import time

spec = json.loads(sys.argv[1])
interface = sys.argv[2]  # our address


def layer(size, offset):
    return struct.pack(">H", 0x7000 | (size - offset))


def root(size, vector, cid):
    return struct.pack(">HH", 0x10, 0) + b"ASC-E1.17\0\0\0" + layer(size, 16) + struct.pack(">I", vector) + bytes([cid]) * 16


def data(one, sequence, slots, options, start_code=0):
    size = 126 + len(slots)
    packet = root(size, 4, one["cid"]) + layer(size, 38) + struct.pack(">I", 2) + one["name"].encode().ljust(64, b"\0")
    packet += bytes([one["priority"]]) + struct.pack(">H", one.get("sync", 0)) + bytes([sequence & 255, options])
    return packet + struct.pack(">H", one["universe"]) + layer(size, 115) + bytes([2, 0xA1, 0, 0, 0, 1]) + struct.pack(">H", 1 + len(slots)) + \
        bytes([start_code]) + slots


def sync(one, sequence):
    return root(49, 8, one["cid"]) + layer(49, 38) + struct.pack(">I", 1) + bytes([sequence & 255]) + struct.pack(">HH", one["sync"], 0)


def announcement(one):
    size = 120 + 2 * len(one["announces"])
    packet = root(size, 8, one["cid"]) + layer(size, 38) + struct.pack(">I", 2) + one["name"].encode().ljust(64, b"\0") + bytes(4)
    return packet + layer(size, 112) + struct.pack(">I", 1) + bytes(2) + b"".join(struct.pack(">H", u) for u in one["announces"])


def artdmx(one, sequence, slots):
    number, physicals = 0 if one.get("unnumbered") else sequence % 255 + 1, one.get("physicals", [0])
    head = b"Art-Net\0" + struct.pack("<H", 0x5000) + bytes([0, one.get("version", 14), number, physicals[sequence % len(physicals)]])
    return head + struct.pack("<H", one["universe"]) + struct.pack(">H", len(slots)) + slots


def artpoll():
    return b"Art-Net\0" + struct.pack("<H", 0x2000) + bytes([0, 14, 0, 0])


def arttimecode(count, hour):
    return b"Art-Net\0" + struct.pack("<H", 0x9700) + bytes([0, 14, 0, 0, count % 25, count // 25 % 60, 0, hour, 1])


def group(universe):
    return f"239.255.{universe >> 8}.{universe & 255}"


for one in spec:
    one.setdefault("cid", 1)
    one.setdefault("name", "Test desk")
    one.setdefault("priority", 100)
    out = one["out"] = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    out.setsockopt(socket.SOL_SOCKET, socket.SO_BROADCAST, 1)
    out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))
    out.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    out.bind((one.get("bind", "0.0.0.0"), one.get("port", 0)))
    if one.get("by_turns"):  # two sockets
        one["outs"] = [out, socket.socket(socket.AF_INET, socket.SOCK_DGRAM)]
        one["outs"][1].setsockopt(socket.SOL_SOCKET, socket.SO_BROADCAST, 1)
    slots = bytearray(one.get("slots", 512))
    for address, value in one["levels"].items():
        slots[int(address) - 1] = value
    one["data"] = bytes(slots)
    one["sequence"] = one.get("first_number", 0)
    if "twin" in one:  # the same packets from another address, too
        twin = one["twin_out"] = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        twin.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))
        twin.bind((one["twin"], 0))


def look(one):
    """What it shows now: channel 40 flashes for so many packets, or channels move, or are up by turns for a quarter of a second (chase_step packets) each."""
    slots = bytearray(one["data"])
    if "flashes" in one:
        slots[39] = count // one["flashes"] % 2 * 255
    for address in one.get("moves", []):
        slots[address - 1] = 1 + count % 200
    chased = one.get("chases", [])
    for place, address in enumerate(chased):
        slots[address - 1] = 255 if (count + one.get("chase_begins", 0)) // one.get("chase_step", 10) % len(chased) == place else 0
    return bytes(slots)


def send(one, packet, to, port):
    try:
        one["out"].sendto(packet, (to, port))
    except OSError:
        pass  # no cable


start = time.monotonic()
count = 0
while True:
    passed = time.monotonic() - start
    for one in spec:
        if one.get("announces") and count % 40 == 0 and passed <= one.get("stops_s", 1e9):
            send(one, announcement(one), group(64214), 5568)
        if one.get("polls") and count % 40 == 0:
            send(one, artpoll(), "10.93.0.255", 6454)
        if one.get("timecode"):
            send(one, arttimecode(count, one["timecode"]), "10.93.0.255", 6454)
        if one.get("silent") or count % one.get("every", 1) != 0:
            continue
        if "outs" in one:
            one["out"] = one["outs"][count % 2]
        if "stops_s" in one and passed > one["stops_s"]:
            if one.pop("goodbye", False):
                for _ in range(3):
                    one["sequence"] += 1
                    send(one, data(one, one["sequence"], b"", 0x40), group(one["universe"]), 5568)
            continue
        if one["protocol"] == "artnet":
            send(one, artdmx(one, one.get("number", count // one.get("every", 1) + one.get("first_number", 0)), look(one)), one.get("to", "10.93.0.255"), 6454)
            continue
        if passed > one.get("moves_after_s", 1e9):
            one["universe"] = one["moves_to"]
        to = one.get("to", group(one["universe"]))
        one["sequence"] += 1
        number = one.get("number", one["sequence"] * one.get("step", 1))
        options, start_code, slots = one.get("options", 0), 0, look(one)
        if "per_address" in one and (number % 5 == 1 or one.get("priorities_alone")):
            start_code, slots = 0xDD, bytes([one["per_address"]]) * one.get("per_address_count", 512)
        if passed > one.get("bad_after_s", 1e9):
            one["priority"] = 250
        if number % one.get("blind_every", 1 << 30) == 0 or passed > one.get("blind_after_s", 1e9):
            options, slots = 0x80, bytes(512)
        if number % one.get("text_every", 1 << 30) == 0:
            start_code = 0x17
        packet = b"something else" * 20 if one.get("garbage") else data(one, number, slots, options, start_code)
        if "cut" in one:
            packet = packet[:126 + one["cut"]]
        if number % one.get("exchanges", 1 << 30) == 0:
            one["held"] = packet
        elif number % one.get("loses", 1 << 30) != 0:
            send(one, packet, to, 5568)
            if "held" in one:
                send(one, one.pop("held"), to, 5568)
            if one.get("twice"):
                send(one, packet, to, 5568)
            if "twin" in one:
                if "twin_first_number" in one:
                    packet = data(one, number + one["twin_first_number"], slots, options, start_code)
                one["twin_out"].sendto(packet, (to, 5568))
        if "sync" in one and passed < one.get("sync_stops_s", 1e9) and count % one.get("sync_every", 1) == 0:
            send(one, sync(one, number), group(one["sync"]), 5568)
    if count == 0:
        print("sending", flush=True)
    count += 1
    time.sleep(max(0.0, start + count / 40 - time.monotonic()))

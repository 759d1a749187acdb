#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""MVR-xchange between two machines: ghostlight and a station written from the standard (DIN SPEC 15801: mDNS and TCP, in Python,
below), then two of ghostlight. Each machine is a network namespace without a way out (root).

Arguments: source folder, build folder. Exit 77: skipped, with the reason."""
import json
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

from lib import needs

SOURCE, GHOSTLIGHT = Path(sys.argv[1]).resolve(), str(Path(sys.argv[2]).resolve() / "ghostlight")
DESK, VIS = f"gl_x{os.getpid()}", f"gl_y{os.getpid()}"

# Runs in the desk's namespace: a station named "Desk" of group GROUP that offers FILE; announces itself by mDNS, asks for others, joins
# them, commits FILE after they joined. Prints one JSON line for each thing that happens.
STATION = r'''
import json, select, socket, struct, sys, time
address, group, path, uuid = sys.argv[1:5]
content = open(path, "rb").read()
FILE = "0F9D3E9E-9E4C-4C1B-8D8E-6D4B6C1B2A01"

def say(**what):
    print(json.dumps(what), flush=True)

def name(text):
    return b"".join(bytes([len(label)]) + label.encode() for label in text.split(".") if label) + b"\0"

def record(owner, kind, data, ttl=120):
    return name(owner) + struct.pack(">HHIH", kind, 1, ttl, len(data)) + data

SERVICE = "_mvrxchange._tcp.local"
server = socket.socket()
server.bind((address, 0))
server.listen(8)
port = server.getsockname()[1]
instance = f"{group}.{SERVICE}"
texts = b"".join(bytes([len(text)]) + text for text in (b"StationName=Desk", b"StationUUID=" + uuid.encode()))
answer = struct.pack(">HHHHHH", 0, 0x8400, 0, 4, 0, 0) + record(SERVICE, 12, name(instance)) + \
    record(instance, 33, struct.pack(">HHH", 0, 0, port) + name("desk.local")) + record(instance, 16, texts) + \
    record("desk.local", 1, socket.inet_aton(address))
question = struct.pack(">HHHHHH", 0, 0, 1, 0, 0, 0) + name(SERVICE) + struct.pack(">HH", 12, 1)
mdns = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
mdns.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
mdns.bind(("", 5353))
mdns.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton("224.0.0.251") + socket.inet_aton(address))
mdns.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(address))

def read_name(data, at):
    labels, end = [], None
    while data[at]:
        if data[at] & 0xC0 == 0xC0:
            end = end or at + 2
            at = (data[at] & 0x3F) << 8 | data[at + 1]
            continue
        labels.append(data[at + 1:at + 1 + data[at]].decode())
        at += 1 + data[at]
    return ".".join(labels), end or at + 1

def records(data):
    flags, questions, *counts = struct.unpack_from(">HHHHH", data, 2)
    at, found = 12, []
    for _ in range(questions):
        _, at = read_name(data, at)
        at += 4
    for _ in range(sum(counts)):
        owner, at = read_name(data, at)
        kind, _, _, size = struct.unpack_from(">HHIH", data, at)
        found.append((owner, kind, at + 10, size))
        at += 10 + size
    return flags, found

def package(payload, kind=0):
    return struct.pack(">IIIIIQ", 778682, 1, 0, 1, kind, len(payload)) + payload

def send(connection, message):
    connection.sendall(package(json.dumps(message).encode()))

def receive(connection):
    def exactly(count):
        data = b""
        while len(data) < count:
            more = connection.recv(count - len(data))
            if not more: raise EOFError
            data += more
        return data
    magic, version, number, count, kind, length = struct.unpack(">IIIIIQ", exactly(28))
    assert (magic, version, number, count) == (778682, 1, 0, 1), (magic, version, number, count)
    data = exactly(length)
    return data if kind else json.loads(data)

COMMIT = {"Type": "MVR_COMMIT", "verMajor": 1, "verMinor": 6, "FileSize": len(content), "FileUUID": FILE, "StationUUID": uuid,
          "ForStationsUUID": [], "Comment": "from the standard", "FileName": "desk.mvr"}

def visit(to):
    with socket.create_connection(to, timeout=5) as out:
        send(out, {"Type": "MVR_JOIN", "Provider": "standard", "verMajor": "1", "verMinor": "6", "StationUUID": uuid,
                   "StationName": "Desk", "Commits": []})
        joined = receive(out)
        say(joined=joined)
        send(out, COMMIT)
        say(commit_answer=receive(out))
        # What they offer.
        if joined["Commits"]:
            send(out, {"Type": "MVR_REQUEST", "FileUUID": joined["Commits"][-1]["FileUUID"], "FromStationUUID": joined["StationUUID"]})
            say(file=len(receive(out)))
        send(out, {"Type": "MVR_REQUEST", "FileUUID": "no such file", "FromStationUUID": joined["StationUUID"]})
        say(no_file=receive(out))
        send(out, {"Type": "MVR_OF_TOMORROW", "StationUUID": uuid})
        say(unknown=receive(out))

met, last = set(), 0.0
connections = []
while True:
    if time.monotonic() - last > 2:
        last = time.monotonic()
        mdns.sendto(answer, ("224.0.0.251", 5353))
        mdns.sendto(question, ("224.0.0.251", 5353))
    ready, _, _ = select.select([mdns, server] + connections, [], [], 0.2)
    for one in ready:
        if one is mdns:
            data, sender = mdns.recvfrom(9000)
            flags, found = records(data)
            if not flags & 0x8000:
                if SERVICE.split(".")[0].encode() in data and sender[0] != address: mdns.sendto(answer, ("224.0.0.251", 5353))
                continue
            for owner, kind, at, size in found:
                if kind != 33 or not owner.endswith(SERVICE) or sender[0] == address: continue
                to = (sender[0], struct.unpack_from(">H", data, at + 4)[0])
                if to in met: continue
                met.add(to)
                own = [data[at + 1:at + size] for o, k, at, size in found if k == 16 and o == owner]
                say(found=owner, to=to, texts=[text.decode(errors="replace") for text in own])
                visit(to)
        elif one is server:
            connections.append(server.accept()[0])
        else:
            try:
                message = receive(one)
            except (EOFError, OSError):
                connections.remove(one)
                continue
            say(heard=message)
            kind = message["Type"]
            if kind == "MVR_JOIN":
                send(one, {"Type": "MVR_JOIN_RET", "OK": "true", "Message": "", "Provider": "standard", "verMajor": "1", "verMinor": "6",
                           "StationUUID": uuid, "StationName": "Desk", "Files": []})
            elif kind == "MVR_REQUEST" and message["FileUUID"] == FILE:
                half = len(content) // 2  # in two packages
                one.sendall(struct.pack(">IIIIIQ", 778682, 1, 0, 2, 1, half) + content[:half])
                one.sendall(struct.pack(">IIIIIQ", 778682, 1, 1, 2, 1, len(content) - half) + content[half:])
            else:
                send(one, {"Type": kind + "_RET", "OK": "true", "Message": ""})
'''


def ip(*words):
    subprocess.run(["ip", *words], check=True, capture_output=True, timeout=20)


def inside(namespace, *words):
    return ["ip", "netns", "exec", namespace, *map(str, words)]


class Program:
    """Prints JSON, line by line."""

    def __init__(self, folder, name, command):
        self.path = Path(folder) / f"{name}.jsonl"
        self.process = subprocess.Popen(command, stdout=self.path.open("w"), stderr=(Path(folder) / f"{name}.err").open("w"))

    def lines(self):
        return [json.loads(line) for line in self.path.read_text().split("\n")[:-1]]

    def wait(self, what, condition, limit_s=30):
        end = time.monotonic() + limit_s
        while time.monotonic() < end:
            for line in self.lines():
                if condition(line):
                    return line
            time.sleep(0.05)
        raise AssertionError(f"{what}: not within {limit_s} s; {self.path.read_text()[-3000:]}"
                             f"{self.path.with_suffix('.err').read_text()[-2000:]}")

    def stop(self):
        self.process.send_signal(signal.SIGINT)
        try:
            self.process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            self.process.kill()


def plot(path, fixture_x_mm):
    """A plot of one truss-hung object, as the standard's example has it."""
    matrix = f"{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{fixture_x_mm},0,5000}}"
    xml = f"""<?xml version="1.0" encoding="UTF-8"?>
<GeneralSceneDescription verMajor="1" verMinor="6" provider="test" providerVersion="1"><Scene><Layers>
<Layer name="Rig" uuid="11111111-1111-4111-8111-111111111111"><ChildList>
<Fixture name="Spot" uuid="22222222-2222-4222-8222-222222222222"><Matrix>{matrix}</Matrix><GDTFSpec>none.gdtf</GDTFSpec>
<GDTFMode>a</GDTFMode><Addresses><Address break="0">1</Address></Addresses></Fixture>
</ChildList></Layer></Layers></Scene></GeneralSceneDescription>"""
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("GeneralSceneDescription.xml", xml)
        archive.writestr("filler.bin", os.urandom(300_000))


def test_against_the_standard(work):
    plot(work / "desk.mvr", 1000)
    plot(work / "ours.mvr", 0)
    shutil.copy(work / "ours.mvr", work / "first.mvr")
    made = subprocess.run([GHOSTLIGHT, "import", str(work / "first.mvr"), "-o", str(work / "show"), "--quiet"],
                          capture_output=True, text=True, timeout=60)
    assert made.returncode == 0, made.stderr
    desk = Program(work, "desk", inside(DESK, "/usr/bin/python3", "-c", STATION, "10.93.0.1", "Tour", work / "desk.mvr",
                                        "AAAAAAAA-0000-4000-8000-000000000001"))
    vis = Program(work, "vis", inside(VIS, GHOSTLIGHT, "xchange", "--group", "tour", "--save", work / "come", "--share", work / "ours.mvr",
                                      "--show", work / "show", "--station", "FOH", "--interface", "net0", "--json"))
    try:
        found = desk.wait("the desk finds us", lambda line: "found" in line)
        assert any("StationName=FOH" in text for text in found["texts"]), found
        joined = desk.wait("the desk joins us", lambda line: "joined" in line)["joined"]
        assert joined["Type"] == "MVR_JOIN_RET" and joined["OK"] is True and joined["StationName"] == "FOH", joined
        assert joined["Commits"][0]["FileSize"] == (work / "ours.mvr").stat().st_size, joined
        assert desk.wait("our plot", lambda line: "file" in line)["file"] == (work / "ours.mvr").stat().st_size
        assert desk.wait("a refusal", lambda line: "no_file" in line)["no_file"]["OK"] is False
        assert desk.wait("its commit is answered", lambda line: "commit_answer" in line)["commit_answer"]["Type"] == "MVR_COMMIT_RET"
        unknown = desk.wait("an unknown type is answered", lambda line: "unknown" in line)["unknown"]
        assert unknown["Type"] == "MVR_OF_TOMORROW_RET" and unknown["OK"] is False, unknown
        heard = desk.wait("we join the desk", lambda line: line.get("heard", {}).get("Type") == "MVR_JOIN")["heard"]
        assert heard["Provider"] == "Ghostlight", heard
        asked = desk.wait("we ask for its plot", lambda line: line.get("heard", {}).get("Type") == "MVR_REQUEST")["heard"]
        assert asked["FromStationUUID"] == ["AAAAAAAA-0000-4000-8000-000000000001"], asked
        received = vis.wait("its plot comes", lambda line: line["event"] == "received")
        assert received["station"] == "Desk" and received["comment"] == "from the standard", received
        assert Path(received["file"]).read_bytes() == (work / "desk.mvr").read_bytes()
        merged = vis.wait("and is merged", lambda line: line["event"] == "merged")
        assert "moved" in merged["text"], merged
        assert (work / "show" / "first.mvr").read_bytes() == (work / "desk.mvr").read_bytes()
    finally:
        vis.stop()
        left = None
        try:
            left = desk.wait("we say goodbye", lambda line: line.get("heard", {}).get("Type") == "MVR_LEAVE", 5)
        finally:
            desk.process.kill()
    assert left["heard"]["FromStationUUID"], left
    print("ok: a station written from the standard finds us, joins, takes our plot and gives its own, which is merged")


def test_two_of_ours(work):
    plot(work / "two.mvr", 2000)
    a = Program(work, "a", inside(DESK, GHOSTLIGHT, "xchange", "--share", work / "two.mvr", "--station", "A", "--json"))
    b = Program(work, "b", inside(VIS, GHOSTLIGHT, "xchange", "--save", work / "b", "--station", "B", "--files", 1, "--json"))
    try:
        b.process.wait(timeout=30)
        assert b.process.returncode == 0, b.path.read_text()
        assert (work / "b" / "two.mvr").read_bytes() == (work / "two.mvr").read_bytes()
        a.wait("B says goodbye", lambda line: line["event"] == "left" and line["station"] == "B")
    finally:
        a.stop()
        b.process.kill()
    print("ok: two Ghostlights find each other without being told where")


def test_a_thousand_stations(work):
    """Forged announcements, one packet each; the one real station is found all the same."""
    storm = r'''
import socket, struct, sys, time
out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
out.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
out.bind((sys.argv[1], 5353))
out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(sys.argv[1]))
def name(text): return b"".join(bytes([len(label)]) + label.encode() for label in text.split(".")) + b"\0"
for i in range(1000):
    owner = f"S{i}.Storm._mvrxchange._tcp.local"
    uuid = b"StationUUID=%08d-0000" % i
    srv, txt = struct.pack(">HHH", 0, 0, 1 + i) + name("h.local"), bytes([len(uuid)]) + uuid
    packet = struct.pack(">HHHHHH", 0, 0x8400, 0, 2, 0, 0)
    for kind, data in ((33, srv), (16, txt)): packet += name(owner) + struct.pack(">HHIH", kind, 1, 120, len(data)) + data
    out.sendto(packet, ("224.0.0.251", 5353))
    out.sendto(bytes([i & 255]) * (i % 200), ("224.0.0.251", 5353))
    time.sleep(0.001)
'''
    plot(work / "three.mvr", 3000)
    b = Program(work, "storm", inside(VIS, GHOSTLIGHT, "xchange", "--group", "Storm", "--save", work / "c", "--station", "B", "--json"))
    a = None
    try:
        time.sleep(1)
        a = Program(work, "real", inside(DESK, GHOSTLIGHT, "xchange", "--group", "Storm", "--share", work / "three.mvr", "--station", "A", "--json"))
        b.wait("the real one", lambda line: line["event"] == "found" and line["station"] == "A")
        subprocess.run(inside(DESK, "/usr/bin/python3", "-c", storm, "10.93.0.1"), check=True, timeout=60)
        b.wait("the limit", lambda line: "more than 256 stations" in line["text"])
        b.wait("the plot", lambda line: line["event"] == "received")
        memory_kb = int(next(line for line in Path(f"/proc/{b.process.pid}/status").read_text().splitlines() if line.startswith("VmHWM")).split()[1])
        # `ip netns exec` becomes the program, so this is its memory.
        assert memory_kb < 200_000, memory_kb
        assert b.process.poll() is None
    finally:
        if a:
            a.stop()
        b.stop()
    print(f"ok: a thousand forged stations, {memory_kb} kB at most")


def main():
    if os.getuid() != 0:
        needs.skip("needs root for network namespaces")
    needs.packages("iproute2")
    if not Path(GHOSTLIGHT).exists():
        needs.skip(f"{GHOSTLIGHT} is not built")
    try:
        for namespace in (DESK, VIS):
            ip("netns", "add", namespace)
            ip("-n", namespace, "link", "set", "lo", "up")
        ip("link", "add", "name", "net0", "netns", DESK, "type", "veth", "peer", "name", "net0", "netns", VIS)
        for namespace, address in ((DESK, "10.93.0.1"), (VIS, "10.93.0.2")):
            ip("-n", namespace, "addr", "add", f"{address}/24", "brd", "10.93.0.255", "dev", "net0")
            ip("-n", namespace, "link", "set", "net0", "up")
    except (subprocess.CalledProcessError, OSError) as problem:
        clean()
        needs.skip(f"no network namespaces or veth here: {problem}")
    try:
        with tempfile.TemporaryDirectory() as folder:
            test_against_the_standard(Path(folder))
        with tempfile.TemporaryDirectory() as folder:
            test_two_of_ours(Path(folder))
        with tempfile.TemporaryDirectory() as folder:
            test_a_thousand_stations(Path(folder))
    finally:
        clean()


def clean():
    for namespace in (DESK, VIS):
        subprocess.run(["ip", "netns", "del", namespace], capture_output=True, check=False)


main()

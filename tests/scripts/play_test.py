#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What `ghostlight play` puts on the wire, on ports of its own on the loopback interface: every look of desks of 30 to 50 Hz, in order;
packets with as many slots as were recorded; a universe that rests at the rate. Prints how far looks are from their time; the times
themselves are held by tests/dmx/record/playout_test.cpp, without a clock. Arguments: source folder, build folder. Exit 77: skipped."""
import os
import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
import time

GHOSTLIGHT = str(pathlib.Path(sys.argv[2]).resolve() / "ghostlight")
SACN = 20000 + os.getpid() % 20000 * 2
ARTNET = SACN + 1
LOOKS = 301


def show(work, interval_ms, slots, looks=LOOKS, universe=1):
    """An OLA show file: looks that count in slots 1 and 2."""
    lines = ["OLA Show"]
    for i in range(looks):
        lines += [f"{universe} " + ",".join(map(str, [i >> 8, i & 255] + [9] * (slots - 2))), str(interval_ms)]
    path = work / f"{interval_ms}.show"
    path.write_text("\n".join(lines[:-1]) + "\n0\n")
    return path


def play(path, *more, protocol="sacn"):
    """(arrival in seconds, slots) of every packet of levels."""
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 21)
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_TIMESTAMPNS_OLD if hasattr(socket, "SO_TIMESTAMPNS_OLD") else 35, 1)
    sock.bind(("127.0.0.1", SACN if protocol == "sacn" else ARTNET))
    sock.settimeout(0.5)
    player = subprocess.Popen([GHOSTLIGHT, "play", str(path), "--protocol", protocol, "--to", "127.0.0.1", "--sacn-port", str(SACN), "--artnet-port",
                               str(ARTNET), "--quiet", *map(str, more)])
    packets = []
    deadline = time.monotonic() + 120
    while time.monotonic() < deadline:
        try:
            data, control, _, _ = sock.recvmsg(2000, 100)
        except TimeoutError:
            if player.poll() is not None:
                break
            continue
        seconds, nanoseconds = struct.unpack("ll", control[0][2][:16])
        if protocol == "artnet":
            packets.append((seconds + nanoseconds / 1e9, data[18:]))
        elif not data[112] & 0x40:  # no goodbye
            packets.append((seconds + nanoseconds / 1e9, data[126:]))
    assert player.wait(20) == 0
    sock.close()
    return packets


def looks_of(packets):
    """(arrival, number) of each look, where it begins."""
    looks = []
    for arrival, slots in packets:
        number = slots[0] << 8 | slots[1]
        if not looks or looks[-1][1] != number:
            looks.append((arrival, number))
    return looks


def every_look(work):
    for protocol in ("sacn", "artnet"):
        for interval_ms in (33, 25, 20):
            packets = play(show(work, interval_ms, 512), protocol=protocol)
            looks = looks_of(packets)
            start = looks[0][0]
            off_ms = sorted(abs((arrival - start) * 1000 - number * interval_ms) for arrival, number in looks)
            print(f"{protocol}, a look every {interval_ms} ms: {len(looks)} of {LOOKS} sent, {len(packets)} packets; off its time by "
                  f"{off_ms[len(off_ms) // 2]:.2f} ms in the median, {off_ms[int(len(off_ms) * 0.99)]:.2f} at 99 %, {off_ms[-1]:.2f} at most")
            assert [number for _, number in looks] == list(range(LOOKS)), f"{len(looks)} of {LOOKS} looks"
            assert all(len(slots) == 512 for _, slots in packets)


def slot_counts(work):
    for protocol in ("sacn", "artnet"):
        packets = play(show(work, 40, 64, looks=20), protocol=protocol)
        assert {len(slots) for _, slots in packets} == {64}, {len(slots) for _, slots in packets}
    print("ok: 64 slots stay 64")


def rests_and_faster(work):
    packets = play(show(work, 4000, 16, looks=2), "--rate", 20)
    assert 60 <= len(packets) <= 90, len(packets)
    print(f"ok: {len(packets)} packets in 4 s of rest at 20 Hz")
    packets = play(show(work, 20, 16), "--speed", 10)
    assert looks_of(packets)[-1][1] == LOOKS - 1 and len(packets) < 40, len(packets)
    print(f"ok: {len(packets)} packets of 301 looks in 0.6 s, the last look among them")


def main():
    if not os.access(GHOSTLIGHT, os.X_OK):
        print("skipped:", GHOSTLIGHT, "is not built")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        every_look(work)
        slot_counts(work)
        rests_and_faster(work)


if __name__ == "__main__":
    main()

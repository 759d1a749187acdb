# SPDX-License-Identifier: Apache-2.0
"""A desk for soak_test.py, in a namespace of its own: so many universes of sACN 44 times a second, the first by multicast, the others to
one address. Arguments: our address, theirs, universes. Every channel is a slow sine of its own phase; what cannot be sent (no cable) is left
out. Each second it prints how many packets went out so far."""
import math
import socket
import struct
import sys
import time

RATE_HZ = 44
SEQUENCE, LEVELS = 111, 126  # places in a packet


def packet(universe):
    def layer(offset):
        return struct.pack(">H", 0x7000 | (638 - offset))

    head = struct.pack(">HH", 0x10, 0) + b"ASC-E1.17\0\0\0" + layer(16) + struct.pack(">I", 4) + b"GhostlightSoak01" + layer(38) + struct.pack(">I", 2)
    head += b"Soak desk".ljust(64, b"\0") + bytes([100, 0, 0, 0, 0]) + struct.pack(">H", universe) + layer(115) + bytes([2, 0xA1, 0, 0, 0, 1, 2, 1, 0])
    assert len(head) == LEVELS
    return bytearray(head + bytes(512))


def main():
    ours, theirs, count = sys.argv[1], sys.argv[2], int(sys.argv[3])
    out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(ours))
    out.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 1 << 22)
    packets = [(packet(universe), ("239.255.0.1" if universe == 1 else theirs, 5568)) for universe in range(1, count + 1)]
    waves = [bytes(int(127.5 + 127.5 * math.sin(0.05 * tick + 0.13 * channel)) for channel in range(512)) for tick in range(126)]
    sent, next_s, said_s = 0, time.monotonic(), 0.0
    for tick in range(1 << 40):
        levels = waves[tick % len(waves)]
        for one, to in packets:
            one[SEQUENCE] = tick & 255
            one[LEVELS:] = levels
            try:
                out.sendto(one, to)
                sent += 1
            except OSError:
                break  # no cable: the rest of this round has none either
        now_s = time.monotonic()
        if now_s - said_s > 1:
            print(sent, flush=True)
            said_s = now_s
        next_s = max(next_s + 1 / RATE_HZ, now_s - 0.1)  # late ones go on from there, as real desks do
        time.sleep(max(next_s - time.monotonic(), 0))


if __name__ == "__main__":
    main()

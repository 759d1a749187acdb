#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`ghostlight play` as tshark sees it (Debian package tshark): a desk of 50 Hz, and one of 64 slots, by sACN and Art-Net in a network
namespace. Every look is sent, in order and in time, with numbers without a gap and the slots that were recorded. Prints the table of
docs/measurements/performance.md. Arguments: source folder, build folder. Exit 77: skipped."""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "lib"))
import needs  # noqa: E402

GHOSTLIGHT = str(pathlib.Path(sys.argv[2]).resolve() / "ghostlight")
WIRE = f"gl_w{os.getpid()}"
INTERVAL_MS, LOOKS = 20, 301
MOST_OFF_MS = 1  # in the median, on a machine that does other things, too; the worst that was measured stands in the docs
FIELDS = {
    "sacn": ["acn.dmx.seq_number", "acn.dmx.count", "acn.dmx.option_s"],
    "artnet": ["artnet.output.sequence", "artnet.output.length", "artnet.output.universe"],
}


def inside(*words):
    return ["ip", "netns", "exec", WIRE, *map(str, words)]


def write_show(work, slots):
    """An OLA show file: looks that count in slots 1 and 2."""
    frames = [f"1 {','.join(map(str, [look >> 8, look & 255] + [9] * (slots - 2)))}\n{INTERVAL_MS}" for look in range(LOOKS)]
    path = work / f"{slots}.show"
    path.write_text("OLA Show\n" + "\n".join(frames) + "\n")
    return path


def capture(work, protocol, slots):
    """What tshark reads of each packet of levels: (seconds, number, slots, the two bytes of the look)."""
    file = work / f"{protocol}-{slots}.pcapng"
    port = 5568 if protocol == "sacn" else 6454
    with (work / "tshark.txt").open("w") as log:
        tshark = subprocess.Popen(inside("tshark", "-q", "-i", "lo", "-f", f"udp port {port}", "-w", file), stderr=log, stdout=log)
    end = time.monotonic() + 30
    while "Capturing on" not in (work / "tshark.txt").read_text() or not file.exists():
        assert tshark.poll() is None and time.monotonic() < end, (work / "tshark.txt").read_text()
        time.sleep(0.1)
    subprocess.run(inside(GHOSTLIGHT, "play", write_show(work, slots), "--protocol", protocol, "--to", "127.0.0.1", "--quiet"), check=True, timeout=60)
    time.sleep(1)  # what is in its buffer
    tshark.terminate()
    tshark.wait(20)
    wanted = [word for field in ["frame.time_epoch", *FIELDS[protocol], "udp.payload"] for word in ("-e", field)]
    text = subprocess.run(["tshark", "-r", str(file), "--enable-protocol", "acn", "--enable-heuristic", "acn", "-o", "acn.dmx_enable:TRUE", "-T", "fields", *wanted], capture_output=True, text=True, check=True,
                          timeout=60).stdout
    packets = []
    for line in text.splitlines():
        seconds, number, count, last, payload = line.split("\t")
        begin = 126 if protocol == "sacn" else 18
        if not number or (protocol == "sacn" and last in ("1", "True")):
            continue  # a poll, or a goodbye
        slots_sent = int(count, 0) - (1 if protocol == "sacn" else 0)  # sACN counts the start code
        packets.append((float(seconds), int(number, 0), slots_sent, bytes.fromhex(payload[2 * begin:2 * begin + 4])))
    return packets


def row(work, protocol, slots):
    packets = capture(work, protocol, slots)
    looks = []
    for seconds, _, _, look in packets:
        number = look[0] << 8 | look[1]
        if not looks or looks[-1][1] != number:
            looks.append((seconds, number))
    assert [number for _, number in looks] == list(range(LOOKS)), f"{len(looks)} of {LOOKS} looks: {[number for _, number in looks][:20]}"
    counts = {count for _, _, count, _ in packets}
    assert counts == {slots}, counts
    numbers = [number for _, number, _, _ in packets]
    one_more = (lambda n: (n + 1) % 256) if protocol == "sacn" else (lambda n: n % 255 + 1)
    gaps = sum(b != one_more(a) for a, b in zip(numbers, numbers[1:]))
    assert gaps == 0, f"{gaps} gaps in the numbers"
    times_ms = [seconds * 1000 - number * INTERVAL_MS for seconds, number in looks]
    middle = sorted(times_ms)[len(times_ms) // 2]  # the clock of the recording began there
    off_ms = sorted(abs(one - middle) for one in times_ms)
    figures = [off_ms[len(off_ms) // 2], off_ms[int(len(off_ms) * 0.99)], off_ms[-1]]
    print(f"| {'sACN' if protocol == 'sacn' else 'Art-Net'}, {slots} slots, a look every {INTERVAL_MS} ms | {len(looks)} of {LOOKS} | {len(packets)} | "
          f"{', '.join(map(str, counts))} | {gaps} | {figures[0]:.2f} | {figures[1]:.2f} | {figures[2]:.2f} |")
    assert figures[0] < MOST_OFF_MS, f"{figures[0]:.2f} ms off in the median"


def main():
    if os.geteuid() != 0:
        needs.skip("needs root for a network namespace")
    needs.packages("tshark", "iproute2")
    if not os.access(GHOSTLIGHT, os.X_OK):
        needs.skip(f"{GHOSTLIGHT} is not built")
    try:
        subprocess.run(["ip", "netns", "add", WIRE], check=True, capture_output=True)
        subprocess.run(["ip", "-n", WIRE, "link", "set", "lo", "up"], check=True, capture_output=True)
    except subprocess.CalledProcessError as error:
        subprocess.run(["ip", "netns", "del", WIRE], capture_output=True)
        needs.skip(f"no network namespaces here: {error}")
    try:
        print("| desk | looks sent | packets | slots | gaps in the numbers | off its time, ms: median | 99 % | most |\n|---|---|---|---|---|---|---|---|")
        with tempfile.TemporaryDirectory() as folder:
            work = pathlib.Path(folder)
            work.chmod(0o777)
            for protocol, slots in (("sacn", 512), ("artnet", 512), ("sacn", 64)):
                row(work, protocol, slots)
    finally:
        subprocess.run(["ip", "netns", "del", WIRE], capture_output=True)


if __name__ == "__main__":
    main()

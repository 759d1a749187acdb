#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The receiver on networks that change: interfaces that come, go and come again, two of ours on one net, a program that was stopped,
and what is shown when the desk is gone. In network namespaces of its own (root); the "desk" is a few lines of Python.

Arguments: source folder, build folder; then, if wanted, a number: only the stopped program, so often. GHOST_PAUSE_S: for how long.
Exit 77: skipped, with the reason."""
import bisect
import json
import os
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from lib import needs

SOURCE = Path(sys.argv[1]).resolve()
GHOSTLIGHT = str(Path(sys.argv[2]) / "ghostlight")
PAUSE_S = float(os.environ.get("GHOST_PAUSE_S", "4"))
GROUP_BUFFER_PACKETS = 6600  # of 638 bytes have room in a socket for multicast
AT_ONCE_S = 1.0  # the past is gone
SLACK_S = 1.0  # for a desk and a receiver on a machine that does other things, too
DESK, VIS = f"gl_d{os.getpid()}", f"gl_v{os.getpid()}"
CID = bytes(range(16))

# Runs in the desk's namespace: levels that count, 40 Hz, to where it is told.
SENDER = r'''
import socket, struct, sys, time
to, interface, universe = sys.argv[1], sys.argv[2], int(sys.argv[3])
if ":" in to:
    out = socket.socket(socket.AF_INET6, socket.SOCK_DGRAM)
    out.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_MULTICAST_IF, socket.if_nametoindex(interface))
else:
    out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))
cid = bytes(range(16))
start = time.monotonic()
count = 0
while True:
    slots = struct.pack(">I", int(time.monotonic() * 100) & 0xFFFFFFFF)
    size = 126 + len(slots)
    def layer(offset): return struct.pack(">H", 0x7000 | (size - offset))
    packet = struct.pack(">HH", 0x10, 0) + b"ASC-E1.17\0\0\0" + layer(16) + struct.pack(">I", 4) + cid
    packet += layer(38) + struct.pack(">I", 2) + b"Test desk".ljust(64, b"\0") + bytes([100, 0, 0, count & 255, 0])
    packet += struct.pack(">H", universe) + layer(115) + bytes([2, 0xA1, 0, 0, 0, 1]) + struct.pack(">H", 1 + len(slots)) + b"\0" + slots
    try:
        out.sendto(packet, (to, 5568))
    except OSError:
        pass
    count += 1
    time.sleep(max(0.0, start + count / 40 - time.monotonic()))
'''

# The same, 512 slots to many universes in one burst. Levels: milliseconds since a time; the list gets those of each burst that is out.
MANY = r'''
import socket, struct, sys, time
interface, base, hertz, path, universes = sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), sys.argv[4], list(map(int, sys.argv[5:]))
out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))
def layer(offset): return struct.pack(">H", 0x7000 | (638 - offset))
head = struct.pack(">HH", 0x10, 0) + b"ASC-E1.17\0\0\0" + layer(16) + struct.pack(">I", 4) + bytes(range(1, 17))
head += layer(38) + struct.pack(">I", 2) + b"Busy desk".ljust(64, b"\0") + bytes([100, 0, 0])
tail = layer(115) + bytes([2, 0xA1, 0, 0, 0, 1]) + struct.pack(">H", 513) + b"\0"
sent, count, next = open(path, "w"), 0, time.time()
while True:
    stamp = int((time.time() - base) * 1000)
    slots = struct.pack(">I", stamp).ljust(512, b"\0")
    for universe in universes:
        out.sendto(head + bytes([count & 255, 0]) + struct.pack(">H", universe) + tail + slots, (f"239.255.{universe >> 8}.{universe & 255}", 5568))
    print(stamp, file=sent, flush=True)
    count += 1
    next = max(next + 1 / hertz, time.time() - 1)
    time.sleep(max(0.0, next - time.time()))
'''


def ip(*words, check=True):
    return subprocess.run(["ip", *words], check=check, capture_output=True, text=True, timeout=20)


def inside(namespace, *words):
    return ["ip", "netns", "exec", namespace, *words]


class Monitor:
    """ghostlight monitor --json, read line by line."""

    def __init__(self, folder, *options):
        self.path = Path(folder) / f"monitor{time.monotonic_ns()}.jsonl"
        self.process = subprocess.Popen(
            inside(VIS, GHOSTLIGHT, "monitor", "--json", "--levels", "--every", "0.1", "--quiet", *options),
            stdout=self.path.open("w"), preexec_fn=os.setsid)

    def reports(self):
        return [json.loads(line) for line in self.path.read_text().split("\n")[:-1]]

    def wait(self, what, condition, limit_s=30):
        end = time.monotonic() + limit_s
        last = None
        while time.monotonic() < end:
            found = self.reports()
            last = found[-1] if found else None
            if last and condition(last):
                print("ok:", what)
                return last
            time.sleep(0.1)
        print(json.dumps(last)[:3000])
        raise AssertionError(what)

    def pid(self):
        """Of ghostlight itself: ip replaced itself by it."""
        return self.process.pid

    def stop(self):
        self.process.terminate()
        self.process.wait(20)


def universe(report, number=1):
    return next((u for u in report["universes"] if u["universe"] == number), None)


def is_lost(report, number=1):
    """Also where a report leaves the universe out."""
    found = universe(report, number)
    return found is None or found["lost"]


def stamp(report, number=1):
    """Hundredths of seconds that the newest look carries."""
    found = universe(report, number)
    return struct.unpack(">I", bytes(found["levels"][:4]))[0] if found else 0


def received(report):
    return sum(source["packets"] for source in report["sources"])


def add_link(name, address):
    """A cable from the bridge of the desk to a network card of ours."""
    ip("link", "add", f"p{name}{os.getpid()}", "type", "veth", "peer", "name", f"q{name}{os.getpid()}")
    ip("link", "set", f"p{name}{os.getpid()}", "netns", DESK)
    ip("link", "set", f"q{name}{os.getpid()}", "netns", VIS)
    ip("-n", DESK, "link", "set", f"p{name}{os.getpid()}", "name", f"to_{name}")
    ip("-n", VIS, "link", "set", f"q{name}{os.getpid()}", "name", name)
    ip("-n", DESK, "link", "set", f"to_{name}", "master", "br0", "up")
    subprocess.run(inside(VIS, "sysctl", "-qw", f"net.ipv4.conf.{name}.rp_filter=0"), check=True)
    ip("-n", VIS, "addr", "add", f"{address}/24", "brd", "10.93.0.255", "dev", name)
    ip("-n", VIS, "link", "set", name, "up")


def set_up():
    for namespace in (DESK, VIS):
        ip("netns", "add", namespace)
        ip("-n", namespace, "link", "set", "lo", "up")
    ip("-n", DESK, "link", "add", "br0", "type", "bridge", "mcast_snooping", "0")
    ip("-n", DESK, "addr", "add", "10.93.0.1/24", "brd", "10.93.0.255", "dev", "br0")
    ip("-n", DESK, "link", "set", "br0", "up")
    subprocess.run(inside(VIS, "sysctl", "-qw", "net.ipv4.conf.all.rp_filter=0"), check=True, stderr=subprocess.PIPE, text=True)


def links_come_and_go(folder):
    monitor = Monitor(folder, "--universes", "1-3")
    try:
        monitor.wait("it runs without a network", lambda r: True)
        add_link("net0", "10.93.0.2")
        monitor.wait("an interface that came later is joined", lambda r: received(r) > 20)
        before = received(monitor.reports()[-1])
        ip("-n", VIS, "link", "del", "net0")
        monitor.wait("its loss is seen", lambda r: is_lost(r) and any("net0: gone" in c["text"] for c in r["network"]["links"]))
        add_link("net0", "10.93.0.2")
        monitor.wait("an interface that came again is joined again", lambda r: received(r) > 20 and not is_lost(r))
        assert before > 0

        add_link("net1", "10.93.0.3")
        report = monitor.wait("two of ours on one net: every packet comes twice", lambda r: r["counters"]["other_way"] > 40)
        assert report["counters"]["out_of_sequence"] == 0, report["counters"]
        assert len([s for s in report["sources"] if s["universe"] == 1]) == 1, report["sources"]
        lost_before = report["counters"]["sources_lost"]
        used = next(s for s in report["sources"])
        print("ok: its copies are dropped, source by way of", used["from"])
        newest = stamp(report)
        ip("-n", VIS, "link", "set", "net0", "down")
        report = monitor.wait("the other takes over", lambda r: stamp(r) > newest + 300)
        assert report["counters"]["sources_lost"] == lost_before, "it was never lost"
        assert not universe(report)["lost"]
    finally:
        monitor.stop()


def ipv6(folder):
    desk = subprocess.Popen(inside(DESK, sys.executable, "-c", SENDER, "ff18::8300:2", "br0", "2"))
    monitor = Monitor(folder, "--universes", "1-3")
    try:
        report = monitor.wait("sACN by IPv6 multicast", lambda r: any(s["universe"] == 2 and s["packets"] > 20 for s in r["sources"]))
        source = next(s for s in report["sources"] if s["universe"] == 2)
        assert source["from"].startswith("fe80::") and not source["wrong_group"], source
        assert report["counters"]["out_of_sequence"] == 0
    finally:
        desk.kill()
        monitor.stop()


def stopped_program(folder):
    """After the program was stopped the present is shown, not the backlog, and nothing is taken for lost: with one universe, all of
    whose packets found room to wait, and with twenty at a rate that fills the buffer of their socket, so that the newest were lost.
    A look shown afterwards is that from before the stop, or the newest that the desk had sent, which is told by its own list."""
    base = time.time()
    for numbers, hertz in (([11], 40), (list(range(20, 40)), 150)):
        sent = Path(folder) / f"sent{numbers[0]}"
        desk = subprocess.Popen(inside(DESK, sys.executable, "-c", MANY, "10.93.0.1", str(base), str(hertz), str(sent), *map(str, numbers)))
        monitor = Monitor(folder, "--universes", f"{numbers[0]}-{numbers[-1]}", "--on-loss", "black", "--interface", "net1")

        def refreshes():
            return [int(line) for line in sent.read_text().split("\n")[:-1]]

        try:
            monitor.wait(f"levels of {len(numbers)} universes arrive", lambda r: all(stamp(r, n) > 0 for n in numbers))
            stopped, count = time.time() + 0.05, len(refreshes())
            os.kill(monitor.pid(), signal.SIGSTOP)
            time.sleep(0.3)
            seen = len(monitor.reports())
            enough = 1.5 * GROUP_BUFFER_PACKETS / len(numbers) if len(numbers) > 1 else 0
            while time.time() < stopped + PAUSE_S or len(refreshes()) - count < enough:
                time.sleep(0.1)
                assert time.time() < stopped + PAUSE_S + 60, "the desk is too slow"
            resumed = time.time()
            os.kill(monitor.pid(), signal.SIGCONT)
            monitor.wait("after it went on: the present",
                         lambda r: r["counters"]["pauses"] > 0 and all(stamp(r, n) > (resumed - base) * 1000 for n in numbers))
            reports = monitor.reports()[seen:]
            overflow = reports[-1]["counters"]["kernel_overflow"]
            print(f"   stopped for {resumed - stopped:.1f} s; {overflow} packets found no room")
            assert (overflow > 0) == (len(numbers) > 1), "the case that was meant"
            out, last_past, first_present = refreshes(), None, None
            for report in reports:
                after = report["time"] - resumed
                newest = bisect.bisect_left(out, (report["time"] - base - SLACK_S) * 1000)
                for n in numbers:
                    shown = stamp(report, n)
                    if shown <= (stopped - base) * 1000:
                        last_past = after
                        assert after < AT_ONCE_S, f"universe {n} shows the look from before the stop {after:.2f} s after going on"
                    else:
                        first_present = after if first_present is None else first_present
                        assert shown >= out[newest - 1], f"universe {n} shows a look of {resumed - base - shown / 1000:.2f} s before it went on"
            text = lambda s: "never" if s is None else f"{s:.3f} s after going on"
            print(f"   the look from before the stop shown last: {text(last_past)}; the present first: {text(first_present)}")
            assert not any(universe(r, n)["lost"] or universe(r, n)["black"] for r in reports for n in numbers), "our pause is no loss of the desk"
            assert reports[-1]["counters"]["sources_lost"] == 0
            assert reports[-1]["counters"]["pauses"] >= 1
        finally:
            desk.kill()
            desk.wait()
            monitor.stop()


def desk_dies(folder, desk):
    held, black, later = (Monitor(folder, "--universes", "1", *more) for more in ([], ["--on-loss", "black"], ["--on-loss", "2"]))
    try:
        for monitor in (held, black, later):
            monitor.wait("levels arrive", lambda r: stamp(r) > 0)
        desk.kill()
        desk.wait()
        held.wait("hold: the last look, marked lost", lambda r: universe(r)["lost"] and stamp(r) > 0 and not universe(r)["black"])
        black.wait("black: none", lambda r: universe(r)["lost"] and universe(r)["black"] and stamp(r) == 0)
        later.wait("2 seconds: held at first, then none", lambda r: universe(r)["black"] and stamp(r) == 0)
        assert any(universe(r)["lost"] and not universe(r)["black"] for r in later.reports() if universe(r))
    finally:
        for monitor in (held, black, later):
            monitor.stop()


def groups():
    """sACN universes whose multicast groups this machine of ours has joined, without that of universe discovery."""
    text = subprocess.run(inside(VIS, "cat", "/proc/net/igmp"), check=True, capture_output=True, text=True).stdout
    numbers = {int(word[2:4] + word[0:2], 16) for word in text.split() if len(word) == 8 and word.endswith("FFEF")}
    return sorted(numbers - {64214})


def window_follows_the_patch(folder):
    """The window joins the universes of the show that is open, and those asked for."""
    shows = Path(folder) / "shows"
    shutil.copytree(SOURCE / "assets", shows / "one")
    shutil.copytree(SOURCE / "assets", shows / "two")
    file = shows / "two/demo/show.toml"
    file.write_text(file.read_text().replace("universe = 1\n", "universe = 300\n"))
    path = str(Path(folder) / "socket")
    log = open(Path(folder) / "window.log", "w+")
    window = subprocess.Popen(inside(VIS, "env", "QT_QPA_PLATFORM=offscreen", f"XDG_RUNTIME_DIR={folder}", GHOSTLIGHT, "open", str(shows / "one/demo"),
                                     "--forget", "--socket", path, "--interface", "net1", "--universes", "7"), stdout=log, stderr=log)
    try:
        def wait(wanted):
            end = time.monotonic() + 300
            # While they are silent it listens wider, too.
            while not set(wanted) <= set(groups()):
                assert time.monotonic() < end and window.poll() is None, (groups(), Path(log.name).read_text())
                time.sleep(0.2)
            print("ok: joined", wanted)

        wait([1, 7])
        actions = socket.socket(socket.AF_UNIX)
        actions.connect(path)
        actions.sendall(f"open {shows}/two/demo\n".encode())
        wait([7, 300])
    finally:
        window.kill()
        window.wait()


def play_goes_on_without_a_network(folder):
    """What cannot be sent is counted and said once; when the link is back, so is the show: by multicast through an interface that
    was taken away and put back, and by unicast."""
    heard = r'''
import socket, struct, sys, time
inward = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
inward.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
inward.bind(("", 5568))
inward.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton("239.255.0.1") + socket.inet_aton("10.93.0.1"))
while True:
    inward.recv(2048)
    print(time.monotonic(), flush=True)
'''
    for name, where in (("multicast", ["--interface", "net1"]), ("unicast", ["--to", "10.93.0.1"])):
        log = Path(folder) / f"{name}.times"
        desk = subprocess.Popen(inside(DESK, sys.executable, "-c", heard), stdout=log.open("w"))
        play = subprocess.Popen(inside(VIS, GHOSTLIGHT, "play", str(SOURCE / "assets/demo/demo.show"), "--loop", "--json", *where),
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        try:
            def wait_for_packets(what, least):
                end = time.monotonic() + 30
                while len(log.read_text().split()) < least:
                    assert play.poll() is None, play.communicate()
                    assert time.monotonic() < end, what
                    time.sleep(0.1)

            wait_for_packets("packets before", 20)
            ip("-n", VIS, "link", "del", "net1")
            time.sleep(2.5)
            assert play.poll() is None, play.communicate()
            before = len(log.read_text().split())
            add_link("net1", "10.93.0.3")
            wait_for_packets("packets after", before + 40)
            play.send_signal(signal.SIGINT)
            out, said = play.communicate(timeout=30)
            assert play.returncode == 0, said
            report = json.loads(out)
            assert report["not_sent"] >= 40 and report["packets"] > before, report
            assert said.count("it goes on, and sends again") == 1 and said.count("the network is back;") == 1, said
            print(f"ok: play by {name} outlives its link: {report['not_sent']} packets not sent, {report['packets']} sent")
            print("   " + next(line for line in said.splitlines() if "it goes on" in line))
        finally:
            for process in (desk, play):
                process.kill()
                process.wait()


def main():
    if os.geteuid() != 0:
        needs.skip("needs root for network namespaces")
    needs.packages("iproute2")
    if not os.access(GHOSTLIGHT, os.X_OK):
        needs.skip(GHOSTLIGHT + " is not built")
    desk = None
    try:
        try:
            set_up()
        except subprocess.CalledProcessError as error:
            needs.skip("no network namespaces or bridges here: " + error.stderr.strip())
        if len(sys.argv) > 3:
            add_link("net1", "10.93.0.3")
            for run in range(int(sys.argv[3])):
                with tempfile.TemporaryDirectory() as folder:
                    stopped_program(folder)
                print(f"run {run + 1} holds", flush=True)
            return
        desk = subprocess.Popen(inside(DESK, sys.executable, "-c", SENDER, "239.255.0.1", "10.93.0.1", "1"))
        with tempfile.TemporaryDirectory() as folder:
            links_come_and_go(folder)
            if Path("/proc/net/if_inet6").exists():
                ipv6(folder)
            else:
                print("IPv6 left out: this kernel has none")
            stopped_program(folder)
            desk_dies(folder, desk)
            window_follows_the_patch(folder)
            play_goes_on_without_a_network(folder)
    finally:
        if desk and desk.poll() is None:
            desk.kill()
        for namespace in (DESK, VIS):
            ip("netns", "del", namespace, check=False)


if __name__ == "__main__":
    main()

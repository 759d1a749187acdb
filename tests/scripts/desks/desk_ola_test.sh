#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# OLA (Debian packages ola, iproute2) as the lighting desk, in a network namespace of its own, drives our receiver in another:
# sACN by multicast, Art-Net by unicast after OLA has seen our ArtPollReply. Arguments: source folder, build folder.
set -u
. "$1/tests/scripts/lib/desk.sh"
desk_test "ola, iproute2, util-linux" olad ola_patch ola_set_dmx ola_streaming_client ip setpriv

conf=$work/ola
mkdir "$conf"
for plugin in dummy espnet ftdidmx gpio karate kinet milinst nanoleaf opendmx openpixelcontrol osc pathport renard sandnet \
    shownet spi stageprofi uartdmx usbdmx usbserial; do
    echo "enabled = false" >"$conf/ola-$plugin.conf"
done
printf 'cid = 00010203-0405-0607-0809-0a0b0c0d0e0f\ndraft_discovery = false\ndscp = 0\nenabled = true\nignore_preview = true
input_ports = 4\nip = 127.1.0.1\noutput_ports = 4\nprepend_hostname = false\nrevision = 0.46\n' >"$conf/ola-e131.conf"
printf 'always_broadcast = false\nenabled = true\nip = 127.1.0.1\nlong_name = OLA\nnet = 0\noutput_ports = 4\nshort_name = OLA
subnet = 0\nuse_limited_broadcast = false\nuse_loopback = false\n' >"$conf/ola-artnet.conf"
user=nobody
id olad >/dev/null 2>&1 && user=olad
chmod 755 "$work"
chown -R $user "$conf"
desk() { timeout 20 ip netns exec $DESK "$@"; }

ip netns exec $VIS "$ghostlight" monitor --interface net0 --universes 1-4 --json --levels --every 0.5 --quiet \
    >"$work/monitor.jsonl" &
pids=$!
ip netns exec $DESK setpriv --reuid=$user --regid=nogroup --clear-groups olad --no-http --no-register-with-dns-sd -l 2 -c "$conf" \
    >"$work/olad.log" 2>&1 &
pids="$pids $!"
up=no
for i in $(seq 40); do
    timeout 10 ip netns exec $DESK ola_dev_info >"$work/devices" 2>/dev/null && grep -q E1.31 "$work/devices" && grep -q ArtNet "$work/devices" && up=yes && break
    sleep 0.25
done
[ $up = yes ] || { cat "$work/olad.log"; fail "olad did not come up"; }
sacn=$(sed -n 's/^Device \([0-9]*\).*E1.31.*/\1/p' "$work/devices")
artnet=$(sed -n 's/^Device \([0-9]*\).*ArtNet.*/\1/p' "$work/devices")
desk ola_patch -d $sacn -p 0 -u 1 || fail "ola_patch sACN"
desk ola_patch -d $artnet -p 0 -u 2 || fail "ola_patch Art-Net"

# last FILTER: value of a Python expression over the newest report r; u(n) is universe n, s(n) its sources
last() {
    timeout 10 /usr/bin/python3 - "$work/monitor.jsonl" "$1" <<'P'
import json, sys
lines = [l for l in open(sys.argv[1]) if l.endswith('\n')]
r = json.loads(lines[-1]) if lines else {'universes': [], 'sources': [], 'counters': {}}
u = lambda n: next((x for x in r['universes'] if x['universe'] == n), {'levels': [], 'lost': None})
s = lambda n: [x for x in r['sources'] if x['universe'] == n]
print(eval(sys.argv[2]))
P
}
# Waits up to 25 s (OLA polls every 10 s) for the expression to become true. $3: sent again each time, because OLA sends a
# look once and a single packet may fall into the time before we had joined.
expect() {
    for i in $(seq 50); do
        [ -z "${3:-}" ] || $3
        [ "$(last "$2")" = True ] && { echo "ok: $1"; return; }
        sleep 0.5
    done
    tail -1 "$work/monitor.jsonl" | cut -c1-3000
    fail "$1"
}
looks() {
    desk ola_set_dmx -u 1 -d 10,20,30,255 >/dev/null
    desk ola_set_dmx -u 2 -d 1,0,99 >/dev/null
}
expect "sACN multicast: OLA universe 1 is our universe 1" "u(1)['levels'][:5] == [10, 20, 30, 255, 0]" looks
expect "Art-Net unicast: OLA universe 2 sends Port-Address 2, our universe 3" "u(3)['levels'][:4] == [1, 0, 99, 0]" looks
expect "our poll replies were asked for and sent" "r['counters']['notices']['poll'] >= 1 and r['counters']['poll_replies_sent'] >= 4"
lists_us() { desk ola_artnet -d $artnet -u 2 | grep -q '^127\.1\.0\.2'; }
lists_us || fail "ola_artnet does not list us: $(desk ola_artnet -d $artnet -u 2)"
echo "ok: ola_artnet lists us"
expect "both sources are listed" "s(1)[0]['protocol'] == 'sACN' and s(1)[0]['id'] == '000102030405060708090a0b0c0d0e0f' and s(3)[0]['from'] == '127.1.0.1'"
expect "nothing was missed or misread" "r['counters']['missed'] == 0 and sum(r['counters']['drops'].values()) == 0"
desk ola_patch -r -d $sacn -p 0 -u 1
expect "terminated: the last look is held and marked" "u(1)['lost'] is True and u(1)['levels'][:4] == [10, 20, 30, 255]"
kill ${pids%% *}
pids=${pids#* }

desk ola_patch -d $sacn -p 0 -u 1
# A chase of all 512 slots at 44 Hz: what leaves the desk's network card, packet by packet, against what is recorded, slot by slot.
ip netns exec $DESK /usr/bin/python3 - "$work/wire" <<'P' &
import socket, sys
wire = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(3))
wire.bind(("net0", 0))
with open(sys.argv[1], "w") as out:
    while True:
        frame = wire.recv(2048)
        packet = frame[14 + (frame[14] & 15) * 4 + 8:]
        if frame[23] == 17 and packet[4:13] == b"ASC-E1.17" and packet[40:44] == b"\0\0\0\2" and packet[125:126] == b"\0":
            out.write(packet[126:].hex() + "\n")
            out.flush()
P
pids="$pids $!"
ip netns exec $VIS "$ghostlight" record -o "$work/chase.show" --interface net0 --protocols sacn --universes 1 --seconds 6 --quiet &
pids="$pids $!"
recorder=$!
sleep 2
/usr/bin/python3 -c '
import sys, time
start = time.monotonic()
for i in range(44 * 9):
    print(",".join(str((i * 7 + slot * (1 + i % 5)) % 256) for slot in range(512)), flush=True)
    time.sleep(max(0.0, start + (i + 1) / 44 - time.monotonic()))' | desk ola_streaming_client -u 1 --priority 150 >/dev/null
wait $recorder || fail "record"
/usr/bin/python3 - "$work/chase.show" "$work/wire" <<'P' || fail "recorded slots"
import sys
lines = open(sys.argv[1]).read().splitlines()
assert lines[0] == 'OLA Show', lines[0]
recorded = [bytes(map(int, line.split(' ', 1)[1].split(','))) for line in lines[1:] if ' ' in line]
assert all(line.startswith('1 ') for line in lines[1:] if ' ' in line)
sent = [bytes.fromhex(line) for line in open(sys.argv[2]).read().split('\n')[:-1]]
def changes(looks):
    return [look for before, look in zip([None] + looks, looks) if look != before]
recorded, sent = changes(recorded), changes(sent)
full = [look for look in recorded if len(look) == 512 and any(look)]
assert len(full) > 150, (len(recorded), len(full))
begin = sent.index(full[0])
assert full == sent[begin:begin + len(full)], next((i, a[:8].hex(), b[:8].hex()) for i, (a, b) in enumerate(zip(full, sent[begin:])) if a != b)
print('ok: %d looks of the chase recorded, each with the 512 slots that were sent, none left out' % len(full))
P

# More universes than bind indices: four ports share a reply, and OLA, which takes their ports one by one, goes on sending.
ip netns exec $VIS "$ghostlight" monitor --interface net0 --universes 1-300 --json --levels --every 0.5 --quiet >"$work/monitor.jsonl" &
pids="$pids $!"
expect "300 universes: Art-Net unicast arrives" "u(3)['levels'][:4] == [1, 0, 99, 0] and r['counters']['poll_replies_sent'] >= 76" looks
lists_us || fail "ola_artnet does not list us with 300 universes"
echo "ok: ola_artnet lists us, still"

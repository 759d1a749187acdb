#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Two real desks on one sACN universe: QLC+ with all 512 slots at priority 100, OLA with four at 150. OLA takes its four over and no
# others; when it dies (SIGKILL) they fall back to QLC+, and when that dies, too, the last look is held and marked. Never is anything
# else shown. (Debian packages ola, qlcplus, iproute2.) Arguments: source folder, build folder.
set -u
. "$1/tests/scripts/lib/desk.sh"
desk_test "ola, qlcplus, iproute2, util-linux" olad ola_patch ola_streaming_client qlcplus ip setpriv

conf=$work/ola
mkdir "$conf"
for plugin in artnet dummy espnet ftdidmx gpio karate kinet milinst nanoleaf opendmx openpixelcontrol osc pathport renard sandnet \
    shownet spi stageprofi uartdmx usbdmx usbserial; do
    echo "enabled = false" >"$conf/ola-$plugin.conf"
done
printf 'cid = 00010203-0405-0607-0809-0a0b0c0d0e0f\ndraft_discovery = false\ndscp = 0\nenabled = true\nignore_preview = true
input_ports = 4\nip = 127.1.0.1\noutput_ports = 4\nprepend_hostname = false\nrevision = 0.46\n' >"$conf/ola-e131.conf"
user=nobody
id olad >/dev/null 2>&1 && user=olad
chmod 755 "$work"
chown -R $user "$conf"

/usr/bin/python3 - "$work/test.qxw" <<'P'
import sys
look = ",".join("%d,%d" % (i, (7 * i + 40) % 200 + 1) for i in range(512))
open(sys.argv[1], "w").write(f'''<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE Workspace>
<Workspace xmlns="http://www.qlcplus.org/Workspace" CurrentWindow="VirtualConsole">
<Creator><Name>Q Light Controller Plus</Name><Version>4.12.6</Version><Author>test</Author></Creator>
<Engine Autostart="0"><InputOutputMap><Universe Name="U1" ID="0"><Output Plugin="E1.31" UID="127.1.0.1" Line="1">
<PluginParameters multicast="1" universe="1" priority="100" transmitMode="Full"/></Output></Universe></InputOutputMap>
<Fixture><Manufacturer>Generic</Manufacturer><Model>Generic</Model><Mode>Generic</Mode><ID>0</ID><Name>D</Name>
<Universe>0</Universe><Address>0</Address><Channels>512</Channels></Fixture>
<Function ID="0" Type="Scene" Name="A"><Speed FadeIn="0" FadeOut="0" Duration="0"/><FixtureVal ID="0">{look}</FixtureVal></Function>
</Engine>
</Workspace>
''')
P
ip netns exec $VIS "$ghostlight" monitor --interface net0 --universes 1 --json --levels --every 0.1 --quiet >"$work/monitor.jsonl" &
pids=$!
desk_qlc "$work/test.qxw"
ip netns exec $DESK setpriv --reuid=$user --regid=nogroup --clear-groups olad --no-http --no-register-with-dns-sd -l 2 -c "$conf" \
    >"$work/olad.log" 2>&1 &
ola=$!
pids="$pids $ola"

# expect WHAT EXPRESSION: waits until it is true of the newest report r; u is the universe, by a source's priority s.
expect() {
    for i in $(seq 60); do
        timeout 10 /usr/bin/python3 - "$work/monitor.jsonl" "$2" <<'P' && { echo "ok: $1"; return; }
import json, sys
lines = [line for line in open(sys.argv[1]) if line.endswith("\n")]
r = json.loads(lines[-1]) if lines else {"universes": [], "sources": []}
u = (r["universes"] + [{"levels": [], "lost": None}])[0]
s = {source["priority"]: source for source in r["sources"]}
qlc = [(7 * i + 40) % 200 + 1 for i in range(512)]
sys.exit(0 if eval(sys.argv[2]) else 1)
P
        sleep 0.5
    done
    tail -1 "$work/monitor.jsonl" | cut -c1-3000
    tail -3 "$work/qlcplus.log" "$work/olad.log"
    fail "$1"
}
expect "QLC+ alone: its 512 slots" "u['levels'] == qlc and s[100]['slots'] == 512"
for i in $(seq 40); do
    timeout 10 ip netns exec $DESK ola_patch -d 1 -p 0 -u 1 2>/dev/null && break
    sleep 0.25
done
/usr/bin/python3 -c '
import time
while True:
    print("250,251,0,253", flush=True)
    time.sleep(0.025)' | ip netns exec $DESK ola_streaming_client -u 1 --priority 150 >/dev/null 2>&1 &
pids="$pids $!"
expect "OLA at 150 takes four slots over, and no others" \
    "u['levels'] == [250, 251, 0, 253] + qlc[4:] and s[150]['slots_held'] == 4 and s[100]['slots_held'] == 508"
kill -KILL $ola
expect "OLA is lost: all is QLC+'s again" "u['levels'] == qlc and 150 not in s and not u['lost']"
kill $qlc
expect "QLC+ is lost, too: its look is held and marked" "u['lost'] and u['levels'] == qlc and not s"
/usr/bin/python3 - "$work/monitor.jsonl" <<'P' || fail "something else was shown"
import json, sys
qlc = [(7 * i + 40) % 200 + 1 for i in range(512)]
looks = []
for line in open(sys.argv[1]):
    universes = json.loads(line)["universes"] if line.endswith("\n") else []
    if universes and any(universes[0]["levels"]) and universes[0]["levels"] not in looks[-1:]:
        looks.append(universes[0]["levels"])
assert looks == [qlc, [250, 251, 0, 253] + qlc[4:], qlc], [look[:8] for look in looks]
print("ok: three looks in all, one after the other, and nothing between")
P

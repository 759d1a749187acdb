#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Rigs that travel as a new user tries them: a truss is put on two hoists in the window, patched, and flown from QLC+ (Debian package
# qlcplus), a lift from OLA (ola), a wagon by a PosiStageNet tracker, all in a network namespace of their own; then the mouse takes
# a hoist and gives it back. What is done and checked is in lib/desk_movers.py. Arguments: source folder, build folder [, folder for
# pictures].
set -u
. "$1/tests/scripts/lib/desk.sh"
needs python3-pil python3-numpy
desk_test "qlcplus, ola, iproute2, util-linux, xvfb, xdotool" qlcplus olad ola_patch ola_streaming_client ip setpriv Xvfb xdotool

# QLC+: the hoists at 128 and 64 of 255, in 16 bits; from the beginning on.
cat >"$work/test.qxw" <<'X'
<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE Workspace>
<Workspace xmlns="http://www.qlcplus.org/Workspace" CurrentWindow="VirtualConsole">
<Creator><Name>Q Light Controller Plus</Name><Version>4.12.6</Version><Author>test</Author></Creator>
<Engine Autostart="0">
<InputOutputMap><Universe Name="U1" ID="0"><Output Plugin="E1.31" UID="127.1.0.1" Line="1"><PluginParameters multicast="1" universe="9"/>
</Output></Universe></InputOutputMap>
<Fixture><Manufacturer>Generic</Manufacturer><Model>Generic</Model><Mode>Generic</Mode><ID>0</ID><Name>Hoists</Name><Universe>0</Universe>
<Address>0</Address><Channels>4</Channels></Fixture>
<Function ID="0" Type="Scene" Name="Half way"><Speed FadeIn="0" FadeOut="0" Duration="0"/><FixtureVal ID="0">0,128,2,64</FixtureVal></Function>
</Engine>
</Workspace>
X
ip netns exec $DESK env HOME="$work" XDG_RUNTIME_DIR="$work" QT_QPA_PLATFORM=offscreen \
    qlcplus --nowm --nogui --open "$work/test.qxw" --operate >"$work/qlcplus.log" 2>&1 &
pids=$!

# OLA: universe 8, the lift at 204 of 255.
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
ip netns exec $DESK setpriv --reuid=$user --regid=nogroup --clear-groups olad --no-http --no-register-with-dns-sd -l 2 -c "$conf" \
    >"$work/olad.log" 2>&1 &
pids="$pids $!"
up=no
for i in $(seq 40); do
    timeout 10 ip netns exec $DESK ola_dev_info >"$work/devices" 2>/dev/null && grep -q E1.31 "$work/devices" && up=yes && break
    sleep 0.25
done
[ $up = yes ] || { cat "$work/olad.log"; fail "olad did not come up"; }
ip netns exec $DESK timeout 20 ola_patch -d $(sed -n 's/^Device \([0-9]*\).*E1.31.*/\1/p' "$work/devices") -p 0 -u 8 || fail "ola_patch"
while :; do echo 204,204; sleep 0.2; done | ip netns exec $DESK ola_streaming_client -u 8 >/dev/null 2>&1 &
pids="$pids $!"

# A tracking system: tracker 7 stands 3 m along the wagon's way.
ip netns exec $DESK /usr/bin/python3 -c '
import socket, struct, time
chunk = lambda number, inside, has_chunks: struct.pack("<HH", number, len(inside) | (0x8000 if has_chunks else 0)) + inside
out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.1.0.1"))
frame = 0
while True:
    header = chunk(0, struct.pack("<QBBBB", frame * 50000, 2, 0, frame % 256, 1), False)
    tracker = chunk(7, chunk(0, struct.pack("<fff", -4.5, -3.0, 0.0), False), True)
    out.sendto(chunk(0x6755, header + chunk(1, tracker, True), True), ("236.10.10.10", 56565))
    frame += 1
    time.sleep(0.05)' &
pids="$pids $!"
ip netns exec $VIS /usr/bin/python3 -B "$source_dir/tests/scripts/lib/desk_movers.py" "$@" || { tail -5 "$work/qlcplus.log"; fail "the window"; }

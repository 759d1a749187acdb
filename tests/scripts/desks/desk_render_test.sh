#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# The whole chain: OLA (package ola), in a network namespace of its own, sends red and blue washes in turn by sACN multicast;
# `ghostlight render --live-input` in another draws the demo stage; the pictures must be red and blue. The demo's passes
# are baked when they are not there yet. Arguments: source folder, build folder.
set -u
. "$1/tests/scripts/lib/desk.sh"
needs python3-pil
desk_test "ola, iproute2, util-linux" olad ola_patch ola_streaming_client ip setpriv

"$ghostlight" render "$source_dir/assets/demo" -o "$work/baked.png" --view house --replay "$source_dir/assets/demo/demo.show" \
    --at 0 --quiet || fail "render of the recording"

conf=$work/ola
mkdir "$conf"
for plugin in artnet dummy espnet ftdidmx gpio karate kinet milinst nanoleaf opendmx openpixelcontrol osc pathport renard \
    sandnet shownet spi stageprofi uartdmx usbdmx usbserial; do
    echo "enabled = false" >"$conf/ola-$plugin.conf"
done
printf 'cid = 00010203-0405-0607-0809-0a0b0c0d0e0f\ndraft_discovery = false\ndscp = 0\nenabled = true\nignore_preview = true
input_ports = 4\nip = 127.1.0.1\noutput_ports = 4\nprepend_hostname = false\nrevision = 0.46\n' >"$conf/ola-e131.conf"
user=nobody
id olad >/dev/null 2>&1 && user=olad
chmod 755 "$work"
chown -R $user "$conf"
ip netns exec $DESK setpriv --reuid=$user --regid=nogroup --clear-groups olad --no-http --no-register-with-dns-sd -l 2 \
    -c "$conf" >"$work/olad.log" 2>&1 &
pids=$!
for i in $(seq 40); do
    timeout 10 ip netns exec $DESK ola_dev_info >"$work/devices" 2>/dev/null && grep -q E1.31 "$work/devices" && break
    sleep 0.25
done
device=$(sed -n 's/^Device \([0-9]*\).*E1.31.*/\1/p' "$work/devices")
[ -n "$device" ] || { cat "$work/olad.log"; fail "olad did not come up"; }
timeout 20 ip netns exec $DESK ola_patch -d $device -p 0 -u 1 || fail "ola_patch"

# Washes 1 to 3 on the cyclorama, two seconds red, two seconds blue, 40 frames a second; slot 500 counts, so each is sent.
cat >"$work/looks.py" <<'P'
import sys, time
sys.path[:0] = sys.argv[1:]
from desk_looks import red_and_blue
looks = [levels[:500] for levels in red_and_blue()]
for i in range(40 * 60):
    levels = looks[i // 80 % 2]
    levels[499] = i % 256
    print(','.join(map(str, levels)), flush=True)
    time.sleep(0.025)
P
/usr/bin/python3 -B "$work/looks.py" "$source_dir/tools/demo_show" "$source_dir/tests/scripts/lib" 2>/dev/null > >(exec ip netns exec $DESK ola_streaming_client -u 1 >/dev/null) &
pids="$pids $!"
mkdir "$work/film"
ip netns exec $VIS "$ghostlight" render "$source_dir/assets/demo" -o "$work/film/f.png" --view house --live-input --seconds 9 \
    --interface net0 --universes 1 --quiet --json >"$work/figures.json" || fail "render --live-input"
cat "$work/figures.json"
/usr/bin/python3 - "$work/film" "$work/figures.json" <<'P' || fail "colours of the film"
import glob, json, os, sys
from PIL import Image, ImageStat
names = sorted(glob.glob(sys.argv[1] + '/*.png'))
assert len(names) >= 10, len(names)
figures = json.load(open(sys.argv[2]))
assert figures['out'] == names[0], figures  # f.png itself is not there
assert figures['written'] == names[0] + ' to ' + os.path.basename(names[-1]), figures
colours = []
for name in names:
    picture = Image.open(name).convert('RGB')
    w, h = picture.size
    red, green, blue = ImageStat.Stat(picture.crop((w * 3 // 10, h // 4, w * 7 // 10, h * 3 // 5))).mean
    colours.append('red' if red > 40 and red > 2 * blue else 'blue' if blue > 40 and blue > 2 * red else 'other')
print(len(names), 'pictures:', {c: colours.count(c) for c in set(colours)})
assert colours.count('red') >= 3 and colours.count('blue') >= 3, colours
print('ok: the pictures follow the desk')
P

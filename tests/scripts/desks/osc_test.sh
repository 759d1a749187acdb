#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# A remote control of other people's making (oscsend, package liblo-tools) blacks the live picture out and brings it back.
# In a network namespace of its own, so that ports are free. Arguments: source folder, build folder.
set -u
. "$1/tests/scripts/lib/desk.sh"
needs python3-pil
desk_test "liblo-tools, iproute2" oscsend ip
vis() { ip netns exec $VIS "$@"; }

cp -r "$source_dir/assets/demo" "$work/demo"
cp -r "$source_dir/assets/fixtures" "$work/fixtures"
ip netns exec $VIS "$ghostlight" play "$work/demo/demo.show" --to 127.0.0.1 --loop --quiet &
pids=$!
# Blackout and light in turn, until the film is there.
(while :; do
    for value in 1 0; do
        vis oscsend osc.udp://127.0.0.1:9000 /ghostlight/blackout i $value
        sleep 3
    done
done) &
pids="$pids $!"
vis "$ghostlight" render "$work/demo" -o "$work/f.png" --live --no-shadows --view house --size 192x108 --live-input --osc 9000 \
    --seconds 24 --fps 2 --ev 4 --quiet || fail "render --osc"
/usr/bin/python3 - "$work" <<'P' || fail "light and dark in turn"
import glob, sys
from PIL import Image, ImageStat
means = [sum(ImageStat.Stat(Image.open(name).convert('RGB')).mean) for name in sorted(glob.glob(sys.argv[1] + '/*.png'))]
print([round(m) for m in means])
low, high = min(means), max(means)
assert high > 1.5 * low + 5, (low, high)
states = [m > 0.5 * (low + high) for m in means]
turns = sum(a != b for a, b in zip(states, states[1:]))
assert turns >= 2, turns
print('ok: light and dark change', turns, 'times')
P

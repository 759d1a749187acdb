#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Makes assets/demo/demo.qxw and demo.show anew: the workspace from its script, then 96 s of QLC+ 4.12 playing it headless
# in a network namespace of its own, recorded by `ghostlight record` in another.
#   tools/demo_show/record.sh BUILD_DIR        (root; needs qlcplus and iproute2)
set -eu
here=$(cd "$(dirname "$0")" && pwd)
demo=$(cd "$here/../../assets/demo" && pwd)
ghostlight=$(cd "$1" && pwd)/ghostlight
. "$here/desk_net.sh"

work=$(mktemp -d)
desk_pid= rec_pid=
cleanup() {
    [ -z "$desk_pid" ] || kill "$desk_pid" 2>/dev/null || true
    [ -z "$rec_pid" ] || kill "$rec_pid" 2>/dev/null || true
    sleep 0.5
    desk_net_down
    rm -rf "$work"
}
trap cleanup EXIT
desk_net_up || { echo "needs root and network namespaces" >&2; exit 1; }

/usr/bin/python3 "$here/make_workspace.py" "$demo/demo.qxw"
mkdir -p "$work/.qlcplus/fixtures"
cp "$demo/VL2500_Spot.qxf" "$work/.qlcplus/fixtures/"

ip netns exec $VIS "$ghostlight" record -o "$work/raw.show" --interface net0 --protocols sacn --universes 1 \
    --seconds 100 --wait 30 &
rec_pid=$!
sleep 1
ip netns exec $DESK env HOME="$work" XDG_RUNTIME_DIR="$work" QT_QPA_PLATFORM=offscreen \
    qlcplus --nowm --nogui --open "$demo/demo.qxw" --operate >"$work/qlcplus.log" 2>&1 &
desk_pid=$!
wait $rec_pid
rec_pid=
/usr/bin/python3 "$here/trim.py" "$work/raw.show" "$demo/demo.show" 96
ls -l "$demo/demo.show"

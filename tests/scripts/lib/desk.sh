# SPDX-License-Identifier: Apache-2.0
# For tests that put a lighting desk, or anything else that sends, into a network namespace of its own. Sourced with the
# test's own arguments (source folder, build folder). Sets source_dir, ghostlight, and by desk_test: work, a folder that goes
# at the end, the namespaces of tools/demo_show/desk_net.sh, and pids, which are killed at the end.
source_dir=$1
ghostlight=$2/ghostlight
skip() { echo "skipped: $1"; exit 77; }
needs() { /usr/bin/python3 "$source_dir/tests/scripts/lib/needs.py" "$@" || exit; }
fail() { echo "FAILED: $1"; exit 1; }

# desk_test PACKAGES TOOL...: skips where a tool is missing.
desk_test() {
    local packages=$1 tool
    shift
    [ "$(id -u)" = 0 ] || skip "needs root for network namespaces"
    for tool in "$@"; do
        command -v "$tool" >/dev/null || skip "$tool is not installed (packages $packages)"
    done
    [ -x "$ghostlight" ] || skip "$ghostlight is not built"
    . "$source_dir/tools/demo_show/desk_net.sh"
    work=$(mktemp -d)
    pids=
    trap desk_test_end EXIT
    desk_net_up || skip "no network namespaces or veth here"
}

# desk_qlc WORKSPACE: QLC+ plays it, headless, in the desk's namespace, until qlc is killed; its words go to $work/qlcplus.log.
# QLC+ 4.12 now and then dies of a segmentation fault while it starts: what a signal ended is started again, twice, and says so.
desk_qlc() {
    (
        trap 'kill -KILL $desk; exit' TERM
        for start in 1 2 3; do
            ip netns exec $DESK env HOME="$work" XDG_RUNTIME_DIR="$work" QT_QPA_PLATFORM=offscreen \
                qlcplus --nowm --nogui --open "$1" --operate &
            desk=$!
            wait $desk
            code=$?
            [ $code -gt 128 ] || exit $code
            echo "start $start of QLC+ was ended by signal $((code - 128))"
        done
    ) >"$work/qlcplus.log" 2>&1 &
    qlc=$!
    pids="$pids $qlc"
}

# desk_qlc_record WORKSPACE FILE SECONDS: records QLC+'s universes 1 and 2 from its first packet on; again where QLC+ died meanwhile.
# The summary is $work/summary.json.
desk_qlc_record() {
    local recorder take
    for take in 1 2 3; do
        rm -f "$2"
        ip netns exec $VIS "$ghostlight" record -o "$2" --interface net0 --universes 1-2 --seconds "$3" --wait 30 --json --quiet \
            >"$work/summary.json" &
        recorder=$!
        pids=$recorder
        sleep 0.5
        desk_qlc "$1"
        wait $recorder || { tail -5 "$work/qlcplus.log"; fail "record"; }
        grep "was ended by signal" "$work/qlcplus.log" || return 0
        kill $qlc
    done
    fail "QLC+ died in every take"
}

desk_test_end() {
    for pid in $pids; do kill $pid 2>/dev/null; done
    sleep 0.3
    desk_net_down
    rm -rf "$work"
}

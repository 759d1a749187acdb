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

desk_test_end() {
    for pid in $pids; do kill $pid 2>/dev/null; done
    sleep 0.3
    desk_net_down
    rm -rf "$work"
}

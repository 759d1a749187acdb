#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# OLA (Debian package ola) drives a DMX USB Pro; a DMX cable joins it to a second one, which our receiver reads. The widgets are
# tools/usb_pro_widget.py on pseudo-terminals. Slots as frames and as changes, noise on the line, the plug pulled and put back.
# Arguments: source folder, build folder.
set -u
. "$1/tests/scripts/lib/desk.sh"
[ "$(id -u)" = 0 ] || skip "needs root for network namespaces (OLA's own port)"
desk_test "ola, iproute2, util-linux" olad ola_patch ola_set_dmx ola_streaming_client ip setpriv
/usr/bin/python3 -c 'import os; os.openpty()' 2>/dev/null || skip "no pseudo-terminals here (/dev/pts)"

user=nobody
id olad >/dev/null 2>&1 && user=olad
conf=$work/ola
mkdir "$conf" "$work/dev"
for plugin in artnet dummy e131 espnet ftdidmx gpio karate kinet milinst nanoleaf opendmx openpixelcontrol osc pathport renard \
    sandnet shownet spi stageprofi uartdmx usbdmx; do
    echo "enabled = false" >"$conf/ola-$plugin.conf"
done
printf 'device_dir = %s\ndevice_prefix = ttyUSB\nenabled = true\npro_fps_limit = 190\ntri_use_raw_rdm = false\nultra_fps_limit = 40\n' \
    "$work/dev" >"$conf/ola-usbserial.conf"
chmod 755 "$work" "$work/dev"
chown -R $user "$conf"
setpriv --reuid=$user --regid=nogroup --clear-groups test -w /var/lock/ || skip "OLA cannot write its lock into /var/lock"
desk() { timeout 20 ip netns exec $DESK "$@"; }

# Our end is called otherwise than OLA's, which would take it as well.
ours=$work/dev/usb-ENTTEC_DMX_USB_PRO_EN000042-if00-port0
/usr/bin/python3 -B "$source_dir/tools/usb_pro_widget.py" "$work/dev/ttyUSB0" "$ours" >"$work/widget.log" 2>&1 &
widget=$!
pids=$widget
"$ghostlight" monitor --protocols none --usb "$ours=5" --json --levels --every 0.5 --quiet >"$work/monitor.jsonl" &
pids="$pids $!"
ip netns exec $DESK setpriv --reuid=$user --regid=nogroup --clear-groups olad --no-http --no-register-with-dns-sd -l 3 -c "$conf" \
    >"$work/olad.log" 2>&1 &
pids="$pids $!"
device=
for i in $(seq 60); do
    timeout 10 ip netns exec $DESK ola_dev_info >"$work/devices" 2>/dev/null
    device=$(sed -n 's/^Device \([0-9]*\).*Enttec Usb Pro.*12345678.*/\1/p' "$work/devices")
    [ -n "$device" ] && break
    sleep 0.25
done
[ -n "$device" ] || { cat "$work/olad.log" "$work/widget.log"; fail "OLA found no widget"; }
echo "ok: OLA takes it for a widget: $(grep "^Device $device" "$work/devices")"
desk ola_patch -d "$device" -p 0 -u 1 || fail "ola_patch"

# value of a Python expression over the newest report r; u is universe 5, p the port
last() {
    timeout 10 /usr/bin/python3 - "$work/monitor.jsonl" "$1" <<'P'
import json, sys
lines = [l for l in open(sys.argv[1]) if l.endswith('\n')]
r = json.loads(lines[-1]) if lines else {'universes': [], 'sources': [], 'usb': []}
u = next((x for x in r['universes'] if x['universe'] == 5), {'levels': [], 'lost': None})
p = r['usb'][0] if r['usb'] else {'state': None}
print(eval(sys.argv[2]))
P
}
expect() {
    for i in $(seq 50); do
        [ -z "${3:-}" ] || $3
        [ "$(last "$2")" = True ] && { echo "ok: $1"; return; }
        sleep 0.5
    done
    tail -1 "$work/monitor.jsonl" | cut -c1-3000
    fail "$1"
}
levels=$(/usr/bin/python3 -c 'print(",".join(str(i * 7 % 256) for i in range(512)))')
look() { desk ola_set_dmx -u 1 -d "$levels" >/dev/null; }
dark() { desk ola_set_dmx -u 1 -d 10,20,30,255 >/dev/null; }
all="u['levels'] == [i * 7 % 256 for i in range(512)] and u['lost'] is False"
expect "all 512 slots of OLA's universe 1 are our universe 5" "$all" look
expect "the widget told who it is" "p['state'] == 'ok' and p['serial'] == '00000042' and p['firmware'] == '1.44'"
expect "the source is listed" "r['sources'][0]['protocol'] == 'USB' and r['sources'][0]['rate_hz'] > 5"
expect "nothing was misread" "p['malformed'] == p['overruns'] == p['other_labels'] == 0"
kill -USR1 $widget
expect "pulled out: the last look is held and marked" "p['state'] == 'not open' and u['lost'] is True and u['levels'][511] == 511 * 7 % 256"
dark
kill -USR1 $widget
expect "put back: read again" "p['state'] == 'ok' and p['openings'] == 2 and u['lost'] is False and u['levels'][:5] == [10, 20, 30, 255, 0]" dark
kill -HUP $widget
sleep 1
expect "a noisy line is noticed, and shows nothing that nobody sent" "p['skipped_bytes'] > 1000 and u['levels'][:5] == [10, 20, 30, 255, 0]"
kill -HUP $widget
expect "after it the slots come again" "$all" look
kill -USR2 $widget
expect "changes only (label 9): the same slots" "u['levels'][:5] == [10, 20, 30, 255, 0]" dark
expect "changes only (label 9): and back" "$all" look

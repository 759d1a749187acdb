#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Tries what we give away as its user would: try_package.sh SUITE ROOT FILE makes a bare Debian in ROOT (as root), installs the .deb with what it
# depends on, or unpacks the bundle (.tar.zst) and installs nothing, and as an ordinary user draws a still, bakes, draws a film, opens the window
# under Xvfb; then removes it and looks for what it left. Says what took how long.
set -euo pipefail
suite=$1
root=$2
file=$3
bare=${DEBIAN_TAR:-$root.tar} # kept, so that the next try need not fetch it
[ "$(id -u)" = 0 ] || { echo "try_package.sh needs root: debootstrap and chroot" >&2; exit 1; }

rm -rf --one-file-system "$root"
mkdir -p "$root"
if [ -f "$bare" ]; then
    tar -xf "$bare" -C "$root"
else
    debootstrap --variant=minbase "$suite" "$root" ${DEBIAN_MIRROR:+"$DEBIAN_MIRROR"}
    tar -cf "$bare" -C "$root" .
fi
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
if [ -n "${http_proxy:-}" ]; then echo "Acquire::http::Proxy \"$http_proxy\";" >"$root/etc/apt/apt.conf.d/proxy"; fi
case $file in
*.deb) cp "$file" "$root/root/ghostlight.deb" ;;
*.tar.zst)
    mkdir -p "$root/home/guest"
    begun=$SECONDS
    zstd -dc "$file" | tar -xf - -C "$root/home/guest"
    echo "TRIED unpack: $((SECONDS - begun)) s, $(du -sm "$root/home/guest" | cut -f1) MB" >&2
    ;;
*)
    echo "try_package.sh: $file: expected a .deb or a .tar.zst" >&2
    exit 2
    ;;
esac
cat >"$root/root/try" <<'EOT'
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive LANG=C.UTF-8
clock() { local begun=$SECONDS; "${@:2}"; echo "TRIED $1: $((SECONDS - begun)) s" >&2; }
user() { setpriv --reuid 1000 --regid 1000 --clear-groups env -i HOME=/home/guest PATH=/usr/bin:/bin XDG_RUNTIME_DIR=/home/guest/run LANG=C.UTF-8 "$@"; }
apt-get -q update >/dev/null
before=$(dpkg -l | grep -c ^ii)
used=$(df -k --output=used / | tail -1)
if [ -f /root/ghostlight.deb ]; then
    clock install apt-get -q install -y --no-install-recommends /root/ghostlight.deb >/root/install.log
    grep -E '^Need to get|^After this' /root/install.log || true
    program=ghostlight
    demo=/usr/share/ghostlight/demo
else
    bundle=$(echo /home/guest/ghostlight-*)
    program=$bundle/bin/ghostlight
    demo=$bundle/share/ghostlight/demo
    chown -R 0:0 "$bundle" # read-only for its user
fi
echo "TRIED packages: $(($(dpkg -l | grep -c ^ii) - before)) new beside $before, $((($(df -k --output=used / | tail -1) - used) / 1024)) MB"
useradd -m guest 2>/dev/null || { echo guest:x:1000:1000::/home/guest:/bin/sh >>/etc/passwd; mkdir -p /home/guest; }
mkdir -p /home/guest/run && chmod 700 /home/guest/run && chown 1000:1000 /home/guest /home/guest/run
cd /home/guest
user "$program" --version
user "$program" check "$demo"
clock still user "$program" render "$demo" -o still.png --live --view close --size 320x180 --at 36 --quiet
clock bake user "$program" bake "$demo" --view house --spp 4 --quiet
clock film user "$program" render "$demo" -o film.mp4 --view house --from 16 --to 17 --fps 25 --quiet
ls -l still.png film.mp4
[ ! -e "$demo/.ghost" ] && ls .cache/ghostlight
user env QT_QPA_PLATFORM=offscreen timeout 15 "$program" open "$demo" --no-desk >window.log 2>&1 && exit 1 || [ $? = 124 ] # it stays
apt-get -q install -y --no-install-recommends xvfb xdotool >/dev/null
user Xvfb :7 -screen 0 1280x800x24 -fbdir /home/guest/run >/dev/null 2>&1 &
screen=$!
sleep 2
user env DISPLAY=:7 QT_QPA_PLATFORM=xcb "$program" open "$demo" >window.log 2>&1 &
window=$!
clock window user env DISPLAY=:7 xdotool search --sync --onlyvisible --name Ghostlight >/dev/null
sleep 15
kill -0 $window
cp /home/guest/run/Xvfb_screen0 /root/window.xwd # to look at
kill $window $screen
wait 2>/dev/null || true
if [ -f /root/ghostlight.deb ]; then
    clock removal apt-get -q purge -y ghostlight >/dev/null
else
    rm -r "$bundle"
fi
left=$(find / -xdev -iname '*ghostlight*' -not -path '/home/*' -not -path '/root/*' -not -path '/proc/*' -not -path '/var/log/*' -not -path '/var/cache/apt/*')
[ -z "$left" ] || { echo "left behind: $left" >&2; exit 1; }
echo "TRIED nothing is left"
EOT
unshare --mount --pid --fork bash -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    mount -t sysfs sys "$1/sys"
    exec chroot "$1" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root bash /root/try' try "$root"

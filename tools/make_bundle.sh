#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# A folder that runs on any Linux with this glibc or a newer one, nothing installed: make_bundle.sh BUILD OUT FILES makes
# OUT/ghostlight-VERSION-x86_64 of the program in BUILD, what tools/package_files.sh made into FILES, and this Debian's libraries. The same program, libraries and SOURCE_DATE_EPOCH give the same bytes.
#   bin/ghostlight      the launcher (packaging/bundle)      libexec/ghostlight  the program, its libraries by a path relative to it
#   lib/                libraries                            lib/fallback/NAME/  those that a system's drivers use, too: only where it lacks them
#   lib/lavapipe/       Mesa's driver for the processor      plugins/            Qt's
set -euo pipefail
export LC_ALL=C
build=$(readlink -f "$1")
files=$(readlink -f "$3")
here=$(readlink -f "$(dirname "$0")/..")
version=$("$build/ghostlight" --version | cut -d' ' -f2)
root=$2/ghostlight-$version-$(uname -m)
rm -rf "$root"
mkdir -p "$root"
root=$(readlink -f "$root")
system=/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || echo x86_64-linux-gnu)
qt=$system/qt6/plugins

cmake --install "$build" --component program --prefix "$root" >/dev/null
mkdir -p "$root"/{libexec,lib/fallback,lib/lavapipe,plugins,share/vulkan,share/fonts,share/translations,licences/common}
mv "$root/bin/ghostlight" "$root/libexec/"
rm -rf "$root/share/doc"
install -m 644 "$files/copyright" "$root/licences/ghostlight"
install -D -m 644 -t "$root/share/man/man1" "$files"/man1/*
install -D -m 644 "$files/ghostlight.bash" "$root/share/bash-completion/completions/ghostlight"
cp "$here/packaging/bundle/qt.conf" "$root/libexec/"
cp "$here/packaging/bundle/fonts.conf" "$root/share/fonts/"
cp /usr/share/fonts/truetype/dejavu/DejaVuSans{,-Bold,Mono}.ttf "$root/share/fonts/"
cp -r /usr/share/X11/xkb "$root/share/xkb" 2>/dev/null && rm -rf "$root/share/xkb/compiled"
cp /usr/share/qt6/translations/qtbase_de.qm "$root/share/translations/" 2>/dev/null || true
for plugin in platforms/libqxcb platforms/libqoffscreen platforms/libqminimal imageformats/libqjpeg imageformats/libqgif imageformats/libqico \
    platforminputcontexts/libcomposeplatforminputcontextplugin tls/libqopensslbackend tls/libqcertonlybackend; do
    install -D -m 644 "$qt/$plugin.so" "$root/plugins/$plugin.so"
done
# Where Debian's package of Qt for Wayland is installed.
for plugin in platforms/libqwayland-generic wayland-shell-integration/libxdg-shell wayland-decoration-client/libbradient; do
    [ ! -e "$qt/$plugin.so" ] || install -D -m 644 "$qt/$plugin.so" "$root/plugins/$plugin.so"
done

elf() { find "$root/libexec/ghostlight" "$root/lib" "$root/plugins" -type f \( -name '*.so*' -o -name ghostlight \) -print0; }
needs() { ldd "$@" | sed -n 's/.* => \(\/[^ ]*\) (0x.*/\1/p' | sort -u; }
missing=$(ldd "$root/libexec/ghostlight" "$root"/plugins/*/*.so | grep 'not found' || true)
[ -z "$missing" ] || { echo "make_bundle.sh: $missing" >&2; exit 1; }
driver=$system/libvulkan_lvp.so
of_program=$(needs "$root/libexec/ghostlight" "$root"/plugins/*/*.so)
of_driver=$(comm -13 <(echo "$of_program") <(needs "$driver"; echo "$driver"))
put() { # FOLDER FILE...
    local folder=$1 file name
    shift
    for file in "$@"; do
        name=${file##*/}
        case $name in
        # The system's, always: glibc is the one thing that must be there.
        ld-linux* | libc.so* | libm.so* | libmvec.so* | libpthread.so* | libdl.so* | librt.so* | libresolv.so* | libutil.so* | libanl.so*) ;;
        # What drivers of Vulkan, X and sound bring along or speak with.
        libstdc++.* | libgcc_s.* | libdrm*.so* | libexpat.* | libz.so* | libzstd.* | libffi.* | libedit.* | libtinfo.* | libz3.* | libxml2.* | \
            liblzma.* | libbsd.* | libmd.* | libX*.so* | libxcb*.so* | libxshmfence.* | libwayland-client.* | libEGL.* | libGLX.* | libOpenGL.* | \
            libGLdispatch.* | libasound.*)
            install -D -m 644 "$file" "$root/lib/fallback/$name/$name"
            ;;
        *) install -D -m 644 "$file" "$root/$folder/$name" ;;
        esac
    done
}
put lib $of_program
put lib/lavapipe $of_driver
sed 's|"[^"]*libvulkan_lvp.so"|"../../lib/lavapipe/libvulkan_lvp.so"|' /usr/share/vulkan/icd.d/lvp_icd*.json >"$root/share/vulkan/lavapipe.json"

elf | xargs -0 -n 20 -P "$(nproc)" strip --strip-unneeded
path_of() { # FOLDER PATH
    find "$root/$1" -maxdepth "$3" -type f \( -name '*.so*' -o -name ghostlight \) -print0 | xargs -0 -r -n 20 patchelf --set-rpath "$2"
}
path_of libexec '$ORIGIN/../lib' 1
path_of lib '$ORIGIN' 1
path_of lib/fallback '$ORIGIN/../..' 2
path_of lib/lavapipe '$ORIGIN:$ORIGIN/..' 1
path_of plugins '$ORIGIN/../../lib' 2

printf 'package\tversion\tsource\tsource version\twhere\n' >"$root/licences/packages.tsv"
told=$(printf '%s\n' $of_program "$driver" $of_driver "$qt/platforms/libqxcb.so" /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf \
    /usr/share/X11/xkb/rules/base | sort -u)
# By which of its names dpkg knows a file differs.
for file in $told; do printf '%s\n' "$file" "${file#/usr}" "$(readlink -f "$file")"; done | sort -u | xargs dpkg -S 2>/dev/null |
    sed 's/: .*//; s/,.*//' | sort -u >"$root/licences/packages" || true
[ -s "$root/licences/packages" ] || { echo "make_bundle.sh: dpkg knows none of the libraries; licences cannot be told" >&2; exit 1; }
while read -r package; do
    cp -L "/usr/share/doc/${package%%:*}/copyright" "$root/licences/${package%%:*}"
    dpkg-query -W -f '${Package}\t${Version}\t${source:Package}\t${source:Version}\thttps://snapshot.debian.org/package/${source:Package}/${source:Version}/\n' \
        "$package"
done <"$root/licences/packages" | sort -u >>"$root/licences/packages.tsv"
rm "$root/licences/packages"
cp -L /usr/share/common-licenses/* "$root/licences/common/"

newest() { xargs -0 objdump -T | grep -o 'GLIBC_2\.[0-9]*' | sort -u -V | tail -1 | cut -d_ -f2; }
glibc=$(elf | grep -zv /lib/lavapipe/ | newest)
glibc_of_driver=$(find "$root/lib/lavapipe" -type f -print0 | newest)
sed "s/NEEDED_GLIBC/${glibc#2.}/g" "$here/packaging/bundle/ghostlight" >"$root/bin/ghostlight"
chmod 755 "$root/bin/ghostlight"
sed "s/GLIBC_OF_DRIVER/$glibc_of_driver/; s/GLIBC/$glibc/" "$here/packaging/bundle/README" >"$root/README"
chmod -R u=rwX,go=rX "$root"
find "$root" -exec touch --no-dereference --date="@${SOURCE_DATE_EPOCH:-0}" {} +
echo "$root: $(find "$root/lib" -name '*.so*' | wc -l) libraries, $(du -sm "$root" | cut -f1) MB, glibc $glibc or newer, $glibc_of_driver for its own driver"

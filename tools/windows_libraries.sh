#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Builds, for Windows, the libraries that Debian has for Linux alone, out of Debian's own source packages, into build/windows_libraries.
# What is there stays. Fetches with apt-get and lists of its own under build, so that nothing of the system changes; needs no root.
# Usage: windows_libraries.sh [PROCESSES]
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
processes=${1:-$(nproc)}
root=$PWD/build/windows_libraries
mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}
. /etc/os-release

# Debian's source package | folder in it | options of CMake
libraries='
pugixml       | .           | -DPUGIXML_BUILD_TESTS=OFF
libpng1.6     | .           | -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_EXECUTABLES=OFF
libzstd       | build/cmake | -DZSTD_BUILD_SHARED=OFF -DZSTD_BUILD_PROGRAMS=OFF
libzip        | .           | -DENABLE_BZIP2=OFF -DENABLE_LZMA=OFF -DENABLE_OPENSSL=OFF -DENABLE_GNUTLS=OFF -DENABLE_MBEDTLS=OFF -DENABLE_COMMONCRYPTO=OFF -DENABLE_ZSTD=OFF -DENABLE_WINDOWS_CRYPTO=OFF -DBUILD_TOOLS=OFF -DBUILD_REGRESS=OFF -DBUILD_EXAMPLES=OFF -DBUILD_DOC=OFF
libjpeg-turbo | .           | -DENABLE_SHARED=OFF -DWITH_SIMD=OFF
imath         | .           |
openexr       | .           | -DOPENEXR_BUILD_TOOLS=OFF -DOPENEXR_INSTALL_EXAMPLES=OFF'

mkdir -p "$root/apt/lists/partial" "$root/apt/archives/partial" "$root/sources"
echo "deb-src $mirror $VERSION_CODENAME main" >"$root/apt/sources.list"
own=(-q -o "Dir::Etc::sourcelist=$root/apt/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$root/apt/lists"
    -o "Dir::Cache::archives=$root/apt/archives" -o "Dir::Cache::pkgcache=" -o "Dir::Cache::srcpkgcache=" -o APT::Sandbox::User=)

while IFS='|' read -r name folder options; do
    name=${name// /} folder=${folder// /}
    [ -n "$name" ] && [ ! -f "$root/$name.built" ] || continue
    [ -n "$(ls "$root/apt/lists"/*Sources* 2>/dev/null)" ] || apt-get "${own[@]}" update
    (cd "$root/sources" && rm -rf "${name}"-*/ && apt-get "${own[@]}" source "$name")
    source=$(find "$root/sources" -mindepth 1 -maxdepth 1 -type d -name "$name-*")
    # shellcheck disable=SC2086 # options are words
    cmake -S "$source/$folder" -B "$root/build/$name" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/windows_toolchain.cmake" \
        -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$root" -DCMAKE_INSTALL_LIBDIR:STRING=lib -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF \
        -DZLIB_LIBRARY=/usr/x86_64-w64-mingw32/lib/libz.a $options
    cmake --build "$root/build/$name" -j "$processes"
    cmake --install "$root/build/$name" >/dev/null
    rm -rf "$root/build/$name"
    touch "$root/$name.built"
done <<<"$libraries"

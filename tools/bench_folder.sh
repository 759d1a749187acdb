#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Makes ghostlight-bench.run: one file that measures the graphics of any 64-bit PC with Linux (as new as this one) and a Vulkan driver. It
# unpacks itself into a folder beside it, where the demo, the program with the libraries that it needs, tests of what draws and goldens
# lie, and runs that; only the C and C++ libraries, zlib, zstd and the Vulkan loader are the
# machine's own.
# Usage: bench_folder.sh BUILD_FOLDER OUT_FILE
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1 out=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
folder=$work/ghostlight-bench
mkdir -p "$folder/lib" "$folder/tests" "$folder/assets"
cp "$build/ghostlight-bench" "$folder/"
cp "$build"/test_gpu "$build"/test_render_{geometry,haze,relight} "$folder/tests/"
strip "$folder/ghostlight-bench" "$folder/tests/"*
for program in "$folder/ghostlight-bench" "$folder/tests/"*; do ldd "$program"; done | awk '$3 ~ /^\// { print $3 }' | sort -u |
    grep -vE '/(libc|libm|libdl|libpthread|librt|libstdc\+\+|libgcc_s|libz|libzstd|libvulkan)\.so' | xargs cp -Lt "$folder/lib"
cp -r assets/demo assets/fixtures "$folder/assets/"
rm -rf "$folder/assets/demo/.ghost" "$folder/assets/fixtures/src"
mkdir -p "$folder/tools"
cp -r tools/make_festival.py tools/festival "$folder/tools/"
find "$folder" -name __pycache__ -prune -exec rm -rf {} +
cp LICENSE "$folder/"
cat >"$folder/README.txt" <<'EOT'
./ghostlight-bench measures this machine's graphics and writes ghostlight-report/report.html and report.json
(--quick: the most important tables; --help: all options). It needs a Vulkan 1.3 driver and its loader (Debian: libvulkan1),
Python for the rows of festivals, and the Khronos validation layer (vulkan-validationlayers) for the table of that name.
EOT
# What lavapipe draws is what others are held against.
mkdir "$work/goldens"
"$folder/ghostlight-bench" pictures --device llvmpipe --pictures "$work/goldens" >/dev/null
rm -rf "$work"/goldens/*.png "$folder/assets/demo/.ghost"
mv "$work/goldens" "$folder/"
du -sm "$folder" | sed 's/\t.*/ MB unpacked/'
cat >"$out" <<'EOT'
#!/bin/sh
# Unpacks ghostlight-bench into the folder that this is started in, and runs it there with these arguments.
set -e
sed '1,/^__ARCHIVE__$/d' "$0" | tar -xJf -
exec ./ghostlight-bench/ghostlight-bench -o "$PWD/ghostlight-report" "$@"
__ARCHIVE__
EOT
tar -c --owner=0 --group=0 --sort=name -C "$work" ghostlight-bench | xz -T0 -6 >>"$out"
chmod +x "$out"
ls -l "$out"

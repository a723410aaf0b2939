#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# make_pictures.sh [NAME…]: installs what is missing, builds the workstation, and has it make the pictures of the user
# guide (pictures.txt), or those that are named.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$(cd "$here/../.." && pwd)"
folder="$here/guide/pictures"
largest=60000 # bytes; tests/architecture/pages_test.cpp has the same limit

bash "$root/app/install-packages.sh" build pictures
cd "$root"
if [ ! -f build/release/build.ninja ]; then
    cmake --preset release -DPROVEOUT_TESTS=OFF -DPROVEOUT_BENCH=OFF -DPROVEOUT_TOGETHER=ON
fi
cmake --build build/release --parallel "$(nproc)" --target proveout

# The same on every desktop.
export LC_ALL=C.UTF-8 QT_QPA_PLATFORM=xcb QT_SCALE_FACTOR=1 LIBGL_ALWAYS_SOFTWARE=1
raw="$(mktemp -d)"
trap 'rm -rf "$raw"' EXIT
mkdir -p "$folder"
grep -Ev '^(#|$)' "$here/pictures.txt" | while read -r name file block size options; do
    [ $# -eq 0 ] || [[ " $* " == *" $name "* ]] || continue
    # shellcheck disable=SC2086 # several options
    xvfb-run --auto-servernum --server-args "-screen 0 1600x1000x24" build/release/app/proveout \
        --screenshot "$raw/$name.png" --seek "$block" --size "$size" --theme light --language en $options "$file" \
        </dev/null
    pngquant --strip --speed 1 --nofs --force --output "$folder/$name.png" 64 "$raw/$name.png"
    bytes="$(stat --format %s "$folder/$name.png")"
    echo "$name: $bytes bytes"
    if [ "$bytes" -gt "$largest" ]; then
        echo "$name.png is larger than $largest bytes: make it smaller in pictures.txt" >&2
        exit 1
    fi
done

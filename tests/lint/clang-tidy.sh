#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# clang-tidy.sh BUILD: runs clang-tidy over the sources of core, ui, app and resources that BUILD compiles.
# A source is checked again only when it, a header of ours that it includes, or the rules have changed: the
# dependencies are those Ninja has recorded, so BUILD must have been built. What was found clean is remembered beside
# the compiler's cache, not in BUILD, so that a fresh clone on the same machine checks what is new only.
set -euo pipefail
build="$(realpath "$1")"
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
root="$PWD"
checked="${XDG_CACHE_HOME:-$HOME/.cache}/proveout/clang-tidy"
mkdir -p "$checked"
find "$checked" -type f -mtime +30 -delete
export root build checked

# Options of the build count as rules; where the clone lies does not.
options="$(grep -o '"command": .*' "$build/compile_commands.json" | grep -oE ' (-[DfmOW]|-std)[^ ]*' | sort -u)"
rules="$(cat .clang-tidy <(clang-tidy --version) <(echo "${options//$root/}") | sha256sum)"
export rules

# Object, then its sources and headers below this repository (outside of the build tree), one line an object.
dependencies() {
    ninja -C "$build" -t deps | awk -v root="$root/" -v build="$build/" '
        /^[^ ].*: #deps/ { if (line) print line; sub(/:$/, "", $1); line = ""; next }
        /^ / {
            path = $1
            if (path !~ /^\//) path = build path
            while (sub(/[^\/]+\/\.\.\//, "", path)) {}
            if (index(path, root) == 1 && index(path, build) != 1) line = line (line ? " " : "") substr(path, length(root) + 1)
        }
        END { if (line) print line }' | grep -E '^(core|ui|app|resources)/[^ ]*\.cpp( |$)' | sort -u -k1,1
}

check() {
    local files=($1) key
    cd "$root"
    key="$( (echo "$rules" && sha256sum "${files[@]}") | sha256sum | cut -c1-40)"
    [ -f "$checked/$key" ] && touch "$checked/$key" && return 0
    echo "clang-tidy ${files[0]}"
    clang-tidy --quiet -p "$build" "${files[0]}" 2>/dev/null && touch "$checked/$key"
}
export -f check

dependencies >"$build/clang-tidy-sources"
echo "clang-tidy: $(wc -l <"$build/clang-tidy-sources") sources"
xargs --arg-file="$build/clang-tidy-sources" --max-procs="$(nproc)" --delimiter='\n' --max-args=1 bash -c 'check "$1"' check

#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# install-packages.sh SECTION…: installs the missing Debian packages of these sections of packages.txt.
# Touches the network only if something is missing.
set -euo pipefail
list="$(dirname "${BASH_SOURCE[0]}")/packages.txt"

packages_of() {
    sed -n "/^\[$1\]\$/,/^\[/p" "$list" | grep -Ev '^(\[|#|[[:space:]]*$)'
}

installed() {
    [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing_of() {
    local package
    for package in $(packages_of "$1"); do
        installed "$package" || echo "$package"
    done
}

give_up() {
    echo "Proveout needs these packages: $*" >&2
    echo "They could not be installed. Please install them by hand and start again." >&2
    exit 1
}

if ! command -v dpkg-query >/dev/null; then
    echo "This is not a Debian system: packages are taken as installed (see app/packages.txt)." >&2
    exit 0
fi

missing=()
optional=()
for section in "$@"; do
    mapfile -t -O "${#missing[@]}" missing < <(missing_of "$section")
    mapfile -t -O "${#optional[@]}" optional < <(missing_of "$section-optional")
done
if [ "${#missing[@]}" -eq 0 ] && [ "${#optional[@]}" -eq 0 ]; then
    exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || give_up "${missing[@]}" "${optional[@]}"
    as_root=(sudo)
fi
echo "Installing: ${missing[*]} ${optional[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update || give_up "${missing[@]}" "${optional[@]}"

available=()
for package in "${optional[@]}"; do
    if apt-cache show "$package" >/dev/null 2>&1; then
        available+=("$package")
    fi
done
if [ "$((${#missing[@]} + ${#available[@]}))" -gt 0 ]; then
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install --yes --no-install-recommends "${missing[@]}" "${available[@]}" ||
        give_up "${missing[@]}" "${available[@]}"
fi

#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# install-packages.sh SECTION…: installs the missing Debian packages of these sections of packages.txt, and those of
# SECTION-optional that are available. Uses the network only if something is missing.
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
    echo "They could not be installed. Install them manually and start again." >&2
    exit 1
}

if ! command -v dpkg-query >/dev/null; then
    echo "This is not a Debian system: assuming that the packages in app/packages.txt are installed." >&2
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
    as_root=(sudo)
    if ! command -v sudo >/dev/null; then
        if [ "${#missing[@]}" -eq 0 ]; then
            echo "Continuing without: ${optional[*]}" >&2
            exit 0
        fi
        give_up "${missing[@]}"
    fi
fi

# Without recommended packages: those of linuxcnc-uspace include a real-time kernel.
install() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "$@"
}

echo "Installing: ${missing[*]} ${optional[*]}"
updated=yes
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update || updated=no
if [ "${#missing[@]}" -gt 0 ]; then
    if [ "$updated" = no ] || ! install "${missing[@]}"; then
        give_up "${missing[@]}"
    fi
fi
# One by one, so that an unavailable package does not prevent the others; no failure stops the run.
for package in "${optional[@]}"; do
    if apt-cache show "$package" >/dev/null 2>&1; then
        install "$package" || echo "Continuing without $package." >&2
    fi
done

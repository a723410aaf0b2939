#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh [PROGRAM [OPTION…]]: installs what is missing, builds, and opens PROGRAM (an NC program or a .proveout job; by
# default the core insert sample) in the workstation. Without a display it simulates headless instead, and passes the
# options to `proveout-cli simulate`.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
program="$(realpath -- "${1:-$root/resources/samples/core-insert.proveout}")"
shift || true

bash "$root/app/install-packages.sh" build

cd "$root"
if [ ! -f build/release/build.ninja ]; then
    # The tests need additional packages; tests/run.sh enables them.
    cmake --preset release -DPROVEOUT_TESTS=OFF -DPROVEOUT_BENCH=OFF -DPROVEOUT_TOGETHER=ON
fi
cmake --build build/release --parallel "$(nproc)" --target proveout proveout-cli

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    exec build/release/app/proveout "$program"
fi

# If there is a job file next to the program, that job is simulated.
stem="$(basename "${program%.*}")"
job="${program%.*}.proveout"
if [ -f "$job" ]; then
    input=(--job "$job")
else
    input=("$program")
fi
mkdir -p results
result="results/$stem"
rm -f "$result.stl" "$result.json"
echo "No display: simulating $program headless."
status=0
build/release/app/proveout-cli simulate "${input[@]}" "$@" --stl "$result.stl" --json >"$result.json" || status=$?
cat "$result.json"
if [ -f "$result.stl" ]; then
    echo "Results: $root/$result.stl (the machined part), $root/$result.json (figures)"
fi
exit "$status"

#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh [NAME…]: builds the benchmarks and runs all of them, or those named, one after the other. The output of NAME is
# in results/figures/NAME.txt; the pages of this folder contain the figures.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"

# name | command, in build/release
figures() {
    cat <<'ROWS'
cutting|tests/bench/cutting_table
scale|tests/bench/scale_bench
seek|tests/bench/seek_bench
decimation|tests/bench/certified_bench MAPS
certify|tests/bench/decimation_bench --benchmark_filter=generated/.*allowanceUm:50/
peers|tests/bench/peers_bench MAP 0.1 200
interpret|tests/bench/interpret_bench --benchmark_filter=none
whole|tests/bench/whole_run
memory|tests/bench/memory_table
faults|tests/bench/fault_table
core-insert|app/proveout-cli simulate --job SAMPLES/core-insert.proveout --json
mouse-case|app/proveout-cli simulate --job SAMPLES/mouse-case.proveout --json
optimiser|app/proveout-cli study --job SAMPLES/core-insert.proveout --optimise --exhaustive --repeats 9 --out OUT
paper|app/proveout study --job SAMPLES/core-insert.proveout --sweep all --draw-every 4 --out OUT
drawing|tests/ui/viewport/paper_mode_bench SAMPLES/core-insert.proveout
drawing-mouse|tests/ui/viewport/paper_mode_bench SAMPLES/mouse-case.proveout --every 10
pairs|tests/ui/viewport/paper_mode_bench SAMPLES/core-insert.proveout --every 4 --pairs 20
pairs-mouse|tests/ui/viewport/paper_mode_bench SAMPLES/mouse-case.proveout --every 80 --pairs 20
playing|tests/ui/viewport/viewport_bench 5
typing|tests/ui/window/typing_bench
gaps|tests/ui/window/fault_gaps
ROWS
}

bash "$root/app/install-packages.sh" build test
cd "$root"
cmake --preset release -DPROVEOUT_TESTS=ON -DPROVEOUT_BENCH=ON -DPROVEOUT_TOGETHER=ON
cmake --build build/release --parallel "$(nproc)"

export LC_ALL=C.UTF-8 QT_QPA_PLATFORM=xcb QT_SCALE_FACTOR=1 LIBGL_ALWAYS_SOFTWARE=1
display=()
[ -n "${DISPLAY:-}" ] || display=(xvfb-run --auto-servernum --server-args "-screen 0 1600x1000x24")
out="$root/results/figures"
maps="$root/../shared/maps" # without these maps the benchmarks create their own, or are skipped
given=()
for map in m01:0.1 mo01:0.1 die025:0.25; do
    [ ! -f "$maps/${map%:*}.npy" ] || given+=("$maps/${map%:*}.npy" "${map#*:}")
done
mkdir -p "$out"
failed=0
while IFS='|' read -r name command; do
    [ $# -eq 0 ] || [[ " $* " == *" $name "* ]] || continue
    if [[ $command == *" MAP "* ]] && [ ! -f "$maps/m01.npy" ]; then
        echo "$name is left out: there is no $maps/m01.npy"
        continue
    fi
    command="${command/ MAPS/ ${given[*]}}"
    command="${command/ MAP / $maps/m01.npy }"
    command="${command//SAMPLES/$root/resources/samples}"
    command="${command//OUT/$out/$name}"
    echo "$name: $command"
    # shellcheck disable=SC2086 # a command with its arguments
    "${display[@]}" build/release/$command </dev/null >"$out/$name.txt" || { echo "$name failed" >&2 && failed=1; }
done < <(figures)
echo "Figures: $out"
exit "$failed"

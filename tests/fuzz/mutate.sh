#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# tests/fuzz/mutate.sh [RUNS [OPTION…]]: builds the release preset as far as needed and reads RUNS (100000) damaged
# inputs. Fails if one crashes, uses more than 5 s of CPU time or more than 1 GB; these inputs are stored in
# build/release/mutation-findings. The seed is printed; --seed N repeats a run.
set -eu
cd "$(dirname "$0")/../.."
runs="${1:-100000}"
[ $# -eq 0 ] || shift
[ -f build/release/build.ninja ] || cmake --preset release
cmake --build build/release --target mutation_runs
exec build/release/tests/fuzz/mutation_runs --runs "$runs" --found build/release/mutation-findings "$@"

#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh [CTEST OPTION…]: installs what is missing, builds everything but the benchmarks, also with sanitizers, and
# runs every test. The output ends with CTest's lines, and the exit code is that of CTest.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

bash "$root/app/install-packages.sh" build test

cd "$root"
jobs="$(nproc)"
cmake --preset release -DPROVEOUT_TESTS=ON -DPROVEOUT_BENCH=OFF -DPROVEOUT_TOGETHER=ON
cmake --build build/release --parallel "$jobs"
for preset in asan tsan; do
    # Names of functions are enough to see what failed; line numbers take a tenth of the compilation.
    PROVEOUT_SANITIZER_FLAGS=-g0 cmake --preset "$preset"
    cmake --build "build/$preset" --target brief_tests --parallel "$jobs"
done
# Caches its results, which the test of the same name then reports. A finding must not stop the other tests.
tests/lint/clang_tidy.py build/release || true

# Random input is the same in every run, so that a failure is caused by the change under test; tests started by hand
# use new input each time. For a failing test, only the failures are printed.
export PROVEOUT_SEED="${PROVEOUT_SEED:-1}" GTEST_BRIEF=1
# Makes the tests independent of the desktop that they are started from.
export LC_ALL=C.UTF-8 QT_QPA_PLATFORM=xcb QT_SCALE_FACTOR=1 LIBGL_ALWAYS_SOFTWARE=1
if [ -z "${XDG_RUNTIME_DIR:-}" ]; then
    XDG_RUNTIME_DIR="$(mktemp -d)"
    export XDG_RUNTIME_DIR
    trap 'rm -rf "$XDG_RUNTIME_DIR"' EXIT
fi
display=()
if [ -z "${DISPLAY:-}" ]; then
    # Without a window manager, no window gets the keyboard focus back after a dialog was closed.
    display=(xvfb-run --auto-servernum --server-args "-screen 0 1600x1000x24"
        bash -c 'openbox >/dev/null 2>&1 & sleep 1; "$@"' with-window-manager)
fi
"${display[@]}" ctest --test-dir build/release --parallel "$jobs" --output-on-failure "$@"

#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh [CTEST OPTION…]: installs what is missing, builds everything, the sanitizer builds of the core included, and
# runs every test. Ends in CTest's lines and with its exit code.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

bash "$root/app/install-packages.sh" build test

cd "$root"
jobs="$(nproc)"
cmake --preset release -DPROVEOUT_TESTS=ON -DPROVEOUT_BENCH=ON -DPROVEOUT_TOGETHER=ON
cmake --build build/release --parallel "$jobs"
for preset in asan tsan; do
    cmake --preset "$preset"
    cmake --build "build/$preset" --parallel "$jobs"
done
# Remembers what it has checked; the test of the same name then reports. A finding must not stop the other tests.
tests/lint/clang_tidy.py build/release || true

# Random input is the same in every run, so that a failure is one of the change that runs it; tests started by
# hand find new input each time. Of a test that fails, only what failed is printed.
export PROVEOUT_SEED="${PROVEOUT_SEED:-1}" GTEST_BRIEF=1
# What the tests see does not depend on the desktop they are started from.
export LC_ALL=C.UTF-8 QT_QPA_PLATFORM=xcb QT_SCALE_FACTOR=1 LIBGL_ALWAYS_SOFTWARE=1
if [ -z "${XDG_RUNTIME_DIR:-}" ]; then
    XDG_RUNTIME_DIR="$(mktemp -d)"
    export XDG_RUNTIME_DIR
    trap 'rm -rf "$XDG_RUNTIME_DIR"' EXIT
fi
display=()
if [ -z "${DISPLAY:-}" ]; then
    # Without a window manager, no window has the keyboard again once a dialog over it was closed.
    display=(xvfb-run --auto-servernum --server-args "-screen 0 1600x1000x24"
        bash -c 'openbox >/dev/null 2>&1 & sleep 1; "$@"' with-window-manager)
fi
"${display[@]}" ctest --test-dir build/release --parallel "$jobs" --output-on-failure "$@"

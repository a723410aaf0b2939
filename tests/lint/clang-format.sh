#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Fails if clang-format would change any C++ source.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
find core ui app resources tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
    xargs --null clang-format --dry-run -Werror

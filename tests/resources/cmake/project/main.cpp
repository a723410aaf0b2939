// SPDX-License-Identifier: GPL-3.0-or-later
#include <zstd.h>

int main() {
    return ZSTD_versionNumber() / 10000 == ZSTD_VERSION_MAJOR ? 0 : 1;
}

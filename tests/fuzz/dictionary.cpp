// SPDX-License-Identifier: GPL-3.0-or-later
// Prints libFuzzer's dictionary of NC words.
#include <cstdio>

#include "tests/fuzz/nc_words.h"

int main() {
    for (const std::string& word : proveout::test::ncWords()) {
        std::putchar('"');
        for (const char c : word)
            std::printf(c < ' ' ? "\\x%02x" : "%c", c);
        std::puts("\"");
    }
    return 0;
}

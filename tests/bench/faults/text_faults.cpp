// SPDX-License-Identifier: GPL-3.0-or-later
// Programs with faults in their characters, words and expressions.
#include <fmt/format.h>

#include "tests/bench/faults/written_faults.h"

namespace proveout {

namespace {

std::string repeated(const std::string& part, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
        text += part;
    return text;
}

std::string manyNames() {
    std::string text;
    for (int i = 0; i < 100'200; ++i)
        text += fmt::format("#<n{}>=1\n", i);
    return text + "G0 X1\nM2\n";
}

void writeNumbers(FaultWriter& writer) {
    writer.put(9, "num-exp", ".ngc", "G21 G90\nG0 X1e5\nM2\n");
    writer.put(9, "num-power", ".ngc", "G21 G90\nG0 X[10**400]\nM2\n");
    writer.put(10, "num-lone", ".ngc", "G21 G90\nG0 X\nG0 X-\nG0 X.\nG0 X-.\nM2\n");
    for (const auto& [name, open] : {std::pair{"brackets-10k", "["}, std::pair{"functions-10k", "SIN["}})
        writer.put(11, name, ".ngc",
                   "G21 G90\nG0 X" + repeated(open, 10'000) + "1" + repeated("]", 10'000) + "\nM2\n");
    writer.put(11, "indirect-10k", ".ngc", "G21 G90\nG0 X" + repeated("#", 10'000) + "1\nM2\n");
    writer.put(12, "expr-domain", ".ngc",
               "G21 G90\nG0 X[1/0]\nX[SQRT[0-1]]\nX[LN[0]]\nX[ACOS[2]]\nX[ASIN[0-2]]\nX[[0-1]**0.5]\n"
               "X[5 MOD 0]\nM2\n");
}

} // namespace

void writeTextFaults(FaultWriter& writer) {
    writer.put(2, "png-header", ".ngc", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\1\0", 20));
    writer.put(3, "bom-utf8", ".ngc", "\xef\xbb\xbfG21 G90\nG0 X1\nM2\n");
    writer.put(4, "eol-cr", ".ngc", "G21 G90\rG0 X1\rG777\rM2\r");
    writer.put(4, "no-final-newline", ".ngc", "G21 G90\nG0 X1\nG777");
    writer.put(6, "latin1-comment", ".ngc", "G21 G90\n(caf\xe9)\nG0 X1\nM2\n");
    writer.put(8, "line-100k", ".ngc", "G21 G90\nG0 X1" + std::string(100'000, ' ') + "Y2\nM2\n");
    writeNumbers(writer);
    writer.put(13, "named-many", ".ngc", manyNames());
    writer.put(14, "n-duplicate", ".nc", "O1\nG0 X1.\nGOTO 7\nN7 X2.\nN7 X3.\nM30\n");
    writer.put(17, "unknown-g", ".ngc", "G21 G90\nG0 X0 Y0\nG777 X1\nM777\nM2\n");
    writer.put(17, "g68", ".ngc", "G21 G90\nG0 X0 Y0\nG68 X0 Y0 R30\nX9\nM2\n");
}

} // namespace proveout

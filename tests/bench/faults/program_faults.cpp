// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that specify something impossible, or impossible within the available time and memory.
#include <filesystem>
#include <fmt/format.h>

#include "tests/bench/faults/written_faults.h"

namespace proveout {

namespace {

const std::string kHead = "G21 G90 G17 F100\nG0 X0 Y0 Z5\n";

void writeArcsAndCycles(FaultWriter& writer) {
    writer.put(18, "arc-radius-small", ".ngc", kHead + "G2 X10 Y0 R4\nM2\n");
    writer.put(18, "arc-radius-mismatch", ".ngc", kHead + "G2 X10 Y0 I6\nM2\n");
    writer.put(19, "arc-turns-1e9", ".ngc", kHead + "G2 X0 Y0 I5 P1000000000\nM2\n");
    writer.put(19, "arc-turns-1000", ".ngc", kHead + "G1 Z-1\nG2 X0 Y0 Z-9 I5 P1000\nM2\n");
    writer.put(20, "arc-circle-1e12", ".ngc", kHead + "G2 X0 Y0 I1000000000000\nM2\n");
    writer.put(20, "arc-circle-1e7", ".ngc", kHead + "G2 X0 Y0 I10000000\nM2\n");
    writer.put(21, "g83-q0", ".ngc", kHead + "G83 X1 Y1 Z-10 R1 Q0\nG80\nM2\n");
    writer.put(21, "g83-q-tiny", ".ngc", kHead + "G83 X1 Y1 Z-10 R1 Q0.0000001\nG80\nM2\n");
    writer.put(21, "g83-99k-pecks", ".ngc", kHead + "G83 X1 Y1 Z-3 R0 Q0.0001\nG80\nM2\n");
}

void writeLoops(FaultWriter& writer) {
    writer.put(22, "m98-L-nested", ".ngc",
               kHead + "M98 P2 L9999\nM2\nO2\nM98 P3 L9999\nM99\nO3\nG91 G0 X1\nM99\n");
    writer.put(23, "o-repeat-huge", ".ngc",
               kHead + "o1 repeat [1000000000000]\nG91 G0 X1\no1 endrepeat\nM2\n");
    writer.put(23, "o-repeat-million", ".ngc",
               kHead + "o1 repeat [999999]\nG91 G1 X0.001\no1 endrepeat\nM2\n");
    writer.put(24, "while-forever", ".nc",
               "O1\nG0 X0 Y0 Z9.\n#1=0\nWHILE [1 EQ 1] DO 1\n#1=#1+1\nG0 X#1\nEND 1\nM30\n");
    writer.put(24, "while-idle", ".nc", "O1\n#1=0\nWHILE [1 EQ 1] DO 1\n#1=#1+1\nEND 1\nM30\n");
    writer.put(24, "while-tool-changes", ".ngc",
               kHead + "#1=0\no1 while [1]\n#1=[#1+1]\nT1 M6\nT2 M6\nG91 G0 X1\no1 endwhile\nM2\n");
    writer.put(25, "m98-self", ".nc", "O1\nM98 P1\nM30\n");
    writer.put(25, "o-recursion", ".ngc", "o7 sub\no7 call\no7 endsub\no7 call\nM2\n");
    writer.put(29, "m98-missing", ".ngc", "M98 P4711\nM2\n");
    writer.put(29, "goto-missing", ".nc", "O1\nG0 X1.\nGOTO 4711\nM30\n");
    writer.put(29, "do-crossed", ".nc", "O1\nWHILE [1 EQ 1] DO 1\nWHILE [1 EQ 1] DO 2\nEND 1\nEND 2\nM30\n");
}

void writeFilesOfPrograms(FaultWriter& writer) {
    std::filesystem::create_symlink("/etc/passwd", writer.folder() / "away.ngc");
    writer.put(27, "o-symlink", ".ngc", "o<away> call\nM2\n");
    writer.put(28, "log-files", ".ngc",
               "(LOGOPEN,written.txt)\n(LOG,hello)\n(LOGCLOSE)\n(PROBEOPEN probed.txt)\nG0 X1\nM2\n");
}

void writeCompensationAndTools(FaultWriter& writer) {
    const std::string head = "G21 G90 F100 G0 X0 Y-20\n";
    writer.put(30, "comp-gouge", ".ngc", head + "G41.1 D10 G1 X20 Y0\nY20\nX15\nY-20\nG40 G0 X99\nM2\n");
    writer.put(30, "comp-end-active", ".ngc", head + "G41.1 D4 G1 X20 Y0\nY20\nM2\n");
    writer.put(31, "feed-negative", ".ngc", "G21 G90\nG1 X1 F-5\nM2\n");
    writer.put(31, "feed-zero", ".ngc", "G21 G90\nG1 X1 F0\nM2\n");
    writer.put(31, "g93-no-f", ".ngc", "G21 G90\nG93 G1 X1\nM2\n");
    writer.put(31, "g95-no-spindle", ".ngc", "G21 G90\nG95 F0.1 G1 X1\nM2\n");
    writer.put(32, "tool-numbers", ".ngc", "G21 G90\nT1.5 M6\nT-1 M6\nT100000000000 M6\nG0 X1\nM2\n");
    writer.put(33, "arc-tiny", ".ngc", kHead + "G2 X0 Y0 I0.0000001\nM2\n");
}

std::string manyLines(int count) {
    std::string text = "G21 G90 F1000\nT1 M6\nG0 X0 Y0 Z5\nG1 Z-1\n";
    for (int i = 0; i < count; ++i)
        text += fmt::format("X{} Y{}\n", i % 39, i % 29);
    return text + "M2\n";
}

} // namespace

void writeProgramFaults(FaultWriter& writer) {
    writeArcsAndCycles(writer);
    writeLoops(writer);
    writeFilesOfPrograms(writer);
    writeCompensationAndTools(writer);
    writer.put(35, "lines-10k", ".ngc", manyLines(10'000));
}

void writeBigFaults(FaultWriter& writer) {
    // The guarantee is a million lines per second, for reading only.
    FaultCase& lines = writer.put(35, "lines-10M", ".ngc", manyLines(10'000'000));
    lines.seconds = 10;
    lines.setup = {"--stock", "40x30x10", "--grid", "0.5", "--tool", "1=flat:d=4,l=20", "--until", "1"};
    writer.put(63, "json-1GB-string", ".proveout", R"({"proveout": 2, "program": ")");
    writer.lengthen("json-1GB-string.proveout", 1'000'000'000);
}

} // namespace proveout

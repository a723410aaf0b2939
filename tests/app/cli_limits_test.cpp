// SPDX-License-Identifier: GPL-3.0-or-later
// A few bytes that request an enormous amount of work: each is refused with a message and its location,
// within about a second and a gigabyte.
#include <cctype>
#include <gtest/gtest.h>
#include <string>
#include <string_view>

#include "tests/app/command_line.h"

namespace proveout {
namespace {

constexpr double kMostBytes = 1e9;
constexpr double kMostSeconds = 20; ///< CPU time: it takes one second, and much longer if nothing limits it

struct Attack {
    const char* name;
    const char* dialect;
    const char* text;
    const char* where; ///< line:column of the message
    const char* id;
};

const Attack kAttacks[] = {
    {"pecks of no depth", "linuxcnc", "F100 G0 X0 Y0 Z9\nG83 X1 Y1 Z-10 R1 Q0.0000001\nG80\nM2\n", "2:19",
     "block-too-long"},
    {"chips of no depth", "linuxcnc", "F100 G0 X0 Y0 Z9\nG73 X1 Y1 Z-10 R1 Q.0000001\nM2\n", "2:19",
     "block-too-long"},
    {"a negative peck", "linuxcnc", "F100 G0 X0 Y0 Z9\nG83 X1 Y1 Z-10 R1 Q-0.0000001\nM2\n", "2:19",
     "cycle-peck"},
    {"the least peck of Fanuc", "fanuc", "G90 G0 X0 Y0 Z9. F100\nG83 X1. Y1. Z-9999. R1. Q1\nM30\n", "2:25",
     "block-too-long"},
    {"a tap by pecks", "fanuc", "G90 G0 X0 Y0 Z9. F100 S100 M3\nG84 Z-9000. R1. Q-1 F1.\nM30\n", "2:17",
     "block-too-long"},
    {"shrinking pecks", "haas", "G90 G0 X0 Y0 Z9. F100.\nG83 Z-99. R1. I0.1 J0.0001 K0.0001\nM30\n", "2:15",
     "block-too-long"},
    {"repeats of a cycle", "linuxcnc", "F100 G0 X0 Y0 Z9\nG91 G81 X1 Z-1 R0 L999999999\nM2\n", "2:19",
     "block-too-long"},
    {"repeats of pecks", "fanuc", "G90 G0 X0 Y0 Z9. F100\nG91 G83 X1. Z-9. R-1. Q1000 K9999\nM30\n", "2:29",
     "block-too-long"},
    {"a pattern of pecks", "haas", "G90 G0 X0 Y0 Z9. F100.\nG83 Z-90. R1. Q1. L0\nG70 I9. J0 L9999\nM30\n",
     "3:12", "block-too-long"},
    {"passes of a pocket", "haas", "G90 G0 X0 Y0 Z9. F100.\nG91 G13 Z-1. I1. K999. Q1. L9999\nM30\n", "2:5",
     "block-too-long"},
    {"turns of an arc", "linuxcnc", "F100 G0 X0 Y0 Z9\nG2 X0 Y0 I5 P1000000000\nM2\n", "2:13", "arc-turns"},
    {"a turned arc", "linuxcnc", "G10 L2 P1 R30\nF100 G0 X0 Y0 Z9\nG18 G2 X0 Z9 Y9 I1500 P1000\nM2\n", "3:5",
     "block-too-long"},
    {"repeats of a call", "linuxcnc", "G0 X0 Y0 Z9\nM98 P2 L999999999\nM2\nO2\nG91 G0 X1\nM99\n", "2:5",
     "too-many-rounds"},
    {"repeats of a call on Mach", "mach", "G0 X0 Y0 Z9\nM98 P2 L999999999\nM30\nO2\nG91 G0 X1\nM99\n", "2:5",
     "too-many-rounds"},
    {"repeats of repeats", "linuxcnc",
     "G0 X0 Y0 Z9\nM98 P2 L999999\nM2\nO2\nM98 P3 L999999\nM99\nO3\nG91 G0 X1\nM99\n", "", "too-many-steps"},
    {"repeats of repeats on Fanuc", "fanuc",
     "O1\nG0 X0 Y0 Z9.\nM98 P2 L9999\nM30\nO2\nM98 P3 L9999\nM99\nO3\nG91 G0 X1.\nM99\n", "",
     "too-many-steps"},
    {"rounds of a loop", "linuxcnc", "G0 X0 Y0 Z9\no1 repeat [1000000000000]\nG91 G0 X1\no1 endrepeat\nM2\n",
     "2:1", "too-many-rounds"},
    {"rounds within rounds", "linuxcnc",
     "G0 X0 Y0 Z9\no1 repeat [999999]\no2 repeat [999999]\nG91 G0 X1\no2 endrepeat\no1 endrepeat\nM2\n", "",
     "too-many-steps"},
    {"a loop that always holds", "linuxcnc", "o1 while [1]\no1 endwhile\nM2\n", "1:1", "endless-loop"},
    {"a loop that moves for ever", "linuxcnc", "G0 X0 Y0 Z9\no1 while [1]\nG91 G0 X1\no1 endwhile\nM2\n",
     "2:1", "endless-loop"},
    {"a loop that moves and counts", "linuxcnc",
     "G0 X0 Y0 Z9\n#1=0\no1 while [1]\n#1=[#1+1]\nG91 G0 X1\no1 endwhile\nM2\n", "", "too-many-steps"},
    {"a loop that changes tools", "linuxcnc",
     "G0 X0 Y0 Z9\n#1=0\no1 while [1]\n#1=[#1+1]\nT1 M6\nT2 M6\no1 endwhile\nM2\n", "", "too-many-steps"},
    {"WHILE with motions", "fanuc",
     "O1\nG0 X0 Y0 Z9.\n#1=0\nWHILE [1 EQ 1] DO 1\n#1=#1+1\nG0 X#1\nEND 1\nM30\n", "", "too-many-steps"},
    {"WHILE that counts", "fanuc", "O1\n#1=0\nWHILE [1 EQ 1] DO 1\n#1=#1+1\nEND 1\nM30\n", "",
     "loop-without-motion"},
    {"GOTO that counts", "fanuc", "%\nO1\n#1=0\nN1 #1=#1+1\nGOTO 1\nM30\n%\n", "", "loop-without-motion"},
    {"GOTO round motions", "fanuc", "O1\nG0 X0 Y0 Z9.\nN1 G91 G0 X1.\nX-2.\nGOTO 1\nM30\n", "3:1",
     "endless-loop"},
    {"M99 round motions", "fanuc", "O1\nG0 X0 Y0 Z9.\nN1 G91 G0 X1.\nX-2.\nM99 P1\n", "3:1", "endless-loop"},
    {"dwells", "linuxcnc", "o1 while [1]\nG4 P1\no1 endwhile\nM2\n", "1:1", "endless-loop"},
    {"a macro behind each motion", "fanuc",
     "O1\nG0 X0 Y0 Z9.\nG66 P2\n#1=0\nWHILE [1 EQ 1] DO 1\n#1=#1+1\nG0 X#1\nEND 1\nM30\nO2\nG91 G0 "
     "Z1.\nG90\nM99\n",
     "", "too-many-steps"},
    {"calls that double", "linuxcnc",
     "o1 sub\n#1=[#1-1]\no2 if [#1 GT 0]\no1 call [#1]\no1 call [#1]\no2 endif\no1 endsub\no1 call "
     "[60]\nM2\n",
     "", "call-too-deep"},
};

std::string start(const Attack& attack) {
    const std::string where = attack.where;
    return where.empty() ? "a.nc:" : "a.nc:" + where + ": error: ";
}

class CliLimits : public CommandLine, public testing::WithParamInterface<Attack> {
protected:
    void expectRefused(const Finished& done) {
        const Attack& attack = GetParam();
        EXPECT_EQ(done.exitCode, 2) << attack.name << '\n' << done.err;
        EXPECT_TRUE(done.reports(start(attack), attack.id)) << attack.name << '\n' << done.err;
#if !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
        EXPECT_LT(done.peakBytes, kMostBytes) << attack.name;
        EXPECT_LT(done.cpuSeconds, kMostSeconds) << attack.name;
#endif
    }
};

TEST_P(CliLimits, AreMetByTheInterpretation) {
    write("a.nc", GetParam().text);
    expectRefused(run(std::string("interpret a.nc --dialect ") + GetParam().dialect));
}

TEST_P(CliLimits, AreMetByTheSimulation) {
    write("a.nc", GetParam().text);
    expectRefused(run(std::string("simulate a.nc --json --dialect ") + GetParam().dialect + kStock + kTool +
                      "--tool 2=flat:d=4,l=20"));
}

TEST_P(CliLimits, AreMetInLittleMemory) {
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "sanitizers take address space of their own";
#endif
    write("a.nc", GetParam().text);
    expectRefused(runWithin(2'000'000'000, std::string("interpret a.nc --dialect ") + GetParam().dialect));
}

std::string caseName(const testing::TestParamInfo<Attack>& attack) {
    std::string name;
    bool begins = true;
    for (const char c : std::string_view(attack.param.name)) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        begins = c == ' ';
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(Attacks, CliLimits, testing::ValuesIn(kAttacks), caseName);

} // namespace
} // namespace proveout

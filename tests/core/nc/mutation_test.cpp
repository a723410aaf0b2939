// SPDX-License-Identifier: GPL-3.0-or-later
// For any text: a result in time, with finite numbers and valid locations.
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "core/nc/run/interpreter.h"
#include "tests/core/nc/program_invariants.h"

namespace proveout {

namespace {

const std::vector<std::string> kPieces{"G0",
                                       "G1",
                                       "G2",
                                       "G3",
                                       "G4",
                                       "G17",
                                       "G18",
                                       "G19",
                                       "G20",
                                       "G21",
                                       "G28",
                                       "G53",
                                       "G80",
                                       "G81",
                                       "G90",
                                       "G91",
                                       "G90.1",
                                       "G91.1",
                                       "M2",
                                       "M3",
                                       "M6",
                                       "M98",
                                       "T1",
                                       "S1000",
                                       "F100",
                                       "X",
                                       "Y",
                                       "Z",
                                       "I",
                                       "J",
                                       "K",
                                       "R",
                                       "P",
                                       "N",
                                       "O",
                                       "/",
                                       "%",
                                       "(",
                                       ")",
                                       ";",
                                       "#",
                                       "[",
                                       "]",
                                       "-",
                                       "+",
                                       ".",
                                       "1",
                                       "5.5",
                                       "-10",
                                       "1e12",
                                       "\n",
                                       "\n",
                                       "\n",
                                       "\r",
                                       "\r\n",
                                       " ",
                                       "\t",
                                       "\x11",
                                       "\x1a",
                                       "\xff",
                                       "\xe2\x88\x92",
                                       "999999999999",
                                       "0.000000001",
                                       "nan",
                                       "1000000000",
                                       "o100 sub"};

std::string randomProgram(std::mt19937& random) {
    std::string text;
    for (std::size_t n = random() % 120; n > 0; --n) {
        text += kPieces[random() % kPieces.size()];
        if (random() % 2 == 0)
            text +=
                std::to_string(static_cast<int>(random() % 41) - 20) + (random() % 3 == 0 ? "." : "") + " ";
    }
    return text;
}

/// Programs of complete words, so that they reach the geometry.
std::string randomMotions(std::mt19937& random) {
    std::string text = "G0 X0 Y0 Z0 F100\n";
    for (std::size_t n = random() % 40; n > 0; --n) {
        const std::vector<std::string> codes{"G0",  "G1",  "G2",  "G3",  "",    "G17",
                                             "G18", "G19", "G91", "G90", "G20", "G21"};
        text += codes[random() % codes.size()];
        for (const char letter : std::string("XYZIJKRP")) {
            if (random() % 4 == 0)
                text.append(1, letter).append(std::to_string(static_cast<int>(random() % 21) - 10));
        }
        text += '\n';
    }
    return text;
}

/// Lines and arcs with cutter compensation that are impossible to compensate, small and large ones.
std::string randomCompensated(std::mt19937& random) {
    std::string text = "G0 X0 Y0 Z0 F100\nG" + std::to_string(41 + random() % 2) + ".1 D" +
                       std::to_string(random() % 12) + "\n";
    for (std::size_t n = random() % 40; n > 0; --n) {
        const std::vector<std::string> codes{"G0", "G1", "G2", "G3", "G2", "G3", "", "G20", "G21"};
        text += codes[random() % codes.size()];
        for (const char letter : std::string(random() % 3 == 0 ? "XYZIJ" : "XYR")) {
            if (random() % 8 != 0)
                text.append(1, letter).append(std::to_string((static_cast<int>(random() % 41) - 20) / 8.0));
        }
        text += random() % 20 == 0 ? "\nG40 G1 X0 Y0\nG41.1 D2\n" : "\n";
    }
    return text;
}

/// The same for compensation by registers, with other blocks in between that are allowed in this mode.
std::string randomByRegister(std::mt19937& random) {
    const std::vector<std::string> between{
        "",       "",      "",         "G4 P1\n", "M8\n",        "G91 G28 Z0\nG90\n",
        "Z-1.\n", "M0\n",  "G41\n",    "G42\n",   "G40\n",       "G42 D2\n",
        "D3\n",   "D0\n",  "G53 X1\n", "G17\n",   "G4 P1\nM8\n", "G40 X1. I1. J2.\n",
        "G18\n",  "G41\n", "G20\n",    "G21\n"};
    std::string text = "G0 X0 Y0 Z0 F100\nG41 D1\n";
    for (std::size_t n = random() % 40; n > 0; --n) {
        const std::vector<std::string> codes{"G0", "G1", "G2", "G3", "G1", "G1", "G2", "G3", ""};
        text += codes[random() % codes.size()];
        for (const char letter : std::string(random() % 3 == 0 ? "XYZIJ" : "XYR")) {
            if (random() % 8 != 0)
                text.append(1, letter).append(std::to_string((static_cast<int>(random() % 41) - 20) / 2.0));
        }
        const std::vector<std::string> corners{"", "", ",C1.", ",R2.", ",R.5"};
        text += corners[random() % corners.size()] + "\n" + between[random() % between.size()];
    }
    return text;
}

void check(const std::string& text, const InterpretOptions& options = {}) {
    const NcText nc(text);
    EXPECT_EQ(test::brokenPromise(nc, options, *interpret(nc, options)), "") << text;
}

} // namespace

TEST(Mutation, RandomTextsAreAnswered) {
    for (unsigned seed = 1; seed <= 20000; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        ASSERT_NO_FATAL_FAILURE(check(seed % 2 == 0 ? randomProgram(random) : randomMotions(random)));
        if (HasFailure())
            return;
    }
}

TEST(Mutation, RandomCompensationIsAnswered) {
    for (unsigned seed = 1; seed <= 20000; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        ASSERT_NO_FATAL_FAILURE(check(randomCompensated(random)));
        if (HasFailure())
            return;
    }
}

TEST(Mutation, RandomCompensationByRegisterIsAnswered) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    options.tools = ToolOffsets({{1, {Vec3(0), 4}}, {2, {Vec3(0), 1}}, {3, {Vec3(0), -2}}});
    for (unsigned seed = 1; seed <= 20000; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        options.dialect = seed % 3 == 0 ? DialectId::haas : DialectId::fanuc;
        ASSERT_NO_FATAL_FAILURE(check(randomByRegister(random), options));
        if (HasFailure())
            return;
    }
}

TEST(Mutation, RandomBytesAreAnswered) {
    for (unsigned seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        std::string text(random() % 400, '\0');
        for (char& c : text)
            c = static_cast<char>(random());
        ASSERT_NO_FATAL_FAILURE(check(text));
        if (HasFailure())
            return;
    }
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/tool_proposals.h"

#include <ctime>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace proveout {
namespace {

using testing::ElementsAre;

/// "T1 flat:d=6 @3": number, cutter and line of every proposal.
std::vector<std::string> proposalsOf(const std::string& text) {
    const ToolProposals proposals = proposeTools(NcText(text));
    std::vector<std::string> out;
    for (const auto& [number, cutter] : proposals.tools.tools())
        out.push_back(fmt::format("T{} {} @{}", number, cutter.spec(),
                                  proposals.tools.unconfirmedOrigin(number)->line));
    return out;
}

TEST(ToolProposals, AListInTheHeader) {
    const std::string text = "%\nO1001\n(T1 D=6. CR=0. - ZMIN=-5. - FLAT END MILL)\n"
                             "(T3 D=8. CR=4. - ZMIN=-9. - BALL END MILL)\nG21\nT1 M6\nG0 X1\nT3 M6\nG1 X2\n";
    EXPECT_THAT(proposalsOf(text), ElementsAre("T1 flat:d=6 @3", "T3 ball:d=8 @4"));
    const ToolProposals proposals = proposeTools(NcText(text));
    const ToolOrigin* origin = proposals.tools.unconfirmedOrigin(3);
    ASSERT_NE(origin, nullptr);
    EXPECT_EQ(origin->source, ToolSource::comment);
    EXPECT_EQ(origin->comment, "T3 D=8. CR=4. - ZMIN=-9. - BALL END MILL");
    EXPECT_THAT(proposals.called, ElementsAre(1, 3));
}

TEST(ToolProposals, AreInTheUnitOfTheProgram) {
    EXPECT_THAT(proposalsOf("(T3 D=0.125 CR=0.0625 - BALL END MILL)\nN10 G90\nN15 G20\nT3 M6\n"),
                ElementsAre("T3 ball:d=3.175 @1"));
    EXPECT_THAT(proposalsOf("G20\n(T1 D=3.175mm FLAT)\nT1 M6\n"), ElementsAre("T1 flat:d=3.175 @2"));
    EXPECT_THAT(proposalsOf("(T1 D=1 FLAT)\nT1 M6\n"), ElementsAre("T1 flat:d=1 @1")) << "no unit is mm";
    EXPECT_THAT(proposalsOf("G21\nT1 M6\nX1\nG20\nT2 M6 (D.5 ENDMILL)\n"), ElementsAre("T2 flat:d=12.7 @5"));
}

TEST(ToolProposals, ACommentWithoutANumberIsOfTheToolCalledBesideIt) {
    EXPECT_THAT(proposalsOf("T5 M6 (FREZA D10)\nG0 X1\n"), ElementsAre("T5 flat:d=10 @1"));
    EXPECT_THAT(proposalsOf("T5 M6 (D10)\nG0 X1\n"), ElementsAre("T5 flat:d=10 @1"));
    EXPECT_THAT(proposalsOf("(D10)\nT5 M6\nG0 X1\n"), ElementsAre("T5 flat:d=10 @1"));
    EXPECT_THAT(proposalsOf("(20mm ENDMILL)\nN110 T3 M06\nG0 X1\n"), ElementsAre("T3 flat:d=20 @1"));
    EXPECT_THAT(proposalsOf("T1\nM5\n(MSG, Change tool bit to drill size 0.6mm)\nM6\nG0 X1\n"
                            "T2\n(MSG, Change tool bit to drill size 0.8mm)\nM6\nX1\n"),
                ElementsAre("T1 drill:d=0.6,angle=118 @3", "T2 drill:d=0.8,angle=118 @7"));
    EXPECT_THAT(proposalsOf("T1 M6\nT2\n(6MM ENDMILL)\nG0 X1\nM6\nX2\n"), ElementsAre("T1 flat:d=6 @3"))
        << "T2 is selected for later";
}

TEST(ToolProposals, OfProgramsThatCallNoTool) {
    EXPECT_THAT(proposalsOf("(Tool: D = 3.0 mm  type END flutes 2)\nS12000M03\nG0 X1\n"),
                ElementsAre("T1 flat:d=3 @1"));
    EXPECT_THAT(proposalsOf("( T0 : 3.175 )\nG21\n( T0 : 3.175 )\nT0 M6\nG0 X1\n"),
                ElementsAre("T0 flat:d=3.175 @1"));
    EXPECT_THAT(
        proposalsOf("; Tool diameter: 2.0\nG1 X1\n; Tool diameter: 2.0\nG1 X2\n; Tool diameter: 5.0\nX3\n"),
        ElementsAre("T1 flat:d=2 @1", "T2 flat:d=5 @5"));
}

TEST(ToolProposals, MayBeWrittenOverSeveralLines) {
    EXPECT_THAT(proposalsOf("(*** TOOL DIAMETER = 12.0 ***)\n(*** TOOL LENGTH = 3.0 ***)\n"
                            "(*** TOOL NUMBER = 3 ***)\nG0 X1\n(*** TOOL DIAMETER = 6.0 ***)\n"
                            "(*** TOOL NUMBER = 1 ***)\nG0 X1\n"),
                ElementsAre("T1 flat:d=6 @5", "T3 flat:d=12 @1"));
    EXPECT_THAT(proposalsOf(";[Tool]\n;torus_radius = 0.25\n;speed = 1000.0\n;shape = CylindricalCutter\n"
                            ";tool_radius = 0.5\n;feedrate = 500.0\nG1 X1\n"),
                ElementsAre("T1 flat:d=1 @5"));
}

TEST(ToolProposals, WordsInNamesAndExpressionsCallNoTool) {
    const ToolProposals named = proposeTools(NcText("#<T5> = 1\no<T7> call [T9]\nIF [#1 GT 5] GOTO 12\n"));
    EXPECT_TRUE(named.called.empty());
    EXPECT_FALSE(named.callsComputed);
    EXPECT_TRUE(proposeTools(NcText("T#1113 M6\n")).callsComputed);
}

ToolTable tableOf(const std::string& spec) {
    ToolTable tools;
    tools.set(1, parseCutter(spec).value());
    return tools;
}

TEST(ToolProposals, FillTheTableWhereTheProgramCallsWhatItLacks) {
    const ToolProposals proposals =
        proposeTools(NcText("(T1 D=6 FLAT)\n(T2 D=8 FLAT)\n(T3 D=10 FLAT)\nT1 M6\nX1\nT2 M6\nX2\n"));
    ToolTable given = tableOf("ball:d=4");
    addProposals(given, proposals);
    EXPECT_EQ(given.find(1)->spec(), "ball:d=4") << "given tools win";
    EXPECT_EQ(given.unconfirmedOrigin(1), nullptr);
    ASSERT_NE(given.find(2), nullptr);
    EXPECT_EQ(given.unconfirmedOrigin(2)->line, 2U);
    EXPECT_EQ(given.find(3), nullptr) << "never called";

    ToolTable removed = given;
    removed.remove(2);
    addProposals(removed, proposals, proposals);
    EXPECT_EQ(removed.find(2), nullptr) << "the user does not want it";

    given.confirm(2);
    addProposals(given, proposeTools(NcText("(T2 D=9 FLAT)\nT2 M6\n")), proposals);
    EXPECT_EQ(given.find(2)->spec(), "flat:d=8") << "what is confirmed stays";
    ToolTable followed;
    addProposals(followed, proposals);
    addProposals(followed, proposeTools(NcText("\n(T2 D=9 FLAT)\nT2 M6\n")), proposals);
    EXPECT_EQ(followed.find(2)->spec(), "flat:d=9");
    EXPECT_EQ(followed.unconfirmedOrigin(2)->line, 2U);
}

TEST(ToolProposals, WhatWasEnteredStaysWhenTheTextIsReadAgain) {
    const ToolProposals proposals = proposeTools(NcText("(T2 D=8 FLAT)\nT2 M6\n"));
    ToolTable tools;
    addProposals(tools, proposals);
    ToolOrigin origin = *tools.unconfirmedOrigin(2);
    ASSERT_EQ(origin.defaults, std::vector<std::string>{"l"});
    origin.defaults.clear();
    origin.entered = {"l"};
    tools.set(2, parseCutter("flat:d=8,l=20").value(), origin);
    addProposals(tools, proposals, proposals);
    EXPECT_EQ(tools.find(2)->spec(), "flat:d=8,l=20");
    EXPECT_EQ(*tools.unconfirmedOrigin(2), origin);
    addProposals(tools, proposeTools(NcText("(T2 D=9 FLAT)\nT2 M6\n")), proposals);
    EXPECT_EQ(tools.find(2)->spec(), "flat:d=9,l=20");
}

TEST(ToolProposals, AToolOfAnotherProgramIsNotAddedBesideGivenOnes) {
    ToolTable tools = tableOf("ball:d=4");
    addProposals(tools, proposeTools(NcText("(Tool: D = 3.0 mm type END)\nG1 X1\n")));
    EXPECT_EQ(tools.tools().size(), 1U) << "the program calls none, and runs with the one that is given";
}

TEST(ToolProposals, HostileTextTakesBoundedTime) {
    std::string text;
    for (int i = 0; i < 400'000; ++i)
        text += fmt::format("(T{} D={} TOOL DRILL 1/2 BALL BULL 3MM)\n", i, i % 50 + 1);
    const std::clock_t begin = std::clock();
    const ToolProposals proposals = proposeTools(NcText(text));
    EXPECT_LE(proposals.tools.tools().size(), 1000U);
    EXPECT_LT(std::clock() - begin, 10 * CLOCKS_PER_SEC);
}

/// Regression test: each comment used to be compared with all cutters found before.
TEST(ToolProposals, CommentsAtEveryMotionTakeBoundedTime) {
    std::string text;
    for (int k = 0; k < 99'000; ++k)
        text += fmt::format("(D={:.2f} FLAT END MILL)\nX1\n", 1 + std::min(k, 998) * 0.01);
    const std::clock_t start = std::clock();
    EXPECT_EQ(proposeTools(NcText(text)).tools.tools().size(), 999U);
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 20);
}

/// Third-party programs whose tools are known: the proposals from comments must match.
TEST(ToolProposals, AgreeWithTheKnownToolsOfTheCorpus) {
    const std::filesystem::path corpus = std::filesystem::path(PROVEOUT_SHARED_DIR) / "corpus";
    if (!std::filesystem::exists(corpus / "JOBS.csv"))
        GTEST_SKIP() << "the corpus is not here";
    struct Known {
        const char* program;
        const char* shape;
        double diameter; ///< mm, as JOBS.csv has it
    };
    const Known known[] = {
        {"camotics/examples/genes-encoder/genes-encoder.ngc", "flat", 1.5875},
        {"linuxcnc-nc_files/nc_files/3D_Chips.ngc", "ball", 10},
        {"blendercam/patterns/Spiral.gcode", "flat", 3},
        {"easy_gcode_plot/PARALLEL.NC", "ball", 3.175},
        {"ugs/test_files/communicator.nc", "flat", 3.175},
        {"ugs/test_files/enclosure.nc", "flat", 1},
    };
    for (const Known& row : known) {
        const auto text = NcText::load(corpus / row.program);
        ASSERT_TRUE(text) << row.program;
        const ToolProposals proposals = proposeTools(*text);
        ASSERT_EQ(proposals.tools.tools().size(), 1U) << row.program;
        const Cutter& cutter = proposals.tools.tools().begin()->second;
        EXPECT_TRUE(cutter.spec().starts_with(row.shape)) << row.program << ": " << cutter.spec();
        EXPECT_NEAR(2 * cutter.radius(), row.diameter, 1e-6) << row.program;
    }
}

/// The comments of LinuxCNC's own tests and libraries mention diameters and tools without defining one.
TEST(ToolProposals, AreNoneInProseOfTheCorpus) {
    const std::filesystem::path library =
        std::filesystem::path(PROVEOUT_SHARED_DIR) / "corpus/linuxcnc-nc_files/nc_files/ngcgui_lib";
    if (!std::filesystem::exists(library))
        GTEST_SKIP() << "the corpus is not here";
    for (const auto& entry : std::filesystem::directory_iterator(library)) {
        // "use a 5mm tool"
        if (entry.path().extension() != ".ngc" || entry.path().filename() == "qpex_mm.ngc")
            continue;
        const auto text = NcText::load(entry.path());
        ASSERT_TRUE(text);
        const ToolProposals proposals = proposeTools(*text);
        for (const auto& [number, origin] : proposals.tools.unconfirmed())
            ADD_FAILURE() << entry.path() << ":" << origin.line << ": T" << number << " " << origin.comment;
    }
}

} // namespace
} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/dialects.h"
#include "core/nc/run/foreign_text.h"

#include <gtest/gtest.h>
#include <string>
#include <string_view>

#include "core/nc/run/resumable_interpreter.h"
#include "core/nc/text/glob.h"

namespace proveout {

namespace {

struct ForeignSample {
    const char* kind;
    int line; ///< line of the detected feature
    const char* text;
};

// Our own texts in the style of each control.
const ForeignSample kForeign[] = {
    {"a Heidenhain conversational program", 1,
     "0 BEGIN PGM PLATE MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 BLK FORM 0.2 X+100 Y+60 Z+0\n"
     "3 TOOL CALL 5 Z S4000\n4 L Z+100 R0 FMAX M3\n5 L X+10 Y+10 R0 FMAX\n6 END PGM PLATE MM\n"},
    {"a Heidenhain conversational program", 2,
     "; a part of a program\nL X+10 Y+5 FMAX M3\nCC X+20 Y+20\nC X+30 Y+20 DR-\n"},
    {"a Heidenhain DIN/ISO program", 1, "%PLATE G71 *\nN10 G30 G17 X+0 Y+0 Z-20 *\nN20 T5 G17 S4000 *\n"},
    {"a Siemens Sinumerik program", 1, "%_N_PLATE_MPF\n;$PATH=/_N_MPF_DIR\nN10 G17 G71 G90\nN20 M30\n"},
    {"a Siemens Sinumerik program", 2, "G17 G90 G54\nT=\"MILL 10\" D1 M6\nTRANS X20 Y10\nG0 X0 Y0\nM30\n"},
    {"a Siemens Sinumerik program", 3, "; finish\nG0 X0 Y0 Z5\nN30 CYCLE81(10,0,2,-12)\nM30\n"},
    {"a Siemens Sinumerik program", 2, "N5 G54 G0 X0 Y0\nN10 DEF REAL DEPTH=4.5\nN20 G1 Z=-DEPTH F200\n"},
    {"a Siemens Sinumerik program", 1, "R1=25 R2=-4\nG0 X=R1\nG2 X40 Y0 CR=20\nM17\n"},
    {"an Okuma OSP program", 1, "$SHAFT.MIN%\nG0 X500 Z500\nM2\n"},
    {"a WinCNC program", 1, "[SIGN WITH LETTERS]\nG90 [ABSOLUTE]\nT2 [TOOL 2]\nG0 X1\n"},
    {"a ShopBot program", 3, "'panel\nSA\nMS,3,1\nJZ,0.8\nJ2,1,1\nM3,1,1,-0.25\n"},
    {"a lathe program", 2, "O0100\nG50 S2500\nT0101\nG96 S180 M3\nG0 X52. Z2.\nG1 X-1. F0.2\nM30\n"},
    {"a lathe program", 3,
     "%\nO0100\nT0202\nG96 S180 M3\nG0 X52. Z2.\nG71 U2. R1.\nG71 P10 Q20 U0.4 W0.1 F0.25\nM30\n"},
    {"a 3D printer program", 1, ";FLAVOR:Marlin\nG28\nG1 X10 Y10 E0.4 F1200\n"},
    {"a 3D printer program", 1, "M104 S210\nG28 X0 Y0\nM109 S210\nG92 E0\nG1 X10 Y10 E0.4 F1200\n"},
    {"an APT or CL data file", 1, "PARTNO PLATE\nLOADTL/1,LENGTH,50\nFEDRAT/200,MMPM\nGOTO/0,0,10\nFINI\n"},
    {"a Gerber file", 2, "G04 outline*\n%FSLAX46Y46*%\n%MOMM*%\n%ADD10C,0.1*%\nD10*\nX0Y0D02*\nM02*\n"},
    {"an Excellon drill file", 1, "M48\nMETRIC,TZ\nT01C0.800\nT02C1.000\n%\nG90\nT01\nX12000Y4000\nM30\n"},
    {"an HPGL plot file", 1, "IN;SP1;\nPU100,100;\nPD400,100;\nPU;SP0;\n"},
    {"a CAMotics project", 3,
     "{\n  \"units\": \"metric\",\n  \"resolution-mode\": \"high\",\n  \"tools\": {}\n}\n"},
    {"a Proveout job", 2, "{\n  \"proveout\": 1,\n  \"program\": \"plate.nc\"\n}\n"},
    {"a JSON file", 1, "{\"a\": 1,\n \"b\": 2}\n"},
    {"an SVG drawing", 2, "<?xml version=\"1.0\"?>\n<svg width=\"10\" height=\"10\">\n</svg>\n"},
    {"an HTML page", 1, "<!DOCTYPE html>\n<html><body>Not found</body></html>\n"},
    {"an XML file", 1, "<?xml version=\"1.0\"?>\n<job/>\n"},
    {"an STL mesh", 1, "solid cube\n facet normal 0 0 1\n  outer loop\n"},
    {"an OBJ mesh", 2, "# cube\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"},
    {"a PLY mesh", 1, "ply\nformat ascii 1.0\nelement vertex 8\n"},
    {"a STEP model", 1, "ISO-10303-21;\nHEADER;\n"},
    {"a DXF drawing", 1, "0\nSECTION\n2\nHEADER\n"},
    {"a PostScript file", 1, "%!PS-Adobe-3.0\n"},
    {"a PDF document", 1, "%PDF-1.7\n1 0 obj\n"},
    {"a rich text document", 1, "{\\rtf1\\ansi G0 X0 Y0\\par}\n"},
};

// Texts that resemble those of another control at first sight.
const char* const kOurs[] = {
    "",
    "%\nO0001\nG0 X1.\nM30\n%\n",
    "G21\nG0 X0 Y0 (BEGIN PGM PLATE MM)\n; TOOL CALL 5 Z S4000\n; CYCLE81(10,0,2)\nM2\n",
    "(MSG,\"T=\")\n(CR=0.5)\n(T1 D=10. CR=0. - ZMIN=-5. - flat end mill)\nG1 X1 F100\nM2\n",
    "M48\nG21 G90\nG0 X1 Y2\nM2\n",
    "<PART-1>\nG0 X1.\nM30\n",
    "G18\nT0101\nG96 D2500 S180 M3\nG0 X52 Z2\nG76 P1 Z-20 I-1 J0.2 K0.6\nM2\n", // LinuxCNC turning
    "T0102 M6\nG50 S2500\nG0 X1 Y1\nM30\n",
    "G0(RAPID)X1(TO)Y2\nM30(END)\n",
    "#<depth> = 3\no<hole> sub\nG0 Z[-#<depth>]\no<hole> endsub\no<hole> call\nM2\n",
    "$H\nG21\nG0 X1\nM2\n",
    "O1000\nN10 IF [#1 EQ 1] GOTO 20\nR5. X1.\nN20 M30\n",
    "0\nG0 X1\n",
    "N1 G92 S2000\nG0 X1 Y1\nM30\n",
    "MFG,R1\nM3 S100\nM2\n",
};

} // namespace

TEST(ForeignText, IsNamedWithTheLineThatShowsIt) {
    for (const ForeignSample& sample : kForeign) {
        const auto found = findForeignText(NcText(sample.text));
        ASSERT_TRUE(found) << sample.text;
        EXPECT_STREQ(found->kind, sample.kind) << sample.text;
        EXPECT_EQ(found->line, sample.line) << sample.text;
        EXPECT_FALSE(found->sign.empty()) << sample.text;
    }
}

TEST(ForeignText, IsNotSeenInProgramsOfOurs) {
    for (const char* text : kOurs) {
        const auto found = findForeignText(NcText(text));
        EXPECT_FALSE(found) << found->kind << " in line " << found->line << " of\n" << text;
    }
}

TEST(ForeignText, IsSaidInOneSentenceAndNothingElse) {
    for (const ForeignSample& sample : kForeign) {
        InterpretOptions options;
        options.dialect.reset();
        ResumableInterpreter again;
        for (const auto& program :
             {interpret(NcText(sample.text), options), again.interpret(NcText(sample.text), options)}) {
            EXPECT_STREQ(program->foreignKind(), sample.kind);
            EXPECT_EQ(program->motionCount(), 0U);
            EXPECT_TRUE(program->unverified());
            ASSERT_EQ(program->diagnostics().size(), 1U) << sample.text;
            EXPECT_EQ(program->diagnostics().front().where.line, sample.line);
            EXPECT_EQ(program->diagnostics().front().severity, Severity::error);
        }
    }
}

TEST(ForeignText, SaysWhatItIsWhereAndWhatToDo) {
    InterpretOptions options;
    options.dialect.reset();
    const auto program = interpret(NcText(kForeign[0].text), options);
    const Diagnostic& problem = program->diagnostics().front();
    EXPECT_STREQ(problem.id, "dialect-foreign");
    EXPECT_EQ(message(problem), "This is a Heidenhain conversational program (line 1: 0 BEGIN PGM PLATE MM), "
                                "which Proveout does not read.");
    for (const Dialect& row : dialects())
        EXPECT_NE(hintText(problem).find(row.name), std::string::npos) << row.name;
    EXPECT_STREQ(interpret(NcText("<html>\n"), options)->diagnostics().front().id, "not-a-program");
}

TEST(ForeignText, IsReadAllTheSameWhereTheDialectIsChosen) {
    for (const ForeignSample& sample : kForeign) {
        for (const Dialect& row : dialects()) {
            InterpretOptions options;
            options.dialect = row.id;
            EXPECT_EQ(interpret(NcText(sample.text), options)->foreignKind(), nullptr) << sample.text;
        }
    }
}

TEST(ForeignText, IsReadAgainOnceItIsAProgram) {
    InterpretOptions options;
    options.dialect.reset();
    ResumableInterpreter interpreter;
    EXPECT_EQ(interpreter.interpret(NcText("G0 X1\nM2\n"), options)->motionCount(), 1U);
    EXPECT_NE(interpreter.interpret(NcText("END PGM A MM\nG0 X1\nM2\n"), options)->foreignKind(), nullptr);
    EXPECT_EQ(interpreter.interpret(NcText("G0 X1\nG0 X2\nM2\n"), options)->motionCount(), 2U);
}

TEST(ForeignText, HasNoValuesUnderThePointer) {
    InterpretOptions options;
    options.dialect.reset();
    options.watchedLine = 1;
    const auto program = interpret(NcText(kForeign[0].text), options);
    ASSERT_NE(program->lineValues(), nullptr);
    EXPECT_EQ(program->lineValues()->executions, 0U);
}

TEST(ForeignText, TakesNoLongOverHostileLines) {
    const std::string digits(2'000'000, '1');
    const std::string brackets(200'000, '(');
    for (const std::string& text : {digits, "CYCLE" + digits, brackets, std::string(1'000'000, '\n')})
        EXPECT_FALSE(findForeignText(NcText(text)));
}

TEST(Glob, MatchesTheWholeText) {
    EXPECT_TRUE(matchesGlob("BEGIN PGM ~", "BEGIN PGM 11 MM"));
    EXPECT_FALSE(matchesGlob("BEGIN PGM ~", "END PGM 11 MM"));
    EXPECT_TRUE(matchesGlob("~CYCLE#(~", "N10 CYCLE CYCLE83(1,2)"));
    EXPECT_FALSE(matchesGlob("G92S#", "G92S100X1"));
    EXPECT_TRUE(matchesGlob("T????", "T0101"));
    EXPECT_FALSE(matchesGlob("T????", "T010"));
    EXPECT_FALSE(matchesGlob("T????", "T01011"));
    EXPECT_TRUE(matchesGlob("%@ G71~\\*", "%PLATE G71 *"));
    EXPECT_TRUE(matchesGlob("~", ""));
    EXPECT_FALSE(matchesGlob("#", ""));
}

} // namespace proveout

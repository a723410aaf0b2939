// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/tool_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/cutter/default_spec.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

using testing::HasSubstr;

class ToolFile : public testing::Test {
protected:
    Result<ToolTable> read(const std::string& text) {
        m_folder.put("t.toml", text);
        return readToolFile(m_folder / "t.toml");
    }
    /// All messages, one "LINE:COLUMN sentence [id]" per line; empty if the table was read.
    std::string reported(const std::string& text) {
        const auto tools = read(text);
        std::string out;
        if (tools)
            return out;
        for (const Diagnostic& error : tools.error()) {
            EXPECT_EQ(error.file, (m_folder / "t.toml").string());
            EXPECT_EQ(error.severity, Severity::error);
            out += fmt::format("{}:{} {} [{}]\n", error.where.line, error.where.column, message(error),
                               error.id);
        }
        return out;
    }

    TemporaryFolder m_folder;
};

TEST_F(ToolFile, ReadsNumbersAndCutters) {
    const auto tools = read("# roughing\n[[tool]]\nnumber = 1\ncutter = \"ball:d=11,l=50\"\n\n"
                            "[[tool]]\ncutter = 'flat:d=6' # finishing\nnumber = 12\n");
    ASSERT_TRUE(tools) << oneLine(tools.error().front());
    ASSERT_EQ(tools->tools().size(), 2U);
    EXPECT_EQ(tools->find(1)->radius(), 5.5);
    EXPECT_EQ(tools->find(12)->spec(), "flat:d=6");
}

TEST_F(ToolFile, KeepsStickOutAndHolder) {
    const auto tools =
        read("[[tool]]\nnumber = 1\ncutter = \"ball:d=11,l=50,sd=12,so=60,holder=40x30+40-60x15\"\n");
    ASSERT_TRUE(tools) << oneLine(tools.error().front());
    EXPECT_EQ(tools->find(1)->body().stickOut, 60);
    ASSERT_EQ(tools->find(1)->body().holder.size(), 2U);
    EXPECT_EQ(tools->find(1)->body().holder[1].upperRadius, 30);
    EXPECT_THAT(reported("[[tool]]\nnumber = 1\ncutter = \"ball:d=11,so=60,holder=40\"\n"),
                HasSubstr("3:10 “40” is not a segment of a holder"));
}

TEST_F(ToolFile, KeepsHowAToolMayBeUsed) {
    const auto tools =
        read("[[tool]]\nnumber = 1\ncutter = \"flat:d=10,z=3,centre=0,ramp=5,maxap=4,maxchip=0.06\"\n");
    ASSERT_TRUE(tools) << oneLine(tools.error().front());
    EXPECT_EQ(tools->find(1)->data().teeth, 3);
    EXPECT_EQ(tools->find(1)->data().mostChip, 0.06);
    EXPECT_FALSE(tools->find(1)->data().centreCutting);
    EXPECT_THAT(reported("[[tool]]\nnumber = 1\ncutter = \"flat:d=10,maxchip=0.06\"\n"),
                HasSubstr("3:10 A maximum chip thickness, maxchip, needs the key z"));
}

TEST_F(ToolFile, MayMarkSizesAsNotConfirmed) {
    const auto tools = read("[[tool]]\nnumber = 1\ncutter = \"flat:d=6\"\nsource = \"assumed\"\n"
                            "[[tool]]\nnumber = 2\ncutter = \"flat:d=6\"\nsource = \"given\"\n"
                            "[[tool]]\nnumber = 3\ncutter = \"flat:d=6\"\n");
    ASSERT_TRUE(tools);
    ASSERT_EQ(tools->unconfirmed().size(), 1U);
    EXPECT_EQ(tools->unconfirmedOrigin(1)->source, ToolSource::assumed);
    EXPECT_THAT(reported("[[tool]]\nnumber = 1\ncutter = \"flat:d=6\"\nsource = \"me\"\n"),
                HasSubstr("[tool-source]"));
}

TEST_F(ToolFile, HoldsCuttersOfEveryShape) {
    std::string text;
    int number = 0;
    for (const CutterShape& shape : cutterShapes())
        text += fmt::format("[[tool]]\nnumber = {}\ncutter = \"{}\"\n", ++number, defaultSpecOf(shape));
    const auto tools = read(text);
    ASSERT_TRUE(tools) << oneLine(tools.error().front());
    number = 0;
    for (const CutterShape& shape : cutterShapes())
        EXPECT_EQ(tools->find(++number)->spec(), defaultSpecOf(shape));
}

TEST_F(ToolFile, ReportsAHundredErrorsAndHowManyMoreThereAre) {
    std::string text;
    for (int row = 0; row < 20'000; ++row)
        text += "[[tool]]\nnumber = -1\n";
    const auto tools = read(text);
    ASSERT_FALSE(tools);
    ASSERT_EQ(tools.error().size(), 101U);
    EXPECT_EQ(message(tools.error().back()), "19900 more messages are not shown.");
    EXPECT_EQ(tools.error().back().severity, Severity::error);
}

TEST_F(ToolFile, KeysOfARowThatAreNotKnownAreErrorsWithTheirPlace) {
    EXPECT_EQ(reported("[[tool]]\nnumber = 1\ncuter = \"ball:d=4\"\n"),
              "1:1 Tool 1 needs a cutter, e.g. cutter = \"ball:d=11,l=50\". [tool-cutter]\n"
              "3:1 “cuter” is not a key of a tool; perhaps “cutter” is meant. [tool-key-unknown]\n");
    EXPECT_EQ(reported("[[tool]]\nnumber = 1\ncutter = \"ball:d=4\"\n  flutes = 2\n"),
              "4:3 “flutes” is not a key of a tool; there are number, cutter, source. [tool-key-unknown]\n");
    EXPECT_EQ(reported("[[tool]]\nnumber = 1\ncutter = \"ball:d=4\"\nNumber = 2\n"),
              "4:1 “Number” is not a key of a tool; perhaps “number” is meant. [tool-key-unknown]\n");
}

TEST_F(ToolFile, TablesThatAreNotKnownAreErrorsWithTheirPlace) {
    const std::string row = "[[tool]]\nnumber = 1\ncutter = \"ball:d=4\"\n";
    EXPECT_EQ(reported(row + "[[tools]]\nnumber = 2\ncutter = \"ball:d=4\"\n"),
              "4:3 “tools” is not a table of a tool file; perhaps “tool” is meant. [tool-key-unknown]\n");
    EXPECT_EQ(reported("unit = \"mm\"\n" + row),
              "1:1 “unit” is not a table of a tool file; each tool is a [[tool]]. [tool-key-unknown]\n");
    EXPECT_EQ(reported(row + "[tool.holder]\nd = 40\n"),
              "4:7 “holder” is not a key of a tool; there are number, cutter, source. [tool-key-unknown]\n");
    EXPECT_EQ(reported("[machine]\nname = \"x\"\n"),
              "0:0 The file holds no [[tool]] tables. [tool-file-empty]\n"
              "1:2 “machine” is not a table of a tool file; each tool is a [[tool]]. [tool-key-unknown]\n");
}

TEST_F(ToolFile, KeysOfACutterThatAreNotKnownAreErrorsAtTheCutter) {
    EXPECT_THAT(reported("[[tool]]\nnumber = 1\ncutter = \"ball:d=4,x=3\"\n"),
                testing::MatchesRegex("3:10 .*“x” is not a key .*\\[cutter-key-unknown\\]\n"));
}

TEST_F(ToolFile, AllErrorsAreReportedAtOnceInTheOrderOfTheText) {
    EXPECT_EQ(reported("[[tool]]\nnumber = -1\ncutter = \"ball:d=4\"\n"
                       "[[tool]]\nnumber = 3\n"
                       "[[tool]]\nnumber = \"4\"\ncolour = 1\n"
                       "[[tool]]\nnumber = 3\ncutter = \"ball:d=4\"\n"
                       "[[tool]]\ncutter = \"ball:d=4\"\n"),
              "2:10 A tool needs a number, a whole one from 0 to 99999999. [tool-number]\n"
              "4:1 Tool 3 needs a cutter, e.g. cutter = \"ball:d=11,l=50\". [tool-cutter]\n"
              "7:10 A tool needs a number, a whole one from 0 to 99999999. [tool-number]\n"
              "8:1 “colour” is not a key of a tool; there are number, cutter, source. [tool-key-unknown]\n"
              "10:10 Tool 3 is in the table twice. [tool-twice]\n"
              "12:1 A tool needs a number, a whole one from 0 to 99999999. [tool-number]\n");
}

TEST_F(ToolFile, OtherFilesAreRefused) {
    EXPECT_THAT(reported(""), HasSubstr("0:0 The file holds no [[tool]] tables. [tool-file-empty]"));
    EXPECT_THAT(reported("[tool]\nnumber = 1\n"), HasSubstr("[tool-file-empty]"));
    EXPECT_THAT(reported("tool = [1, 2]\n"), HasSubstr("1:9 A tool must be a table: [[tool]]. [tool-row]"));
    EXPECT_THAT(reported("[[tool]]\nnumber = 1\ncutter = \"ball:d=4\n"), HasSubstr("3:"));
    EXPECT_THAT(reported("[[tool]]\nnumber = 1\nnumber = 2\n"), HasSubstr("[tool-file-syntax]"));
    EXPECT_STREQ(readToolFile(m_folder / "missing.toml").error().front().id, "file-unreadable");
}

} // namespace
} // namespace proveout

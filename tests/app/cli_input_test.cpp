// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input: each case has a message with its location, and its exit code.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sstream>

#include "tests/app/command_line.h"

namespace proveout {
namespace {

using testing::HasSubstr;

class CliInput : public CommandLine {
protected:
    Finished simulate(const std::string& program, const std::string& more = "") {
        write("p.nc", program);
        return run("simulate p.nc" + kStock + kTool + more);
    }
};

TEST_F(CliInput, MissingFile) {
    const auto done = run("simulate none.nc" + kStock + kTool);
    EXPECT_EQ(done.exitCode, 3);
    EXPECT_TRUE(done.reports("none.nc: error: ", "file-unreadable")) << done.err;
    EXPECT_EQ(done.err,
              "none.nc: error: The file cannot be read: No such file or directory. [file-unreadable]\n");
    EXPECT_EQ(run("interpret none.nc").exitCode, 3);
    EXPECT_EQ(run("decimate none.npy --grid 1").exitCode, 3);
}

TEST_F(CliInput, FolderAndBinaryFile) {
    const auto refused = run("simulate ." + kStock + kTool);
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_EQ(refused.err, ".: error: This is a folder, not a file. [file-not-regular]\n");
    const auto done = simulate(std::string("G0\0\1\2\3 X1", 10));
    EXPECT_EQ(done.exitCode, 3);
    EXPECT_EQ(done.err, "p.nc: error: This is not an NC program: it holds binary data. [nc-binary]\n")
        << "about the whole file, so without a place";
    EXPECT_EQ(simulate(std::string("\xff\xfeG\0000\0", 6)).err,
              "p.nc: error: The file is encoded in UTF-16 LE, not in ASCII or UTF-8. [nc-encoding]\n");
}

TEST_F(CliInput, BinaryFilesAreNamed) {
    EXPECT_EQ(simulate("\x89PNG\r\n\x1a\n").err,
              "p.nc: error: This is a PNG picture, not an NC program. [nc-binary]\n");
    EXPECT_THAT(simulate(std::string("PK\3\4\0\0", 6)).err, HasSubstr("a ZIP archive"));
    EXPECT_THAT(simulate(std::string(80, 'x') + std::string("\1\0\0\0", 4) + std::string(50, '\0')).err,
                HasSubstr("an STL mesh"));
}

TEST_F(CliInput, AProgramOfAnotherControlIsNamedOnce) {
    const std::string program = "0 BEGIN PGM A MM\n1 TOOL CALL 5 Z S4000\n2 L X+10 Y+10 R0 FMAX\n";
    const std::string sentence =
        "p.nc:1:1: error: This is a Heidenhain conversational program (line 1: 0 BEGIN "
        "PGM A MM), which Proveout does not read. [dialect-foreign]\n";
    const auto done = simulate(program, "--json");
    EXPECT_EQ(done.exitCode, 3);
    EXPECT_EQ(done.err, sentence);
    EXPECT_THAT(done.out, HasSubstr("for one of these dialects: LinuxCNC, Fanuc, Haas"));
    EXPECT_EQ(run("interpret p.nc").err, sentence);
    EXPECT_EQ(run("interpret p.nc").exitCode, 3);
    // An explicit dialect makes the program acceptable.
    const auto read = run("simulate p.nc --dialect linuxcnc" + kStock + kTool);
    EXPECT_EQ(read.exitCode, 2);
    EXPECT_THAT(read.err, testing::Not(HasSubstr("dialect-foreign")));
}

TEST_F(CliInput, FiguresHaveAPoint) {
    const auto done = simulate("G21 G90\nT1 M6\nF100 G0 X0 Y0 Z5\nG2 X10 Y0 I4.75 J0\nM30\n", "--json");
    EXPECT_THAT(done.err, testing::AllOf(HasSubstr("4.75"), HasSubstr("5.25")));
    EXPECT_THAT(done.out, testing::AllOf(HasSubstr("4.75"), HasSubstr("5.25")));
}

TEST_F(CliInput, MCodesThatMoveNoAxisAreIgnoredAndListed) {
    const std::string program = "%\nO1\nG21 G90\nT1 M6\nM11\nG0 X5. Y5. Z5.\nM10\nM16\nG1 Z-2. F100 S500 M3\n"
                                "X30.\nG0 Z5.\nM30\n%\n";
    const auto unknown = simulate(program, "--dialect fanuc --json");
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_TRUE(unknown.reports("p.nc:8:1: error: M16 ", "code-unknown")) << unknown.err;
    const auto done = simulate(program, "--dialect fanuc --ignore-m 16 --json");
    EXPECT_EQ(done.exitCode, 0) << done.err;
    EXPECT_TRUE(done.reports("p.nc:8:1: note: M16 is ignored", "code-ignored")) << done.err;
    EXPECT_TRUE(done.json()["unverified"].empty());
    const auto listed = done.json()["ignoredCodes"];
    ASSERT_EQ(listed.size(), 3U);
    EXPECT_EQ(listed[0]["code"], "M10");
    EXPECT_EQ(listed[0]["by"], "dialect");
    EXPECT_EQ(listed[2],
              (nlohmann::json{
                  {"code", "M16"}, {"meaning", nullptr}, {"by", "setup"}, {"count", 1}, {"lines", {8}}}));
    EXPECT_GT(done.json()["removedMm3"], 0);
    const auto bad = run("interpret p.nc --ignore-m G16");
    EXPECT_EQ(bad.exitCode, 3);
    EXPECT_TRUE(bad.reports("proveout-cli: error: --ignore-m: ", "m-code-list")) << bad.err;
}

TEST_F(CliInput, NoMotionIsAWarningAndUnverified) {
    for (const char* program : {"", "%\n%\n", "(nothing)\nM30\n"}) {
        const auto done = simulate(program, "--json");
        EXPECT_EQ(done.exitCode, 2) << program;
        EXPECT_THAT(done.err, HasSubstr("warning: ")) << program;
        EXPECT_THAT(done.err, HasSubstr("[no-motion]")) << program;
        EXPECT_EQ(done.json()["motions"], 0) << program;
        EXPECT_EQ(run("interpret p.nc").exitCode, 2) << program;
    }
}

TEST_F(CliInput, ToolWithoutACutterIsUnverified) {
    const auto done = simulate("T7 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX30\n", "--json");
    EXPECT_EQ(done.exitCode, 2);
    EXPECT_TRUE(done.reports("p.nc:2:1: error: ", "tool-undefined")) << done.err;
    EXPECT_EQ(done.json()["removedMm3"], 0);
    ASSERT_FALSE(done.json()["unverified"].empty());
    EXPECT_EQ(done.json()["unverified"][0]["id"], "tool-undefined");
    EXPECT_EQ(done.json()["unverified"][0]["line"], 2);
}

TEST_F(CliInput, AToolOfACommentIsUsedAndWhatItFindsIsUnverified) {
    const std::string program = "(T7 D=4. CR=0. - FLAT END MILL)\nG21 G90\nT7 M6\nG0 X5 Y5 Z5\nZ-3\nM30\n";
    const auto done = simulate(program, "--json");
    EXPECT_EQ(done.exitCode, 2) << done.err;
    EXPECT_TRUE(done.reports("p.nc:1:1: warning: ", "tool-unconfirmed")) << done.err;
    EXPECT_TRUE(done.reports("p.nc:5:1: warning: ", "rapid-cuts")) << done.err;
    EXPECT_GT(done.json()["removedMm3"], 0);
    const auto tools = done.json()["tools"];
    for (const auto& tool : tools)
        if (tool["number"] == 7) {
            EXPECT_EQ(tool["cutter"], "flat:d=4");
            EXPECT_EQ(tool["source"], "comment");
            EXPECT_EQ(tool["line"], 1);
            EXPECT_EQ(tool["comment"], "T7 D=4. CR=0. - FLAT END MILL");
        }
    // The same tool, defined by the user.
    const auto given = simulate(program, "--json --tool 7=flat:d=4");
    EXPECT_EQ(given.exitCode, 1) << given.err;
    EXPECT_TRUE(given.reports("p.nc:5:1: fault: ", "rapid-cuts")) << given.err;
    const auto other = simulate(program, "--json --tool 7=ball:d=6").json()["tools"];
    EXPECT_NE(other.dump().find("ball:d=6"), std::string::npos) << "given tools win";
    EXPECT_EQ(other.dump().find("flat:d=4"), std::string::npos);
}

TEST_F(CliInput, MotionBeforeFAndArcThatDoesNotFitAreUnverified) {
    const auto noFeed = simulate("T1 M6\nG0 X5 Y5 Z5\nG1 Z-2\nM30\n");
    EXPECT_EQ(noFeed.exitCode, 2);
    EXPECT_THAT(noFeed.err, HasSubstr("p.nc:3:1: error: ")) << noFeed.err;
    EXPECT_THAT(noFeed.err, HasSubstr("[feed-missing]"));
    const auto badArc = simulate("T1 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nG2 X20 Y9 I1 J1\nM30\n");
    EXPECT_EQ(badArc.exitCode, 2);
    EXPECT_THAT(badArc.err, HasSubstr("p.nc:4:"));
    EXPECT_THAT(badArc.err, HasSubstr("[arc-ends-differ]"));
}

TEST_F(CliInput, RapidThatCutsIsAFaultAndOutranksUnverified) {
    const auto done = simulate("T1 M6\nG0 X5 Y5 Z5\nZ-3\nG1 X9\nM30\n", "--json");
    EXPECT_EQ(done.exitCode, 1);
    EXPECT_TRUE(done.reports("p.nc:3:1: fault: ", "rapid-cuts")) << done.err;
    EXPECT_THAT(done.err, HasSubstr("[feed-missing]"));
    const auto json = done.json();
    EXPECT_EQ(json["findings"][0]["id"], "rapid-cuts");
    EXPECT_EQ(json["findings"][0]["severity"], "fault");
    EXPECT_FALSE(json["unverified"].empty());
}

TEST_F(CliInput, ShankAndHolderInTheStockAreFaults) {
    write("p.nc", "T1 M6\nG0 X20 Y15 Z5\nG1 Z-6 F100\nG0 Z5\nM30\n");
    const std::string simulated = "simulate p.nc --stock 40x30x10 --tool 1=flat:d=4,l=7";
    const auto holder = run(simulated + ",so=5,holder=20x30 --json");
    EXPECT_EQ(holder.exitCode, 1) << holder.err;
    EXPECT_TRUE(holder.reports("p.nc:3:1: fault: The holder collides with the stock, 1.000 mm deep at X",
                               "holder-collision"))
        << holder.err;
    EXPECT_EQ(holder.json()["findings"][0]["id"], "holder-collision");
    EXPECT_EQ(holder.json()["tools"][0]["cutter"], "flat:d=4,l=7,so=5,holder=20x30");
    const auto shank = run(simulated + ",sd=6,so=6.5 --until 2");
    EXPECT_EQ(shank.exitCode, 0) << shank.err;
    const auto deep = run("simulate p.nc --stock 40x30x10 --tool 1=flat:d=4,l=5.5,sd=6");
    EXPECT_EQ(deep.exitCode, 1);
    EXPECT_TRUE(deep.reports("p.nc:3:1: fault: The shank collides with the stock, 0.500 mm deep at X",
                             "shank-collision"))
        << deep.err;
}

TEST_F(CliInput, UnwritableOutputIsReportedBeforeTheRun) {
    const auto done = simulate("T1 M6\nG0 X5 Y5 Z5\nZ-3\nM30\n", "--stl none/a.stl --json");
    EXPECT_EQ(done.exitCode, 3);
    EXPECT_TRUE(done.reports("none/a.stl: error: ", "file-unwritable")) << done.err;
    EXPECT_THAT(done.err, testing::Not(HasSubstr("[rapid-cuts]")));
    for (const char* output : {"--zmap none/a.npy", "--records none/a.csv", "--stl ."})
        EXPECT_EQ(simulate(kSound, output).exitCode, 3) << output;
}

TEST_F(CliInput, GridTooFineForTheMachineNamesOneThatFits) {
    const auto huge = run("simulate " + write("p.nc", kSound) + " --stock 4000x3000x10 --grid 0.005" + kTool);
    EXPECT_EQ(huge.exitCode, 3);
    EXPECT_THAT(huge.err, HasSubstr("finest"));
    EXPECT_THAT(huge.err, testing::ContainsRegex("[0-9.]+ [GT]B"));
    const auto absurd = run("simulate p.nc --stock 1e9x1e9x10 --grid 1e-9" + kTool);
    EXPECT_EQ(absurd.exitCode, 3);
    EXPECT_THAT(absurd.err, HasSubstr("error: "));
}

TEST_F(CliInput, OutputsNeverOverwriteInputs) {
    write("p.nc", kSound);
    for (const char* output : {"--stl p.nc", "--records ./p.nc", "--stl a.x --zmap a.x"}) {
        const auto done = run("simulate p.nc" + kStock + kTool + output);
        EXPECT_EQ(done.exitCode, 3) << output;
        EXPECT_THAT(done.err, HasSubstr("[output-overwrites]")) << output;
        EXPECT_EQ(read("p.nc"), kSound) << output;
    }
}

TEST_F(CliInput, BrokenToolTablesNameTheirPlace) {
    write("p.nc", kSound);
    const auto report = [this](const std::string& table, const std::string& start, const std::string& id) {
        write("t.toml", table);
        const auto done = run("simulate p.nc --tools t.toml" + kStock);
        EXPECT_EQ(done.exitCode, 3) << table;
        EXPECT_TRUE(done.reports(start, id)) << done.err;
    };
    report("[[tool]]\nnumber = 1\ncutter = \"ball:d=4\n", "t.toml:3:", "tool-file-syntax");
    report("x = 1\n", "t.toml: error", "tool-file-empty");
    report("\n[[tool]]\nnumber = -1\ncutter = \"ball:d=4\"\n", "t.toml:3:10: error", "tool-number");
    report("[[tool]]\nnumber = 1\n", "t.toml:1:", "tool-cutter");
    report("[[tool]]\nnumber = 1\ncutter = \"star:d=4\"\n", "t.toml:3:10: error", "cutter-shape-unknown");
    const std::string row = "[[tool]]\nnumber = 1\ncutter = \"ball:d=4\"\n";
    report(row + row, "t.toml:5:10: error", "tool-twice");
    report(row + "lenght = 50\n", "t.toml:4:1: error", "tool-key-unknown");
}

TEST_F(CliInput, ProgramsNeedNotBeUtf8) {
    // Latin-1: in comments it is ignored, elsewhere the byte is reported.
    const auto fine =
        simulate("(Fr\xe4ser \xd8 4)\nT1 M6\nG0 X5 Y5 Z5 ; \374ber\nG1 Z-2 F100\nM30\n", "--json");
    EXPECT_EQ(fine.exitCode, 0) << fine.err;
    EXPECT_EQ(fine.json()["motions"], 2);
    EXPECT_EQ(run("interpret p.nc").exitCode, 0);
    const auto reported = simulate("T1 M6\nG0 X5 Y5 Z5\n\xe4X6\nM30\n", "--json");
    EXPECT_EQ(reported.exitCode, 2);
    EXPECT_TRUE(reported.reports("p.nc:3:1: error: \"\\xe4\" has no meaning here.", "bad-character"))
        << reported.err;
    EXPECT_FALSE(reported.json().is_discarded());
    const auto records = run("interpret p.nc");
    EXPECT_EQ(records.exitCode, 2);
    std::istringstream lines(records.out);
    for (std::string line; std::getline(lines, line);)
        EXPECT_FALSE(nlohmann::json::parse(line, nullptr, false).is_discarded()) << line;
}

TEST_F(CliInput, FileNamesNeedNotBeUtf8) {
    const std::string name = "p\xff\xfe.nc";
    write(name, "T7 M6\nG0 X1 Y1 Z1\nX2\n");
    const auto done = run("simulate '" + name + "' --json" + kStock + kTool);
    EXPECT_EQ(done.exitCode, 2);
    EXPECT_FALSE(done.json().is_discarded());
    EXPECT_EQ(run("interpret '" + name + "'").exitCode, 0);
}

} // namespace
} // namespace proveout

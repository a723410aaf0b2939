// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <sstream>

#include "tests/app/command_line.h"

namespace proveout {
namespace {

class CliInterpret : public CommandLine {
protected:
    std::vector<nlohmann::json> lines(const std::string& program, const std::string& more = "") {
        write("p.nc", program);
        finished = run("interpret p.nc " + more);
        std::vector<nlohmann::json> records;
        std::istringstream text(finished.out);
        for (std::string line; std::getline(text, line);)
            records.push_back(nlohmann::json::parse(line));
        return records;
    }
    Finished finished;
};

TEST_F(CliInterpret, PrintsMotionsAndEventsInOrder) {
    const auto records = lines(kSound);
    EXPECT_EQ(finished.exitCode, 0) << finished.err;
    ASSERT_EQ(records.size(), 9U);
    EXPECT_EQ(records.front()["k"], "meta");
    EXPECT_EQ(records.front()["format"], "nc-motion/1");
    EXPECT_EQ(records[1]["k"], "tool");
    EXPECT_EQ(records[1]["t"], 1);
    EXPECT_EQ(records[2]["k"], "rapid");
    EXPECT_EQ(records[2]["e"], (nlohmann::json{5, 5, 5}));
    EXPECT_EQ(records[5]["k"], "arc");
    EXPECT_EQ(records[5]["l"], 6);
    EXPECT_EQ(records.back()["k"], "sum");
}

TEST_F(CliInterpret, StartIsAssumedAtZeroUnlessGiven) {
    const auto assumed = lines("G91 G1 X10 F100\nM2\n");
    EXPECT_EQ(finished.exitCode, 0) << finished.err;
    EXPECT_EQ(assumed[1]["e"], (nlohmann::json{10, 0, 0}));
    const auto reported = lines("G91 G1 X10 F100\nM2\n", "--start 1,2,3");
    EXPECT_EQ(finished.exitCode, 0) << finished.err;
    EXPECT_EQ(reported[1]["e"], (nlohmann::json{11, 2, 3}));
}

TEST_F(CliInterpret, WordsThatAreNotUnderstoodExitWith2) {
    lines("G0 X1\nG68 X3 R4\nX5\nM2\n", "--dialect linuxcnc");
    EXPECT_EQ(finished.exitCode, 2);
    EXPECT_THAT(finished.err, testing::HasSubstr("p.nc:2:"));
    EXPECT_THAT(finished.err, testing::HasSubstr("G68"));
}

TEST_F(CliInterpret, ToolsAreKnownUnlessATableSaysOtherwise) {
    lines("T5 M6\nG0 X1 Y1 Z1\nM2\n");
    EXPECT_EQ(finished.exitCode, 0) << finished.err;
    write("t.toml", "[[tool]]\nnumber = 1\ncutter = \"ball:d=4\"\n");
    lines("T5 M6\nG0 X1 Y1 Z1\nT1 M6\nG0 X2\nT5 M6\nG0 X3\nM2\n", "--tools t.toml");
    EXPECT_EQ(finished.exitCode, 2);
    EXPECT_EQ(finished.err, "p.nc:2:1: error: T5 is not in the tool table; its moves are not simulated. "
                            "[tool-undefined]\n")
        << "once, where it is missed first";
}

TEST_F(CliInterpret, DialectIsChosenOrGuessed) {
    EXPECT_EQ(lines("G90 G0 X1000\nM30\n", "--dialect linuxcnc")[1]["e"], (nlohmann::json{1000, 0, 0}));
    EXPECT_EQ(lines("G90 G0 X1000\nM30\n", "--dialect fanuc")[1]["e"], (nlohmann::json{1, 0, 0}));
    lines("O1 (HOLES)\nG65 P2 X5.\nM30\nO2\nG0 X#24\nM99\n");
    EXPECT_EQ(finished.exitCode, 0) << finished.err;
    EXPECT_THAT(finished.err, testing::HasSubstr("Dialect detected: Fanuc"));
    EXPECT_THAT(finished.err, testing::HasSubstr("G65P2X5. (2)"));
    EXPECT_EQ(lines("G21 G0 X5\nG12 I2 F100\nM30\n", "--dialect mach").size(), 7U);
    EXPECT_EQ(lines("X10\nM30\n", "--dialect grbl")[1]["e"], (nlohmann::json{10, 0, 0}));
    EXPECT_EQ(run("interpret p.nc --dialect basic").exitCode, 3);
}

TEST_F(CliInterpret, TheStartOfCompensationIsOfTypeAOrB) {
    const std::string program = "G90 G1 G42 D1 X0 Y0 F100\nX-20. Y20.\nG40 X0\nM30\n";
    const std::string options = "--start=-20,0,0 --tool 1=flat:d=10 --dialect ";
    const auto ends = [&](const std::string& more) {
        std::vector<nlohmann::json> points;
        for (const auto& record : lines(program, options + more))
            if (record["k"] == "feed")
                points.push_back(record["e"]);
        return points;
    };
    const auto typeA = ends("fanuc");
    EXPECT_EQ(typeA.size(), 3U);
    EXPECT_EQ(ends("fanuc --compensation-start a"), typeA);
    for (const std::string control : {"fanuc", "haas"}) {
        const auto typeB = ends(control + " --compensation-start b");
        ASSERT_EQ(typeB.size(), 4U) << control << ": it goes round the corner";
        EXPECT_EQ(typeB.front(), (nlohmann::json{5, -5, 0}));
        EXPECT_EQ(finished.err.find("compensation-start"), std::string::npos) << finished.err;
    }
    for (const std::string control : {"linuxcnc", "grbl", "mach"}) {
        const auto before = ends(control);
        const int exitCode = finished.exitCode;
        EXPECT_EQ(ends(control + " --compensation-start b"), before) << control;
        EXPECT_EQ(finished.exitCode, exitCode);
        EXPECT_TRUE(finished.reports("p.nc: warning: Cutter compensation start-up type B ",
                                     "compensation-start-unused"))
            << finished.err;
    }
}

TEST_F(CliInterpret, DialectsAreComparedLineByLine) {
    const auto records = lines("G21 G90\nG0 X1.\nX2000\nM30\n", "--compare-dialects linuxcnc,fanuc");
    EXPECT_EQ(finished.exitCode, 0) << finished.err;
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[0]["l"], 3);
    EXPECT_EQ(records[0]["src"], "X2000");
    EXPECT_EQ(records[0]["linuxcnc"][0]["e"], (nlohmann::json{2000, 0, 0}));
    EXPECT_EQ(records[0]["fanuc"][0]["e"], (nlohmann::json{2, 0, 0}));
    EXPECT_EQ(records[1]["differs"], 1);
    EXPECT_EQ(run("interpret p.nc --compare-dialects linuxcnc").exitCode, 3);
}

TEST_F(CliInterpret, DialectsAndRulesAreListedFromTheirTables) {
    std::vector<std::string> keys;
    const auto listed = run("dialects --json").json();
    for (const auto& row : listed["dialects"])
        keys.push_back(row["key"]);
    EXPECT_THAT(keys, testing::ElementsAre("linuxcnc", "fanuc", "haas", "grbl", "mach"));
    EXPECT_THAT(run("dialects").out, testing::HasSubstr("Fanuc"));
    EXPECT_THAT(run("rules").out, testing::HasSubstr("length-missing"));
    EXPECT_GT(run("rules --json").json()["rules"].size(), 10U);
}

TEST_F(CliInterpret, ProbesTheStockThatIsGiven) {
    const std::string program = "T2 M6\nG0 X10 Y15 Z5\nG38.2 Z-8 F50\nG0 Z5\nM2\n";
    const auto probing = [](const std::vector<nlohmann::json>& records) {
        return *std::ranges::find(records, "probe", [](const auto& record) { return record["k"]; });
    };
    EXPECT_EQ(probing(lines(program))["e"], (nlohmann::json{10, 15, -8}));
    EXPECT_EQ(finished.exitCode, 2);
    const std::string stock = "--stock 40x30x10 --stock-origin 0,0,-1 --tool 2=ball:d=6";
    EXPECT_NEAR(probing(lines(program, stock))["e"][2].get<double>(), -1, 2e-3);
    EXPECT_EQ(finished.exitCode, 0) << finished.err;
    EXPECT_THAT(finished.err, testing::HasSubstr("X10.000 Y15.000 Z-1.000"));
}

} // namespace
} // namespace proveout

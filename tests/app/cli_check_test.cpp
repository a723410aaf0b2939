// SPDX-License-Identifier: GPL-3.0-or-later
// The command check: programs with one planted fault, and the same programs without it.
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/app/command_line.h"

namespace proveout {
namespace {

const std::string kAcceptAll = " --accept "
                               "holder-not-given,shank-not-given,fixtures-not-given,travel-not-given,machine-"
                               "not-given,tool-limits-not-given ";

class CliCheck : public CommandLine {
protected:
    /// The ids of the findings of a program, and its verdict first.
    std::set<std::string> judged(const std::string& text, const std::string& options) {
        const nlohmann::json result =
            run("check " + write("part.nc", text) + options + kAcceptAll + "--json").json();
        std::set<std::string> ids;
        if (!result.is_object())
            return ids;
        ids.insert(result["verdict"].get<std::string>());
        for (const nlohmann::json& finding : result["findings"]) {
            ids.insert(finding["id"].get<std::string>());
            m_last[finding["id"].get<std::string>()] = finding;
        }
        return ids;
    }
    std::map<std::string, nlohmann::json> m_last; ///< the finding of an id
};

using Ids = std::set<std::string>;
const std::string kHead = "G21 G90 G17\nT1 M6\nS1000 M3\nG0 X5 Y5 Z5\n";
const std::string kEnd = "G0 Z5\nM5\nM30\n";
const std::string kSafe = kHead + "G1 Z-2 F100\nX20\n" + kEnd;

TEST_F(CliCheck, AJobKeepsWhatSomebodyAnswersFor) {
    write("part.nc", kHead + "G1 Z-2 F100\nX10\nG0 X20\n" + kEnd);
    const auto job = [&](const std::string& check) {
        return write("part.proveout", R"({"proveout": 2, "program": "part.nc", "grid": 0.5,
            "stock": {"width": 40, "depth": 30, "height": 10}, "tools": {"1": "ball:d=4,l=20"}, "check": )" +
                                          check + "}");
    };
    const std::string accepted = R"("accepted": {"holder-not-given": "short", "shank-not-given": "",
        "fixtures-not-given": "", "travel-not-given": "", "machine-not-given": "", "tool-limits-not-given": ""})";
    EXPECT_EQ(run("check " + job("{" + accepted + "}")).exitCode, 1);
    const std::string waived = job("{" + accepted + R"(, "waivers": {"1": {"finding": "rapid-cuts", "tool": 1,
        "values": "2.000", "place": [16, 5, -2], "reason": "a hole is there", "owner": "M. Roth"}}})");
    EXPECT_EQ(run("check part.proveout --json").json()["findings"][0]["values"], "2.000");
    EXPECT_EQ(run("check part.proveout --json").json()["findings"][0]["cutter"], "ball:d=4,l=20");
    const Finished done = run("check " + waived + " --sarif out.sarif --json");
    EXPECT_EQ(done.exitCode, 0) << done.out << done.err;
    EXPECT_EQ(done.json()["findings"][0]["waived"]["owner"], "M. Roth");
    EXPECT_EQ(done.json()["notChecked"][0]["reason"], "short");
    EXPECT_NE(done.err.find("part.nc:7:1: note: "), std::string::npos) << done.err;
    const nlohmann::json result = nlohmann::json::parse(read("out.sarif"))["runs"][0]["results"][0];
    EXPECT_EQ(result["suppressions"][0]["justification"], "M. Roth: a hole is there");
    EXPECT_EQ(run("check " + job("{" + accepted + R"(, "off": {"rapid-cuts:T1": "dry run"}})")).exitCode, 0);
    EXPECT_EQ(run("check " + job("{" + accepted + R"(, "off": {"rapid-cuts:T2": "dry run"}})")).exitCode, 1);
    EXPECT_EQ(run("check part.proveout --rules rapid-cuts:T1=off").exitCode, 0) << "options add to the job";
}

TEST_F(CliCheck, APlantedFaultIsFoundAtItsLineAndItsTwinIsSafe) {
    struct Case {
        const char* id;
        const char* verdict;
        std::string faulty;
        std::string clean;
        int line;
        double value;
        const char* tool = "ball:d=4,l=20";
    };
    const std::vector<Case> cases{
        {"rapid-cuts", "faults", "G1 Z-2 F100\nX10\nG0 X20\n", "G1 Z-2 F100\nX10\nX20\n", 7, 2},
        {"spindle-stopped", "faults", "G1 Z-2 F100\nM5\nX20\n", "G1 Z-2 F100\nX20\n", 7, 2},
        {"spindle-reversed", "faults", "M4\nG1 Z-2 F100\nX20\n", "M3\nG1 Z-2 F100\nX20\n", 6, 2},
        {"plunge-not-allowed", "faults", "G1 Z-3 F100\nX20\n", "G1 Z-3 F100\nG0 Z5\nX20\n", 6, 3,
         "drill:d=4,angle=118,l=20"},
        {"table-collision", "faults", "G1 Z-14 F100\n", "G1 Z-12 F100\n", 5, 4},
        {"nothing-cut", "unverified", "G1 X-1.7 Z-2 F800\nZ1\n", "G1 X5 Z-2 F800\nX20\n", 0, 0.009},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.id);
        const std::string options = fmt::format(" --stock 40x30x10 --grid 0.25 --tool 1={}", one.tool);
        m_last.clear();
        const Ids found = judged(kHead + one.faulty + kEnd, options);
        EXPECT_EQ(found, (Ids{one.verdict, one.id}));
        const nlohmann::json& finding = m_last[one.id];
        EXPECT_EQ(finding.value("line", 0), one.line);
        EXPECT_NEAR(finding.value("value", 0.0), one.value, 0.01);
        EXPECT_EQ(judged(kHead + one.clean + kEnd, options), Ids{"safe"});
    }
}

TEST_F(CliCheck, AFixtureOfAFileIsCheckedAndAMissingOneIsNeverSafe) {
    write("part.nc", kHead + "G1 Z-2 F100\nX20\nG0 Z0.5\nX60\n" + kEnd);
    std::string wall = "solid\n"; // only its top, from (48, 0) to (50, 30) at Z5
    for (const char* corners : {"vertex 0 0 15\nvertex 2 30 15\nvertex 0 30 15\n",
                                "vertex 0 0 15\nvertex 2 0 15\nvertex 2 30 15\n"})
        wall += std::string("facet normal 0 0 1\nouter loop\n") + corners + "endloop\nendfacet\n";
    write("wall.stl", wall + "endsolid\n");
    const std::string options = "check part.nc --json --stock 40x30x10 --tool 1=ball:d=4,l=20 --fixture ";
    const Finished hit = run(options + "wall=stl:x=48,z=-10,file=wall.stl");
    EXPECT_EQ(hit.exitCode, 1) << hit.out;
    std::map<std::string, nlohmann::json> byId;
    const nlohmann::json result = hit.json();
    for (const nlohmann::json& finding : result["findings"])
        byId[finding["id"]] = finding;
    ASSERT_TRUE(byId.contains("fixture-collision"));
    EXPECT_EQ(byId["fixture-collision"]["line"], 8);
    EXPECT_NEAR(byId["fixture-collision"]["value"].get<double>(), 4.5, 0.1);
    EXPECT_TRUE(byId.contains("fixture-incomplete")) << "it is not closed";
    const std::string inputs = hit.json()["inputs"].dump();
    EXPECT_NE(inputs.find("wall.stl"), std::string::npos) << "a change of it is noticed by --resume";
    const Finished missing = run(options + "wall=stl:file=missing.stl" + kAcceptAll);
    EXPECT_EQ(missing.exitCode, 2);
    EXPECT_NE(missing.err.find("fixture-unread"), std::string::npos) << missing.err;
}

TEST_F(CliCheck, APieceThatComesLooseHasItsVolume) {
    const std::string options = " --stock 40x40x5 --grid 0.25 --tool 1=flat:d=4,l=20";
    const auto ring = [](const std::string& last) {
        return kHead + "G0 X10 Y10\nG1 Z-6 F100\nX30\nY30\nX10\n" + last + kEnd;
    };
    EXPECT_EQ(judged(ring("Y10\n"), options), (Ids{"faults", "loose-piece"}));
    // The points on its edge are cut, so that it is a spacing narrower.
    EXPECT_DOUBLE_EQ(m_last["loose-piece"]["value"].get<double>(), 15.75 * 15.75 * 5);
    EXPECT_EQ(judged(ring("Y15\n"), options), Ids{"safe"});
}

TEST_F(CliCheck, ABlockOfARepeatedFaultIsCounted) {
    const std::string text = kHead + "G1 Z-2 F100\nM5\nX10\nX15\nX20\nM3\nX25\n" + kEnd;
    EXPECT_EQ(judged(text, " --stock 40x30x10 --grid 0.5 --tool 1=ball:d=4,l=20"),
              (Ids{"faults", "spindle-stopped"}));
    EXPECT_EQ(m_last["spindle-stopped"]["count"], 3);
    EXPECT_EQ(m_last["spindle-stopped"]["line"], 7);
    EXPECT_EQ(m_last["spindle-stopped"]["lastLine"], 9);
}

TEST_F(CliCheck, WhatIsNotCheckedLeavesAProgramUnverified) {
    const std::string file = write("part.nc", kSafe);
    const Finished plain = run("check " + file + kStock + kTool + "--json");
    EXPECT_EQ(plain.json()["verdict"], "unverified");
    EXPECT_EQ(plain.exitCode, 2);
    const Finished noStock = run("check " + file + kTool + " --json");
    const nlohmann::json entries = noStock.json()["notChecked"];
    EXPECT_TRUE(std::ranges::any_of(
        entries, [](const nlohmann::json& one) { return one["id"] == "stock-not-given"; }));
    EXPECT_EQ(run("check " + file + kStock + kTool + "--accept nonsense").exitCode, 3);
}

TEST_F(CliCheck, AHolderThatIsGivenIsChecked) {
    const std::string options = " --stock 40x30x10 --grid 0.25 --accept "
                                "fixtures-not-given,travel-not-given,machine-not-given,tool-limits-not-given "
                                "--tool 1=ball:d=4,l=9,sd=4,holder=20x30,so=";
    const std::string file = write("part.nc", kHead + "G1 X20 Y15 Z-9 F800\n" + kEnd);
    EXPECT_EQ(run("check " + file + options + "12 --json").json()["verdict"], "safe");
    const nlohmann::json near = run("check " + file + options + "9 --json").json();
    EXPECT_EQ(near["verdict"], "safe");
    const std::string deep = write("deep.nc", kHead + "G1 X20 Y15 Z-9.6 F800\n" + kEnd);
    const nlohmann::json hit = run("check " + deep + options + "9 --json").json();
    EXPECT_EQ(hit["verdict"], "faults");
    std::set<std::string> ids;
    for (const nlohmann::json& finding : hit["findings"])
        ids.insert(finding["id"].get<std::string>());
    EXPECT_TRUE(ids.contains("holder-collision")) << hit;
}

TEST_F(CliCheck, RulesAreTurnedOffAndLimitsSet) {
    const std::string text = kHead + "G1 Z-14 F100\n" + kEnd;
    const std::string options = " --stock 40x30x10 --grid 0.5 --tool 1=ball:d=4,l=20 --rules ";
    EXPECT_EQ(judged(text, options + "table-collision=off"), Ids{"safe"});
    EXPECT_EQ(judged(text, options + "table-collision:belowStock=5"), Ids{"safe"});
    EXPECT_EQ(judged(text, options + "table-collision:T1.belowStock=5"), Ids{"safe"});
    EXPECT_EQ(judged(text, options + "table-collision:T2.belowStock=5"), (Ids{"faults", "table-collision"}));
    const std::string file = write("part.nc", text);
    for (const char* bad :
         {"nonsense=off", "table-collision:T1.belowStock=-1", "table-collision:T1.below=1",
          "table-collision:Tx.belowStock=1", "nonsense:T1.belowStock=1", "table-collision=on",
          "table-collision", "a:b=1", "table-collision:belowStock=-1", "table-collision:belowStock=x"})
        EXPECT_EQ(run("check " + file + options + bad).exitCode, 3) << bad;
}

TEST_F(CliCheck, ABrokenFileStopsNothing) {
    write("a.nc", kSafe);
    write("b.nc", std::string("\0\0\0\1binary", 10));
    write("c.proveout", "{");
    write("d.nc", kSafe);
    const Finished all = run("check a.nc b.nc missing.nc c.proveout d.nc --jobs 2 --json" + kStock + kTool);
    EXPECT_EQ(all.exitCode, 3);
    EXPECT_EQ(std::ranges::count(all.out, '\n'), 5);
}

TEST_F(CliCheck, AnInterruptedCheckContinues) {
    write("a.nc", kSafe);
    write("b.nc", kSafe);
    const std::string options = kStock + kTool + "--json --resume done.jsonl";
    (void)run("check a.nc" + options);
    const std::string first = read("done.jsonl");
    write("done.jsonl", first + "{\"program\": \"b.nc\", \"ver"); // killed while it wrote
    const Finished again = run("check a.nc b.nc --junit all.xml" + options);
    EXPECT_EQ(std::ranges::count(again.out, '\n'), 2);
    EXPECT_NE(read("done.jsonl").find(first), std::string::npos);
    EXPECT_EQ(std::ranges::count(read("done.jsonl"), '\n'), 3) << "a.nc was not checked again";
    EXPECT_NE(read("all.xml").find("tests=\"2\""), std::string::npos);
    write("a.nc", kHead + kEnd);
    (void)run("check a.nc b.nc" + options);
    EXPECT_EQ(std::ranges::count(read("done.jsonl"), '\n'), 4) << "a.nc has changed";
    (void)run("check a.nc --stock-origin 1,0,0" + options);
    EXPECT_EQ(std::ranges::count(read("done.jsonl"), '\n'), 5) << "the options have changed";
}

TEST_F(CliCheck, SarifNamesRuleFileAndLines) {
    const std::string file = write("part a.nc", kHead + "G1 Z-2 F100\nM5\nX20\n" + kEnd);
    EXPECT_EQ(run("check \"" + file + "\" --sarif out.sarif" + kStock + kTool).exitCode, 1);
    const nlohmann::json report = nlohmann::json::parse(read("out.sarif"));
    EXPECT_EQ(report["version"], "2.1.0");
    const nlohmann::json& result = report["runs"][0]["results"][0];
    EXPECT_EQ(result["ruleId"], "spindle-stopped");
    EXPECT_EQ(result["level"], "error");
    const nlohmann::json& place = result["locations"][0]["physicalLocation"];
    EXPECT_EQ(place["artifactLocation"]["uri"], "part%20a.nc");
    EXPECT_EQ(place["region"]["startLine"], 7);
}

} // namespace
} // namespace proveout

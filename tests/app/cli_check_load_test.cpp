// SPDX-License-Identifier: GPL-3.0-or-later
// The command check: the load of tools, and what they may do. Each program has one planted fault, and a twin
// without it.
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "tests/app/command_line.h"

namespace proveout {
namespace {

using Ids = std::set<std::string>;

class CliCheckLoad : public CommandLine {
protected:
    /// The ids of the findings of a program, and its verdict; its result is kept.
    Ids judged(const std::string& text, const std::string& options) {
        const std::string file = write("part.nc", text);
        m_result = run("check " + file +
                       " --stock 40x30x10 --grid 0.25 --json --accept holder-not-given,"
                       "shank-not-given,fixtures-not-given,travel-not-given,machine-not-given,"
                       "tool-limits-not-given " +
                       options)
                       .json();
        Ids ids;
        if (!m_result.is_object())
            return ids;
        ids.insert(m_result["verdict"].get<std::string>());
        for (const nlohmann::json& finding : m_result["findings"])
            ids.insert(finding["id"].get<std::string>());
        return ids;
    }
    /// The last finding with this id.
    [[nodiscard]] nlohmann::json finding(const std::string& id) const {
        nlohmann::json found;
        for (const nlohmann::json& one : m_result["findings"])
            if (one["id"] == id)
                found = one;
        return found;
    }
    nlohmann::json m_result;
};

const std::string kToFirstCut = "G21 G90 G17\nT1 M6\nS1000 M3\nG0 X5 Y5 Z5\n";
const std::string kAfterLastCut = "G0 Z5\nM5\nM30\n";
/// Up to Y beside the stock, then along X: the tool of ⌀4 is engaged up to Y + 2.
std::string alongTheEdge(const std::string& y) {
    return "G0 X-5 Y-5\nG1 Z-2 F100\nY" + y + "\nX45\n";
}

TEST_F(CliCheckLoad, APlantedFaultIsFoundAtItsLineAndItsTwinIsSafe) {
    struct Case {
        const char* id;
        const char* tool;
        std::string faulty;
        std::string clean;
        int line;
        double value;
    };
    const std::vector<Case> cases{
        {"depth-limit", "flat:d=4,l=20,maxap=2,maxae=4", "G1 Z-3 F100\nX20\n", "G1 Z-2 F100\nX20\n", 6, 3},
        {"engagement-limit", "flat:d=4,l=20,maxae=2", alongTheEdge("1"), alongTheEdge("0"), 8, 3},
        {"chip-limit", "flat:d=4,l=20,z=2,maxchip=0.05,maxae=4", "G1 Z-2 F100\nX20 F200\n",
         "G1 Z-2 F100\nX20\n", 6, 0.1},
        {"chip-limit", "flat:d=4,l=20,z=2,maxchip=0.09", alongTheEdge("0") + "Y2 F200\nX-5\n",
         alongTheEdge("0") + "Y1 F200\nX-5\n", 10, 0.1},
        {"chip-limit", "drill:d=4,angle=60,l=20,z=2,maxchip=0.05", "G1 Z-5 F220\n", "G1 Z-5 F190\n", 5,
         0.055},
        {"surface-speed", "flat:d=4,l=20,maxvc=12", "G1 Z-2 F100\nX20\n", "S900\nG1 Z-2 F100\nX20\n", 5,
         4 * std::numbers::pi},
        {"removal-rate-limit", "flat:d=4,l=20,maxmrr=0.8,maxae=4", "G1 Z-2 F100\nX20\n",
         "G1 Z-2 F100\nX20 F90\n", 6, 0.85},
        {"tool-feed-limit", "flat:d=4,l=20,maxfeed=100", "G1 Z-2 F100\nX20 F120\n", "G1 Z-2 F100\nX20\n", 6,
         120},
        {"tool-spindle-limit", "flat:d=4,l=20,maxrpm=900", "G1 Z-2 F100\nX20\n", "S900\nG1 Z-2 F100\nX20\n",
         5, 1000},
        {"ramp-too-steep", "flat:d=4,l=20,ramp=10", "G0 Z0\nG1 X15 Z-3 F100\n", "G0 Z0\nG1 X25 Z-3 F100\n", 6,
         16.699},
        {"plunge-not-allowed", "flat:d=4,l=20,centre=0", "G1 Z-3 F100\n", "G0 Z0\nG1 X15 Z-3 F100\n", 5, 3},
        {"tap-feed", "tap:d=4,tip=3.3,lead=2,l=20,pitch=0.7,centre=1", "G0 Z2\nG1 Z-5 F500\nM4\nZ2 F700\n",
         "G0 Z2\nG1 Z-5 F700\nM4\nZ2\n", 6, 500},
        {"tap-not-reversed", "tap:d=4,tip=3.3,lead=2,l=20,centre=1", "G0 Z2\nG1 Z-5 F700\nZ2\n",
         "G0 Z2\nG1 Z-5 F700\nM4\nZ2\n", 7, 5},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.tool);
        const std::string options = fmt::format("--tool 1={}", one.tool);
        EXPECT_EQ(judged(kToFirstCut + one.faulty + kAfterLastCut, options), (Ids{"faults", one.id}));
        const nlohmann::json found = finding(one.id);
        EXPECT_EQ(found.value("line", 0), one.line);
        EXPECT_NEAR(found.value("value", 0.0), one.value, 1e-3);
        EXPECT_EQ(judged(kToFirstCut + one.clean + kAfterLastCut, options), Ids{"safe"});
    }
}

TEST_F(CliCheckLoad, ATappingCycleIsInStep) {
    const std::string tap = "--tool 1=tap:d=4,tip=3.3,lead=2,l=20,pitch=0.7 --tool "
                            "2=drill:d=3.3,angle=118,l=20 --dialect linuxcnc";
    const std::string drilled = "G21 G90 G17\nT2 M6\nS1000 M3\nG43 H2\nG0 X10 Y10 Z50\n"
                                "G81 X10 Y10 Z-8 R2 F100\nG80\nG0 Z50\nM5\nT1 M6\nS500 M3\nG43 H1\n";
    EXPECT_EQ(judged(drilled + "G84 X10 Y10 Z-5 R3 F350\nG80\n" + kAfterLastCut, tap), Ids{"safe"});
    EXPECT_EQ(judged(drilled + "G0 Z3\nG33.1 Z-5 K0.7\n" + kAfterLastCut, tap), Ids{"safe"});
    EXPECT_EQ(judged(drilled + "G81 X10 Y10 Z-5 R3 F350\nG80\n" + kAfterLastCut, tap),
              (Ids{"faults", "tap-not-reversed"}));
    EXPECT_EQ(judged(drilled + "G84 X20 Y10 Z-5 R3 F350\nG80\n" + kAfterLastCut, tap),
              (Ids{"faults", "plunge-not-allowed"}))
        << "where no hole is";
}

TEST_F(CliCheckLoad, ASizeFromACommentOnlyWarns) {
    const std::string program = "(T1 D20 FACE MILL)\n" + kToFirstCut + "G1 Z-2 F100\n" + kAfterLastCut;
    EXPECT_EQ(judged(program, ""), (Ids{"unverified", "tool-unconfirmed", "plunge-not-allowed"}));
    EXPECT_EQ(finding("plunge-not-allowed")["severity"], "warning");
}

TEST_F(CliCheckLoad, ASlotIsANoteWhereNoRadialLimitIsStated) {
    const std::string slot = kToFirstCut + "G1 Z-2 F100\nX20\n" + kAfterLastCut;
    EXPECT_EQ(judged(slot, "--tool 1=flat:d=4,l=20,maxap=2"), (Ids{"safe", "full-slot"}));
    EXPECT_EQ(finding("full-slot")["count"], 1);
    EXPECT_EQ(judged(slot, "--tool 1=flat:d=4,l=20"), Ids{"safe"}) << "nothing is stated";
    EXPECT_EQ(judged(kToFirstCut + alongTheEdge("1") + kAfterLastCut, "--tool 1=flat:d=4,l=20,maxap=2"),
              Ids{"safe"});
}

TEST_F(CliCheckLoad, AnEngagementThatJumpsIsANote) {
    const std::string options = "--tool 1=flat:d=4,l=20,maxae=2";
    const std::string along = "G0 X-5 Y-1\nG1 Z-2 F100\nX20\n";
    EXPECT_EQ(judged(kToFirstCut + along + "Y15\n" + kAfterLastCut, options),
              (Ids{"faults", "engagement-limit", "engagement-jump"}));
    EXPECT_EQ(finding("engagement-jump")["line"], 8);
    EXPECT_EQ(judged(kToFirstCut + along + "X45\n" + kAfterLastCut, options), Ids{"safe"});
    EXPECT_EQ(judged(kToFirstCut + "G0 X20 Y-5\nG1 Z-2 F100\nY15\n" + kAfterLastCut, options),
              (Ids{"faults", "engagement-limit"}))
        << "the block before cuts nothing";
}

TEST_F(CliCheckLoad, TheSpindleOfTheMachineHasALimit) {
    const std::string program = kToFirstCut + "G1 Z-2 F100\nX20\n" + kAfterLastCut;
    const std::string tool = "--tool 1=flat:d=4,l=20 --machine largestSpindle=";
    EXPECT_EQ(judged(program, tool + "900"), (Ids{"safe", "spindle-limit"}));
    EXPECT_EQ(finding("spindle-limit")["count"], 4) << "from G0 in line 4 to the last one";
    EXPECT_EQ(judged(program, tool + "1000"), Ids{"safe"});
    const auto isListed = [&] {
        return std::ranges::any_of(m_result["notChecked"], [](const nlohmann::json& one) {
            return one["id"] == "largest-spindle-not-given";
        });
    };
    EXPECT_FALSE(isListed());
    EXPECT_EQ(judged(program, tool + "0"), Ids{"unverified"});
    EXPECT_TRUE(isListed());
}

TEST_F(CliCheckLoad, LimitsThatBoundTheLoadLeaveNothingUnchecked) {
    const std::string program = kToFirstCut + "G1 Z-2 F100\nX20\n" + kAfterLastCut;
    const auto isListed = [&](const std::string& limits) {
        judged(program, "--tool 1=flat:d=4,l=20" + limits);
        return std::ranges::any_of(m_result["notChecked"], [](const nlohmann::json& one) {
            return one["id"] == "tool-limits-not-given";
        });
    };
    EXPECT_TRUE(isListed(""));
    EXPECT_TRUE(isListed(",maxrpm=2000"));
    EXPECT_FALSE(isListed(",maxap=2,maxae=4"));
}

TEST_F(CliCheckLoad, ACommentThatDescribesAnotherToolIsAWarning) {
    const std::string program = kToFirstCut + "G1 Z-2 F100\nX20\n" + kAfterLastCut;
    const std::string tool = "--tool 1=flat:d=4,l=20";
    const Ids differs{"safe", "tool-comment-differs"};
    EXPECT_EQ(judged("(T1 D6 END MILL)\n" + program, tool), differs);
    EXPECT_EQ(finding("tool-comment-differs")["line"], 1);
    EXPECT_EQ(judged("(T1 D4 DRILL)\n" + program, tool), differs);
    EXPECT_EQ(judged("(T1 D4 BALL END MILL)\n" + program, tool), differs);
    EXPECT_EQ(judged("(T1 D4 END MILL)\n" + program, tool), Ids{"safe"});
    EXPECT_EQ(judged("(T2 D6 END MILL)\n" + program, tool), Ids{"safe"}) << "it is not called";
    EXPECT_EQ(judged("(T1 D6 END MILL)\n" + program, tool + " --rules tool-comment-differs=off"),
              Ids{"safe"});
}

TEST_F(CliCheckLoad, ARapidCloseToTheStockIsAWarning) {
    const std::string tool = "--tool 1=ball:d=4,l=20 --rules rapid-too-close:rapidClearance=1";
    const auto over = [](const char* z) {
        return kToFirstCut + "G0 Z" + z + "\nX30\nG1 Z-2 F100\n" + kAfterLastCut;
    };
    EXPECT_EQ(judged(over("0.4"), tool), (Ids{"safe", "rapid-too-close"}));
    EXPECT_EQ(finding("rapid-too-close")["line"], 5);
    EXPECT_EQ(finding("rapid-too-close")["count"], 2) << "down and along, but not the one straight up";
    EXPECT_NEAR(finding("rapid-too-close")["value"].get<double>(), 0.6, 1e-3);
    EXPECT_EQ(judged(over("1"), tool), Ids{"safe"});
    EXPECT_EQ(judged(over("0.4"), "--tool 1=ball:d=4,l=20"), Ids{"safe"}) << "off unless it is asked for";
    EXPECT_EQ(judged(over("-1"), tool), (Ids{"faults", "rapid-cuts"})) << "not both";
}

TEST_F(CliCheckLoad, TheFirstContactOfEachToolIsListed) {
    const std::string program = kToFirstCut +
                                "X6\nG1 Z1 F100\nZ-2\nX20\nG0 Z50\nM5\nT2 M6\nS1000 M3\nG43 H2\nG0 X30 Y20\n"
                                "G1 Z-3 F100\n" +
                                kAfterLastCut;
    const std::string tools = "--tool 1=flat:d=4,l=20 --tool 2=drill:d=4,angle=118,l=20";
    EXPECT_EQ(judged(program, tools), Ids{"safe"});
    const nlohmann::json expected{
        {{"tool", 1}, {"block", 4}, {"line", 7}, {"x", 6.0}, {"y", 5.0}, {"z", 1.0}},
        {{"tool", 2}, {"block", 8}, {"line", 15}, {"x", 30.0}, {"y", 20.0}, {"z", 50.0}}};
    EXPECT_EQ(m_result["firstContacts"], expected);
    const Finished text = run("check part.nc --stock 40x30x10 --grid 0.25 " + tools);
    EXPECT_NE(text.out.find("first contact of T2: line 15, from X30.000 Y20.000 Z50.000"), std::string::npos)
        << text.out;
}

} // namespace
} // namespace proveout

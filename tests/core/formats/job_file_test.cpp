// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/job_file.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/tool_number.h"
#include "core/cutting/fixtures/fixture_surface.h"
#include "tests/core/formats/random_bytes.h"
#include "tests/core/temporary_folder.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

const std::string kWhole = R"({
  "proveout": 1,
  "program": "core-insert.nc",
  "stock": {"corner": [-70, -50.5, 2], "width": 140, "depth": 101, "height": 50},
  "grid": 0.5,
  "tools": {"1": "ball:d=11,l=50", "12": "flat:d=6"},
  "start": [0, 0, 50],
  "blockDelete": true,
  "decimation": {"method": "global", "region": 16, "period": -1, "allowance": 0.02, "certify": false,
                 "borders": "paper", "order": "sequential", "seed": 7}
})";

class JobFile : public testing::Test {
protected:
    Result<Job> read(const std::string& text) {
        m_folder.put("a.proveout", text);
        return readJob(m_folder / "a.proveout");
    }
    /// All messages, one "LINE:COLUMN sentence [id]" per line; empty if the job was read without a warning.
    std::string reported(const std::string& text) {
        const auto job = read(text);
        std::string out;
        for (const Diagnostic& diagnostic : job ? job->warnings : job.error()) {
            EXPECT_EQ(diagnostic.file, (m_folder / "a.proveout").string());
            EXPECT_EQ(diagnostic.severity == Severity::warning,
                      std::string_view(diagnostic.id) == "job-field-unknown");
            out += std::to_string(diagnostic.where.line) + ":" + std::to_string(diagnostic.where.column) +
                   " " + message(diagnostic) + " [" + diagnostic.id + "]\n";
        }
        return out;
    }
    /// kWhole with the first occurrence of `from` replaced.
    static std::string with(const std::string& from, const std::string& to) {
        std::string text = kWhole;
        const auto at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    }

    TemporaryFolder m_folder;
};

TEST_F(JobFile, ReadsEveryField) {
    const auto job = read(kWhole);
    ASSERT_TRUE(job) << oneLine(job.error().front());
    EXPECT_EQ(job->program, fs::canonical(m_folder.path()) / "core-insert.nc");
    EXPECT_EQ(job->setup.stock, (StockBox{{-70, -50.5, 2}, 140, 101, 50}));
    EXPECT_EQ(job->setup.spacing, 0.5);
    ASSERT_EQ(job->setup.tools.tools().size(), 2U);
    EXPECT_EQ(job->setup.tools.find(1)->radius(), 5.5);
    EXPECT_EQ(job->setup.tools.find(12)->spec(), "flat:d=6");
    ASSERT_TRUE(job->setup.start);
    EXPECT_EQ(*job->setup.start, Vec3(0, 0, 50));
    EXPECT_TRUE(job->setup.blockDelete);
    EXPECT_EQ(job->parameters, (DecimationParameters{DecimationMethod::global, 16, -1, 0.02, false,
                                                     BorderRule::paper, RemovalOrder::sequential, 7}));
}

TEST_F(JobFile, KeepsWhereTheSizesOfAToolComeFrom) {
    auto job = read(kWhole);
    ASSERT_TRUE(job);
    EXPECT_TRUE(job->setup.tools.unconfirmed().empty()) << "old jobs give their tools";
    const ToolOrigin comment{ToolSource::comment, 3, "T1 D=11 \"BALL\"", {"shape", "l"}, {"sd", "sl"}};
    job->setup.tools.set(1, *job->setup.tools.find(1), comment);
    job->setup.tools.set(5, parseCutter("flat:d=10").value(), {ToolSource::assumed});
    job->setup.tools.set(6, parseCutter("flat:d=10,sd=12,so=40,holder=40x30+40-60x15").value());
    ASSERT_TRUE(writeJob(m_folder / "again.proveout", *job));
    const auto again = readJob(m_folder / "again.proveout");
    ASSERT_TRUE(again) << oneLine(again.error().front());
    EXPECT_TRUE(again->warnings.empty());
    EXPECT_EQ(again->setup.tools, job->setup.tools);
    EXPECT_EQ(again->setup.tools.find(6)->body().holder.size(), 2U);
    ASSERT_NE(again->setup.tools.unconfirmedOrigin(1), nullptr);
    EXPECT_EQ(*again->setup.tools.unconfirmedOrigin(1), comment);
    EXPECT_EQ(again->setup.tools.unconfirmedOrigin(12), nullptr);
    EXPECT_EQ(again->setup.tools.unconfirmedOrigin(5)->source, ToolSource::assumed);

    const auto refused = [this](const std::string& field) {
        return reported(with("\"grid\"", "\"unconfirmedTools\": " + field + ", \"grid\""));
    };
    EXPECT_THAT(refused(R"({"1": {"source": "guessed"}})"), HasSubstr("unconfirmedTools.1.source"));
    EXPECT_THAT(refused(R"({"1": {"source": "comment", "line": -1}})"), HasSubstr("unconfirmedTools.1.line"));
    EXPECT_THAT(refused(R"({"99": {"source": "assumed"}})"), HasSubstr("unconfirmedTools.99"));
}

TEST_F(JobFile, OptionalFieldsHaveTheirDefaults) {
    const auto job =
        read(R"({"proveout": 1, "program": "a.nc", "stock": {"width": 1, "depth": 2, "height": 3}})");
    ASSERT_TRUE(job) << oneLine(job.error().front());
    EXPECT_TRUE(job->warnings.empty());
    EXPECT_EQ(job->setup.stock, (StockBox{{0, 0, 0}, 1, 2, 3}));
    EXPECT_TRUE(job->setup.automaticGrid);
    EXPECT_FALSE(job->setup.startTool);
    EXPECT_TRUE(job->setup.tools.tools().empty());
    EXPECT_FALSE(job->setup.start);
    EXPECT_FALSE(job->setup.blockDelete);
    EXPECT_EQ(job->parameters, DecimationParameters());
}

TEST_F(JobFile, ThePositionOfTheStockHasFieldsOfItsOwnNames) {
    const auto positioned = [this](const std::string& fields) {
        return reported(R"({"proveout": 2, "program": "a.nc", "stock": {)" + fields +
                        R"("width": 1, "depth": 2, "height": 3}})");
    };
    EXPECT_EQ(positioned(R"("minX": -70, "minY": 4.5, "topZ": 2, )"), "");
    EXPECT_EQ(readJob(m_folder / "a.proveout")->setup.stock, (StockBox{{-70, 4.5, 2}, 1, 2, 3}));
    EXPECT_EQ(positioned(R"("corner": [-70, 4.5, 2], )"), "") << "as jobs of format 1 have it";
    EXPECT_EQ(readJob(m_folder / "a.proveout")->setup.stock, (StockBox{{-70, 4.5, 2}, 1, 2, 3}));
    EXPECT_THAT(positioned(R"("minX": -70, "topZ": 2, )"), HasSubstr("\"stock.minY\" is missing."));
    EXPECT_THAT(positioned(R"("topZ": 0, "corner": [0, 0, 0], )"), HasSubstr("cannot be used together"));
    EXPECT_THAT(positioned(R"("minX": 0, "minY": 0, "topZ": 1e8, )"),
                HasSubstr("\"stock.topZ\" must be a number from -10000000 to 10000000."));
    EXPECT_THAT(positioned(R"("minX": 0, "minY": 0, "bottomZ": 1, )"), HasSubstr("bottomZ"));
}

TEST_F(JobFile, TheStartHasAPositionAndATool) {
    EXPECT_EQ(read(with("\"grid\"", "\"startTool\": 12, \"grid\"")).value().setup.startTool, 12);
    EXPECT_EQ(read(with("\"grid\"", "\"startTool\": 0, \"grid\"")).value().setup.startTool, 0);
    for (const char* wrong : {"-1", "100000000", "1.5", "\"T1\"", "null"})
        EXPECT_THAT(reported(with("\"grid\"", std::string("\"startTool\": ") + wrong + ", \"grid\"")),
                    HasSubstr("\"startTool\" must be a"))
            << wrong;
}

TEST_F(JobFile, AGridThatIsNotNamedIsAutomaticAndStaysSo) {
    EXPECT_FALSE(read(kWhole)->setup.automaticGrid);
    Job job = read(kWhole).value();
    job.setup.automaticGrid = true;
    job.setup.spacing = 0.3; // as computed last
    ASSERT_TRUE(writeJob(m_folder / "b.proveout", job));
    EXPECT_THAT(readFile(m_folder / "b.proveout").value(), testing::Not(HasSubstr("grid")));
    EXPECT_TRUE(readJob(m_folder / "b.proveout")->setup.automaticGrid);
}

TEST_F(JobFile, AShapeWhoseFileIsNotChosenYetComesBackSo) {
    Job job = read(kWhole).value();
    job.setup.shape.kind = StockKind::mesh;
    ASSERT_TRUE(writeJob(m_folder / "b.proveout", job));
    const auto back = readJob(m_folder / "b.proveout");
    ASSERT_TRUE(back) << oneLine(back.error().front());
    EXPECT_EQ(back->setup.shape, job.setup.shape);
    EXPECT_STREQ(checkShape(back->setup.shape).error().front().id, "stock-incomplete");
}

TEST_F(JobFile, KeepsTheIgnoredMCodes) {
    EXPECT_TRUE(read(kWhole).value().setup.ignoredM.empty());
    const Job job = read(with("\"grid\"", "\"ignoredM\": [24, 16], \"grid\"")).value();
    EXPECT_EQ(job.setup.ignoredM, (std::set<int>{16, 24}));
    ASSERT_TRUE(writeJob(m_folder / "b.proveout", job));
    EXPECT_EQ(readJob(m_folder / "b.proveout")->setup, job.setup);
    for (const char* value : {"16", "[\"16\"]", "[1.5]", "[-1]", "[100000]", "{}", "[[1]]"})
        EXPECT_EQ(reported(with("\"grid\"", std::string("\"ignoredM\": ") + value + ", \"grid\"")),
                  "5:3 The field \"ignoredM\" must be a list of whole numbers from 0 to 99999. [job-field]\n")
            << value;
}

TEST_F(JobFile, CompensationStartsByTypeAUnlessTheJobSaysB) {
    const auto typeB = [this](const std::string& field) {
        return read(with("\"grid\"", field + "\"grid\"")).value().setup.compensationTypeB;
    };
    EXPECT_FALSE(typeB(""));
    EXPECT_FALSE(typeB(R"("compensationStart": "a", )"));
    EXPECT_TRUE(typeB(R"("compensationStart": "b", )"));
    const std::string refused =
        "5:3 The field \"compensationStart\" must be one of \"a\", \"b\". [job-field]\n";
    for (const char* value : {"\"c\"", "\"\"", "\"B\"", "true", "1", "null", "[\"b\"]", "{}"})
        EXPECT_EQ(reported(with("\"grid\"", std::string("\"compensationStart\": ") + value + ", \"grid\"")),
                  refused)
            << value;
    EXPECT_THAT(reported(with("\"grid\"", "\"compensation-start\": \"b\", \"grid\"")),
                HasSubstr("compensationStart"));
}

TEST_F(JobFile, FixturesAreNamed) {
    const auto job = read(with("\"grid\"", R"("fixtures": {"jaw": "box:x=-20,w=20,d=80,h=25"}, "grid")"));
    ASSERT_TRUE(job);
    const Fixtures expected{{"jaw", FixtureBox{-20, 0, 0, 20, 80, 25}}};
    EXPECT_EQ(job->setup.fixtures, expected);
    EXPECT_THAT(reported(with("\"grid\"", R"("fixtures": {"jaw": "box:w=20"}, "grid")")), HasSubstr("jaw"));
    const auto mesh =
        read(with("\"grid\"", R"("fixtures": {"vice": "stl:x=5,turn=90,file=vices/a, b.stl"}, "grid")"));
    ASSERT_TRUE(mesh) << "a file that is missing is reported by the check";
    const auto& vice = std::get<FixtureMesh>(mesh->setup.fixtures.at("vice"));
    EXPECT_EQ(vice.file, fs::canonical(m_folder.path()) / "vices/a, b.stl");
    EXPECT_EQ(vice.turn, 90);
    EXPECT_TRUE(vice.surface->facets().empty());
    EXPECT_FALSE(vice.surface->findings().empty());
    ASSERT_TRUE(writeJob(m_folder / "b.proveout", *mesh));
    EXPECT_THAT(readFile(m_folder / "b.proveout").value(),
                HasSubstr("\"stl:x=5,y=0,z=0,turn=90,scale=1,file=vices/a, b.stl\""));
    EXPECT_THAT(reported(with("\"grid\"", R"("fixtures": {"vice": "stl:file=../a.stl"}, "grid")")),
                HasSubstr("a.stl"))
        << "outside the folder of the job";
    EXPECT_FALSE(read(with("\"grid\"", R"("fixtures": {"vice": "stl:file=/a.stl"}, "grid")")));
    EXPECT_FALSE(read(with("\"grid\"", R"("fixtures": {"jaw": 3}, "grid")")));
    EXPECT_FALSE(read(with("\"grid\"", R"("fixtures": ["box:w=1,d=1,h=1"], "grid")")));
}

TEST_F(JobFile, TheMachineIsAssumedUnlessTheJobDescribesIt) {
    EXPECT_FALSE(read(kWhole).value().machine);
    const auto job = read(with("\"grid\"", R"("machine": {"rapidXY": 30000, "toolChange": 3.5}, "grid")"));
    ASSERT_TRUE(job);
    ASSERT_TRUE(job->machine);
    EXPECT_EQ(job->machine->rapidXY, 30000);
    EXPECT_EQ(job->machine->toolChangeSeconds, 3.5);
    EXPECT_EQ(job->machine->rapidZ, Machine().rapidZ);
    EXPECT_FALSE(read(with("\"grid\"", R"("machine": {"rapidXY": 0}, "grid")")));
}

TEST_F(JobFile, TheCheckHasLimitsRulesAndWaivers) {
    const auto job = read(with("\"grid\"", R"("check": {
        "limits": {"rapidClearance": 1.5, "fixture-near:T3.fixtureClearance": 4},
        "off": {"full-slot:T3": "trochoidal"},
        "accepted": {"manual-stops": "clamps are turned by hand"},
        "waivers": {"first": {"finding": "rapid-cuts", "tool": 1, "count": 2, "values": "0.5",
                              "cutter": "ball:d=4", "place": [1, 2, -0.5], "reason": "drilled before", "owner": "M. Roth"}}}, "grid")"));
    ASSERT_TRUE(job);
    EXPECT_EQ(job->check.limits.rapidClearance, 1.5);
    EXPECT_EQ(job->check.limits.belowStock, RuleLimits().belowStock);
    EXPECT_EQ(job->check.limitsOf("fixture-near").at(3).fixtureClearance, 4);
    EXPECT_EQ(job->check.limitsOf("fixture-near").at(3).rapidClearance, 1.5);
    EXPECT_TRUE(job->check.limitsOf("fixture-collision").empty());
    EXPECT_TRUE(job->check.isOff("full-slot", 3));
    EXPECT_FALSE(job->check.isOff("full-slot", 2));
    EXPECT_EQ(job->check.accepted.at("manual-stops"), "clamps are turned by hand");
    const Waiver waiver{"rapid-cuts", 1, 2, "0.5", Vec3(1, 2, -0.5), "drilled before", "M. Roth", "ball:d=4"};
    EXPECT_EQ(job->check.waivers, std::vector{waiver});
    EXPECT_EQ(read(kWhole)->check, CheckRules());
}

TEST_F(JobFile, AWaiverNeedsAReasonAndAnOwner) {
    const auto about = [this](const std::string& fields) {
        return reported(with("\"grid\"", R"("check": {"waivers": {"a": {)" + fields + R"(}}}, "grid")"));
    };
    EXPECT_THAT(about(R"("finding": "rapid-cuts", "owner": "M. Roth")"), HasSubstr("check.waivers.a.reason"));
    EXPECT_THAT(about(R"("finding": "rapid-cuts", "owner": "", "reason": "b")"),
                HasSubstr("check.waivers.a.owner"));
    EXPECT_THAT(about(R"("finding": "a", "owner": "b", "reason": "c", "count": 0)"),
                HasSubstr("check.waivers.a.count"));
    EXPECT_THAT(about(R"("finding": "a", "owner": "b", "reason": "c", "place": [1, 2])"),
                HasSubstr("check.waivers.a.place"));
    EXPECT_FALSE(read(with("\"grid\"", R"("check": {"limits": {"rapidClearance": -1}}, "grid")")));
    EXPECT_FALSE(read(with("\"grid\"", R"("check": {"limits": {"tap-feed:T3.tapFeedError": -1}}, "grid")")));
    EXPECT_THAT(reported(with("\"grid\"", R"("check": {"limits": {"tap-feed:T3.feed": 1}}, "grid")")),
                HasSubstr("tap-feed:T3.feed"));
    EXPECT_FALSE(read(with("\"grid\"", R"("check": {"off": ["full-slot"]}, "grid")")));
}

TEST_F(JobFile, RegionAndPeriodAreTheDefaultsOfTheMethodUnlessTheyAreGiven) {
    const auto parameters = [this](const std::string& decimation) {
        return read(R"({"proveout": 1, "program": "a.nc", "stock": {"width": 1, "depth": 2, "height": 3},
                        "decimation": )" +
                    decimation + "}")
            ->parameters;
    };
    EXPECT_EQ(parameters(R"({"method": "global"})").period, 1);
    EXPECT_EQ(parameters(R"({"method": "global", "period": 7})").period, 7);
    EXPECT_EQ(parameters(R"({"method": "lee"})").period, 20);
    EXPECT_EQ(parameters(R"({"region": 12})").regionCells, 12);
    EXPECT_EQ(parameters("{}"), DecimationParameters());
}

TEST_F(JobFile, RegionsGrowWithTheMapUnlessTheirSizeIsGiven) {
    const auto job = [this](const std::string& decimation) {
        return read(R"({"proveout": 1, "program": "a.nc", "grid": 0.05,
                        "stock": {"width": 200, "depth": 150, "height": 3}, "decimation": )" +
                    decimation + "}")
            .value();
    };
    EXPECT_EQ(job("{}").parameters.regionCells, 32); // 12 million points
    EXPECT_FALSE(job("{}").regionNamed);
    EXPECT_EQ(job(R"({"region": 16})").parameters.regionCells, 16);
    EXPECT_TRUE(job(R"({"region": 16})").regionNamed);
}

TEST_F(JobFile, ErrorsNameTheFieldAndWhatIsAllowed) {
    EXPECT_EQ(reported(with("140", "-1")),
              "4:40 The field \"stock.width\" must be a number above 0 and at most 1000000. [job-field]\n");
    EXPECT_THAT(reported(with("140", "0")), HasSubstr("\"stock.width\""));
    EXPECT_THAT(reported(with("140", "\"140\"")), HasSubstr("\"stock.width\" must be a number"));
    EXPECT_THAT(reported(with("140", "1e7")), HasSubstr("\"stock.width\""));
    EXPECT_THAT(reported(with("-50.5", "null")), HasSubstr("\"stock.corner[1]\" must be a number from"));
    EXPECT_THAT(reported(with("[0, 0, 50]", "[0, 0]")),
                HasSubstr("\"start\" must be three numbers [x, y, z]."));
    EXPECT_THAT(reported(with("\"grid\": 0.5", "\"grid\": 0")), HasSubstr("\"grid\""));
    EXPECT_THAT(reported(with("16", "1")),
                HasSubstr("\"decimation.region\" must be a number from 2 to 256."));
    EXPECT_THAT(reported(with("16", "16.5")), HasSubstr("\"decimation.region\" must be a whole number."));
    EXPECT_THAT(reported(with("16", "1e300")), HasSubstr("\"decimation.region\""));
    EXPECT_THAT(
        reported(with("\"global\"", "\"best\"")),
        HasSubstr("\"decimation.method\" must be one of \"certified\", \"lee\", \"global\", \"none\"."));
    EXPECT_THAT(reported(with("\"global\"", "3")), HasSubstr("\"decimation.method\" must be one of"));
    EXPECT_THAT(reported(with("false", "0")), HasSubstr("\"decimation.certify\" must be true or false."));
    EXPECT_THAT(reported(with("flat:d=6", "flat:d=-6")), HasSubstr("\"tools.12\" is not a cutter: "));
    EXPECT_THAT(reported(with("\"12\"", "\"T12\"")), HasSubstr("\"tools.T12\" is not a tool number"));
    EXPECT_THAT(reported(with("\"12\"", "\"-1\"")), HasSubstr("\"tools.-1\" is not a tool number"));
    EXPECT_EQ(reported(with("\"12\"", "\"0\"")), "") << "T0 is a cutter where the table says so";
    EXPECT_THAT(reported(with("\"12\"", "\"100000000\"")), HasSubstr("from 0 to 99999999."));
    EXPECT_THAT(reported(with("\"12\"", "\"01\"")),
                HasSubstr("\"tools.1\" names a tool that is in the table already."));
    EXPECT_THAT(reported(with("\"12\"", "\"99999999999\"")), HasSubstr("is not a tool number"));
    EXPECT_THAT(reported(with("\"flat:d=6\"", "6")), HasSubstr("\"tools.12\" must be a text."));
    EXPECT_THAT(reported(with("core-insert.nc", "")), HasSubstr("\"program\" must name a file."));
    EXPECT_THAT(reported(with("core-insert.nc", "a\\u0000b")), HasSubstr("\"program\" must be a text."));
    EXPECT_THAT(reported(with("\"stock\"", "\"stack\"")), HasSubstr("\"stock\" is missing."));
    EXPECT_THAT(reported(with("\"height\"", "\"hight\"")), HasSubstr("\"stock.height\" is missing."));
}

TEST_F(JobFile, AllWrongFieldsAreReportedAtOnceWithTheirPlaces) {
    EXPECT_EQ(
        reported(
            "{\"proveout\": 1, \"stock\": 5,\n \"grid\": -1, \"decimation\": [],\n\"start\": [1, \"2\", 3]}"),
        "0:0 The field \"program\" is missing. [job-field]\n"
        "1:17 The field \"stock\" must be an object { }. [job-field]\n"
        "1:17 The field \"stock.width\" is missing. [job-field]\n"
        "1:17 The field \"stock.depth\" is missing. [job-field]\n"
        "1:17 The field \"stock.height\" is missing. [job-field]\n"
        "2:2 The field \"grid\" must be a number above 0 and at most 1000000. [job-field]\n"
        "3:1 The field \"start[1]\" must be a number from -10000000 to 10000000. [job-field]\n"
        "2:14 The field \"decimation\" must be an object { }. [job-field]\n");
}

TEST_F(JobFile, FieldsThatAreNotKnownAreWarningsInTheOrderOfTheText) {
    EXPECT_EQ(reported(kWhole), "");
    EXPECT_EQ(
        reported("{\"proveout\": 1, \"program\": \"a.nc\", \"from the future\": [[], {\"grid\": 1}],\n"
                 "  \"stock\": {\"width\": 1, \"depth\": 2, \"height\": 3,\n\"colour\": {\"red\": 1}},\n"
                 "  \"grd\": 0.5, \"decimation\": {\"Allowence\": 0.1},\n"
                 "  \"tools\": {\"1\": \"ball:d=4\"}, \"a\\\"b\\\\\": {}}"),
        "1:36 The field \"from the future\" is not known and has no effect. [job-field-unknown]\n"
        "3:1 The field \"stock.colour\" is not known and has no effect. [job-field-unknown]\n"
        "4:3 The field \"grd\" is not known and has no effect; perhaps \"grid\" is meant. "
        "[job-field-unknown]\n"
        "4:30 The field \"decimation.Allowence\" is not known and has no effect; perhaps "
        "\"decimation.allowance\" is meant. [job-field-unknown]\n"
        "5:31 The field \"a\"b\\\" is not known and has no effect. [job-field-unknown]\n");
}

TEST_F(JobFile, AWarningHasTheLengthOfTheNameAndAHint) {
    const auto job = read(with("\"grid\"", "\"gr\\u0069dd\""));
    ASSERT_TRUE(job);
    ASSERT_EQ(job->warnings.size(), 1U);
    EXPECT_EQ(job->warnings[0].where, (TextRange{5, 3, 12}));
    EXPECT_THAT(job->warnings[0].arguments, testing::ElementsAre("gridd", "grid"));
    EXPECT_STRNE(job->warnings[0].hint, "");
}

TEST_F(JobFile, AMisspeltFieldThatIsNeededIsNamedBesideTheError) {
    const std::string hight = reported(with("\"height\"", "\"hight\""));
    EXPECT_THAT(hight, HasSubstr("4:3 The field \"stock.height\" is missing. [job-field]\n4:68 The field "
                                 "\"stock.hight\" is not known and has no effect; perhaps \"stock.height\""));
}

TEST_F(JobFile, WarningsAreBounded) {
    std::string text = R"({"proveout": 1, "program": "a.nc", "stock": {"width": 1, "depth": 2, "height": 3})";
    for (int i = 0; i < 200'000; ++i)
        text += ",\n\"x" + std::to_string(i) + "\": {}";
    const auto job = read(text + "}");
    ASSERT_TRUE(job);
    ASSERT_EQ(job->warnings.size(), 101U);
    EXPECT_EQ(message(job->warnings.back()), "199900 more messages are not shown.");
    EXPECT_EQ(job->warnings.back().severity, Severity::warning);
}

TEST_F(JobFile, ErrorsAndWarningsTogetherAreBounded) {
    std::string wrongTools = "\"tools\": {\"x\": \"ball:d=1\"";
    std::string unknown = "\"gridd\": 0";
    for (int i = 0; i < 20'000; ++i) {
        wrongTools += ", \"x" + std::to_string(i) + "\": \"ball:d=1\"";
        unknown += ", \"y" + std::to_string(i) + "\": 0";
    }
    const auto job = read(with("\"tools\": {", unknown + ", " + wrongTools + ", "));
    ASSERT_FALSE(job);
    ASSERT_EQ(job.error().size(), 101U);
    EXPECT_EQ(message(job.error().back()), "39902 more messages are not shown.");
    EXPECT_EQ(job.error().back().severity, Severity::error);
}

TEST_F(JobFile, SyntaxErrorsHaveLineAndColumn) {
    EXPECT_EQ(reported("{\n  \"proveout\": 1,\n  \"grid\": x\n}"),
              "3:11 This is not valid JSON. [json-syntax]\n");
    EXPECT_THAT(reported("{\n  \"grid\": 1e999\n}"), HasSubstr("2:11 "));
    EXPECT_THAT(reported("{\"grid\": 1e999}"), HasSubstr("1:10 "));
    EXPECT_THAT(reported("1e999"), HasSubstr("1:1 "));
    for (const char* end : {"", "\n", "x"})
        EXPECT_THAT(reported(std::string("{\"proveout\": 1, \"a\": 1]") + end), HasSubstr("1:23 ")) << end;
    EXPECT_THAT(reported("{\"proveout\": 1"), HasSubstr("1:15 "));
    EXPECT_THAT(reported(""), HasSubstr("1:1 This is not valid JSON."));
    EXPECT_THAT(reported("{\"a\": \"\xff\"}"), HasSubstr("1:8 This is not valid JSON."));
    EXPECT_THAT(reported(kWhole + "x"), HasSubstr("[json-syntax]"));
}

TEST_F(JobFile, OtherJsonAndNewerJobsAreRefusedPolitely) {
    for (const char* other : {"{}", "[]", "5", "null", "\"text\"", "{\"grid\": 1}"})
        EXPECT_THAT(reported(other), HasSubstr("[not-a-job]")) << other;
    EXPECT_EQ(reported(R"({"proveout": 3, "everything": "else may differ"})"),
              "0:0 The job was written by a newer Proveout (format 3); this one reads up to format 2. "
              "[job-newer]\n");
    EXPECT_THAT(reported(R"({"proveout": 18446744073709551615})"), HasSubstr("[job-newer]"));
    for (const char* schema : {"0", "-1", "1.5", "\"1\"", "null"})
        EXPECT_THAT(reported(std::string("{\"proveout\": ") + schema + "}"), HasSubstr("\"proveout\""))
            << schema;
}

TEST_F(JobFile, HostileSizesAreRefused) {
    const std::string deep(1'000'000, '[');
    EXPECT_THAT(reported(deep), HasSubstr("[json-depth]"));
    EXPECT_THAT(reported("{\"proveout\": 1, \"x\": " + deep), HasSubstr("deeper than 32 levels"));
    std::string objects;
    for (int i = 0; i < 100'000; ++i)
        objects += "{\"a\":";
    EXPECT_THAT(reported(objects), HasSubstr("[json-depth]"));
    EXPECT_THAT(reported("{\"proveout\": 1, \"x\": \"" + std::string(17'000'000, 'x') + "\"}"),
                HasSubstr("[file-too-large]"));
}

TEST_F(JobFile, ReportsFilesThatCannotBeRead) {
    EXPECT_STREQ(readJob(m_folder / "missing.proveout").error().front().id, "file-unreadable");
    EXPECT_STREQ(readJob(m_folder.path()).error().front().id, "file-not-regular");
}

Job randomJob(std::mt19937& random, const fs::path& folder) {
    std::uniform_real_distribution<double> real(0.001, 5000);
    Job job;
    job.program = folder / "deep" / "prögram \"1\".nc";
    job.setup.stock = {
        {real(random) - 2500, -real(random), real(random)}, real(random), real(random), real(random)};
    job.setup.spacing = real(random);
    if (random() % 2 == 0)
        job.setup.startTool = static_cast<int>(random() % 100);
    job.setup.tools.set(static_cast<int>(1 + random() % 1000), parseCutter("ball:d=11,l=50").value());
    job.setup.tools.set(kLargestTool, parseCutter("flat:d=6.35").value());
    if (random() % 2 == 0)
        job.setup.start = Vec3(real(random), -real(random), 0.1);
    job.setup.blockDelete = random() % 2 == 0;
    job.setup.compensationTypeB = random() % 2 == 0;
    auto& parameters = job.parameters;
    parameters.method = static_cast<DecimationMethod>(random() % kMethodChoices.size());
    parameters.regionCells = 2 + static_cast<int>(random() % 255);
    parameters.period = static_cast<int>(random() % 100) - 1;
    parameters.allowance = real(random) / 1000;
    parameters.certify = random() % 2 == 0;
    parameters.borders = static_cast<BorderRule>(random() % kBorderChoices.size());
    parameters.order = static_cast<RemovalOrder>(random() % kOrderChoices.size());
    parameters.seed = static_cast<int>(random() % 1000);
    parameters.level = static_cast<ErrorLevel>(random() % kLevelChoices.size());
    if (random() % 2 == 0) {
        job.machine.emplace();
        describe(*job.machine, [&](double& value, const Field& field) {
            value = std::uniform_real_distribution<double>(field.minimum, field.maximum)(random);
        });
    }
    if (random() % 2 == 0)
        job.setup.fixtures = {
            {"left jaw", FixtureBox{real(random), real(random), -real(random), 1 + real(random), 2, 0.3}},
            {"screw = 2", FixtureCylinder{0, -real(random), 0, 1 + real(random), 1e-3}}};
    if (random() % 2 == 0)
        job.check = {
            .limits = {.airSeconds = std::abs(real(random)), .rapidClearance = 0.1},
            .off = {{"full-slot:T3", "a \"b\""}, {"air-cutting", {}}},
            .accepted = {{"probing", "ä"}},
            .waivers = {{"rapid-cuts", 3, 7, "1; 2", Vec3(real(random), -0.1, 1e-9), "c", "d", "flat:d=6"},
                        {"code-unknown", 0, 1, "G987", {}, "e", "f"}},
            .limitsOfTools = {{"tap-feed:T7.tapFeedError", std::abs(real(random)) / 1e4}}};
    return job;
}

TEST_F(JobFile, ReadsWhatItWrites) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const fs::path folder = fs::canonical(m_folder.path());
    for (int round = 0; round < 200; ++round) {
        const Job job = randomJob(random, folder);
        ASSERT_TRUE(writeJob(folder / "jobs.proveout", job));
        const auto back = readJob(folder / "jobs.proveout");
        ASSERT_TRUE(back) << oneLine(back.error().front());
        EXPECT_EQ(back->program, job.program);
        EXPECT_EQ(back->setup, job.setup) << "every double comes back bit for bit";
        EXPECT_EQ(back->parameters, job.parameters);
        EXPECT_EQ(back->machine, job.machine);
        EXPECT_EQ(back->check, job.check);
    }
}

TEST_F(JobFile, AJobMovesWithItsProgram) {
    const fs::path folder = fs::canonical(m_folder.path());
    fs::create_directories(folder / "old/jobs");
    Job job = read(kWhole).value();
    job.program = folder / "old/nc/part.nc";
    ASSERT_TRUE(writeJob(folder / "old/jobs/a.proveout", job));
    EXPECT_THAT(readFile(folder / "old/jobs/a.proveout").value(),
                HasSubstr("\"program\": \"../nc/part.nc\""));
    fs::rename(folder / "old", folder / "new");
    EXPECT_EQ(readJob(folder / "new/jobs/a.proveout", anyOutside)->program, folder / "new/nc/part.nc");

    job.program = "/elsewhere/part.nc";
    ASSERT_TRUE(writeJob(folder / "a.proveout", job));
    EXPECT_EQ(readJob(folder / "a.proveout", anyOutside)->program, "/elsewhere/part.nc");
}

TEST_F(JobFile, HasTheLayoutThatOthersWrite) {
    Job job = read(kWhole).value();
    job.program = m_folder / "core-insert.nc";
    ASSERT_TRUE(writeJob(m_folder / "b.proveout", job));
    std::string text = readFile(m_folder / "b.proveout").value();
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
    EXPECT_EQ(
        text,
        R"({"proveout":2,"program":"core-insert.nc","stock":{"minX":-70.0,"minY":-50.5,"topZ":2.0,)"
        R"("width":140.0,"depth":101.0,"height":50.0},"grid":0.5,"tools":{"1":"ball:d=11,l=50","12":"flat:d=6"},)"
        R"("start":[0.0,0.0,50.0],"blockDelete":true,"decimation":{"method":"global","region":16,)"
        R"("period":-1,"allowance":0.02,"certify":false,"borders":"paper","order":"sequential",)"
        R"("seed":7,"level":"surface"}})");
}

TEST_F(JobFile, AProgramNameThatIsNotUtf8IsReported) {
    Job job = read(kWhole).value();
    job.program = m_folder / "\xff\xfe.nc";
    const auto result = writeJob(m_folder / "b.proveout", job);
    ASSERT_FALSE(result);
    EXPECT_STREQ(result.error().front().id, "job-not-utf8");
}

/// With one bit flipped or the end missing, the job is refused, or the values read are within the limits of
/// their fields.
TEST_F(JobFile, SurvivesDamage) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    int readable = 0;
    for (int round = 0; round < 1000; ++round) {
        const auto job = read(damaged(kWhole, random));
        if (!job) {
            ASSERT_FALSE(job.error().empty());
            continue;
        }
        ++readable;
        EXPECT_GT(job->setup.stock.width, 0);
        EXPECT_GT(job->setup.spacing, 0);
        EXPECT_GE(job->parameters.regionCells, 2);
        EXPECT_LE(job->parameters.regionCells, 256);
    }
    EXPECT_LT(readable, 1000);
}

} // namespace
} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
// Golden cases: every folder of tests/data/nc contains `program.ngc` and `expected.jsonl`, the records that
// `interpret` must write for it. A record may omit keys; a missing "unverified" means false. A first record
// {"k":"options"} sets block_delete, start as a point or "unknown", or tools as an object of diameters by
// number: {"1":{"diameter":6}}.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/formats/nc_motion.h"
#include "core/nc/run/interpreter.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kCases = fs::path(PROVEOUT_SOURCE_DIR) / "tests/data/nc";
constexpr double kTolerance = 1e-8; ///< mm, mm/min; the records have nine decimals

std::vector<json> readRecords(std::istream& in) {
    std::vector<json> records;
    for (std::string line; std::getline(in, line);)
        records.push_back(json::parse(line));
    return records;
}

ToolOffsets toolsOf(const json& record) {
    std::map<int, ToolOffset> tools;
    for (const auto& [number, tool] : record.items())
        tools[std::stoi(number)] = {Vec3(0), tool.at("diameter").get<double>()};
    return ToolOffsets(tools);
}

InterpretOptions optionsOf(std::vector<json>& expected) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    options.lint = false;
    if (expected.empty() || expected.front()["k"] != "options")
        return options;
    const json record = expected.front();
    expected.erase(expected.begin());
    options.blockDelete = record.value("block_delete", false);
    options.tools = toolsOf(record.value("tools", json::object()));
    if (const auto start = record.find("start"); start != record.end()) {
        options.assumeStartAtZero = false;
        if (start->is_array())
            options.start = Vec3(start->at(0), start->at(1), start->at(2));
    }
    return options;
}

bool same(const json& expected, const json& actual) {
    if (expected.is_array())
        return actual.size() == expected.size() &&
               std::equal(expected.begin(), expected.end(), actual.begin(), same);
    if (expected.is_number())
        return actual.is_number() && std::abs(expected.get<double>() - actual.get<double>()) < kTolerance;
    return expected == actual;
}

void expectSame(const json& expected, const json& actual) {
    for (const auto& [key, value] : expected.items())
        EXPECT_TRUE(actual.contains(key) && same(value, actual[key]))
            << key << " of " << actual << "\n  expected " << expected;
    EXPECT_EQ(expected.value("unverified", false), actual.value("unverified", false)) << actual;
}

std::vector<json> interpreted(const fs::path& program, const InterpretOptions& options) {
    const auto text = NcText::load(program);
    if (!text)
        throw std::runtime_error(program.string());
    std::ostringstream out;
    writeNcMotion(out, *interpret(*text, options), *text, {"test", "program.ngc", options.blockDelete, {}});
    std::istringstream in(out.str());
    return readRecords(in);
}

class Golden : public testing::TestWithParam<fs::path> {};

std::vector<fs::path> folders() {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(kCases))
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

std::string caseName(const testing::TestParamInfo<fs::path>& info) {
    std::string name = info.param.filename().string();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

} // namespace

TEST_P(Golden, MatchesItsRecords) {
    std::ifstream file(GetParam() / "expected.jsonl");
    ASSERT_TRUE(file);
    std::vector<json> expected = readRecords(file);
    std::vector<json> actual = interpreted(GetParam() / "program.ngc", optionsOf(expected));
    ASSERT_GE(actual.size(), 2U);
    EXPECT_EQ(actual.front()["format"], "nc-motion/1");
    EXPECT_EQ(actual.back()["k"], "sum");
    actual.erase(actual.begin());
    actual.pop_back();
    for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i)
        expectSame(expected[i], actual[i]);
    for (std::size_t i = expected.size(); i < actual.size(); ++i)
        ADD_FAILURE() << "not expected: " << actual[i];
    for (std::size_t i = actual.size(); i < expected.size(); ++i)
        ADD_FAILURE() << "missing: " << expected[i];
}

INSTANTIATE_TEST_SUITE_P(Cases, Golden, testing::ValuesIn(folders()), caseName);

} // namespace proveout::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/oracle_records.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace proveout::test {

namespace {

namespace fs = std::filesystem;

const std::string kPlain = ".oracle.jsonl";
const std::string kPacked = ".oracle.jsonl.gz";

std::string readPlain(const fs::path& file) {
    std::ostringstream out;
    out << std::ifstream(file, std::ios::binary).rdbuf();
    return out.str();
}

/// gzip is an essential package, so a test needs no library for reading its files.
std::string readPacked(const fs::path& file) {
    std::string quoted;
    for (const char c : file.string())
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    FILE* const pipe = popen(("gzip -dc '" + quoted + "'").c_str(), "r");
    std::string text;
    std::vector<char> buffer(1 << 16);
    for (std::size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        text.append(buffer.data(), n);
    pclose(pipe);
    return text;
}

std::istringstream recordsOf(const fs::path& program) {
    const fs::path plain = program.string() + kPlain;
    return std::istringstream(fs::exists(plain) ? readPlain(plain) : readPacked(program.string() + kPacked));
}

constexpr double kMmPerInch = 25.4;
constexpr int kGeneratedTools = 100; ///< minimum, if there is no table

/// The numbers of the generated table: the first hundred, and those in the text.
std::set<int> generatedTools(const fs::path& program) {
    std::set<int> numbers;
    for (int number = 1; number <= kGeneratedTools; ++number)
        numbers.insert(number);
    const std::string text = readPlain(program);
    const std::regex word("[TtHhDd]\\s*0*(\\d{1,5})(?![\\d.])");
    for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it)
        numbers.insert(std::stoi((*it)[1]));
    return numbers;
}

/// A tool table of LinuxCNC, in inches.
std::map<int, ToolOffset> readTable(const fs::path& file) {
    std::map<int, ToolOffset> tools;
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line.substr(0, line.find(';')));
        int number = 0;
        ToolOffset tool;
        for (std::string word; words >> word;) {
            const double value = std::strtod(word.c_str() + 1, nullptr);
            if (word[0] == 'T')
                number = static_cast<int>(value);
            else if (word[0] == 'D')
                tool.diameter = value * kMmPerInch;
            else if (word[0] >= 'X' && word[0] <= 'Z')
                tool.offset[word[0] - 'X'] = value * kMmPerInch;
        }
        if (number > 0)
            tools[number] = tool;
    }
    return tools;
}

} // namespace

std::vector<fs::path> programsWithAnswer(const fs::path& root) {
    std::set<fs::path> programs;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const std::string name = entry.path().string();
        for (const std::string& suffix : {kPlain, kPacked}) {
            if (name.ends_with(suffix))
                programs.insert(name.substr(0, name.size() - suffix.size()));
        }
    }
    return {programs.begin(), programs.end()};
}

ToolOffsets toolsOfAnswer(const fs::path& program) {
    std::istringstream lines = recordsOf(program);
    std::string line;
    std::getline(lines, line);
    const nlohmann::json meta = nlohmann::json::parse(line);
    if (meta.at("tool_table").is_string())
        return ToolOffsets(readTable(program.parent_path() / meta.at("tool_table").get<std::string>()));
    const double length = meta.at("tool_len").get<double>();
    const double diameter = meta.at("tool_dia").get<double>();
    if (length == 0 && diameter == 0)
        return {};
    std::map<int, ToolOffset> tools;
    for (const int number : generatedTools(program))
        tools[number] = {Vec3(0, 0, length), diameter};
    return ToolOffsets(tools);
}

OracleAnswer readAnswer(const fs::path& program) {
    std::istringstream lines = recordsOf(program);
    const std::set<std::string> compared{"rapid", "feed", "arc",   "probe", "tap",
                                         "nurbs", "tool", "dwell", "end"};
    OracleAnswer answer;
    for (std::string line; std::getline(lines, line);) {
        nlohmann::json record = nlohmann::json::parse(line);
        const std::string kind = record.at("k");
        answer.compensated = answer.compensated || (kind == "comp" && record.at("v") != "off");
        answer.cut = answer.cut || kind == "cut";
        if (kind == "error" && answer.errorLine == 0) {
            answer.errorLine = record.at("l").is_null() ? -1 : record.at("l").get<int>();
            answer.errorClass = record.at("cls");
            answer.errorText = record.at("msg");
        }
        if (compared.contains(kind))
            answer.records.push_back(std::move(record));
    }
    return answer;
}

} // namespace proveout::test

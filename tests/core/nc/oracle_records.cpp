// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/oracle_records.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
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

/// gzip is an essential package, so that no library is needed for reading its files in a test.
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

OracleAnswer readAnswer(const fs::path& program) {
    const fs::path plain = program.string() + kPlain;
    std::istringstream lines(fs::exists(plain) ? readPlain(plain) : readPacked(program.string() + kPacked));
    const std::set<std::string> compared{"rapid", "feed", "arc",   "probe", "tap",
                                         "nurbs", "tool", "dwell", "end"};
    OracleAnswer answer;
    for (std::string line; std::getline(lines, line);) {
        nlohmann::json record = nlohmann::json::parse(line);
        const std::string kind = record.at("k");
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

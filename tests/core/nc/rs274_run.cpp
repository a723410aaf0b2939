// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/rs274_run.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include "tests/core/nc/rs274_listing.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;

constexpr double kInch = 25.4;
constexpr std::size_t kMostCalls = 100'000;
constexpr int kCpuSeconds = 2; ///< CPU time, so that load on the machine does not matter
constexpr std::size_t kLongestLine = 240;

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

std::string readAll(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The listing contains block numbers and not lines, so every block gets the number of its line.
std::string numbered(const std::string& line, std::size_t number) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos || line.size() > kLongestLine ||
        std::string("%;(").find(line[begin]) != std::string::npos)
        return line;
    const bool deleted = line[begin] == '/';
    std::size_t at = deleted ? line.find_first_not_of(" \t", begin + 1) : begin;
    if (at == std::string::npos)
        return line;
    if (line[at] == 'N' || line[at] == 'n') {
        at = line.find_first_not_of(" \t", at + 1);
        while (at < line.size() && std::isdigit(static_cast<unsigned char>(line[at])) != 0)
            ++at;
    }
    const std::string rest = at < line.size() ? line.substr(at) : std::string();
    // A digit would become part of the number.
    const std::size_t next = rest.find_first_not_of(" \t");
    if (next != std::string::npos && std::string("0123456789.").find(rest[next]) != std::string::npos)
        return line;
    return fmt::format("{}N{} {}", deleted ? "/" : "", number, rest);
}

/// Whether anything depends on the tool in the spindle.
bool asksForTool(const std::string& program) {
    static const std::regex kAsks("#5400|_current_tool|g43(?![0-9.])(?!.*h)|g4[12](?![0-9.])(?!.*d)",
                                  std::regex::icase);
    return std::ranges::any_of(linesOf(program),
                               [](const std::string& line) { return std::regex_search(line, kAsks); });
}

std::string trimmed(const std::string& line) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    return begin == std::string::npos ? "" : line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
}

int blockNumberOf(const std::string& line) {
    std::size_t at = line.find_first_not_of(" \t/");
    if (at == std::string::npos || (line[at] != 'N' && line[at] != 'n'))
        return -1;
    return std::atoi(line.c_str() + at + 1);
}

} // namespace

Rs274::Rs274(const std::map<int, ToolOffset>& tools)
    : m_home(fs::temp_directory_path() / fmt::format("proveout-rs274-{}", getpid())) {
    fs::create_directories(m_home);
    std::ofstream table(m_home / "tools.tbl"); // its machine configuration is in inches
    int pocket = 0;
    for (const auto& [number, tool] : tools) {
        table << fmt::format("T{} P{} X{:.17g} Y{:.17g} Z{:.17g} D{:.17g}\n", number, ++pocket,
                             tool.offset.x / kInch, tool.offset.y / kInch, tool.offset.z / kInch,
                             tool.diameter / kInch);
    }
    std::ofstream(m_home / "machine.ini")
        << fmt::format("[EMC]\nDEBUG=0\n[DISPLAY]\nPROGRAM_PREFIX={0}\n[RS274NGC]\nSUBROUTINE_PATH={0}"
                       "\nPARAMETER_FILE={0}/values.var\n"
                       "[TRAJ]\nSPINDLES=1\n",
                       m_home.string());
}

Rs274::~Rs274() {
    std::error_code ignored;
    fs::remove_all(m_home, ignored);
}

bool Rs274::isInstalled() {
    return std::system("command -v rs274 > /dev/null 2>&1") == 0;
}

OracleAnswer Rs274::run(const std::string& program) const {
    std::ofstream in(m_home / "program.ngc", std::ios::binary);
    std::size_t number = 0;
    for (const std::string& line : linesOf(program))
        in << numbered(line, ++number) << '\n';
    in.close();
    std::ofstream(m_home / "values.var").close();
    const std::string command = fmt::format("cd '{0}' && export HOME='{0}' LC_ALL=C LD_PRELOAD='{1}' && "
                                            "ulimit -t {2} && exec rs274 -g -n 2 -t tools.tbl -v values.var "
                                            "-i machine.ini program.ngc 2> errors",
                                            m_home.string(), PROVEOUT_WIDE_NUMBERS, kCpuSeconds);
    FILE* const pipe = popen(command.c_str(), "r");
    Rs274Listing listing;
    std::array<char, 4096> line{};
    std::size_t calls = 0;
    while (calls++ < kMostCalls && fgets(line.data(), static_cast<int>(line.size()), pipe) != nullptr) {
        std::string text(line.data());
        while (!text.empty() && (text.back() == '\n' || text.back() == '\r'))
            text.pop_back();
        if (!text.empty())
            listing.readLine(text);
    }
    const int status = pclose(pipe);
    OracleAnswer answer;
    answer.records = listing.releaseRecords();
    answer.compensated = listing.compensated();
    answer.lost = listing.lost();
    if (listing.beforeRename() && asksForTool(program)) {
        answer.records.resize(std::min(answer.records.size(), *listing.beforeRename()));
        answer.lost = "the stand-alone machine keeps its tool at M61";
    }
    if (WIFSIGNALED(status) && WTERMSIG(status) != SIGXCPU && WTERMSIG(status) != SIGKILL &&
        WTERMSIG(status) != SIGPIPE)
        answer.errorClass = "crash";
    else if (WIFSIGNALED(status))
        answer.errorClass = "timeout";
    else if (status != 0)
        readErrors(answer, program);
    return answer;
}

/// Reads the messages, each followed by the line that it refers to.
void Rs274::readErrors(OracleAnswer& answer, const std::string& program) const {
    std::vector<std::string> lines = linesOf(readAll(m_home / "errors"));
    std::erase_if(lines, [](const std::string& line) {
        return line.find_first_not_of(" \t\r") == std::string::npos || line == "executing";
    });
    answer.errorLine = -1;
    answer.errorClass = "other";
    if (lines.empty())
        return;
    answer.errorText = lines.front();
    if (answer.errorText.starts_with("File ended with no percent sign")) {
        answer.errorClass = "no-program-end";
        return;
    }
    if (lines.size() < 2)
        return;
    answer.errorLine = blockNumberOf(lines[1]);
    const std::vector<std::string> source = linesOf(program);
    for (std::size_t i = 0; answer.errorLine < 0 && i < source.size(); ++i) {
        if (trimmed(source[i]) == trimmed(lines[1]))
            answer.errorLine = static_cast<int>(i) + 1;
    }
}

} // namespace proveout::test

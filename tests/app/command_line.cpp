// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/command_line.h"

#include <fstream>
#include <sstream>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include "core/verification/findings/exit_effect.h"
#include "core/verification/findings/findings.h"

namespace proveout {

bool Finished::reports(const std::string& start, const std::string& id) const {
    std::istringstream lines(err);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(start) && line.ends_with("[" + id + "]"))
            return true;
    return false;
}

Finished CommandLine::run(const std::string& arguments, const std::string& before, const std::string& out) {
    return shell(before + " " PROVEOUT_CLI " " + arguments, out);
}

Finished CommandLine::runWithin(std::size_t bytes, const std::string& arguments) {
    return run(arguments, "ulimit -v " + std::to_string(bytes / 1024) + " &&");
}

namespace {

/// The mildest and the most severe exit code.
using Effects = std::pair<ExitEffect, ExitEffect>;

ExitEffect leastEffect(const FindingTable& table, const FindingRow& row) {
    return row.severityRule == SeverityRule::fixed ? exitEffect(table, row) : ExitEffect::none;
}

ExitEffect worstEffect(const FindingTable& table, const FindingRow& row) {
    return row.severityRule == SeverityRule::worstOmitted ? ExitEffect::faults : exitEffect(table, row);
}

/// The effects of all rows with an id, which may differ; an impossible pair if the id has no row.
Effects effectsOfId(std::string_view id) {
    Effects found{ExitEffect::unusable, ExitEffect::none};
    for (const FindingTable& table : findingTables()) {
        for (const FindingRow* row : table.rows) {
            if (row->id != id)
                continue;
            if (worse(found.first, leastEffect(table, *row)) == found.first)
                found.first = leastEffect(table, *row);
            found.second = worse(found.second, worstEffect(table, *row));
        }
    }
    return found;
}

/// The exit codes that the messages in `err` permit, by the table of findings.
Effects effectsOf(const std::string& err) {
    Effects found{ExitEffect::none, ExitEffect::none};
    std::istringstream lines(err);
    for (std::string line; std::getline(lines, line);) {
        const auto id = line.ends_with(']') ? line.rfind('[') : std::string::npos;
        if (id == std::string::npos)
            continue;
        const Effects effects = effectsOfId(line.substr(id + 1, line.size() - id - 2));
        found = {worse(found.first, effects.first), worse(found.second, effects.second)};
    }
    return found;
}

/// A program may be unverified without a message, e.g. if it was not simulated to its end.
void expectListedExitCode(const Finished& finished, const std::string& command) {
    if (finished.exitCode < 0 || finished.exitCode > static_cast<int>(ExitEffect::unusable))
        return;
    const auto effect = static_cast<ExitEffect>(finished.exitCode);
    const auto [least, worst] = effectsOf(finished.err);
    EXPECT_EQ(worse(effect, least), effect) << command << "\n" << finished.err;
    const ExitEffect most = worse(worst, ExitEffect::unverified);
    EXPECT_EQ(worse(effect, most), most) << command << "\n" << finished.err;
}

} // namespace

Finished CommandLine::shell(const std::string& command, const std::string& out) {
    const std::string line =
        "cd '" + folder.path().string() + "' && " + command + " 2>stderr.txt </dev/null >" + out;
    std::filesystem::remove(folder / "stderr.txt");
    const pid_t child = ::fork();
    if (child == 0) {
        ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
        ::_exit(127);
    }
    int status = 0;
    rusage used{};
    EXPECT_EQ(::wait4(child, &status, 0, &used), child);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    Finished finished{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("stdout.txt"), read("stderr.txt"),
                      1024.0 * static_cast<double>(used.ru_maxrss),
                      seconds(used.ru_utime) + seconds(used.ru_stime)};
    if (exists("stderr.txt"))
        expectListedExitCode(finished, line);
    return finished;
}

std::string CommandLine::write(const std::string& name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary) << text;
    return name;
}

std::string CommandLine::read(const std::string& name) {
    std::ifstream file(folder / name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

bool CommandLine::exists(const std::string& name) const {
    return std::filesystem::exists(folder / name);
}

} // namespace proveout

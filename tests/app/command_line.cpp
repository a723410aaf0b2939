// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/command_line.h"

#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace proveout {

bool Finished::tells(const std::string& start, const std::string& id) const {
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

Finished CommandLine::shell(const std::string& command, const std::string& out) {
    const std::string line =
        "cd '" + folder.path().string() + "' && " + command + " 2>stderr.txt </dev/null >" + out;
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
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("stdout.txt"), read("stderr.txt"),
            1024.0 * static_cast<double>(used.ru_maxrss), seconds(used.ru_utime) + seconds(used.ru_stime)};
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

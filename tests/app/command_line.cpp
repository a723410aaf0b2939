// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/command_line.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <sys/wait.h>

namespace proveout {

bool Finished::tells(const std::string& start, const std::string& id) const {
    std::istringstream lines(err);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(start) && line.ends_with("[" + id + "]"))
            return true;
    return false;
}

Finished CommandLine::run(const std::string& arguments, const std::string& before, const std::string& out) {
    const std::string in = "cd '" + folder.path().string() + "' && " + before + " ";
    const int status =
        std::system((in + PROVEOUT_CLI + " " + arguments + " 2>stderr.txt </dev/null >" + out).c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("stdout.txt"), read("stderr.txt")};
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

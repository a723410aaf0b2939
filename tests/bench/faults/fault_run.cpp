// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/faults/fault_run.h"

#include <fstream>

namespace proveout {

namespace {

constexpr unsigned kLongest = 60; ///< seconds

std::vector<std::string> linesOf(const std::filesystem::path& file) {
    std::vector<std::string> lines;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (!line.empty())
            lines.push_back(line);
    return lines;
}

} // namespace

std::vector<std::string> FaultRunner::commandLine(const FaultCase& fault) const {
    const bool isJob = fault.file.extension() == ".proveout";
    const bool isInside = fault.file.parent_path() == m_folder;
    // With "./" a name such as -x.ngc is not taken for an option.
    const std::string file = isInside ? "./" + fault.file.filename().string() : fault.file.string();
    std::vector<std::string> words{m_program.string(), "simulate"};
    if (isJob)
        words.emplace_back("--job");
    words.push_back(file);
    if (!fault.setup.empty())
        words.insert(words.end(), fault.setup.begin(), fault.setup.end());
    else if (!isJob)
        words.insert(words.end(), {"--stock", "40x30x10", "--grid", "0.5", "--tool", "1=flat:d=4,l=20"});
    words.insert(words.end(), {"--stl", "out.stl", "--json"});
    return words;
}

FaultRun FaultRunner::run(const FaultCase& fault) const {
    const MeasuredRun measured = runMeasured(commandLine(fault), m_folder, kLongest);
    return {measured, linesOf(m_folder / "err.txt")};
}

} // namespace proveout

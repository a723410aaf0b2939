// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/faults/fault_run.h"

#include <fcntl.h>
#include <fstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/stop_watch.h"

namespace proveout {

namespace {

constexpr unsigned kLongest = 60; ///< seconds

/// In the child: replaces it by the program. Nothing is allocated between fork and here.
[[noreturn]] void become(const std::filesystem::path& folder, const std::vector<char*>& arguments) {
    const bool ready = ::chdir(folder.c_str()) == 0 &&
                       ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO) >= 0 &&
                       ::dup2(::open("/dev/null", O_WRONLY), STDOUT_FILENO) >= 0 &&
                       ::dup2(::open("err.txt", O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO) >= 0;
    ::alarm(kLongest); // it outlives the change of program
    if (ready)
        ::execv(arguments.front(), arguments.data());
    ::_exit(127);
}

double secondsOf(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

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
    // Its own path says that a name like -x.ngc is no option.
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
    std::vector<std::string> words = commandLine(fault);
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const StopWatch watch;
    const pid_t child = ::fork();
    if (child == 0)
        become(m_folder, pointers);
    int status = 0;
    rusage usage{};
    if (child < 0 || ::wait4(child, &status, 0, &usage) != child)
        throw std::runtime_error("cannot run " + m_program.string());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), watch.seconds(),
            secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime),
            1024 * static_cast<double>(usage.ru_maxrss), linesOf(m_folder / "err.txt")};
}

} // namespace proveout

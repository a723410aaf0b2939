// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/measured_run.h"

#include <fcntl.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/stop_watch.h"

namespace proveout {

namespace {

bool redirect(const char* file, int flags, int descriptor) {
    return ::dup2(::open(file, flags, 0600), descriptor) >= 0;
}

/// Runs in the child: replaces it by the program. Nothing is allocated between fork and here.
[[noreturn]] void become(const std::filesystem::path& folder, const std::vector<char*>& arguments,
                         unsigned longestSeconds) {
    constexpr int kFresh = O_WRONLY | O_CREAT | O_TRUNC;
    const bool ready = ::chdir(folder.c_str()) == 0 && redirect("/dev/null", O_RDONLY, STDIN_FILENO) &&
                       redirect("out.json", kFresh, STDOUT_FILENO) &&
                       redirect("err.txt", kFresh, STDERR_FILENO);
    ::alarm(longestSeconds); // the alarm stays active across exec
    if (ready)
        ::execv(arguments.front(), arguments.data());
    ::_exit(127);
}

double secondsOf(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

} // namespace

MeasuredRun runMeasured(std::vector<std::string> words, const std::filesystem::path& folder,
                        unsigned longestSeconds) {
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const StopWatch watch;
    const pid_t child = ::fork();
    if (child == 0)
        become(folder, pointers, longestSeconds);
    int status = 0;
    rusage usage{};
    if (child < 0 || ::wait4(child, &status, 0, &usage) != child)
        throw std::runtime_error("cannot run " + words.front());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), watch.seconds(),
            secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime),
            1024 * static_cast<double>(usage.ru_maxrss)};
}

} // namespace proveout

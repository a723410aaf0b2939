// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/interpreter_comparison.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/memory.h"
#include "core/nc/run/interpreter.h"

namespace proveout::bench {

namespace {

namespace fs = std::filesystem;

constexpr int kRuns = 3;
constexpr double kMostBytesAMotion = 64;
constexpr const char* kRs274 = "/usr/bin/rs274";

/// A finishing pass over a panel of 2 × 1 m, row by row, as a CAM system writes it.
std::string panel() {
    constexpr int kRows = 1000;
    constexpr int kPoints = 1050;
    std::string text = "G21 G90 G17\nS8000 M3\nG0 X0 Y0 Z5\nF3000\n";
    for (int row = 0; row < kRows; ++row) {
        fmt::format_to(std::back_inserter(text), "G1 Y{:.3f}\n", 1.0 * row);
        for (int k = 1; k < kPoints; ++k) {
            const double x = 2000.0 * (row % 2 == 0 ? k : kPoints - k) / kPoints;
            fmt::format_to(std::back_inserter(text), "G1 X{:.3f} Z{:.3f}\n", x,
                           -5 + 4 * std::sin(x * 0.01) * std::cos(row * 0.013));
        }
    }
    return text + "M2\n";
}

/// A folder of its own, which is also the home of the other interpreter: it truncates a file there.
class Folder {
public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "proveout-bench-XXXXXX").string();
        if (::mkdtemp(name.data()) != nullptr)
            m_path = name;
    }
    ~Folder() {
        std::error_code ignored;
        if (!m_path.empty())
            fs::remove_all(m_path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] const fs::path& path() const { return m_path; }

private:
    fs::path m_path;
};

double cpuSeconds() {
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

double residentBytes() {
    std::ifstream in("/proc/self/statm");
    double total = 0;
    double resident = 0;
    in >> total >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// CPU seconds of a process that lists the motions of `program` into `output`; nothing where it failed.
std::optional<double> rs274Seconds(const fs::path& program, const fs::path& home, const fs::path& output) {
    std::vector<std::string> words{kRs274, "-g", "-n", "2", program.string()};
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::string homeOf = "HOME=" + home.string();
    std::string locale = "LC_ALL=C";
    char* environment[] = {homeOf.data(), locale.data(), nullptr};
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                       0600);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int spawned = ::posix_spawn(&child, kRs274, &actions, nullptr, arguments.data(), environment);
    ::posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    rusage used{};
    if (spawned != 0 || ::wait4(child, &status, 0, &used) != child || status != 0)
        return {};
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

std::size_t motionsListed(const fs::path& listing) {
    std::ifstream in(listing);
    std::size_t count = 0;
    for (std::string line; std::getline(in, line);)
        count += line.find("STRAIGHT_") != std::string::npos ? 1 : 0;
    return count;
}

double ourSeconds(const fs::path& file) {
    const double begin = cpuSeconds();
    const auto program = interpret(NcText::load(file).value());
    return cpuSeconds() - begin;
}

/// Memory that a motion takes while the program is held, and at most while it is made.
bool reportMemory(const NcText& text) {
    const double before = residentBytes();
    const auto program = interpret(text);
    const auto motions = static_cast<double>(program->motionCount());
    const double held = (residentBytes() - before) / motions;
    const double peak = (static_cast<double>(peakMemoryBytes()) - before) / motions;
    fmt::print("resident beside the text: {:.1f} bytes a motion (at most {:.0f}), {:.1f} while it is made\n",
               held, kMostBytesAMotion, std::max(peak, held));
    return held <= kMostBytesAMotion;
}

bool compareSpeed(const fs::path& file, std::size_t lines, std::size_t motions, const fs::path& home) {
    constexpr double kMillion = 1e6;
    const fs::path listing = home / "listing";
    const bool installed = fs::exists(kRs274);
    if (installed && !rs274Seconds(file, home, listing))
        return false;
    double ours = std::numeric_limits<double>::infinity();
    double theirs = ours;
    for (int k = 0; k < kRuns; ++k) {
        ours = std::min(ours, ourSeconds(file));
        if (installed)
            theirs = std::min(theirs, rs274Seconds(file, home, "/dev/null").value_or(theirs));
    }
    const double million = static_cast<double>(lines) / kMillion;
    fmt::print("proveout: {:.3f} s, {:.2f} million lines/s, {} motions\n", ours, million / ours, motions);
    if (!installed) {
        fmt::print("rs274: not installed (Debian package linuxcnc-uspace)\n");
        return true;
    }
    const std::size_t listed = motionsListed(listing);
    fmt::print("rs274 -g: {:.3f} s, {:.2f} million lines/s, {} motions\nratio: {:.1f}\n", theirs,
               million / theirs, listed, theirs / ours);
    return listed == motions;
}

} // namespace

bool compareInterpreters() {
    const Folder folder;
    const fs::path file = folder.path() / "panel.ngc";
    std::ofstream(file, std::ios::binary) << panel();
    const Result<NcText> text = NcText::load(file);
    if (!text) {
        fmt::print("The program cannot be written to {}.\n", file.string());
        return false;
    }
    const std::size_t lines = text->lineCount() - 1;
    fmt::print("{:.1f} MB, {} lines\n", static_cast<double>(text->size()) / 1e6, lines);
    const bool small = reportMemory(*text);
    const bool same = compareSpeed(file, lines, interpret(*text)->motionCount(), folder.path());
    std::fflush(stdout);
    return small && same;
}

} // namespace proveout::bench

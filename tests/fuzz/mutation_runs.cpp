// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of damaged inputs: each is read in a watched process, and none may crash or use more than 5 s or
// 1 GB. Inputs that do are stored as files, with the command that repeats them.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tests/fuzz/mutation_kinds.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/watched_runs.h"
#include "tests/random_seed.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;

struct Options {
    std::size_t runs = 1000; ///< for all kinds together
    std::uint32_t seed = 0;
    std::string kind;                        ///< empty: all
    std::optional<std::size_t> only;         ///< runs only this one of each kind
    std::string file;                        ///< used instead of damaged ones
    std::string found = "mutation-findings"; ///< a folder
};

/// A folder of this process, removed with its content.
class Workplace {
public:
    Workplace() {
        std::string name = (fs::temp_directory_path() / "proveout-mutation-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw std::runtime_error("there is no temporary folder");
        m_path = name;
    }
    ~Workplace() {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

    [[nodiscard]] const fs::path& path() const { return m_path; }

private:
    fs::path m_path;
};

/// The inputs of a kind: the number of the run determines the seed file and its changes.
class Inputs {
public:
    Inputs(const MutationKind& kind, const fs::path& folder, std::uint32_t seed)
        : m_seeds(kind.seeds(folder)), m_words(kind.words()), m_seed(seed) {}

    [[nodiscard]] std::string input(std::size_t run) const {
        std::seed_seq sequence{m_seed, static_cast<std::uint32_t>(run)};
        MutationRandom random(sequence);
        return mutated(m_seeds[random() % m_seeds.size()], m_words, random);
    }

private:
    Seeds m_seeds;
    std::vector<std::string> m_words;
    std::uint32_t m_seed;
};

void writeBytes(const fs::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

template<class Measure>
std::size_t worstOf(const std::vector<WatchedRun>& runs, const Measure& measure) {
    return static_cast<std::size_t>(std::ranges::max_element(runs, {}, measure) - runs.begin());
}

void printCosts(const MutationKind& kind, const std::vector<WatchedRun>& runs, std::size_t first) {
    const std::size_t slowest = worstOf(runs, &WatchedRun::seconds);
    const std::size_t largest = worstOf(runs, &WatchedRun::peakBytes);
    fmt::print("{:<18}{:>8}{:>9}{:>10.3f} s (run {}){:>8} MB (run {})\n", kind.key, runs.size(),
               std::ranges::count(runs, true, &WatchedRun::accepted), runs[slowest].seconds, first + slowest,
               runs[largest].peakBytes / 1'000'000, first + largest);
}

/// Stores the inputs that exceeded a limit, and the requested one; returns how many exceeded a limit.
std::size_t keepFindings(const MutationKind& kind, const std::vector<WatchedRun>& runs, std::size_t first,
                         const Inputs& inputs, const Options& options) {
    std::size_t findings = 0;
    for (std::size_t index = 0; index < runs.size(); ++index) {
        const bool broke = runs[index].end != RunEnd::done;
        if (!broke && !options.only)
            continue;
        findings += broke ? 1 : 0;
        const std::size_t run = first + index;
        fs::create_directories(options.found);
        const fs::path kept = fs::absolute(options.found) /
                              fmt::format("{}-{}-{}{}", kind.key, options.seed, run, kind.extension);
        writeBytes(kept, inputs.input(run));
        fmt::print("{} run {} {}; repeat it with\n    mutation_runs --kind {} --file {}\n", kind.key, run,
                   sentenceOf(runs[index], RunLimits()), kind.key, kept.string());
    }
    return findings;
}

std::size_t runKind(const MutationKind& kind, std::size_t count, const Options& options) {
    const Workplace workplace;
    const fs::path home = fs::current_path();
    const fs::path file = workplace.path() / (std::string("input") + kind.extension);
    const Inputs inputs(kind, workplace.path(), options.seed);
    const std::size_t first = options.only.value_or(0);
    fs::current_path(workplace.path()); // damaged inputs may contain relative names
    const auto runs = watchRuns(options.only ? 1 : count, RunLimits(), [&](std::size_t index) {
        writeBytes(file, inputs.input(first + index));
        return kind.run(file);
    });
    fs::current_path(home);
    printCosts(kind, runs, first);
    return keepFindings(kind, runs, first, inputs, options);
}

/// Runs one input unchanged.
std::size_t runFile(const MutationKind& kind, const std::string& name) {
    const fs::path file = fs::absolute(name);
    const auto runs = watchRuns(1, RunLimits(), [&](std::size_t) { return kind.run(file); });
    printCosts(kind, runs, 0);
    if (runs.front().end == RunEnd::done)
        return 0;
    fmt::print("{} {}\n", name, sentenceOf(runs.front(), RunLimits()));
    return 1;
}

std::size_t runAll(const Options& options) {
    std::vector<const MutationKind*> chosen;
    for (const MutationKind& kind : mutationKinds())
        if (options.kind.empty() || options.kind == kind.key)
            chosen.push_back(&kind);
    if (!options.file.empty())
        return chosen.size() == 1 ? runFile(*chosen.front(), options.file) : 1;
    fmt::print("seed {}\n{:<18}{:>8}{:>9}{:>12}{:>20}\n", options.seed, "kind", "runs", "accepted", "slowest",
               "largest");
    const std::size_t each = (options.runs + chosen.size() - 1) / chosen.size();
    return std::accumulate(chosen.begin(), chosen.end(), std::size_t{0},
                           [&](std::size_t sum, const MutationKind* kind) {
                               std::fflush(stdout);
                               return sum + runKind(*kind, each, options);
                           });
}

void addOptions(CLI::App& app, Options& options) {
    std::vector<std::string> kinds;
    for (const MutationKind& kind : mutationKinds())
        kinds.emplace_back(kind.key);
    app.add_option("--runs", options.runs, "Damaged inputs, shared evenly by the kinds")
        ->check(CLI::PositiveNumber);
    app.add_option("--seed", options.seed, "Of the random damage (a new one, or PROVEOUT_SEED)");
    auto* kind =
        app.add_option("--kind", options.kind, "One kind of input only")->check(CLI::IsMember(kinds));
    app.add_option("--run", options.only, "One run only, by its number; its input is kept");
    app.add_option("--file", options.file, "Read this file instead of damaged ones")
        ->check(CLI::ExistingFile)
        ->needs(kind);
    app.add_option("--found", options.found, "Folder for inputs that broke a limit");
}

} // namespace

} // namespace proveout::test

int main(int argc, char** argv) {
    using namespace proveout::test;
    CLI::App app("Reads damaged inputs and measures each of them", "mutation_runs");
    Options options;
    options.seed = proveout::randomSeed();
    addOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    const std::size_t findings = runAll(options);
    if (findings > 0)
        fmt::print("{} inputs broke a limit.\n", findings);
    return findings == 0 ? 0 : 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/core/temporary_folder.h"

namespace proveout {

struct Finished {
    int exitCode = -1; ///< -1: ended by a signal
    std::string out;
    std::string err;
    double peakBytes = 0;  ///< resident memory
    double cpuSeconds = 0; ///< of all its threads

    /// The single JSON object on stdout; null if there is none.
    [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out, nullptr, false); }
    /// Whether a line of stderr begins with `start` and ends with `[id]`.
    [[nodiscard]] bool reports(const std::string& start, const std::string& id) const;
};

/// Runs the real binary in a separate folder.
class CommandLine : public testing::Test {
protected:
    /// `before`: shell commands to run first, with their separator, e.g. "ulimit -f 100;". `out`: where
    /// stdout is redirected to.
    Finished run(const std::string& arguments, const std::string& before = {},
                 const std::string& out = "stdout.txt");
    /// Runs with an address space of the given number of bytes.
    Finished runWithin(std::size_t bytes, const std::string& arguments);
    /// Writes a file into the folder and returns its name.
    std::string write(const std::string& name, const std::string& text);
    std::string read(const std::string& name);
    [[nodiscard]] bool exists(const std::string& name) const;

    TemporaryFolder folder;

private:
    Finished shell(const std::string& command, const std::string& out);
};

inline const std::string kStock = " --stock 40x30x10 --grid 0.5 ";
inline const std::string kTool = " --tool 1=ball:d=4,l=20 ";
/// A correct program with five motion blocks.
inline const std::string kSound =
    "G21 G90\nT1 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX30\nG2 X20 I-5 J0\nG0 Z5\nM30\n";

} // namespace proveout

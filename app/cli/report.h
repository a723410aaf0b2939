// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "core/base/diagnostic.h"

namespace proveout::cli {

/// The messages of a command: each is printed on stderr immediately, and together they determine the exit
/// code and are listed in the JSON.
class Report {
public:
    /// `file` is used for messages without a file of their own.
    explicit Report(std::string file) : m_file(std::move(file)) {}

    void add(Diagnostics diagnostics);
    /// For errors that stopped the command or prevented an output: exit code 3.
    void addFatal(Diagnostics diagnostics);
    /// Something could not be checked, and a message about it was added already.
    void markUnverified() { m_unverified = true; }

    [[nodiscard]] ExitCode exitCode() const;
    /// The messages about what was checked, and about what could not be checked.
    [[nodiscard]] nlohmann::ordered_json findings() const;
    [[nodiscard]] nlohmann::ordered_json unverified() const;

private:
    [[nodiscard]] nlohmann::ordered_json listed(bool unverified) const;

    std::string m_file;
    Diagnostics m_diagnostics;
    bool m_unverified = false;
    bool m_fatal = false;
};

/// Prints one JSON object on stdout; bytes that are not UTF-8 (in file names) are replaced.
void printJson(const nlohmann::ordered_json& object);

} // namespace proveout::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "core/base/diagnostic.h"

namespace proveout::cli {

/// What a command has to tell about its inputs: each message goes to stderr at once, and all of them decide
/// the exit code and stand in the JSON.
class Report {
public:
    /// `file` names messages that have no file of their own.
    explicit Report(std::string file) : m_file(std::move(file)) {}

    void add(Diagnostics diagnostics);
    /// What stopped the command, or kept an output from being written: exit code 3.
    void addFatal(Diagnostics diagnostics);
    /// Something could not be checked, and a message has said so already.
    void markUnverified() { m_unverified = true; }

    [[nodiscard]] ExitCode exitCode() const;
    /// The messages about what was checked, and those about what could not be.
    [[nodiscard]] nlohmann::ordered_json findings() const;
    [[nodiscard]] nlohmann::ordered_json unverified() const;

private:
    [[nodiscard]] nlohmann::ordered_json listed(bool unverified) const;

    std::string m_file;
    Diagnostics m_diagnostics;
    bool m_unverified = false;
    bool m_fatal = false;
};

/// Prints one JSON object on stdout; bytes that are no UTF-8 (of file names) are replaced.
void printJson(const nlohmann::ordered_json& object);

} // namespace proveout::cli

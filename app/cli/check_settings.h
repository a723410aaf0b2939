// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/check_program.h"
#include "core/base/diagnostic.h"

namespace proveout::cli {

/// `--rules` and `--accept`.
class CheckSettings {
public:
    /// This object must outlive the parsing.
    void addTo(CLI::App& command);
    /// Sets limits, rules that are off, and what is accepted. Errors: an unknown id or key, a value out of
    /// range.
    [[nodiscard]] Result<void> read(CheckOptions& options) const;
    /// Notes all options of a parsed command on which its results depend.
    void note(const CLI::App& command);
    /// These options as text: two checks with the same text judge alike.
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    std::string m_rules;
    std::string m_accepted;
    std::string m_text;
};

} // namespace proveout::cli

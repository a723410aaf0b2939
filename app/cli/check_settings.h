// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "core/base/diagnostic.h"
#include "core/simulation/setup/check_rules.h"

namespace proveout::cli {

/// `--rules` and `--accept`.
class CheckSettings {
public:
    /// This object must outlive the parsing.
    void addTo(CLI::App& command);
    /// Sets limits, rules that are off, and what is accepted, in addition to those of a job. Errors: an
    /// unknown id or key, a value out of range; independent of `rules`.
    [[nodiscard]] Result<void> apply(CheckRules& rules) const;
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

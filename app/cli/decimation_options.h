// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include <CLI/CLI.hpp>

#include "core/decimation/parameters.h"

namespace proveout::cli {

/// One option a field of DecimationParameters, made from its description.
class DecimationOptions {
public:
    /// This object must outlive the parsing.
    void addTo(CLI::App& command);
    [[nodiscard]] bool given(const std::string& key) const { return m_given.contains(key); }
    /// Puts what was given over `parameters`. Where `standards` asks for it, or the method has
    /// become another, what was not given becomes the standard of the method (region size, period).
    void apply(DecimationParameters& parameters, bool standards) const;

private:
    std::map<std::string, std::string> m_given; ///< by field key; values that the parser has checked
};

} // namespace proveout::cli

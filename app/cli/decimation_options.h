// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/field_options.h"
#include "core/decimation/regions/parameters.h"

namespace proveout::cli {

/// One option a field of DecimationParameters, made from its description.
class DecimationOptions {
public:
    /// This object must outlive the parsing.
    void addTo(CLI::App& command);
    [[nodiscard]] bool given(const std::string& key) const { return m_given.contains(key); }
    /// Whether region size and period of the parameters have been named elsewhere.
    struct Named {
        bool region = false;
        bool period = false;
    };
    /// Puts what was given over `parameters`. Region size and period that were neither given nor named, or
    /// named for another method, become its standards on a map of `points`.
    void apply(DecimationParameters& parameters, Named named, double points) const;

private:
    GivenFields m_given;
};

} // namespace proveout::cli

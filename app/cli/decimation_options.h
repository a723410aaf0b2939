// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/field_options.h"
#include "core/decimation/regions/parameters.h"

namespace proveout::cli {

/// One option per field of DecimationParameters, created from its description.
class DecimationOptions {
public:
    /// This object must outlive the parsing.
    void addTo(CLI::App& command);
    [[nodiscard]] bool given(const std::string& key) const { return m_given.contains(key); }
    /// Whether region size and period of the parameters were set elsewhere.
    struct Named {
        bool region = false;
        bool period = false;
    };
    /// Overrides `parameters` with the given options. Region size and period that were not set anywhere, or
    /// only for another method, become the defaults for a z-map of `points` points.
    void apply(DecimationParameters& parameters, Named named, double points) const;

private:
    GivenFields m_given;
};

} // namespace proveout::cli

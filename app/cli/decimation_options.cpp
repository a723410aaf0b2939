// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/decimation_options.h"

#include <fmt/format.h>

#include "core/decimation/regions/region_decimator.h"

namespace proveout::cli {

namespace {

/// "8", or "20; global: 1" if methods differ.
std::string defaultOf(int DecimationMethodRow::*number) {
    const int first = decimationMethods().front().*number;
    std::string text = std::to_string(first);
    for (const DecimationMethodRow& method : decimationMethods())
        if (method.*number != first)
            text += fmt::format("; {}: {}", kMethodChoices[static_cast<std::size_t>(method.method)].key,
                                method.*number);
    return text;
}

} // namespace

void DecimationOptions::addTo(CLI::App& command) {
    const DecimationParameters defaults;
    const std::string region = fmt::format("{}; doubled up to {} if a map would have more than {} regions",
                                           defaultOf(&DecimationMethodRow::defaultRegion),
                                           kLargestDefaultRegion, kMostDefaultRegions);
    describe(defaults,
             OptionAdder{command,
                         m_given,
                         "Decimation",
                         {{"region", region}, {"period", defaultOf(&DecimationMethodRow::defaultPeriod)}}});
}

void DecimationOptions::apply(DecimationParameters& parameters, Named named, double points) const {
    const DecimationMethod before = parameters.method;
    Result<void> result; // stays without errors, because the parser has checked these texts
    describe(parameters, OptionReader{m_given, result});
    const bool sameMethod = parameters.method == before;
    useDefaults(parameters, given("region") || (named.region && sameMethod),
                given("period") || (named.period && sameMethod), points);
}

} // namespace proveout::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cassert>

#include "core/decimation/certified_border.h"
#include "core/decimation/certified_decimator.h"
#include "core/decimation/lee_decimator.h"
#include "core/decimation/region_decimator.h"

namespace proveout {

namespace {

std::unique_ptr<RegionDecimator> createLee() {
    return std::make_unique<LeeDecimator>();
}

std::unique_ptr<RegionDecimator> createCertified() {
    return std::make_unique<CertifiedDecimator>();
}

BorderLine leeBorder(const BorderSamples& border, const DecimationParameters& parameters) {
    return simplifyBorder(border.heights, border.step, border.seed, parameters);
}

BorderLine certifiedBorderLine(const BorderSamples& border, const DecimationParameters& parameters) {
    return certifiedBorder(border.heights, borderAllowance(parameters), border.extras);
}

// In the order of DecimationMethod. The paper's figures stand on regions of 8 × 8 cells and a period of 20;
// its global decimation follows every movement of the tool (§2.1).
constexpr std::array kMethods{
    DecimationMethodRow{DecimationMethod::certified, false, 64, 20, createCertified, certifiedBorderLine},
    DecimationMethodRow{DecimationMethod::lee, false, 8, 20, createLee, leeBorder},
    DecimationMethodRow{DecimationMethod::global, true, 8, 1, createLee, leeBorder},
    DecimationMethodRow{DecimationMethod::none, false, 8, 0, nullptr, nullptr},
};

} // namespace

std::span<const DecimationMethodRow> decimationMethods() {
    return kMethods;
}

const DecimationMethodRow& row(DecimationMethod method) {
    const DecimationMethodRow& found = kMethods[static_cast<std::size_t>(method)];
    assert(found.method == method);
    return found;
}

void useStandards(DecimationParameters& parameters, bool regionGiven, bool periodGiven) {
    if (!regionGiven)
        parameters.regionCells = row(parameters.method).standardRegion;
    if (!periodGiven)
        parameters.period = row(parameters.method).standardPeriod;
}

bool isBounded(const DecimationParameters& parameters) {
    return parameters.method == DecimationMethod::certified || parameters.certify;
}

} // namespace proveout

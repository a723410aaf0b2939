// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

#include "core/decimation/certified/certified_border.h"
#include "core/decimation/certified/certified_decimator.h"
#include "core/decimation/lee/lee_decimator.h"
#include "core/decimation/regions/region_decimator.h"

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
    std::vector<std::uint32_t> kept;
    std::ranges::set_union(border.extras, border.walls, std::back_inserter(kept));
    BorderLine line = certifiedBorder(border.heights, borderAllowance(parameters), kept);
    line.extras.assign(border.extras.begin(), border.extras.end());
    return line;
}

constexpr std::array<std::string_view, 5> kCertifiedFields{"region", "period", "allowance", "borders",
                                                           "level"};
constexpr std::array<std::string_view, 7> kLeeFields{"region",  "period", "allowance", "certify",
                                                     "borders", "order",  "seed"};
constexpr std::array<std::string_view, 6> kGlobalFields{"period",  "allowance", "certify",
                                                        "borders", "order",     "seed"};

constexpr double kMostPoints = std::numeric_limits<std::int32_t>::max();

// In the order of DecimationMethod. A mesh of the paper's method has six half-edges per point and counts them
// by int. Regions of the certified method are small, because a cut that touches one invalidates all of it;
// when cutting pauses they are merged. The paper's figures use regions of 8 × 8 cells and a period of 20; its
// global decimation follows every movement of the tool (§2.1).
constexpr std::array kMethods{
    DecimationMethodRow{DecimationMethod::certified, false, 16, 5, 25, kMostPoints, createCertified,
                        certifiedBorderLine, kCertifiedFields},
    DecimationMethodRow{DecimationMethod::lee, false, 8, 20, 25, kMostPoints, createLee, leeBorder,
                        kLeeFields},
    DecimationMethodRow{DecimationMethod::global, true, 8, 1, 220, kMostPoints / 6, createLee, leeBorder,
                        kGlobalFields},
    DecimationMethodRow{DecimationMethod::none, false, 8, 0, 25, kMostPoints, nullptr, nullptr, {}},
};

} // namespace

bool DecimationMethodRow::uses(std::string_view field) const {
    return field == "method" || std::find(fields.begin(), fields.end(), field) != fields.end();
}

std::span<const DecimationMethodRow> decimationMethods() {
    return kMethods;
}

const DecimationMethodRow& row(DecimationMethod method) {
    const DecimationMethodRow& found = kMethods[static_cast<std::size_t>(method)];
    assert(found.method == method);
    return found;
}

int defaultRegion(DecimationMethod method, double points) {
    int cells = row(method).defaultRegion;
    while (cells < kLargestDefaultRegion && points > kMostDefaultRegions * static_cast<double>(cells * cells))
        cells *= 2;
    return cells;
}

void useDefaults(DecimationParameters& parameters, bool regionGiven, bool periodGiven, double points) {
    if (!regionGiven)
        parameters.regionCells = defaultRegion(parameters.method, points);
    if (!periodGiven)
        parameters.period = row(parameters.method).defaultPeriod;
}

bool isBounded(const DecimationParameters& parameters) {
    return parameters.method == DecimationMethod::certified || parameters.certify;
}

ErrorLevel errorLevel(const DecimationParameters& parameters) {
    return parameters.method == DecimationMethod::certified ? parameters.level : ErrorLevel::sample;
}

bool canMerge(const DecimationParameters& parameters) {
    return parameters.method == DecimationMethod::certified && parameters.borders == BorderRule::shared &&
           parameters.allowance > 0;
}

DecimationParameters whileCutting(DecimationParameters parameters) {
    parameters.level = ErrorLevel::sample;
    return parameters;
}

DecimationParameters forExport(DecimationParameters parameters) {
    parameters.borders = BorderRule::shared;
    parameters.regionCells = std::min(parameters.regionCells, kMostExportCells);
    return parameters;
}

} // namespace proveout

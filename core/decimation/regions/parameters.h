// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "core/base/field.h"
#include "core/base/text.h"

namespace proveout {

enum class DecimationMethod : std::uint8_t {
    certified, ///< insertion and removal under an error bound; see certified_decimator.h
    lee,       ///< the paper's local decimation, region by region
    global,    ///< the paper's §2.1, the whole map at once, for comparison
    none,      ///< always the full mesh
};

enum class BorderRule : std::uint8_t {
    shared, ///< borders are simplified first, each by its own samples, so that there are no cracks
    paper,  ///< each region simplifies its own copy, which causes cracks; for studies only, never exported
};

enum class RemovalOrder : std::uint8_t { random, sequential };

/// Where a surface stays within its allowance, or where an error is measured.
enum class ErrorLevel : std::uint8_t {
    sample,  ///< at every z-map point; between two of them, at a wall, the deviation may be larger
    surface, ///< everywhere
};

/// The parameters of the paper (§5: region size, period s, error allowance e) and of this program. Value
/// type.
struct DecimationParameters {
    DecimationMethod method = DecimationMethod::certified;
    int regionCells = 16;    ///< a region is regionCells × regionCells cells
    int period = 5;          ///< s: every s-th motion block; -1 once at the start, 0 never
    double allowance = 0.05; ///< e, mm; 0 means no decimation
    bool certify = true;     ///< refuse a removal that would leave a z-map point farther than e away
                             ///< vertically
    BorderRule borders = BorderRule::shared;
    RemovalOrder order = RemovalOrder::random;
    int seed = 1;
    ErrorLevel level = ErrorLevel::surface; ///< for the certified method; during cutting it is `sample`

    friend bool operator==(const DecimationParameters&, const DecimationParameters&) = default;
};

inline constexpr std::array kMethodChoices{
    Choice{"certified", PROVEOUT_TEXT("Core", "Certified")},
    Choice{"lee", PROVEOUT_TEXT("Core", "Lee & Lee (local)")},
    Choice{"global", PROVEOUT_TEXT("Core", "Global")},
    Choice{"none", PROVEOUT_TEXT("Core", "None (full mesh)")},
};
inline constexpr std::array kBorderChoices{
    Choice{"shared", PROVEOUT_TEXT("Core", "Shared, no cracks")},
    Choice{"paper", PROVEOUT_TEXT("Core", "Per region, as in the paper")},
};
inline constexpr std::array kOrderChoices{
    Choice{"random", PROVEOUT_TEXT("Core", "Random")},
    Choice{"sequential", PROVEOUT_TEXT("Core", "Sequential")},
};

inline constexpr std::array kLevelChoices{
    Choice{"sample", PROVEOUT_TEXT("Core", "At every z-map point")},
    Choice{"surface", PROVEOUT_TEXT("Core", "Everywhere")},
};

/// Visits every field once; see field.h.
template<ParametersOf<DecimationParameters> Params, class Visitor>
void describe(Params& params, Visitor&& visit) {
    visit(params.method,
          Field{"method", PROVEOUT_TEXT("Core", "Method"), "",
                PROVEOUT_TEXT("Core", "How the mesh of a region is decimated."), 0, 0, 0, kMethodChoices});
    visit(params.regionCells,
          Field{"region", PROVEOUT_TEXT("Core", "Region size"), "cells",
                PROVEOUT_TEXT("Core", "Cells along each side of a region; each region has its own mesh."), 2,
                256, 1});
    visit(params.period,
          Field{"period", PROVEOUT_TEXT("Core", "Decimation period"), "blocks",
                PROVEOUT_TEXT("Core", "Cut regions are decimated again after this many blocks; "
                                      "-1: once at the start, 0: never."),
                -1, 1000000, 1});
    visit(params.allowance,
          Field{"allowance", PROVEOUT_TEXT("Core", "Error allowance"), "mm",
                PROVEOUT_TEXT("Core", "Largest vertical error of the decimated surface; 0: no decimation."),
                0, 10, 0.01});
    visit(params.certify,
          Field{"certify", PROVEOUT_TEXT("Core", "Certify"), "",
                PROVEOUT_TEXT("Core", "Keep every z-map point within the error allowance; off: exactly as in "
                                      "the paper, which gives no bound.")});
    visit(params.borders, Field{"borders", PROVEOUT_TEXT("Core", "Borders"), "",
                                PROVEOUT_TEXT("Core", "How the borders between regions are simplified."), 0,
                                0, 0, kBorderChoices});
    visit(params.order, Field{"order", PROVEOUT_TEXT("Core", "Removal order"), "",
                              PROVEOUT_TEXT("Core", "The order in which vertices are tested for removal."), 0,
                              0, 0, kOrderChoices});
    visit(params.seed,
          Field{"seed", PROVEOUT_TEXT("Core", "Random seed"), "",
                PROVEOUT_TEXT("Core", "Start of the random order; equal seeds give equal meshes."), 0,
                1000000, 1});
    visit(params.level, Field{"level", PROVEOUT_TEXT("Core", "Error level"), "",
                              PROVEOUT_TEXT("Core", "Where the certified method keeps its surface within "
                                                    "the error allowance, at rest and in exports; while "
                                                    "cutting, it is at every z-map point."),
                              0, 0, 0, kLevelChoices});
}

} // namespace proveout

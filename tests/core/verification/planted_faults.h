// SPDX-License-Identifier: GPL-3.0-or-later
// Random programs with one planted fault each, beside their clean twins, on a stock of 140 × 110 × 20 mm
// whose top is at Z0. A new kind of fault is one row.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "core/simulation/setup/machine.h"
#include "core/simulation/setup/setup.h"
#include "tests/core/verification/twin_program.h"

namespace proveout {

/// What a kind of fault writes to. T1 is a mill, built after it was written; T2 a drill of 4 mm; T3 a keyseat
/// cutter of 12 mm with a neck of 6 mm; T4 an M6 tap.
struct Planting {
    TwinProgram program;
    std::string shape = "flat"; ///< of T1: flat, ball, bull
    int diameter = 4;           ///< of T1; even, so that its axis and its edge are above points of the grid
    int flutes = 16;
    int stickOut = 30;
    int holder = 30;                  ///< diameter
    int shank = 0;                    ///< diameter; 0: not given
    std::optional<double> value = {}; ///< of the finding, in its unit; nothing: not known exactly
    std::optional<Machine> machine = {};
    std::set<std::string> alsoFound = {}; ///< ids that the fault also breaks
    Fixtures fixtures = {};
    std::string limits = {}; ///< of T1, as in a tool table: ",maxap=4"
    double holderClearance = 0;
};

struct PlantedKind {
    const char* name;
    const char* id; ///< of the finding
    void (*plant)(Planting& planting);
    bool alone = false; ///< the program has no other cuts
};

/// One planted fault and its twin. Value type.
struct PlantedPair {
    std::string faulty;
    std::string clean;
    int line = 0; ///< of the fault; 0: the program as a whole
    std::optional<double> value = {};
    std::optional<Machine> machine = {};
    std::set<std::string> alsoFound = {};
    double holderClearance = 0;
    Setup setup;
};

[[nodiscard]] std::span<const PlantedKind> plantedKinds();
/// Equal seeds give equal programs.
[[nodiscard]] PlantedPair plantedPair(const PlantedKind& kind, std::uint_fast32_t seed);

} // namespace proveout

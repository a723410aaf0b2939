// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/machine_profiles.h"

#include <algorithm>
#include <array>

namespace proveout {

namespace {

// Travel ends at 0, where the machine zero of most machines is; that of a router is at its near left corner.
constexpr std::array kProfiles{
    MachineProfile{"router",
                   PROVEOUT_TEXT("Core", "Router 600 × 400 × 100"),
                   {.rapidXY = 5000,
                    .rapidZ = 3000,
                    .largestFeed = 4000,
                    .largestSpindle = 24000,
                    .accelerationXY = 500,
                    .accelerationZ = 300,
                    .cornerDeviation = 0.05,
                    .toolChangeSeconds = 60,
                    .minX = 0,
                    .maxX = 600,
                    .minY = 0,
                    .maxY = 400,
                    .minZ = -100,
                    .maxZ = 0}},
    MachineProfile{"knee-mill",
                   PROVEOUT_TEXT("Core", "Knee mill 760 × 400 × 125"),
                   {.rapidXY = 6000,
                    .rapidZ = 4000,
                    .largestFeed = 5000,
                    .largestSpindle = 4500,
                    .accelerationXY = 600,
                    .accelerationZ = 500,
                    .toolChangeSeconds = 90,
                    .minX = -760,
                    .maxX = 0,
                    .minY = -400,
                    .maxY = 0,
                    .minZ = -125,
                    .maxZ = 0}},
    MachineProfile{"vmc-500",
                   PROVEOUT_TEXT("Core", "Machining centre 500 × 400 × 500"),
                   {.rapidXY = 25000,
                    .rapidZ = 25000,
                    .largestFeed = 16000,
                    .largestSpindle = 8100,
                    .accelerationXY = 3000,
                    .accelerationZ = 3000,
                    .toolChangeSeconds = 4,
                    .minX = -500,
                    .maxX = 0,
                    .minY = -400,
                    .maxY = 0,
                    .minZ = -500,
                    .maxZ = 0}},
    MachineProfile{"vmc-760",
                   PROVEOUT_TEXT("Core", "Machining centre 760 × 400 × 500"),
                   {.rapidXY = 25000,
                    .rapidZ = 25000,
                    .largestFeed = 16000,
                    .largestSpindle = 8100,
                    .accelerationXY = 2500,
                    .accelerationZ = 2500,
                    .toolChangeSeconds = 5,
                    .minX = -760,
                    .maxX = 0,
                    .minY = -400,
                    .maxY = 0,
                    .minZ = -500,
                    .maxZ = 0}},
    MachineProfile{"vmc-1270",
                   PROVEOUT_TEXT("Core", "Machining centre 1270 × 660 × 635"),
                   {.rapidXY = 15000,
                    .rapidZ = 15000,
                    .largestFeed = 12000,
                    .largestSpindle = 8100,
                    .accelerationXY = 1500,
                    .accelerationZ = 1500,
                    .toolChangeSeconds = 7,
                    .minX = -1270,
                    .maxX = 0,
                    .minY = -660,
                    .maxY = 0,
                    .minZ = -635,
                    .maxZ = 0}},
};

} // namespace

std::span<const MachineProfile> machineProfiles() {
    return kProfiles;
}

std::string machineProfileKeys() {
    std::string keys;
    for (const MachineProfile& profile : kProfiles)
        keys += (keys.empty() ? "" : ", ") + std::string(profile.key);
    return keys;
}

Machine machineOf(const MachineProfile& profile, const Machine& placed) {
    Machine machine = profile.machine;
    machine.offsetX = placed.offsetX;
    machine.offsetY = placed.offsetY;
    machine.offsetZ = placed.offsetZ;
    return machine;
}

const MachineProfile* findMachineProfile(std::string_view key) {
    const auto found = std::ranges::find(kProfiles, key, &MachineProfile::key);
    return found == kProfiles.end() ? nullptr : &*found;
}

} // namespace proveout

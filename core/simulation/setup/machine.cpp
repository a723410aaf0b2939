// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/machine.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "core/base/described_values.h"
#include "core/simulation/setup/machine_profiles.h"
#include "core/simulation/setup/setup_findings.h"

namespace proveout {

std::optional<std::pair<double, double>> Machine::travel(int axis) const {
    const std::pair<double, double> limits[] = {{minX, maxX}, {minY, maxY}, {minZ, maxZ}};
    const std::pair<double, double>& of = limits[axis];
    return of.first < of.second ? std::optional(of) : std::nullopt;
}

std::optional<Vec3> Machine::programZero() const {
    const Vec3 zero{offsetX, offsetY, offsetZ};
    return zero == Vec3(0) ? std::nullopt : std::optional(zero);
}

std::optional<double> Machine::toolChange(int axis) const {
    const double at = std::array{changeX, changeY, changeZ}[static_cast<std::size_t>(axis)];
    return at == kNowhere ? std::nullopt : std::optional(at);
}

Result<Machine> parseMachine(std::string_view text, Machine machine) {
    const std::string_view first = text.substr(0, text.find(','));
    if (!first.empty() && first.find('=') == std::string_view::npos) {
        const MachineProfile* profile = findMachineProfile(first);
        if (profile == nullptr)
            return failure(setup_finding::kMachineProfile, {std::string(first), machineProfileKeys()});
        machine = machineOf(*profile, machine);
        text.remove_prefix(std::min(text.size(), first.size() + 1));
    }
    return parseDescribed(text, machine, {setup_finding::kMachineValue, setup_finding::kMachineKey});
}

} // namespace proveout

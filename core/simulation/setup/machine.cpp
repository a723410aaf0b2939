// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/machine.h"

#include "core/base/described_values.h"
#include "core/simulation/setup/setup_findings.h"

namespace proveout {

Result<Machine> parseMachine(std::string_view text, Machine machine) {
    return parseDescribed(text, machine, {setup_finding::kMachineValue, setup_finding::kMachineKey});
}

} // namespace proveout

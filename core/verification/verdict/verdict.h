// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "core/base/diagnostic.h"
#include "core/verification/verdict/not_checked.h"

namespace proveout {

/// Whether a program may be run on the machine.
enum class Verdict : std::uint8_t {
    safe,       ///< all of it was checked, but for what was accepted by name, and nothing was found
    faults,     ///< it would cause damage, or make a wrong part
    unverified, ///< a part of it was not checked
};

/// "safe", "faults" or "unverified".
[[nodiscard]] const char* name(Verdict verdict);

/// A fault decides; otherwise an error, a finding after which nothing is verified, or something that was not
/// checked and not accepted, leaves the program unverified.
[[nodiscard]] Verdict verdictOf(const Diagnostics& findings, std::span<const NotChecked> notChecked);

} // namespace proveout

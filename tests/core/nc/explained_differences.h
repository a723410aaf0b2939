// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a comparison with LinuxCNC's interpreter, and the deliberate differences.
#pragma once

#include <string>
#include <vector>

#include "core/nc/program/program.h"
#include "tests/core/nc/oracle_records.h"

namespace proveout::test {

struct Outcome {
    std::string kind; ///< "agrees", "refused by both", "differs", or the reason for a difference
    std::string why;  ///< for a difference without a reason

    [[nodiscard]] bool differs() const { return !why.empty(); }
};

/// Our results for a program. The referenced programs must outlive this object.
struct OurAnswer {
    const Program& whole;
    const Program& upToError; ///< up to the last block before the first error or isUnlikeControl()
};

[[nodiscard]] Outcome outcomeOf(const std::vector<std::string>& lines, const OracleAnswer& answer,
                                const OurAnswer& ours);

} // namespace proveout::test

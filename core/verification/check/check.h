// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a whole program: runs it to its end, judges the run by all rules, and gives a verdict.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/machine.h"
#include "core/simulation/setup/setup.h"
#include "core/verification/check/check_report.h"
#include "core/verification/rules/rules.h"

namespace proveout {

/// By what a program is judged. Value type; read by several threads at once.
struct CheckRules {
    RuleLimits limits = {};
    std::set<std::string> off = {};      ///< ids of rules
    std::set<std::string> accepted = {}; ///< ids of entries of notCheckedRows()
};

/// What is checked. Value type.
struct CheckSubject {
    std::shared_ptr<const Program> program; ///< interpreted with `setup`
    std::shared_ptr<const Setup> setup;     ///< an automatic grid is settled
    std::optional<Machine> machine = {};    ///< empty: not given, and nothing is judged by it
    bool hasStock = true;                   ///< otherwise only the program text is judged
    bool stockFitted = false;               ///< the stock is only fitted to the toolpath
    Diagnostics warnings = {};              ///< about the job; they come first in the report
};

/// The largest number of bytes that check() needs for it, without the program. Errors: stock, grid.
[[nodiscard]] Result<double> checkBytes(const CheckSubject& subject);

/// Runs the program on its stock in the calling thread and those of parallel loops, without decimation and
/// without checkpoints; `context` can stop it within 200 ms. Null if it was stopped. Errors: stock, grid, and
/// memory if checkBytes() exceeds `memoryBytes`; nothing was allocated then. Throws std::bad_alloc.
[[nodiscard]] Result<std::shared_ptr<const CheckReport>> check(const CheckSubject& subject,
                                                               const CheckRules& rules,
                                                               std::uint64_t memoryBytes,
                                                               const WorkContext& context = {});

} // namespace proveout

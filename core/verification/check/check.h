// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a whole program: runs it to its end, judges the run by all rules, and gives a verdict.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/formats/part_file.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/check_rules.h"
#include "core/simulation/setup/machine.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_proposals.h"
#include "core/verification/check/check_report.h"

namespace proveout {

struct CheckedStock;

/// The part of a job. Value type.
struct PartToCompare {
    PartContents of;
    PartTolerance tolerance;
};

/// What is checked. Value type.
struct CheckSubject {
    std::shared_ptr<const Program> program; ///< interpreted with `setup`
    std::shared_ptr<const Setup> setup;     ///< an automatic grid is settled
    std::optional<Machine> machine = {};    ///< empty: not given, and nothing is judged by it
    bool hasStock = true;                   ///< otherwise only the program text is judged
    bool stockFitted = false;               ///< the stock is only fitted to the toolpath
    Diagnostics warnings = {};              ///< about the job; they come first in the report
    ToolProposals proposals = {};           ///< the tools as the program's comments describe them
    std::optional<PartToCompare> part = {}; ///< what the stock is compared with; empty: nothing
    bool keepsResult = false;               ///< CheckReport::result
};

/// The largest number of bytes that check() needs for it, without the program. Errors: stock, grid.
[[nodiscard]] Result<double> checkBytes(const CheckSubject& subject);

/// Checks versions of a program one after another: blocks before the first one that an edit has changed are
/// not cut again. One thread at a time.
class Checker {
public:
    /// `checkpointBytes`: for the moments from which the next version may continue; 0: nothing is kept.
    explicit Checker(std::size_t checkpointBytes = 0);
    ~Checker();
    Checker(const Checker&) = delete;
    Checker& operator=(const Checker&) = delete;

    /// As check(), with the same result. What is kept afterwards is never more than a quarter of
    /// `memoryBytes`.
    [[nodiscard]] Result<std::shared_ptr<const CheckReport>> check(const CheckSubject& subject,
                                                                   const CheckRules& rules,
                                                                   std::uint64_t memoryBytes,
                                                                   const WorkContext& context = {});
    /// How many blocks the last check has cut.
    [[nodiscard]] std::size_t blocksCut() const { return m_blocksCut; }

private:
    std::size_t m_checkpointBytes;
    std::size_t m_blocksCut = 0;
    std::unique_ptr<CheckedStock> m_kept;
};

/// Runs the program on its stock in the calling thread and those of parallel loops, without decimation and
/// without checkpoints; `context` can stop it within 200 ms. Null if it was stopped. Errors: stock, grid, and
/// memory if checkBytes() exceeds `memoryBytes`; nothing was allocated then. Throws std::bad_alloc.
[[nodiscard]] Result<std::shared_ptr<const CheckReport>> check(const CheckSubject& subject,
                                                               const CheckRules& rules,
                                                               std::uint64_t memoryBytes,
                                                               const WorkContext& context = {});

} // namespace proveout

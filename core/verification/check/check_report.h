// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"
#include "core/simulation/setup/check_rules.h"
#include "core/simulation/time/machine_time.h"
#include "core/verification/part/part_comparison.h"
#include "core/verification/rules/first_contacts.h"
#include "core/verification/verdict/verdict.h"

namespace proveout {

/// A finding with all that lists and machine-readable reports need. Value type.
struct CheckFinding {
    Diagnostic diagnostic{};    ///< at its first line; without a file it is about the program
    std::size_t block = 0;      ///< the first, 1-based; 0: none
    std::size_t worstBlock = 0; ///< that of value and place, 1-based; 0: none
    std::size_t count = 1;      ///< of blocks
    int lastLine = 0;           ///< that of the last block; 0: none
    int tool = 0;               ///< of its blocks
    std::string cutter = {};    ///< of this tool (cutter_of.h); empty: it has none
    double value = 0;           ///< the worst
    double limit = 0;
    const char* unit = ""; ///< of value and limit; empty: there is no value
    std::optional<Vec3> place = {};
    std::optional<Waiver> waived = {}; ///< somebody answers for it: it does not count in the verdict

    friend bool operator==(const CheckFinding&, const CheckFinding&) = default;
};

/// The values of its sentence, as a waiver has them.
[[nodiscard]] std::string valuesOf(const Diagnostic& diagnostic);

/// A first contact with its line.
struct CheckedContact {
    FirstContact of;
    int line = 0;
};

/// What a run has left, and how long it takes. Immutable once made.
struct CheckedResult {
    ZMapSnapshot stock; ///< at the end, with its walls
    double removedMm3 = 0;
    std::shared_ptr<const MachineTimes> times;
    bool machineAssumed = true; ///< the times are those of the default machine
    struct OfTool {
        int tool = 0;
        std::string cutter = {}; ///< its spec; empty: it has none
        double lowestZ = 0;      ///< of its tip at feed, program coordinates, mm
    };
    std::vector<OfTool> tools; ///< those that move at feed, in the order of their first motion
};

/// The result of a check. Immutable once made, any thread.
struct CheckReport {
    std::vector<CheckFinding> findings;
    std::size_t ofText = 0; ///< so many of them, the first ones, are of the job and the program text alone
    std::vector<NotChecked> notChecked; ///< what concerns the program
    std::vector<CheckedContact> firstContacts;
    std::shared_ptr<const CheckedResult> result; ///< null: nobody asked for it
    std::shared_ptr<const PartComparison> part;  ///< null: the stock was not compared with a part
    /// The program itself is unverified for a reason that is not among the findings, or has no motion.
    bool programUnverified = false;

    /// By findings and notChecked.
    [[nodiscard]] Verdict verdict() const;
    /// The number of findings that are faults and not waived.
    [[nodiscard]] std::size_t faults() const;
    /// The same result with these ids accepted and these findings waived, and no others. A waiver whose
    /// finding is gone or has changed becomes a finding.
    [[nodiscard]] CheckReport answered(const IdsWithReasons& accepted,
                                       const std::vector<Waiver>& waivers) const;
    /// The waiver that names the finding; `finding` is one of this report.
    [[nodiscard]] Waiver waiverOf(const CheckFinding& finding, std::string reason, std::string owner) const;
};

/// How the findings of a report differ from those of an earlier one.
struct CheckChange {
    std::size_t added = 0; ///< findings that are new
    std::size_t gone = 0;

    friend bool operator==(const CheckChange&, const CheckChange&) = default;
};

/// Findings are the same if rule and tool are, and what they say, wherever their lines are now.
[[nodiscard]] CheckChange changeBetween(const CheckReport& before, const CheckReport& after);
/// The findings of a report that another one does not have, in the same sense.
[[nodiscard]] std::vector<CheckFinding> missingFrom(const CheckReport& other, const CheckReport& report);

} // namespace proveout

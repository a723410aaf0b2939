// SPDX-License-Identifier: GPL-3.0-or-later
// How long the machine takes for a program, block by block.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/work_context.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/machine.h"

namespace proveout {

/// Where the time goes, s.
struct TimeParts {
    double rapid = 0;
    double feed = 0; ///< arcs and probing too
    double dwell = 0;
    double toolChange = 0;

    [[nodiscard]] double total() const { return rapid + feed + dwell + toolChange; }
};

/// The time and the way of a program. Immutable once made, any thread.
struct MachineTimes {
    std::shared_ptr<const Program> program; ///< that they are of
    /// [n]: after n blocks; one more value than blocks. What happens between two blocks belongs to the second
    /// of them, what happens behind the last to the last.
    std::vector<double> secondsAfter{0};
    std::vector<double> lengthAfter{0}; ///< mm of path, the same way
    TimeParts parts;                    ///< of the whole program
    struct OfTool {
        int tool = 0;
        TimeParts parts;
        double feedLength = 0; ///< mm
    };
    std::vector<OfTool> tools;          ///< in the order of their first motion
    std::size_t motionsWithoutFeed = 0; ///< counted with the largest feed of the machine
    std::size_t motionsFromUnknown = 0; ///< counted along the axes that are known at both ends
    /// The machine stands still before a motion of a block.
    struct Standstill {
        std::size_t block = 0;
        double seconds = 0;
    };
    std::vector<Standstill> standstills; ///< dwells and tool changes, by block

    static constexpr double kBytesPerBlock = 2 * sizeof(double);

    /// What the motions of a block take, 0-based, without dwells and tool changes.
    [[nodiscard]] double movingSeconds(std::size_t block) const;
    /// Of its path, mm.
    [[nodiscard]] double length(std::size_t block) const {
        return lengthAfter[block + 1] - lengthAfter[block];
    }
};

/// Plans the speed along all motions (VelocityPlan). The machine stands still between rapids and feeds (the
/// in-position check of the controls), at dwells, tool changes and stops; an operator's pause at M0 takes no
/// time, nor does a tool that is in the spindle already. Rapids go straight to their end. Arcs keep to the
/// centripetal acceleration of their plane. The time that a spindle needs to gain its speed is not counted.
/// Linear in the motions: 1 M of them take some tenths of a second. Null where the context was stopped.
[[nodiscard]] std::shared_ptr<const MachineTimes>
machineTimes(std::shared_ptr<const Program> program, const Machine& machine, const WorkContext& context = {});

} // namespace proveout

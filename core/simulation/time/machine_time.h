// SPDX-License-Identifier: GPL-3.0-or-later
// How long the machine needs for a program, block by block.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/work_context.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/machine.h"

namespace proveout {

/// The time by kind, s.
struct TimeParts {
    double rapid = 0;
    double feed = 0; ///< including arcs and probing
    double dwell = 0;
    double toolChange = 0;

    [[nodiscard]] double total() const { return rapid + feed + dwell + toolChange; }
};

/// The times and path lengths of a program. Immutable once made, any thread.
struct MachineTimes {
    std::shared_ptr<const Program> program; ///< the program that they belong to
    /// [n]: after n blocks; one more value than blocks. Events between two blocks belong to the second of
    /// them, events after the last to the last.
    std::vector<double> secondsAfter{0};
    std::vector<double> lengthAfter{0}; ///< mm of path, in the same form
    TimeParts parts;                    ///< of the whole program
    struct OfTool {
        int tool = 0;
        TimeParts parts;
        double feedLength = 0; ///< mm
    };
    std::vector<OfTool> tools;          ///< in the order of their first motion
    std::size_t motionsWithoutFeed = 0; ///< timed with the machine's maximum feed rate
    std::size_t motionsFromUnknown = 0; ///< timed along the axes whose position is known at both ends
    /// The machine stops before a motion of a block.
    struct Standstill {
        std::size_t block = 0;
        double seconds = 0;
    };
    std::vector<Standstill> standstills; ///< dwells and tool changes, by block

    static constexpr double kBytesPerBlock = 2 * sizeof(double);

    /// The time of the motions of a block, 0-based, without dwells and tool changes.
    [[nodiscard]] double movingSeconds(std::size_t block) const;
    /// The length of its path, mm.
    [[nodiscard]] double length(std::size_t block) const {
        return lengthAfter[block + 1] - lengthAfter[block];
    }
};

/// Plans the speed along all motions (VelocityPlan). The machine stops between rapids and feeds (the
/// in-position check of the controls), at dwells, tool changes and stops; an operator's pause at M0 takes no
/// time, and neither does a change to the tool that is in the spindle already. Rapids move straight to their
/// end. Arcs keep to the centripetal acceleration of their plane. The time that a spindle needs to reach its
/// speed is not counted. Linear in the motions: 1 M of them take some tenths of a second. Null if the context
/// was stopped.
[[nodiscard]] std::shared_ptr<const MachineTimes>
machineTimes(std::shared_ptr<const Program> program, const Machine& machine, const WorkContext& context = {});

} // namespace proveout

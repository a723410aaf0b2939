// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "core/base/work_context.h"
#include "core/nc/program/motion.h"
#include "core/nc/program/program.h"

namespace proveout {

/// The object that the probing motions of one interpretation touch: the stock left by the earlier motions.
/// Each interpretation has its own, on its thread.
class ProbeTarget {
public:
    enum class Seek : std::uint8_t {
        contact, ///< G31, G38.2, G38.3: until the tool in the spindle touches the stock
        release, ///< G38.4, G38.5: until it no longer touches it
    };
    struct Answer {
        enum class Kind : std::uint8_t {
            found,
            missed,  ///< nowhere on the path
            already, ///< at the start of the motion
            unknown, ///< there is no stock, or no cutter for the tool
        };
        Kind kind = Kind::unknown;
        Vec3 place{0}; ///< found: the position of the tip, program coordinates in mm
    };

    ProbeTarget() = default;
    ProbeTarget(const ProbeTarget&) = delete;
    ProbeTarget& operator=(const ProbeTarget&) = delete;
    virtual ~ProbeTarget() = default;

    /// Probes along the straight path of `motion`, which is known and will be appended to `program` next. All
    /// motions of `program` have been executed and stay unchanged. With a stopped context the answer is
    /// arbitrary.
    [[nodiscard]] virtual Answer probe(const Program& program, const Motion& motion, Seek seek,
                                       const WorkContext& context) = 0;
};

/// The part of a setup, which makes a target for each interpretation. Immutable; any thread.
class ProbedPart {
public:
    ProbedPart() = default;
    ProbedPart(const ProbedPart&) = delete;
    ProbedPart& operator=(const ProbedPart&) = delete;
    virtual ~ProbedPart() = default;
    [[nodiscard]] virtual std::unique_ptr<ProbeTarget> target() const = 0;
    [[nodiscard]] virtual bool sameAs(const ProbedPart& other) const = 0;
};

/// A part to probe, or none. Compares the parts themselves.
struct PartToProbe {
    std::shared_ptr<const ProbedPart> part;

    [[nodiscard]] std::unique_ptr<ProbeTarget> target() const { return part ? part->target() : nullptr; }
    friend bool operator==(const PartToProbe& a, const PartToProbe& b) {
        return a.part == b.part || (a.part && b.part && a.part->sameAs(*b.part));
    }
};

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "core/base/work_context.h"
#include "core/nc/program/motion.h"
#include "core/nc/program/program.h"

namespace proveout {

/// What the probing motions of one interpretation meet: the stock as the motions before have left it. Each
/// interpretation has one of its own, on its thread.
class ProbeTarget {
public:
    enum class Seek : std::uint8_t {
        contact, ///< G31, G38.2, G38.3: until the tool in the spindle touches the stock
        release, ///< G38.4, G38.5: until it touches it no longer
    };
    struct Answer {
        enum class Kind : std::uint8_t {
            found,
            missed,  ///< nowhere on the way
            already, ///< where the motion begins
            unknown, ///< there is no stock, or no cutter for the tool
        };
        Kind kind = Kind::unknown;
        Vec3 place{0}; ///< found: where the tip is then, program coordinates in mm
    };

    ProbeTarget() = default;
    ProbeTarget(const ProbeTarget&) = delete;
    ProbeTarget& operator=(const ProbeTarget&) = delete;
    virtual ~ProbeTarget() = default;

    /// On the straight way of `motion`, which is known and will be appended to `program` next. All motions of
    /// `program` have been carried out and stay as they are. A stopped context answers anything.
    [[nodiscard]] virtual Answer probe(const Program& program, const Motion& motion, Seek seek,
                                       const WorkContext& context) = 0;
};

/// The part of a set-up, which makes a target for each interpretation. Immutable; any thread.
class ProbedPart {
public:
    ProbedPart() = default;
    ProbedPart(const ProbedPart&) = delete;
    ProbedPart& operator=(const ProbedPart&) = delete;
    virtual ~ProbedPart() = default;
    [[nodiscard]] virtual std::unique_ptr<ProbeTarget> target() const = 0;
    [[nodiscard]] virtual bool sameAs(const ProbedPart& other) const = 0;
};

/// One of them, or none. Compares as the parts do.
struct PartToProbe {
    std::shared_ptr<const ProbedPart> part;

    [[nodiscard]] std::unique_ptr<ProbeTarget> target() const { return part ? part->target() : nullptr; }
    friend bool operator==(const PartToProbe& a, const PartToProbe& b) {
        return a.part == b.part || (a.part && b.part && a.part->sameAs(*b.part));
    }
};

} // namespace proveout

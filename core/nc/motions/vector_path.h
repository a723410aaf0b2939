// SPDX-License-Identifier: GPL-3.0-or-later
// Cutter compensation by vectors, as in Fanuc's controls. Source: FANUC Series 0i and 30i, operator's manuals
// for machining centres, details of cutter compensation.
#pragma once

#include <optional>

#include "core/nc/geometry/corner_vectors.h"
#include "core/nc/motions/compensated_motion.h"

namespace proveout {

/// The control reads ahead to the next motion in the plane and places the tool on points beside the corner;
/// the moves between these belong to the block after it.
class VectorPath final : public CompensatedMotion {
public:
    VectorPath(Execution& execution, const Word& word, const Motion& motion);

    void finishHeld() override;

private:
    void enter() override;
    void join() override;
    void appendAcross() override;

    void leave();
    void joinSquare();
    bool finish(const Vec2& end);
    void moveThrough(const CornerPoints& points);
    void emit(const Vec2& from);
    void moveTipTo(const Vec2& place);
    void reportOffCircle(const PlanePath& path, const Vec2& from);

    std::optional<CornerPoints> corner();
    [[nodiscard]] CornerPoints exitPoints() const;
    [[nodiscard]] CornerPoints kept(const CornerPoints& points) const;
    [[nodiscard]] bool changesSide() const;
    [[nodiscard]] Vec2 tip() const;

    const VectorRules& m_rules;
    VectorState& m_held;
};

/// The control does not know what follows: the tool stays at a right angle beside the end of the last motion.
void finishSquare(Execution& execution);

} // namespace proveout

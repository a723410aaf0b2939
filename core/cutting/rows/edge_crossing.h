// SPDX-License-Identifier: GPL-3.0-or-later
// Where along a line over ground the envelope of a cutter first falls below a given height: exact for any
// profile on any path.
#pragma once

#include <limits>
#include <span>

#include "core/base/geometry.h"
#include "core/cutting/profiles/arc_path.h"
#include "core/cutting/profiles/convex_profile.h"
#include "core/cutting/rows/arc_sweep.h"
#include "core/cutting/rows/straight_sweep.h"

namespace proveout {

/// A stretch along X or Y, and a height over each of its places, mm.
struct EdgeLine {
    Vec2 from{0};
    Vec2 along{1, 0}; ///< a unit vector
    double length = 0;
    double height = 0; ///< at `from`
    double fall = 0;   ///< of the height per mm

    [[nodiscard]] Vec2 at(double place) const { return from + along * place; }
    [[nodiscard]] double heightAt(double place) const { return height - fall * place; }
    [[nodiscard]] double highest() const { return fall > 0 ? height : heightAt(length); }
    /// A vector with `along` as the first axis, and back.
    [[nodiscard]] Vec2 seen(const Vec2& v) const {
        return {v.x * along.x + v.y * along.y, v.y * along.x - v.x * along.y};
    }
    [[nodiscard]] Vec2 unseen(const Vec2& v) const {
        return {v.x * along.x - v.y * along.y, v.x * along.y + v.y * along.x};
    }
};

/// The first place of a line where something is below its height.
struct EdgeCrossing {
    double place = std::numeric_limits<double>::infinity(); ///< mm from the line's start
    Vec2 outwards{0}; ///< over ground, from the cutter to the place; a unit vector

    [[nodiscard]] bool found() const { return place < std::numeric_limits<double>::infinity(); }
    /// Replaces this crossing by one that is earlier; of equal ones, by the one with the smaller direction,
    /// so that the result does not depend on their order.
    void take(const EdgeCrossing& other);
};

/// Updates `first` by the first place where the envelope is below the line, to within some nanometres across
/// the wall. Looks a little beyond the line's end, as maps cut points that are on the rim to rounding.
/// What is later than `first` may be left out; the result is the same for any order of calls.
void findCrossing(const ConvexProfile& profile, const StraightPath& path, const EdgeLine& line,
                  EdgeCrossing& first);
/// `parts`: splitArc() of the path. In closed form if the wall is that of a circle or helix about Z, else by
/// branch and bound as in arcPartEnvelope().
void findCrossing(const ConvexProfile& profile, const ArcPath& path, std::span<const ArcPart> parts,
                  const EdgeLine& line, EdgeCrossing& first);

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
// Whether shank and holder of a tool touch the stock on a motion, and how deep.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/geometry.h"
#include "core/cutter/cutter.h"
#include "core/cutting/profiles/convex_profile.h"
#include "core/nc/program/motion.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The deepest contact of one part of a tool with the stock.
struct PartContact {
    /// By which the stock is higher than the part, or than its own floor, over one point, mm; 0: none.
    double depth = 0;
    Vec3 place{0}; ///< the point, and the lower surface of the part over it; program coordinates
};

struct AssemblyContact {
    PartContact shank;
    PartContact holder;

    [[nodiscard]] bool any() const { return shank.depth > 0 || holder.depth > 0; }
};

/// Shank and holder of one cutter, prepared for many motions. Immutable; any thread.
///
/// A part touches what the cutter has not removed by the moment in which the part is over it: the material
/// ahead of the cutter, and beside it, but not what it has cut before on the same motion. Each motion is
/// treated like this, straight or circular, in any plane; one whose path is unknown touches nothing.
///
/// Accuracy: contacts are measured over the points of the grid, so that one that is narrower than the spacing
/// may be missed. Over a point they are exact to kExact in height. Where the cutter itself passes the point
/// on an arc, both count as moving along its chords (MomentsOverPoint), within a micrometre of it.
class ToolAssembly {
public:
    /// Smaller depths do not count as contacts: two exact cuts may differ by a micrometre each. Of contacts
    /// that are equally deep within 0.1 µm, the place of one is given.
    static constexpr double kExact = 2e-3;

    /// `clearance`: parts also touch what is nearer than this to their sides or below them, mm, except what
    /// is lower than the profile of the cutter. `aside`: so much more to their sides. Nothing is kept of
    /// `cutter`.
    explicit ToolAssembly(const Cutter& cutter, double clearance = 0, double aside = 0);

    /// Whether there is nothing that could touch: neither a holder nor a shank was given, or both are as
    /// narrow as the cutter.
    [[nodiscard]] bool empty() const { return m_parts.empty(); }
    /// The largest radius of the parts; 0 if there are none.
    [[nodiscard]] double radius() const;
    /// Whether all parts stay above the uncut stock on the motion; costs next to nothing.
    [[nodiscard]] bool staysAbove(const StockBox& stock, const Motion& motion) const;
    /// The contacts on a motion of this cutter that begins on this map, which is the one before the motion is
    /// cut. On a map that is nowhere lower they are nowhere less deep. Nothing if it was stopped, which takes
    /// effect within some 30 ms.
    [[nodiscard]] std::optional<AssemblyContact> contact(const ZMap& before, const Motion& motion,
                                                         const std::stop_token& stop) const;

private:
    struct Part {
        Cutter surface; ///< its lower surface as a profile
        PartContact AssemblyContact::*contact;
    };
    void add(std::vector<ProfilePiece> pieces, double outwards, double downwards, double lowest,
             PartContact AssemblyContact::*contact);

    std::vector<Part> m_parts;
    std::vector<ConvexProfile> m_cutter;
    double m_cutterRadius = 0;
    double m_lowest = 0; ///< of all parts
};

} // namespace proveout

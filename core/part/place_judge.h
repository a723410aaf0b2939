// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this room.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/part/deviation.h"

namespace proveout {

/// Heights of the map are exact to 1 µm, and in single precision as are those of the part.
inline constexpr double kSameHeight = 2e-6; // mm
/// How exact swept volumes are.
inline constexpr double kExactVolume = 2e-3; // mm
/// The part of a normal along Z: faces that are steeper are sampled on their own.
inline constexpr double kSteepNormal = 0.5;
/// Where a step of the grid has no rim, its wall is somewhere in a cell.
inline constexpr double kUncertainCells = 0.75;

/// A place of the part that may be out of tolerance.
struct PartPlace {
    Vec3 place;
    Vec3 normal;      ///< of its face
    double off;       ///< its deviation by the map, without the allowance
    double uncertain; ///< how much that may differ from the stock
};

/// Decides which candidates are out of tolerance: beyond the tolerance, normal to the part, there must be air
/// where material is missing, or material where some is left.
class PlaceJudge {
public:
    PlaceJudge(const DesignPart& part, const PartTolerance& tolerance, const IsMaterial& isMaterial)
        : m_part(part), m_tolerance(tolerance), m_isMaterial(isMaterial) {}

    enum class Verdict : std::uint8_t { in, out, unknown };
    [[nodiscard]] std::vector<Verdict> verdicts(std::span<const PartPlace> candidates) const {
        std::vector<Verdict> verdicts(candidates.size(), Verdict::in);
        if (!m_isMaterial) {
            std::ranges::transform(candidates, verdicts.begin(),
                                   [this](const PartPlace& candidate) { return byMap(candidate); });
            return verdicts;
        }
        std::vector<std::optional<Vec3>> places(candidates.size());
        inParallelRanges(candidates.size(), kCandidatesOfTask, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k)
                places[k] = placeBeyond(candidates[k], verdicts[k]);
        });
        std::vector<Vec3> asked;
        for (const auto& place : places)
            if (place)
                asked.push_back(*place);
        const std::vector<bool> isMaterial = m_isMaterial(asked);
        std::size_t next = 0;
        for (std::size_t k = 0; k < candidates.size(); ++k)
            if (places[k] && isMaterial[next++] == (candidates[k].off > 0))
                verdicts[k] = Verdict::out;
        return verdicts;
    }

private:
    static constexpr std::size_t kCandidatesOfTask = 256;
    static constexpr double kFarOut = 3; ///< tolerances

    [[nodiscard]] double limit(const PartPlace& candidate) const {
        return candidate.off > 0 ? m_tolerance.above : -m_tolerance.below;
    }
    [[nodiscard]] Verdict byMap(const PartPlace& candidate) const {
        const double beyond = std::abs(candidate.off) - std::abs(limit(candidate));
        if (beyond > candidate.uncertain)
            return Verdict::out;
        return beyond > -candidate.uncertain && candidate.uncertain > 0 ? Verdict::unknown : Verdict::in;
    }
    /// Just beyond the tolerance. At edges of the part and in gaps, where that is nearer to another face,
    /// only what is far out of tolerance counts: neighbouring places tell the rest. Nothing: it does not
    /// count, or the place would be on the other side of the part's surface.
    [[nodiscard]] std::optional<Vec3> placeBeyond(const PartPlace& candidate, Verdict& otherwise) const {
        const double wanted = m_tolerance.allowance + limit(candidate);
        const double side = candidate.off > 0 ? 1 : -1;
        const Vec3 place = candidate.place + candidate.normal * (wanted + side * kExactVolume);
        const auto there = m_part.distance().at(place);
        if (!there->hasSide) {
            otherwise = Verdict::unknown;
            return std::nullopt;
        }
        if (side * there->distance >= side * wanted - kSameHeight)
            return place;
        const bool isFar = std::abs(candidate.off + m_tolerance.allowance) >
                           kFarOut * std::abs(wanted) + candidate.uncertain;
        return isFar && side * there->distance > kExactVolume ? std::optional(place) : std::nullopt;
    }

    const DesignPart& m_part;
    const PartTolerance& m_tolerance;
    const IsMaterial& m_isMaterial;
};

} // namespace proveout

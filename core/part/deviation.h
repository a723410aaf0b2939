// SPDX-License-Identifier: GPL-3.0-or-later
// How a stock deviates from the part that it is to become.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/work_context.h"
#include "core/part/design_part.h"
#include "core/part/map_distance.h"
#include "core/part/part_spec.h"
#include "core/part/part_top.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Deviations are normal to the surfaces, mm, without the allowance: positive where stock is left on the
/// part, negative where it is missing. kNotJudged where there is no part, and the stock is not within it.
inline constexpr float kNotJudged = std::numeric_limits<float>::quiet_NaN();

/// Those of the points of a tile, row by row. Immutable once published.
struct DeviationTile {
    std::array<float, std::size_t{Tile::kSize} * Tile::kSize> values;
};

/// A sample of a steep face of the part.
struct WallDeviation {
    Vec3 place; ///< on the part
    float value;
    float areaMm2; ///< of the part, that the sample is for
    int i;         ///< the point of the grid that is nearest over ground
    int j;
};

/// What of the part cannot be judged, or not with this map.
struct DeviationLimits {
    std::size_t pointsWithoutSide = 0; ///< the mesh does not tell on which side of it they are
    double hiddenMm2 = 0; ///< of steep faces below other parts, where stock is left: three axes reach none
    double unresolvedMm2 = 0; ///< of steep faces where the map does not say accurately enough where walls are
    double wallSpacing = 0;   ///< of the samples of steep faces, mm; 0: there are none
};

/// Whether there is material at each of some places, exactly, wherever they are between the points of the
/// grid. Any thread.
using IsMaterial = std::function<std::vector<bool>(std::span<const Vec3> places)>;

class PlaceJudge;

/// The deviations of a stock. In both directions: of the stock's points from the part, and of the part from
/// the surface of the stock, which finds what is missing, or left, in places that are narrower than they are
/// deep. Immutable; any thread.
class Deviation {
public:
    Deviation() = default;
    /// Nothing if it was stopped. In parallel. `tolerance` only decides where the slower direction is looked
    /// at: what is within it vertically is so in each direction. Between the points, where the map is less
    /// exact than they are, `isMaterial` decides; without it such places are not resolved.
    [[nodiscard]] static std::optional<Deviation>
    of(const ZMapSnapshot& stock, std::shared_ptr<const DesignPart> part, const PartTolerance& tolerance,
       const WorkContext& context = {}, const IsMaterial& isMaterial = {});

    [[nodiscard]] const Grid& grid() const { return m_map->zmap().grid(); }
    [[nodiscard]] const ZMapSnapshot& stock() const { return m_map->zmap(); }
    [[nodiscard]] const DesignPart& part() const { return *m_part; }
    [[nodiscard]] const std::shared_ptr<const DesignPart>& sharePart() const { return m_part; }
    [[nodiscard]] const PartTop& top() const { return *m_top; }
    [[nodiscard]] std::size_t tileCount() const { return m_tiles.size(); }
    /// Null: no point of it is judged.
    [[nodiscard]] const std::shared_ptr<const DeviationTile>& tile(std::size_t index) const {
        return m_tiles[index];
    }
    [[nodiscard]] float at(int i, int j) const;
    /// Whether a moment has this stock and grid, so that its tiles are those of stock() where they are equal.
    [[nodiscard]] bool isOn(const ZMapSnapshot& moment) const;
    /// Those of steep faces that are out of tolerance.
    [[nodiscard]] const std::vector<WallDeviation>& walls() const { return m_walls; }
    [[nodiscard]] const DeviationLimits& limits() const { return m_limits; }

    /// The place of the deviation of a point: on the surface of the stock, or, where that is farther, on the
    /// part. Program coordinates.
    struct Place {
        Vec3 at;
        bool isOnPart;
    };
    [[nodiscard]] Place placeOf(int i, int j) const;
    /// The place of the stock's surface that is nearest to a place; nothing if nothing is left.
    [[nodiscard]] std::optional<Vec3> nearestOnStock(const Vec3& place) const;

    /// The memory for it, beside the part.
    [[nodiscard]] static double bytes(const Grid& grid);

private:
    [[nodiscard]] bool judgePoints(const PlaceJudge& judge, const PartTolerance& tolerance,
                                   const WorkContext& context);
    [[nodiscard]] bool judgeWalls(const PlaceJudge& judge, const PartTolerance& tolerance,
                                  const WorkContext& context);

    std::shared_ptr<const DesignPart> m_part;
    std::shared_ptr<const PartTop> m_top;
    std::shared_ptr<const MapDistance> m_map;
    std::vector<std::shared_ptr<const DeviationTile>> m_tiles;
    std::vector<WallDeviation> m_walls;
    DeviationLimits m_limits;
};

} // namespace proveout

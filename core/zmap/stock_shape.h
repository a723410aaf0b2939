// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of a box of stock is material before the first cut.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/diagnostic.h"
#include "core/base/file_state.h"
#include "core/base/geometry.h"
#include "core/zmap/rims.h"
#include "core/zmap/stock.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// In the order of the table of shapes (core/formats/stock_shapes.h).
enum class StockKind : std::uint8_t {
    box,
    cylinder, ///< vertical
    outline,  ///< a closed outline of lines and arcs, extruded downwards
    mesh,     ///< what is below the surface of a closed mesh
    saved,    ///< what an earlier setup has left
};
/// Counter-clockwise, seen from above.
enum class StockTurn : std::uint8_t { none, quarter, half, threeQuarters };
/// By half a turn about a horizontal axis, before the stock is turned.
enum class StockFlip : std::uint8_t { none, aboutX, aboutY };

/// A z-map of uncut stock.
struct UncutStock {
    ZMap zmap;
    Diagnostics findings; ///< what the map cannot represent; `file` is empty
};

/// How high a body is over a place in plan, relative to the top of its box, mm; any thread.
class StockTop {
public:
    static constexpr double kAbsent = -1e30; ///< there is no material

    virtual ~StockTop() = default;
    [[nodiscard]] virtual double height(const Vec2& place) const = 0;
    /// An upper bound of the body's height within a box in plan; the closer the bound, the less work for the
    /// caller.
    [[nodiscard]] virtual double highest(const Vec2& lo, const Vec2& hi) const = 0;
    /// Whether walls are where it says: a map has them somewhere between its points.
    [[nodiscard]] virtual bool knowsWalls() const { return true; }
    /// What it knows of its walls in a tile of the grid, if it does not know all; null: there are no walls.
    /// `tile`: index within the grid.
    [[nodiscard]] virtual const RimTile* rims(std::size_t /*tile*/) const { return nullptr; }
};

/// Material of any form. Immutable; any thread.
class StockBody {
public:
    StockBody() = default;
    StockBody(const StockBody&) = delete;
    StockBody& operator=(const StockBody&) = delete;
    virtual ~StockBody() = default;

    /// The bounding box in the body's own coordinates.
    [[nodiscard]] virtual StockBox box() const = 0;
    /// The spacing of the grid on which nothing of it is lost; nothing if no spacing is better than another.
    [[nodiscard]] virtual std::optional<double> spacing() const { return {}; }
    /// Its z-map when its box is moved to that of `stock`. Allocates memory; ask checkMemory() first.
    [[nodiscard]] virtual UncutStock uncut(const StockBox& stock, const Grid& grid) const = 0;
    /// The top of the body itself rather than of its z-map, in the coordinates of `stock`. Null if the z-map
    /// is as good.
    [[nodiscard]] virtual std::unique_ptr<StockTop> top(const StockBox& /*stock*/) const { return nullptr; }
    /// The rims of uncut(), as far as they are known; empty: there are none.
    [[nodiscard]] virtual RimMap rims(const StockBox& /*stock*/, const Grid& /*grid*/) const { return {}; }
};

/// Which part of the box is stock: all of it, or a body. Value type.
struct StockShape {
    StockKind kind = StockKind::box;
    std::filesystem::path file; ///< of an outline, a mesh or a saved stock; absolute once loaded
    StockTurn turn = StockTurn::none;
    StockFlip flip = StockFlip::none;
    std::shared_ptr<const StockBody> body; ///< null for a box
    FileState fileState;                   ///< of the file, determined before it was read

    /// Bodies are compared by address: one that was made again counts as different.
    friend bool operator==(const StockShape&, const StockShape&) = default;
};

/// Refuses a shape whose body is missing, e.g. because its file has not been chosen yet.
[[nodiscard]] Result<void> checkShape(const StockShape& shape);

/// Allocates memory; ask checkMemory() first.
[[nodiscard]] UncutStock uncutStock(const StockBox& stock, const StockShape& shape, const Grid& grid);

/// The top of a shape that is not a box, as accurate as possible: from its body, or else from its z-map on
/// this grid and the rims that it has there.
[[nodiscard]] std::unique_ptr<StockTop> topOf(const StockBox& stock, const StockShape& shape,
                                              const Grid& grid);
/// The same, from the z-map without rims.
[[nodiscard]] std::unique_ptr<StockTop> mapTopOf(const StockBox& stock, const StockShape& shape,
                                                 const Grid& grid);

} // namespace proveout

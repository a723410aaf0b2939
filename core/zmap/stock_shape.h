// SPDX-License-Identifier: GPL-3.0-or-later
// What of a box of stock is material before the first cut.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/diagnostic.h"
#include "core/base/file_state.h"
#include "core/base/geometry.h"
#include "core/zmap/stock.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// In the order of the table of shapes (core/formats/stock_shapes.h).
enum class StockKind : std::uint8_t {
    box,
    cylinder, ///< upright
    outline,  ///< a closed outline of lines and arcs, extruded downwards
    mesh,     ///< what is below the surface of a closed mesh
    saved,    ///< what an earlier set-up has left
};
/// Counter-clockwise, seen from above.
enum class StockTurn : std::uint8_t { none, quarter, half, threeQuarters };
/// By half a turn about an axis that lies; before the stock is turned.
enum class StockFlip : std::uint8_t { none, aboutX, aboutY };

/// A z-map of uncut stock.
struct UncutStock {
    ZMap zmap;
    Diagnostics findings; ///< what the map cannot hold; `file` is left empty
};

/// How high a body stands over a place in plan, above or below the top of its box, mm; any thread.
class StockTop {
public:
    static constexpr double kAbsent = -1e30; ///< nothing stands there

    virtual ~StockTop() = default;
    [[nodiscard]] virtual double height(const Vec2& place) const = 0;
    /// Nowhere in a box in plan is the body higher; the nearer the truth, the less work for who asks.
    [[nodiscard]] virtual double highest(const Vec2& lo, const Vec2& hi) const = 0;
};

/// Material of any form. Immutable; any thread.
class StockBody {
public:
    StockBody() = default;
    StockBody(const StockBody&) = delete;
    StockBody& operator=(const StockBody&) = delete;
    virtual ~StockBody() = default;

    /// The box round it, where it lies by itself.
    [[nodiscard]] virtual StockBox box() const = 0;
    /// The spacing of the grid on which nothing of it is lost; nothing: none is better than another.
    [[nodiscard]] virtual std::optional<double> spacing() const { return {}; }
    /// Its z-map where its box lies in the place of `stock`. Memory is taken here; ask checkMemory() first.
    [[nodiscard]] virtual UncutStock uncut(const StockBox& stock, const Grid& grid) const = 0;
    /// How high it stands, asked for itself rather than for its z-map, in the coordinates of `stock`. Null:
    /// it has nothing that is better.
    [[nodiscard]] virtual std::unique_ptr<StockTop> top(const StockBox& /*stock*/) const { return nullptr; }
};

/// What of the box is stock: all of it, or a body. Value type.
struct StockShape {
    StockKind kind = StockKind::box;
    std::filesystem::path file; ///< of an outline, a mesh or a saved stock; absolute once loaded
    StockTurn turn = StockTurn::none;
    StockFlip flip = StockFlip::none;
    std::shared_ptr<const StockBody> body; ///< none of a box
    FileState fileState;                   ///< of the file, from before it was read

    /// A body that was made anew is another one.
    friend bool operator==(const StockShape&, const StockShape&) = default;
};

/// Refuses a shape whose body is missing, e.g. because its file has not been chosen yet.
[[nodiscard]] Result<void> checkShape(const StockShape& shape);

/// Memory is taken here; ask checkMemory() first.
[[nodiscard]] UncutStock uncutStock(const StockBox& stock, const StockShape& shape, const Grid& grid);

/// The top of a shape that is no box, nearest to the truth: of its body, or of its z-map on this grid.
[[nodiscard]] std::unique_ptr<StockTop> topOf(const StockBox& stock, const StockShape& shape,
                                              const Grid& grid);

} // namespace proveout

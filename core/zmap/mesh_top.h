// SPDX-License-Identifier: GPL-3.0-or-later
// The upper surface of a mesh at any place. Internal to this library.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "core/zmap/facet_index.h"
#include "core/zmap/mesh_stock.h"
#include "core/zmap/stock_shape.h"

namespace proveout {

/// Makes the tops of one mesh, which share an index over its triangles: the first one costs less time than a
/// map. Any thread.
class MeshTops {
public:
    /// Each triangle costs some 20 ns for each of the hundreds of heights that the wall on one edge needs.
    static constexpr int kMostOverPlace = 256;

    /// The top of `mesh` when it is moved by `offset` in plan; the same mesh each time. `box`: its own.
    /// Refers to the mesh. Null if long triangles are so many over one place, more than kMostOverPlace on
    /// average, that it would be slow.
    [[nodiscard]] std::unique_ptr<StockTop> top(const StockMesh& mesh, const Box3& box,
                                                const Vec2& offset) const;

private:
    mutable std::once_flag m_once;
    mutable std::optional<FacetIndex> m_index;
};

} // namespace proveout

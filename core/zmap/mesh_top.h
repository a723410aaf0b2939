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
    /// The top of `mesh` when it is moved by `offset` in plan; the same mesh each time. `box`: its own.
    /// Refers to the mesh. Null if long triangles are so many over one place that it would be slow.
    [[nodiscard]] std::unique_ptr<StockTop> top(const StockMesh& mesh, const Box3& box,
                                                const Vec2& offset) const;

private:
    mutable std::once_flag m_once;
    mutable std::optional<FacetIndex> m_index;
};

} // namespace proveout

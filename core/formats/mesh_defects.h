// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/decimation/solid/solid.h"

namespace proveout {

/// Why a mesh is not the closed surface of a body, as counts.
struct MeshDefects {
    std::size_t duplicateFacets = 0;  ///< beyond the first of those with the same three vertices
    std::size_t openEdges = 0;        ///< of one facet alone
    std::size_t nonManifoldEdges = 0; ///< of more than two facets
    std::size_t flippedEdges = 0;     ///< of two facets of opposite winding
    bool insideOut = false;           ///< the facets are clockwise seen from outside

    friend bool operator==(const MeshDefects&, const MeshDefects&) = default;
};

/// Counts them; vertices are equal where their indices are, of which there are less than 2³¹. Time and memory
/// are linear in the mesh, but for the sorting of the facets round one vertex. An open mesh is inside out
/// only where most of it is closed: the sign of a volume that is not enclosed says nothing. Any thread.
[[nodiscard]] MeshDefects findDefects(const TriangleMesh& mesh);

} // namespace proveout

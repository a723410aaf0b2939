// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/decimation/solid/solid.h"

namespace proveout {

/// Counts of the defects that keep a mesh from being the closed surface of a body.
struct MeshDefects {
    std::size_t duplicateFacets = 0;  ///< in addition to the first one with the same three vertices
    std::size_t openEdges = 0;        ///< of only one facet
    std::size_t nonManifoldEdges = 0; ///< of more than two facets
    std::size_t flippedEdges = 0;     ///< of two facets of opposite winding
    bool insideOut = false;           ///< the facets are clockwise seen from outside

    friend bool operator==(const MeshDefects&, const MeshDefects&) = default;
};

/// Counts the defects; vertices are equal if their indices are, and there must be less than 2³¹. Time and
/// memory are linear in the mesh, except for the sorting of the facets around one vertex. An open mesh counts
/// as inside out only if most of it is closed: the sign of a volume that is not enclosed has no meaning. Any
/// thread.
[[nodiscard]] MeshDefects findDefects(const TriangleMesh& mesh);

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
// The two Euler operators of the paper's edge collapse (§4.3), on OpenMesh's kernel. OpenMesh's own collapse
// does the same, and the tests compare the two; but the library as distributed is built with its assertions,
// which allocate a string whenever a vertex's status is read: this was measured to take half of the time of a
// decimation, and no region was free of allocations.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace proveout {

struct HalfEdgeTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

/// KEF: removes the edge of `side` and the face on that side, which merges into the face across the edge.
void killEdgeAndFace(HalfEdgeMesh& mesh, OpenMesh::HalfedgeHandle side);

/// KEV: contracts the edge of `out` and removes the vertex at its start; the other edges of that vertex move
/// to the vertex at its end. The edge must not be part of a triangle.
void killEdgeAndVertex(HalfEdgeMesh& mesh, OpenMesh::HalfedgeHandle out);

/// Removes the vertex at the start of `out`: a KEF for each face on its edge (two inside, one on the border;
/// Figs 5 and 6), then a KEV.
void collapseEdge(HalfEdgeMesh& mesh, OpenMesh::HalfedgeHandle out);

} // namespace proveout

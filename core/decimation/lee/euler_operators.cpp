// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/lee/euler_operators.h"

namespace proveout {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

void killEdgeAndFace(HalfEdgeMesh& mesh, HalfedgeHandle side) {
    const HalfedgeHandle across = mesh.opposite_halfedge_handle(side);
    const FaceHandle killed = mesh.face_handle(side);
    const FaceHandle grown = mesh.face_handle(across); // not valid if the edge is on the border
    const HalfedgeHandle next = mesh.next_halfedge_handle(side);
    const HalfedgeHandle nextAcross = mesh.next_halfedge_handle(across);
    const VertexHandle from = mesh.to_vertex_handle(across);
    const VertexHandle to = mesh.to_vertex_handle(side);

    for (HalfedgeHandle h = next; h != side; h = mesh.next_halfedge_handle(h))
        mesh.set_face_handle(h, grown);
    mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(side), nextAcross);
    mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(across), next);
    if (grown.is_valid())
        mesh.set_halfedge_handle(grown, next);
    if (mesh.halfedge_handle(from) == side)
        mesh.set_halfedge_handle(from, nextAcross);
    if (mesh.halfedge_handle(to) == across)
        mesh.set_halfedge_handle(to, next);
    mesh.status(killed).set_deleted(true);
    mesh.status(mesh.edge_handle(side)).set_deleted(true);
}

void killEdgeAndVertex(HalfEdgeMesh& mesh, HalfedgeHandle out) {
    const HalfedgeHandle back = mesh.opposite_halfedge_handle(out);
    const VertexHandle killed = mesh.to_vertex_handle(back);
    const VertexHandle kept = mesh.to_vertex_handle(out);
    const HalfedgeHandle next = mesh.next_halfedge_handle(out);
    // If the vertex had three neighbours, the edge is a dangling one now, with both its sides in one face.
    const bool dangles = mesh.next_halfedge_handle(back) == out;
    const HalfedgeHandle nextBack = dangles ? next : mesh.next_halfedge_handle(back);

    for (HalfedgeHandle in = mesh.prev_halfedge_handle(out); in != back;
         in = mesh.prev_halfedge_handle(mesh.opposite_halfedge_handle(in)))
        mesh.set_vertex_handle(in, kept);
    mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(out), next);
    mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(back), nextBack);
    if (const FaceHandle face = mesh.face_handle(out); face.is_valid())
        mesh.set_halfedge_handle(face, next);
    if (const FaceHandle face = mesh.face_handle(back); face.is_valid())
        mesh.set_halfedge_handle(face, nextBack);
    // A border vertex must point at the outer half-edge that leaves it, even if that was inherited from the
    // removed edge.
    const HalfedgeHandle outer = mesh.halfedge_handle(killed);
    if (mesh.is_boundary(outer))
        mesh.set_halfedge_handle(kept, outer == out ? next : outer);
    else if (mesh.halfedge_handle(kept) == back)
        mesh.set_halfedge_handle(kept, next);
    mesh.set_isolated(killed);
    mesh.status(killed).set_deleted(true);
    mesh.status(mesh.edge_handle(out)).set_deleted(true);
}

void collapseEdge(HalfEdgeMesh& mesh, HalfedgeHandle out) {
    const HalfedgeHandle back = mesh.opposite_halfedge_handle(out);
    // In each face on the edge, the edge that meets it in the vertex to be removed is killed.
    if (!mesh.is_boundary(out))
        killEdgeAndFace(mesh, mesh.prev_halfedge_handle(out));
    if (!mesh.is_boundary(back))
        killEdgeAndFace(mesh, mesh.next_halfedge_handle(back));
    killEdgeAndVertex(mesh, out);
}

} // namespace proveout

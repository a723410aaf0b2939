// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/atomic_file.h"
#include "core/formats/mesh_files.h"
#include "core/formats/mesh_writing.h"

namespace proveout {

namespace {

void appendVertex(std::string& out, const Vec3& vertex) {
    out += 'v';
    for (int axis = 0; axis < 3; ++axis) {
        out += ' ';
        appendNumber(out, vertex[axis]);
    }
    out += '\n';
}

/// The format counts from 1.
void appendFace(std::string& out, const std::array<std::uint32_t, 3>& triangle) {
    out += 'f';
    for (const std::uint32_t vertex : triangle) {
        out += ' ';
        appendNumber(out, std::uint64_t{vertex} + 1);
    }
    out += '\n';
}

} // namespace

Result<WrittenFile> writeObj(const std::filesystem::path& file, const TriangleMesh& mesh,
                             const WorkContext& context) {
    if (auto fine = checkNotEmpty(file, mesh).and_then([&] { return checkFinite(file, mesh); }); !fine)
        return tl::unexpected(std::move(fine.error()));
    AtomicFile out(file);
    MeshBatches batches(file, mesh.vertices.size() + mesh.triangles.size(), context);
    return writeWhole(out, mesh, context, [&](AtomicFile& to) {
        to.write("# Proveout, mm\n");
        return batches.pass(mesh.vertices, to, appendVertex).and_then([&] {
            return batches.pass(mesh.triangles, to, appendFace);
        });
    });
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <limits>

#include "core/base/atomic_file.h"
#include "core/formats/mesh_files.h"
#include "core/formats/mesh_writing.h"

namespace proveout {

namespace {

static_assert(std::endian::native == std::endian::little, "binary PLY is written as it lies in memory");
static_assert(sizeof(Vec3) == 3 * sizeof(double), "a vertex is written as it lies in memory");

/// Signed indices are the type that most readers support; the bits are the same as long as they suffice.
std::string header(const TriangleMesh& mesh) {
    const bool signedSuffices = mesh.vertices.size() <= std::numeric_limits<std::int32_t>::max();
    return fmt::format("ply\n"
                       "format binary_little_endian 1.0\n"
                       "comment Proveout, mm\n"
                       "element vertex {}\n"
                       "property double x\n"
                       "property double y\n"
                       "property double z\n"
                       "element face {}\n"
                       "property list uchar {} vertex_indices\n"
                       "end_header\n",
                       mesh.vertices.size(), mesh.triangles.size(), signedSuffices ? "int" : "uint");
}

template<class Value>
void appendBytes(std::string& out, const Value& value) {
    const std::size_t start = out.size();
    out.resize(start + sizeof value);
    std::memcpy(out.data() + start, &value, sizeof value);
}

void appendVertex(std::string& out, const Vec3& vertex) {
    appendBytes(out, vertex);
}

void appendFace(std::string& out, const std::array<std::uint32_t, 3>& triangle) {
    out += static_cast<char>(triangle.size());
    appendBytes(out, triangle);
}

} // namespace

Result<WrittenFile> writePly(const std::filesystem::path& file, const TriangleMesh& mesh,
                             const WorkContext& context) {
    if (auto fine = checkNotEmpty(file, mesh).and_then([&] { return checkFinite(file, mesh); }); !fine)
        return tl::unexpected(std::move(fine.error()));
    AtomicFile out(file);
    MeshBatches batches(file, mesh.vertices.size() + mesh.triangles.size(), context);
    return writeWhole(out, mesh, context, [&](AtomicFile& to) {
        to.write(header(mesh));
        return batches.pass(mesh.vertices, to, appendVertex).and_then([&] {
            return batches.pass(mesh.triangles, to, appendFace);
        });
    });
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <string>

#include "core/base/atomic_file.h"
#include "core/base/text.h"
#include "core/formats/stl.h"

namespace proveout {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is written as it lies in memory");

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kFacetSize = 50;
/// Triangles between two looks at the context: under a millisecond of work.
constexpr std::size_t kBatch = 8192;

using Point = std::array<float, 3>;

/// Normal and corners of a facet, in the order of the file.
using Facet = std::array<Point, 4>;

Point rounded(const Vec3& point) {
    return {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)};
}

Vec3 normalOf(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : Vec3(0);
}

Facet facetOf(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    const Vec3& a = mesh.vertices[triangle[0]];
    const Vec3& b = mesh.vertices[triangle[1]];
    const Vec3& c = mesh.vertices[triangle[2]];
    return {rounded(normalOf(a, b, c)), rounded(a), rounded(b), rounded(c)};
}

bool collapses(const Facet& facet) {
    return facet[1] == facet[2] || facet[2] == facet[3] || facet[3] == facet[1];
}

void appendBinary(std::string& out, const Facet& facet) {
    static_assert(sizeof(Facet) + sizeof(std::uint16_t) == kFacetSize);
    const std::size_t start = out.size();
    out.resize(start + kFacetSize); // the attribute bytes stay zero
    std::memcpy(out.data() + start, facet.data(), sizeof(Facet));
}

/// fmt writes the shortest digits that read back as the same float, with a point in every locale.
void appendAscii(std::string& out, const Facet& facet) {
    auto to = std::back_inserter(out);
    fmt::format_to(to, "facet normal {} {} {}\n outer loop\n", facet[0][0], facet[0][1], facet[0][2]);
    for (std::size_t i = 1; i < facet.size(); ++i)
        fmt::format_to(to, "  vertex {} {} {}\n", facet[i][0], facet[i][1], facet[i][2]);
    fmt::format_to(to, " endloop\nendfacet\n");
}

std::string opening(StlEncoding encoding, std::size_t count) {
    if (encoding == StlEncoding::ascii)
        return "solid proveout\n";
    // Not "solid …": readers that look at the first word alone must not take it for ASCII.
    std::string header = "Proveout, binary STL, mm";
    header.resize(kHeaderSize, ' ');
    const auto announced = static_cast<std::uint32_t>(count);
    header.resize(kHeaderSize + sizeof announced);
    std::memcpy(header.data() + kHeaderSize, &announced, sizeof announced);
    return header;
}

Result<void> checkWritable(const std::filesystem::path& file, const TriangleMesh& mesh) {
    if (mesh.triangles.empty())
        return failure("nothing-left",
                       PROVEOUT_TEXT("Core", "Nothing of the stock is left, so there is no mesh to write."),
                       {}, file.string());
    if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
        return failure("stl-too-many-triangles",
                       PROVEOUT_TEXT("Core", "The mesh has {} triangles; an STL file holds 4294967295."),
                       {std::to_string(mesh.triangles.size())}, file.string());
    for (const Vec3& vertex : mesh.vertices) {
        const double largest = std::max({std::abs(vertex.x), std::abs(vertex.y), std::abs(vertex.z)});
        if (!(largest <= static_cast<double>(std::numeric_limits<float>::max())) ||
            glm::any(glm::isnan(vertex)))
            return failure(
                "stl-coordinate", PROVEOUT_TEXT("Core", "A vertex lies at {}, {}, {}: STL cannot hold that."),
                {fmt::format("{}", vertex.x), fmt::format("{}", vertex.y), fmt::format("{}", vertex.z)},
                file.string());
    }
    return {};
}

} // namespace

Result<WrittenFile> writeStl(const std::filesystem::path& file, const TriangleMesh& mesh,
                             StlEncoding encoding, const WorkContext& context) {
    if (auto writable = checkWritable(file, mesh); !writable)
        return tl::unexpected(std::move(writable.error()));
    AtomicFile out(file);
    WrittenFile written;
    out.write(opening(encoding, mesh.triangles.size()));
    std::string batch;
    std::uint64_t collapsed = 0;
    while (written.triangles < mesh.triangles.size() && !out.failed()) {
        if (context.stopped())
            return failure("cancelled", PROVEOUT_TEXT("Core", "Cancelled; no file was written."), {},
                           file.string());
        context.tell(static_cast<double>(written.triangles) / static_cast<double>(mesh.triangles.size()));
        const auto end = std::min<std::uint64_t>(written.triangles + kBatch, mesh.triangles.size());
        batch.clear();
        for (; written.triangles < end; ++written.triangles) {
            const Facet facet = facetOf(mesh, mesh.triangles[written.triangles]);
            collapsed += collapses(facet) ? 1 : 0;
            if (encoding == StlEncoding::binary)
                appendBinary(batch, facet);
            else
                appendAscii(batch, facet);
        }
        out.write(batch);
    }
    if (collapsed > 0)
        return failure("stl-too-coarse",
                       PROVEOUT_TEXT("Core", "The coordinates of an STL file are too coarse for this mesh so "
                                             "far from the origin: {} triangles would collapse."),
                       {std::to_string(collapsed)}, file.string());
    if (encoding == StlEncoding::ascii)
        out.write("endsolid proveout\n");
    written.bytes = out.bytesWritten();
    if (auto done = out.commit(); !done)
        return tl::unexpected(std::move(done.error()));
    context.tell(1);
    return written;
}

} // namespace proveout

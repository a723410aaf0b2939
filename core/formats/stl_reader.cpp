// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/formats/mesh_findings.h"
#include "core/formats/stl.h"
#include "core/formats/stl_facets.h"
#include "core/formats/stl_warnings.h"
#include "core/formats/stl_words.h"
#include "core/formats/vertex_welder.h"

namespace proveout {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read as it lies in memory");

constexpr std::size_t kHeaderSize = 84; ///< bytes of text and count
constexpr std::size_t kFacetSize = 50;

std::uint64_t announcedCount(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeaderSize - sizeof count, sizeof count);
    return count;
}

bool startsWithSolid(std::string_view bytes) {
    static constexpr std::string_view kSolid = "solid";
    return StlWord{withoutLeadingSpace(bytes).substr(0, kSolid.size()), {}}.is(kSolid);
}

bool isText(std::string_view bytes) {
    return std::none_of(bytes.begin(), bytes.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte == 0x7f || (byte < 0x20 && (byte < '\t' || byte > '\r'));
    });
}

/// The size rule is checked first: many programs write "solid" into binary headers too.
bool isBinaryBySize(std::string_view bytes) {
    return bytes.size() >= kHeaderSize && bytes.size() == kHeaderSize + kFacetSize * announcedCount(bytes);
}

Result<StlFacets> readBinaryFacets(std::string_view bytes) {
    const std::uint64_t announced = announcedCount(bytes);
    const std::uint64_t present = (bytes.size() - kHeaderSize) / kFacetSize;
    if (announced > present)
        return failure(mesh_finding::kStlCutOffFacets,
                       {std::to_string(announced), std::to_string(bytes.size()), std::to_string(present)});
    StlFacets out;
    out.facets.resize(announced);
    const char* from = bytes.data() + kHeaderSize;
    for (StlFacet& facet : out.facets) {
        std::memcpy(facet.data(), from, sizeof facet);
        from += kFacetSize;
    }
    if (const auto read = kHeaderSize + kFacetSize * announced; read < bytes.size())
        out.warnings.push_back(diagnosticOf(
            mesh_finding::kStlTrailingBytes,
            {std::to_string(announced), std::to_string(bytes.size() - read), std::to_string(read)}));
    return out;
}

Result<StlFacets> readFacets(std::string_view bytes, StlEncoding& encoding) {
    encoding = StlEncoding::binary;
    if (isBinaryBySize(bytes))
        return readBinaryFacets(bytes);
    // Text in the first kilobyte without "solid", or the magic number of an archive: not an STL of any kind.
    const auto head = bytes.substr(0, 1024);
    if (startsWithSolid(bytes) && isText(head)) {
        encoding = StlEncoding::ascii;
        return readAsciiFacets(bytes);
    }
    if (isText(head) || bytes.starts_with("PK\3\4"))
        return failure(mesh_finding::kNotStl);
    if (bytes.size() < kHeaderSize)
        return failure(mesh_finding::kStlCutOffHeader, {std::to_string(bytes.size())});
    return readBinaryFacets(bytes);
}

bool isFinite(const StlFacet& facet) {
    return std::all_of(facet.begin() + 1, facet.end(), [](const auto& point) {
        return std::all_of(point.begin(), point.end(), [](float value) { return std::isfinite(value); });
    });
}

Vec3 exact(const std::array<float, 3>& point) {
    return {point[0], point[1], point[2]};
}

/// Adds one facet, or counts why it was skipped.
void add(const StlFacet& facet, VertexWelder& welder, StlContents& contents) {
    if (!isFinite(facet)) {
        ++contents.notFinite;
        return;
    }
    const Vec3 a = exact(facet[1]);
    const Vec3 normal = glm::cross(exact(facet[2]) - a, exact(facet[3]) - a);
    if (normal == Vec3(0)) {
        ++contents.degenerate;
        return;
    }
    if (glm::dot(normal, exact(facet[0])) < 0)
        ++contents.opposedNormals;
    contents.mesh.triangles.push_back(
        {welder.index(facet[1]), welder.index(facet[2]), welder.index(facet[3])});
}

tl::unexpected<Diagnostics> about(const std::filesystem::path& file, Diagnostics&& diagnostics) {
    for (auto& diagnostic : diagnostics)
        diagnostic.file = file.string();
    return tl::unexpected(std::move(diagnostics));
}

} // namespace

Result<StlContents> readStlContents(const std::filesystem::path& file) {
    const auto bytes = readFile(file);
    if (!bytes)
        return tl::unexpected(bytes.error());
    StlContents contents;
    auto read = readFacets(*bytes, contents.encoding);
    if (!read)
        return about(file, std::move(read.error()));
    contents.facets = read->facets.size();
    contents.warnings = std::move(read->warnings);
    VertexWelder welder(read->facets.size() / 2);
    contents.mesh.triangles.reserve(read->facets.size());
    for (const StlFacet& facet : read->facets)
        add(facet, welder, contents);
    contents.mesh.vertices = welder.releaseVertices();
    if (contents.mesh.triangles.empty())
        return failure(mesh_finding::kStlNoFacets,
                       {std::to_string(contents.facets), std::to_string(contents.notFinite),
                        std::to_string(contents.degenerate)},
                       file.string());
    contents.defects = findDefects(contents.mesh);
    warnOfStl(contents);
    for (auto& warned : contents.warnings)
        warned.file = file.string();
    return contents;
}

Result<TriangleMesh> readStl(const std::filesystem::path& file) {
    return readStlContents(file).map([](StlContents&& contents) { return std::move(contents.mesh); });
}

} // namespace proveout

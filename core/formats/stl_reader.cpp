// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <string_view>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/text.h"
#include "core/formats/stl.h"
#include "core/formats/stl_facets.h"
#include "core/formats/vertex_welder.h"

namespace proveout {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read as it lies in memory");

constexpr std::size_t kHeaderSize = 84; ///< text and count
constexpr std::size_t kFacetSize = 50;
/// Coordinates with a coarser float32 step than this (mm) no longer hold the detail of a part.
constexpr double kCoarseStep = 1e-3;

Diagnostic warning(const char* id, const char* text, std::vector<std::string> arguments) {
    Diagnostic diagnostic;
    diagnostic.severity = Severity::warning;
    diagnostic.id = id;
    diagnostic.text = text;
    diagnostic.arguments = std::move(arguments);
    return diagnostic;
}

std::uint64_t announcedCount(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeaderSize - sizeof count, sizeof count);
    return count;
}

bool startsWithSolid(std::string_view bytes) {
    static constexpr std::string_view kSolid = "solid";
    const auto start = std::min(bytes.find_first_not_of(" \t\r\n\v\f"), bytes.size());
    const auto word = bytes.substr(start, kSolid.size());
    return std::equal(word.begin(), word.end(), kSolid.begin(), kSolid.end(),
                      [](char a, char b) { return (a | 0x20) == b; });
}

bool isText(std::string_view bytes) {
    return std::none_of(bytes.begin(), bytes.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte == 0x7f || (byte < 0x20 && (byte < '\t' || byte > '\r'));
    });
}

/// The size rule comes first: many programs write "solid" into binary headers too.
bool isBinaryBySize(std::string_view bytes) {
    return bytes.size() >= kHeaderSize && bytes.size() == kHeaderSize + kFacetSize * announcedCount(bytes);
}

Result<StlFacets> readBinaryFacets(std::string_view bytes) {
    const std::uint64_t announced = announcedCount(bytes);
    const std::uint64_t present = (bytes.size() - kHeaderSize) / kFacetSize;
    if (announced > present)
        return failure("stl-cut-off",
                       PROVEOUT_TEXT("Core", "The file announces {} facets and ends at byte {}, after {}."),
                       {std::to_string(announced), std::to_string(bytes.size()), std::to_string(present)});
    StlFacets out;
    out.facets.resize(announced);
    const char* from = bytes.data() + kHeaderSize;
    for (StlFacet& facet : out.facets) {
        std::memcpy(facet.data(), from, sizeof facet);
        from += kFacetSize;
    }
    if (const auto read = kHeaderSize + kFacetSize * announced; read < bytes.size())
        out.warnings.push_back(warning(
            "stl-trailing-bytes",
            PROVEOUT_TEXT("Core", "The {} facets announced were read; {} bytes follow them from byte {}."),
            {std::to_string(announced), std::to_string(bytes.size() - read), std::to_string(read)}));
    return out;
}

Result<StlFacets> readFacets(std::string_view bytes, StlEncoding& encoding) {
    encoding = StlEncoding::binary;
    if (isBinaryBySize(bytes))
        return readBinaryFacets(bytes);
    // Text in the first kilobyte and no "solid", or the magic number of an archive: no STL of any kind.
    const auto head = bytes.substr(0, 1024);
    if (startsWithSolid(bytes) && isText(head)) {
        encoding = StlEncoding::ascii;
        return readAsciiFacets(bytes);
    }
    if (isText(head) || bytes.starts_with("PK\3\4"))
        return failure("not-stl", PROVEOUT_TEXT("Core", "This is not an STL file."));
    if (bytes.size() < kHeaderSize)
        return failure(
            "stl-cut-off",
            PROVEOUT_TEXT("Core", "This is not an STL file: it ends at byte {}, within the header."),
            {std::to_string(bytes.size())});
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

/// Adds one facet, or counts why it was left out.
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

void warnOfCounts(StlContents& contents) {
    const auto warn = [&contents](std::size_t count, const char* id, const char* text) {
        if (count > 0)
            contents.warnings.push_back(
                warning(id, text, {std::to_string(count), std::to_string(contents.facets)}));
    };
    warn(contents.notFinite, "stl-not-finite",
         PROVEOUT_TEXT("Core",
                       "{} of {} facets have a coordinate that is no finite number; they were left out."));
    warn(contents.degenerate, "stl-degenerate",
         PROVEOUT_TEXT("Core", "{} of {} facets have no area; they were left out."));
    warn(contents.opposedNormals, "stl-opposed-normals",
         PROVEOUT_TEXT("Core", "{} of {} facets have a normal against their winding; the winding counts."));
}

void warnOfSize(StlContents& contents) {
    Box3 box;
    for (const Vec3& vertex : contents.mesh.vertices)
        box.add(vertex);
    if (box.empty())
        return;
    const Vec3 farthest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    const double largest = std::max({farthest.x, farthest.y, farthest.z});
    const double step = largest * static_cast<double>(std::numeric_limits<float>::epsilon());
    if (step > kCoarseStep)
        contents.warnings.push_back(warning(
            "stl-far-origin",
            PROVEOUT_TEXT("Core", "The mesh lies {} mm from the origin, where an STL file holds steps of "
                                  "{} mm only."),
            {fmt::format("{:.6g}", largest), fmt::format("{:.2g}", step)}));
    const Vec3 size = box.hi - box.lo;
    if (std::max({size.x, size.y, size.z}) < kCoarseStep)
        contents.warnings.push_back(warning(
            "stl-no-size", PROVEOUT_TEXT("Core", "The mesh is {} × {} × {} mm: hardly a part."),
            {fmt::format("{:.3g}", size.x), fmt::format("{:.3g}", size.y), fmt::format("{:.3g}", size.z)}));
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
    contents.mesh.vertices = welder.takeVertices();
    if (contents.mesh.triangles.empty())
        return failure("stl-no-facets",
                       PROVEOUT_TEXT("Core",
                                     "The file holds no facet that could be used ({} read, {} not finite, "
                                     "{} without area)."),
                       {std::to_string(contents.facets), std::to_string(contents.notFinite),
                        std::to_string(contents.degenerate)},
                       file.string());
    warnOfCounts(contents);
    warnOfSize(contents);
    for (auto& warned : contents.warnings)
        warned.file = file.string();
    return contents;
}

Result<TriangleMesh> readStl(const std::filesystem::path& file) {
    return readStlContents(file).map([](StlContents&& contents) { return std::move(contents.mesh); });
}

} // namespace proveout

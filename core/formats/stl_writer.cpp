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
#include "core/base/figures_argument.h"
#include "core/decimation/solid/solid_error.h"
#include "core/formats/export_findings.h"
#include "core/formats/formats.h"
#include "core/formats/mesh_writing.h"
#include "core/formats/stl.h"
#include "core/formats/vertex_welder.h"

namespace proveout {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is written as it lies in memory");

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kFacetSize = 50;

using Triangle = std::array<std::uint32_t, 3>;
using Point = std::array<float, 3>;

/// Normal and corners of a facet, in the order of the file.
using Facet = std::array<Point, 4>;

Vec3 inFile(const Vec3& point) {
    return roundedTo(CoordinateType::float32, point);
}

Point toFloat(const Vec3& point) {
    return {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)};
}

Vec3 normalOf(const std::array<Vec3, 3>& at) {
    return glm::cross(at[1] - at[0], at[2] - at[0]);
}

Vec3 normalized(const Vec3& normal) {
    const double length = glm::length(normal);
    return length > 0 ? normal / length : Vec3(0);
}

/// Turns triangles into facets and counts those that lose their area or turn over by the rounding.
class Rounding {
public:
    /// Vertices that may merge are searched for in this many passes, each over a part of them, because a
    /// welder of all would need as much memory as the mesh.
    static constexpr std::size_t kParts = 8;

    explicit Rounding(const TriangleMesh& mesh) : m_mesh(mesh), m_coarse(isCoarse(mesh)) {}

    /// Whether vertices may merge: only where steps of float32 come near the spacing of a grid, because the
    /// gaps that closeSolid() leaves are preserved at any distance. If true, all of them must be checked.
    [[nodiscard]] bool verticesMayMeet() const { return m_coarse; }

    /// Call it for the vertices in the order of the mesh, kParts times.
    void look(const Vec3& vertex) {
        const Point rounded = toFloat(inFile(vertex));
        if (partOf(rounded) == m_part) {
            const std::uint32_t welded = m_welder.index(rounded);
            if (welded == m_first.size())
                m_first.push_back(m_looked);
            else
                m_met += m_mesh.vertices[m_first[welded]] != vertex ? 1 : 0;
        }
        if (++m_looked == m_mesh.vertices.size())
            beginPart(m_part + 1);
    }

    Facet facet(const Triangle& triangle) {
        const std::array<Vec3, 3> exact{m_mesh.vertices[triangle[0]], m_mesh.vertices[triangle[1]],
                                        m_mesh.vertices[triangle[2]]};
        const std::array<Vec3, 3> rounded{inFile(exact[0]), inFile(exact[1]), inFile(exact[2])};
        const Vec3 normal = normalOf(exact);
        m_lost += glm::dot(normal, normalOf(rounded)) > 0 ? 0 : 1;
        return {toFloat(normalized(normal)), toFloat(rounded[0]), toFloat(rounded[1]), toFloat(rounded[2])};
    }

    /// Refuses a mesh that would no longer be the boundary of a solid.
    [[nodiscard]] Result<void> check(const std::filesystem::path& file) const {
        if (m_lost == 0 && m_met == 0)
            return {};
        return failure(export_finding::kStlTooCoarse,
                       {std::to_string(m_lost), std::to_string(m_met), exactMeshEndings()}, file.string());
    }

private:
    static bool isCoarse(const TriangleMesh& mesh) {
        constexpr double kFineStep = 1e-3; // mm
        double farthest = 0;
        for (const Vec3& vertex : mesh.vertices)
            farthest = std::max({farthest, std::abs(vertex.x), std::abs(vertex.y), std::abs(vertex.z)});
        return farthest * static_cast<double>(std::numeric_limits<float>::epsilon()) >= kFineStep;
    }

    /// Equal points are in the same part: adding zero turns -0 into 0.
    static std::size_t partOf(const Point& rounded) {
        std::uint32_t mixed = 0;
        for (const float value : rounded)
            mixed = (mixed ^ std::bit_cast<std::uint32_t>(value + 0.0F)) * 0x9e3779b9U;
        return mixed >> 29U; // 3 bits for kParts
    }

    void beginPart(std::size_t part) {
        m_part = part;
        m_looked = 0;
        m_welder = VertexWelder(0);
        m_first.clear();
    }

    const TriangleMesh& m_mesh;
    bool m_coarse;
    VertexWelder m_welder{0};
    std::vector<std::uint32_t> m_first; ///< by index of the float32 position: the first vertex that was there
    std::size_t m_part = 0;
    std::uint32_t m_looked = 0;
    std::uint64_t m_met = 0; ///< vertices that are distinct but have equal float32 positions
    std::uint64_t m_lost = 0;
};

void appendBinary(std::string& out, const Facet& facet) {
    static_assert(sizeof(Facet) + sizeof(std::uint16_t) == kFacetSize);
    const std::size_t start = out.size();
    out.resize(start + kFacetSize); // the attribute bytes stay zero
    std::memcpy(out.data() + start, facet.data(), sizeof(Facet));
}

/// fmt writes the shortest digits that read back as the same float, with a decimal point in every locale.
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
    // Not "solid …": readers that check only the first word must not mistake it for ASCII.
    std::string header = "Proveout, binary STL, mm";
    header.resize(kHeaderSize, ' ');
    const auto announced = static_cast<std::uint32_t>(count);
    header.resize(kHeaderSize + sizeof announced);
    std::memcpy(header.data() + kHeaderSize, &announced, sizeof announced);
    return header;
}

/// 0 if it depends on the digits.
std::uint64_t expectedBytes(StlEncoding encoding, std::size_t count) {
    return encoding == StlEncoding::ascii
               ? 0
               : kHeaderSize + sizeof(std::uint32_t) + static_cast<std::uint64_t>(count) * kFacetSize;
}

Result<void> checkStl(const std::filesystem::path& file, const TriangleMesh& mesh) {
    if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
        return failure(export_finding::kStlTooManyTriangles, {std::to_string(mesh.triangles.size())},
                       file.string());
    return checkSinglePrecision(file, mesh);
}

} // namespace

Result<WrittenFile> writeStl(const std::filesystem::path& file, const TriangleMesh& mesh,
                             StlEncoding encoding, const WorkContext& context) {
    if (auto fine = checkNotEmpty(file, mesh).and_then([&] { return checkStl(file, mesh); }); !fine)
        return tl::unexpected(std::move(fine.error()));
    AtomicFile out(file, expectedBytes(encoding, mesh.triangles.size()));
    Rounding rounding(mesh);
    const std::size_t looks = rounding.verticesMayMeet() ? Rounding::kParts : 0;
    MeshBatches batches(file, mesh.triangles.size() + looks * mesh.vertices.size(), context);
    const auto append = encoding == StlEncoding::binary ? appendBinary : appendAscii;
    return writeWhole(out, mesh, context, [&](AtomicFile& to) {
        to.write(opening(encoding, mesh.triangles.size()));
        return batches
            .pass(
                mesh.triangles, to,
                [&](std::string& text, const Triangle& triangle) { append(text, rounding.facet(triangle)); })
            .and_then([&]() -> Result<void> {
                for (std::size_t part = 0; part < looks; ++part)
                    if (Result<void> looked =
                            batches.pass(mesh.vertices, to,
                                         [&](std::string&, const Vec3& vertex) { rounding.look(vertex); });
                        !looked)
                        return looked;
                return {};
            })
            .and_then([&] { return rounding.check(file); })
            .map([&] { to.write(encoding == StlEncoding::ascii ? "endsolid proveout\n" : ""); });
    });
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/formats/export_findings.h"
#include "core/formats/glb.h"
#include "core/formats/mesh_files.h"
#include "core/formats/mesh_writing.h"

namespace proveout {

namespace {

static_assert(std::endian::native == std::endian::little, "GLB is written as it lies in memory");

// glTF 2.0, sections 3 and 4: constants and chunks.
constexpr std::uint32_t kMagic = 0x46546C67; // "glTF"
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kNearest = 9728;
constexpr int kLinear = 9729;
constexpr int kClamp = 33071;
constexpr std::uint64_t kHeaderBytes = 12;
constexpr std::uint64_t kChunkHeaderBytes = 8;

using Point = std::array<float, 3>;
using TexturePlace = std::array<float, 2>;
using Triangle = std::array<std::uint32_t, 3>;

Point rounded(const Vec3& vertex) {
    return {static_cast<float>(vertex.x), static_cast<float>(vertex.y), static_cast<float>(vertex.z)};
}

struct Sizes {
    /// `texture`: null: none.
    Sizes(const TriangleMesh& mesh, const PlanTexture* texture)
        : vertices(mesh.vertices.size() * sizeof(Point)), triangles(mesh.triangles.size() * sizeof(Triangle)),
          places(texture == nullptr ? 0 : mesh.vertices.size() * sizeof(TexturePlace)),
          picture(texture == nullptr ? 0 : texture->png.size()) {}
    std::uint64_t vertices;
    std::uint64_t triangles;
    std::uint64_t places;
    std::uint64_t picture;
    [[nodiscard]] std::uint64_t binary() const {
        return (vertices + triangles + places + picture + 3) / 4 * 4;
    }
};

/// The third accessor and the last two views.
void addTexture(nlohmann::ordered_json& json, const TriangleMesh& mesh, const Sizes& sizes) {
    const std::uint64_t places = sizes.vertices + sizes.triangles;
    json["accessors"].push_back(
        {{"bufferView", 2}, {"componentType", kFloat}, {"count", mesh.vertices.size()}, {"type", "VEC2"}});
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", places}, {"byteLength", sizes.places}, {"target", kArrayBuffer}});
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", places + sizes.places}, {"byteLength", sizes.picture}});
    json["images"] = {{{"bufferView", 3}, {"mimeType", "image/png"}}};
    json["samplers"] = {
        {{"magFilter", kNearest}, {"minFilter", kLinear}, {"wrapS", kClamp}, {"wrapT", kClamp}}};
    json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 2;
    json["materials"][0]["pbrMetallicRoughness"] = {
        {"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}};
}

/// From the upper left corner of the picture.
TexturePlace textureAt(const Vec3& vertex, const PlanTexture& texture) {
    const Vec2 size = texture.hi - texture.lo;
    return {static_cast<float>((vertex.x - texture.lo.x) / size.x),
            static_cast<float>((texture.hi.y - vertex.y) / size.y)};
}

/// The scene has Y upwards and metres; the vertices stay in program coordinates. Spaces fill it to four
/// bytes.
std::string description(const TriangleMesh& mesh, const PlanTexture* texture) {
    Point low;
    Point high;
    low.fill(std::numeric_limits<float>::infinity());
    high.fill(-std::numeric_limits<float>::infinity());
    for (const Vec3& vertex : mesh.vertices) {
        const Point point = rounded(vertex);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], point[axis]);
            high[axis] = std::max(high[axis], point[axis]);
        }
    }
    const Sizes sizes(mesh, texture);
    nlohmann::ordered_json json{
        {"asset", {{"version", "2.0"}, {"generator", "Proveout"}}},
        {"scene", 0},
        {"scenes", {{{"nodes", {0}}}}},
        {"nodes",
         {{{"mesh", 0},
           {"name", "Stock"},
           {"matrix", {0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0, 0, 0, 1}}}}},
        {"meshes",
         {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"material", 0}}}}}}},
        {"materials",
         {{{"pbrMetallicRoughness",
            {{"baseColorFactor", {0.7, 0.72, 0.75, 1}},
             {"metallicFactor", 0.3},
             {"roughnessFactor", 0.5}}}}}},
        {"accessors",
         {{{"bufferView", 0},
           {"componentType", kFloat},
           {"count", mesh.vertices.size()},
           {"type", "VEC3"},
           {"min", low},
           {"max", high}},
          {{"bufferView", 1},
           {"componentType", kUnsignedInt},
           {"count", 3 * mesh.triangles.size()},
           {"type", "SCALAR"}}}},
        {"bufferViews",
         {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", sizes.vertices}, {"target", kArrayBuffer}},
          {{"buffer", 0},
           {"byteOffset", sizes.vertices},
           {"byteLength", sizes.triangles},
           {"target", kElementArrayBuffer}}}},
        {"buffers", {{{"byteLength", sizes.binary()}}}}};
    if (texture != nullptr)
        addTexture(json, mesh, sizes);
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return text;
}

template<class Value>
void appendBytes(std::string& out, const Value& value) {
    const std::size_t start = out.size();
    out.resize(start + sizeof value);
    std::memcpy(out.data() + start, &value, sizeof value);
}

/// Refuses what single precision, or lengths of 32 bits, cannot hold.
Result<void> check(const std::filesystem::path& file, const TriangleMesh& mesh, std::uint64_t bytes) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    if (bytes > kMost)
        return failure(export_finding::kGlbTooLarge,
                       {std::to_string(mesh.triangles.size()), std::to_string(kMost)}, file.string());
    return checkSinglePrecision(file, mesh);
}

/// All before the vertices.
std::string headOf(const std::string& json, std::uint64_t binary) {
    std::string head;
    const std::uint64_t bytes = kHeaderBytes + 2 * kChunkHeaderBytes + json.size() + binary;
    for (const std::uint32_t word : {kMagic, kVersion, static_cast<std::uint32_t>(bytes),
                                     static_cast<std::uint32_t>(json.size()), kJsonChunk})
        appendBytes(head, word);
    head += json;
    for (const std::uint32_t word : {static_cast<std::uint32_t>(binary), kBinaryChunk})
        appendBytes(head, word);
    return head;
}

Result<void> checkAll(const std::filesystem::path& file, const TriangleMesh& mesh, std::uint64_t bytes) {
    return checkNotEmpty(file, mesh).and_then([&] { return checkFinite(file, mesh); }).and_then([&] {
        return check(file, mesh, bytes);
    });
}

} // namespace

Result<std::string> glbOf(const TriangleMesh& mesh, const PlanTexture& texture) {
    const std::uint64_t binary = Sizes(mesh, &texture).binary();
    std::string bytes = headOf(description(mesh, &texture), binary);
    if (auto fine = checkAll({}, mesh, bytes.size() + binary); !fine)
        return tl::unexpected(std::move(fine.error()));
    const std::size_t end = bytes.size() + binary;
    bytes.reserve(end);
    for (const Vec3& vertex : mesh.vertices)
        appendBytes(bytes, rounded(vertex));
    for (const Triangle& triangle : mesh.triangles)
        appendBytes(bytes, triangle);
    for (const Vec3& vertex : mesh.vertices)
        appendBytes(bytes, textureAt(vertex, texture));
    bytes += texture.png;
    bytes.resize(end, '\0');
    return bytes;
}

Result<WrittenFile> writeGlb(const std::filesystem::path& file, const TriangleMesh& mesh,
                             const WorkContext& context) {
    const std::uint64_t binary = Sizes(mesh, nullptr).binary();
    const std::string head = headOf(description(mesh, nullptr), binary);
    if (auto fine = checkAll(file, mesh, head.size() + binary); !fine)
        return tl::unexpected(std::move(fine.error()));
    AtomicFile out(file);
    MeshBatches batches(file, mesh.vertices.size() + mesh.triangles.size(), context);
    return writeWhole(out, mesh, context, [&](AtomicFile& to) {
        to.write(head);
        const auto appendVertex = [](std::string& text, const Vec3& vertex) {
            appendBytes(text, rounded(vertex));
        };
        const auto appendTriangle = [](std::string& text, const Triangle& triangle) {
            appendBytes(text, triangle);
        };
        return batches.pass(mesh.vertices, to, appendVertex).and_then([&] {
            return batches.pass(mesh.triangles, to, appendTriangle);
        });
    });
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "core/formats/mesh_files.h"
#include "core/formats/mesh_writing.h"
#include "core/formats/zip_file.h"

namespace proveout {

namespace {

constexpr const char* kXml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
constexpr const char* kContentTypes =
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
    "</Types>\n";
constexpr const char* kRelationships =
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Id=\"model\" Target=\"/3D/3dmodel.model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
    "</Relationships>\n";
constexpr const char* kModelBegins = "<model unit=\"millimeter\" xml:lang=\"en-US\" "
                                     "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
                                     "<metadata name=\"Application\">Proveout</metadata>\n"
                                     "<resources><object id=\"1\" type=\"model\"><mesh>\n<vertices>\n";
constexpr const char* kTrianglesBegin = "</vertices>\n<triangles>\n";
constexpr const char* kModelEnds =
    "</triangles>\n</mesh></object></resources>\n<build><item objectid=\"1\"/></build>\n</model>\n";

void appendAttribute(std::string& out, std::string_view opening, auto value) {
    out += opening;
    appendNumber(out, value);
}

void appendVertex(std::string& out, const Vec3& vertex) {
    appendAttribute(out, "<vertex x=\"", vertex.x);
    appendAttribute(out, "\" y=\"", vertex.y);
    appendAttribute(out, "\" z=\"", vertex.z);
    out += "\"/>\n";
}

void appendTriangle(std::string& out, const std::array<std::uint32_t, 3>& triangle) {
    appendAttribute(out, "<triangle v1=\"", triangle[0]);
    appendAttribute(out, "\" v2=\"", triangle[1]);
    appendAttribute(out, "\" v3=\"", triangle[2]);
    out += "\"/>\n";
}

/// The lengths are upper bounds for the longest numbers: 24 digits and signs of a double and 10 digits of an
/// index.
bool mayReachFourGigabytes(const TriangleMesh& mesh) {
    constexpr std::uint64_t kLongestVertex = 104;
    constexpr std::uint64_t kLongestTriangle = 72;
    constexpr std::uint64_t kRest = 4096;
    return mesh.vertices.size() * kLongestVertex + mesh.triangles.size() * kLongestTriangle + kRest >
           std::numeric_limits<std::uint32_t>::max();
}

void writePart(ZipFile& out, const char* name, const char* xml) {
    out.beginEntry(name);
    out.write(kXml);
    out.write(xml);
}

} // namespace

Result<WrittenFile> write3mf(const std::filesystem::path& file, const TriangleMesh& mesh,
                             const WorkContext& context) {
    if (auto fine = checkNotEmpty(file, mesh).and_then([&] { return checkFinite(file, mesh); }); !fine)
        return tl::unexpected(std::move(fine.error()));
    ZipFile out(file, mayReachFourGigabytes(mesh));
    MeshBatches batches(file, mesh.vertices.size() + mesh.triangles.size(), context);
    return writeWhole(out, mesh, context, [&](ZipFile& to) {
        writePart(to, "[Content_Types].xml", kContentTypes);
        writePart(to, "_rels/.rels", kRelationships);
        writePart(to, "3D/3dmodel.model", kModelBegins);
        return batches.pass(mesh.vertices, to, appendVertex)
            .and_then([&] {
                to.write(kTrianglesBegin);
                return batches.pass(mesh.triangles, to, appendTriangle);
            })
            .map([&] { to.write(kModelEnds); });
    });
}

} // namespace proveout

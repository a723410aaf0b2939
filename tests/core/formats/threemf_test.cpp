// SPDX-License-Identifier: GPL-3.0-or-later
// 3MF files, read by the archive library and a strict XML parser.
#include <archive.h>
#include <archive_entry.h>
#include <cstdlib>
#include <expat.h>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/formats/mesh_files.h"
#include "tests/core/formats/meshes.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

using test::randomSoup;
using test::tetrahedron;

/// The entries of an archive, in sequence; the test fails if it cannot be read to its end.
std::vector<std::pair<std::string, std::string>> entriesOf(const std::filesystem::path& file) {
    const std::unique_ptr<archive, decltype(&archive_read_free)> from(archive_read_new(), archive_read_free);
    archive_read_support_format_zip_seekable(from.get()); // uses the directory, as most readers do
    EXPECT_EQ(archive_read_open_filename(from.get(), file.c_str(), 65536), ARCHIVE_OK);
    std::vector<std::pair<std::string, std::string>> entries;
    archive_entry* entry = nullptr;
    int status = ARCHIVE_OK;
    while ((status = archive_read_next_header(from.get(), &entry)) == ARCHIVE_OK) {
        std::string bytes(static_cast<std::size_t>(archive_entry_size(entry)), '\0');
        EXPECT_EQ(archive_read_data(from.get(), bytes.data(), bytes.size()),
                  static_cast<la_ssize_t>(bytes.size()));
        entries.emplace_back(archive_entry_pathname(entry), std::move(bytes));
    }
    EXPECT_EQ(status, ARCHIVE_EOF) << archive_error_string(from.get());
    return entries;
}

/// The content of an XML document: elements as paths of "namespace|name", with their attributes.
struct Element {
    std::string path;
    std::map<std::string, std::string> attributes;
};

class Document {
public:
    explicit Document(const std::string& xml) {
        const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
            XML_ParserCreateNS(nullptr, '|'), XML_ParserFree);
        XML_SetUserData(parser.get(), this);
        XML_SetElementHandler(
            parser.get(),
            [](void* self, const XML_Char* name, const XML_Char** attributes) {
                static_cast<Document*>(self)->begin(name, attributes);
            },
            [](void* self, const XML_Char* /*name*/) { static_cast<Document*>(self)->end(); });
        const auto status = XML_Parse(parser.get(), xml.data(), static_cast<int>(xml.size()), 1);
        EXPECT_EQ(status, XML_STATUS_OK) << XML_ErrorString(XML_GetErrorCode(parser.get())) << " in line "
                                         << XML_GetCurrentLineNumber(parser.get());
    }

    /// The elements whose path ends in `ending`.
    [[nodiscard]] std::vector<const Element*> all(const std::string& ending) const& {
        std::vector<const Element*> found;
        for (const Element& element : m_elements)
            if (element.path.ends_with(ending))
                found.push_back(&element);
        return found;
    }

private:
    void begin(const std::string& name, const XML_Char** attributes) {
        m_open.push_back(name);
        Element element;
        for (const std::string& part : m_open)
            element.path += "/" + part;
        for (; *attributes != nullptr; attributes += 2)
            element.attributes[attributes[0]] = attributes[1];
        m_elements.push_back(std::move(element));
    }
    void end() { m_open.pop_back(); }

    std::vector<std::string> m_open;
    std::vector<Element> m_elements;
};

const std::string kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02|";

/// A path of elements of the core namespace.
std::string core(const std::string& names) {
    std::string path;
    for (std::size_t at = 0; at < names.size();) {
        const std::size_t end = std::min(names.find('/', at), names.size());
        path += "/" + kCore + names.substr(at, end - at);
        at = end + 1;
    }
    return path;
}

void expectSame(const Document& model, const TriangleMesh& mesh) {
    const auto vertices = model.all(core("model/resources/object/mesh/vertices/vertex"));
    ASSERT_EQ(vertices.size(), mesh.vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const auto& attributes = vertices[v]->attributes;
        ASSERT_EQ(attributes.size(), 3U);
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_EQ(std::strtod(attributes.at({"xyz"[axis]}).c_str(), nullptr), mesh.vertices[v][axis]);
    }
    const auto triangles = model.all(core("model/resources/object/mesh/triangles/triangle"));
    ASSERT_EQ(triangles.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t corner = 0; corner < 3; ++corner)
            ASSERT_EQ(std::stoul(triangles[t]->attributes.at("v" + std::to_string(corner + 1))),
                      mesh.triangles[t][corner]);
}

TEST(ThreeMf, IsAPackageThatLeadsToItsModel) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write3mf(folder / "a.3mf", tetrahedron()));
    const auto entries = entriesOf(folder / "a.3mf");
    ASSERT_EQ(entries.size(), 3U);
    EXPECT_EQ(entries[0].first, "[Content_Types].xml");
    EXPECT_EQ(entries[1].first, "_rels/.rels");
    EXPECT_EQ(entries[2].first, "3D/3dmodel.model");

    const Document typesPart(entries[0].second);
    std::map<std::string, std::string> types;
    for (const Element* row :
         typesPart.all("http://schemas.openxmlformats.org/package/2006/content-types|Default"))
        types[row->attributes.at("Extension")] = row->attributes.at("ContentType");
    EXPECT_EQ(types["rels"], "application/vnd.openxmlformats-package.relationships+xml");
    EXPECT_EQ(types["model"], "application/vnd.ms-package.3dmanufacturing-3dmodel+xml");

    const Document relationships(entries[1].second);
    const auto rows =
        relationships.all("http://schemas.openxmlformats.org/package/2006/relationships|Relationship");
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0]->attributes.at("Target"), "/" + entries[2].first);
    EXPECT_EQ(rows[0]->attributes.at("Type"), "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel");
}

TEST(ThreeMf, ModelIsOneObjectInMillimetresThatIsBuilt) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write3mf(folder / "a.3mf", tetrahedron(2)));
    const Document model(entriesOf(folder / "a.3mf").at(2).second);
    const auto root = model.all(core("model"));
    ASSERT_EQ(root.size(), 1U);
    EXPECT_EQ(root[0]->attributes.at("unit"), "millimeter");
    const auto objects = model.all(core("model/resources/object"));
    ASSERT_EQ(objects.size(), 1U);
    EXPECT_EQ(objects[0]->attributes.at("type"), "model");
    const auto items = model.all(core("model/build/item"));
    ASSERT_EQ(items.size(), 1U);
    EXPECT_EQ(items[0]->attributes.at("objectid"), objects[0]->attributes.at("id"));
    expectSame(model, tetrahedron(2));
}

TEST(ThreeMf, HoldsEveryVertexAndTriangle) {
    const TemporaryFolder folder;
    TriangleMesh mesh = randomSoup(30'000, 1);
    mesh.vertices[0] = {-0.0, 1e-300, -1.7976931348623157e308}; // numbers with the longest representation
    mesh.vertices[1] = {1e22, -2.2250738585072014e-308, 5e-324};
    ASSERT_TRUE(write3mf(folder / "a.3mf", mesh));
    const auto entries = entriesOf(folder / "a.3mf");
    ASSERT_EQ(entries.size(), 3U);
    expectSame(Document(entries[2].second), mesh);
}

/// Byte 6 of the first header contains the flags, byte 4 the version that a reader must support: 2.0, not
/// 4.5.
TEST(ThreeMf, SmallArchivesNeedNoZip64) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write3mf(folder / "a.3mf", randomSoup(1000, 2)));
    const std::string bytes = readFile(folder / "a.3mf").value();
    EXPECT_EQ(bytes.substr(0, 4), "PK\3\4");
    EXPECT_EQ(bytes[4], 20);
    EXPECT_EQ(bytes.find("PK\6\6"), std::string::npos) << "an end of directory of zip64";
    EXPECT_EQ(bytes.substr(bytes.size() - 22, 4), "PK\5\6") << "nothing behind the end of the directory";
}

} // namespace
} // namespace proveout

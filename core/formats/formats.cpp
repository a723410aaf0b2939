// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/text.h"
#include "core/formats/export_findings.h"

namespace proveout {

namespace {

constexpr std::array kStlExtensions{".stl"};
constexpr std::array kObjExtensions{".obj"};
constexpr std::array kPlyExtensions{".ply"};
constexpr std::array k3mfExtensions{".3mf"};
constexpr std::array kGlbExtensions{".glb"};
constexpr std::array kNpyExtensions{".npy"};
constexpr std::array kJobExtensions{".proveout"};
constexpr std::array kStockExtensions{".pvstock"};

template<StlEncoding encoding>
Result<WrittenFile> writeStlAs(const std::filesystem::path& file, const TriangleMesh& mesh,
                               const WorkContext& context) {
    return writeStl(file, mesh, encoding, context);
}

constexpr std::array kFormats{
    FileFormat{"stl", PROVEOUT_TEXT("Core", "STL, binary"), kStlExtensions,
               PROVEOUT_TEXT("Core", "a closed triangle mesh of the stock"),
               MeshFormat{readStl, writeStlAs<StlEncoding::binary>, CoordinateType::float32, 50}},
    FileFormat{"stl-ascii", PROVEOUT_TEXT("Core", "STL, ASCII"), kStlExtensions,
               PROVEOUT_TEXT("Core", "a closed triangle mesh of the stock"),
               MeshFormat{readStl, writeStlAs<StlEncoding::ascii>, CoordinateType::float32, 94}},
    FileFormat{"obj", PROVEOUT_TEXT("Core", "Wavefront OBJ"), kObjExtensions,
               PROVEOUT_TEXT("Core", "a closed triangle mesh of the stock"),
               MeshFormat{nullptr, writeObj, CoordinateType::float64, 12}},
    FileFormat{"ply", PROVEOUT_TEXT("Core", "PLY, binary"), kPlyExtensions,
               PROVEOUT_TEXT("Core", "a closed triangle mesh of the stock"),
               MeshFormat{nullptr, writePly, CoordinateType::float64, 25}},
    FileFormat{"3mf", PROVEOUT_TEXT("Core", "3MF"), k3mfExtensions,
               PROVEOUT_TEXT("Core", "a closed triangle mesh of the stock"),
               MeshFormat{nullptr, write3mf, CoordinateType::float64, 1}},
    FileFormat{"glb", PROVEOUT_TEXT("Core", "GLB (glTF 2.0)"), kGlbExtensions,
               PROVEOUT_TEXT("Core", "a closed triangle mesh of the stock"),
               MeshFormat{nullptr, writeGlb, CoordinateType::float32, 18}},
    FileFormat{"npy", PROVEOUT_TEXT("Core", "NumPy array"), kNpyExtensions,
               PROVEOUT_TEXT("Core", "the heights of a z-map, row 0 at the smallest y"),
               HeightsFormat{readNpy, writeNpy}},
    FileFormat{"job", PROVEOUT_TEXT("Core", "Proveout job"), kJobExtensions,
               PROVEOUT_TEXT("Core", "a program with its stock, tools and parameters"),
               JobFormat{readJob, writeJob}},
    FileFormat{"stock", PROVEOUT_TEXT("Core", "Proveout stock"), kStockExtensions,
               PROVEOUT_TEXT("Core", "the stock left by a setup"), StockFormat{readStock, writeStock}},
};

/// The extensions of those mesh formats that can be written and that fit, each once.
template<class Fits>
std::string endingsWhere(Fits&& fits) {
    std::vector<std::string_view> seen;
    std::string endings;
    for (const FileFormat& row : kFormats)
        for (const std::string_view ending : row.extensions) {
            const MeshFormat* mesh = row.meshWriter();
            if (mesh == nullptr || !fits(*mesh) || std::ranges::find(seen, ending) != seen.end())
                continue;
            seen.push_back(ending);
            endings.append(endings.empty() ? "" : " ").append(ending);
        }
    return endings;
}

} // namespace

bool FileFormat::reads() const {
    return std::visit([](const auto& handler) { return handler.read != nullptr; }, handlers);
}

bool FileFormat::writes() const {
    return std::visit([](const auto& handler) { return handler.write != nullptr; }, handlers);
}

const MeshFormat* FileFormat::meshWriter() const {
    const auto* mesh = std::get_if<MeshFormat>(&handlers);
    return mesh != nullptr && mesh->write != nullptr ? mesh : nullptr;
}

std::uint64_t fullMeshBytes(const MeshFormat& format, const Grid& grid) {
    return format.leastBytes * 2 * static_cast<std::uint64_t>(grid.nx - 1) *
           static_cast<std::uint64_t>(grid.ny - 1);
}

const char* nameOf(CoordinateType type) {
    return type == CoordinateType::float32 ? "float32" : "float64";
}

std::span<const FileFormat> fileFormats() {
    return kFormats;
}

const FileFormat* findFormat(std::string_view key) {
    const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                    [key](const FileFormat& row) { return row.key == key; });
    return found == kFormats.end() ? nullptr : &*found;
}

std::string meshEndings() {
    return endingsWhere([](const MeshFormat&) { return true; });
}

std::string exactMeshEndings() {
    return endingsWhere(
        [](const MeshFormat& format) { return format.coordinates == CoordinateType::float64; });
}

Result<const FileFormat*> meshFormatOf(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&extension](const FileFormat& row) {
        return row.meshWriter() != nullptr &&
               std::ranges::find(row.extensions, extension) != row.extensions.end();
    });
    if (found == kFormats.end())
        return failure(export_finding::kExportFormatUnknown, {meshEndings()}, file.string());
    return &*found;
}

} // namespace proveout

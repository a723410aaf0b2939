// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"

namespace proveout {

namespace {

constexpr std::array kStlExtensions{".stl"};
constexpr std::array kNpyExtensions{".npy"};
constexpr std::array kJobExtensions{".proveout"};

template<StlEncoding encoding>
Result<WrittenFile> writeStlAs(const std::filesystem::path& file, const TriangleMesh& mesh,
                               const WorkContext& context) {
    return writeStl(file, mesh, encoding, context);
}

constexpr std::array kFormats{
    FileFormat{"stl", PROVEOUT_TEXT("Core", "STL, binary"), kStlExtensions,
               PROVEOUT_TEXT("Core", "a closed triangle mesh of the stock"),
               MeshFormat{readStl, writeStlAs<StlEncoding::binary>}},
    FileFormat{"stl-ascii", PROVEOUT_TEXT("Core", "STL, ASCII"), kStlExtensions,
               PROVEOUT_TEXT("Core", "a closed triangle mesh of the stock"),
               MeshFormat{readStl, writeStlAs<StlEncoding::ascii>}},
    FileFormat{"npy", PROVEOUT_TEXT("Core", "NumPy array"), kNpyExtensions,
               PROVEOUT_TEXT("Core", "the heights of a z-map, row 0 at the smallest y"),
               HeightsFormat{readNpy, writeNpy}},
    FileFormat{"job", PROVEOUT_TEXT("Core", "Proveout job"), kJobExtensions,
               PROVEOUT_TEXT("Core", "a program with its stock, tools and parameters"),
               JobFormat{readJob, writeJob}},
};

} // namespace

bool FileFormat::reads() const {
    return std::visit([](const auto& handler) { return handler.read != nullptr; }, handlers);
}

bool FileFormat::writes() const {
    return std::visit([](const auto& handler) { return handler.write != nullptr; }, handlers);
}

std::span<const FileFormat> fileFormats() {
    return kFormats;
}

const FileFormat* findFormat(std::string_view key) {
    const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                    [key](const FileFormat& row) { return row.key == key; });
    return found == kFormats.end() ? nullptr : &*found;
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
// The table of file formats: one row per format, with its reader and writer. Command line, dialogs and tests
// read it; adding a format takes one row and its functions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/decimation/solid/solid.h"
#include "core/formats/job_file.h"
#include "core/formats/mesh_files.h"
#include "core/formats/npy.h"
#include "core/formats/stl.h"
#include "core/formats/stock_file.h"
#include "core/zmap/stock.h"

namespace proveout {

/// A null function means that the format cannot be read, or cannot be written.
struct MeshFormat {
    Result<TriangleMesh> (*read)(const std::filesystem::path& file);
    Result<WrittenFile> (*write)(const std::filesystem::path& file, const TriangleMesh& mesh,
                                 const WorkContext& context);
    CoordinateType coordinates; ///< the type of the coordinates in a written file
    std::uint64_t leastBytes;   ///< per written triangle, with its share of the vertices
};
struct HeightsFormat {
    Result<NpyArray> (*read)(const std::filesystem::path& file);
    Result<void> (*write)(const std::filesystem::path& file, const NpyArray& heights);
};
struct JobFormat {
    Result<Job> (*read)(const std::filesystem::path& file);
    Result<void> (*write)(const std::filesystem::path& file, const Job& job);
};

struct StockFormat {
    Result<SavedStockFile> (*read)(const std::filesystem::path& file);
    Result<void> (*write)(const std::filesystem::path& file, const ZMapSnapshot& zmap, double spacing,
                          const StockProvenance& provenance);
};

struct FileFormat {
    const char* key;                         ///< on the command line, e.g. "stl"
    const char* label;                       ///< for the user interface; marked with PROVEOUT_TEXT
    std::span<const char* const> extensions; ///< with the dot, lower case; the first is the default
    const char* holds;                       ///< for the user interface; marked with PROVEOUT_TEXT
    std::variant<MeshFormat, HeightsFormat, JobFormat, StockFormat> handlers;

    [[nodiscard]] bool reads() const;
    [[nodiscard]] bool writes() const;
    /// Its handler if it is a mesh format that can be written, else null.
    [[nodiscard]] const MeshFormat* meshWriter() const;
};

/// Size in bytes of a file with all triangles of the top of a z-map, forecast before it is made; the size of
/// a stock that is cut through may be smaller.
[[nodiscard]] std::uint64_t fullMeshBytes(const MeshFormat& format, const Grid& grid);

/// "float32" or "float64".
[[nodiscard]] const char* nameOf(CoordinateType type);

[[nodiscard]] std::span<const FileFormat> fileFormats();

/// The row with this key, or null.
[[nodiscard]] const FileFormat* findFormat(std::string_view key);

/// The extensions of the mesh formats that can be written, each once: ".stl .obj …".
[[nodiscard]] std::string meshEndings();
/// The same for those formats that hold coordinates in double precision.
[[nodiscard]] std::string exactMeshEndings();

/// The first row that writes meshes into files with the extension of this one; case is ignored. Error: there
/// is no such row (id "export-format-unknown").
[[nodiscard]] Result<const FileFormat*> meshFormatOf(const std::filesystem::path& file);

} // namespace proveout

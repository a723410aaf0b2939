// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/decimation/solid/solid.h"
#include "core/formats/mesh_defects.h"
#include "core/formats/mesh_files.h"

namespace proveout {

enum class StlEncoding : std::uint8_t { binary, ascii };

/// Writes a mesh atomically; a stopped context leaves no file behind (id "cancelled"). Coordinates are
/// rounded to float32; normals are computed in double before that. Numbers have a decimal point in any
/// locale. Errors: an empty mesh (id "nothing-left"), coordinates that are not finite or beyond float32 (id
/// "stl-coordinate"), a mesh so far from the origin that the rounding reduces a triangle's area to zero,
/// turns it over, or merges two vertices (id "stl-too-coarse"), a file that cannot be written.
[[nodiscard]] Result<WrittenFile> writeStl(const std::filesystem::path& file, const TriangleMesh& mesh,
                                           StlEncoding encoding, const WorkContext& context = {});

/// The contents of an STL file and the problems found in it.
struct StlContents {
    TriangleMesh mesh; ///< vertices with equal float32 coordinates are merged; degenerate facets are skipped
    StlEncoding encoding = StlEncoding::binary;
    std::size_t facets = 0;         ///< number of facets read, including skipped ones
    std::size_t notFinite = 0;      ///< facets skipped because a coordinate is not a number
    std::size_t degenerate = 0;     ///< facets skipped because they have no area in float32
    std::size_t opposedNormals = 0; ///< facets whose stored normal contradicts their winding; the winding
                                    ///< counts
    MeshDefects defects;            ///< of `mesh`
    Diagnostics warnings;           ///< the counts above and other suspicious properties, as sentences
};

/// Reads binary or ASCII STL. A file whose size fits its count is binary, regardless of its header; otherwise
/// it is ASCII if it begins with "solid" and has facets; lines may end in CR, and the whole file may be one
/// line. More bytes than announced are a warning; a truncated file is an error with the offset or line where
/// it ends. Errors: unreadable, not STL, no facets, syntax.
[[nodiscard]] Result<StlContents> readStlContents(const std::filesystem::path& file);

/// Reads only the mesh.
[[nodiscard]] Result<TriangleMesh> readStl(const std::filesystem::path& file);

} // namespace proveout

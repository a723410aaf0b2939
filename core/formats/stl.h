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
/// rounded to float32; normals are computed in double before that. Numbers have a decimal point whatever the
/// locale. Errors: an empty mesh (id "nothing-left"), coordinates that are not finite
/// or beyond float32 (id "stl-coordinate"), a mesh so far from the origin that the rounding takes a triangle
/// its area, turns it over, or makes two vertices one (id "stl-too-coarse"), a file that cannot be written.
[[nodiscard]] Result<WrittenFile> writeStl(const std::filesystem::path& file, const TriangleMesh& mesh,
                                           StlEncoding encoding, const WorkContext& context = {});

/// What an STL file holds and what was wrong with it.
struct StlContents {
    TriangleMesh mesh; ///< vertices with equal float32 coordinates are one; degenerate facets are left out
    StlEncoding encoding = StlEncoding::binary;
    std::size_t facets = 0;         ///< read, with those left out
    std::size_t notFinite = 0;      ///< facets left out because a coordinate is no number
    std::size_t degenerate = 0;     ///< facets left out because they have no area in float32
    std::size_t opposedNormals = 0; ///< facets whose stored normal contradicts their winding; winding wins
    MeshDefects defects;            ///< of `mesh`
    Diagnostics warnings;           ///< the counts above and what else looks wrong, as sentences
};

/// Reads binary or ASCII STL. A file whose size fits its count is binary, whatever its header says; else it
/// is ASCII if it begins with "solid" and has facets; lines may end in CR, and all of it may be one line.
/// More bytes than announced are a warning; a file cut off is an error with the offset or line where it ends.
/// Errors: unreadable, not STL at all, no facets, syntax.
[[nodiscard]] Result<StlContents> readStlContents(const std::filesystem::path& file);

/// The mesh alone.
[[nodiscard]] Result<TriangleMesh> readStl(const std::filesystem::path& file);

} // namespace proveout

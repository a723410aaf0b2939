// SPDX-License-Identifier: GPL-3.0-or-later
// Writes mesh files.
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/decimation/solid/solid.h"

namespace proveout {

struct WrittenFile {
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;
};

// For all writers but GLB: coordinates are in mm and read back as the same double. For all: vertices and
// triangles are in the order of the mesh, with shared indices, so that readers need not weld. Files are
// written atomically and in batches: memory does not grow with the mesh, and a stopped context leaves no file
// behind (id "cancelled"). Any thread. Equal meshes give equal bytes. Errors: an empty mesh (id
// "nothing-left"), coordinates that are not finite (id "mesh-coordinate"), a file that cannot be written (id
// "file-unwritable").

/// Wavefront OBJ: `v` and `f` lines with the shortest decimals that read back as the same numbers.
[[nodiscard]] Result<WrittenFile> writeObj(const std::filesystem::path& file, const TriangleMesh& mesh,
                                           const WorkContext& context = {});

/// Stanford PLY, binary, little-endian.
[[nodiscard]] Result<WrittenFile> writePly(const std::filesystem::path& file, const TriangleMesh& mesh,
                                           const WorkContext& context = {});

/// 3MF: a ZIP archive with the model as XML, one object, unit millimetre (3MF core specification 1.3).
[[nodiscard]] Result<WrittenFile> write3mf(const std::filesystem::path& file, const TriangleMesh& mesh,
                                           const WorkContext& context = {});

/// GLB: glTF 2.0 in one binary file, for browsers and viewers. Program coordinates in mm, in single
/// precision, below a node that turns Z upwards to Y and scales to metres; facets are shaded flat. Errors,
/// also: beyond the range of single precision (id "stl-coordinate"), 4 GiB or more (id "glb-too-large").
[[nodiscard]] Result<WrittenFile> writeGlb(const std::filesystem::path& file, const TriangleMesh& mesh,
                                           const WorkContext& context = {});

} // namespace proveout

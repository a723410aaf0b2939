// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/decimation/surface.h"
#include "ui/gl/gl_functions.h"

namespace proveout {

/// The outside walls of the stock and its underside, as indices into the lattice (index + number of points:
/// the point on the floor). Walls hang from the same border polylines as the surface, so that nothing shows
/// between them. Order of the faces: kSides, then the underside.
struct WallMesh {
    static constexpr std::size_t kFaces = 5;
    static constexpr std::size_t kUnderside = 4;
    std::array<std::vector<std::uint32_t>, kFaces> faces;
};
[[nodiscard]] WallMesh wallMesh(const SurfaceSnapshot& surface);

/// The same on the graphics side; written again when a border line at the edge of the map is another one.
/// All methods need the same context to be current.
class WallBuffer {
public:
    /// Returns how many indices went up.
    [[nodiscard]] std::size_t update(Gl& gl, const SurfaceSnapshot& surface);
    void draw(Gl& gl, std::size_t face);
    void release(Gl& gl);

private:
    RegionGrid m_grid;
    std::vector<BorderLinePtr> m_lines;
    GLuint m_buffer = 0;
    std::array<std::size_t, WallMesh::kFaces + 1> m_first{};
};

} // namespace proveout

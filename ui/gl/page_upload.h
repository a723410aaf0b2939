// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "ui/gl/gl_functions.h"
#include "ui/gl/height_pages.h"

namespace proveout {

/// While it exists, uploads read rows of tiles, one float per point. The context must be current.
class TileRows {
public:
    explicit TileRows(Gl& gl);
    ~TileRows();
    TileRows(const TileRows&) = delete;
    TileRows& operator=(const TileRows&) = delete;

    /// Uploads the values of a tile to the pages that hold any of its points `rect`, layers of the bound
    /// GL_TEXTURE_2D_ARRAY. Returns the number of points uploaded.
    std::size_t upload(const HeightPages& pages, const Grid& grid, const IndexRect& rect,
                       const float* values);

private:
    Gl& m_gl;
};

} // namespace proveout

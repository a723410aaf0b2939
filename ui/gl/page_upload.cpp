// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/page_upload.h"

#include "core/zmap/zmap.h"

namespace proveout {

TileRows::TileRows(Gl& gl) : m_gl(gl) {
    m_gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, Tile::kSize);
}

TileRows::~TileRows() {
    m_gl.glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    m_gl.glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    m_gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

std::size_t TileRows::upload(const HeightPages& pages, const Grid& grid, const IndexRect& rect,
                             const float* values) {
    const IndexRect holding = pages.pagesAt(rect);
    std::size_t points = 0;
    for (int row = holding.j0; row < holding.j1; ++row)
        for (int column = holding.i0; column < holding.i1; ++column) {
            const IndexRect part = intersection(rect, pages.held(column, row, grid));
            m_gl.glPixelStorei(GL_UNPACK_SKIP_PIXELS, part.i0 - rect.i0);
            m_gl.glPixelStorei(GL_UNPACK_SKIP_ROWS, part.j0 - rect.j0);
            m_gl.glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, part.i0 - column * pages.points.x + pages.margin,
                                 part.j0 - row * pages.points.y + pages.margin, row * pages.columns + column,
                                 part.width(), part.height(), 1, GL_RED, GL_FLOAT, values);
            points += static_cast<std::size_t>(part.width()) * static_cast<std::size_t>(part.height());
        }
    return points;
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/height_texture.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "ui/gl/page_upload.h"

namespace proveout {

namespace {

/// The index of a point on the floor, which comes after all of the surface, is a signed number in the shader.
constexpr std::int64_t kMostPoints = std::int64_t{1} << 30;

} // namespace

HeightPages HeightTexture::pagesOf(Gl& gl, const Grid& grid) const {
    GLint limit = 0;
    gl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    return HeightPages::of(grid, std::min<int>(limit, m_mostPoints));
}

std::size_t HeightTexture::bytesOf(Gl& gl, const Grid& grid) const {
    return pagesOf(gl, grid).bytes();
}

bool HeightTexture::isCounted(const Grid& grid) {
    return static_cast<std::int64_t>(grid.nx) * grid.ny <= kMostPoints;
}

bool HeightTexture::fits(Gl& gl, const Grid& grid) const {
    GLint limit = 0;
    gl.glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &limit);
    return isCounted(grid) && pagesOf(gl, grid).count() <= limit && !(m_refused == grid);
}

HeightTexture::Uploaded HeightTexture::refuse(Gl& gl) {
    m_refused = m_grid;
    release(gl);
    Uploaded uploaded;
    uploaded.fits = false;
    return uploaded;
}

bool HeightTexture::restart(Gl& gl, const ZMapSnapshot& moment) {
    m_grid = moment.grid();
    m_pages = pagesOf(gl, m_grid);
    m_floor = moment.floor();
    m_tiles.reset(moment.tileCount());
    // The vertex shader fetches single points; shading interpolates between them.
    bindTexture(gl, GL_TEXTURE_2D_ARRAY, m_texture, GL_LINEAR);
    // After the parameters are set, because a driver allocates the mipmap levels that they require.
    forgetErrors(gl);
    gl.glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R32F, m_pages.texels().x, m_pages.texels().y, m_pages.count(),
                    0, GL_RED, GL_FLOAT, nullptr);
    m_untried = true;
    if (gl.glGetError() != GL_NO_ERROR)
        return false;
    clearOutside(gl);
    return true;
}

void HeightTexture::clearOutside(Gl& gl) {
    const glm::ivec2 texels = m_pages.texels();
    std::vector<float> zeros;
    const auto clear = [&](int layer, const IndexRect& part) {
        if (part.empty())
            return;
        zeros.resize(std::max(zeros.size(), static_cast<std::size_t>(part.width()) *
                                                static_cast<std::size_t>(part.height())));
        gl.glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, part.i0, part.j0, layer, part.width(), part.height(), 1,
                           GL_RED, GL_FLOAT, zeros.data());
    };
    for (int row = 0; row < m_pages.rows; ++row)
        for (int column = 0; column < m_pages.columns; ++column) {
            const IndexRect held = m_pages.held(column, row, m_grid);
            const int i = column * m_pages.points.x - m_pages.margin;
            const int j = row * m_pages.points.y - m_pages.margin;
            const int layer = row * m_pages.columns + column;
            clear(layer, {0, 0, held.i0 - i, texels.y});
            clear(layer, {held.i1 - i, 0, texels.x, texels.y});
            clear(layer, {0, 0, texels.x, held.j0 - j});
            clear(layer, {0, held.j1 - j, texels.x, texels.y});
        }
}

HeightTexture::Uploaded HeightTexture::update(Gl& gl, const ZMapSnapshot& moment,
                                              const UploadBudget& budget) {
    Uploaded uploaded;
    if (m_texture == 0 || !(moment.grid() == m_grid) || moment.floor() != m_floor) {
        if (!restart(gl, moment))
            return refuse(gl);
    } else {
        gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_texture);
    }
    TileRows rows(gl);
    for (std::size_t index = 0; index < moment.tileCount() && uploaded.whole; ++index) {
        if (moment.tile(index) == m_tiles.tile(index))
            continue;
        uploaded.bytes += sizeof(float) * rows.upload(m_pages, m_grid, moment.tileRect(index),
                                                      moment.tile(index)->heights.data());
        m_tiles.set(index, moment);
        ++uploaded.tiles;
        uploaded.whole = !budget.spent();
    }
    if (uploaded.tiles > 0 && std::exchange(m_untried, false) && gl.glGetError() == GL_OUT_OF_MEMORY)
        return refuse(gl);
    return uploaded;
}

void HeightTexture::release(Gl& gl) {
    if (m_texture != 0)
        gl.glDeleteTextures(1, &m_texture);
    m_texture = 0;
    m_tiles.reset(0);
}

} // namespace proveout

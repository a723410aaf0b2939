// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/height_texture.h"

#include <algorithm>

namespace proveout {

bool HeightTexture::fits(Gl& gl, const Grid& grid) {
    GLint limit = 0;
    gl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    return grid.nx <= limit && grid.ny <= limit;
}

void HeightTexture::restart(Gl& gl, const ZMapSnapshot& moment) {
    m_grid = moment.grid();
    m_floor = moment.floor();
    m_tiles.assign(moment.tileCount(), nullptr);
    m_onFloor.assign(moment.tileCount(), false);
    m_tilesOnFloor = 0;
    if (m_texture == 0)
        gl.glGenTextures(1, &m_texture);
    gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    // The vertex shader fetches single points; shading interpolates between them.
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    // After the parameters are set, because a driver allocates the mipmap levels that they require.
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, m_grid.nx, m_grid.ny, 0, GL_RED, GL_FLOAT, nullptr);
}

std::size_t HeightTexture::upload(Gl& gl, const ZMapSnapshot& moment, std::size_t index) {
    const IndexRect rect = moment.tileRect(index);
    const Tile& tile = *moment.tile(index);
    gl.glTexSubImage2D(GL_TEXTURE_2D, 0, rect.i0, rect.j0, rect.width(), rect.height(), GL_RED, GL_FLOAT,
                       tile.heights.data());
    float lowest = 0;
    for (int j = 0; j < rect.height(); ++j) {
        const float* row = tile.heights.data() + static_cast<std::ptrdiff_t>(j) * Tile::kSize;
        lowest = std::min(lowest, *std::min_element(row, row + rect.width()));
    }
    const bool onFloor = lowest <= moment.floor();
    if (onFloor != m_onFloor[index])
        m_tilesOnFloor = onFloor ? m_tilesOnFloor + 1 : m_tilesOnFloor - 1;
    m_onFloor[index] = onFloor;
    return sizeof(float) * static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height());
}

HeightTexture::Uploaded HeightTexture::update(Gl& gl, const ZMapSnapshot& moment,
                                              const UploadBudget& budget) {
    if (m_texture == 0 || !(moment.grid() == m_grid) || moment.floor() != m_floor)
        restart(gl, moment);
    else
        gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    Uploaded uploaded;
    gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, Tile::kSize);
    for (std::size_t index = 0; index < moment.tileCount() && uploaded.whole; ++index) {
        if (moment.tile(index) == m_tiles[index])
            continue;
        uploaded.bytes += upload(gl, moment, index);
        ++uploaded.tiles;
        m_tiles[index] = moment.tile(index);
        uploaded.whole = !budget.spent();
    }
    gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    return uploaded;
}

void HeightTexture::release(Gl& gl) {
    if (m_texture != 0)
        gl.glDeleteTextures(1, &m_texture);
    m_texture = 0;
    m_tiles.clear();
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/wall_offsets.h"

#include <algorithm>
#include <utility>

namespace proveout {

namespace {

constexpr std::int32_t kNoPlace = -1;
constexpr int kAcross = 8; ///< tiles along a side of a layer, as in walls.glsl
constexpr int kPerLayer = kAcross * kAcross;
constexpr int kSide = kAcross * Tile::kSize;
constexpr std::size_t kBytesOfPoint = 8; ///< four halves
/// Differences of heights across a wall reach so many points.
constexpr int kNear = 2;
constexpr int kPlacesUnit = 4;
constexpr int kOffsetsUnit = 5;

/// Of one point, as the shader reads it.
struct Offset {
    float dx = 0;
    float dy = 0;
    float dz = 0;
    float near = 0; ///< 1: normals and shade are not those of differences between points
};

void markNear(std::vector<Offset>& offsets, int i, int j) {
    for (int y = std::max(j - kNear, 0); y <= std::min(j + kNear, Tile::kSize - 1); ++y)
        for (int x = std::max(i - kNear, 0); x <= std::min(i + kNear, Tile::kSize - 1); ++x)
            offsets[static_cast<std::size_t>(y * Tile::kSize + x)].near = 1;
}

} // namespace

WallOffsets::Around WallOffsets::around(const ZMapSnapshot& moment, std::size_t tile) {
    Around tiles;
    const int column = static_cast<int>(tile) % moment.tilesX();
    const int row = static_cast<int>(tile) / moment.tilesX();
    for (int k = 0; k < 9; ++k) {
        const int x = column + k % 3 - 1;
        const int y = row + k / 3 - 1;
        if (x >= 0 && y >= 0 && x < moment.tilesX() && y < moment.tilesY())
            tiles[static_cast<std::size_t>(k)] =
                moment.walls().tile(static_cast<std::size_t>(y * moment.tilesX() + x));
    }
    return tiles;
}

void WallOffsets::restart(Gl& gl, const ZMapSnapshot& moment) {
    m_grid = moment.grid();
    m_uploaded.assign(moment.tileCount(), {});
    m_placeOf.assign(moment.tileCount(), kNoPlace);
    m_used = 0;
    bindTexture(gl, GL_TEXTURE_2D, m_places, GL_NEAREST);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_R32I, moment.tilesX(), moment.tilesY(), 0, GL_RED_INTEGER, GL_INT,
                    m_placeOf.data());
}

/// Whatever was uploaded is lost where the texture grows.
bool WallOffsets::makeRoom(Gl& gl, std::size_t places) {
    const int needed = static_cast<int>((places + kPerLayer - 1) / kPerLayer);
    if (needed <= m_layers)
        return true;
    GLint most = 0;
    gl.glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    m_layers = std::max(needed, std::min(2 * m_layers, static_cast<int>(most)));
    if (m_layers > most)
        return false;
    bindTexture(gl, GL_TEXTURE_2D_ARRAY, m_offsets, GL_NEAREST);
    forgetErrors(gl);
    gl.glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16F, kSide, kSide, m_layers, 0, GL_RGBA, GL_FLOAT,
                    nullptr);
    for (Around& uploaded : m_uploaded)
        uploaded = {};
    return gl.glGetError() == GL_NO_ERROR;
}

std::size_t WallOffsets::upload(Gl& gl, const ZMapSnapshot& moment, std::size_t tile) {
    const IndexRect rect = moment.tileRect(tile);
    std::vector<Offset> offsets(std::size_t{Tile::kSize} * Tile::kSize);
    for (std::size_t k = 0; k < m_uploaded[tile].size(); ++k) {
        const auto& walls = m_uploaded[tile][k];
        if (!walls)
            continue;
        const int column = (static_cast<int>(k) % 3 - 1) * Tile::kSize;
        const int row = (static_cast<int>(k) / 3 - 1) * Tile::kSize;
        for (const WallPoint& wall : walls->points) {
            const int i = column + wall.point % Tile::kSize;
            const int j = row + wall.point / Tile::kSize;
            if (wall.dx != 0 || wall.dy != 0) // else it stays between two walls, or on a slope
                markNear(offsets, i, j);
            if (column != 0 || row != 0)
                continue;
            Offset& offset = offsets[wall.point];
            offset = {wall.dx, wall.dy, wall.z - moment.height(rect.i0 + i, rect.j0 + j), 1};
        }
    }
    const int place = m_placeOf[tile];
    gl.glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, place % kAcross * Tile::kSize,
                       place / kAcross % kAcross * Tile::kSize, place / kPerLayer, Tile::kSize, Tile::kSize,
                       1, GL_RGBA, GL_FLOAT, offsets.data());
    return kBytesOfPoint * offsets.size();
}

std::size_t WallOffsets::update(Gl& gl, const ZMapSnapshot& moment) {
    m_shown = !moment.walls().empty();
    if (!m_shown)
        return 0; // what was uploaded is kept: while a program is played there are none
    if (m_places == 0 || !(moment.grid() == m_grid))
        restart(gl, moment);
    std::vector<std::size_t> changed;
    for (std::size_t tile = 0; tile < moment.tileCount(); ++tile) {
        Around now = around(moment, tile);
        if (now == m_uploaded[tile])
            continue;
        const bool has = std::ranges::any_of(now, [](const auto& walls) { return walls != nullptr; });
        if (has && m_placeOf[tile] == kNoPlace) {
            m_placeOf[tile] = static_cast<std::int32_t>(m_used++);
            m_placesDue = true;
        }
        m_uploaded[tile] = std::move(now);
        if (m_placeOf[tile] != kNoPlace)
            changed.push_back(tile);
    }
    const int layersBefore = m_layers;
    m_refused = !makeRoom(gl, m_used);
    if (m_refused)
        return 0;
    if (m_layers != layersBefore)
        return update(gl, moment); // all of them again
    gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_offsets);
    std::size_t sent = 0;
    for (const std::size_t tile : changed)
        sent += upload(gl, moment, tile);
    if (std::exchange(m_placesDue, false)) {
        gl.glBindTexture(GL_TEXTURE_2D, m_places);
        gl.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, moment.tilesX(), moment.tilesY(), GL_RED_INTEGER, GL_INT,
                           m_placeOf.data());
    }
    return sent;
}

void WallOffsets::set(Gl& gl, ShaderProgram& program, bool used) const {
    gl.glActiveTexture(GL_TEXTURE0 + kPlacesUnit);
    gl.glBindTexture(GL_TEXTURE_2D, m_places);
    gl.glActiveTexture(GL_TEXTURE0 + kOffsetsUnit);
    gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_offsets);
    gl.glActiveTexture(GL_TEXTURE0);
    program.set(gl, "wallPlaces", kPlacesUnit);
    program.set(gl, "wallOffsets", kOffsetsUnit);
    program.set(gl, "hasWalls", used && m_shown && !m_refused);
}

void WallOffsets::release(Gl& gl) {
    const std::array textures{m_places, m_offsets};
    gl.glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data()); // ignores zeros
    m_places = m_offsets = 0;
    m_layers = 0;
    m_used = 0;
    m_refused = false;
    m_uploaded.clear();
    m_placeOf.clear();
}

std::size_t WallOffsets::bytes() const {
    return kBytesOfPoint * static_cast<std::size_t>(m_layers) * kSide * kSide;
}

} // namespace proveout

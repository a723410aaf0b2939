// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/wall_offsets.h"

#include <algorithm>
#include <array>
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

/// Calls `work(column, row)` for a tile and its neighbours.
template<class Work>
void forEachAround(const ZMapSnapshot& moment, std::size_t tile, const Work& work) {
    const int column = static_cast<int>(tile) % moment.tilesX();
    const int row = static_cast<int>(tile) / moment.tilesX();
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, moment.tilesY() - 1); ++y)
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, moment.tilesX() - 1); ++x)
            work(x, y);
}

std::size_t indexOf(const ZMapSnapshot& moment, int column, int row) {
    return static_cast<std::size_t>(row * moment.tilesX() + column);
}

void markNear(std::vector<Offset>& offsets, int i, int j) {
    for (int y = std::max(j - kNear, 0); y <= std::min(j + kNear, Tile::kSize - 1); ++y)
        for (int x = std::max(i - kNear, 0); x <= std::min(i + kNear, Tile::kSize - 1); ++x)
            offsets[static_cast<std::size_t>(y * Tile::kSize + x)].near = 1;
}

} // namespace

void WallOffsets::restart(Gl& gl, const ZMapSnapshot& moment) {
    m_grid = moment.grid();
    m_uploaded.assign(moment.tileCount(), {});
    m_placeOf.assign(moment.tileCount(), kNoPlace);
    m_used = 0;
    bindTexture(gl, GL_TEXTURE_2D, m_places, GL_NEAREST);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_R32I, moment.tilesX(), moment.tilesY(), 0, GL_RED_INTEGER, GL_INT,
                    m_placeOf.data());
}

/// False if there is not enough memory. Whatever was uploaded is lost where the texture grows.
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
    m_isWhole = false;
    return gl.glGetError() == GL_NO_ERROR;
}

std::size_t WallOffsets::upload(Gl& gl, const ZMapSnapshot& moment, std::size_t tile) {
    const IndexRect rect = moment.tileRect(tile);
    std::vector<Offset> offsets(std::size_t{Tile::kSize} * Tile::kSize);
    forEachAround(moment, tile, [&](int x, int y) {
        const WallTile* walls = moment.walls().tile(indexOf(moment, x, y));
        if (walls == nullptr)
            return;
        const int column = x * Tile::kSize - rect.i0;
        const int row = y * Tile::kSize - rect.j0;
        for (const WallPoint& wall : walls->points) {
            const int i = column + wall.point % Tile::kSize;
            const int j = row + wall.point / Tile::kSize;
            if (wall.dx != 0 || wall.dy != 0) // else it stays between two walls
                markNear(offsets, i, j);
            if (column != 0 || row != 0)
                continue;
            Offset& offset = offsets[wall.point];
            offset = {wall.dx, wall.dy, wall.z - moment.height(rect.i0 + i, rect.j0 + j), offset.near};
        }
    });
    const int place = m_placeOf[tile];
    gl.glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, place % kAcross * Tile::kSize,
                       place / kAcross % kAcross * Tile::kSize, place / kPerLayer, Tile::kSize, Tile::kSize,
                       1, GL_RGBA, GL_FLOAT, offsets.data());
    return kBytesOfPoint * offsets.size();
}

std::vector<std::size_t> WallOffsets::changedTiles(const ZMapSnapshot& moment) const {
    std::vector<std::size_t> changed;
    for (std::size_t tile = 0; tile < moment.tileCount(); ++tile) {
        const WallTile* walls = moment.walls().tile(tile);
        const Uploaded& uploaded = m_uploaded[tile];
        if (walls == uploaded.walls.get() && (walls == nullptr || moment.tile(tile) == uploaded.heights))
            continue;
        forEachAround(moment, tile, [&](int x, int y) { changed.push_back(indexOf(moment, x, y)); });
    }
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
}

void WallOffsets::givePlaces(const std::vector<std::size_t>& tiles) {
    for (const std::size_t tile : tiles) {
        if (m_placeOf[tile] != kNoPlace)
            continue;
        m_placeOf[tile] = static_cast<std::int32_t>(m_used++);
        m_placesDue = true;
    }
}

std::size_t WallOffsets::update(Gl& gl, const ZMapSnapshot& moment) {
    m_shown = !moment.walls().empty();
    if (!m_shown)
        return 0; // what was uploaded is kept: while a program is played there are none
    if (m_places == 0 || !(moment.grid() == m_grid))
        restart(gl, moment);
    std::vector<std::size_t> changed = changedTiles(moment);
    givePlaces(changed);
    m_isWhole = true;
    m_refused = !makeRoom(gl, m_used);
    if (m_refused)
        return 0;
    if (!m_isWhole) { // the texture is a new one
        changed.clear();
        for (std::size_t tile = 0; tile < m_placeOf.size(); ++tile)
            if (m_placeOf[tile] != kNoPlace)
                changed.push_back(tile);
    }
    gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_offsets);
    std::size_t sent = 0;
    for (const std::size_t tile : changed) {
        sent += upload(gl, moment, tile);
        m_uploaded[tile] = {moment.walls().share(tile), moment.tile(tile)};
    }
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

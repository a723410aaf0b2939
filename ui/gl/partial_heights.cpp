// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/partial_heights.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace proveout {

namespace {

constexpr std::int16_t kNoLayer = -1;
constexpr GLint kUsualAlignment = 4;

} // namespace

void PartialHeights::restart(Gl& gl, const ZMapSnapshot& moment, const GraphicsShares& shares) {
    release(gl);
    m_grid = moment.grid();
    m_floor = moment.floor();
    m_points = CoarsePoints::of(m_grid, shares.coarseStep);
    m_pages = HeightPages::ofSide(m_grid, shares.pagePoints);
    m_vertexBytes = shares.vertices;
    const auto count = static_cast<std::size_t>(m_pages.count());
    m_residency.reset(count, std::min(shares.slotCount, count));
    m_tiles.reset(moment.tileCount());
}

void PartialHeights::makeCoarse(Gl& gl) {
    bindTexture(gl, GL_TEXTURE_2D, m_coarse, GL_LINEAR);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, m_points.count.x, m_points.count.y, 0, GL_RED, GL_FLOAT,
                    nullptr);
}

void PartialHeights::makeLayers(Gl& gl) {
    bindTexture(gl, GL_TEXTURE_2D, m_layers, GL_NEAREST);
    const std::vector<std::int16_t> none(static_cast<std::size_t>(m_pages.count()), kNoLayer);
    gl.glPixelStorei(GL_UNPACK_ALIGNMENT, sizeof(std::int16_t));
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_R16I, m_pages.columns, m_pages.rows, 0, GL_RED_INTEGER, GL_SHORT,
                    none.data());
    gl.glPixelStorei(GL_UNPACK_ALIGNMENT, kUsualAlignment); // QPainter uploads its letters with it
}

void PartialHeights::makePages(Gl& gl) {
    forgetErrors(gl);
    bindTexture(gl, GL_TEXTURE_2D_ARRAY, m_held, GL_LINEAR);
    gl.glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R32F, m_pages.texels().x, m_pages.texels().y,
                    static_cast<GLsizei>(capacity()), 0, GL_RED, GL_FLOAT, nullptr);
    if (gl.glGetError() == GL_NO_ERROR)
        return;
    gl.glDeleteTextures(1, &m_held);
    m_held = 0;
    m_residency.reset(static_cast<std::size_t>(m_pages.count()), 0);
}

bool PartialHeights::make(Gl& gl, const UploadBudget& budget) {
    if (m_made)
        return true;
    forgetErrors(gl);
    const bool first = m_coarse == 0;
    if (first)
        makeCoarse(gl);
    if (!first || !budget.spent()) {
        makeLayers(gl);
        m_vertices.reset(gl, m_vertexBytes);
        m_made = true;
    }
    return gl.glGetError() == GL_NO_ERROR;
}

std::size_t PartialHeights::countChanged(const ZMapSnapshot& moment) const {
    std::size_t changed = 0;
    for (std::size_t tile = 0; tile < moment.tileCount(); ++tile)
        changed += moment.tile(tile) != m_tiles.tile(tile) ? 1 : 0;
    return changed;
}

std::size_t PartialHeights::uploadCoarse(Gl& gl, const ZMapSnapshot& moment, std::size_t tile) {
    const IndexRect rect = moment.tileRect(tile);
    const SampledPoints columns = sampledPoints(rect.i0, rect.i1, m_grid.nx, m_points.step);
    const SampledPoints rows = sampledPoints(rect.j0, rect.j1, m_grid.ny, m_points.step);
    if (columns.points.empty() || rows.points.empty())
        return 0;
    std::vector<float> heights;
    heights.reserve(columns.points.size() * rows.points.size());
    for (const int j : rows.points)
        for (const int i : columns.points)
            heights.push_back(moment.tile(tile)->at(i - rect.i0, j - rect.j0));
    gl.glBindTexture(GL_TEXTURE_2D, m_coarse);
    gl.glTexSubImage2D(GL_TEXTURE_2D, 0, columns.first, rows.first,
                       static_cast<GLsizei>(columns.points.size()), static_cast<GLsizei>(rows.points.size()),
                       GL_RED, GL_FLOAT, heights.data());
    return sizeof(float) * heights.size();
}

std::size_t PartialHeights::uploadPart(Gl& gl, const ZMapSnapshot& moment, std::size_t tile, int page) {
    const int column = page % m_pages.columns;
    const int row = page / m_pages.columns;
    const IndexRect rect = moment.tileRect(tile);
    const IndexRect part = intersection(rect, m_pages.held(column, row, m_grid));
    if (part.empty())
        return 0;
    gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, Tile::kSize);
    gl.glPixelStorei(GL_UNPACK_SKIP_PIXELS, part.i0 - rect.i0);
    gl.glPixelStorei(GL_UNPACK_SKIP_ROWS, part.j0 - rect.j0);
    gl.glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, part.i0 - column * m_pages.points.x + m_pages.margin,
                       part.j0 - row * m_pages.points.y + m_pages.margin, m_residency.slotOf(page),
                       part.width(), part.height(), 1, GL_RED, GL_FLOAT, moment.tile(tile)->heights.data());
    gl.glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    gl.glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    return sizeof(float) * static_cast<std::size_t>(part.width()) * static_cast<std::size_t>(part.height());
}

std::size_t PartialHeights::uploadToPages(Gl& gl, const ZMapSnapshot& moment, std::size_t tile) {
    const IndexRect pages = m_pages.pagesAt(moment.tileRect(tile));
    std::size_t bytes = 0;
    for (int row = pages.j0; row < pages.j1; ++row)
        for (int column = pages.i0; column < pages.i1; ++column)
            if (const int page = row * m_pages.columns + column; holds(page))
                bytes += uploadPart(gl, moment, tile, page);
    return bytes;
}

HeightTexture::Uploaded PartialHeights::update(Gl& gl, const ZMapSnapshot& moment,
                                               const GraphicsShares& shares, const UploadBudget& budget) {
    HeightTexture::Uploaded uploaded;
    if (m_coarse == 0 || !(moment.grid() == m_grid) || moment.floor() != m_floor)
        restart(gl, moment, shares);
    if (!make(gl, budget)) {
        m_refused = m_grid;
        release(gl);
        uploaded.fits = false;
        return uploaded;
    }
    uploaded.whole = m_made;
    m_vertices.tilesChanged(countChanged(moment), moment.tileCount());
    gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_held);
    for (std::size_t tile = 0; tile < moment.tileCount() && uploaded.whole; ++tile) {
        if (moment.tile(tile) == m_tiles.tile(tile))
            continue;
        uploaded.bytes += uploadCoarse(gl, moment, tile) + uploadToPages(gl, moment, tile);
        m_vertices.setTile(moment, tile);
        m_tiles.set(tile, moment);
        ++uploaded.tiles;
        uploaded.whole = !budget.spent();
    }
    return uploaded;
}

void PartialHeights::setLayer(Gl& gl, int page, int layer) {
    const auto value = static_cast<std::int16_t>(layer);
    gl.glBindTexture(GL_TEXTURE_2D, m_layers);
    gl.glTexSubImage2D(GL_TEXTURE_2D, 0, page % m_pages.columns, page / m_pages.columns, 1, 1, GL_RED_INTEGER,
                       GL_SHORT, &value);
}

void PartialHeights::load(Gl& gl, const ZMapSnapshot& moment, const PageResidency::Load& load) {
    if (load.evicted != PageResidency::kNone)
        setLayer(gl, load.evicted, kNoLayer);
    setLayer(gl, load.page, load.slot);
    const int column = load.page % m_pages.columns;
    const int row = load.page / m_pages.columns;
    gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_held);
    const IndexRect held = m_pages.held(column, row, m_grid);
    const glm::ivec2 texels = m_pages.texels();
    // Interpolation beside the map must not meet whatever was in that memory. The margin of a page may reach
    // beyond the map although the page is not at its edge.
    if (held.width() < texels.x || held.height() < texels.y) {
        const std::vector<float> zeros(static_cast<std::size_t>(texels.x) *
                                       static_cast<std::size_t>(texels.y));
        gl.glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, load.slot, texels.x, texels.y, 1, GL_RED, GL_FLOAT,
                           zeros.data());
    }
    const IndexRect tiles = tilesOf(column, row);
    for (int tj = tiles.j0; tj < tiles.j1; ++tj)
        for (int ti = tiles.i0; ti < tiles.i1; ++ti)
            uploadPart(gl, moment, static_cast<std::size_t>(tj * moment.tilesX() + ti), load.page);
}

bool PartialHeights::isAtEdge(int column, int row) const {
    return column == 0 || row == 0 || column + 1 == m_pages.columns || row + 1 == m_pages.rows;
}

IndexRect PartialHeights::tilesOf(int column, int row) const {
    const IndexRect held = m_pages.held(column, row, m_grid);
    return {held.i0 / Tile::kSize, held.j0 / Tile::kSize, (held.i1 - 1) / Tile::kSize + 1,
            (held.j1 - 1) / Tile::kSize + 1};
}

std::vector<PageHeights> PartialHeights::heightsSeen(bool fromBelow) const {
    const int tilesX = (m_grid.nx - 1) / Tile::kSize + 1;
    std::vector<PageHeights> heights;
    for (int row = 0; row < m_pages.rows; ++row)
        for (int column = 0; column < m_pages.columns; ++column) {
            float lowest = 0;
            float highest = m_floor;
            const IndexRect tiles = tilesOf(column, row);
            for (int tj = tiles.j0; tj < tiles.j1; ++tj)
                for (int ti = tiles.i0; ti < tiles.i1; ++ti) {
                    const auto tile = static_cast<std::size_t>(tj * tilesX + ti);
                    lowest = std::min(lowest, m_tiles.lowest(tile));
                    highest = std::max(highest, m_tiles.highest(tile));
                }
            if (fromBelow || isAtEdge(column, row))
                lowest = m_floor;
            heights.push_back(
                {static_cast<double>(lowest) - m_floor, static_cast<double>(highest) - m_floor});
        }
    return heights;
}

bool PartialHeights::hold(Gl& gl, const ZMapSnapshot& moment, std::span<const int> pages,
                          const UploadBudget& budget) {
    if (m_held == 0 && capacity() > 0 && !pages.empty() && !budget.spent())
        makePages(gl);
    m_residency.need(pages);
    while (m_held != 0 && !budget.spent())
        if (const auto next = m_residency.nextLoad())
            load(gl, moment, *next);
        else
            break;
    return std::ranges::all_of(pages, [&](int page) { return holds(page); });
}

void PartialHeights::set(Gl& gl, ShaderProgram& program) const {
    constexpr int kCoarseUnit = 1;
    constexpr int kLayersUnit = 2;
    constexpr int kVerticesUnit = 3;
    gl.glActiveTexture(GL_TEXTURE0 + kCoarseUnit);
    gl.glBindTexture(GL_TEXTURE_2D, m_coarse);
    gl.glActiveTexture(GL_TEXTURE0 + kLayersUnit);
    gl.glBindTexture(GL_TEXTURE_2D, m_layers);
    gl.glActiveTexture(GL_TEXTURE0 + kVerticesUnit);
    gl.glBindTexture(GL_TEXTURE_2D, m_vertices.id());
    gl.glActiveTexture(GL_TEXTURE0);
    gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_held);
    program.set(gl, "heights", 0);
    program.set(gl, "coarse", kCoarseUnit);
    program.set(gl, "pageLayers", kLayersUnit);
    program.set(gl, "vertexHeights", kVerticesUnit);
    program.set(gl, "vertexShift", m_vertices.shift());
    program.set(gl, "coarseStep", m_points.step);
    program.set(gl, "pagePoints", m_pages.points);
    program.set(gl, "pageMargin", m_pages.margin);
}

void PartialHeights::release(Gl& gl) {
    const std::array textures{m_coarse, m_held, m_layers};
    gl.glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data()); // ignores zeros
    m_coarse = m_held = m_layers = 0;
    m_made = false;
    m_vertices.release(gl);
    m_residency.reset(0, 0);
    m_tiles.reset(0);
}

std::size_t PartialHeights::bytes() const {
    if (m_coarse == 0)
        return 0;
    const auto page = sizeof(float) * static_cast<std::size_t>(m_pages.texels().x) *
                      static_cast<std::size_t>(m_pages.texels().y);
    return m_points.bytes() + (m_held == 0 ? 0 : capacity() * page) +
           static_cast<std::size_t>(m_pages.count()) * sizeof(std::int16_t) + m_vertices.bytes();
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/deviation_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/gl/page_upload.h"

namespace proveout {

namespace {

constexpr int kValuesUnit = 6;
constexpr int kSelectionUnit = 7;
/// Half precision is exact to 0.05 %, which no colour shows.
constexpr std::size_t kBytesOfDeviation = 2;
/// For the shader, of points that are not judged: drivers need not keep what is not a number.
constexpr float kPlain = 6e4F;
/// No part is so large; for a half, it is a number.
constexpr float kFarthest = 4e4F;
constexpr std::uint8_t kSelected = 255;

} // namespace

std::size_t DeviationTexture::bytesOf(const HeightPages& pages) {
    return kBytesOfDeviation * static_cast<std::size_t>(pages.points.x) *
           static_cast<std::size_t>(pages.points.y) * static_cast<std::size_t>(pages.count());
}

bool DeviationTexture::restart(Gl& gl, const ZMapSnapshot& moment, const HeightPages& pages) {
    m_grid = moment.grid();
    m_stock = moment.stock();
    m_pages = pages;
    m_pages.margin = 0;
    m_tiles.assign(moment.tileCount(), {});
    m_selected.assign(moment.tileCount(), 0);
    bindTexture(gl, GL_TEXTURE_2D_ARRAY, m_values, GL_NEAREST);
    forgetErrors(gl);
    gl.glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R16F, m_pages.points.x, m_pages.points.y, m_pages.count(), 0,
                    GL_RED, GL_FLOAT, nullptr);
    bindTexture(gl, GL_TEXTURE_2D, m_selection, GL_NEAREST);
    gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, moment.tilesX(), moment.tilesY(), 0, GL_RED, GL_UNSIGNED_BYTE,
                    m_selected.data());
    gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return gl.glGetError() == GL_NO_ERROR;
}

DeviationTexture::Uploaded DeviationTexture::update(Gl& gl, const ZMapSnapshot& moment,
                                                    const Deviation& deviation, const HeightPages& pages,
                                                    const UploadBudget& budget) {
    Uploaded uploaded;
    const bool isOther = m_values == 0 || !(m_grid == moment.grid()) || m_stock != moment.stock();
    if (isOther && !restart(gl, moment, pages)) {
        release(gl);
        uploaded.fits = false;
        return uploaded;
    }
    if (std::exchange(m_part, deviation.sharePart()) != deviation.sharePart())
        m_tiles.assign(m_tiles.size(), {}); // the old values are not of this part
    gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_values);
    TileRows rows(gl);
    DeviationTile values;
    for (std::size_t index = 0; index < m_tiles.size() && uploaded.whole; ++index) {
        const std::shared_ptr<const DeviationTile>& tile = deviation.tile(index);
        OfTile& known = m_tiles[index];
        const std::shared_ptr<const Tile>& heights = moment.tile(index);
        if (heights != deviation.stock().tile(index) || (known.values == tile && known.heights == heights))
            continue;
        known = {tile, heights};
        if (tile == nullptr)
            continue; // it is not selected
        std::ranges::transform(tile->values, values.values.begin(), [](float value) {
            return std::isnan(value) ? kPlain : std::clamp(value, -kFarthest, kFarthest);
        });
        rows.upload(m_pages, m_grid, moment.tileRect(index), values.values.data());
        ++uploaded.tiles;
        uploaded.whole = !budget.spent();
    }
    return uploaded;
}

bool DeviationTexture::select(Gl& gl, const ZMapSnapshot& moment) {
    if (m_values == 0 || !(m_grid == moment.grid()) || m_stock != moment.stock())
        return false;
    bool isAny = false;
    bool isChanged = false;
    for (std::size_t index = 0; index < m_tiles.size(); ++index) {
        const OfTile& tile = m_tiles[index];
        const bool isSelected = tile.values != nullptr && tile.heights == moment.tile(index);
        const std::uint8_t value = isSelected ? kSelected : 0;
        isAny = isAny || isSelected;
        isChanged = std::exchange(m_selected[index], value) != value || isChanged;
    }
    if (isChanged) {
        gl.glBindTexture(GL_TEXTURE_2D, m_selection);
        gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        gl.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, moment.tilesX(), moment.tilesY(), GL_RED, GL_UNSIGNED_BYTE,
                           m_selected.data());
        gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    }
    return isAny;
}

void DeviationTexture::set(Gl& gl, ShaderProgram& program, const DeviationColours& colours,
                           const PartTolerance& tolerance) const {
    gl.glActiveTexture(GL_TEXTURE0 + kValuesUnit);
    gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_values);
    gl.glActiveTexture(GL_TEXTURE0 + kSelectionUnit);
    gl.glBindTexture(GL_TEXTURE_2D, m_selection);
    gl.glActiveTexture(GL_TEXTURE0);
    program.set(gl, "deviations", kValuesUnit);
    program.set(gl, "deviationTiles", kSelectionUnit);
    program.set(gl, "deviationPagePoints", m_pages.points);
    program.set(gl, "deviationPageColumns", m_pages.columns);
    program.set(gl, "allowance", static_cast<float>(tolerance.allowance));
    program.set(gl, "tolerance", glm::vec2(tolerance.below, tolerance.above));
    program.set(gl, "excessAlbedo", colours.excess);
    program.set(gl, "leftAlbedo", colours.left);
    program.set(gl, "exactAlbedo", colours.exact);
    program.set(gl, "missingAlbedo", colours.missing);
    program.set(gl, "gougeAlbedo", colours.gouge);
}

void DeviationTexture::release(Gl& gl) {
    const std::array textures{m_values, m_selection};
    gl.glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data()); // ignores zeros
    m_values = m_selection = 0;
    m_part.reset();
    m_tiles.clear();
    m_selected.clear();
}

} // namespace proveout

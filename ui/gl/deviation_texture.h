// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/part/deviation.h"
#include "core/zmap/zmap.h"
#include "ui/gl/gl_functions.h"
#include "ui/gl/height_pages.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/shader_program.h"
#include "ui/gl/upload_budget.h"

namespace proveout {

/// The deviations of a stock from its part as textures for deviation.glsl: one with a value per point, in the
/// pages of the heights, and one that selects the tiles whose heights are those that were compared. Only
/// tiles that have changed are uploaded. All methods need the same context to be current.
class DeviationTexture {
public:
    DeviationTexture() = default;
    DeviationTexture(const DeviationTexture&) = delete;
    DeviationTexture& operator=(const DeviationTexture&) = delete;

    struct Uploaded {
        std::size_t tiles = 0;
        bool whole = true; ///< whether nothing is left to upload
        bool fits = true;  ///< false: the driver has no memory for it
    };

    /// Uploads those tiles that are of the heights of `moment`, whose stock the deviations must be on. If the
    /// budget is too small, the next call continues.
    Uploaded update(Gl& gl, const ZMapSnapshot& moment, const Deviation& deviation, const HeightPages& pages,
                    const UploadBudget& budget);
    /// Selects the tiles that are uploaded and whose heights `moment` has. Returns whether there are any.
    bool select(Gl& gl, const ZMapSnapshot& moment);
    /// Binds the textures, and sets the uniforms of the bound program.
    void set(Gl& gl, ShaderProgram& program, const DeviationColours& colours,
             const PartTolerance& tolerance) const;
    void release(Gl& gl);

    /// The bytes that a grid with such pages takes.
    [[nodiscard]] static std::size_t bytesOf(const HeightPages& pages);
    [[nodiscard]] std::size_t bytes() const { return m_values == 0 ? 0 : bytesOf(m_pages); } ///< held now

private:
    struct OfTile {
        std::shared_ptr<const DeviationTile> values; ///< null: nothing is uploaded
        std::shared_ptr<const Tile> heights;         ///< that they belong to
    };

    [[nodiscard]] bool restart(Gl& gl, const ZMapSnapshot& moment, const HeightPages& pages);

    GLuint m_values = 0;
    GLuint m_selection = 0;
    HeightPages m_pages; ///< without margins
    Grid m_grid;
    StockBox m_stock;
    std::shared_ptr<const DesignPart> m_part; ///< that the deviations are from
    std::vector<OfTile> m_tiles;
    std::vector<std::uint8_t> m_selected; ///< per tile, as uploaded
};

} // namespace proveout

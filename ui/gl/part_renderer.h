// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "core/part/design_part.h"
#include "ui/gl/scene_light.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/upload_budget.h"

namespace proveout {

/// Draws the design part see-through over the scene: what is before the stock, and, fainter, what is in it.
/// All methods need the same context to be current.
class PartRenderer {
public:
    PartRenderer();
    PartRenderer(const PartRenderer&) = delete;
    PartRenderer& operator=(const PartRenderer&) = delete;

    [[nodiscard]] bool valid() const { return m_program.valid(); }
    /// If the budget is too small, the next call continues. `origin`: that of the stock coordinates. Without
    /// memory for it, it is not drawn.
    void upload(Gl& gl, const std::shared_ptr<const DesignPart>& part, const Vec3& origin,
                const UploadBudget& budget);
    /// Whether a part is not uploaded completely.
    [[nodiscard]] bool isPending() const { return m_part != nullptr && m_fits && !isWhole(); }
    void draw(Gl& gl, const StockView& view, const SceneOptions& options);
    void release(Gl& gl);

private:
    [[nodiscard]] bool isWhole() const {
        return m_vertices == m_part->mesh().vertices.size() && m_triangles == m_part->mesh().triangles.size();
    }
    void restart(Gl& gl);
    void uploadSlice(Gl& gl);

    ShaderProgram m_program;
    std::shared_ptr<const DesignPart> m_part;
    Vec3 m_origin{0};
    GLuint m_array = 0;
    GLuint m_places = 0;
    GLuint m_indices = 0;
    std::size_t m_vertices = 0; ///< uploaded so far
    std::size_t m_triangles = 0;
    bool m_fits = true;
};

} // namespace proveout

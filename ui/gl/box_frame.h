// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/zmap/zmap.h"
#include "ui/gl/path_lines.h"
#include "ui/gl/scene_light.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/vertex_buffer.h"

namespace proveout {

/// Which sides of a detail region are at the edge of the stock, so that there is no stock beyond them.
struct BoxSides {
    bool south = false;
    bool east = false;
    bool north = false;
    bool west = false;
};
[[nodiscard]] BoxSides sidesAtEdge(const Grid& around, const Grid& box);

/// The visible boundary between a detail region and the stock around it. In mm; x and y from the corner of
/// the region, heights from the top of the stock.
struct BoxEdge {
    std::vector<glm::vec3> curtain; ///< triangles that close the step between both surfaces
    std::vector<PathVertex> line;   ///< the upper edge of the step, as separate lines; at the edge of the
                                    ///< stock, that of the detail region
};

/// `slack`: how far the surface that is drawn around the region may deviate from its z-map, mm. There is no
/// edge where both surfaces are on the floor.
[[nodiscard]] BoxEdge boxEdge(const ZMapSnapshot& around, const ZMapSnapshot& box, double slack);

/// Draws the edge of a detail region. All methods need the same context to be current.
class BoxFrame {
public:
    BoxFrame();

    [[nodiscard]] bool valid() const { return m_lines.valid() && m_flat.valid(); }
    void setEdge(Gl& gl, const BoxEdge& edge);
    /// `shift`: position of the region's corner at the top of the stock, in stock coordinates.
    void draw(Gl& gl, const StockView& view, const SceneOptions& options, const glm::vec3& shift);
    void release(Gl& gl);

private:
    ShaderProgram m_lines;
    ShaderProgram m_flat;
    VertexBuffer m_line;
    VertexBuffer m_curtain;
};

} // namespace proveout

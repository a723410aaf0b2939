// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/zmap/zmap.h"
#include "ui/gl/path_lines.h"
#include "ui/gl/scene_light.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/vertex_buffer.h"

namespace proveout {

/// Which sides of a box of interest are at the edge of the stock, so that nothing is beyond them.
struct BoxSides {
    bool south = false;
    bool east = false;
    bool north = false;
    bool west = false;
};
[[nodiscard]] BoxSides sidesAtEdge(const Grid& around, const Grid& box);

/// What stands between a box of interest and the stock round it, in mm from the corner of the box, its
/// heights from the top of the stock.
struct BoxEdge {
    std::vector<glm::vec3> curtain; ///< triangles that close the step between both surfaces
    std::vector<PathVertex> line;   ///< the higher one of them, as separate lines; at the edge of the stock
                                    ///< there is the box alone
};

/// `slack`: how far the surface that is drawn round the box may lie from its z-map, mm. Where both stand on
/// the floor there is no edge.
[[nodiscard]] BoxEdge boxEdge(const ZMapSnapshot& around, const ZMapSnapshot& box, double slack);

/// Draws the edge of a box of interest. All methods need the same context to be current.
class BoxFrame {
public:
    BoxFrame();

    [[nodiscard]] bool valid() const { return m_lines.valid() && m_flat.valid(); }
    void setEdge(Gl& gl, const BoxEdge& edge);
    /// `shift`: of the corner of the box at the top of the stock, in stock coordinates.
    void draw(Gl& gl, const StockView& view, const SceneOptions& options, const glm::vec3& shift);
    void release(Gl& gl);

private:
    ShaderProgram m_lines;
    ShaderProgram m_flat;
    VertexBuffer m_line;
    VertexBuffer m_curtain;
};

} // namespace proveout

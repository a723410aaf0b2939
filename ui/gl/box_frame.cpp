// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/box_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/decimation/regions/canonical_surface.h"

namespace proveout {
namespace {

constexpr float kWidth = 2.2f; // logical pixels
constexpr float kCurtainShade = 0.7f;
/// Heights closer to the floor than this count as on the floor, mm.
constexpr double kOnFloor = 1e-4;
/// Points of both grids that are closer than this count as one, mm.
constexpr double kSamePlace = 1e-6;

struct Post {
    glm::vec2 at;
    float low;
    float high;
    bool onFloor;
};

class Edge {
public:
    Edge(const ZMapSnapshot& around, const ZMapSnapshot& box, double slack)
        : m_around(around), m_surface(around), m_box(box), m_slack(slack) {}

    [[nodiscard]] BoxEdge made() const {
        const int lastI = m_box.grid().nx - 1;
        const int lastJ = m_box.grid().ny - 1;
        const BoxSides atEdge = sidesAtEdge(m_around.grid(), m_box.grid());
        BoxEdge edge;
        // Counter-clockwise order.
        addSide(edge, {0, 0}, {1, 0}, lastI, atEdge.south);
        addSide(edge, {lastI, 0}, {0, 1}, lastJ, atEdge.east);
        addSide(edge, {lastI, lastJ}, {-1, 0}, lastI, atEdge.north);
        addSide(edge, {0, lastJ}, {0, -1}, lastJ, atEdge.west);
        return edge;
    }

private:
    [[nodiscard]] Post post(const glm::ivec2& at, bool alone) const {
        const Grid& grid = m_box.grid();
        const Grid& wide = m_around.grid();
        const glm::vec2 place(grid.hx * at.x, grid.hy * at.y);
        const double fine = double{m_box.height(at.x, at.y)};
        if (alone)
            return {place, static_cast<float>(fine), static_cast<float>(fine), onFloor(fine)};
        const double coarse =
            m_surface.height(std::clamp((grid.x(at.x) - wide.x0) / wide.hx, 0.0, wide.nx - 1.0),
                             std::clamp((grid.y(at.y) - wide.y0) / wide.hy, 0.0, wide.ny - 1.0));
        return {place, static_cast<float>(std::min(fine, coarse) - m_slack),
                static_cast<float>(std::max(fine, coarse) + m_slack), onFloor(std::max(fine, coarse))};
    }

    [[nodiscard]] bool onFloor(double height) const { return height <= double{m_box.floor()} + kOnFloor; }

    void addSide(BoxEdge& edge, const glm::ivec2& from, const glm::ivec2& step, int count, bool alone) const {
        Post last = post(from, alone);
        for (int k = 1; k <= count; ++k) {
            const Post next = post(from + step * k, alone);
            if (!(last.onFloor && next.onFloor))
                add(edge, last, next, alone);
            last = next;
        }
    }

    static void add(BoxEdge& edge, const Post& a, const Post& b, bool alone) {
        const std::array corners{glm::vec3(a.at, a.low), glm::vec3(b.at, b.low),  glm::vec3(b.at, b.high),
                                 glm::vec3(a.at, a.low), glm::vec3(b.at, b.high), glm::vec3(a.at, a.high)};
        if (!alone)
            edge.curtain.insert(edge.curtain.end(), corners.begin(), corners.end());
        edge.line.push_back({glm::vec3(a.at, a.high), 0, 0});
        edge.line.push_back({glm::vec3(b.at, b.high), 0, 0});
    }

    const ZMapSnapshot& m_around;
    const CanonicalSurface m_surface;
    const ZMapSnapshot& m_box;
    double m_slack;
};

} // namespace

BoxSides sidesAtEdge(const Grid& around, const Grid& box) {
    const auto same = [](double a, double b) { return std::abs(a - b) < kSamePlace; };
    return {same(box.y(0), around.y(0)), same(box.x(box.nx - 1), around.x(around.nx - 1)),
            same(box.y(box.ny - 1), around.y(around.ny - 1)), same(box.x(0), around.x(0))};
}

BoxEdge boxEdge(const ZMapSnapshot& around, const ZMapSnapshot& box, double slack) {
    return Edge(around, box, slack).made();
}

BoxFrame::BoxFrame()
    : m_lines({{"line.vert"}, "line.geom", {"line.frag"}, {}}),
      m_flat({{"flat.vert"}, nullptr, {"flat.frag"}, {}}) {}

void BoxFrame::setEdge(Gl& gl, const BoxEdge& edge) {
    m_line.write(gl, edge.line.data(), edge.line.size(), {3, 1, 1});
    m_curtain.write(gl, edge.curtain.data(), edge.curtain.size(), {3});
}

void BoxFrame::draw(Gl& gl, const StockView& view, const SceneOptions& options, const glm::vec3& shift) {
    gl.glDisable(GL_CULL_FACE);
    m_flat.bind(gl);
    setView(gl, m_flat, view);
    m_flat.set(gl, "shift", shift);
    m_flat.set(gl, "flatColour", kCurtainShade * options.colours.box);
    m_curtain.draw(gl, GL_TRIANGLES, 0, m_curtain.size());
    m_lines.bind(gl);
    setView(gl, m_lines, view);
    m_lines.set(gl, "shift", shift);
    m_lines.set(gl, "width", kWidth * view.pixelRatio);
    m_lines.set(gl, "pixelsPerMm", view.pixelsPerMm);
    m_lines.set(gl, "dashes", glm::vec3(0));
    m_lines.set(gl, "colours[0]", glm::vec4(options.colours.box, 1));
    gl.glEnable(GL_BLEND);
    // Keeps the alpha at 1, because the window system blends a QOpenGLWidget by its alpha.
    gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_line.draw(gl, GL_LINES, 0, m_line.size());
    gl.glDisable(GL_BLEND);
    gl.glEnable(GL_CULL_FACE);
}

void BoxFrame::release(Gl& gl) {
    m_line.release(gl);
    m_curtain.release(gl);
}

} // namespace proveout

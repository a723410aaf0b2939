// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cutting/fixtures/fixture.h"
#include "ui/gl/scene_light.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/vertex_buffer.h"

namespace proveout {

/// Draws what holds the stock. All methods need the same context to be current.
class FixtureRenderer {
public:
    FixtureRenderer() : m_program({{"solid.vert"}, nullptr, {"lighting.glsl", "fixture.frag"}, {}}) {}

    [[nodiscard]] bool valid() const { return m_program.valid(); }
    /// `origin`: that of the stock coordinates.
    void setFixtures(Gl& gl, const Fixtures& fixtures, const Vec3& origin);
    void draw(Gl& gl, const StockView& view, const SceneOptions& options);
    void release(Gl& gl);

private:
    ShaderProgram m_program;
    VertexBuffer m_vertices;
    Fixtures m_fixtures;
    Vec3 m_origin{0};
};

} // namespace proveout

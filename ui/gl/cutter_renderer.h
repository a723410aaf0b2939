// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/cutter/cutter.h"
#include "ui/gl/scene_light.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/vertex_buffer.h"

namespace proveout {

/// Draws a cutter to scale. All methods need the same context to be current.
class CutterRenderer {
public:
    CutterRenderer() : m_program({{"solid.vert"}, nullptr, {"lighting.glsl", "cutter.frag"}, {}}) {}

    [[nodiscard]] bool valid() const { return m_program.valid(); }
    /// nullptr: draws no cutter.
    void setCutter(Gl& gl, const Cutter* cutter);
    /// `tip`: position in stock coordinates.
    void draw(Gl& gl, const StockView& view, const SceneOptions& options, const glm::vec3& tip);
    void release(Gl& gl);

private:
    ShaderProgram m_program;
    VertexBuffer m_vertices;
    std::string m_spec;
    float m_radius = 0;
    bool m_present = false;
};

} // namespace proveout

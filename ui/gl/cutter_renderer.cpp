// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/cutter_renderer.h"

#include "ui/gl/cutter_mesh.h"

namespace proveout {

void CutterRenderer::setCutter(Gl& gl, const Cutter* cutter) {
    m_present = cutter != nullptr && cutter->radius() > 0;
    if (!m_present || (m_vertices.size() > 0 && cutter->spec() == m_spec))
        return;
    m_spec = cutter->spec();
    m_radius = static_cast<float>(cutter->radius());
    const std::vector<CutterVertex> vertices = cutterMesh(*cutter);
    m_vertices.write(gl, vertices.data(), vertices.size(), {3, 3, 1});
}

void CutterRenderer::draw(Gl& gl, const StockView& view, const SceneOptions& options, const glm::vec3& tip) {
    if (!m_present || (options.cutter == CutterShown::hidden && !options.contact))
        return;
    const bool seeThrough = options.cutter == CutterShown::seeThrough;
    m_program.bind(gl);
    setView(gl, m_program, view);
    m_program.set(gl, "shift", tip);
    m_program.set(gl, "radius", m_radius);
    m_program.set(gl, "opacity", seeThrough ? 0.45f : 1.0f);
    m_program.set(gl, "fluteAlbedo", options.colours.flute);
    m_program.set(gl, "shankAlbedo", options.colours.shank);
    m_program.set(gl, "holderAlbedo", options.colours.holder);
    const bool hit = options.contact && options.contact->part;
    m_program.set(gl, "hitPart", hit ? static_cast<float>(*options.contact->part) : -1.0f);
    m_program.set(gl, "hitAlbedo", options.colours.hit);
    if (seeThrough) {
        gl.glEnable(GL_BLEND);
        // Keeps the alpha at 1, because the window system blends a QOpenGLWidget by its alpha.
        gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    }
    m_vertices.draw(gl, GL_TRIANGLES, 0, m_vertices.size());
    gl.glDisable(GL_BLEND);
}

void CutterRenderer::release(Gl& gl) {
    m_vertices.release(gl);
}

} // namespace proveout

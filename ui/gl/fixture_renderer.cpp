// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/fixture_renderer.h"

#include <iterator>

#include "ui/gl/fixture_mesh.h"

namespace proveout {

namespace {

constexpr float kNone = -1;

/// The part of the mesh that is drawn as hit.
float hitPart(const Fixtures& fixtures, const SceneOptions& options) {
    if (!options.contact)
        return kNone;
    const auto found = fixtures.find(options.contact->fixture);
    return found == fixtures.end() ? kNone : static_cast<float>(std::distance(fixtures.begin(), found));
}

} // namespace

void FixtureRenderer::setFixtures(Gl& gl, const Fixtures& fixtures, const Vec3& origin) {
    const bool written = m_vertices.size() > 0 || fixtures.empty();
    if (written && fixtures == m_fixtures && origin == m_origin)
        return;
    m_fixtures = fixtures;
    m_origin = origin;
    const std::vector<SolidVertex> vertices = fixtureMesh(fixtures, origin);
    m_vertices.write(gl, vertices.data(), vertices.size(), {3, 3, 1});
}

void FixtureRenderer::draw(Gl& gl, const StockView& view, const SceneOptions& options) {
    if (!options.fixtures || m_fixtures.empty())
        return;
    m_program.bind(gl);
    setView(gl, m_program, view);
    m_program.set(gl, "shift", glm::vec3(0));
    m_program.set(gl, "albedo", options.colours.fixture);
    m_program.set(gl, "hitPart", hitPart(m_fixtures, options));
    m_program.set(gl, "hitAlbedo", options.colours.hit);
    m_vertices.draw(gl, GL_TRIANGLES, 0, m_vertices.size());
}

void FixtureRenderer::release(Gl& gl) {
    m_vertices.release(gl);
}

} // namespace proveout

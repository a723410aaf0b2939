// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/part_renderer.h"

#include <algorithm>
#include <array>
#include <vector>

namespace proveout {

namespace {

/// Vertices or triangles that are uploaded at once.
constexpr std::size_t kSlice = 65'536;
constexpr float kBefore = 0.34F; ///< opacity before the stock …
constexpr float kWithin = 0.16F; ///< … and in it
constexpr float kBehind = 0.10F; ///< of faces that are seen from inside
/// Faces in the surface of the stock are in it.
constexpr float kOffset = 2;

struct Triple {
    float x;
    float y;
    float z;
};

} // namespace

PartRenderer::PartRenderer() : m_program({{"solid.vert"}, nullptr, {"lighting.glsl", "part.frag"}, {}}) {}

void PartRenderer::restart(Gl& gl) {
    const TriangleMesh& mesh = m_part->mesh();
    gl.glGenVertexArrays(1, &m_array);
    gl.glGenBuffers(1, &m_places);
    gl.glGenBuffers(1, &m_indices);
    gl.glBindVertexArray(m_array);
    forgetErrors(gl);
    gl.glBindBuffer(GL_ARRAY_BUFFER, m_places);
    gl.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Triple)), nullptr,
                    GL_STATIC_DRAW);
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices);
    gl.glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                    static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(mesh.triangles[0])), nullptr,
                    GL_STATIC_DRAW);
    gl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Triple), nullptr);
    gl.glEnableVertexAttribArray(0);
    m_fits = gl.glGetError() == GL_NO_ERROR;
}

void PartRenderer::uploadSlice(Gl& gl) {
    const TriangleMesh& mesh = m_part->mesh();
    if (m_vertices < mesh.vertices.size()) {
        std::vector<Triple> places(std::min(kSlice, mesh.vertices.size() - m_vertices));
        std::transform(mesh.vertices.begin() + static_cast<std::ptrdiff_t>(m_vertices),
                       mesh.vertices.begin() + static_cast<std::ptrdiff_t>(m_vertices + places.size()),
                       places.begin(), [this](const Vec3& vertex) {
                           const glm::vec3 place(vertex - m_origin);
                           return Triple{place.x, place.y, place.z};
                       });
        gl.glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(m_vertices * sizeof(Triple)),
                           static_cast<GLsizeiptr>(places.size() * sizeof(Triple)), places.data());
        m_vertices += places.size();
        return;
    }
    const std::size_t count = std::min(kSlice, mesh.triangles.size() - m_triangles);
    constexpr std::size_t kBytes = sizeof(mesh.triangles[0]);
    gl.glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(m_triangles * kBytes),
                       static_cast<GLsizeiptr>(count * kBytes), &mesh.triangles[m_triangles]);
    m_triangles += count;
}

void PartRenderer::upload(Gl& gl, const std::shared_ptr<const DesignPart>& part, const Vec3& origin,
                          const UploadBudget& budget) {
    if (part != m_part || origin != m_origin) {
        release(gl);
        m_part = part;
        m_origin = origin;
        if (part != nullptr)
            restart(gl);
    }
    if (!isPending())
        return;
    gl.glBindVertexArray(m_array);
    gl.glBindBuffer(GL_ARRAY_BUFFER, m_places);
    do
        uploadSlice(gl);
    while (isPending() && !budget.spent());
    gl.glBindVertexArray(0);
    gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void PartRenderer::draw(Gl& gl, const StockView& view, const SceneOptions& options) {
    if (!options.part || m_part == nullptr || !m_fits || !isWhole())
        return;
    m_program.bind(gl);
    setView(gl, m_program, view);
    m_program.set(gl, "shift", glm::vec3(0));
    m_program.set(gl, "albedo", options.colours.part);
    gl.glEnable(GL_BLEND);
    gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    gl.glDepthMask(GL_FALSE);
    gl.glEnable(GL_POLYGON_OFFSET_FILL);
    gl.glPolygonOffset(kOffset, kOffset);
    gl.glBindVertexArray(m_array);
    const auto count = static_cast<GLsizei>(3 * m_triangles);
    struct Pass {
        GLenum depth;
        GLenum culled;
        float opacity;
    };
    for (const Pass& pass : {Pass{GL_GREATER, GL_BACK, kWithin}, Pass{GL_LEQUAL, GL_FRONT, kBehind},
                             Pass{GL_LEQUAL, GL_BACK, kBefore}}) {
        gl.glDepthFunc(pass.depth);
        gl.glCullFace(pass.culled);
        m_program.set(gl, "opacity", pass.opacity);
        gl.glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
    }
    gl.glBindVertexArray(0);
    gl.glDisable(GL_POLYGON_OFFSET_FILL);
    gl.glCullFace(GL_BACK);
    gl.glDepthFunc(GL_LESS);
    gl.glDepthMask(GL_TRUE);
    gl.glDisable(GL_BLEND);
}

void PartRenderer::release(Gl& gl) {
    if (m_array != 0) {
        const std::array buffers{m_places, m_indices};
        gl.glDeleteBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
        gl.glDeleteVertexArrays(1, &m_array);
    }
    m_array = m_places = m_indices = 0;
    m_vertices = m_triangles = 0;
    m_part.reset();
    m_fits = true;
}

} // namespace proveout

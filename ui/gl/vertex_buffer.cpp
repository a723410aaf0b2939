// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/vertex_buffer.h"

#include <numeric>

namespace proveout {

void VertexBuffer::write(Gl& gl, const void* data, std::size_t vertices,
                         std::initializer_list<int> attributes) {
    if (m_buffer == 0) {
        gl.glGenBuffers(1, &m_buffer);
        gl.glGenVertexArrays(1, &m_array);
    }
    const std::size_t floats =
        static_cast<std::size_t>(std::accumulate(attributes.begin(), attributes.end(), 0));
    const std::size_t stride = floats * sizeof(float);
    gl.glBindVertexArray(m_array);
    gl.glBindBuffer(GL_ARRAY_BUFFER, m_buffer);
    gl.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices * stride), data, GL_DYNAMIC_DRAW);
    std::size_t offset = 0;
    GLuint location = 0;
    for (const int count : attributes) {
        gl.glVertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                                 bufferPlace(offset));
        gl.glEnableVertexAttribArray(location++);
        offset += static_cast<std::size_t>(count) * sizeof(float);
    }
    gl.glBindVertexArray(0);
    m_size = vertices;
}

void VertexBuffer::draw(Gl& gl, GLenum mode, std::size_t first, std::size_t count) {
    if (count == 0)
        return;
    gl.glBindVertexArray(m_array);
    gl.glDrawArrays(mode, static_cast<GLint>(first), static_cast<GLsizei>(count));
    gl.glBindVertexArray(0);
}

void VertexBuffer::release(Gl& gl) {
    if (m_buffer != 0) {
        gl.glDeleteBuffers(1, &m_buffer);
        gl.glDeleteVertexArrays(1, &m_array);
    }
    m_buffer = m_array = 0;
    m_size = 0;
}

} // namespace proveout

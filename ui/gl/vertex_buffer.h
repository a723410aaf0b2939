// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <initializer_list>

#include "ui/gl/gl_functions.h"

namespace proveout {

/// A vertex array with one buffer of interleaved floats. Needs the same context to be current.
class VertexBuffer {
public:
    VertexBuffer() = default;
    VertexBuffer(const VertexBuffer&) = delete;
    VertexBuffer& operator=(const VertexBuffer&) = delete;

    /// Replaces the content; `attributes` is the number of floats of each attribute, by location.
    void write(Gl& gl, const void* data, std::size_t vertices, std::initializer_list<int> attributes);
    void draw(Gl& gl, GLenum mode, std::size_t first, std::size_t count);
    void release(Gl& gl);
    [[nodiscard]] std::size_t size() const { return m_size; }

private:
    GLuint m_buffer = 0;
    GLuint m_array = 0;
    std::size_t m_size = 0;
};

} // namespace proveout

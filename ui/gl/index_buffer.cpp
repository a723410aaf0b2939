// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/index_buffer.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace proveout {
namespace {
constexpr std::uint32_t kFirstCapacity = 1u << 16;

GLsizeiptr bytes(std::size_t count) {
    return static_cast<GLsizeiptr>(count * IndexBuffer::kHalf);
}

std::vector<std::uint16_t> halvesOf(std::span<const std::uint32_t> indices, IndexWidth width) {
    std::vector<std::uint16_t> halves;
    if (width == IndexWidth::bits16) {
        halves.reserve(indices.size());
        for (const std::uint32_t index : indices)
            halves.push_back(static_cast<std::uint16_t>(index));
    } else {
        halves.resize(2 * indices.size());
        std::memcpy(halves.data(), indices.data(), indices.size_bytes());
    }
    return halves;
}
} // namespace

void IndexBuffer::reserve(Gl& gl, std::uint32_t count) {
    if (count <= m_capacity)
        return;
    const std::uint32_t capacity = std::max({count, kFirstCapacity, m_capacity + m_capacity / 2});
    GLuint grown = 0;
    gl.glGenBuffers(1, &grown);
    gl.glBindBuffer(GL_COPY_WRITE_BUFFER, grown);
    gl.glBufferData(GL_COPY_WRITE_BUFFER, bytes(capacity), nullptr, GL_DYNAMIC_DRAW);
    if (m_buffer != 0) {
        gl.glBindBuffer(GL_COPY_READ_BUFFER, m_buffer);
        gl.glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, bytes(m_capacity));
        gl.glDeleteBuffers(1, &m_buffer);
    }
    m_buffer = grown;
    m_capacity = capacity;
}

IndexBuffer::Slot IndexBuffer::write(Gl& gl, Slot slot, std::span<const std::uint32_t> indices,
                                     IndexWidth width) {
    const std::vector<std::uint16_t> halves = halvesOf(indices, width);
    const auto count = static_cast<std::uint32_t>(halves.size());
    if (count > slot.capacity) {
        m_slots.free(slot);
        slot = m_slots.allocate(count);
        reserve(gl, m_slots.extent());
    }
    gl.glBindBuffer(GL_COPY_WRITE_BUFFER, m_buffer);
    gl.glBufferSubData(GL_COPY_WRITE_BUFFER, bytes(slot.offset), bytes(halves.size()), halves.data());
    return slot;
}

void IndexBuffer::release(Gl& gl) {
    if (m_buffer != 0)
        gl.glDeleteBuffers(1, &m_buffer);
    m_buffer = 0;
    m_capacity = 0;
    m_slots.clear();
}

} // namespace proveout

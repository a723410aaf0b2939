// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/index_buffer.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace proveout {
namespace {
constexpr std::uint32_t kFirstCapacity = 1u << 16;

GLsizeiptr bytesOf(std::size_t count) {
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

void IndexBuffer::setLimit(std::size_t bytes) {
    m_limit = static_cast<std::uint32_t>(
        std::min<std::size_t>(bytes / kHalf, std::numeric_limits<std::uint32_t>::max()));
}

GLuint IndexBuffer::make(Gl& gl, std::uint32_t capacity) {
    GLuint buffer = 0;
    gl.glGenBuffers(1, &buffer);
    gl.glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
    gl.glBufferData(GL_COPY_WRITE_BUFFER, bytesOf(capacity), nullptr, GL_DYNAMIC_DRAW);
    return buffer;
}

bool IndexBuffer::reserve(Gl& gl, std::uint32_t count) {
    if (count <= m_capacity)
        return true;
    const std::uint32_t room = m_limit > m_capacity ? m_limit - m_capacity : 0;
    const std::uint32_t capacity =
        std::min(std::max({count, kFirstCapacity, m_capacity + m_capacity / 2}), room);
    if (capacity < count)
        return false;
    const GLuint grown = make(gl, capacity);
    if (m_buffer != 0) {
        gl.glBindBuffer(GL_COPY_READ_BUFFER, m_buffer);
        gl.glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, bytesOf(m_capacity));
        gl.glDeleteBuffers(1, &m_buffer);
    }
    m_buffer = grown;
    m_capacity = capacity;
    return true;
}

std::optional<IndexBuffer::Slot> IndexBuffer::write(Gl& gl, Slot slot, std::span<const std::uint32_t> indices,
                                                    IndexWidth width) {
    const std::vector<std::uint16_t> halves = halvesOf(indices, width);
    const auto count = static_cast<std::uint32_t>(halves.size());
    if (count > slot.capacity) {
        m_slots.free(slot);
        slot = m_slots.allocate(count);
        if (!reserve(gl, m_slots.extent()))
            return {};
    }
    gl.glBindBuffer(GL_COPY_WRITE_BUFFER, m_buffer);
    gl.glBufferSubData(GL_COPY_WRITE_BUFFER, bytesOf(slot.offset), bytesOf(halves.size()), halves.data());
    return slot;
}

void IndexBuffer::restart(Gl& gl) {
    release(gl);
    m_buffer = make(gl, m_limit);
    m_capacity = m_limit;
}

void IndexBuffer::release(Gl& gl) {
    if (m_buffer != 0)
        gl.glDeleteBuffers(1, &m_buffer);
    m_buffer = 0;
    m_capacity = 0;
    m_slots.clear();
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "ui/gl/gl_functions.h"
#include "ui/gl/slot_allocator.h"

namespace proveout {

enum class IndexWidth : std::uint8_t { bits16, bits32 };

/// A GPU buffer that stores many index lists; it grows and keeps its content. Offsets are in halves of 32
/// bits, whatever the width of the indices.
/// All methods need the same context to be current.
class IndexBuffer {
public:
    using Slot = SlotAllocator::Slot; ///< offset and capacity in halves
    static constexpr std::size_t kHalf = sizeof(std::uint16_t);

    IndexBuffer() = default;
    IndexBuffer(const IndexBuffer&) = delete;
    IndexBuffer& operator=(const IndexBuffer&) = delete;

    /// Writes a list (not empty) into `slot`, or into a new slot if it does not fit there.
    [[nodiscard]] Slot write(Gl& gl, Slot slot, std::span<const std::uint32_t> indices, IndexWidth width);
    void free(Slot slot) { m_slots.free(slot); }
    void clear() { m_slots.clear(); }
    void release(Gl& gl);

    [[nodiscard]] GLuint id() const { return m_buffer; }

private:
    void reserve(Gl& gl, std::uint32_t count);

    SlotAllocator m_slots;
    GLuint m_buffer = 0;
    std::uint32_t m_capacity = 0;
};

} // namespace proveout

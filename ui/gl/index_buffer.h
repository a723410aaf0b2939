// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
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

    /// It never has more bytes than this, not even while it grows, which takes a copy.
    void setLimit(std::size_t bytes);
    /// Writes a list (not empty) into `slot`, or into a new slot if it does not fit there. Nothing if there
    /// is no room; then restart() and write everything again.
    [[nodiscard]] std::optional<Slot> write(Gl& gl, Slot slot, std::span<const std::uint32_t> indices,
                                            IndexWidth width);
    /// Frees all lists and takes all bytes of the limit, so that it need not grow.
    void restart(Gl& gl);
    void free(Slot slot) { m_slots.free(slot); }
    void clear() { m_slots.clear(); }
    void release(Gl& gl);

    [[nodiscard]] GLuint id() const { return m_buffer; }
    [[nodiscard]] std::size_t bytes() const { return std::size_t{m_capacity} * kHalf; }

private:
    [[nodiscard]] bool reserve(Gl& gl, std::uint32_t count);
    [[nodiscard]] GLuint make(Gl& gl, std::uint32_t capacity);

    SlotAllocator m_slots;
    GLuint m_buffer = 0;
    std::uint32_t m_capacity = 0; ///< in halves
    std::uint32_t m_limit = std::numeric_limits<std::uint32_t>::max();
};

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>

#include "core/base/geometry.h"

namespace proveout {

/// What a control knows about a tool, in mm.
struct ToolOffset {
    Vec3 offset{0}; ///< of its tip; Z is its length
    double diameter = 0;
    bool assumed = false; ///< the diameter was not given; its consequences are not faults of the program

    bool operator==(const ToolOffset&) const = default;
};

/// The offsets of the control by number. If none is given, every tool counts as known with length and
/// diameter 0: programs are then read as if they positioned the cutter's tip.
class ToolOffsets {
public:
    ToolOffsets() = default;
    explicit ToolOffsets(std::map<int, ToolOffset> offsets)
        : m_offsets(std::move(offsets)), m_anyNumber(m_offsets.empty()) {}

    /// Null if the control does not know the number. Number 0 means that there is no tool.
    [[nodiscard]] const ToolOffset* find(int number) {
        static constexpr ToolOffset kNone;
        m_asked = true;
        const auto found = m_offsets.find(number);
        if (found != m_offsets.end())
            return &found->second;
        return m_anyNumber || number == 0 ? &kNone : nullptr;
    }
    /// Whether any tools were given: otherwise their sizes are assumed.
    [[nodiscard]] bool given() const { return !m_anyNumber; }
    /// Whether any tool was looked up: only then do the tools affect the program.
    [[nodiscard]] bool asked() const { return m_asked; }
    void set(int number, const ToolOffset& offset) { m_offsets[number] = offset; }

    bool operator==(const ToolOffsets&) const = default;

private:
    std::map<int, ToolOffset> m_offsets;
    bool m_anyNumber = true;
    bool m_asked = false;
};

} // namespace proveout

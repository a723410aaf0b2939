// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>

#include "core/base/geometry.h"

namespace proveout {

/// What a control knows of a tool, in mm.
struct ToolOffset {
    Vec3 offset{0}; ///< of its tip; Z is its length
    double diameter = 0;
    bool assumed = false; ///< nobody has given the diameter; what it leads to is no fault of the program

    bool operator==(const ToolOffset&) const = default;
};

/// The offsets of the control by number. Where none is given at all, every tool counts as known with length
/// and diameter 0: programs are then read as if the cutter's tip were what they position.
class ToolOffsets {
public:
    ToolOffsets() = default;
    explicit ToolOffsets(std::map<int, ToolOffset> offsets)
        : m_offsets(std::move(offsets)), m_anyNumber(m_offsets.empty()) {}

    /// Nothing where the control does not know the number. Number 0 is no tool.
    [[nodiscard]] const ToolOffset* find(int number) {
        static constexpr ToolOffset kNone;
        m_asked = true;
        const auto found = m_offsets.find(number);
        if (found != m_offsets.end())
            return &found->second;
        return m_anyNumber || number == 0 ? &kNone : nullptr;
    }
    /// Whether any tools were given: without them their sizes are assumed.
    [[nodiscard]] bool given() const { return !m_anyNumber; }
    /// Whether anybody has asked for a tool: only then do they matter to the program.
    [[nodiscard]] bool asked() const { return m_asked; }
    void set(int number, const ToolOffset& offset) { m_offsets[number] = offset; }

    bool operator==(const ToolOffsets&) const = default;

private:
    std::map<int, ToolOffset> m_offsets;
    bool m_anyNumber = true;
    bool m_asked = false;
};

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/geometry.h"

namespace proveout::samples {

enum class Turn : std::uint8_t { clockwise, counterClockwise };

/// Writes an NC program as a post-processor does: words only where they change, three decimals, one motion a
/// block. Positions are absolute program coordinates in mm; they are kept in whole micrometres, so that
/// incremental words (I, J) fit what was written before.
class ProgramWriter {
public:
    void comment(std::string_view text);
    void line(std::string_view text); ///< a block without motion, as it stands
    void setFeed(int mmPerMin) { m_feed = mmPerMin; }

    void rapid(const Vec3& to);
    void feed(const Vec3& to);
    /// An arc or helix in the XY plane about (`centre.x`, `centre.y`); a full circle where `to` is the
    /// current place in x and y.
    void arc(Turn turn, const Vec3& to, const Vec2& centre);

    [[nodiscard]] Vec3 position() const;
    [[nodiscard]] std::size_t blocks() const { return m_blocks; } ///< blocks that move, so far
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    using Micrometres = std::array<long, 3>;

    void move(std::string_view code, const Vec3& to, std::string_view arcWords, int feed);

    std::string m_text;
    std::string m_code;
    Micrometres m_position{};
    bool m_known = false;
    int m_feed = 0;
    int m_writtenFeed = 0;
    std::size_t m_blocks = 0;
};

/// `value` µm as an NC number in mm: at most three decimals, no trailing zeros, always a decimal point.
[[nodiscard]] std::string ncNumber(long micrometres);

} // namespace proveout::samples

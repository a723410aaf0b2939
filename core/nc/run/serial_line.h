// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as a control reads them that gets them over a serial line. Source: grbl 1.1, protocol.c, serial.c.
#pragma once

#include <string>
#include <string_view>

#include "core/nc/program/reporter.h"
#include "core/nc/state/machine_state.h"

namespace proveout {

/// What grbl does with the characters of a line before it reads words.
class SerialLine {
public:
    /// What was told already, so that it is told once. A value.
    struct Reported {
        bool realtime = false;
        bool deleteMark = false;
    };

    explicit SerialLine(std::size_t longest) : m_longest(longest) {}

    /// Puts blanks in the place of characters that are no part of the block, so that columns stay, and tells
    /// them. False where the line holds no block: it is an order to the control or too long, which is told;
    /// what that may have moved is forgotten.
    [[nodiscard]] bool read(std::string_view line, Reported& reported, Reporter& reporter,
                            MachineState& state);
    /// The line as read() left it.
    [[nodiscard]] std::string_view text() const { return m_text; }

private:
    void removeComment(std::size_t at, bool comment, Reported& reported, Reporter& reporter);

    std::size_t m_longest;
    std::string m_text;
};

} // namespace proveout

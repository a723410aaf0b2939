// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as read by a control that receives them over a serial line. Source: grbl 1.1, protocol.c, serial.c.
#pragma once

#include <string>
#include <string_view>

#include "core/nc/program/reporter.h"
#include "core/nc/state/machine_state.h"

namespace proveout {

/// How grbl processes the characters of a line before it reads words.
class SerialLine {
public:
    /// What has been reported already, so that it is reported once. A value.
    struct Reported {
        bool realtime = false;
        bool deleteMark = false;
    };

    explicit SerialLine(std::size_t longest) : m_longest(longest) {}

    /// Replaces characters that are not part of the block by blanks, so that columns stay, and reports them.
    /// False, with a report, if the line has no block: it is a command to the control or too long; positions
    /// that it may have changed become unknown.
    [[nodiscard]] bool read(std::string_view line, Reported& reported, Reporter& reporter,
                            MachineState& state);
    /// The line after read().
    [[nodiscard]] std::string_view text() const { return m_text; }

private:
    void removeComment(std::size_t at, bool comment, Reported& reported, Reporter& reporter);

    std::size_t m_longest;
    std::string m_text;
};

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/serial_line.h"
#include "core/nc/motions/known_axes.h"

#include <algorithm>
#include <fmt/format.h>

#include "core/nc/text/characters.h"

namespace proveout {

namespace {

constexpr std::size_t kLongestCommand = 20;

unsigned char byteOf(char c) {
    return static_cast<unsigned char>(c);
}

/// Resets the control, opens the safety door, or ends a jog.
bool stopsProgram(char c) {
    constexpr unsigned char kReset = 0x18;
    constexpr unsigned char kDoor = 0x84;
    return byteOf(c) == kReset || byteOf(c) == kDoor;
}

/// Status, cycle start, feed hold, and from 0x80 on overrides and switches.
bool isRealtime(char c) {
    const unsigned char b = byteOf(c);
    const bool overrides = (b >= 0x90 && b <= 0x97) || (b >= 0x99 && b <= 0x9e) || b == 0xa0 || b == 0xa1;
    return c == '?' || c == '~' || c == '!' || overrides || b == 0x85 || b == 0x86;
}

/// Commands to the control that move axes or clear offsets.
LetterSet movedBy(std::string_view command) {
    const bool moves = command.starts_with("$H") || command.starts_with("$J") || command.starts_with("$RST");
    return moves ? LetterSet("XYZ") : LetterSet();
}

std::string upper(std::string_view line) {
    std::string text;
    for (const char c : line) {
        if (!isBlank(c))
            text.push_back(upperCase(c));
    }
    return text;
}

} // namespace

void SerialLine::removeComment(std::size_t at, bool comment, Reported& reported, Reporter& reporter) {
    const char c = m_text[at];
    const auto column = static_cast<int>(at + 1);
    const bool printed = byteOf(c) > 0x20 && byteOf(c) < 0x7f;
    const std::string shown =
        printed ? fmt::format("\"{}\"", c) : fmt::format("0x{:02x}", static_cast<unsigned>(byteOf(c)));
    if (stopsProgram(c)) {
        reporter.report(nc_message::kRealtimeReset, column, 1, {shown});
    } else if (isRealtime(c)) {
        if (!reported.realtime)
            reporter.report(nc_message::kRealtimeCharacter, column, 1, {shown});
        reported.realtime = true;
    } else if (c == '/' && !comment) {
        if (!reported.deleteMark)
            reporter.report(nc_message::kDeleteMarkIgnored, column, 1);
        reported.deleteMark = true;
    } else {
        return;
    }
    // In a comment the bytes of a character stay together.
    if (!comment)
        m_text[at] = ' ';
}

bool SerialLine::read(std::string_view line, Reported& reported, Reporter& reporter, MachineState& state) {
    m_text = line;
    const std::size_t begin = skipBlanks(line, 0);
    if (begin < line.size() && line[begin] == '$') {
        const std::string command = upper(line.substr(begin));
        reporter.report(nc_message::kSystemCommand, static_cast<int>(begin + 1),
                        static_cast<int>(line.size() - begin), {command.substr(0, kLongestCommand)});
        forgetAxes(state, movedBy(command));
        return false;
    }
    std::size_t count = 0;
    bool comment = false;
    bool rest = false; // after ";"
    for (std::size_t at = 0; at < m_text.size(); ++at) {
        removeComment(at, comment || rest, reported, reporter);
        const char c = m_text[at];
        rest = rest || (c == ';' && !comment);
        comment = !rest && (comment || c == '(');
        count += !comment && !rest && byteOf(c) > ' ' ? 1 : 0;
        comment = comment && c != ')';
    }
    if (count <= m_longest)
        return true;
    reporter.report(nc_message::kLineDropped, 1, static_cast<int>(line.size()),
                    {std::to_string(count), std::to_string(m_longest)});
    return false;
}

} // namespace proveout

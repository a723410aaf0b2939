// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/samples/program_writer.h"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace proveout::samples {

namespace {

constexpr double kMicrometresPerMm = 1000.0;

long micrometres(double mm) {
    return std::lround(mm * kMicrometresPerMm);
}

} // namespace

std::string ncNumber(long micrometres) {
    const long size = std::labs(micrometres);
    std::string decimals = std::to_string(1000 + size % 1000).substr(1);
    decimals.erase(decimals.find_last_not_of('0') + 1);
    return fmt::format("{}{}.{}", micrometres < 0 ? "-" : "", size / 1000, decimals);
}

void ProgramWriter::comment(std::string_view text) {
    line(fmt::format("({})", text));
}

void ProgramWriter::line(std::string_view text) {
    m_text += text;
    m_text += '\n';
}

void ProgramWriter::rapid(const Vec3& to) {
    move("G0", to, "", 0);
}

void ProgramWriter::feed(const Vec3& to) {
    move("G1", to, "", m_feed);
}

void ProgramWriter::arc(Turn turn, const Vec3& to, const Vec2& centre) {
    const std::string words = fmt::format(" I{} J{}", ncNumber(micrometres(centre.x) - m_position[0]),
                                          ncNumber(micrometres(centre.y) - m_position[1]));
    move(turn == Turn::clockwise ? "G2" : "G3", to, words, m_feed);
}

Vec3 ProgramWriter::position() const {
    return Vec3(m_position[0], m_position[1], m_position[2]) / kMicrometresPerMm;
}

void ProgramWriter::move(std::string_view code, const Vec3& to, std::string_view arcWords, int feed) {
    const Micrometres target{micrometres(to.x), micrometres(to.y), micrometres(to.z)};
    std::string words;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (!m_known || target[axis] != m_position[axis])
            words += fmt::format(" {}{}", "XYZ"[axis], ncNumber(target[axis]));
    if (words.empty() && arcWords.empty())
        return;

    std::string block;
    if (code != m_code)
        block = code;
    block += words;
    block += arcWords;
    if (feed > 0 && feed != m_writtenFeed) {
        block += fmt::format(" F{}", feed);
        m_writtenFeed = feed;
    }
    line(block.front() == ' ' ? std::string_view(block).substr(1) : std::string_view(block));
    m_code = code;
    m_position = target;
    m_known = true;
    ++m_blocks;
}

} // namespace proveout::samples

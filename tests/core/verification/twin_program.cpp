// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/verification/twin_program.h"

#include <fmt/format.h>
#include <regex>

namespace proveout {

namespace {

constexpr double kMmPerInch = 25.4;

} // namespace

TwinProgram::TwinProgram(Writing writing, std::uint_fast32_t seed) : m_writing(writing), m_random(seed) {}

void TwinProgram::line(const std::string& words) {
    faulty(words);
    clean(words);
}

void TwinProgram::faulty(const std::string& words) {
    m_faulty += written(words) + '\n';
    ++m_lines;
}

void TwinProgram::clean(const std::string& words) {
    m_clean += written(words) + '\n';
}

void TwinProgram::dropSpindle() {
    m_faulty = std::regex_replace(m_faulty, std::regex("S[0-9]+ M3"), "(NO SPINDLE)");
}

int TwinProgram::among(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(m_random);
}

std::string TwinProgram::written(const std::string& words) const {
    std::string out;
    for (std::size_t at = 0; at < words.size(); ++at) {
        if (words[at] != '[') {
            out += words[at];
            continue;
        }
        const std::size_t end = words.find(']', at);
        const double mm = std::stod(words.substr(at + 1, end - at - 1));
        // With a point, because a Fanuc control reads a number without one in the least increment.
        out += m_writing.inch ? fmt::format("{:.6f}", mm / kMmPerInch) : fmt::format("{:.4f}", mm);
        at = end;
    }
    return out;
}

} // namespace proveout

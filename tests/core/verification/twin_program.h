// SPDX-License-Identifier: GPL-3.0-or-later
// Writes random programs in pairs: one with a planted fault, and its twin, which is the same without it.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "core/nc/text/dialect.h"

namespace proveout {

/// What a random program is written in. Value type.
struct Writing {
    DialectId dialect = DialectId::linuxcnc;
    bool inch = false;
};

/// The text of both programs. All sizes are given in mm, and written in the unit of the program; owned by one
/// thread.
class TwinProgram {
public:
    TwinProgram(Writing writing, std::uint_fast32_t seed);

    /// A line of both programs, or of one. In `words`, "X[12.5]" is a length in mm and "F[200]" a feed in
    /// mm/min.
    void line(const std::string& words);
    void faulty(const std::string& words);
    void clean(const std::string& words);
    /// The unit of the following lines; the programs state none by that.
    void writeIn(bool inch) { m_writing.inch = inch; }
    /// The next line is the one with the fault.
    void mark() { m_markedLine = m_lines + 1; }

    /// Takes all S words and M3 of the faulty text away.
    void dropSpindle();
    /// Marks a line that many lines before the marked one.
    void markBefore(int lines) { m_markedLine -= lines; }

    /// A whole number, and one of two answers, of equal probability.
    [[nodiscard]] int among(int least, int most);
    [[nodiscard]] bool either() { return among(0, 1) == 1; }

    [[nodiscard]] const Writing& writing() const { return m_writing; }
    [[nodiscard]] const std::string& faultyText() const { return m_faulty; }
    [[nodiscard]] const std::string& cleanText() const { return m_clean; }
    /// Of the fault in the faulty text; 0: none was marked.
    [[nodiscard]] int markedLine() const { return m_markedLine; }

private:
    [[nodiscard]] std::string written(const std::string& words) const;

    Writing m_writing;
    std::mt19937 m_random;
    std::string m_faulty;
    std::string m_clean;
    int m_lines = 0; ///< of the faulty text
    int m_markedLine = 0;
};

} // namespace proveout

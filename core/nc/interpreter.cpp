// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/interpreter.h"

#include <fmt/format.h>

#include "core/nc/execution.h"
#include "core/nc/lexer.h"
#include "core/nc/motion_building.h"

namespace proveout {

namespace {

constexpr std::size_t kLongestLine = 252;   ///< characters that LinuxCNC reads
constexpr std::size_t kLinesPerLook = 1024; ///< lines between two looks at the stop token
constexpr std::size_t kLinesPerTell = 65536;

/// A part of a line for a message; a byte that no font can show appears as its number.
std::string readable(std::string_view text) {
    const bool single = text.size() == 1;
    const auto byte = static_cast<unsigned char>(single ? text.front() : 'x');
    return byte < 0x20 || byte >= 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(text);
}

class Interpreter {
public:
    Interpreter(const NcText& text, const InterpretOptions& options, const WorkContext& context)
        : m_text(text), m_options(options), m_context(context), m_program(std::make_shared<Program>()),
          m_reporter(*m_program, options.file, options.maxDiagnostics) {
        if (options.start || options.assumeStartAtZero) {
            m_state.position = options.start.value_or(Vec3(0));
            m_state.known = kAllAxes;
        }
    }

    std::shared_ptr<const Program> run() {
        const std::size_t count = m_text.lineCount();
        const std::size_t loneCr = m_text.firstLoneCr();
        std::size_t index = 0;
        while (index < count && !m_finished) {
            m_reporter.beginLine(static_cast<std::uint32_t>(index + 1));
            if (index % kLinesPerLook == 0 && m_context.stopped()) {
                m_reporter.tellInAnyCase(nc_message::kStopped, 1, 0);
                m_cutShort = true;
                break;
            }
            if (index % kLinesPerTell == 0)
                m_context.tell(static_cast<double>(index) / static_cast<double>(count));
            if (index == 0 && m_text.hadByteOrderMark())
                m_reporter.tell(nc_message::kByteOrderMark, 1, 0);
            if (index == loneCr)
                m_reporter.tell(nc_message::kLoneCr, static_cast<int>(m_text.line(index).size() + 1), 1);
            runLine(m_text.line(index), index);
            ++index;
        }
        if (index == count)
            m_reporter.beginLine(static_cast<std::uint32_t>(count));
        if (!m_cutShort)
            tellAboutTheWhole(index);
        m_reporter.tellSuppressed();
        m_program->setSourceBlockCount(m_sourceBlocks);
        m_context.tell(1);
        return std::move(m_program);
    }

private:
    void runLine(std::string_view text, std::size_t index) {
        readLine(text, m_line);
        if (m_line.deleteMark && m_options.blockDelete)
            return;
        tellAboutLine(text);
        if (m_line.error) {
            skipUnreadable(text);
            return;
        }
        if (m_line.percent) {
            handlePercent(index);
            return;
        }
        if (m_line.block.empty())
            return;
        ++m_sourceBlocks;
        Execution execution{m_line.block, m_state, *m_program, m_reporter,
                            static_cast<std::uint32_t>(index + 1)};
        executeBlock(execution);
        m_finished = m_state.ended || tooLong();
    }

    void tellAboutLine(std::string_view text) {
        if (text.size() > kLongestLine)
            m_reporter.tell(nc_message::kLineLong, kLongestLine + 1, 1, {std::to_string(text.size())});
        if (m_line.controlCodeColumn > 0 && !m_controlCodeTold) {
            m_controlCodeTold = true;
            m_reporter.tell(nc_message::kControlCode, m_line.controlCodeColumn, 1);
        }
        if (m_line.longBlockNumber.column > 0 && !m_longNumberTold) {
            m_longNumberTold = true;
            m_reporter.tell(nc_message::kBlockNumberLong, m_line.longBlockNumber.column,
                            m_line.longBlockNumber.length);
        }
    }

    /// What the line orders is not known, so the axes that it names may be anywhere afterwards.
    void skipUnreadable(std::string_view text) {
        const ReadError& error = *m_line.error;
        m_reporter.tell(*error.message, error.column, error.length, {readable(error.argument)});
        ++m_sourceBlocks;
        m_state.forget(axisLetters(text));
    }

    /// LinuxCNC runs what is between two "%". One alone is forgiven at the end of the file.
    void handlePercent(std::size_t index) {
        if (!m_percentOpen && m_sourceBlocks == 0) {
            m_percentOpen = true;
        } else if (m_percentOpen) {
            m_percentClosed = true;
            m_finished = true;
        } else if (firstTextFrom(index + 1) == m_text.lineCount()) {
            m_reporter.tell(nc_message::kPercentUnpaired, 1, 1);
            m_percentClosed = true;
            m_finished = true;
        } else {
            m_reporter.tell(nc_message::kPercentInside, 1, 1);
        }
    }

    /// The first line from `index` on that holds anything; the number of lines where there is none.
    [[nodiscard]] std::size_t firstTextFrom(std::size_t index) const {
        while (index < m_text.lineCount() &&
               m_text.line(index).find_first_not_of(" \t\v\f\x1a%") == std::string_view::npos)
            ++index;
        return index;
    }

    bool tooLong() {
        const bool motions = m_program->motionCount() > m_options.maxMotions;
        if (!motions && m_program->events().size() <= m_options.maxMotions)
            return false;
        m_reporter.tellInAnyCase(motions ? nc_message::kTooManyMotions : nc_message::kTooManyEvents, 1, 0,
                                 {std::to_string(m_options.maxMotions)});
        m_cutShort = true;
        return true;
    }

    void tellAboutTheWhole(std::size_t linesRead) {
        const std::size_t rest = firstTextFrom(linesRead);
        if ((m_state.ended || m_percentClosed) && rest < m_text.lineCount()) {
            m_reporter.beginLine(static_cast<std::uint32_t>(rest + 1));
            m_reporter.tellInAnyCase(m_state.ended ? nc_message::kAfterEnd : nc_message::kAfterPercent, 1, 0);
        }
        if (m_program->motionCount() == 0)
            m_reporter.tellInAnyCase(nc_message::kNoMotion, 1, 0);
        else if (linesRead == m_text.lineCount() && !m_state.ended && !m_percentClosed)
            m_reporter.tellInAnyCase(nc_message::kNoProgramEnd, 1, 0);
        tellNeverKnown();
    }

    /// Axes without which a motion cut nothing were told there.
    void tellNeverKnown() {
        const auto never = static_cast<std::uint8_t>(kAllAxes & ~(m_state.everKnown | m_state.unknownTold));
        if (never != 0 && m_program->motionCount() > 0 && !m_options.assumeStartAtZero)
            m_reporter.tellInAnyCase(nc_message::kNeverKnown, 1, 0, {namesOfAxes(never)});
    }

    const NcText& m_text;
    const InterpretOptions& m_options;
    const WorkContext& m_context;
    std::shared_ptr<Program> m_program;
    Reporter m_reporter;
    MachineState m_state;
    Line m_line;
    std::size_t m_sourceBlocks = 0;
    bool m_percentOpen = false;
    bool m_percentClosed = false;
    bool m_finished = false;
    bool m_cutShort = false; ///< stopped, or at a limit: what the rest of the program says is not known
    bool m_controlCodeTold = false;
    bool m_longNumberTold = false;
};

} // namespace

std::shared_ptr<const Program> interpret(const NcText& text, const InterpretOptions& options,
                                         const WorkContext& context) {
    return Interpreter(text, options, context).run();
}

} // namespace proveout

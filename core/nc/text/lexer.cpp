// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/lexer.h"

#include <algorithm>

#include "core/base/utf8.h"
#include "core/nc/text/characters.h"
#include "core/nc/text/number.h"

namespace proveout {

namespace {

constexpr LetterSet kLengths("XYZIJKRQUVW[]");
constexpr std::size_t kLongestBlockNumber = 15; ///< digits; more than any control can store

/// DC1 to DC4 of a serial line, and the end-of-file byte of DOS.
bool isControlCode(char c) {
    return (c >= 0x11 && c <= 0x14) || c == 0x1a;
}

class LineReader {
public:
    LineReader(std::string_view text, const ReadContext& context, Line& line)
        : m_text(text), m_context(context), m_macroB(context.dialect.macros == MacroLanguage::macroB),
          m_line(line) {}

    void readFrom(std::size_t begin) {
        m_at = begin;
        readItems();
    }

    void read() {
        skipBlanks();
        if (!atEnd() && m_text[m_at] == '%') {
            readPercent();
            return;
        }
        if (!atEnd() && m_text[m_at] == '/') {
            m_line.deleteMark = true;
            skipDeleteMark();
        }
        readItems();
    }

private:
    void readItems() {
        while (skipBlanks(), !atEnd() && !m_line.error)
            readItem();
    }

    /// "/", or "/1" to "/9" if a control has several switches for it.
    void skipDeleteMark() {
        ++m_at;
        skipBlanks();
        if (m_macroB && !atEnd() && m_text[m_at] >= '1' && m_text[m_at] <= '9')
            ++m_at;
    }

    [[nodiscard]] bool atEnd() const { return m_at >= m_text.size(); }

    void skipBlanks() {
        for (; !atEnd(); ++m_at) {
            if (isControlCode(m_text[m_at]))
                m_line.controlCodeColumn = std::max(m_line.controlCodeColumn, static_cast<int>(m_at + 1));
            else if (!isBlank(m_text[m_at]))
                return;
        }
    }

    void fail(const FindingRow& message, std::size_t begin, std::size_t end, std::string_view argument = {}) {
        m_line.error = readError(message, begin, end, argument);
    }

    void readPercent() {
        const std::size_t percent = m_at++;
        while (skipBlanks(), !atEnd() && !m_line.error) {
            if (m_text[m_at] == '(' || m_text[m_at] == ';')
                readItem();
            else
                fail(nc_message::kPercentNotAlone, percent, percent + 1);
        }
        m_line.percent = !m_line.error.has_value();
    }

    void readItem() {
        const char c = m_text[m_at];
        if (m_macroB && readMacroItem(c))
            return;
        if (isLetter(c) || (m_context.dialect.hasPolarWords && (c == '@' || c == '^')))
            readWord(upperCase(c));
        else if (c == '$' && m_context.dialect.macros == MacroLanguage::oWords)
            readWord(kSpindleLetter);
        else if (c == '(')
            readComment();
        else if (c == ';')
            m_at = m_text.size();
        else if (c == '#')
            readAssignment();
        else
            failOnCharacter();
    }

    /// Reads items that only custom macro B's dialect has; false if `c` does not begin one.
    bool readMacroItem(char c) {
        if (upperCase(c) == 'O' || c == ':') {
            readProgramNumber();
            return true;
        }
        if (c == '<') {
            readProgramName();
            return true;
        }
        if (c == ',') {
            readCornerWord();
            return true;
        }
        if (c == '/') {
            m_at = m_context.blockDelete ? m_text.size() : m_at;
            if (!atEnd())
                skipDeleteMark();
            return true;
        }
        if (!isLetter(c))
            return false;
        const std::size_t next = proveout::skipBlanks(m_text, m_at + 1);
        if (next >= m_text.size() || !isLetter(m_text[next]))
            return false;
        m_line.statement = readStatement(m_text, m_at);
        if (!m_line.statement)
            return false;
        if (!m_line.block.empty() || !m_line.assignments.empty()) {
            fail(nc_message::kStatementNotFirst, m_line.statement->begin, m_line.statement->rest);
            m_line.statement.reset();
        }
        m_at = m_text.size();
        return true;
    }

    void readCornerWord() {
        const std::size_t at = proveout::skipBlanks(m_text, m_at + 1);
        const char letter = at < m_text.size() ? upperCase(m_text[at]) : '\0';
        if (letter != 'C' && letter != 'R') {
            fail(nc_message::kCornerComma, m_at, m_at + 1);
            return;
        }
        m_at = at;
        readWord(letter == 'C' ? kChamferLetter : kRoundingLetter);
    }

    void readProgramNumber() {
        const std::size_t begin = m_at;
        const NumberRead number = readNumber(m_text, begin + 1);
        m_at = number.end;
        if (number.status != NumberStatus::good)
            failOnNumber(number, begin);
        else if (!m_line.block.empty())
            fail(nc_message::kFlowNotFirst, begin, number.end);
        else
            m_line.programNumber = true;
        m_line.program = number.value;
    }

    void readProgramName() {
        const std::size_t end = m_text.find('>', m_at);
        if (end == std::string_view::npos) {
            fail(nc_message::kNameUnclosed, m_at, m_text.size());
            return;
        }
        if (m_line.block.empty())
            m_line.programNumber = true;
        else if (callsProgram())
            m_line.block.setCalled(m_text.substr(m_at + 1, end - m_at - 1));
        else
            return failOnCharacter();
        m_at = end + 1;
    }

    /// Whether the block has M98, G65 or G66.
    [[nodiscard]] bool callsProgram() const {
        constexpr double kSubprogram = 98;
        constexpr double kMacro = 65;
        constexpr double kModalMacro = 66;
        return std::ranges::any_of(m_line.block.codes(), [](const Word& word) {
            return word.letter == 'M' ? word.value == kSubprogram
                                      : word.value == kMacro || word.value == kModalMacro;
        });
    }

    void failOnCharacter() {
        const std::size_t end = m_at + firstCharacter(m_text.substr(m_at)).length;
        fail(nc_message::kBadCharacter, m_at, end, m_text.substr(m_at, end - m_at));
    }

    void readComment() {
        const bool nests = !m_macroB && !m_context.dialect.streamed;
        const std::size_t end = m_text.find_first_of(nests ? "()" : ")", m_at + 1);
        if (end == std::string_view::npos)
            fail(nc_message::kCommentUnclosed, m_at, m_at + 1);
        else if (m_text[end] == '(')
            fail(nc_message::kCommentNested, end, end + 1);
        else
            m_at = end + 1;
        m_seenComment = true;
    }

    void readWord(char letter) {
        if (letter == 'N') {
            readBlockNumber();
            return;
        }
        if (letter == 'O') {
            readFlow();
            return;
        }
        const std::size_t begin = m_at;
        const NumberRead number = readNumber(m_text, begin + 1);
        if (number.status == NumberStatus::good)
            addWord(letter, number.value, begin, number.end, number.point);
        else if (beginsExpression(number))
            readExpression(letter);
        else
            failOnNumber(number, begin);
    }

    /// M98 and M99, which LinuxCNC recognizes only at the beginning of a line.
    [[nodiscard]] bool callsOrReturns(const Word& word) const {
        constexpr double kCall = 98;
        constexpr double kReturn = 99;
        return word.letter == 'M' && (word.value == kCall || word.value == kReturn) &&
               m_context.dialect.macros == MacroLanguage::oWords;
    }

    [[nodiscard]] bool beginsExpression(const NumberRead& number) const {
        if (number.status == NumberStatus::expression)
            return true;
        std::size_t place = number.place;
        while (place < m_text.size() && isBlank(m_text[place]))
            ++place;
        return number.status == NumberStatus::missing && place < m_text.size() && isLetter(m_text[place]);
    }

    void readExpression(char letter) {
        const std::size_t begin = m_at;
        if (m_context.dialect.macros == MacroLanguage::none) {
            fail(nc_message::kNoExpressions, begin, begin + 1);
            return;
        }
        std::size_t end = begin + 1;
        ExpressionReader reader(m_text, m_context);
        if (kLengths.has(letter))
            reader.setLeastUnit(m_context.system.leastUnit());
        const auto value = reader.value(end, m_text.substr(begin, 1));
        if (value)
            addWord(letter, *value, begin, end, true);
        else
            m_line.error = value.error();
    }

    void readAssignment() {
        const std::size_t begin = m_at++;
        if (m_context.dialect.macros == MacroLanguage::none) {
            fail(nc_message::kNoExpressions, begin, begin + 1);
            return;
        }
        ExpressionReader reader(m_text, m_context);
        auto target = reader.parameterName(m_at);
        if (!target) {
            m_line.error = target.error();
            return;
        }
        skipBlanks();
        if (atEnd() || m_text[m_at] != '=') {
            fail(nc_message::kAssignmentForm, begin, m_at, m_text.substr(begin, m_at - begin));
            return;
        }
        ++m_at;
        const std::string_view sign = m_text.substr(begin, 1);
        const auto value = m_macroB ? reader.expression(m_at, sign) : reader.value(m_at, sign);
        if (!value) {
            m_line.error = value.error();
            return;
        }
        m_line.assignments.push_back(
            {std::move(*target), *value, static_cast<int>(begin + 1), static_cast<int>(m_at - begin)});
    }

    void addWord(char letter, double value, std::size_t begin, std::size_t end, bool point) {
        m_at = end;
        if (isNull(value))
            return; // null: the word is ignored
        const Word word{letter, value, static_cast<int>(begin + 1), static_cast<int>(end - begin), point};
        if (callsOrReturns(word) && (m_seenComment || !m_line.block.empty() || !m_line.assignments.empty()))
            m_line.lateCall = {word.column, word.length};
        if (m_context.dialect.lastWordCounts ? m_line.block.addOrReplace(word) : m_line.block.add(word))
            return;
        const bool code = letter == 'G' || letter == 'M';
        fail(code ? nc_message::kTooManyCodes : nc_message::kWordTwice, begin, end, m_text.substr(begin, 1));
    }

    void failOnNumber(const NumberRead& number, std::size_t begin) {
        const std::string_view letter = m_text.substr(begin, 1);
        switch (number.status) {
        case NumberStatus::good:
            return;
        case NumberStatus::missing:
            failOnMissing(number.place, begin);
            return;
        case NumberStatus::doubleSign:
            fail(nc_message::kDoubleSign, number.place, number.end + 1, letter);
            return;
        case NumberStatus::twoPoints:
            fail(nc_message::kTwoPoints, number.place, number.place + 1, letter);
            return;
        case NumberStatus::outOfRange:
            fail(nc_message::kNumberOutOfRange, begin, number.end, letter);
            return;
        case NumberStatus::expression:
            return; // this status is not an error
        }
    }

    /// Marks what is in place of the number, or the letter if the line ends there.
    void failOnMissing(std::size_t place, std::size_t begin) {
        while (place < m_text.size() && isBlank(m_text[place]))
            ++place;
        if (place >= m_text.size()) {
            fail(nc_message::kNumberMissing, begin, m_text.size(), m_text.substr(begin, 1));
            return;
        }
        if (static_cast<unsigned char>(m_text[place]) >= 0x80) {
            m_at = place;
            failOnCharacter();
            return;
        }
        fail(nc_message::kNumberMissing, place, place + 1, m_text.substr(begin, 1));
    }

    /// Block numbers are labels, of any length and also with decimals.
    void readBlockNumber() {
        const std::size_t begin = m_at;
        if ((!m_line.block.empty() && !m_context.dialect.streamed) || m_seenBlockNumber) {
            fail(nc_message::kBlockNumberPlace, begin, begin + 1);
            return;
        }
        m_seenBlockNumber = true;
        const NumberRead number = readNumber(m_text, begin + 1);
        const std::size_t first = proveout::skipBlanks(m_text, begin + 1);
        const bool negative = number.value < 0 || (first < m_text.size() && m_text[first] == '-'); // N-0
        if (number.status == NumberStatus::good && negative) {
            fail(nc_message::kBlockNumberNegative, begin, number.end);
            return;
        }
        if (number.status != NumberStatus::good && number.status != NumberStatus::outOfRange) {
            failOnNumber(number, begin);
            return;
        }
        const double largest = m_context.dialect.largestBlockNumber;
        if (largest > 0 && (number.status == NumberStatus::outOfRange || number.value > largest)) {
            fail(nc_message::kBlockNumberLarge, begin, number.end, "10000000");
            return;
        }
        m_line.blockNumber = number.value;
        if (number.end - begin > kLongestBlockNumber + 1)
            m_line.longBlockNumber = {static_cast<int>(begin + 1), static_cast<int>(number.end - begin)};
        m_at = number.end;
    }

    void readFlow() {
        const std::size_t begin = m_at;
        if (!m_line.block.empty() || !m_line.assignments.empty()) {
            fail(nc_message::kFlowNotFirst, begin, begin + 1);
            return;
        }
        auto word = readFlowWord(m_text);
        const bool labels = m_context.dialect.macros == MacroLanguage::labels;
        if (m_context.dialect.macros == MacroLanguage::none)
            fail(nc_message::kWordForeign, begin, begin + 1, "O");
        else if (labels && (!word || word->kind != FlowKind::programNumber || word->label.empty()))
            fail(nc_message::kOWordForeign, begin, begin + 1);
        else if (word)
            m_line.flow = std::move(*word);
        else
            m_line.error = word.error();
        m_at = m_text.size();
    }

    std::string_view m_text;
    const ReadContext& m_context;
    bool m_macroB;
    Line& m_line;
    std::size_t m_at = 0;
    bool m_seenBlockNumber = false;
    bool m_seenComment = false;
};

} // namespace

namespace {

void clear(Line& line) {
    line.block.clear();
    line.assignments.clear();
    line.flow.reset();
    line.statement.reset();
    line.programNumber = false;
    line.blockNumber.reset();
    line.percent = false;
    line.deleteMark = false;
    line.controlCodeColumn = 0;
    line.lateCall = {};
    line.longBlockNumber = {};
    line.error.reset();
}

} // namespace

void readLine(std::string_view text, const ReadContext& context, Line& line) {
    clear(line);
    LineReader(text, context, line).read();
}

void readRest(std::string_view text, std::size_t from, const ReadContext& context, Line& line) {
    clear(line);
    LineReader(text, context, line).readFrom(from);
}

LetterSet axisLetters(std::string_view text) {
    LetterSet letters;
    bool comment = false;
    for (const char c : text) {
        if (c == ';' && !comment)
            break;
        comment = (comment || c == '(') && c != ')';
        const char letter = upperCase(c);
        if (!comment && ((letter >= 'X' && letter <= 'Z') || letter == '@' || letter == '^'))
            letters.add(letter);
    }
    return letters;
}

} // namespace proveout

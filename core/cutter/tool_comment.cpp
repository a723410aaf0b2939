// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/tool_comment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/tool_number.h"
#include "core/cutter/comment_tokens.h"
#include "core/cutter/tool_comment_words.h"

namespace proveout {

namespace {

constexpr double kMmPerInch = 25.4;
// PCB mills are 0.1 mm thick, face mills 300 mm.
constexpr double kThinnest = 0.02;
constexpr double kThickest = 500;
constexpr double kLongest = 1000;
constexpr std::size_t kReach = 3;        ///< tokens from the name of a shape to its size: "20mm 390 ENDMILL"
constexpr std::size_t kLongestLabel = 3; ///< tokens
constexpr std::size_t kMostWords = 14;   ///< a comment with more is prose

/// Reads one comment.
class CommentReader {
public:
    CommentReader(std::string_view comment, bool inch)
        : m_tokens(commentTokens(comment)), m_used(m_tokens.size()), m_inch(inch),
          m_shape(shapeIn(m_tokens)) {
        for (const CommentToken& token : m_tokens) {
            const CommentUnit unit = token.isNumber() ? CommentUnit::none : unitNamed(token.word);
            if (unit == CommentUnit::mm || unit == CommentUnit::inch)
                m_inch = unit == CommentUnit::inch;
        }
    }

    ToolComment read() {
        if (m_shape.row != nullptr && *m_shape.row->shape == '\0')
            return {};
        readNumbers();
        readNumberInFront();
        for (std::size_t at = 0; at < m_tokens.size(); ++at)
            readLabel(at);
        readAngle();
        if (m_shape.row != nullptr)
            m_tool.shape = m_shape.row->shape;
        const bool ofSomethingElse = isAboutSomethingElse();
        if (ofSomethingElse)
            m_tool.diameter.reset();
        if (!m_tool.diameter)
            readSizeAfterNumber();
        if (!m_tool.diameter && !ofSomethingElse)
            readBareSize();
        m_tool.aboutTool = m_tool.aboutTool || namesAnyTool() || isDiameterAlone();
        return m_nonsense ? ToolComment{} : m_tool;
    }

private:
    [[nodiscard]] bool namesAnyTool() const {
        return std::ranges::any_of(m_tokens, [](const CommentToken& token) { return namesTool(token.word); });
    }

    /// "D10"
    [[nodiscard]] bool isDiameterAlone() const { return m_tokens.size() == 2 && m_tool.diameter; }

    [[nodiscard]] double millimetres(const CommentToken& number) const {
        const bool inch = number.fraction || number.unit == CommentUnit::inch ||
                          (number.unit == CommentUnit::none && m_inch);
        return number.value * (inch ? kMmPerInch : 1);
    }

    /// The index of the number that a label of `words` tokens at `at` is for; the number of tokens if there
    /// is none.
    [[nodiscard]] std::size_t numberOf(const LabelRow& row, std::size_t at) const {
        const std::size_t next = at + wordCount(row.words);
        const bool usable =
            next < m_tokens.size() && m_tokens[next].isNumber() && !m_used[next] && !m_tokens[next].term;
        if (!usable)
            return m_tokens.size();
        const CommentToken& number = m_tokens[next];
        return !row.closely || !number.separated || number.equals ? next : m_tokens.size();
    }

    /// Reads the H register and the tool number, which must be known before D can be distinguished from the D
    /// register.
    void readNumbers() {
        for (std::size_t at = 0; at < m_tokens.size(); ++at) {
            const LabelRow* row = labelAt(m_tokens, at);
            const std::size_t next = row == nullptr ? m_tokens.size() : numberOf(*row, at);
            if (next == m_tokens.size())
                continue;
            if (row->field == CommentField::height)
                m_height = m_tokens[next].value;
            else if (row->field == CommentField::toolNumber && m_tokens[next].isWhole() && !m_statedNumber)
                m_statedNumber = m_tokens[next].value;
        }
    }

    /// "1 = End Mill {6 mm}"
    void readNumberInFront() {
        if (m_tokens.size() < 2 || !m_tokens[0].isWhole() || !m_tokens[1].equals || m_shape.row == nullptr)
            return;
        m_used[0] = true;
        setNumber(m_tokens[0].value);
    }

    void readLabel(std::size_t at) {
        const LabelRow* row = labelAt(m_tokens, at);
        if (row == nullptr || isPartOfLongerLabel(at))
            return;
        const std::size_t next = numberOf(*row, at);
        if (next == m_tokens.size())
            return;
        const CommentToken& number = m_tokens[next];
        if (row->field == CommentField::toolNumber && !number.isWhole())
            return; // "Tool: 3.0 mm"
        if (row->field == CommentField::diameter && isRegister(number))
            return;
        m_used[next] = true;
        m_nonsense = m_nonsense || (number.minus && number.equals) || std::isnan(number.value);
        if (row->field == CommentField::toolNumber)
            m_numberAt = next;
        put(row->field, number);
    }

    /// This "D" is part of "TOOL D", which was read already.
    [[nodiscard]] bool isPartOfLongerLabel(std::size_t at) const {
        for (std::size_t back = 1; back <= 2 && back <= at; ++back)
            if (const LabelRow* row = labelAt(m_tokens, at - back);
                row != nullptr && wordCount(row->words) > back)
                return true;
        return false;
    }

    /// "H1 D1": the radius register, as posts list it beside the length register; and "T5 D5 12MM ENDMILL",
    /// where another number is the size.
    [[nodiscard]] bool isRegister(const CommentToken& number) const {
        if (!number.isWhole() || number.equals)
            return false;
        if (m_height && number.value == *m_height)
            return true;
        const bool ofTool = number.value == m_statedNumber.value_or(-1);
        return ofTool && (m_height || (number.unit == CommentUnit::none && hasSizeBesideShape()));
    }

    /// A number with a unit or a point, beside the name of the shape and without a label of its own.
    [[nodiscard]] bool hasSizeBesideShape() const {
        for (std::size_t at = 0; at < m_tokens.size(); ++at) {
            const CommentToken& number = m_tokens[at];
            const bool sized =
                number.isNumber() && (number.unit == CommentUnit::mm || number.unit == CommentUnit::inch ||
                                      number.fraction || number.point);
            if (sized && rankOfSize(at) > 0 && distanceToShape(at) <= kReach && !hasLabel(at))
                return true;
        }
        return false;
    }

    [[nodiscard]] bool hasLabel(std::size_t at) const {
        for (std::size_t back = 1; back <= kLongestLabel && back <= at; ++back)
            if (const LabelRow* row = labelAt(m_tokens, at - back);
                row != nullptr && numberOf(*row, at - back) == at)
                return true;
        return false;
    }

    void put(CommentField field, const CommentToken& number) {
        const double mm = millimetres(number);
        switch (field) {
        case CommentField::toolNumber:
            return setNumber(number.value);
        case CommentField::diameter:
            return setDiameter(mm);
        case CommentField::toolDiameter:
            m_tool.aboutTool = true;
            return setDiameter(mm);
        case CommentField::toolRadius:
            m_tool.aboutTool = true;
            return setDiameter(2 * mm);
        case CommentField::cornerRadius:
            return setOnce(m_tool.cornerRadius, mm, 0, kThickest / 2);
        case CommentField::sideAngle:
            return setOnce(m_tool.sideAngle, number.value, 0, 179);
        case CommentField::includedAngle:
            return setOnce(m_tool.includedAngle, number.value, 1, 179);
        case CommentField::tipDiameter:
            return setOnce(m_tool.tipDiameter, mm, 0, kThickest);
        case CommentField::fluteLength:
            return setOnce(m_tool.fluteLength, mm, kThinnest, kLongest);
        case CommentField::threadSize:
            return isThreading() ? setDiameter(number.value) : void();
        case CommentField::height:
        case CommentField::notOfCutter:
            return;
        }
    }

    /// A bare number beside a tap is its pitch.
    [[nodiscard]] bool isThreading() const {
        const std::string_view shape = m_shape.row == nullptr ? "" : m_shape.row->shape;
        return shape == "tap" || shape == "threadmill";
    }

    void setNumber(double number) {
        if (m_tool.number)
            return;
        if (number <= kLargestTool)
            m_tool.number = static_cast<int>(number);
        else
            m_nonsense = true;
    }

    void setDiameter(double mm) { setOnce(m_tool.diameter, mm, kThinnest, kThickest); }

    /// A size that no cutter has discredits the whole comment.
    void setOnce(std::optional<double>& value, double given, double least, double most) {
        if (value)
            return;
        if (given >= least && given <= most)
            value = given;
        else
            m_nonsense = true;
    }

    /// "90 DEG" without a label.
    void readAngle() {
        if (m_tool.includedAngle || m_tool.sideAngle)
            return;
        for (std::size_t at = 0; at < m_tokens.size(); ++at)
            if (m_tokens[at].unit == CommentUnit::degree && !m_used[at]) {
                m_used[at] = true;
                return setOnce(m_tool.includedAngle, m_tokens[at].value, 0.5, 179);
            }
    }

    /// "T1 : 3.175" and nothing more.
    void readSizeAfterNumber() {
        if (m_numberAt != 1 || m_tokens.size() != 3 || !m_tokens[2].isNumber() || !m_tokens[2].equals)
            return;
        m_tool.aboutTool = true;
        setDiameter(millimetres(m_tokens[2]));
    }

    /// Prose, or a text about holes, passes and heights. A tool number, or sizes that only a tool has,
    /// outweigh that.
    [[nodiscard]] bool isAboutSomethingElse() const {
        if (m_tool.number || m_tool.aboutTool)
            return false;
        const auto words =
            std::ranges::count_if(m_tokens, [](const auto& token) { return !token.isNumber(); });
        if (static_cast<std::size_t>(words) > kMostWords)
            return true;
        for (std::size_t at = 0; at < m_tokens.size(); ++at) {
            const bool ofShape = m_shape.row != nullptr && at >= m_shape.first && at <= m_shape.last;
            if (!ofShape && namesSomethingElse(m_tokens[at].word))
                return true;
        }
        return false;
    }

    /// "10mm ball nose", "END MILL 6 mm", "1/4 SPOT DRILL", "Tool: 3.0mm": the best number beside the name.
    void readBareSize() {
        std::size_t best = m_tokens.size();
        double bestRank = 0;
        for (std::size_t at = 0; at < m_tokens.size(); ++at)
            if (const double rank = rankOfSize(at); rank > bestRank) {
                best = at;
                bestRank = rank;
            }
        if (best == m_tokens.size())
            return;
        m_tool.aboutTool = true;
        setDiameter(millimetres(m_tokens[best]));
    }

    /// How likely it is that a number is the diameter; 0: not at all.
    [[nodiscard]] double rankOfSize(std::size_t at) const {
        const CommentToken& number = m_tokens[at];
        if (!number.isNumber() || m_used[at] || number.glued || number.term ||
            number.unit == CommentUnit::degree || isLabelledOtherwise(at))
            return 0;
        const bool sized = number.unit != CommentUnit::none || number.fraction || isBeforeDiameter(at);
        const std::size_t shape = distanceToShape(at);
        if (sized && shape <= kReach)
            return 10 - static_cast<double>(shape);
        if (sized && isBesideTool(at))
            return 6;
        // A bare number may be anything: it counts beside the name of the shape, if the tool has a number or
        // the figure a decimal point.
        if (shape == 1 && (m_tool.number || number.point) && !isThreading())
            return 2;
        return 0;
    }

    /// "10. DIA FLAT ENDMILL"
    [[nodiscard]] bool isBeforeDiameter(std::size_t at) const {
        const LabelRow* row = at + 1 < m_tokens.size() ? labelAt(m_tokens, at + 1) : nullptr;
        return row != nullptr && row->field == CommentField::diameter &&
               numberOf(*row, at + 1) == m_tokens.size();
    }

    /// The number belongs to the word before it, as in "length: 5 mm".
    [[nodiscard]] bool isLabelledOtherwise(std::size_t at) const {
        return at > 0 && m_tokens[at].equals && !m_tokens[at - 1].isNumber() &&
               !namesTool(m_tokens[at - 1].word) && !isOfShape(at - 1);
    }

    [[nodiscard]] bool isOfShape(std::size_t at) const {
        return m_shape.row != nullptr && at >= m_shape.first && at <= m_shape.last;
    }

    [[nodiscard]] std::size_t distanceToShape(std::size_t at) const {
        if (m_shape.row == nullptr)
            return m_tokens.size() + kReach;
        std::size_t first = m_shape.first;
        std::size_t last = m_shape.last;
        // "BALL END MILL": all its words name it.
        while (last + 1 < m_tokens.size() && isNameWord(last + 1))
            ++last;
        while (first > 0 && isNameWord(first - 1))
            --first;
        return at < first ? first - at : at > last ? at - last : m_tokens.size();
    }

    [[nodiscard]] bool isNameWord(std::size_t at) const {
        static constexpr std::string_view kWords[] = {"END",    "MILL", "ENDMILL", "NOSE",
                                                      "CUTTER", "BIT",  "DRILL"};
        return std::ranges::find(kWords, m_tokens[at].word) != std::end(kWords);
    }

    [[nodiscard]] bool isBesideTool(std::size_t at) const {
        return (at > 0 && namesTool(m_tokens[at - 1].word)) ||
               (at + 1 < m_tokens.size() && namesTool(m_tokens[at + 1].word));
    }

    std::vector<CommentToken> m_tokens;
    std::vector<bool> m_used; ///< numbers that belong to a label
    bool m_inch;
    ShapePlace m_shape;
    std::optional<double> m_height;
    std::optional<double> m_statedNumber; ///< of the tool, given by a label
    std::size_t m_numberAt = 0;           ///< index of the token of the tool number
    bool m_nonsense = false;
    ToolComment m_tool;
};

} // namespace

bool ToolComment::isComplete() const {
    return diameter && (number || aboutTool || *shape != '\0');
}

bool ToolComment::isEmpty() const {
    return !number && *shape == '\0' && !diameter && !cornerRadius && !sideAngle && !includedAngle &&
           !tipDiameter && !fluteLength;
}

ToolComment readToolComment(std::string_view comment, bool inch) {
    // Every size has a digit, and most comments have none.
    if (comment.find_first_of("0123456789=:") == std::string_view::npos)
        return {};
    return CommentReader(comment, inch).read();
}

bool extend(ToolComment& tool, const ToolComment& next) {
    const auto twice = [](const auto& a, const auto& b) { return a && b; };
    if (twice(tool.number, next.number) || twice(tool.diameter, next.diameter) ||
        (*tool.shape != '\0' && *next.shape != '\0'))
        return false;
    const auto adopt = [](auto& into, const auto& from) {
        if (!into)
            into = from;
    };
    adopt(tool.number, next.number);
    adopt(tool.diameter, next.diameter);
    adopt(tool.cornerRadius, next.cornerRadius);
    adopt(tool.sideAngle, next.sideAngle);
    adopt(tool.includedAngle, next.includedAngle);
    adopt(tool.tipDiameter, next.tipDiameter);
    adopt(tool.fluteLength, next.fluteLength);
    if (*tool.shape == '\0')
        tool.shape = next.shape;
    tool.aboutTool = tool.aboutTool || next.aboutTool;
    return true;
}

} // namespace proveout

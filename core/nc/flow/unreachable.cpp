// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/unreachable.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "core/nc/text/characters.h"
#include "core/nc/text/flow_word.h"
#include "core/nc/text/macro_statement.h"
#include "core/nc/text/number.h"

namespace proveout {

namespace {

/// The block numbers that the jumps of a text name.
class Targets {
public:
    explicit Targets(const NcText& text) {
        for (std::size_t line = 0; line < text.lineCount(); ++line)
            read(text.line(line));
    }

    [[nodiscard]] bool has(double number) const { return m_computed || m_numbers.contains(number); }

private:
    void read(std::string_view line) {
        for (std::size_t at = 0; at < line.size(); ++at) {
            const char c = upperCase(line[at]);
            std::size_t behind = at;
            if (c == 'G' && readKeyword(line, behind, "GOTO"))
                add(line, behind);
            else if (c == 'P')
                add(line, at + 1); // of M97 and M99, and of other codes with a P
        }
    }

    void add(std::string_view line, std::size_t at) {
        const NumberRead number = readNumber(line, at);
        m_computed = m_computed || number.status == NumberStatus::expression;
        if (number.status == NumberStatus::good)
            m_numbers.insert(number.value);
    }

    std::set<double> m_numbers;
    bool m_computed = false; ///< a jump may have any number as its target
};

enum class Role { nothing, entry, labelled, plain };

struct Content {
    Role role = Role::nothing;
    double label = 0;
};

/// Whether there is a statement other than a jump at this place: perhaps one of a loop.
bool mayEnterLoop(std::string_view line, std::size_t at, MacroLanguage macros) {
    if (macros != MacroLanguage::macroB)
        return false;
    const auto statement = readStatement(line, at);
    return statement && statement->kind != StatementKind::gotoBlock;
}

/// What a line means for the search for a way to it.
Content contentOf(std::string_view line, MacroLanguage macros) {
    std::size_t at = skipBlanks(line, 0);
    if (macros != MacroLanguage::macroB && hasFlowWord(line))
        return {Role::entry};
    std::optional<double> label;
    while (at < line.size()) {
        const char c = upperCase(line[at]);
        if (c == '(') {
            at = std::min(line.find(')', at), line.size() - 1) + 1;
        } else if (c == 'N' && !label) {
            const NumberRead number = readNumber(line, at + 1);
            if (number.status != NumberStatus::good)
                return {Role::entry};
            label = number.value;
            at = number.end;
        } else if (c == ';') {
            break;
        } else if (c == '%' || c == '/' || c == 'O' || c == ':' || c == '<' ||
                   mayEnterLoop(line, at, macros)) {
            return {Role::entry};
        } else {
            return label ? Content{Role::labelled, *label} : Content{Role::plain};
        }
        at = skipBlanks(line, at);
    }
    return label ? Content{Role::labelled, *label} : Content{};
}

} // namespace

std::vector<std::pair<std::size_t, std::size_t>> Unreachable::find(const NcText& text,
                                                                   MacroLanguage macros) const {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    std::optional<Targets> targets;
    for (const std::size_t leaving : m_leaving) {
        for (std::size_t line = leaving + 1; line < text.lineCount(); ++line) {
            const Content content = contentOf(text.line(line), macros);
            if (content.role == Role::nothing)
                continue;
            if (content.role == Role::labelled && macros == MacroLanguage::macroB && !targets)
                targets.emplace(text);
            const bool jumpedTo = content.role == Role::labelled && targets && targets->has(content.label);
            if (content.role != Role::entry && !jumpedTo)
                found.emplace_back(line, leaving);
            break;
        }
    }
    return found;
}

} // namespace proveout

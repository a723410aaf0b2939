// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/line_watch.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/nc/codes/codes.h"
#include "core/nc/text/characters.h"
#include "core/nc/text/expression_rules.h"

namespace proveout {

namespace {

const char* unitOf(Quantity quantity, const MachineState& state) {
    constexpr std::array kFeeds{"mm/min", "1/min", "mm/rev"};
    constexpr std::array kInchFeeds{"in/min", "1/min", "in/rev"};
    switch (quantity) {
    case Quantity::length:
        return state.inch ? "in" : "mm";
    case Quantity::angle:
        return "°";
    case Quantity::feed:
        return (state.inch ? kInchFeeds : kFeeds)[static_cast<std::size_t>(state.feedMode)];
    case Quantity::speed:
        return PROVEOUT_TEXT("Core", "rpm");
    case Quantity::number:
        break;
    }
    return "";
}

/// Calls `note(begin, value)` for each parameter that the line names; a parameter that is the number of
/// another one comes first.
template<typename Note>
void forParameters(std::string_view text, const ReadContext& context, const Note& note) {
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == '(' || text[at] == ';') {
            at = behindComment(text, at);
            continue;
        }
        if (text[at] == '#') {
            std::size_t end = at;
            const auto value = ExpressionReader(text, context).value(end, "#");
            note(at, value && !isNull(*value) ? std::optional(*value) : std::nullopt);
        }
        ++at;
    }
}

} // namespace

void LineWatch::begin(std::string_view text, const ReadContext& context,
                      std::vector<ControlState::Mode> modes) {
    if (m_values.executions > 0)
        return;
    m_values.before = std::move(modes);
    forParameters(text, context, [&](std::size_t begin, std::optional<double> value) {
        m_values.parameters.push_back({begin, value, {}});
    });
}

void LineWatch::end(const Line& line, std::string_view text, const ReadContext& context,
                    const MachineState& state, std::vector<ControlState::Mode> modes) {
    if (m_values.executions++ > 0)
        return;
    m_values.after = std::move(modes);
    auto parameter = m_values.parameters.begin();
    forParameters(text, context,
                  [&](std::size_t, std::optional<double> value) { (parameter++)->after = value; });
    noteWords(line, context.dialect, state);
}

void LineWatch::noteWords(const Line& line, const Dialect& dialect, const MachineState& state) {
    const auto note = [&](const Word& word) {
        const auto row = std::ranges::find(letters(), word.letter, &LetterRow::letter);
        const Quantity quantity = row != letters().end() ? row->quantity : Quantity::number;
        const bool counts = quantity == Quantity::length && !word.point;
        const double least = state.inch ? dialect.leastInch : dialect.leastMm;
        if (!isNull(word.value))
            m_values.words.push_back({static_cast<std::size_t>(word.column - 1),
                                      counts ? word.value * least : word.value, quantity,
                                      unitOf(quantity, state)});
    };
    for (const LetterRow& row : letters())
        if (line.block.has(row.letter))
            note(line.block.word(row.letter));
    for (const Word& word : line.block.codes())
        note(word);
    for (const Word& word : line.block.earlier())
        note(word);
}

} // namespace proveout

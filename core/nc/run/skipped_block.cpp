// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/skipped_block.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/nc/codes/codes.h"
#include "core/nc/codes/handlers.h"
#include "core/nc/state/execution.h"
#include "core/nc/text/characters.h"
#include "core/nc/text/number.h"

namespace proveout {

namespace {

/// In force when the motion code is unknown. Without a handler it moves nothing, and makes the positions of
/// the axes that a block names unknown.
constexpr CodeRow kLostMotion{'G', -1, ModalGroup::motion, PROVEOUT_TEXT("Core", "motion")};

/// The groups whose codes need no other word of their block, in the order in which they take effect.
constexpr std::array kModes{ModalGroup::units,    ModalGroup::feedMode,    ModalGroup::toolChange,
                            ModalGroup::spindle,  ModalGroup::plane,       ModalGroup::workOffset,
                            ModalGroup::distance, ModalGroup::arcDistance, ModalGroup::retract};

constexpr std::size_t kShortestKeyword = 3; ///< GOTO is not a G

/// The number of consecutive letters.
std::size_t lettersFrom(std::string_view line, std::size_t at) {
    const std::size_t begin = at;
    while (at < line.size() && isLetter(line[at]))
        ++at;
    return at - begin;
}

/// Whether a number ends here; if anything else follows, the number is doubtful.
bool endsNumber(std::string_view line, std::size_t at) {
    while (at < line.size() && (line[at] == ' ' || line[at] == '\t'))
        ++at;
    if (at >= line.size())
        return true;
    const char c = upperCase(line[at]);
    return (c >= '@' && c <= 'Z') || c == '^' || c == '(' || c == ';' || c == '#';
}

/// The only code of a group in the block; null if there is none, or more than one.
const Word* onlyCode(const Execution& execution, ModalGroup group, int& count) {
    const Word* found = nullptr;
    count = 0;
    for (const Word& word : execution.block.codes()) {
        const CodeRow* row = execution.codes.find(word);
        if (row != nullptr && row->group == group) {
            found = &word;
            ++count;
        }
    }
    return count == 1 ? found : nullptr;
}

bool isPlainMotion(const CodeRow& row) {
    return row.handler == moveRapid || row.handler == moveFeed || row.handler == moveArcClockwise ||
           row.handler == moveArcCounterClockwise;
}

const CodeRow* motionAfter(const Execution& execution, bool codesKnown) {
    int count = 0;
    const Word* motion = onlyCode(execution, ModalGroup::motion, count);
    const CodeRow* before = execution.state.motion;
    if (!codesKnown || count > 1)
        return &kLostMotion;
    if (motion != nullptr) {
        const CodeRow* row = execution.codes.find(*motion);
        return isPlainMotion(*row) ? row : &kLostMotion;
    }
    if (before == nullptr || isPlainMotion(*before))
        return before;
    // The words of a hole stay in force for the next one, unless the block ends the cycle.
    onlyCode(execution, ModalGroup::motionOff, count);
    const CodeRow* ended = execution.dialect.rapidAfterG80 ? execution.codes.find('G', 0) : nullptr;
    return count > 0 ? ended : &kLostMotion;
}

/// G65 and similar codes: the letters are arguments of a macro.
bool hasArguments(const Execution& execution) {
    return std::ranges::any_of(execution.block.codes(), [&](const Word& word) {
        const CodeRow* row = execution.codes.find(word);
        return row != nullptr && row->axisUse == AxisUse::allWords;
    });
}

void keepLetter(Execution& execution, char letter, CodeHandler handler) {
    if (!hasArguments(execution) && execution.block.has(letter) && execution.block.value(letter) >= 0)
        handler(execution, execution.block.word(letter));
}

} // namespace

ReadableWords readableWords(std::string_view line) {
    ReadableWords words;
    for (std::size_t at = 0; at < line.size() && line[at] != ';';) {
        if (line[at] == '(') {
            at = std::min(line.find(')', at), line.size());
            continue;
        }
        if (line[at] == '[') {
            at = behindBracket(line, at);
            continue;
        }
        if (const std::size_t name = lettersFrom(line, at); name == 0 || name >= kShortestKeyword) {
            at += std::max<std::size_t>(name, 1);
            continue;
        }
        const char letter = upperCase(line[at]);
        const NumberRead number = readNumber(line, at + 1);
        const bool good = number.status == NumberStatus::good && endsNumber(line, number.end);
        const int length = static_cast<int>(number.end - at);
        const Word word{letter, number.value, static_cast<int>(at) + 1, length, number.point};
        if (!good || !words.block.add(word))
            words.codesKnown = words.codesKnown && letter != 'G';
        at = good ? number.end : at + 1;
    }
    return words;
}

void keepModes(Execution& execution, bool codesKnown) {
    for (const ModalGroup group : kModes) {
        // A tool is selected before it is changed; a change that waits for the end of compensation is not
        // made.
        if (group == ModalGroup::toolChange)
            keepLetter(execution, 'T', selectTool);
        const bool waits = execution.state.compensation.on &&
                           (group == ModalGroup::plane || group == ModalGroup::workOffset ||
                            group == ModalGroup::retract || group == ModalGroup::toolChange);
        const bool refused = waits || (group == ModalGroup::toolChange && execution.state.selectedTool < 0);
        int count = 0;
        const Word* word = refused ? nullptr : onlyCode(execution, group, count);
        const CodeRow* row = word == nullptr ? nullptr : execution.codes.find(*word);
        if (row != nullptr && row->supported() && row->letters.empty() && row->handler != nullptr)
            row->handler(execution, *word);
        if (group == ModalGroup::feedMode) {
            keepLetter(execution, 'F', setFeed);
            keepLetter(execution, 'S', setSpindleSpeed);
        }
    }
    execution.state.motion = motionAfter(execution, codesKnown);
}

bool isLost(const CodeRow* motion) {
    return motion == &kLostMotion;
}

} // namespace proveout

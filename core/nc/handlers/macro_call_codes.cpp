// SPDX-License-Identifier: GPL-3.0-or-later
// Calls of Fanuc's dialect: M97, M98, M99, G65, G66, G67. Source: FANUC's operator's manuals, Haas's.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/state/execution.h"
#include "core/nc/text/expression_rules.h"

namespace proveout {

namespace {

constexpr int kMostNumber = 99'999'999;
constexpr int kMostRepeats = 9999;
constexpr int kPacked = 10'000; ///< P51002 calls program 1002 five times

/// Local variables by letter, "@" first: A is #1. 0: the letter is not an argument. Argument list I.
constexpr std::array<int, 27> kArguments{0, 1, 2, 3,  7,  8,  9,  0,  11, 4,  5,  6,  0, 13,
                                         0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
constexpr int kFirstTriple = 4; ///< argument list II: I1 is #4, J1 #5, K1 #6, I2 #7 …
constexpr int kMostTriples = 10;

std::optional<int> whole(Execution& execution, const Word& word, int most) {
    if (word.value >= 0 && word.value <= most && word.value == std::round(word.value))
        return static_cast<int>(word.value);
    execution.reporter.report(nc_message::kNotInteger, word,
                              {std::string(1, word.letter), "0", std::to_string(most)});
    return {};
}

/// Reads the P and L words of a call; false if they are invalid.
bool readCall(Execution& execution, const Word& word, FlowRequest& request) {
    const Block& block = execution.block;
    request.name = block.called();
    if (!block.has('P') && request.name.empty()) {
        execution.reporter.report(nc_message::kWordMissing, word,
                                  {fmt::format("{}{:g}", word.letter, word.value), "P"});
        return false;
    }
    const auto program =
        request.name.empty() ? whole(execution, block.word('P'), kMostNumber) : std::optional(0);
    const auto repeats = block.has('L') ? whole(execution, block.word('L'), kMostRepeats) : std::optional(1);
    if (!program || !repeats)
        return false;
    request.program = *program;
    request.repeats = *repeats;
    request.word = request.name.empty() ? block.word('P') : word;
    return true;
}

/// The value that a word passes as an argument: without a decimal point in the least input increment of its
/// letter.
double argument(const Execution& execution, const Word& word) {
    constexpr LetterSet kLengths("IJKQRUVWXYZ");
    const double least = execution.state.inch ? execution.dialect.leastInch : execution.dialect.leastMm;
    return word.point || !kLengths.has(word.letter) ? word.value : word.value * least;
}

/// The arguments of a macro, in the order of their words: of two for one variable the later counts.
class Arguments {
public:
    explicit Arguments(const Execution& execution) : m_execution(execution) { m_values.fill(kNull); }

    [[nodiscard]] Parameters::Locals read(const Word& code) {
        const Block& block = m_execution.block;
        std::vector<Word> words(block.earlier().begin(), block.earlier().end());
        for (char letter = 'A'; letter <= 'Z'; ++letter) {
            if (letter != 'G' && letter != 'M' && block.has(letter))
                words.push_back(block.word(letter));
        }
        for (const Word& word : block.codes()) {
            if (word.letter == 'M')
                words.push_back(word);
        }
        std::ranges::sort(words, {}, &Word::column);
        for (const Word& word : words) {
            if (word.column > code.column)
                addArgument(word);
        }
        return m_values;
    }

private:
    void addArgument(const Word& word) {
        int number = kArguments[static_cast<std::size_t>(word.letter - '@')];
        if (word.letter >= 'I' && word.letter <= 'K')
            number = ofTriple(word.letter);
        if (number > 0)
            m_values[static_cast<std::size_t>(number - 1)] = argument(m_execution, word);
    }

    /// I, J and K may occur repeatedly: a letter that does not follow the last one begins the next triple.
    int ofTriple(char letter) {
        const int place = letter - 'I';
        if (place <= m_lastPlace)
            ++m_triple;
        m_lastPlace = place;
        return m_triple < kMostTriples ? kFirstTriple + 3 * m_triple + place : 0;
    }

    const Execution& m_execution;
    Parameters::Locals m_values{};
    int m_triple = 0;
    int m_lastPlace = -1;
};

void callMacroBy(Execution& execution, const Word& word, FlowRequest::Kind kind) {
    FlowRequest request;
    request.kind = kind;
    if (!readCall(execution, word, request))
        return;
    request.arguments = Arguments(execution).read(word);
    execution.request = request;
}

} // namespace

void callSubprogram(Execution& execution, const Word& word) {
    FlowRequest request;
    request.kind = FlowRequest::Kind::call;
    if (!readCall(execution, word, request))
        return;
    // Of more than four digits, the leading ones are the repeats unless L gives them.
    if (!execution.block.has('L') && request.program >= kPacked) {
        request.repeats = request.program / kPacked;
        request.program %= kPacked;
    }
    execution.request = request;
}

void callLocalSubprogram(Execution& execution, const Word& word) {
    FlowRequest request;
    request.kind = FlowRequest::Kind::callLocal;
    if (readCall(execution, word, request))
        execution.request = request;
}

void returnToBlock(Execution& execution, const Word& word) {
    FlowRequest request;
    request.kind = FlowRequest::Kind::returns;
    request.word = word;
    if (execution.block.has('P')) {
        const auto block = whole(execution, execution.block.word('P'), kMostNumber);
        if (!block)
            return;
        request.program = *block;
    }
    execution.request = request;
}

void callMacro(Execution& execution, const Word& word) {
    callMacroBy(execution, word, FlowRequest::Kind::macro);
}

void callMacroModally(Execution& execution, const Word& word) {
    callMacroBy(execution, word, FlowRequest::Kind::modalMacro);
}

void cancelModalMacro(Execution& execution, const Word& word) {
    execution.request.kind = FlowRequest::Kind::cancelModal;
    execution.request.word = word;
}

} // namespace proveout

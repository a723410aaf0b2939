// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/handlers.h"

#include <algorithm>
#include <string>

#include "core/base/text.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

constexpr LetterSet kWords("FIJKLNPRSTXYZ");
constexpr int kLargestToolOfGrbl = 255;
constexpr int kSystems = 6;

constexpr int kFeedLine = 10;
constexpr int kFirstArc = 20;
constexpr int kLastArc = 30;

class GrblBlock {
public:
    explicit GrblBlock(Execution& execution) : m_execution(execution), m_block(execution.block) {}

    bool mayRun() { return onlyKnown() && numbersFit() && codesAgree() && hasFeed() && hasWords(); }

private:
    bool refuse(const FindingRow& message, const Word& word, std::vector<Argument> arguments = {}) {
        m_execution.reporter.report(message, word, std::move(arguments));
        return false;
    }

    bool onlyKnown() {
        for (const Word& word : m_block.codes()) {
            if (m_execution.codes.find(word) == nullptr)
                return refuse(nc_message::kCodeForeign, word, {nameOf(word)});
        }
        for (const LetterRow& row : letters()) {
            if (m_block.has(row.letter) && !kWords.has(row.letter))
                return refuse(nc_message::kWordForeign, m_block.word(row.letter),
                              {std::string(1, row.letter)});
        }
        return true;
    }

    bool numbersFit() {
        for (const char letter : {'F', 'P', 'S', 'T'}) {
            if (m_block.has(letter) && m_block.value(letter) < 0)
                return refuse(nc_message::kNegative, m_block.word(letter), {std::string(1, letter)});
        }
        return !m_block.has('T') ||
               wholeNumber(m_execution, m_block.word('T'), 0, kLargestToolOfGrbl).has_value();
    }

    /// On grbl, G80 is in one group with the motions.
    bool codesAgree() {
        const Word* motion = codeOf(ModalGroup::motion);
        const Word* off = codeOf(ModalGroup::motionOff);
        if (motion == nullptr || off == nullptr)
            return true;
        const Word& first = motion->column < off->column ? *motion : *off;
        const Word& second = motion->column < off->column ? *off : *motion;
        return refuse(nc_message::kModalConflict, second, {nameOf(first), nameOf(second)});
    }

    /// Every motion except G0 needs a feed; without one its code does not take effect.
    bool hasFeed() {
        const CodeRow* row = motionRow();
        if (row == nullptr || row->tenths < kFeedLine)
            return true;
        const MachineState& state = m_execution.state;
        const Word* mode = codeOf(ModalGroup::feedMode);
        constexpr double kInverseTime = 93;
        const bool inverse =
            mode != nullptr ? mode->value == kInverseTime : state.feedMode == FeedMode::inverseTime;
        const bool kept = !inverse && state.feedMode == FeedMode::perMinute;
        const double feed = m_block.has('F') ? m_block.value('F') : kept ? state.feed : 0;
        return feed > 0 || refuse(inverse ? nc_message::kInverseTimeFeed : nc_message::kNoFeed, anyWord());
    }

    bool hasWords() {
        const CodeRow* row = motionRow();
        if (row != nullptr && row->tenths >= kFirstArc && row->tenths <= kLastArc && !namesPlane())
            return refuse(nc_message::kArcAxisMissing, anyWord());
        for (const Word& word : m_block.codes()) {
            if (word.letter == 'G' && !wordsOf(word))
                return false;
        }
        return true;
    }

    bool wordsOf(const Word& word) {
        const bool axes = m_block.letters().any(kAxisWords);
        constexpr double kG43dot1 = 43.1;
        if ((word.value == 10 || word.value == 92) && !axes)
            return refuse(nc_message::kWordMissing, word, {nameOf(word), "X"});
        if (word.value == 10)
            return offsetWords(word);
        if (word.value == kG43dot1 && (!m_block.has('Z') || m_block.letters().any(LetterSet("XY"))))
            return refuse(nc_message::kLengthAxis, word);
        return true;
    }

    bool offsetWords(const Word& word) {
        for (const char letter : {'L', 'P'}) {
            if (!m_block.has(letter))
                return refuse(nc_message::kWordMissing, word, {"G10", std::string(1, letter)});
        }
        const double kind = m_block.value('L');
        if (kind != 2 && kind != 20)
            return refuse(nc_message::kCodeForeign, m_block.word('L'), {"G10 " + nameOf(m_block.word('L'))});
        return wholeNumber(m_execution, m_block.word('P'), 0, kSystems).has_value();
    }

    /// The motion that the block programs or that its axis words continue; null if there is none.
    [[nodiscard]] const CodeRow* motionRow() const {
        if (const Word* word = codeOf(ModalGroup::motion))
            return m_execution.codes.find(*word);
        const bool taken = std::ranges::any_of(m_block.codes(), [&](const Word& word) {
            return m_execution.codes.find(word)->axisUse == AxisUse::takes;
        });
        return m_block.letters().any(kAxisWords) && !taken ? m_execution.state.motion : nullptr;
    }

    [[nodiscard]] const Word* codeOf(ModalGroup group) const {
        const auto found = std::ranges::find_if(
            m_block.codes(), [&](const Word& word) { return m_execution.codes.find(word)->group == group; });
        return found == m_block.codes().end() ? nullptr : &*found;
    }

    [[nodiscard]] bool namesPlane() const {
        constexpr double kG17 = 17;
        const Word* word = codeOf(ModalGroup::plane);
        const Plane plane = word == nullptr ? m_execution.state.plane
                                            : static_cast<Plane>(static_cast<int>(word->value - kG17));
        const PlaneAxes axis = axes(plane);
        return m_block.has(static_cast<char>('X' + axis.first)) ||
               m_block.has(static_cast<char>('X' + axis.second));
    }

    /// The word that a message about the motion points to.
    [[nodiscard]] Word anyWord() const {
        if (const Word* word = codeOf(ModalGroup::motion))
            return *word;
        for (const char letter : {'X', 'Y', 'Z'}) {
            if (m_block.has(letter))
                return m_block.word(letter);
        }
        return {'G', 0, 1, 0};
    }

    Execution& m_execution;
    const Block& m_block;
};

struct Answer {
    const FindingRow* message;
    const char* text;
};

constexpr const char* kAnswer20 = PROVEOUT_TEXT(
    "Core", "The control reports error:20 (unsupported command) and skips the block; remove it.");

// clang-format off
constexpr Answer kAnswers[] = {
    {&nc_message::kCodeForeign, kAnswer20},
    {&nc_message::kWordForeign, kAnswer20},
    {&nc_message::kBadCharacter, PROVEOUT_TEXT("Core", "The control reports error:1 (letter expected) and skips the block; remove the character.")},
    {&nc_message::kNumberMissing, PROVEOUT_TEXT("Core", "The control reports error:2 (bad number) and skips the block; write the number.")},
    {&nc_message::kDoubleSign, PROVEOUT_TEXT("Core", "The control reports error:2 (bad number) and skips the block; write one sign.")},
    {&nc_message::kTwoPoints, PROVEOUT_TEXT("Core", "The control reports error:2 (bad number) and skips the block; keep one point.")},
    {&nc_message::kNoExpressions, PROVEOUT_TEXT("Core", "The control reports error:1 or error:2 and skips the block; let the CAM system write plain numbers.")},
    {&nc_message::kNegative, PROVEOUT_TEXT("Core", "The control reports error:4 (negative value) and skips the block; correct the number.")},
    {&nc_message::kBlockNumberNegative, PROVEOUT_TEXT("Core", "The control reports error:4 (negative value) and skips the block; correct the number.")},
    {&nc_message::kModalConflict, PROVEOUT_TEXT("Core", "The control reports error:21 (two codes of one group) and skips the block; make two blocks.")},
    {&nc_message::kNoFeed, PROVEOUT_TEXT("Core", "The control reports error:22 (no feed rate) and skips the block, its motion code too; give F.")},
    {&nc_message::kInverseTimeFeed, PROVEOUT_TEXT("Core", "The control reports error:22 (no feed rate) and skips the block, its motion code too; give F.")},
    {&nc_message::kUnknownCode, PROVEOUT_TEXT("Core", "The control reports error:20 or error:23 and skips the block; remove the code.")},
    {&nc_message::kAxesTwice, PROVEOUT_TEXT("Core", "The control reports error:24 (two codes use the axis words) and skips the block; make two blocks.")},
    {&nc_message::kWordTwice, PROVEOUT_TEXT("Core", "The control reports error:25 (repeated word) and skips the block; make two blocks.")},
    {&nc_message::kWordMissing, PROVEOUT_TEXT("Core", "The control reports error:26 (no axis words) or error:28 (a word is missing) and skips the block; add the word.")},
    {&nc_message::kNotInteger, PROVEOUT_TEXT("Core", "The control reports error:29 to P of G10, error:38 to T, and skips the block; correct the number.")},
    {&nc_message::kMachineMotion, PROVEOUT_TEXT("Core", "The control reports error:30 (G53 needs G0 or G1) and skips the block; write G53 G0 or G53 G1.")},
    {&nc_message::kG80WithAxis, PROVEOUT_TEXT("Core", "The control reports error:31 (axis words without a motion) and skips the block; write G0 or G1.")},
    {&nc_message::kAxisWithoutMotion, PROVEOUT_TEXT("Core", "The control reports error:31 (axis words without a motion) and skips the block; write G0 or G1.")},
    {&nc_message::kArcAxisMissing, PROVEOUT_TEXT("Core", "The control reports error:26 or error:32 and skips the block; write the end point, also of a full circle.")},
    {&nc_message::kArcEndsDiffer, PROVEOUT_TEXT("Core", "The control reports error:33 (invalid target): the radii may differ by 0.005 mm, and by 0.1 % up to 0.5 mm; check the centre.")},
    {&nc_message::kArcFullWithRadius, PROVEOUT_TEXT("Core", "The control reports error:33 (invalid target) and skips the block; give a full circle its centre.")},
    {&nc_message::kProbeTooClose, PROVEOUT_TEXT("Core", "The control reports error:33 (invalid target) and skips the block; check the axis words.")},
    {&nc_message::kArcRadiusSmall, PROVEOUT_TEXT("Core", "The control reports error:34 (arc radius) and skips the block; check R and the end point.")},
    {&nc_message::kArcNoCentre, PROVEOUT_TEXT("Core", "The control reports error:35 (no centre in the plane) and skips the block; give I, J or K of the plane, or R.")},
    {&nc_message::kArcWrongWord, PROVEOUT_TEXT("Core", "The control reports error:35 (no centre in the plane) and skips the block; give I, J or K of the plane, or R.")},
    {&nc_message::kArcMixed, PROVEOUT_TEXT("Core", "The control reports error:36 (unused words) and skips the block; keep the centre or the radius.")},
    {&nc_message::kWordUnused, PROVEOUT_TEXT("Core", "The control reports error:36 (unused words) and skips the block; remove the word.")},
    {&nc_message::kLengthAxis, PROVEOUT_TEXT("Core", "The control reports error:37 and skips the block; write G43.1 Z… alone.")},
};
// clang-format on

} // namespace

bool mayRunOnGrbl(Execution& execution) {
    return GrblBlock(execution).mayRun();
}

const char* answerOfGrbl(const FindingRow& message) {
    const auto* row = std::ranges::find(kAnswers, &message, &Answer::message);
    return row == std::end(kAnswers) ? nullptr : row->text;
}

} // namespace proveout

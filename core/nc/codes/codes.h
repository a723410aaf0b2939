// SPDX-License-Identifier: GPL-3.0-or-later
// The codes of NC programs, as tables: the interpreter executes their rows, and the editor uses them for
// colours and help.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "core/nc/text/block.h"
#include "core/nc/text/dialect.h"

namespace proveout {

struct Execution;

/// Executes a code; the word is the one that programmed it.
using CodeHandler = void (*)(Execution&, const Word&);

/// A block may have only one code of each group.
enum class ModalGroup : std::uint8_t {
    nonModal,
    shiftEnd, ///< G92.1 to G92.3 of LinuxCNC, which may be in one block with a non-modal code
    motion,
    motionOff, ///< G80; LinuxCNC allows it in one block with a motion code, which then has priority
    plane,
    distance,
    arcDistance,
    feedMode,
    units,
    cutterCompensation,
    toolLength,
    retract,
    workOffset,
    pathControl,
    spindleMode,
    polar,
    scaling,
    mirroring,
    rotation,
    exactStop,
    lookAhead,
    diameterMode,
    macroCall,
    stop,
    inputOutput,
    toolChange,
    spindle,
    coolant,
    overrides,
    modalSave,
    subprogram,
    tapping,
    count
};

/// When a word takes effect within its block, regardless of its place in the text: in the order of this
/// enumeration. Source: LinuxCNC, order of execution.
enum class Step : std::uint8_t {
    feedMode,
    feedRate,
    spindleMode,
    spindleSpeed,
    toolSelection,
    inputOutput,
    toolChange,
    spindle,
    spindleOrientation,
    modalSave,
    tapping,
    coolant,
    overrides,
    dwell,
    plane,
    units,
    cutterCompensation,
    toolLength,
    workOffset,
    pathControl,
    lookAhead,
    distance,
    arcDistance,
    diameterMode,
    polar,
    retract,
    mirroring,
    scaling,
    rotation,
    nonModal, ///< G10, G28, G30, G52, G92
    shiftEnd, ///< G92.1 to G92.3
    macroCall,
    motion,
    spindleStop, ///< M5 and M9 of Fanuc take effect after the motion of their block
    coolantOff,
    stop,
    subprogram,
    count,
    none = count ///< has no effect by itself
};

/// How a code uses the axis words of its block.
enum class AxisUse : std::uint8_t {
    none,     ///< they belong to the motion in force
    takes,    ///< they belong to the code, which replaces the motion; if it is not supported, the axis
              ///< positions are unknown afterwards
    allAxes,  ///< as `takes`, and without axis words it moves every axis
    machine,  ///< they belong to the motion in force, but are machine coordinates
    allWords, ///< every word after the code is one of its arguments
};

/// Whether a code is allowed while cutter compensation is on.
enum class WithCompensation : std::uint8_t {
    allowed,
    refused,
    refusedBeside, ///< refused also while the tool is beside the path, which G40 alone does not change
};

struct CodeRow {
    char letter; ///< G or M
    int tenths;  ///< 382 is G38.2
    ModalGroup group;
    const char* name;              ///< marked with PROVEOUT_TEXT
    CodeHandler handler = nullptr; ///< null: known, but not supported yet
    Step step = Step::none;
    LetterSet letters = {}; ///< the words that it uses
    AxisUse axisUse = AxisUse::none;
    WithCompensation withCompensation = WithCompensation::allowed;
    bool ignored = false; ///< a function of the machine that moves no axis: reported, without effect

    [[nodiscard]] bool supported() const { return handler != nullptr || ignored; }
};

/// The meaning of the number of a word, which determines its unit.
enum class Quantity : std::uint8_t { number, length, angle, feed, speed };

/// A letter that is not a code, and the meaning of its number.
struct LetterRow {
    char letter;
    const char* name; ///< marked with PROVEOUT_TEXT
    Quantity quantity = Quantity::number;
    CodeHandler handler = nullptr; ///< if the word takes effect by itself
    Step step = Step::none;
};

/// The codes of one dialect. Immutable; any thread.
class CodeTable {
public:
    /// If several layers have a row with the same number, that of the last layer counts.
    CodeTable(std::initializer_list<std::span<const CodeRow>> layers);

    /// All rows, by letter and number.
    [[nodiscard]] std::span<const CodeRow* const> rows() const { return m_rows; }
    /// The row of a code, null if there is none. Constant time.
    [[nodiscard]] const CodeRow* find(char letter, int tenths) const;
    /// The row of the code that a G or M word means, null if there is none.
    [[nodiscard]] const CodeRow* find(const Word& word) const;

private:
    static constexpr int kTenths = 2000; ///< codes up to G199.9 and M199.9

    using Index = std::array<const CodeRow*, kTenths>;

    std::vector<const CodeRow*> m_rows;
    Index m_g{};
    Index m_m{};
};

[[nodiscard]] const CodeTable& codesOf(DialectId dialect);

/// All letters except G and M, and the signs of polar words, in ASCII order.
[[nodiscard]] std::span<const LetterRow> letters();

} // namespace proveout

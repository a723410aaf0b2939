// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/codes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "core/base/text.h"
#include "core/nc/codes/code_rows.h"
#include "core/nc/codes/handlers.h"

namespace proveout {

namespace {

constexpr LetterRow kLetters[] = {
    {'@', PROVEOUT_TEXT("Core", "polar radius"), Quantity::length},
    {'A', PROVEOUT_TEXT("Core", "rotary axis about X"), Quantity::angle},
    {'B', PROVEOUT_TEXT("Core", "rotary axis about Y"), Quantity::angle},
    {'C', PROVEOUT_TEXT("Core", "rotary axis about Z"), Quantity::angle},
    {'D', PROVEOUT_TEXT("Core", "cutter compensation number")},
    {'E', PROVEOUT_TEXT("Core", "parameter of a code")},
    {'F', PROVEOUT_TEXT("Core", "feed rate"), Quantity::feed, setFeed, Step::feedRate},
    {'H', PROVEOUT_TEXT("Core", "tool length offset number")},
    {'I', PROVEOUT_TEXT("Core", "arc centre in X"), Quantity::length},
    {'J', PROVEOUT_TEXT("Core", "arc centre in Y"), Quantity::length},
    {'K', PROVEOUT_TEXT("Core", "arc centre in Z"), Quantity::length},
    {'L', PROVEOUT_TEXT("Core", "repeats")},
    {'N', PROVEOUT_TEXT("Core", "block number")},
    {'O', PROVEOUT_TEXT("Core", "program number")},
    {'P', PROVEOUT_TEXT("Core", "dwell in seconds, turns of an arc, or a parameter")},
    {'Q', PROVEOUT_TEXT("Core", "parameter of a code")},
    {'R', PROVEOUT_TEXT("Core", "arc radius, or the R plane"), Quantity::length},
    {'S', PROVEOUT_TEXT("Core", "spindle speed in revolutions per minute"), Quantity::speed, setSpindleSpeed,
     Step::spindleSpeed},
    {'T', PROVEOUT_TEXT("Core", "tool number"), Quantity::number, selectTool, Step::toolSelection},
    {'U', PROVEOUT_TEXT("Core", "second axis along X"), Quantity::length},
    {'V', PROVEOUT_TEXT("Core", "second axis along Y"), Quantity::length},
    {'W', PROVEOUT_TEXT("Core", "second axis along Z"), Quantity::length},
    {'X', PROVEOUT_TEXT("Core", "X coordinate"), Quantity::length},
    {'Y', PROVEOUT_TEXT("Core", "Y coordinate"), Quantity::length},
    {'Z', PROVEOUT_TEXT("Core", "Z coordinate"), Quantity::length},
    {kChamferLetter, PROVEOUT_TEXT("Core", "chamfer"), Quantity::length},
    {kRoundingLetter, PROVEOUT_TEXT("Core", "corner radius"), Quantity::length},
    {'^', PROVEOUT_TEXT("Core", "polar angle in degrees"), Quantity::angle},
    {kSpindleLetter, PROVEOUT_TEXT("Core", "spindle number")},
};

} // namespace

CodeTable::CodeTable(std::initializer_list<std::span<const CodeRow>> layers) {
    for (const std::span<const CodeRow> layer : layers) {
        for (const CodeRow& row : layer)
            (row.letter == 'G' ? m_g : m_m)[static_cast<std::size_t>(row.tenths)] = &row;
    }
    for (const Index& index : {m_g, m_m})
        std::ranges::copy_if(index, std::back_inserter(m_rows), [](const CodeRow* row) { return row; });
}

const CodeRow* CodeTable::find(char letter, int tenths) const {
    if (tenths < 0 || tenths >= kTenths || (letter != 'G' && letter != 'M'))
        return nullptr;
    return (letter == 'G' ? m_g : m_m)[static_cast<std::size_t>(tenths)];
}

const CodeRow* CodeTable::find(const Word& word) const {
    const double tenths = word.value * 10;
    if (tenths < 0 || tenths >= kTenths || std::abs(tenths - std::round(tenths)) > 1e-6)
        return nullptr;
    return find(word.letter, static_cast<int>(std::lround(tenths)));
}

const CodeTable& codesOf(DialectId dialect) {
    static const CodeTable kLinuxcnc{foreignCodes(), basicCodes(), rs274Codes()};
    static const CodeTable kFanuc{basicCodes(), fanucCodes(), fanucFunctions()};
    static const CodeTable kHaas{basicCodes(), fanucCodes(), haasCodes(), haasFunctions()};
    static const CodeTable kGrbl{grblCodes()};
    static const CodeTable kMach{foreignCodes(), basicCodes(), machCodes()};
    switch (dialect) {
    case DialectId::fanuc:
        return kFanuc;
    case DialectId::haas:
        return kHaas;
    case DialectId::grbl:
        return kGrbl;
    case DialectId::mach:
        return kMach;
    case DialectId::linuxcnc:
    case DialectId::count:
        break;
    }
    return kLinuxcnc;
}

std::vector<CodeRow> sameRows(std::span<const CodeRow> all, char letter, std::initializer_list<int> tenths) {
    std::vector<CodeRow> rows;
    std::ranges::copy_if(all, std::back_inserter(rows), [&](const CodeRow& row) {
        return row.letter == letter && std::ranges::find(tenths, row.tenths) != tenths.end();
    });
    return rows;
}

std::span<const LetterRow> letters() {
    return kLetters;
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/modal_groups.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/nc/codes/dialects.h"
#include "core/nc/run/interpreter.h"

namespace proveout {
namespace {

/// Groups whose codes need no other word.
constexpr std::array kPlain{ModalGroup::plane,    ModalGroup::distance,    ModalGroup::arcDistance,
                            ModalGroup::feedMode, ModalGroup::units,       ModalGroup::retract,
                            ModalGroup::polar,    ModalGroup::spindleMode, ModalGroup::workOffset};

/// Haas' additional work offsets, and G70 and G71 of Mach, are shown by their usual name.
bool isOtherName(const CodeRow& row) {
    return row.tenths >= 1000 || (row.group == ModalGroup::units && row.tenths >= 700);
}

bool isPlain(const CodeRow& row) {
    return std::ranges::find(kPlain, row.group) != kPlain.end() && row.handler != nullptr &&
           row.letters.empty() && !isOtherName(row);
}

/// The active code of a group at the end of a program, as the control panel shows it.
std::string codeLeftBy(const std::string& text, const char* group, DialectId dialect) {
    InterpretOptions options;
    options.dialect = dialect;
    const auto program = interpret(NcText(text), options);
    for (const ControlState::Mode& mode : program->controlState().modes) {
        if (std::string(mode.group) == group)
            return mode.code;
    }
    return {};
}

TEST(ModalGroups, HaveTheirRows) {
    for (int i = 0; i < static_cast<int>(ModalGroup::count); ++i)
        EXPECT_EQ(rowOf(static_cast<ModalGroup>(i)).group, static_cast<ModalGroup>(i));
}

TEST(ModalGroups, ACodeThatWasExecutedIsTheOneInForce) {
    int codes = 0;
    for (const Dialect& dialect : dialects()) {
        for (const CodeRow* row : codesOf(dialect.id).rows()) {
            if (!isPlain(*row))
                continue;
            const std::string code = fmt::format("{}{:g}", row->letter, row->tenths / 10.0);
            EXPECT_EQ(codeLeftBy(code + "\nM2\n", nameOf(row->group), dialect.id).substr(0, code.size()),
                      code)
                << dialect.key;
            ++codes;
        }
    }
    EXPECT_GT(codes, 60);
}

TEST(ModalGroups, SavedStatesComeBackByTheCodesOfTheTable) {
    const std::string set = "G18 G91 G90.1 G93 G98 G59.2\n";
    const std::string others = "G17 G90 G91.1 G94 G99 G55\n";
    for (const ModalGroup group : {ModalGroup::plane, ModalGroup::distance, ModalGroup::arcDistance,
                                   ModalGroup::feedMode, ModalGroup::retract, ModalGroup::workOffset}) {
        const std::string before = codeLeftBy(set, nameOf(group), DialectId::linuxcnc);
        EXPECT_NE(before, "");
        EXPECT_NE(codeLeftBy(set + others, nameOf(group), DialectId::linuxcnc), before);
        EXPECT_EQ(codeLeftBy(set + "M70\n" + others + "M72\n", nameOf(group), DialectId::linuxcnc), before);
    }
}

} // namespace
} // namespace proveout

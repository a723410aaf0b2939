// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/modal_groups.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/nc/codes/dialects.h"
#include "core/nc/run/interpreter.h"

namespace proveout {
namespace {

/// Groups that the state keeps and the control panel does not show, or whose codes need other words.
constexpr std::array kOthers{ModalGroup::motion, ModalGroup::shiftEnd, ModalGroup::macroCall};

/// Haas' additional work offsets, and G70 and G71 of Mach, are shown by their usual name.
bool isOtherName(const CodeRow& row) {
    return (row.group == ModalGroup::workOffset && row.tenths >= 1000) ||
           (row.group == ModalGroup::units && row.tenths >= 700);
}

bool isPlain(const CodeRow& row) {
    return rowOf(row.group).inForce != nullptr && std::ranges::find(kOthers, row.group) == kOthers.end() &&
           row.handler != nullptr && row.letters.empty() && !isOtherName(row);
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
    for (int i = 0; i < static_cast<int>(ModalGroup::count); ++i) {
        const ModalGroupRow& row = rowOf(static_cast<ModalGroup>(i));
        EXPECT_EQ(row.group, static_cast<ModalGroup>(i));
        EXPECT_TRUE(row.readers == kReadByNone || row.inForce != nullptr) << row.name;
    }
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

/// The supported codes of LinuxCNC that need no other word, by the name of their group.
std::map<std::string, std::vector<std::string>> plainCodes() {
    std::map<std::string, std::vector<std::string>> codes;
    for (const CodeRow* row : codesOf(DialectId::linuxcnc).rows())
        if (isPlain(*row))
            codes[nameOf(row->group)].push_back(fmt::format("{}{:g}", row->letter, row->tenths / 10.0));
    return codes;
}

TEST(ModalGroups, SavedStatesComeBackByTheCodesOfTheTable) {
    int groups = 0;
    for (const auto& [group, codes] : plainCodes()) {
        for (std::size_t i = 1; i < codes.size(); ++i) {
            const std::string before = codes[i] + "\n";
            const std::string after = codes[i - 1] + "\n";
            EXPECT_EQ(codeLeftBy(before + after, group.c_str(), DialectId::linuxcnc), codes[i - 1]) << group;
            EXPECT_EQ(codeLeftBy(before + "M70\n" + after + "M72\n", group.c_str(), DialectId::linuxcnc),
                      codes[i])
                << group;
        }
        groups += codes.size() > 1 ? 1 : 0;
    }
    EXPECT_GE(groups, 7);
}

} // namespace
} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
// The table of what a check leaves out. A program is safe only if each entry that concerns it was accepted by
// name.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/nc/program/program.h"
#include "core/simulation/setup/check_rules.h"
#include "core/simulation/setup/machine.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

/// What decides whether an entry concerns a program.
struct CheckScope {
    const Program& program;
    const Setup& setup;
    const ToolChoice& tools;
    bool hasStock;          ///< it was run on a stock
    const Machine* machine; ///< its values; null: not given
    bool stockFitted;       ///< nobody has given the stock: it is fitted to the toolpath
};

struct NotCheckedRow {
    const char* id;    ///< stable, kebab-case
    const char* title; ///< what is not checked; marked with PROVEOUT_TEXT
    bool (*concerns)(const CheckScope& scope);
};
[[nodiscard]] std::span<const NotCheckedRow> notCheckedRows();

struct NotChecked {
    const NotCheckedRow* row = nullptr;
    bool accepted = false;
    std::string reason = {}; ///< why it is accepted; may be empty

    /// Sets both by the ids that are accepted.
    void accept(const IdsWithReasons& ids);
};
/// The entries that concern a program.
[[nodiscard]] std::vector<NotChecked> notChecked(const CheckScope& scope, const IdsWithReasons& accepted);

} // namespace proveout

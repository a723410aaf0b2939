// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about the tools that a simulation calls.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::tool_finding {

inline constexpr FindingRow kToolUnconfirmedComment{
    Severity::warning,
    true,
    "tool-unconfirmed",
    PROVEOUT_TEXT("Core", "Tool not confirmed"),
    PROVEOUT_TEXT("Core", "T{} is read from a comment (⌀ {} mm {}); it is not confirmed."),
    PROVEOUT_TEXT("Core", "Confirm the sizes of the tool in the tool table, or correct them.")};
inline constexpr FindingRow kToolUnconfirmedVague{
    Severity::warning,
    true,
    "tool-unconfirmed",
    PROVEOUT_TEXT("Core", "Tool not confirmed"),
    PROVEOUT_TEXT("Core", "T{} is read from a comment (⌀ {} mm {}; assumed: {}); it is not confirmed."),
    kToolUnconfirmedComment.hint};
inline constexpr FindingRow kToolUnconfirmedSizes{
    Severity::warning,
    true,
    "tool-unconfirmed",
    PROVEOUT_TEXT("Core", "Tool not confirmed"),
    PROVEOUT_TEXT("Core", "The sizes of T{} are assumed (⌀ {} mm {}); they are not confirmed."),
    kToolUnconfirmedComment.hint};
inline constexpr FindingRow kToolAssumed{
    Severity::warning,
    true,
    "tool-assumed",
    PROVEOUT_TEXT("Core", "Tool assumed"),
    PROVEOUT_TEXT("Core", "The program cuts before it calls a tool; T{} is assumed to be in the spindle."),
    PROVEOUT_TEXT("Core", "Set the tool at start in the setup if this is the right one.")};
inline constexpr FindingRow kToolAssumedOnly{
    Severity::warning,
    true,
    "tool-assumed",
    PROVEOUT_TEXT("Core", "Tool assumed"),
    PROVEOUT_TEXT("Core", "The program calls no tool; T{} is assumed to be in the spindle."),
    PROVEOUT_TEXT("Core", "Set the tool at start in the setup if this is the right one.")};
inline constexpr FindingRow kToolUndefined{
    Severity::error,
    true,
    "tool-undefined",
    PROVEOUT_TEXT("Core", "Tool not defined"),
    PROVEOUT_TEXT("Core", "T{} is not in the tool table; its moves are not simulated."),
    PROVEOUT_TEXT("Core", "Define it in the tool table.")};
inline constexpr FindingRow kNoTool{
    Severity::error,
    true,
    "no-tool",
    PROVEOUT_TEXT("Core", "No tool"),
    PROVEOUT_TEXT("Core", "The program cuts before it calls a tool; moves are not simulated until it does."),
    PROVEOUT_TEXT("Core", "Set the tool at start in the setup, or program T and M6 before the first cut.")};
inline constexpr FindingRow kNoToolEver{
    Severity::error,
    true,
    "no-tool",
    PROVEOUT_TEXT("Core", "No tool"),
    PROVEOUT_TEXT("Core", "The program calls no tool; its moves are not simulated."),
    PROVEOUT_TEXT("Core", "Set the tool at start in the setup, or program T and M6 before the first cut.")};
inline constexpr FindingRow kNoToolCalled{
    Severity::error,
    true,
    "no-tool",
    PROVEOUT_TEXT("Core", "No tool"),
    PROVEOUT_TEXT("Core", "T{} leaves the spindle empty; its moves are not simulated."),
    PROVEOUT_TEXT("Core", "Define T0 in the tool table if it is a cutter.")};

inline constexpr std::array kToolRows{&kToolUnconfirmedComment,
                                      &kToolUnconfirmedVague,
                                      &kToolUnconfirmedSizes,
                                      &kToolAssumed,
                                      &kToolAssumedOnly,
                                      &kToolUndefined,
                                      &kNoTool,
                                      &kNoToolEver,
                                      &kNoToolCalled};

} // namespace proveout::tool_finding

// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about expressions, parameters and variables.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kNestedTooDeep{
    Severity::error,
    true,
    "nested-too-deep",
    PROVEOUT_TEXT("Core", "Expression nested too deeply"),
    PROVEOUT_TEXT("Core", "The expression is nested deeper than 100 levels."),
    PROVEOUT_TEXT("Core", "Compute it in several steps.")};
inline constexpr FindingRow kBracketsTooDeep{
    Severity::error,
    true,
    "brackets-too-deep",
    PROVEOUT_TEXT("Core", "Brackets nested too deeply"),
    PROVEOUT_TEXT("Core", "More than five brackets are nested; the control gives alarm 118."),
    PROVEOUT_TEXT("Core", "Compute it in several steps.")};
inline constexpr FindingRow kParameterUnset{
    Severity::error,
    true,
    "parameter-unset",
    PROVEOUT_TEXT("Core", "Parameter not set"),
    PROVEOUT_TEXT("Core", "The parameter {} was never set."),
    PROVEOUT_TEXT("Core",
                  "Set it first; a name without _ at its front is known in its own subprogram only.")};
inline constexpr FindingRow kPositionHidden{
    Severity::error,
    true,
    "position-hidden",
    PROVEOUT_TEXT("Core", "Position not readable"),
    PROVEOUT_TEXT("Core", "The position {} cannot be read while cutter compensation is on."),
    PROVEOUT_TEXT("Core", "Write G40 before it.")};
inline constexpr FindingRow kParameterNotWhole{
    Severity::error,
    true,
    "parameter-not-whole",
    PROVEOUT_TEXT("Core", "Parameter number not whole"),
    PROVEOUT_TEXT("Core", "{} is not a whole number, so it is not a parameter number."),
    PROVEOUT_TEXT("Core", "Round it with FIX or ROUND.")};
inline constexpr FindingRow kParameterNumber{
    Severity::error,
    true,
    "parameter-number",
    PROVEOUT_TEXT("Core", "Unknown parameter number"),
    PROVEOUT_TEXT("Core", "There is no parameter with the number {}."),
    PROVEOUT_TEXT("Core", "Use another number, or a name.")};
inline constexpr FindingRow kParameterReadOnly{Severity::error,
                                               true,
                                               "parameter-read-only",
                                               PROVEOUT_TEXT("Core", "Read-only parameter"),
                                               PROVEOUT_TEXT("Core", "The parameter {} can be read only."),
                                               PROVEOUT_TEXT("Core", "Use another number.")};
inline constexpr FindingRow kNameUnclosed{Severity::error,
                                          true,
                                          "name-unclosed",
                                          PROVEOUT_TEXT("Core", "Name not closed"),
                                          PROVEOUT_TEXT("Core", "The name is not closed."),
                                          PROVEOUT_TEXT("Core", "Close it with \">\".")};
inline constexpr FindingRow kNameEmpty{Severity::error,
                                       true,
                                       "name-empty",
                                       PROVEOUT_TEXT("Core", "Empty name"),
                                       PROVEOUT_TEXT("Core", "The name is empty."),
                                       PROVEOUT_TEXT("Core", "Write a name between \"<\" and \">\".")};
inline constexpr FindingRow kNameLong{Severity::error,
                                      true,
                                      "name-long",
                                      PROVEOUT_TEXT("Core", "Name too long"),
                                      PROVEOUT_TEXT("Core", "The name has more than 256 characters."),
                                      PROVEOUT_TEXT("Core", "Use a shorter one.")};
inline constexpr FindingRow kNamesTooMany{
    Severity::error,
    true,
    "names-too-many",
    PROVEOUT_TEXT("Core", "Too many named parameters"),
    PROVEOUT_TEXT("Core", "The program has more than 100000 named parameters at once; {} was not set."),
    PROVEOUT_TEXT("Core", "Use fewer names, or numbers.")};
inline constexpr FindingRow kBracketUnclosed{Severity::error,
                                             true,
                                             "bracket-unclosed",
                                             PROVEOUT_TEXT("Core", "Bracket not closed"),
                                             PROVEOUT_TEXT("Core", "The bracket is not closed."),
                                             PROVEOUT_TEXT("Core", "Close it with \"]\" in the same line.")};
inline constexpr FindingRow kBracketMissing{Severity::error,
                                            true,
                                            "bracket-missing",
                                            PROVEOUT_TEXT("Core", "Brackets missing"),
                                            PROVEOUT_TEXT("Core", "{} has no argument in brackets."),
                                            PROVEOUT_TEXT("Core", "Write for example SIN[30].")};
inline constexpr FindingRow kOperatorMissing{
    Severity::error,
    true,
    "operator-missing",
    PROVEOUT_TEXT("Core", "Operator missing"),
    PROVEOUT_TEXT("Core", "Expected an operator or \"]\" but found \"{}\"."),
    PROVEOUT_TEXT("Core", "Check the expression.")};
inline constexpr FindingRow kNoResult{
    Severity::error,
    true,
    "no-result",
    PROVEOUT_TEXT("Core", "Expression without a result"),
    PROVEOUT_TEXT("Core", "{} has no result for these values."),
    PROVEOUT_TEXT("Core",
                  "Check for a division by zero, the root of a negative number, an arc sine beyond 1.")};
inline constexpr FindingRow kPairForm{Severity::error,
                                      true,
                                      "function-pair",
                                      PROVEOUT_TEXT("Core", "Second argument missing"),
                                      PROVEOUT_TEXT("Core", "{} needs two arguments."),
                                      PROVEOUT_TEXT("Core", "Write ATAN[y]/[x].")};
inline constexpr FindingRow kExistsForm{
    Severity::error,
    true,
    "exists-form",
    PROVEOUT_TEXT("Core", "EXISTS without a name"),
    PROVEOUT_TEXT("Core", "EXISTS asks for a named parameter: EXISTS[#<name>]."),
    PROVEOUT_TEXT("Core", "Write the name between \"<\" and \">\".")};
inline constexpr FindingRow kAssignmentForm{
    Severity::error,
    true,
    "assignment-form",
    PROVEOUT_TEXT("Core", "Incomplete assignment"),
    PROVEOUT_TEXT("Core", "{} is not followed by \"=\" and a value."),
    PROVEOUT_TEXT("Core", "A parameter at the beginning of a word is an assignment, for example #1=10.")};
inline constexpr FindingRow kVariableWithoutGroup{
    Severity::error,
    true,
    "variable-without-group",
    PROVEOUT_TEXT("Core", "Undocumented modal variable"),
    PROVEOUT_TEXT("Core", "{} belongs to no modal group of milling that the manuals name."),
    PROVEOUT_TEXT("Core", "Only the control knows its value; what follows from it is unverified.")};
inline constexpr FindingRow kMachineVariable{
    Severity::error,
    true,
    "variable-of-machine",
    PROVEOUT_TEXT("Core", "Machine-dependent variable"),
    PROVEOUT_TEXT("Core", "The value of {} depends on the machine that runs the program."),
    PROVEOUT_TEXT("Core", "What follows from it is unverified.")};
inline constexpr FindingRow kVariableAssumed{
    Severity::note,
    false,
    "variable-assumed",
    PROVEOUT_TEXT("Core", "Variable assumed to be 0"),
    PROVEOUT_TEXT("Core", "The value of {} is kept by the machine; it is assumed to be 0."),
    PROVEOUT_TEXT("Core", "Check the program with other values where a decision depends on it.")};
inline constexpr FindingRow kPositionUnknown{
    Severity::error,
    true,
    "position-unknown",
    PROVEOUT_TEXT("Core", "Position unknown"),
    PROVEOUT_TEXT("Core", "The position {} is not known here."),
    PROVEOUT_TEXT("Core", "Position the axis first, or enter a start position in the setup.")};
inline constexpr FindingRow kOffsetNumberWritten{
    Severity::warning,
    false,
    "offset-number-written",
    PROVEOUT_TEXT("Core", "#5220 written"),
    PROVEOUT_TEXT("Core", "Writing #5220 selects no work offset."),
    PROVEOUT_TEXT("Core", "Select it with G54 to G59.3, which write #5220 themselves.")};

inline constexpr std::array kExpressionRows{&kNestedTooDeep,
                                            &kBracketsTooDeep,
                                            &kParameterUnset,
                                            &kPositionHidden,
                                            &kParameterNotWhole,
                                            &kParameterNumber,
                                            &kParameterReadOnly,
                                            &kNameUnclosed,
                                            &kNameEmpty,
                                            &kNameLong,
                                            &kNamesTooMany,
                                            &kBracketUnclosed,
                                            &kBracketMissing,
                                            &kOperatorMissing,
                                            &kNoResult,
                                            &kPairForm,
                                            &kExistsForm,
                                            &kAssignmentForm,
                                            &kVariableWithoutGroup,
                                            &kMachineVariable,
                                            &kVariableAssumed,
                                            &kPositionUnknown,
                                            &kOffsetNumberWritten};

} // namespace proveout::nc_message

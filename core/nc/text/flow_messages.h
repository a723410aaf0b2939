// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about subprograms, branches, loops and jumps.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kLabelNotWhole{
    Severity::error,
    true,
    "label-not-whole",
    PROVEOUT_TEXT("Core", "Invalid O number"),
    PROVEOUT_TEXT("Core", "The number after O is not a whole number from 0 up."),
    PROVEOUT_TEXT("Core", "Use a whole number, or a name: O<name>.")};
inline constexpr FindingRow kFlowKeyword{
    Severity::error,
    true,
    "flow-keyword",
    PROVEOUT_TEXT("Core", "Unknown O-word keyword"),
    PROVEOUT_TEXT("Core", "\"{}\" is not an O-word keyword."),
    PROVEOUT_TEXT("Core", "Use sub, endsub, call, return, if, elseif, else, endif, do, while, endwhile, "
                          "repeat, endrepeat, break or continue.")};
inline constexpr FindingRow kFlowNotFirst{Severity::error,
                                          true,
                                          "flow-not-first",
                                          PROVEOUT_TEXT("Core", "O word not first"),
                                          PROVEOUT_TEXT("Core", "The O word does not begin the block."),
                                          PROVEOUT_TEXT("Core", "Put it on a line of its own.")};
inline constexpr FindingRow kFlowRest{
    Severity::error,
    true,
    "flow-rest",
    PROVEOUT_TEXT("Core", "Text after O word"),
    PROVEOUT_TEXT("Core", "Unexpected \"{}\" after the O word and its arguments."),
    PROVEOUT_TEXT("Core", "Put it on a line of its own.")};
inline constexpr FindingRow kFlowPartner{
    Severity::error,
    true,
    "flow-partner",
    PROVEOUT_TEXT("Core", "Unmatched O word"),
    PROVEOUT_TEXT("Core", "O{} {} has no matching {}."),
    PROVEOUT_TEXT("Core", "Both need the same label, in the same subprogram.")};
inline constexpr FindingRow kLabelTwice{
    Severity::error,
    true,
    "label-twice",
    PROVEOUT_TEXT("Core", "Duplicate O label"),
    PROVEOUT_TEXT("Core", "The label O{} is used already in line {} of this subprogram or main program."),
    PROVEOUT_TEXT("Core", "Give each branch and each loop a label of its own.")};
inline constexpr FindingRow kContinueInDo{
    Severity::warning,
    true,
    "continue-in-do",
    PROVEOUT_TEXT("Core", "Continue in a do loop"),
    PROVEOUT_TEXT("Core",
                  "After continue in a do loop, LinuxCNC may run a repeat loop twice as often as it says."),
    PROVEOUT_TEXT("Core", "Skip the rest of the pass with if and endif instead of continue.")};
inline constexpr FindingRow kSubNested{Severity::error,
                                       true,
                                       "sub-nested",
                                       PROVEOUT_TEXT("Core", "Nested subprogram"),
                                       PROVEOUT_TEXT("Core", "O{} sub is inside another subprogram."),
                                       PROVEOUT_TEXT("Core", "Close the other one with endsub before it.")};
inline constexpr FindingRow kFlowCondition{Severity::error,
                                           true,
                                           "flow-condition",
                                           PROVEOUT_TEXT("Core", "Condition missing"),
                                           PROVEOUT_TEXT("Core", "{} needs a condition in brackets."),
                                           PROVEOUT_TEXT("Core", "Write for example: O1 if [#1 GT 0].")};
inline constexpr FindingRow kSubUnknown{
    Severity::error,
    true,
    "sub-unknown",
    PROVEOUT_TEXT("Core", "Subprogram not found"),
    PROVEOUT_TEXT("Core", "There is no subprogram {}, in this file or as {}."),
    PROVEOUT_TEXT("Core", "Check the name and the folders of subprograms.")};
inline constexpr FindingRow kSubFolder{
    Severity::error,
    true,
    "sub-folder",
    PROVEOUT_TEXT("Core", "Subprogram outside its folders"),
    PROVEOUT_TEXT("Core", "The subprogram {} is not opened: its name leads outside the subprogram folders."),
    PROVEOUT_TEXT("Core", "Use a name without \"/\" and \"..\".")};
inline constexpr FindingRow kSubUnreadable{Severity::error,
                                           true,
                                           "sub-unreadable",
                                           PROVEOUT_TEXT("Core", "Subprogram not readable"),
                                           PROVEOUT_TEXT("Core", "The subprogram {} cannot be read: {}"),
                                           PROVEOUT_TEXT("Core", "Check the file.")};
inline constexpr FindingRow kSubEndMissing{Severity::error,
                                           true,
                                           "sub-end-missing",
                                           PROVEOUT_TEXT("Core", "Subprogram not closed"),
                                           PROVEOUT_TEXT("Core", "The file ends within the subprogram {}."),
                                           PROVEOUT_TEXT("Core", "Close it with endsub or M99.")};
inline constexpr FindingRow kCallTooDeep{
    Severity::error,
    true,
    "call-too-deep",
    PROVEOUT_TEXT("Core", "Calls nested too deeply"),
    PROVEOUT_TEXT("Core", "Subprograms call each other deeper than {} levels: {}."),
    PROVEOUT_TEXT("Core", "Check for a subprogram that calls itself endlessly.")};
inline constexpr FindingRow kTooManyArguments{Severity::error,
                                              true,
                                              "too-many-arguments",
                                              PROVEOUT_TEXT("Core", "Too many arguments"),
                                              PROVEOUT_TEXT("Core", "The call has more than 30 arguments."),
                                              PROVEOUT_TEXT("Core", "Pass the others in global parameters.")};
inline constexpr FindingRow kReturnOutside{
    Severity::error,
    true,
    "return-outside",
    PROVEOUT_TEXT("Core", "Return outside a subprogram"),
    PROVEOUT_TEXT("Core", "{} is outside a subprogram."),
    PROVEOUT_TEXT("Core", "Remove it, or put it between sub and endsub.")};
inline constexpr FindingRow kMainReturn{
    Severity::warning,
    false,
    "main-return",
    PROVEOUT_TEXT("Core", "Main program repeats"),
    PROVEOUT_TEXT("Core", "M99 ends the main program: the control restarts it, endlessly."),
    PROVEOUT_TEXT("Core", "It is run once here; use M30 if the program should end.")};
inline constexpr FindingRow kCalledNever{
    Severity::warning,
    true,
    "called-never",
    PROVEOUT_TEXT("Core", "M98 with L0"),
    PROVEOUT_TEXT("Core", "M98 with L0 runs nothing, but LinuxCNC then loses the named parameters of this "
                          "program and refuses the next subprogram."),
    PROVEOUT_TEXT("Core", "Leave out the call.")};
inline constexpr FindingRow kCallNotFirst{
    Severity::error,
    true,
    "call-not-first",
    PROVEOUT_TEXT("Core", "Call not first"),
    PROVEOUT_TEXT("Core", "{} does not begin its block; LinuxCNC looks for it there only."),
    PROVEOUT_TEXT("Core", "Put it first in the block.")};
inline constexpr FindingRow kReturnNotAlone{
    Severity::error,
    true,
    "return-not-alone",
    PROVEOUT_TEXT("Core", "M99 not alone"),
    PROVEOUT_TEXT("Core", "M99 is not alone in its block; LinuxCNC stops there with an error."),
    PROVEOUT_TEXT("Core", "Put it on a line of its own.")};
inline constexpr FindingRow kTooManyAgain{
    Severity::error,
    true,
    "too-many-again",
    PROVEOUT_TEXT("Core", "Too many repeated messages"),
    PROVEOUT_TEXT("Core", "Repeated lines gave {} messages; interpretation ends here."),
    PROVEOUT_TEXT("Core", "Correct what is wrong in the loop.")};
inline constexpr FindingRow kTooMuchRepeated{
    Severity::error,
    true,
    "too-many-steps",
    PROVEOUT_TEXT("Core", "Too many repeated blocks"),
    PROVEOUT_TEXT("Core", "The repeated lines and their motions exceed {}; interpretation ends in line {}."),
    PROVEOUT_TEXT("Core", "Check loops and repeat counts. The motions of this repetition are not shown.")};
inline constexpr FindingRow kIdleLoop{
    Severity::error,
    true,
    "loop-without-motion",
    PROVEOUT_TEXT("Core", "Loop without motion"),
    PROVEOUT_TEXT("Core",
                  "More than {} repeated lines in a row make no motion; interpretation ends in line {}."),
    PROVEOUT_TEXT("Core", "Check the loop for an end.")};
inline constexpr FindingRow kEndlessLoop{
    Severity::error,
    true,
    "endless-loop",
    PROVEOUT_TEXT("Core", "Endless loop"),
    PROVEOUT_TEXT("Core", "This loop never ends: line {} jumps back to line {} and no variable changes from "
                          "one pass to the next."),
    PROVEOUT_TEXT("Core", "Check the loop condition. Only the first passes are shown.")};
inline constexpr FindingRow kTooManyRounds{
    Severity::error,
    true,
    "too-many-rounds",
    PROVEOUT_TEXT("Core", "Too many repeats"),
    PROVEOUT_TEXT("Core", "{} repeats are more than the limit of {}; nothing is repeated here."),
    PROVEOUT_TEXT("Core", "Check the number of repeats.")};
inline constexpr FindingRow kBlockTooLong{
    Severity::error,
    true,
    "block-too-long",
    PROVEOUT_TEXT("Core", "Too many motions in block"),
    PROVEOUT_TEXT("Core", "This block makes {} motions, more than the limit of {}; it is not executed."),
    PROVEOUT_TEXT("Core", "Check the depth of the pecks, the step and the number of repeats.")};
inline constexpr FindingRow kBlockTarget{
    Severity::error,
    true,
    "block-target",
    PROVEOUT_TEXT("Core", "Invalid jump target"),
    PROVEOUT_TEXT("Core", "The jump target is not a whole number from 0 to 99999999."),
    PROVEOUT_TEXT("Core", "Jump to a block number that follows an N.")};
inline constexpr FindingRow kBlockUnknown{
    Severity::error,
    true,
    "block-unknown",
    PROVEOUT_TEXT("Core", "Jump target not found"),
    PROVEOUT_TEXT("Core", "There is no block N{} in this program."),
    PROVEOUT_TEXT("Core", "Check the number; a jump does not leave its program.")};
inline constexpr FindingRow kBlockTwice{
    Severity::error,
    true,
    "block-twice",
    PROVEOUT_TEXT("Core", "Duplicate block number"),
    PROVEOUT_TEXT("Core", "The program has N{} more than once; the jump goes to the one in line {}."),
    PROVEOUT_TEXT("Core", "Controls search in different directions; give each target a number of its own.")};
inline constexpr FindingRow kStatementForm{
    Severity::error,
    true,
    "statement-form",
    PROVEOUT_TEXT("Core", "Incomplete statement"),
    PROVEOUT_TEXT("Core", "The statement is not complete."),
    PROVEOUT_TEXT("Core", "Write IF [#1 GT 2] GOTO 10, IF [#1 GT 2] THEN #3=4, or WHILE [#1 GT 2] DO 1.")};
inline constexpr FindingRow kStatementNotFirst{
    Severity::error,
    true,
    "statement-not-first",
    PROVEOUT_TEXT("Core", "Statement not first"),
    PROVEOUT_TEXT("Core", "The statement does not begin the block."),
    PROVEOUT_TEXT("Core", "Put it on a line of its own.")};
inline constexpr FindingRow kLoopPartner{
    Severity::error,
    true,
    "loop-partner",
    PROVEOUT_TEXT("Core", "Unmatched loop"),
    PROVEOUT_TEXT("Core", "The loop has no matching {}."),
    PROVEOUT_TEXT("Core", "DO 1 needs END 1 in the same program; loops do not cross each other.")};
inline constexpr FindingRow kAlarm{
    Severity::error,
    true,
    "program-alarm",
    PROVEOUT_TEXT("Core", "Program alarm"),
    PROVEOUT_TEXT("Core", "The program stops itself with alarm {}."),
    PROVEOUT_TEXT("Core", "The comment beside it says why; the program ends here.")};
inline constexpr FindingRow kProgramRepeats{
    Severity::warning,
    false,
    "program-repeats",
    PROVEOUT_TEXT("Core", "Program repeats"),
    PROVEOUT_TEXT("Core", "M47 restarts the program, endlessly."),
    PROVEOUT_TEXT("Core", "It is run once here; use M30 if the program should end.")};

inline constexpr std::array kFlowRows{
    &kLabelNotWhole,     &kFlowKeyword,     &kFlowNotFirst,  &kFlowRest,      &kFlowPartner,
    &kLabelTwice,        &kContinueInDo,    &kSubNested,     &kFlowCondition, &kSubUnknown,
    &kSubFolder,         &kSubUnreadable,   &kSubEndMissing, &kCallTooDeep,   &kTooManyArguments,
    &kReturnOutside,     &kMainReturn,      &kCalledNever,   &kCallNotFirst,  &kReturnNotAlone,
    &kTooManyAgain,      &kTooMuchRepeated, &kIdleLoop,      &kEndlessLoop,   &kTooManyRounds,
    &kBlockTooLong,      &kBlockTarget,     &kBlockUnknown,  &kBlockTwice,    &kStatementForm,
    &kStatementNotFirst, &kLoopPartner,     &kAlarm,         &kProgramRepeats};

} // namespace proveout::nc_message

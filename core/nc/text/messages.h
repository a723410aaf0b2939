// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that the NC room has to tell its user. One row a message; ids are stable.
#pragma once

#include "core/base/diagnostic.h"
#include "core/base/text.h"

namespace proveout {

/// A diagnostic without its place and arguments.
struct Message {
    Severity severity;
    bool unverified;
    const char* id;
    const char* text;
    const char* hint;
};

namespace nc_message {

// Lines that cannot be read.
inline constexpr Message kBadCharacter{
    Severity::error, true, "bad-character", PROVEOUT_TEXT("Core", "\"{}\" has no meaning here."),
    PROVEOUT_TEXT("Core", "Remove the character, or put the text into a comment: ( … ).")};
inline constexpr Message kNumberMissing{
    Severity::error, true, "number-missing", PROVEOUT_TEXT("Core", "The word {} has no number."),
    PROVEOUT_TEXT("Core", "Write the number behind the letter, for example X10.5.")};
inline constexpr Message kDoubleSign{
    Severity::error, true, "number-double-sign", PROVEOUT_TEXT("Core", "The number of {} has two signs."),
    PROVEOUT_TEXT("Core", "Controls read this differently; write one sign.")};
inline constexpr Message kTwoPoints{Severity::error, true, "number-two-points",
                                    PROVEOUT_TEXT("Core", "The number of {} has two decimal points."),
                                    PROVEOUT_TEXT("Core", "Keep one point.")};
inline constexpr Message kNumberOutOfRange{
    Severity::error, true, "number-out-of-range",
    PROVEOUT_TEXT("Core", "The number of {} is out of range: larger than 1e12."),
    PROVEOUT_TEXT("Core", "Check the number.")};
inline constexpr Message kTargetTooFar{
    Severity::error, true, "target-too-far",
    PROVEOUT_TEXT("Core", "The motion ends farther than {} mm from the machine's zero, along {}."),
    PROVEOUT_TEXT("Core", "Check the numbers, the scaling and what is repeated.")};
inline constexpr Message kNestedTooDeep{
    Severity::error, true, "nested-too-deep",
    PROVEOUT_TEXT("Core", "The expression is nested deeper than 100 levels."),
    PROVEOUT_TEXT("Core", "Compute it in several steps.")};
inline constexpr Message kBracketsTooDeep{
    Severity::error, true, "brackets-too-deep",
    PROVEOUT_TEXT("Core", "More than five brackets stand within each other; the control gives alarm 118."),
    PROVEOUT_TEXT("Core", "Compute it in several steps.")};
inline constexpr Message kParameterUnset{
    Severity::error, true, "parameter-unset", PROVEOUT_TEXT("Core", "The parameter {} was never set."),
    PROVEOUT_TEXT("Core",
                  "Set it first; a name without _ at its front is known in its own subprogram only.")};
inline constexpr Message kPositionHidden{
    Severity::error, true, "position-hidden",
    PROVEOUT_TEXT("Core", "The position {} cannot be read while cutter compensation is on."),
    PROVEOUT_TEXT("Core", "Write G40 before it.")};
inline constexpr Message kParameterNotWhole{
    Severity::error, true, "parameter-not-whole",
    PROVEOUT_TEXT("Core", "{} is not a whole number, so that it names no parameter."),
    PROVEOUT_TEXT("Core", "Round it with FIX or ROUND.")};
inline constexpr Message kParameterNumber{Severity::error, true, "parameter-number",
                                          PROVEOUT_TEXT("Core", "There is no parameter with the number {}."),
                                          PROVEOUT_TEXT("Core", "Use another number, or a name.")};
inline constexpr Message kParameterReadOnly{Severity::error, true, "parameter-read-only",
                                            PROVEOUT_TEXT("Core", "The parameter {} can be read only."),
                                            PROVEOUT_TEXT("Core", "Use another number.")};
inline constexpr Message kNameUnclosed{Severity::error, true, "name-unclosed",
                                       PROVEOUT_TEXT("Core", "The name is not closed."),
                                       PROVEOUT_TEXT("Core", "Close it with \">\".")};
inline constexpr Message kNameEmpty{Severity::error, true, "name-empty",
                                    PROVEOUT_TEXT("Core", "The name is empty."),
                                    PROVEOUT_TEXT("Core", "Write a name between \"<\" and \">\".")};
inline constexpr Message kNameLong{Severity::error, true, "name-long",
                                   PROVEOUT_TEXT("Core", "The name has more than 256 characters."),
                                   PROVEOUT_TEXT("Core", "Use a shorter one.")};
inline constexpr Message kNamesTooMany{
    Severity::error, true, "names-too-many",
    PROVEOUT_TEXT("Core", "The program has more than 100000 named parameters at once; {} was not set."),
    PROVEOUT_TEXT("Core", "Use fewer names, or numbers.")};
inline constexpr Message kBracketUnclosed{Severity::error, true, "bracket-unclosed",
                                          PROVEOUT_TEXT("Core", "The bracket is not closed."),
                                          PROVEOUT_TEXT("Core", "Close it with \"]\" in the same line.")};
inline constexpr Message kBracketMissing{Severity::error, true, "bracket-missing",
                                         PROVEOUT_TEXT("Core", "{} has no argument in brackets."),
                                         PROVEOUT_TEXT("Core", "Write for example SIN[30].")};
inline constexpr Message kOperatorMissing{
    Severity::error, true, "operator-missing",
    PROVEOUT_TEXT("Core", "\"{}\" stands where an operator or \"]\" belongs."),
    PROVEOUT_TEXT("Core", "Check the expression.")};
inline constexpr Message kNoResult{
    Severity::error, true, "no-result", PROVEOUT_TEXT("Core", "{} has no result for these values."),
    PROVEOUT_TEXT("Core",
                  "Check for a division by zero, the root of a negative number, an arc sine beyond 1.")};
inline constexpr Message kPairForm{Severity::error, true, "function-pair",
                                   PROVEOUT_TEXT("Core", "{} needs two arguments."),
                                   PROVEOUT_TEXT("Core", "Write ATAN[y]/[x].")};
inline constexpr Message kExistsForm{
    Severity::error, true, "exists-form",
    PROVEOUT_TEXT("Core", "EXISTS asks for a named parameter: EXISTS[#<name>]."),
    PROVEOUT_TEXT("Core", "Write the name between \"<\" and \">\".")};
inline constexpr Message kAssignmentForm{
    Severity::error, true, "assignment-form",
    PROVEOUT_TEXT("Core", "{} is not followed by \"=\" and a value."),
    PROVEOUT_TEXT("Core", "A parameter at the beginning of a word is set, for example #1=10.")};
inline constexpr Message kLabelNotWhole{
    Severity::error, true, "label-not-whole",
    PROVEOUT_TEXT("Core", "The number behind O is no whole number from 0 on."),
    PROVEOUT_TEXT("Core", "Use a whole number, or a name: O<name>.")};
inline constexpr Message kFlowKeyword{
    Severity::error, true, "flow-keyword",
    PROVEOUT_TEXT("Core", "\"{}\" is none of the words that may follow an O word."),
    PROVEOUT_TEXT("Core", "sub, endsub, call, return, if, elseif, else, endif, do, while, endwhile, repeat, "
                          "endrepeat, break, continue.")};
inline constexpr Message kFlowNotFirst{Severity::error, true, "flow-not-first",
                                       PROVEOUT_TEXT("Core", "The O word does not begin the block."),
                                       PROVEOUT_TEXT("Core", "Put it on a line of its own.")};
inline constexpr Message kFlowRest{
    Severity::error, true, "flow-rest",
    PROVEOUT_TEXT("Core", "\"{}\" stands behind the O word and its arguments."),
    PROVEOUT_TEXT("Core", "Put it on a line of its own.")};
inline constexpr Message kFlowPartner{
    Severity::error, true, "flow-partner", PROVEOUT_TEXT("Core", "O{} {} has no {} that belongs to it."),
    PROVEOUT_TEXT("Core", "Both need the same label, in the same subprogram.")};
inline constexpr Message kLabelTwice{
    Severity::error, true, "label-twice",
    PROVEOUT_TEXT("Core", "The label O{} is used already in line {} of this subprogram or main program."),
    PROVEOUT_TEXT("Core", "Give each branch and each loop a label of its own.")};
inline constexpr Message kContinueInDo{
    Severity::warning, true, "continue-in-do",
    PROVEOUT_TEXT("Core",
                  "After continue in a do loop, LinuxCNC may run a repeat loop twice as often as it says."),
    PROVEOUT_TEXT("Core", "Leave out the rest of the round with if and endif in place of continue.")};
inline constexpr Message kSubNested{Severity::error, true, "sub-nested",
                                    PROVEOUT_TEXT("Core", "O{} sub stands within another subprogram."),
                                    PROVEOUT_TEXT("Core", "Close the other one with endsub before it.")};
inline constexpr Message kFlowCondition{Severity::error, true, "flow-condition",
                                        PROVEOUT_TEXT("Core", "{} needs a condition in brackets."),
                                        PROVEOUT_TEXT("Core", "Write for example: O1 if [#1 GT 0].")};
inline constexpr Message kSubUnknown{
    Severity::error, true, "sub-unknown",
    PROVEOUT_TEXT("Core", "There is no subprogram {}, in this file or as {}."),
    PROVEOUT_TEXT("Core", "Check the name and the folders of subprograms.")};
inline constexpr Message kSubFolder{
    Severity::error, true, "sub-folder",
    PROVEOUT_TEXT("Core",
                  "The subprogram {} is not opened: its name leads out of the folders of subprograms."),
    PROVEOUT_TEXT("Core", "Use a name without \"/\" and \"..\".")};
inline constexpr Message kSubUnreadable{Severity::error, true, "sub-unreadable",
                                        PROVEOUT_TEXT("Core", "The subprogram {} cannot be read: {}"),
                                        PROVEOUT_TEXT("Core", "Check the file.")};
inline constexpr Message kSubEndMissing{Severity::error, true, "sub-end-missing",
                                        PROVEOUT_TEXT("Core", "The file ends within the subprogram {}."),
                                        PROVEOUT_TEXT("Core", "Close it with endsub or M99.")};
inline constexpr Message kCallTooDeep{
    Severity::error, true, "call-too-deep",
    PROVEOUT_TEXT("Core", "Subprograms call each other deeper than {} levels: {}."),
    PROVEOUT_TEXT("Core", "Check for a subprogram that calls itself without end.")};
inline constexpr Message kTooManyArguments{Severity::error, true, "too-many-arguments",
                                           PROVEOUT_TEXT("Core", "The call has more than 30 arguments."),
                                           PROVEOUT_TEXT("Core", "Pass the others in global parameters.")};
inline constexpr Message kReturnOutside{
    Severity::error, true, "return-outside", PROVEOUT_TEXT("Core", "{} stands outside of a subprogram."),
    PROVEOUT_TEXT("Core", "Remove it, or put it between sub and endsub.")};
inline constexpr Message kMainReturn{
    Severity::warning, false, "main-return",
    PROVEOUT_TEXT("Core", "M99 ends the main program: the control starts it again, without end."),
    PROVEOUT_TEXT("Core", "It is run once here; end it with M30 if that was meant.")};
inline constexpr Message kCalledNever{
    Severity::warning, true, "called-never",
    PROVEOUT_TEXT("Core", "M98 with L0 runs nothing, but LinuxCNC then loses the named parameters of this "
                          "program and refuses the next subprogram."),
    PROVEOUT_TEXT("Core", "Leave out the call.")};
inline constexpr Message kCallNotFirst{
    Severity::error, true, "call-not-first",
    PROVEOUT_TEXT("Core", "{} does not begin its block; LinuxCNC looks for it there only."),
    PROVEOUT_TEXT("Core", "Put it first in the block.")};
inline constexpr Message kReturnNotAlone{
    Severity::error, true, "return-not-alone",
    PROVEOUT_TEXT("Core", "M99 is not alone in its block; LinuxCNC stops there with an error."),
    PROVEOUT_TEXT("Core", "Put it on a line of its own.")};
inline constexpr Message kTooManyAgain{
    Severity::error, true, "too-many-again",
    PROVEOUT_TEXT("Core", "Lines that repeat were told about {} times; interpretation ends here."),
    PROVEOUT_TEXT("Core", "Correct what is wrong in the loop.")};
inline constexpr Message kTooMuchRepeated{
    Severity::error, true, "too-many-steps",
    PROVEOUT_TEXT("Core",
                  "Repeated lines and their motions are more than {}; interpretation ends in line {}."),
    PROVEOUT_TEXT("Core", "Check loops and repeat counts. What this repetition makes is not shown.")};
inline constexpr Message kIdleLoop{
    Severity::error, true, "loop-without-motion",
    PROVEOUT_TEXT("Core",
                  "More than {} repeated lines in a row make no motion; interpretation ends in line {}."),
    PROVEOUT_TEXT("Core", "Check the loop for an end.")};
inline constexpr Message kEndlessLoop{
    Severity::error, true, "endless-loop",
    PROVEOUT_TEXT("Core",
                  "This loop never ends: line {} jumps back to line {} and no variable changes from one "
                  "round to the next."),
    PROVEOUT_TEXT("Core", "Check the condition of the loop. Only its first rounds are shown.")};
inline constexpr Message kTooManyRounds{
    Severity::error, true, "too-many-rounds",
    PROVEOUT_TEXT("Core", "{} repeats are more than the limit of {}; nothing is repeated here."),
    PROVEOUT_TEXT("Core", "Check the number of repeats.")};
inline constexpr Message kBlockTooLong{
    Severity::error, true, "block-too-long",
    PROVEOUT_TEXT("Core", "This block makes {} motions, more than the limit of {}; it is not executed."),
    PROVEOUT_TEXT("Core", "Check the depth of the pecks, the step and the number of repeats.")};
inline constexpr Message kBlockTarget{
    Severity::error, true, "block-target",
    PROVEOUT_TEXT("Core", "The target of the jump is no whole number from 0 to 99999999."),
    PROVEOUT_TEXT("Core", "Jump to a block number that stands behind an N.")};
inline constexpr Message kBlockUnknown{
    Severity::error, true, "block-unknown", PROVEOUT_TEXT("Core", "There is no block N{} in this program."),
    PROVEOUT_TEXT("Core", "Check the number; a jump does not leave its program.")};
inline constexpr Message kBlockTwice{
    Severity::error, true, "block-twice",
    PROVEOUT_TEXT("Core", "The program has N{} more than once; the jump goes to the one in line {}."),
    PROVEOUT_TEXT("Core", "Controls search in different directions; give each target a number of its own.")};
inline constexpr Message kVariableWithoutGroup{
    Severity::error, true, "variable-without-group",
    PROVEOUT_TEXT("Core", "{} belongs to no modal group of milling that the manuals name."),
    PROVEOUT_TEXT("Core",
                  "Only the control itself can tell its value; what follows from it cannot be verified.")};
inline constexpr Message kStatementForm{
    Severity::error, true, "statement-form", PROVEOUT_TEXT("Core", "The statement is not complete."),
    PROVEOUT_TEXT("Core", "Write IF [#1 GT 2] GOTO 10, IF [#1 GT 2] THEN #3=4, or WHILE [#1 GT 2] DO 1.")};
inline constexpr Message kStatementNotFirst{Severity::error, true, "statement-not-first",
                                            PROVEOUT_TEXT("Core", "The statement does not begin the block."),
                                            PROVEOUT_TEXT("Core", "Put it on a line of its own.")};
inline constexpr Message kLoopPartner{
    Severity::error, true, "loop-partner", PROVEOUT_TEXT("Core", "The loop has no {} with its number."),
    PROVEOUT_TEXT("Core", "DO 1 needs END 1 in the same program; loops do not cross each other.")};
inline constexpr Message kMachineVariable{
    Severity::error, true, "variable-of-machine",
    PROVEOUT_TEXT("Core", "The value of {} depends on the machine that runs the program."),
    PROVEOUT_TEXT("Core", "What follows from it cannot be verified.")};
inline constexpr Message kVariableAssumed{
    Severity::note, false, "variable-assumed",
    PROVEOUT_TEXT("Core", "The value of {} is kept by the machine; it is assumed to be 0."),
    PROVEOUT_TEXT("Core", "Check the program with other values where a decision depends on it.")};
inline constexpr Message kPositionUnknown{
    Severity::error, true, "position-unknown", PROVEOUT_TEXT("Core", "The position {} is not known here."),
    PROVEOUT_TEXT("Core", "Position the axis first, or state a start position in the setup.")};
inline constexpr Message kAlarm{
    Severity::error, true, "program-alarm", PROVEOUT_TEXT("Core", "The program stops itself with alarm {}."),
    PROVEOUT_TEXT("Core", "The comment beside it says why; nothing behind it is run.")};
inline constexpr Message kDialectGuessed{
    Severity::note, false, "dialect-guessed", PROVEOUT_TEXT("Core", "Dialect detected: {} (from {})."),
    PROVEOUT_TEXT("Core", "Choose the dialect yourself if that is wrong.")};
inline constexpr Message kDialectForeign{
    Severity::error, true, "dialect-foreign",
    PROVEOUT_TEXT("Core", "This is {} (line {}: {}), which Proveout does not read."),
    PROVEOUT_TEXT("Core", "Post-process it for LinuxCNC, Fanuc, Haas, grbl or Mach3 / Mach4; if it is one of "
                          "these after all, choose the dialect.")};
inline constexpr Message kNotAProgram{
    Severity::error, true, "not-a-program",
    PROVEOUT_TEXT("Core", "This is {} (line {}: {}), not an NC program."),
    PROVEOUT_TEXT("Core", "Open the program that the machine would run; if this is it, choose its dialect.")};
inline constexpr Message kTextBeforePercent{
    Severity::note, false, "text-before-percent",
    PROVEOUT_TEXT("Core", "The text before the first \"%\" is not run."), ""};
inline constexpr Message kLastCounts{
    Severity::warning, false, "last-counts",
    PROVEOUT_TEXT("Core", "{} and {} exclude each other in one block; the last one counts."),
    PROVEOUT_TEXT("Core", "Some controls give an alarm instead; keep one of them.")};
inline constexpr Message kLastWordCounts{
    Severity::warning, false, "last-word-counts",
    PROVEOUT_TEXT("Core", "The block has two {} words; the last one counts."),
    PROVEOUT_TEXT("Core", "Some controls give an alarm instead; keep one of them.")};
inline constexpr Message kWordIgnored{
    Severity::warning, true, "word-ignored",
    PROVEOUT_TEXT("Core", "No code of this block uses the word {}; it is ignored."),
    PROVEOUT_TEXT("Core", "Remove it, or add the code that it belongs to.")};
inline constexpr Message kRapidAfterG80{
    Severity::warning, false, "rapid-after-g80",
    PROVEOUT_TEXT("Core", "Behind G80 the axis {} moves without a motion code: in rapid."),
    PROVEOUT_TEXT("Core", "Write G0 or G1 into the block; controls differ here.")};
inline constexpr Message kNoPoint{
    Severity::warning, false, "no-decimal-point",
    PROVEOUT_TEXT(
        "Core", "{} has no decimal point: the control reads it as {}; one with calculator-type input as {}."),
    PROVEOUT_TEXT("Core", "Write the decimal point.")};
inline constexpr Message kCommentUnclosed{Severity::error, true, "comment-unclosed",
                                          PROVEOUT_TEXT("Core", "The comment is not closed."),
                                          PROVEOUT_TEXT("Core", "Close it with \")\" in the same line.")};
inline constexpr Message kCommentNested{
    Severity::error, true, "comment-nested", PROVEOUT_TEXT("Core", "A comment stands within a comment."),
    PROVEOUT_TEXT("Core", "Controls end it at different brackets; use no \"(\" within a comment.")};
inline constexpr Message kWordTwice{Severity::error, true, "word-twice",
                                    PROVEOUT_TEXT("Core", "The block has two {} words."),
                                    PROVEOUT_TEXT("Core", "Keep one of them, or make two blocks.")};
inline constexpr Message kTooManyCodes{Severity::error, true, "too-many-codes",
                                       PROVEOUT_TEXT("Core", "The block has more than 24 G and M words."),
                                       PROVEOUT_TEXT("Core", "Make several blocks of it.")};
inline constexpr Message kBlockNumberPlace{
    Severity::error, true, "n-not-first", PROVEOUT_TEXT("Core", "The N word does not begin the block."),
    PROVEOUT_TEXT("Core", "Write it first, or put it on a line of its own.")};
inline constexpr Message kBlockNumberNegative{Severity::error, true, "n-negative",
                                              PROVEOUT_TEXT("Core", "The block number is negative."),
                                              PROVEOUT_TEXT("Core", "Use N with digits only.")};
inline constexpr Message kPercentNotAlone{
    Severity::error, true, "percent-not-alone",
    PROVEOUT_TEXT("Core",
                  "\"%\" marks the beginning and the end of a tape and must stand on a line of its own."),
    PROVEOUT_TEXT("Core", "Move the rest to another line.")};

// The file as a whole.
inline constexpr Message kPercentUnpaired{
    Severity::warning, false, "percent-unpaired",
    PROVEOUT_TEXT("Core", "The program ends with \"%\" but does not begin with it."),
    PROVEOUT_TEXT("Core", "LinuxCNC refuses this; write \"%\" on the first line too, or on none.")};
inline constexpr Message kPercentInside{
    Severity::error, true, "percent-inside",
    PROVEOUT_TEXT("Core", "\"%\" stands in the middle of the program."),
    PROVEOUT_TEXT("Core",
                  "Controls skip what is before it, or what is behind it; keep one program in a file.")};
inline constexpr Message kAfterPercent{Severity::note, false, "after-percent",
                                       PROVEOUT_TEXT("Core", "The text behind the second \"%\" is not run."),
                                       ""};
inline constexpr Message kAfterEnd{
    Severity::note, false, "after-program-end",
    PROVEOUT_TEXT("Core", "The blocks behind the end of the program are not run."), ""};
inline constexpr Message kNoProgramEnd{
    Severity::warning, false, "no-program-end",
    PROVEOUT_TEXT("Core", "The program has no end: M2, M30 or a pair of \"%\"."),
    PROVEOUT_TEXT("Core", "Add M30 as the last block.")};
inline constexpr Message kNoMotion{
    Severity::warning, true, "no-motion", PROVEOUT_TEXT("Core", "The program has no motion."),
    PROVEOUT_TEXT("Core", "Check that this is the right file and that it is complete.")};
inline constexpr Message kControlCode{
    Severity::warning, false, "control-code",
    PROVEOUT_TEXT("Core", "Control codes of a tape or a serial line were skipped."),
    PROVEOUT_TEXT("Core", "Harmless here; save the file as plain text to be rid of them.")};
inline constexpr Message kByteOrderMark{
    Severity::warning, false, "byte-order-mark",
    PROVEOUT_TEXT("Core", "The file begins with a byte order mark, which controls refuse."),
    PROVEOUT_TEXT("Core", "Save it as UTF-8 without the mark, or as ASCII.")};
inline constexpr Message kLoneCr{
    Severity::warning, false, "cr-line-end",
    PROVEOUT_TEXT("Core", "The line ends with CR alone, which LinuxCNC takes for no line end."),
    PROVEOUT_TEXT("Core", "Save the file with LF or CR LF line ends.")};
inline constexpr Message kLineLong{
    Severity::warning, false, "line-long",
    PROVEOUT_TEXT("Core", "The line has {} characters; LinuxCNC refuses more than 252."),
    PROVEOUT_TEXT("Core", "Split the line.")};
inline constexpr Message kBlockNumberLong{
    Severity::warning, false, "n-long",
    PROVEOUT_TEXT("Core", "The block number has more than 15 digits, which controls cannot hold."),
    PROVEOUT_TEXT("Core", "It is a label only; number the blocks anew.")};
inline constexpr Message kTooManyMotions{
    Severity::error, true, "too-many-motions",
    PROVEOUT_TEXT("Core", "The program has more than {} motions; interpretation ends here."),
    PROVEOUT_TEXT("Core", "Raise the limit, or split the program.")};
inline constexpr Message kProgramTooLarge{
    Severity::error, true, "program-too-large",
    PROVEOUT_TEXT("Core",
                  "The motions of the program need more than {} of memory; interpretation ends here."),
    PROVEOUT_TEXT("Core", "Close other programs, or split the program.")};
inline constexpr Message kTooManyEvents{
    Severity::error, true, "too-many-events",
    PROVEOUT_TEXT("Core", "The program has more than {} tool changes, stops, dwells and the like; "
                          "interpretation ends here."),
    PROVEOUT_TEXT("Core", "Raise the limit, or split the program.")};
inline constexpr Message kTooManyMessages{Severity::warning, false, "too-many-messages",
                                          PROVEOUT_TEXT("Core", "{} more messages are not shown."), ""};
inline constexpr Message kStopped{
    Severity::warning, true, "interpretation-stopped",
    PROVEOUT_TEXT("Core", "Interpretation was stopped before this line; the last one was {}."), ""};
inline constexpr Message kStillReading{
    Severity::note, true, "still-reading",
    PROVEOUT_TEXT("Core", "The program is still being read; what stands from this line on is missing."), ""};

// Codes.
inline constexpr Message kUnknownCode{
    Severity::error, true, "code-unknown", PROVEOUT_TEXT("Core", "{} is not a known code."),
    PROVEOUT_TEXT("Core", "Without its effect nothing behind it can be vouched for.")};
inline constexpr Message kUnknownMCode{
    Severity::error, true, "code-unknown", PROVEOUT_TEXT("Core", "{} is not a known code."),
    PROVEOUT_TEXT("Core", "If it moves no axis (a clamp, a door, air), add it to the ignored M codes of the "
                          "setup; until then, results after this block are unverified.")};
inline constexpr Message kCodeIgnored{
    Severity::note, false, "code-ignored",
    PROVEOUT_TEXT("Core", "{} ({}) moves no axis and is ignored ({}×, line {})."),
    PROVEOUT_TEXT("Core", "The machine builder gives M codes their meaning; check it where it matters.")};
inline constexpr Message kCodeIgnoredByList{
    Severity::note, false, "code-ignored",
    PROVEOUT_TEXT("Core", "{} is ignored, because the setup lists it ({}×, line {})."),
    PROVEOUT_TEXT("Core", "Remove it from the ignored M codes if it moves an axis.")};
inline constexpr Message kCodeIgnoredInLines{
    Severity::note, false, kCodeIgnored.id,
    PROVEOUT_TEXT("Core", "{} ({}) moves no axis and is ignored ({}×, lines {})."), kCodeIgnored.hint};
inline constexpr Message kCodeIgnoredByListInLines{
    Severity::note, false, kCodeIgnoredByList.id,
    PROVEOUT_TEXT("Core", "{} is ignored, because the setup lists it ({}×, lines {})."),
    kCodeIgnoredByList.hint};
inline constexpr Message kIgnoredExecuted{
    Severity::warning, false, "ignored-code-executed",
    PROVEOUT_TEXT("Core", "{} ({}) is executed, although the setup lists it as ignored."),
    PROVEOUT_TEXT("Core", "Remove it from the ignored M codes: only codes without a known effect can be "
                          "ignored.")};
inline constexpr Message kUnsupportedCode{
    Severity::error, true, "code-unsupported", PROVEOUT_TEXT("Core", "{} ({}) is not supported yet."),
    PROVEOUT_TEXT("Core", "Without its effect nothing behind it can be vouched for.")};
inline constexpr Message kModalConflict{
    Severity::error, true, "modal-conflict",
    PROVEOUT_TEXT("Core", "{} and {} exclude each other in one block."),
    PROVEOUT_TEXT("Core", "Keep one of them, or make two blocks; this block is skipped.")};
inline constexpr Message kTooManyM{
    Severity::error, true, "too-many-m", PROVEOUT_TEXT("Core", "The block has more than {} M words."),
    PROVEOUT_TEXT("Core", "Make several blocks of it; this block is skipped.")};
inline constexpr Message kAxisUnsupported{
    Severity::error, true, "axis-unsupported",
    PROVEOUT_TEXT("Core", "The axis {} does not exist on a three-axis machine."),
    PROVEOUT_TEXT("Core", "The motion is shown without it.")};
inline constexpr Message kWordUnused{
    Severity::error, true, "word-unused", PROVEOUT_TEXT("Core", "No code of this block uses the word {}."),
    PROVEOUT_TEXT("Core", "Remove it, or add the code that it belongs to; this block is skipped.")};
inline constexpr Message kSpindleNumber{
    Severity::error, true, "spindle-number",
    PROVEOUT_TEXT("Core", "There is no spindle {}: the machine has one, $0."),
    PROVEOUT_TEXT("Core", "Write $0, or leave the word out; this block is skipped.")};
inline constexpr Message kOffsetNumberWritten{
    Severity::warning, false, "offset-number-written",
    PROVEOUT_TEXT("Core", "Writing #5220 selects no work offset."),
    PROVEOUT_TEXT("Core", "Select it with G54 to G59.3, which write #5220 themselves.")};
inline constexpr Message kLengthTwice{
    Severity::error, true, "length-twice", PROVEOUT_TEXT("Core", "G43.2 has both H and axis words."),
    PROVEOUT_TEXT("Core", "Write two blocks; the offset in force is kept.")};
inline constexpr Message kAxisWithoutMotion{
    Severity::error, true, "axis-without-motion",
    PROVEOUT_TEXT("Core", "No motion code is in force for the word {}."),
    PROVEOUT_TEXT("Core", "Write G0, G1, G2 or G3 into the block; this block is skipped.")};
inline constexpr Message kG80WithAxis{
    Severity::error, true, "g80-with-axis", PROVEOUT_TEXT("Core", "G80 cannot move the axis {}."),
    PROVEOUT_TEXT("Core", "Controls differ here; move in a block of its own. This block is skipped.")};
inline constexpr Message kWordMissing{Severity::error, true, "word-missing",
                                      PROVEOUT_TEXT("Core", "{} needs the word {}."),
                                      PROVEOUT_TEXT("Core", "Add it; the code has no effect without it.")};
inline constexpr Message kNegative{Severity::error, true, "number-negative",
                                   PROVEOUT_TEXT("Core", "The number of {} must not be negative."),
                                   PROVEOUT_TEXT("Core", "The word is ignored.")};
inline constexpr Message kNotInteger{
    Severity::error, true, "number-not-integer",
    PROVEOUT_TEXT("Core", "The number of {} must be a whole number from {} to {}."),
    PROVEOUT_TEXT("Core", "The word is ignored.")};
inline constexpr Message kOffsetKind{Severity::error, true, "offset-kind",
                                     PROVEOUT_TEXT("Core", "G10 with L{} is not supported."),
                                     PROVEOUT_TEXT("Core", "Supported are L1, L2, L10, L11 and L20.")};
inline constexpr Message kOffsetUnknown{
    Severity::error, true, "offset-unknown", PROVEOUT_TEXT("Core", "No tool has the number {}."),
    PROVEOUT_TEXT("Core", "Add it to the tool table, or correct the number.")};
inline constexpr Message kAxesTwice{Severity::error, true, "axes-used-twice",
                                    PROVEOUT_TEXT("Core", "{} and {} both use the axis words of this block."),
                                    PROVEOUT_TEXT("Core", "Make two blocks; this block is skipped.")};
inline constexpr Message kMachineMotion{
    Severity::error, true, "machine-coordinates-motion",
    PROVEOUT_TEXT("Core", "G53 needs G0 or G1 in force."),
    PROVEOUT_TEXT("Core", "Write G53 G0 or G53 G1; this block is skipped.")};
inline constexpr Message kPolarMixed{Severity::error, true, "polar-mixed",
                                     PROVEOUT_TEXT("Core", "The block has polar words (@ ^) and X or Y."),
                                     PROVEOUT_TEXT("Core", "Keep one kind; this block is skipped.")};
inline constexpr Message kPolarOrigin{
    Severity::error, true, "polar-origin",
    PROVEOUT_TEXT("Core", "{} counts from the current angle, and there is no angle at X0 Y0."),
    PROVEOUT_TEXT("Core", "Give both @ and ^ in G90; this motion is skipped.")};
inline constexpr Message kMachinePolar{Severity::error, true, "machine-coordinates-polar",
                                       PROVEOUT_TEXT("Core", "G53 cannot be used with polar words."),
                                       PROVEOUT_TEXT("Core", "Write X and Y; this block is skipped.")};
inline constexpr Message kMachineIncremental{
    Severity::error, true, "machine-coordinates-incremental",
    PROVEOUT_TEXT("Core", "G53 cannot be used with incremental distances."),
    PROVEOUT_TEXT("Core", "Write G90 before it; this block is skipped.")};
inline constexpr Message kReferenceUnknown{
    Severity::note, false, "reference-unknown",
    PROVEOUT_TEXT("Core", "Machine zero is unknown, so {} has no position; motions are not simulated until "
                          "the axis is positioned again."),
    PROVEOUT_TEXT("Core", "Motions to reference positions are taken to lead away from the part.")};
inline constexpr Message kArcTurned{
    Severity::error, true, "arc-turned",
    PROVEOUT_TEXT(
        "Core", "G68 turns another plane than that of the arc, which then lies in no plane of the machine."),
    PROVEOUT_TEXT("Core", "Keep the plane that was in force at G68.")};
inline constexpr Message kArcScaled{
    Severity::error, true, "arc-scaled",
    PROVEOUT_TEXT("Core",
                  "Scaled by different factors along the axes of its plane, the arc is none any more."),
    PROVEOUT_TEXT("Core", "Use one factor for both axes, or let the CAM system write it as lines.")};
inline constexpr Message kScaleFactor{Severity::error, true, "scale-factor",
                                      PROVEOUT_TEXT("Core", "The scale factor of {} must not be 0."),
                                      PROVEOUT_TEXT("Core", "Check the number; the code has no effect.")};
inline constexpr Message kTransformationOrder{
    Severity::warning, true, "transformation-order",
    PROVEOUT_TEXT("Core",
                  "{} stands within {}: the control wants mirror image, scaling and rotation begun in "
                  "this order and ended in the opposite one."),
    PROVEOUT_TEXT("Core", "End the inner one first.")};
inline constexpr Message kCentreUnknown{
    Severity::warning, true, "centre-unknown",
    PROVEOUT_TEXT("Core", "The centre of {} is where the tool stands, which is not known for {}."),
    PROVEOUT_TEXT("Core", "Write the centre, or position the tool before.")};
inline constexpr Message kRotationOneAxis{
    Severity::warning, true, "rotation-one-axis",
    PROVEOUT_TEXT("Core", "The first motion behind {} does not say where both axes of the rotation go; "
                          "controls differ here."),
    PROVEOUT_TEXT("Core", "Position both axes in G90 behind it.")};
inline constexpr Message kRotationSetting{
    Severity::warning, true, "rotation-setting",
    PROVEOUT_TEXT("Core", "A setting of the control says whether G68 with G91 adds its angle to the one in "
                          "force (Fanuc: parameter 5400#0, Haas: setting 73); here the angle is {} degrees."),
    PROVEOUT_TEXT("Core", "Write G90 before G68, or G69 between them.")};
inline constexpr Message kReferenceInCycle{
    Severity::error, true, "reference-in-cycle",
    PROVEOUT_TEXT("Core", "{} stands within a canned cycle (alarm 044)."),
    PROVEOUT_TEXT("Core", "End the cycle with G80 before it.")};
inline constexpr Message kMachineIgnored{
    Severity::warning, true, "machine-coordinates-ignored",
    PROVEOUT_TEXT("Core", "G53 is ignored with incremental distances; nothing moves."),
    PROVEOUT_TEXT("Core", "Write G90 before it.")};
inline constexpr Message kDataKind{Severity::error, true, "data-kind",
                                   PROVEOUT_TEXT("Core", "G10 with L{} is not supported."),
                                   PROVEOUT_TEXT("Core", "Supported are L1, L2, L10 to L13 and L20.")};
inline constexpr Message kDataSkipped{
    Severity::warning, true, "data-skipped",
    PROVEOUT_TEXT("Core",
                  "G10 with L{} begins to set data of the control; the blocks up to G11 are skipped."),
    PROVEOUT_TEXT("Core", "What depends on these data cannot be vouched for.")};
inline constexpr Message kRegisterUnknown{
    Severity::error, true, "register-unknown", PROVEOUT_TEXT("Core", "The offset register {} is not known."),
    PROVEOUT_TEXT("Core", "The tool with its number fills it, or G10; add the tool, or correct the number.")};
inline constexpr Message kLengthWithoutAxis{
    Severity::warning, true, "length-without-axis",
    PROVEOUT_TEXT("Core", "{} changes the tool length without a Z word; some machines move by the "
                          "difference, others stand still."),
    PROVEOUT_TEXT("Core", "Position Z in the same block; here it stands still.")};
inline constexpr Message kCompensationSuspended{
    Severity::warning, true, "compensation-suspended",
    PROVEOUT_TEXT("Core", "{} suspends cutter compensation on its way."),
    PROVEOUT_TEXT("Core", "Write G40 before it.")};
inline constexpr Message kCycleWord{
    Severity::error, true, "cycle-word-missing", PROVEOUT_TEXT("Core", "The cycle {} needs the word {}."),
    PROVEOUT_TEXT("Core", "The first block of a cycle must have it; this one drills nothing.")};
inline constexpr Message kCycleNoAxis{Severity::error, true, "cycle-no-axis",
                                      PROVEOUT_TEXT("Core", "The cycle has no axis word."),
                                      PROVEOUT_TEXT("Core", "Name the place of the first hole.")};
inline constexpr Message kCycleInverseTime{
    Severity::error, true, "cycle-inverse-time",
    PROVEOUT_TEXT("Core", "A cycle cannot be used with inverse time feed."),
    PROVEOUT_TEXT("Core", "Write G94 and a feed before it; the cycle drills nothing.")};
inline constexpr Message kInverseTimeFeed{
    Severity::error, true, "inverse-time-feed",
    PROVEOUT_TEXT("Core", "With inverse time feed (G93) every cutting block needs an F word."),
    PROVEOUT_TEXT("Core", "Add F, one over the minutes that the motion takes.")};
inline constexpr Message kFeedWithoutSpindle{
    Severity::error, true, "feed-without-spindle",
    PROVEOUT_TEXT("Core", "The feed counts per revolution (G95), but the spindle does not turn."),
    PROVEOUT_TEXT("Core", "Switch the spindle on, or write G94 and a feed per minute.")};
inline constexpr Message kCycleLevels{
    Severity::error, true, "cycle-levels",
    PROVEOUT_TEXT("Core", "The R level lies below the bottom of the hole."),
    PROVEOUT_TEXT("Core", "Check R and the depth; the cycle drills nothing.")};
inline constexpr Message kCyclePeck{Severity::error, true, "cycle-peck",
                                    PROVEOUT_TEXT("Core", "The depth of a peck must be greater than 0."),
                                    PROVEOUT_TEXT("Core", "Check the Q word; the cycle drills nothing.")};
inline constexpr Message kCycleSpindle{
    Severity::error, true, "cycle-spindle",
    PROVEOUT_TEXT("Core", "The spindle must turn for this cycle: {}."),
    PROVEOUT_TEXT("Core", "Switch it on in a block before; the cycle drills nothing.")};
inline constexpr Message kBackBore{
    Severity::warning, true, "back-bore",
    PROVEOUT_TEXT("Core", "G87 cuts from below, which a z-map cannot hold."),
    PROVEOUT_TEXT("Core", "The motions are shown; what they cut from below cannot be vouched for.")};
inline constexpr Message kTapAxesMixed{
    Severity::fault, false, "tap-axes-mixed",
    PROVEOUT_TEXT("Core",
                  "LinuxCNC 2.9 mixes up the axes of a tapping cycle in {}: the tool feeds to another place "
                  "than the hole bottom."),
    PROVEOUT_TEXT("Core", "Tap in G17, or use G33.1.")};
inline constexpr Message kShiftNotTurned{
    Severity::fault, false, "shift-not-turned",
    PROVEOUT_TEXT("Core",
                  "{} turns the work offset while G92 or G52 is in force: LinuxCNC then takes the tool to be "
                  "at another place than it is."),
    PROVEOUT_TEXT("Core", "Cancel the shift with G92.1 first, and set it again afterwards.")};
inline constexpr Message kArcFromElsewhere{
    Severity::error, true, "arc-from-elsewhere",
    PROVEOUT_TEXT("Core",
                  "The control takes the tool to be elsewhere than it is at the beginning of this arc."),
    PROVEOUT_TEXT("Core", "Program a straight move before the arc; the arc is skipped.")};
inline constexpr Message kFineBore{
    Severity::warning, true, "fine-bore",
    PROVEOUT_TEXT("Core",
                  "The boring bar moves aside before it leaves the bore, but is cut as a full cylinder."),
    PROVEOUT_TEXT("Core", "What it seems to touch on its way out cannot be vouched for.")};
inline constexpr Message kManualExit{
    Severity::warning, true, "manual-exit",
    PROVEOUT_TEXT("Core", "The operator takes the tool out of the hole by hand."),
    PROVEOUT_TEXT("Core", "Shown is the straight way out; what follows cannot be vouched for.")};
inline constexpr Message kBackBoreLevels{
    Severity::error, true, "back-bore-levels",
    PROVEOUT_TEXT("Core", "Back boring goes up from R, but the depth does not lie above R."),
    PROVEOUT_TEXT("Core", "Check R and the depth; the cycle bores nothing.")};
inline constexpr Message kBackBoreReturn{
    Severity::warning, false, "back-bore-return",
    PROVEOUT_TEXT("Core", "{} cannot be used with G99; it returns to the initial level."),
    PROVEOUT_TEXT("Core", "Write G98 before it.")};
inline constexpr Message kInitialLevelUnknown{
    Severity::warning, true, "initial-level-unknown",
    PROVEOUT_TEXT("Core", "G98 returns to the initial level, which is not known; shown is R."),
    PROVEOUT_TEXT("Core", "Position the axis before the cycle.")};
inline constexpr Message kPeckMissing{
    Severity::warning, false, "cycle-peck-missing",
    PROVEOUT_TEXT("Core", "{} has no Q: the hole is drilled in one go."),
    PROVEOUT_TEXT("Core", "Newer controls stop with an alarm instead; give the depth of a peck.")};
inline constexpr Message kTapSpindle{
    Severity::warning, true, "tap-without-spindle",
    PROVEOUT_TEXT("Core", "The spindle stands, and no M29 orders rigid tapping."),
    PROVEOUT_TEXT("Core", "Some machines tap rigidly without M29, as is shown; write M29 before the cycle.")};
inline constexpr Message kCycleStoredPlace{
    Severity::warning, true, "cycle-stored-place",
    PROVEOUT_TEXT("Core", "With 0 repeats the cycle is only stored; {} of this block is not moved to."),
    PROVEOUT_TEXT("Core", "Some controls move there; name the place in another block.")};
inline constexpr Message kPatternWithoutCycle{
    Severity::error, true, "pattern-without-cycle",
    PROVEOUT_TEXT("Core", "{} drills with the canned cycle in force, but there is none."),
    PROVEOUT_TEXT("Core", "Write the cycle with L0 in a block before; the pattern drills nothing.")};
inline constexpr Message kBoltLineFirst{
    Severity::warning, true, "bolt-line-first",
    PROVEOUT_TEXT("Core", "The first hole of G72 is taken to be where the tool stands."),
    PROVEOUT_TEXT("Core", "Check it against the manual of the control.")};
inline constexpr Message kPocketWay{
    Severity::warning, false, "pocket-way",
    PROVEOUT_TEXT("Core",
                  "How the control moves from circle to circle of the pocket is not documented; shown "
                  "are half circles."),
    PROVEOUT_TEXT("Core", "The finished pocket is the same.")};
inline constexpr Message kPocketSmall{
    Severity::error, true, "pocket-small",
    PROVEOUT_TEXT("Core", "No pocket leads from radius {} mm to {} mm with a tool of radius {} mm."),
    PROVEOUT_TEXT("Core", "Check I, K and D; the pocket is not milled.")};
inline constexpr Message kNoIntermediate{
    Severity::error, true, "intermediate-unknown",
    PROVEOUT_TEXT("Core", "G29 returns by the intermediate point of G28, which is not known for {}."),
    PROVEOUT_TEXT("Core", "Position the axis before G28 and name it there.")};
inline constexpr Message kOneSided{
    Severity::warning, true, "one-sided-approach",
    PROVEOUT_TEXT("Core", "G60 overshoots by a distance that is set in the machine; it is shown without."),
    PROVEOUT_TEXT("Core", "Make sure that there is room behind the target.")};
inline constexpr Message kFeedInOldUnit{
    Severity::warning, false, "feed-before-units",
    PROVEOUT_TEXT("Core", "The feed is read in the unit that was in force before {}."),
    PROVEOUT_TEXT("Core", "LinuxCNC reads F first; switch the unit in a block before.")};
inline constexpr Message kDiameterMode{
    Severity::error, true, "diameter-mode",
    PROVEOUT_TEXT("Core", "G7 makes X a diameter, as on a lathe: LinuxCNC would halve every X."),
    PROVEOUT_TEXT("Core", "Remove it, or write G8; X is shown as a radius.")};
inline constexpr Message kSurfaceSpeedLimited{
    Severity::warning, false, "surface-speed-limited",
    PROVEOUT_TEXT("Core", "With G96 the spindle follows X; it is taken to turn at its limit D, {} rpm."),
    PROVEOUT_TEXT("Core", "X is no diameter on a mill: write G97 and a speed.")};
inline constexpr Message kSurfaceSpeedUnknown{
    Severity::warning, false, "surface-speed-unknown",
    PROVEOUT_TEXT("Core", "Spindle speed is unknown, because G96 has no D."),
    PROVEOUT_TEXT("Core", "Write G97 and a speed, or a limit D.")};
inline constexpr Message kInputTwice{Severity::error, true, "input-twice",
                                     PROVEOUT_TEXT("Core", "M66 has P and E: a digital and an analog input."),
                                     PROVEOUT_TEXT("Core", "Keep one of them.")};
inline constexpr Message kInputWait{Severity::error, true, "input-wait",
                                    PROVEOUT_TEXT("Core", "M66 cannot wait for an analog input."),
                                    PROVEOUT_TEXT("Core", "Remove L, or write L0.")};
inline constexpr Message kInputAssumed{
    Severity::warning, false, "input-assumed",
    PROVEOUT_TEXT("Core", "What M66 reads is known to the machine only; #5399 is taken to be {}."),
    PROVEOUT_TEXT("Core", "What follows is verified as long as it does not read #5399.")};
inline constexpr Message kInputUsed{
    Severity::warning, true, "input-used",
    PROVEOUT_TEXT("Core", "This line reads #5399, which holds an input of the machine."),
    PROVEOUT_TEXT("Core", "What follows may depend on it and cannot be vouched for.")};
inline constexpr Message kPitch{Severity::error, true, "pitch",
                                PROVEOUT_TEXT("Core", "The pitch K must be greater than 0."),
                                PROVEOUT_TEXT("Core", "Check the K word; nothing moves.")};
inline constexpr Message kSynchronisedFeed{
    Severity::error, true, "synchronised-feed",
    PROVEOUT_TEXT("Core", "{} moves in step with the spindle and takes no F."),
    PROVEOUT_TEXT("Core", "Remove F; the feed is the pitch K times the speed of the spindle.")};
inline constexpr Message kSynchronisedSpindle{
    Severity::error, true, "synchronised-spindle",
    PROVEOUT_TEXT("Core", "{} moves in step with the spindle, which does not turn."),
    PROVEOUT_TEXT("Core", "Write S and M3 or M4 in a block before.")};
inline constexpr Message kProbePerRevolution{
    Severity::error, true, "probe-feed-mode",
    PROVEOUT_TEXT("Core", "Probing with a feed per revolution (G95) is not possible."),
    PROVEOUT_TEXT("Core", "Write G94 and a feed per minute.")};
inline constexpr Message kProbeTooClose{Severity::error, true, "probe-too-close",
                                        PROVEOUT_TEXT("Core", "The probing motion ends where it begins."),
                                        PROVEOUT_TEXT("Core", "Check the axis words.")};
inline constexpr Message kSkipAssumed{
    Severity::warning, true, "skip-assumed",
    PROVEOUT_TEXT(
        "Core", "The skip motion is shown to its end; where a signal stops it, only the machine finds out."),
    PROVEOUT_TEXT("Core",
                  "#5061 to #5063 hold that end. With a stock and a cutter for its tool it stops at the "
                  "stock.")};
inline constexpr Message kProbeAssumed{
    Severity::warning, true, "probe-assumed",
    PROVEOUT_TEXT("Core", "Where the probe meets the part is known to the machine only."),
    PROVEOUT_TEXT("Core",
                  "It is taken to go to its programmed end; #5061 to #5069 hold that, #5070 is 0. With a "
                  "stock and a cutter for its tool it stops at the stock.")};
inline constexpr Message kProbeContact{
    Severity::warning, false, "probe-contact",
    PROVEOUT_TEXT("Core",
                  "The probe is assumed to stop at X{} Y{} Z{} mm, where it touches the simulated stock."),
    PROVEOUT_TEXT("Core",
                  "On the machine the part decides; what follows is verified as long as it does not go on "
                  "from there or read the result.")};
inline constexpr Message kProbeRelease{
    Severity::warning, false, "probe-release",
    PROVEOUT_TEXT("Core",
                  "The probe is assumed to stop at X{} Y{} Z{} mm, where it leaves the simulated stock."),
    PROVEOUT_TEXT("Core",
                  "On the machine the part decides; what follows is verified as long as it does not go on "
                  "from there or read the result.")};
inline constexpr Message kProbeUsed{
    Severity::warning, true, "probe-used",
    PROVEOUT_TEXT("Core",
                  "This line uses what a probing motion has found, which is assumed from the simulated "
                  "stock."),
    PROVEOUT_TEXT("Core", "What follows is shown for that; it cannot be vouched for on another part.")};
inline constexpr Message kProbeMissed{
    Severity::error, true, "probe-missed",
    PROVEOUT_TEXT("Core",
                  "{} reaches its end without touching the simulated stock; the control stops there."),
    PROVEOUT_TEXT("Core", "Check stock, tool and offsets, or probe farther.")};
inline constexpr Message kProbeHeld{
    Severity::error, true, "probe-held",
    PROVEOUT_TEXT("Core", "{} reaches its end without leaving the simulated stock; the control stops there."),
    PROVEOUT_TEXT("Core", "Check stock, tool and offsets, or move farther.")};
inline constexpr Message kProbeTouches{
    Severity::error, true, "probe-touches",
    PROVEOUT_TEXT("Core", "{} begins where the probe touches the simulated stock; the control stops there."),
    PROVEOUT_TEXT("Core", "Retract before it; the motion is skipped.")};
inline constexpr Message kProbeFree{
    Severity::error, true, "probe-free",
    PROVEOUT_TEXT("Core",
                  "{} begins where the probe touches nothing of the simulated stock; the control stops "
                  "there."),
    PROVEOUT_TEXT("Core", "Touch the part before it; the motion is skipped.")};
inline constexpr Message kSplinePlane{Severity::error, true, "spline-plane",
                                      PROVEOUT_TEXT("Core", "{} draws in the XY plane only."),
                                      PROVEOUT_TEXT("Core", "Write G17 before it.")};
inline constexpr Message kSplineHandle{
    Severity::error, true, "spline-handle",
    PROVEOUT_TEXT("Core", "G5 without I and J goes on from a G5, but the motion before it was none."),
    PROVEOUT_TEXT("Core", "Give I and J; LinuxCNC would take what some block before it left.")};
inline constexpr Message kSplineTooLong{
    Severity::error, true, "spline-too-long",
    PROVEOUT_TEXT("Core", "The spline needs more than {} straight motions."),
    PROVEOUT_TEXT("Core", "Check its points.")};
inline constexpr Message kNurbsAxes{Severity::error, true, "nurbs-axes",
                                    PROVEOUT_TEXT("Core", "A control point needs both X and Y."),
                                    PROVEOUT_TEXT("Core", "Add the missing word; the point is left out.")};
inline constexpr Message kNurbsWeight{
    Severity::error, true, "nurbs-weight",
    PROVEOUT_TEXT("Core", "A control point needs a weight P greater than 0."),
    PROVEOUT_TEXT("Core", "Write P1 for an ordinary point; the point is left out.")};
inline constexpr Message kNurbsWeightAlone{
    Severity::error, true, "nurbs-weight-alone",
    PROVEOUT_TEXT("Core", "P without X and Y is the weight of the first control point only."),
    PROVEOUT_TEXT("Core", "Close the NURBS block with G5.3 before the next one begins.")};
inline constexpr Message kNurbsPoints{
    Severity::error, true, "nurbs-points",
    PROVEOUT_TEXT("Core", "The NURBS block has {} control points, fewer than its order {}."),
    PROVEOUT_TEXT("Core", "Add points, or lower the order L.")};
inline constexpr Message kNurbsNotOpen{
    Severity::error, true, "nurbs-not-open",
    PROVEOUT_TEXT("Core", "G5.3 closes a NURBS block, but none is open."),
    PROVEOUT_TEXT("Core", "Begin it with G5.2; other motions in between end it.")};
inline constexpr Message kNurbsOpen{
    Severity::error, true, "nurbs-open",
    PROVEOUT_TEXT("Core", "A NURBS block was begun by G5.2 but not closed: nothing moves along it."),
    PROVEOUT_TEXT("Core", "Write G5.3 behind its last control point.")};
inline constexpr Message kNothingSaved{
    Severity::error, true, "modal-state-not-saved",
    PROVEOUT_TEXT("Core", "M72 restores a modal state, but none is saved at this level of calls."),
    PROVEOUT_TEXT("Core", "Write M70 or M73 before it, in the same subprogram.")};
inline constexpr Message kRestoreNotAlone{
    Severity::warning, true, "modal-restore-not-alone",
    PROVEOUT_TEXT("Core", "Other words stand beside M72."),
    PROVEOUT_TEXT("Core", "LinuxCNC drops what comes after the restoring; give M72 a block of its own.")};
inline constexpr Message kNoToolSelected{
    Severity::error, true, "tool-not-selected",
    PROVEOUT_TEXT("Core", "M6 changes the tool, but none is selected."),
    PROVEOUT_TEXT("Core", "Write the T word into the block or before it.")};

// Motions.
inline constexpr Message kNoFeed{
    Severity::error, true, "feed-missing", PROVEOUT_TEXT("Core", "A cutting motion has no feed rate."),
    PROVEOUT_TEXT("Core", "Give F in this block or before it; there is no default.")};
inline constexpr Message kStartUnknown{
    Severity::warning, true, "start-unknown",
    PROVEOUT_TEXT("Core", "The position of {} is not known, so this motion cuts nothing."),
    PROVEOUT_TEXT("Core", "Position all axes with G0 before the first cut.")};
inline constexpr Message kNeverKnown{
    Severity::warning, true, "position-never-known",
    PROVEOUT_TEXT("Core", "The program never says where {} stands, so what it cuts is not known."),
    PROVEOUT_TEXT("Core", "Position all axes with G0 before the first cut.")};
inline constexpr Message kIncrementalUnknown{
    Severity::warning, true, "incremental-from-unknown",
    PROVEOUT_TEXT("Core", "{} moves by a distance from a place that is not known."),
    PROVEOUT_TEXT("Core", "Position the axis in G90 first.")};
inline constexpr Message kArcNoCentre{
    Severity::error, true, "arc-no-centre",
    PROVEOUT_TEXT("Core", "The arc has neither a centre nor a radius."),
    PROVEOUT_TEXT("Core", "Give the centre with {} and {}, or the radius with R.")};
inline constexpr Message kArcCentreIncomplete{
    Severity::error, true, "arc-centre-incomplete",
    PROVEOUT_TEXT("Core", "An absolute centre (G90.1) needs both {} and {}."),
    PROVEOUT_TEXT("Core", "Add the missing word, or use G91.1.")};
inline constexpr Message kArcMixed{
    Severity::error, true, "arc-radius-and-centre",
    PROVEOUT_TEXT("Core", "The arc has both a centre and a radius."),
    PROVEOUT_TEXT("Core", "Controls differ in which one they take; keep one.")};
inline constexpr Message kArcWrongWord{
    Severity::error, true, "arc-word-off-plane",
    PROVEOUT_TEXT("Core", "The word {} does not belong to an arc in the plane of {}."),
    PROVEOUT_TEXT("Core", "Remove the word, or select the plane that was meant.")};
inline constexpr Message kArcZeroRadius{
    Severity::error, true, "arc-zero-radius", PROVEOUT_TEXT("Core", "The arc has no radius: {} mm."),
    PROVEOUT_TEXT("Core", "The centre lies on the start or the end point.")};
inline constexpr Message kArcEndsDiffer{
    Severity::error, true, "arc-ends-differ",
    PROVEOUT_TEXT("Core", "The arc does not fit: radius {} mm at its start, {} mm at its end, {} mm apart."),
    PROVEOUT_TEXT("Core",
                  "Check the centre: I J K count from the start point, after G90.1 from the origin.")};
inline constexpr Message kArcFullWithRadius{
    Severity::error, true, "arc-full-with-radius",
    PROVEOUT_TEXT("Core", "An arc with R cannot end where it begins."),
    PROVEOUT_TEXT("Core", "Give a full circle its centre, or make two arcs of it.")};
inline constexpr Message kArcRadiusSmall{
    Severity::error, true, "arc-radius-small",
    PROVEOUT_TEXT("Core",
                  "The radius {} mm is too small: the end lies {} mm from the start, {} mm more than 2 R."),
    PROVEOUT_TEXT("Core", "Check R and the end point.")};
inline constexpr Message kArcRadiusCounts{
    Severity::warning, false, "arc-radius-counts",
    PROVEOUT_TEXT("Core", "The arc has both a centre and a radius; the radius counts."),
    PROVEOUT_TEXT("Core", "Other controls refuse this; keep one.")};
inline constexpr Message kArcStays{
    Severity::warning, false, "arc-stays",
    PROVEOUT_TEXT("Core", "The arc with R ends where it begins, so that nothing moves."),
    PROVEOUT_TEXT("Core", "Give a full circle its centre, or make two arcs of it.")};
inline constexpr Message kArcStraight{
    Severity::warning, true, "arc-straight",
    PROVEOUT_TEXT("Core",
                  "The arc has neither a centre nor a radius: the control moves straight, or stops with an "
                  "alarm."),
    PROVEOUT_TEXT("Core", "Give the centre with I, J or K, or the radius with R.")};
inline constexpr Message kArcTooLarge{
    Severity::error, true, "arc-too-large",
    PROVEOUT_TEXT("Core", "The radius of the arc is {} mm, beyond what can be computed exactly."),
    PROVEOUT_TEXT("Core", "Check the centre; use G1 for a straight line.")};
inline constexpr Message kArcTooLong{
    Severity::error, true, "arc-too-long",
    PROVEOUT_TEXT("Core", "The path of the arc is {} mm long, beyond the limit of {} mm; it cuts nothing."),
    PROVEOUT_TEXT("Core", "Check the centre and the number of turns.")};
inline constexpr Message kArcTurns{Severity::error, true, "arc-turns",
                                   PROVEOUT_TEXT("Core", "P must be a whole number of turns from 1 to {}."),
                                   PROVEOUT_TEXT("Core", "Check the P word.")};

// Optional chamfers and corner radii.
inline constexpr Message kCornerWithoutMotion{
    Severity::error, true, "corner-without-motion",
    PROVEOUT_TEXT("Core",
                  "No straight or circular motion stands on both sides of the chamfer or corner radius "
                  "(alarm 051)."),
    PROVEOUT_TEXT("Core", "Let G1, G2 or G3 in the plane follow; the corner stays sharp.")};
inline constexpr Message kCornerNextBlock{
    Severity::error, true, "corner-next-block",
    PROVEOUT_TEXT("Core",
                  "The block behind the chamfer or corner radius orders neither G1, G2 nor G3 (alarm 052, on "
                  "newer controls 051)."),
    PROVEOUT_TEXT("Core", "Only one dwell in a block of its own may stand between; the corner stays sharp.")};
inline constexpr Message kCornerTwice{
    Severity::error, true, "corner-twice",
    PROVEOUT_TEXT("Core", "The block orders a chamfer and a corner radius (alarm 053)."),
    PROVEOUT_TEXT("Core", "Keep one of them; the corner stays sharp.")};
inline constexpr Message kCornerComma{
    Severity::error, true, "corner-comma",
    PROVEOUT_TEXT("Core", "Neither C nor R stands behind the comma (alarm 053)."),
    PROVEOUT_TEXT("Core", "Write ,C for a chamfer and ,R for a corner radius.")};
inline constexpr Message kCornerCompensation{
    Severity::error, true, "corner-compensation",
    PROVEOUT_TEXT("Core",
                  "A chamfer or corner radius stands where cutter compensation begins, ends or changes its "
                  "side (alarm 039)."),
    PROVEOUT_TEXT("Core", "Put it between other motions; the corner stays sharp.")};
inline constexpr Message kCornerNegative{
    Severity::error, true, "corner-negative",
    PROVEOUT_TEXT("Core", "The chamfer or corner radius of {} mm is negative."),
    PROVEOUT_TEXT("Core", "Write it without a sign; the corner stays sharp.")};
inline constexpr Message kCornerScaled{
    Severity::warning, true, "corner-scaled",
    PROVEOUT_TEXT("Core",
                  "The manuals do not tell whether G51 scales chamfers and corner radii too; here it does "
                  "not."),
    PROVEOUT_TEXT("Core", "Write the motions out.")};
inline constexpr Message kCornerTooLarge{
    Severity::error, true, "corner-too-large",
    PROVEOUT_TEXT("Core",
                  "The chamfer or corner radius of {} mm does not fit between the motions (alarm 055)."),
    PROVEOUT_TEXT("Core", "Use a smaller one; the corner stays sharp.")};
inline constexpr Message kCornerOffPlane{
    Severity::error, true, "corner-off-plane",
    PROVEOUT_TEXT("Core", "A chamfer or corner radius stands between motions in one plane only."),
    PROVEOUT_TEXT("Core", "Move along the third axis in another block; the corner stays sharp.")};
inline constexpr Message kChamferOnArc{
    Severity::warning, true, "chamfer-on-arc",
    PROVEOUT_TEXT("Core",
                  "The manuals do not tell how a chamfer counts along an arc; here it is the straight "
                  "distance from the corner."),
    PROVEOUT_TEXT("Core", "Write the motions out.")};

// Cutter compensation.
inline constexpr Message kCompensationOnAlready{Severity::error, true, "compensation-on-already",
                                                PROVEOUT_TEXT("Core", "Cutter compensation is on already."),
                                                PROVEOUT_TEXT("Core", "Write G40 first; {} has no effect.")};
inline constexpr Message kCompensationPlane{
    Severity::error, true, "compensation-plane",
    PROVEOUT_TEXT("Core", "Cutter compensation works in the planes of G17 and G18 only."),
    PROVEOUT_TEXT("Core", "Select the plane before; the code has no effect.")};
inline constexpr Message kCompensationTurned{
    Severity::error, true, "compensation-turned",
    PROVEOUT_TEXT("Core", "Cutter compensation in G18 under a rotation about Z is not supported."),
    PROVEOUT_TEXT("Core", "Take the rotation out of the work offset; the code has no effect.")};
inline constexpr Message kCompensationForbids{
    Severity::error, true, "compensation-forbids",
    PROVEOUT_TEXT("Core", "{} cannot be used while cutter compensation is on."),
    PROVEOUT_TEXT("Core", "Write G40 before it; the code has no effect.")};
inline constexpr Message kCompensationNoDiameter{
    Severity::warning, false, "compensation-without-diameter",
    PROVEOUT_TEXT("Core", "The diameter for {} is 0, so the tool moves on the programmed path."),
    PROVEOUT_TEXT("Core", "Check the tool table, if the path is not written for the centre of the tool.")};
inline constexpr Message kCompensationDiameterUnknown{
    Severity::warning, true, "compensation-diameter-unknown",
    PROVEOUT_TEXT("Core", "No diameter is known for {}, so the tool moves on the programmed path."),
    PROVEOUT_TEXT("Core", "Give the tools of the program.")};
inline constexpr Message kCompensationUnknownStart{
    Severity::error, true, "compensation-from-unknown",
    PROVEOUT_TEXT("Core", "The motion is not compensated: it leads from or to a place that is not known."),
    PROVEOUT_TEXT("Core", "Position the axes of the plane before G41 or G42.")};
inline constexpr Message kCompensationEntryShort{
    Severity::error, true, "compensation-entry-short",
    PROVEOUT_TEXT("Core", "The motion into cutter compensation is {} mm long, not longer than the tool's "
                          "radius of {} mm."),
    PROVEOUT_TEXT("Core", "Begin farther away; the motion is skipped.")};
inline constexpr Message kCompensationArcSmall{
    Severity::error, true, "compensation-arc-small",
    PROVEOUT_TEXT("Core", "The arc has a radius of {} mm, not larger than the tool's radius of {} mm."),
    PROVEOUT_TEXT("Core", "Use a smaller tool; the motion is skipped.")};
inline constexpr Message kCompensationCorner{
    Severity::error, true, "compensation-corner",
    PROVEOUT_TEXT("Core", "The tool with a radius of {} mm does not fit into this inside corner."),
    PROVEOUT_TEXT("Core", "Use a smaller tool; the motion is skipped.")};
inline constexpr Message kCompensationGouge{
    Severity::error, true, "compensation-gouge",
    PROVEOUT_TEXT("Core", "The tool with a radius of {} mm gouges between the inside corners of the motion "
                          "of line {}."),
    PROVEOUT_TEXT("Core", "Use a smaller tool, or leave the short motion out.")};
inline constexpr Message kCompensationBackward{
    Severity::warning, false, "compensation-backward",
    PROVEOUT_TEXT("Core",
                  "The tool with a radius of {} mm goes backward in the motion of line {} and gouges; "
                  "LinuxCNC does not notice."),
    PROVEOUT_TEXT("Core", "Use a smaller tool, or leave the short motion out.")};
inline constexpr Message kCompensationAfterStop{
    Severity::warning, true, "compensation-after-stop",
    PROVEOUT_TEXT("Core", "A stop stands before this inside corner, so the tool goes too far and gouges."),
    PROVEOUT_TEXT("Core", "Stop elsewhere: the corner is known only when the motion to it is done.")};
inline constexpr Message kCompensationExitArc{
    Severity::error, true, "compensation-exit-arc",
    PROVEOUT_TEXT("Core", "The first motion after G40 must be straight."),
    PROVEOUT_TEXT("Core", "Lead out with G0 or G1; the arc is skipped.")};
inline constexpr Message kCompensationStartArc{
    Severity::error, true, "compensation-start-arc",
    PROVEOUT_TEXT("Core", "Cutter compensation cannot begin on an arc (alarm 034)."),
    PROVEOUT_TEXT("Core", "Lead in with G0 or G1; the arc is skipped.")};
inline constexpr Message kCompensationSquare{
    Severity::warning, false, "compensation-square",
    PROVEOUT_TEXT("Core",
                  "The corner before this motion is not compensated: the tool stands square beside the "
                  "block before it, and goes on from there."),
    PROVEOUT_TEXT("Core", "Keep stops, repeated codes and blocks without a motion away from corners.")};
inline constexpr Message kCompensationSideApart{
    Severity::warning, true, "compensation-side-apart",
    PROVEOUT_TEXT("Core", "The tool changes its side between paths that do not meet."),
    PROVEOUT_TEXT("Core", "Write G40 before the other side.")};
inline constexpr Message kCompensationErased{
    Severity::error, true, "compensation-erased",
    PROVEOUT_TEXT("Core",
                  "The tool with a radius of {} mm goes backward in the motion of line {}; the control "
                  "leaves out points of the corner before it, or stops (alarm 041)."),
    PROVEOUT_TEXT("Core", "Use a smaller tool, or leave the short motion out.")};
inline constexpr Message kCompensationOffCircle{
    Severity::warning, true, "compensation-off-circle",
    PROVEOUT_TEXT("Core", "The compensated arc begins {} mm off its circle."),
    PROVEOUT_TEXT("Core", "Change side, radius or code of compensation before a straight motion.")};
inline constexpr Message kCompensationAtEnd{
    Severity::warning, false, "compensation-at-end",
    PROVEOUT_TEXT("Core", "Cutter compensation is still on at the end of the program."),
    PROVEOUT_TEXT("Core", "Lead out with G40.")};

// Of grbl, and of Mach.
inline constexpr Message kCodeForeign{
    Severity::error, true, "code-foreign", PROVEOUT_TEXT("Core", "{} is no order of this control."),
    PROVEOUT_TEXT("Core", "The control drops the block, and so does the simulation; take the code out.")};
inline constexpr Message kWordForeign{
    Severity::error, true, "word-foreign", PROVEOUT_TEXT("Core", "This control has no word {}."),
    PROVEOUT_TEXT("Core", "The control drops the block, and so does the simulation; take the word out.")};
inline constexpr Message kNoExpressions{
    Severity::error, true, "no-expressions",
    PROVEOUT_TEXT("Core", "This control has neither parameters nor expressions."),
    PROVEOUT_TEXT("Core", "Let the CAM system write plain numbers.")};
inline constexpr Message kLineDropped{
    Severity::error, true, "line-dropped",
    PROVEOUT_TEXT(
        "Core", "The line has {} characters without blanks and comments; the control reads no more than {}."),
    PROVEOUT_TEXT("Core", "The control answers error:11 and drops the line; split it.")};
inline constexpr Message kBlockNumberLarge{
    Severity::error, true, "n-large", PROVEOUT_TEXT("Core", "The block number is larger than {}."),
    PROVEOUT_TEXT("Core", "The control answers error:27 and drops the block; number the blocks anew.")};
inline constexpr Message kSystemCommand{
    Severity::warning, true, "system-command",
    PROVEOUT_TEXT("Core", "{} is an order to the control itself; it is not carried out here."),
    PROVEOUT_TEXT("Core",
                  "It may move axes, change settings or clear offsets; send it apart from the program.")};
inline constexpr Message kRealtimeCharacter{
    Severity::warning, false, "realtime-character",
    PROVEOUT_TEXT(
        "Core",
        "The character {} is an order to the control that counts wherever it stands, also in comments."),
    PROVEOUT_TEXT("Core", "It may stop the machine or change an override; take it out.")};
inline constexpr Message kRealtimeReset{
    Severity::error, true, "realtime-reset",
    PROVEOUT_TEXT("Core", "The character {} resets the control or stops it in the middle of the program."),
    PROVEOUT_TEXT("Core", "Take it out.")};
inline constexpr Message kDeleteMarkIgnored{
    Severity::warning, false, "delete-mark-ignored",
    PROVEOUT_TEXT("Core", "This control has no block delete: it runs what stands behind \"/\"."),
    PROVEOUT_TEXT("Core", "Take the blocks out that are not to run.")};
inline constexpr Message kPercentRefused{
    Severity::warning, false, "percent-refused", PROVEOUT_TEXT("Core", "This control does not know \"%\"."),
    PROVEOUT_TEXT("Core", "The control answers error:1 unless the sender keeps the line back; remove it.")};
inline constexpr Message kToolNotChanged{
    Severity::warning, true, "tool-not-changed",
    PROVEOUT_TEXT("Core", "T{} is read, but changes nothing: this control has no tool change."),
    PROVEOUT_TEXT("Core", "Make one program for each tool, or change it by hand behind M0.")};
inline constexpr Message kOptionalStopIgnored{Severity::warning, false, "optional-stop-ignored",
                                              PROVEOUT_TEXT("Core", "This control does not stop at M1."),
                                              PROVEOUT_TEXT("Core", "Write M0 where it has to stop.")};
inline constexpr Message kMistOption{
    Severity::warning, true, "mist-option",
    PROVEOUT_TEXT("Core", "M7 is known only where grbl was built with mist coolant."),
    PROVEOUT_TEXT("Core",
                  "Otherwise grbl answers error:20 and drops the block; give M7 a block of its own.")};
inline constexpr Message kArcWordIgnored{
    Severity::warning, false, "arc-word-ignored",
    PROVEOUT_TEXT("Core", "The centre word {} lies outside the plane of the arc; the control ignores it."),
    PROVEOUT_TEXT("Core", "Remove the word, or select the plane that was meant.")};
inline constexpr Message kArcAxisMissing{
    Severity::error, true, "arc-axis-missing",
    PROVEOUT_TEXT("Core", "The arc names no axis of its plane as its end."),
    PROVEOUT_TEXT("Core", "Write the end point, also of a full circle.")};
inline constexpr Message kLengthAxis{
    Severity::error, true, "length-axis",
    PROVEOUT_TEXT("Core", "G43.1 takes the word Z and no other axis on this control."),
    PROVEOUT_TEXT("Core", "Write G43.1 Z… in a block of its own.")};
inline constexpr Message kOWordForeign{
    Severity::error, true, "o-word-foreign",
    PROVEOUT_TEXT("Core", "This control knows O with a number alone, as the beginning of a subprogram."),
    PROVEOUT_TEXT("Core", "Call it with M98 and end it with M99.")};
inline constexpr Message kDwellUnit{
    Severity::warning, false, "dwell-unit",
    PROVEOUT_TEXT("Core", "A setting of the control decides whether the dwell of {} is {} s or {} s; it is "
                          "taken as the first."),
    PROVEOUT_TEXT("Core", "Check on the control whether P counts seconds or milliseconds.")};
inline constexpr Message kArcCentreOpen{
    Severity::warning, true, "arc-centre-open",
    PROVEOUT_TEXT(
        "Core",
        "The arc fits with its centre counted from the start point and also from the origin; a setting "
        "of the control decides, and it is taken from the start point."),
    PROVEOUT_TEXT("Core", "Write G91.1 or G90.1 at the beginning of the program.")};
inline constexpr Message kPolarPole{
    Severity::warning, true, "polar-pole",
    PROVEOUT_TEXT("Core",
                  "Mach3 takes the place of the tool for the pole of G16, Mach4 the origin; it is taken "
                  "as Mach3 does."),
    PROVEOUT_TEXT("Core", "Begin the polar coordinates where both are the same: at X0 Y0.")};
inline constexpr Message kPolarArc{
    Severity::warning, true, "polar-arc",
    PROVEOUT_TEXT("Core",
                  "Polar coordinates are meant for G0 and G1 in the XY plane; what {} does in them is "
                  "not written."),
    PROVEOUT_TEXT("Core", "Write G15 before it.")};
inline constexpr Message kRadiusScaled{
    Severity::warning, true, "radius-scaled",
    PROVEOUT_TEXT("Core", "Whether G51 scales the word {} is not written; it is taken to scale it."),
    PROVEOUT_TEXT("Core", "Write G50 before it, or give the centre of an arc by I and J.")};
inline constexpr Message kPlaneXyOnly{Severity::error, true, "plane-xy-only",
                                      PROVEOUT_TEXT("Core", "{} works in the XY plane only."),
                                      PROVEOUT_TEXT("Core", "Write G17 before it; the code has no effect.")};
inline constexpr Message kLengthNumberMissing{
    Severity::warning, true, "length-number-missing",
    PROVEOUT_TEXT("Core", "{} without H, or with H0, sets the tool length offset to 0."),
    PROVEOUT_TEXT("Core", "Write the number of the tool behind H.")};
inline constexpr Message kProgramRepeats{
    Severity::warning, false, "program-repeats",
    PROVEOUT_TEXT("Core", "M47 begins the program again, without end."),
    PROVEOUT_TEXT("Core", "It is run once here; end it with M30 if that was meant.")};
inline constexpr Message kAxesReferenced{
    Severity::warning, true, "axes-referenced",
    PROVEOUT_TEXT("Core",
                  "{} seeks the reference switches; where the axes stand afterwards, only the machine "
                  "knows."),
    PROVEOUT_TEXT("Core", "Position the axes before the next cut.")};

// What is no error and yet seldom meant; lint.cpp has the table of the rules.
inline constexpr Message kFeedZero{Severity::warning, false, "feed-zero",
                                   PROVEOUT_TEXT("Core", "The feed rate is 0."),
                                   PROVEOUT_TEXT("Core", "Give F a value above 0.")};
inline constexpr Message kLengthMissing{
    Severity::warning, false, "length-missing",
    PROVEOUT_TEXT("Core", "Tool {} begins to cut without a tool length offset of its own."),
    PROVEOUT_TEXT("Core",
                  "Write G43 behind the tool change: the offset of the tool before it is still in force.")};
inline constexpr Message kOffsetNeverChosen{
    Severity::note, false, "offset-never-chosen",
    PROVEOUT_TEXT("Core", "The program cuts without having chosen a work offset."),
    PROVEOUT_TEXT("Core", "Write G54, or the one that the part is set up in.")};
inline constexpr Message kLengthOfOtherTool{
    Severity::warning, false, "length-of-other-tool",
    PROVEOUT_TEXT("Core", "The tool length offset H{} is not that of tool {}."),
    PROVEOUT_TEXT("Core", "Use the number of the tool, if that was not meant.")};
inline constexpr Message kDiameterMissing{
    Severity::warning, false, "diameter-missing", PROVEOUT_TEXT("Core", "{} has no D word."),
    PROVEOUT_TEXT("Core", "Write the number of the offset: the one used last is in force.")};
inline constexpr Message kCompensationOnArc{
    Severity::warning, false, "compensation-on-arc",
    PROVEOUT_TEXT("Core", "Cutter compensation begins on an arc."),
    PROVEOUT_TEXT("Core", "Lead in with a straight motion; many controls give an alarm here.")};
inline constexpr Message kUnitsMixed{
    Severity::warning, false, "units-mixed",
    PROVEOUT_TEXT("Core", "{} changes the unit in the middle of the program."),
    PROVEOUT_TEXT("Core", "Keep to one unit; lengths that are in force keep their old one.")};
inline constexpr Message kLeftOn{
    Severity::warning, false, "left-on", PROVEOUT_TEXT("Core", "Still in force here: {}."),
    PROVEOUT_TEXT("Core", "End it before the tool change and before the end of the program.")};
inline constexpr Message kChangeLow{
    Severity::warning, false, "change-low",
    PROVEOUT_TEXT("Core", "The tool is changed at Z{}, not above Z{}, where it was fed."),
    PROVEOUT_TEXT("Core", "Retract first.")};
inline constexpr Message kChangeTurning{
    Severity::note, false, "change-turning",
    PROVEOUT_TEXT("Core", "The tool is changed while the spindle turns."),
    PROVEOUT_TEXT("Core", "Write M5 before it; not every machine stops the spindle by itself.")};
inline constexpr Message kUnreachable{
    Severity::warning, false, "unreachable",
    PROVEOUT_TEXT("Core", "Nothing leads to this line: line {} leaves the blocks before it for good."),
    PROVEOUT_TEXT("Core", "Remove it, or give it the block number or the label that something jumps to.")};
inline constexpr Message kToolNotInTable{
    Severity::warning, false, "tool-not-in-table",
    PROVEOUT_TEXT("Core", "T{} is selected, but the tool table does not have it."),
    PROVEOUT_TEXT("Core", "Add the tool, or correct the number.")};
inline constexpr Message kNearlyHalfCircle{
    Severity::warning, false, "nearly-half-circle",
    PROVEOUT_TEXT("Core", "The arc by its radius is nearly a half circle, {} degrees."),
    PROVEOUT_TEXT("Core", "Give the centre by I, J and K: here the last digit of R moves it far.")};

} // namespace nc_message

} // namespace proveout

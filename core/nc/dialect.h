// SPDX-License-Identifier: GPL-3.0-or-later
// The dialects of NC programs: what one control reads differently from another, as switches. Facts:
// LinuxCNC's documentation and stand-alone interpreter; the operator's manuals of the other controls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace proveout {

enum class DialectId : std::uint8_t { linuxcnc, fanuc, haas, count };

/// How parameters, expressions and jumps are written.
enum class MacroLanguage : std::uint8_t {
    oWords, ///< of LinuxCNC: #<name>, O… sub, O… if
    macroB, ///< of Fanuc: a parameter that was never set is null; IF […] GOTO, WHILE […] DO
};

/// One row of the table of dialects.
struct Dialect {
    DialectId id;
    const char* key;  ///< in files and on the command line
    const char* name; ///< proper, the same in all languages
    MacroLanguage macros;
    /// What the number 1 without a decimal point means, as a part of the unit; 1: the unit itself.
    double leastMm;
    double leastInch;
    /// Of two words with one letter, or two codes of one group, the last counts; otherwise they are an error.
    bool lastWordCounts;
    double leastFactor;         ///< what 1 without a decimal point means as a factor of G51
    bool rotationAdds;          ///< with G91 the angle of G68 adds to the one in force
    bool registersHoldDiameter; ///< D registers, otherwise the radius
    bool keepsLocalShift;       ///< G52 is stored with the work offsets
    bool allAxesGoHome;         ///< G28 without axis words moves all of them
    int additionalSystems;      ///< work offsets beyond G59
    int mostMWords;             ///< in one block
    bool refusesUnused;         ///< words that nothing in their block uses are an error
    bool codeAloneMoves;        ///< G0 without an axis word is a motion of no length
    bool beginsInRapid;         ///< G0 is in force at the start
    bool retractsToR;           ///< G99 is in force at the start, otherwise G98
    std::size_t deepestCalls;   ///< of subprograms within subprograms
    bool cyclesKeepWords;       ///< the words of canned cycles count until the series ends, Fanuc's way
    bool pecksShrink;           ///< I J K of a cycle are lengths of its pecks; otherwise K is its repeats
    bool tapsRigidly;           ///< without M29
    bool pointMeansSeconds;     ///< P of a dwell with a decimal point; otherwise milliseconds always
    /// What the builder of the machine sets in parameters; typical values.
    double chipGapMm;  ///< back to break the chip: Fanuc 5114, Haas setting 22
    double peckGapMm;  ///< above the depth reached, where rapid becomes feed: Fanuc 5115, Haas setting 22
    double peckLiftMm; ///< above R to clear the chips: Haas setting 52
    bool radiusWins;   ///< over I J K in an arc; a full circle by R moves nothing, and no centre is a line
    double arcRadiiMm; ///< by which an arc's radii may differ: Fanuc 3410; 0: LinuxCNC's rules
};

/// All of them, in the order of DialectId.
[[nodiscard]] std::span<const Dialect> dialects();
[[nodiscard]] const Dialect& dialect(DialectId id);
/// By its key; null where there is none.
[[nodiscard]] const Dialect* findDialect(std::string_view key);

} // namespace proveout

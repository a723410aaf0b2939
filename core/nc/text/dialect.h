// SPDX-License-Identifier: GPL-3.0-or-later
// The dialects of NC programs: the differences between the controls, as switches. Sources: LinuxCNC's
// documentation and stand-alone interpreter; the operator's manuals of the other controls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace proveout {

enum class DialectId : std::uint8_t { linuxcnc, fanuc, haas, grbl, mach, count };

struct Execution;
struct FindingRow;

/// How parameters, expressions and jumps are written.
enum class MacroLanguage : std::uint8_t {
    oWords, ///< of LinuxCNC: #<name>, O… sub, O… if
    macroB, ///< of Fanuc: a parameter that was never set is null; IF […] GOTO, WHILE […] DO
    labels, ///< of Mach: expressions of RS274, parameters by number; O… alone, as the label of a subprogram
    none,   ///< of grbl: numbers only
};

/// By how much the radii at both ends of an arc may differ, and by how much R may be short.
enum class ArcRule : std::uint8_t {
    linuxcnc, ///< in round numbers of the unit of the program
    grbl,     ///< in mm, for any unit
    nist,     ///< of RS274/NGC, from which Mach comes
};

/// Cutter compensation by vectors, as in Fanuc's controls; values set by the machine builder, with typical
/// defaults.
struct VectorRules {
    bool used = false;           ///< otherwise LinuxCNC's method
    bool typeB = false;          ///< of start-up and cancel: Fanuc 5003#0, Haas setting 43
    int readAhead = 3;           ///< number of blocks that the control knows at a time: Fanuc 19625
    double smallMoveMm = 1e-3;   ///< corner moves up to this along each axis are omitted: Fanuc 5010
    bool crossesAtCorner = true; ///< from G41 to G42 where the paths meet; otherwise along the path of the
                                 ///< block
};

/// How work offsets beyond G59 are selected.
struct AdditionalOffsetCode {
    int tenths = 590;             ///< of the code that is in force then
    int step = 1;                 ///< increment for each of them: G59.1, G59.2
    const char* written = "G59."; ///< before its number
    int first = 1;                ///< number of the first one
};

/// The contents of an offset register.
enum class RegisterEntry : std::uint8_t { length, lengthWear, radius, radiusWear };

/// System variables that name the same entry of successive registers, from 1 on.
struct RegisterVariables {
    int first;
    int last;
    RegisterEntry entry;
};

/// One row of the table of dialects.
struct Dialect {
    DialectId id;
    const char* key;  ///< in files and on the command line
    const char* name; ///< proper name, the same in all languages
    MacroLanguage macros;
    /// The value of the number 1 without a decimal point, as a fraction of the unit; 1: the unit itself.
    double leastMm;
    double leastInch;
    /// Of two words with one letter, or two codes of one group, the last counts; otherwise they are an error.
    bool lastWordCounts;
    double leastFactor;         ///< the value of 1 without a decimal point as a factor of G51
    bool rotationAdds;          ///< with G91 the angle of G68 is added to the one in force
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
    bool cyclesKeepWords;       ///< the words of canned cycles stay valid until the series ends, as on
                                ///< Fanuc's controls
    bool pecksShrink;           ///< I J K of a cycle are lengths of its pecks; otherwise K is the number of
                                ///< repeats
    bool tapsRigidly;           ///< without M29
    bool pointMeansSeconds;     ///< P of a dwell with a decimal point; otherwise milliseconds always
    /// Parameters set by the machine builder; typical values.
    double chipGapMm;  ///< retract to break the chip: Fanuc 5114, Haas setting 22
    double peckGapMm;  ///< above the depth reached, where rapid becomes feed: Fanuc 5115, Haas setting 22
    double peckLiftMm; ///< above R to clear the chips: Haas setting 52
    bool radiusWins;   ///< R has priority over I J K in an arc; a full circle by R moves nothing, and an arc
                       ///< without a centre is a line
    double arcRadiiMm; ///< by which an arc's radii may differ: Fanuc 3410; 0: by `arcs`
    VectorRules vectors = {};
    AdditionalOffsetCode additionalCode = {};
    std::span<const RegisterVariables> registerVariables = {};
    bool hasMonitors =
        false; ///< variables of timers, loads and settings, and second numbers: haas_variables.h
    ArcRule arcs = ArcRule::linuxcnc;
    std::size_t longestLine = 0;    ///< characters that the control reads; 0: any number
    double largestBlockNumber = 0;  ///< 0: any
    int deepestBrackets = 0;        ///< in an expression, including those of functions; 0: any
    bool streamed = false;          ///< lines are received over a serial line: serial_line.h
    bool machineIsAbsolute = false; ///< G53 uses machine coordinates in G91 too; otherwise it is refused
    bool rapidAfterG80 = false;     ///< axis words after G80 move in rapid; otherwise they are an error
    bool changesTools = true;       ///< by M6
    bool polarAboutTool = false;    ///< the pole of G16 is at the position of the tool
    bool radiusNotScaled = false;   ///< G51 scales words; whether R and Q are included is not documented
    bool dwellUnitOpen = false; ///< a setting determines whether P of a dwell is in seconds or milliseconds
    bool arcCentreOpen = false; ///< a setting determines whether I J K are absolute without G90.1 and G91.1
    bool risesOnTheWay = false; ///< moving to the first hole under G98: rises to the initial level; otherwise
                                ///< stays at its level
    bool readsBackAtToolChange = false; ///< M6 removes the difference between program and tip that G40 and
                                        ///< canned cycles leave
    bool straightFirst = false; ///< after G40 an arc needs a straight motion before it, regardless of other
                                ///< motions
    bool inverseTimeAsProgrammed = false; ///< G93 after G40 applies to the programmed length, not to that of
                                          ///< the actual path
    bool refusesIdleG53 = false;          ///< if the block has neither axis words nor a motion code
    bool entersUncalled = false;          ///< M98 with L0 begins the subprogram, and never ends it
    bool hasPolarWords = false;           ///< @ and ^
    bool registersNeedCode = false; ///< H without G43 is an error; on other controls it changes the offset in
                                    ///< force
    bool shiftHasParameter = false; ///< #5210 shows whether G92 or G52 is in force
    bool shiftIsNotTurned = false;  ///< by G10 L2 R: the control then assumes a wrong tool position
    bool feedModeEndsFeed = false;  ///< G94 and G95 end the feed in force even if they are in force already
    double leastInverseFeed = 0;    ///< to which G93 raises a lower feed, in units of the program per minute
    bool noReferenceInCycle = false;      ///< G27 to G30 while a canned cycle is in force are an alarm
    bool (*mayRun)(Execution&) = nullptr; ///< false: reported, and the control drops the block
    /// The answer of the control when it drops a block for the mistake that a message reports; null: no
    /// answer is known.
    const char* (*answer)(const FindingRow&) = nullptr;
};

} // namespace proveout

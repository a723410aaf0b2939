// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that the rows of the table of codes name, one per code or family of codes.
#pragma once

#include "core/nc/codes/codes.h"

namespace proveout {

struct FindingRow;

// motion_codes.cpp
void moveRapid(Execution& execution, const Word& word);               ///< G0
void moveFeed(Execution& execution, const Word& word);                ///< G1
void moveArcClockwise(Execution& execution, const Word& word);        ///< G2
void moveArcCounterClockwise(Execution& execution, const Word& word); ///< G3

// synchronised_codes.cpp
void moveInStep(Execution& execution, const Word& word); ///< G33
void tapRigidly(Execution& execution, const Word& word); ///< G33.1

// spline_codes.cpp
void followCubic(Execution& execution, const Word& word);     ///< G5
void followQuadratic(Execution& execution, const Word& word); ///< G5.1
void addNurbsPoint(Execution& execution, const Word& word);   ///< G5.2
void followNurbs(Execution& execution, const Word& word);     ///< G5.3

// probe_codes.cpp
void probe(Execution& execution, const Word& word);      ///< G38.2 to G38.5
void skipMotion(Execution& execution, const Word& word); ///< G31 of Fanuc

// input_codes.cpp
void waitForInput(Execution& execution, const Word& word);        ///< M66
void switchDigitalOutput(Execution& execution, const Word& word); ///< M62 to M65
void setAnalogOutput(Execution& execution, const Word& word);     ///< M67, M68

// modal_codes.cpp
void refuseDiameters(Execution& execution, const Word& word);         ///< G7
void setPlaneXy(Execution& execution, const Word& word);              ///< G17
void setPlaneZx(Execution& execution, const Word& word);              ///< G18
void setPlaneYz(Execution& execution, const Word& word);              ///< G19
void setInch(Execution& execution, const Word& word);                 ///< G20
void setMillimetre(Execution& execution, const Word& word);           ///< G21
void setAbsolute(Execution& execution, const Word& word);             ///< G90
void setIncremental(Execution& execution, const Word& word);          ///< G91
void setArcCentreAbsolute(Execution& execution, const Word& word);    ///< G90.1
void setArcCentreIncremental(Execution& execution, const Word& word); ///< G91.1
void selectPathControl(Execution& execution, const Word& word);       ///< G61 to G64 of Fanuc
void keepState(Execution& execution, const Word& word); ///< a code whose state is the only possible one

// cycle_codes.cpp
void runCycle(Execution& execution, const Word& word);              ///< G73, G74, G81 to G89
void retractToInitialLevel(Execution& execution, const Word& word); ///< G98
void retractToRLevel(Execution& execution, const Word& word);       ///< G99

// offset_codes.cpp
void selectWorkOffset(Execution& execution, const Word& word); ///< G54 to G59.3
void setOffsets(Execution& execution, const Word& word);       ///< G10
void shiftCoordinates(Execution& execution, const Word& word); ///< G92
void clearShift(Execution& execution, const Word& word);       ///< G92.1
void suspendShift(Execution& execution, const Word& word);     ///< G92.2
void restoreShift(Execution& execution, const Word& word);     ///< G92.3
void shiftLocally(Execution& execution, const Word& word);     ///< G52

// reference_codes.cpp
void goHome(Execution& execution, const Word& word);               ///< G28
void storeHome(Execution& execution, const Word& word);            ///< G28.1
void goToSecondReference(Execution& execution, const Word& word);  ///< G30
void storeSecondReference(Execution& execution, const Word& word); ///< G30.1

// positioning_codes.cpp
void checkReference(Execution& execution, const Word& word);      ///< G27
void returnFromReference(Execution& execution, const Word& word); ///< G29
void approachFromOneSide(Execution& execution, const Word& word); ///< G60

// pattern_codes.cpp
void drillBoltCircle(Execution& execution, const Word& word); ///< G70 of Haas
void drillBoltArc(Execution& execution, const Word& word);    ///< G71 of Haas
void drillBoltLine(Execution& execution, const Word& word);   ///< G72 of Haas

// pocket_codes.cpp
void millPocketClockwise(Execution& execution, const Word& word);        ///< G12 of Haas
void millPocketCounterClockwise(Execution& execution, const Word& word); ///< G13 of Haas

// length_codes.cpp
void useToolLength(Execution& execution, const Word& word);      ///< G43
void subtractToolLength(Execution& execution, const Word& word); ///< G44 of Mach, with a number
void useGivenLength(Execution& execution, const Word& word);     ///< G43.1
void addToolLength(Execution& execution, const Word& word);      ///< G43.2
void cancelToolLength(Execution& execution, const Word& word);   ///< G49

// transformation_codes.cpp
void scaleCoordinates(Execution& execution, const Word& word); ///< G51
void endScaling(Execution& execution, const Word& word);       ///< G50
void mirrorAxes(Execution& execution, const Word& word);       ///< G51.1
void endMirror(Execution& execution, const Word& word);        ///< G50.1, G100 of Haas
void mirrorAboutZero(Execution& execution, const Word& word);  ///< G101 of Haas
void turnCoordinates(Execution& execution, const Word& word);  ///< G68
void endTurning(Execution& execution, const Word& word);       ///< G69

// polar_words.cpp
void beginPolar(Execution& execution, const Word& word); ///< G16
void endPolar(Execution& execution, const Word& word);   ///< G15

// work_system_codes.cpp
void selectWorkSystem(Execution& execution, const Word& word);       ///< G54 to G59 of Fanuc
void selectAdditionalSystem(Execution& execution, const Word& word); ///< G54.1, G154 of Haas
void selectNamedSystem(Execution& execution, const Word& word);      ///< G110 to G129 of Haas
void shiftAllSystems(Execution& execution, const Word& word);        ///< G52 of Fanuc
void presetCoordinates(Execution& execution, const Word& word);      ///< G92 of Fanuc
void restoreCoordinates(Execution& execution, const Word& word);     ///< G92.1 of Fanuc

// data_codes.cpp
void writeData(Execution& execution, const Word& word); ///< G10 of Fanuc

// register_codes.cpp
void useRegisterLength(Execution& execution, const Word& word);      ///< G43 of Fanuc
void subtractRegisterLength(Execution& execution, const Word& word); ///< G44
void changeRegister(Execution& execution, const Word& word);         ///< H alone
void endRegisterLength(Execution& execution, const Word& word);      ///< G49 of Fanuc

// machine_position_codes.cpp
void goToMachineZero(Execution& execution, const Word& word);      ///< G28 of Fanuc
void goToFurtherReference(Execution& execution, const Word& word); ///< G30 of Fanuc
void moveInMachine(Execution& execution, const Word& word);        ///< G53 of Fanuc

// call_codes.cpp
void callProgram(Execution& execution, const Word& word);       ///< M98
void returnFromProgram(Execution& execution, const Word& word); ///< M99

// modal_save_codes.cpp
void saveModes(Execution& execution, const Word& word);            ///< M70
void discardModes(Execution& execution, const Word& word);         ///< M71
void restoreModes(Execution& execution, const Word& word);         ///< M72
void saveModesUntilReturn(Execution& execution, const Word& word); ///< M73
// macro_call_codes.cpp
void callSubprogram(Execution& execution, const Word& word);      ///< M98 of Fanuc
void callLocalSubprogram(Execution& execution, const Word& word); ///< M97 of Haas
void returnToBlock(Execution& execution, const Word& word);       ///< M99 of Fanuc
void callMacro(Execution& execution, const Word& word);           ///< G65
void callMacroModally(Execution& execution, const Word& word);    ///< G66
void cancelModalMacro(Execution& execution, const Word& word);    ///< G67

// compensation_codes.cpp
void endCompensation(Execution& execution, const Word& word);           ///< G40
void compensateLeft(Execution& execution, const Word& word);            ///< G41
void compensateRight(Execution& execution, const Word& word);           ///< G42
void compensateLeftByDiameter(Execution& execution, const Word& word);  ///< G41.1
void compensateRightByDiameter(Execution& execution, const Word& word); ///< G42.1

// vector_codes.cpp
void endCompensationOnTheWay(Execution& execution, const Word& word);   ///< G40 of Fanuc
void compensateLeftByRegister(Execution& execution, const Word& word);  ///< G41 of Fanuc
void compensateRightByRegister(Execution& execution, const Word& word); ///< G42 of Fanuc
void changeRadiusRegister(Execution& execution, const Word& word);      ///< D alone

// mach_handlers.cpp
void millCircleClockwise(Execution& execution, const Word& word);        ///< G12 of Mach
void millCircleCounterClockwise(Execution& execution, const Word& word); ///< G13 of Mach
void beginPolarHere(Execution& execution, const Word& word);             ///< G16 of Mach
void referenceAxes(Execution& execution, const Word& word);              ///< G28.1 of Mach
void useNumberedLength(Execution& execution, const Word& word);          ///< G43 of Mach
void subtractNumberedLength(Execution& execution, const Word& word);     ///< G44 of Mach
void scaleByAxis(Execution& execution, const Word& word);                ///< G51 of Mach
void turnByPoint(Execution& execution, const Word& word);                ///< G68 of Mach
void selectNumberedSystem(Execution& execution, const Word& word);       ///< G54.1 and G59 of Mach
void beginAgain(Execution& execution, const Word& word);                 ///< M47 of Mach

// grbl_handlers.cpp
void ignoreOptionalStop(Execution& execution, const Word& word);   ///< M1 of grbl
void switchMistWhereBuilt(Execution& execution, const Word& word); ///< M7 of grbl

// machine_codes.cpp
/// Reports once that a setting of the control determines the unit of P of a dwell.
void reportDwellUnit(Execution& execution, const Word& time);
void dwell(Execution& execution, const Word& word);                       ///< G4
void dwellByLetter(Execution& execution, const Word& word);               ///< G4 of Fanuc
void orderRigidTapping(Execution& execution, const Word& word);           ///< M29
void feedInverseTime(Execution& execution, const Word& word);             ///< G93
void feedPerMinute(Execution& execution, const Word& word);               ///< G94
void feedPerRevolution(Execution& execution, const Word& word);           ///< G95
void keepSurfaceSpeed(Execution& execution, const Word& word);            ///< G96
void keepSpindleSpeed(Execution& execution, const Word& word);            ///< G97
void setToolNumber(Execution& execution, const Word& word);               ///< M61
void changePallet(Execution& execution, const Word& word);                ///< M60
void setFeed(Execution& execution, const Word& word);                     ///< F
void setSpindleSpeed(Execution& execution, const Word& word);             ///< S
void selectTool(Execution& execution, const Word& word);                  ///< T
void changeTool(Execution& execution, const Word& word);                  ///< M6
void turnSpindleClockwise(Execution& execution, const Word& word);        ///< M3
void turnSpindleCounterClockwise(Execution& execution, const Word& word); ///< M4
void stopSpindle(Execution& execution, const Word& word);                 ///< M5
void switchMistOn(Execution& execution, const Word& word);                ///< M7
void switchFloodOn(Execution& execution, const Word& word);               ///< M8
void switchCoolantOff(Execution& execution, const Word& word);            ///< M9
void stopProgram(Execution& execution, const Word& word);                 ///< M0
void stopProgramOptionally(Execution& execution, const Word& word);       ///< M1
void endProgram(Execution& execution, const Word& word);                  ///< M2, M30

// grbl_rules.cpp: named by the row of the dialect

/// Whether grbl runs the block. It rejects the whole block if anything in it is wrong; that is reported.
[[nodiscard]] bool mayRunOnGrbl(Execution& execution);

/// The error code with which grbl answers the mistake that a message reports, with the remedy; null if there
/// is none. A literal marked with PROVEOUT_TEXT.
[[nodiscard]] const char* answerOfGrbl(const FindingRow& message);

} // namespace proveout

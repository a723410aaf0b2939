// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that the rows of the codes table name, one per code or family of codes.
#pragma once

#include "core/nc/codes.h"

namespace proveout {

// motion_codes.cpp
void moveRapid(Execution& execution, const Word& word);               ///< G0
void moveFeed(Execution& execution, const Word& word);                ///< G1
void moveArcClockwise(Execution& execution, const Word& word);        ///< G2
void moveArcCounterClockwise(Execution& execution, const Word& word); ///< G3

// modal_codes.cpp
void setPlaneXy(Execution& execution, const Word& word);              ///< G17
void setPlaneZx(Execution& execution, const Word& word);              ///< G18
void setPlaneYz(Execution& execution, const Word& word);              ///< G19
void setInch(Execution& execution, const Word& word);                 ///< G20
void setMillimetre(Execution& execution, const Word& word);           ///< G21
void setAbsolute(Execution& execution, const Word& word);             ///< G90
void setIncremental(Execution& execution, const Word& word);          ///< G91
void setArcCentreAbsolute(Execution& execution, const Word& word);    ///< G90.1
void setArcCentreIncremental(Execution& execution, const Word& word); ///< G91.1
void cancelToolLength(Execution& execution, const Word& word);        ///< G49
void keepState(Execution& execution, const Word& word); ///< a code whose state is the only one there is

// machine_codes.cpp
void dwell(Execution& execution, const Word& word);                       ///< G4
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

} // namespace proveout

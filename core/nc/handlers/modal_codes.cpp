// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/handlers.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

void setUnits(Execution& execution, const Word& word, bool inch) {
    if (execution.state.inch == inch)
        return;
    execution.state.inch = inch;
    if (!execution.dialect.cyclesKeepWords)
        execution.state.cycle.reinterpret(inch ? kMmPerInch : 1 / kMmPerInch);
    execution.program.append(UnitsChange{inch}, execution.line);
    if (execution.block.has('F') && execution.dialect.streamed) {
        // grbl reads the whole block before it converts F.
        setFeed(execution, execution.block.word('F'));
    } else if (execution.block.has('F')) {
        execution.reporter.report(nc_message::kFeedInOldUnit, execution.block.word('F'), {nameOf(word)});
    }
}

void setPlane(Execution& execution, const Word& word, Plane plane) {
    if (execution.state.compensation.on && plane != execution.state.plane) {
        execution.reporter.report(nc_message::kCompensationForbids, word, {nameOf(word)});
        return;
    }
    execution.state.plane = plane;
}

} // namespace

void setPlaneXy(Execution& execution, const Word& word) {
    setPlane(execution, word, Plane::xy);
}

void setPlaneZx(Execution& execution, const Word& word) {
    setPlane(execution, word, Plane::zx);
}

void setPlaneYz(Execution& execution, const Word& word) {
    setPlane(execution, word, Plane::yz);
}

void setInch(Execution& execution, const Word& word) {
    setUnits(execution, word, true);
}

void setMillimetre(Execution& execution, const Word& word) {
    setUnits(execution, word, false);
}

void setAbsolute(Execution& execution, const Word& /*word*/) {
    execution.state.incremental = false;
}

void setIncremental(Execution& execution, const Word& /*word*/) {
    execution.state.incremental = true;
}

void setArcCentreAbsolute(Execution& execution, const Word& /*word*/) {
    execution.state.arcCentreAbsolute = execution.state.arcCentreChosen = true;
}

void setArcCentreIncremental(Execution& execution, const Word& /*word*/) {
    execution.state.arcCentreAbsolute = false;
    execution.state.arcCentreChosen = true;
}

void refuseDiameters(Execution& execution, const Word& word) {
    execution.reporter.report(nc_message::kDiameterMode, word);
}

void selectPathControl(Execution& execution, const Word& word) {
    execution.state.pathControl = word.value;
}

void keepState(Execution& /*execution*/, const Word& /*word*/) {}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
// Transformations of coordinates by the program: G50, G51, G50.1, G51.1, G68, G69, and G100, G101 of Haas.
// Source: FANUC's operator's manuals, scaling, programmable mirror image, coordinate system rotation; Haas's
// manuals.

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "core/base/figures_argument.h"
#include "core/nc/codes/handlers.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

Transformation& transformation(Execution& execution) {
    return execution.state.frame.transformation;
}

/// Whether the block itself ends the rotation: that takes effect first, regardless of the order of the steps.
bool endsTurning(const Execution& execution) {
    constexpr double kEnd = 69;
    return std::ranges::any_of(execution.block.codes(),
                               [](const Word& word) { return word.letter == 'G' && word.value == kEnd; });
}

/// Mirror image, scaling and rotation must be nested in this order; reports a code that is programmed within
/// a later one.
void reportOrder(Execution& execution, const Word& word, bool scaling) {
    const Transformation& now = transformation(execution);
    const bool turned = now.turned && !endsTurning(execution);
    if (turned || (scaling && now.scaled))
        execution.reporter.report(nc_message::kTransformationOrder, word,
                                  {nameOf(word), turned ? "G68" : "G51"});
}

double factor(const Execution& execution, char letter) {
    const Word& word = execution.block.word(letter);
    return word.point ? word.value : word.value * execution.dialect.leastFactor;
}

/// The factors along the axes; nothing, with a report, if the block gives none, or 0.
std::optional<Vec3> factorsGiven(Execution& execution, const Word& word) {
    const Block& block = execution.block;
    if (!block.has('P') && !block.letters().any(LetterSet("IJK"))) {
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "P"});
        return {};
    }
    Vec3 factors(1);
    for (int axis = 0; axis < 3; ++axis) {
        const char letter = block.has('P') ? 'P' : static_cast<char>('I' + axis);
        if (!block.has(letter))
            continue;
        factors[axis] = factor(execution, letter);
        if (factors[axis] == 0) {
            execution.reporter.report(nc_message::kScaleFactor, block.word(letter), {std::string(1, letter)});
            return {};
        }
    }
    return factors;
}

void mirror(Execution& execution, const Word& word, const Vec3& at) {
    reportOrder(execution, word, true);
    Transformation& now = transformation(execution);
    for (int axis = 0; axis < 3; ++axis) {
        if (!execution.block.has(letterOfAxis(axis)))
            continue;
        now.mirrored |= axisBit(axis);
        now.mirrorAt[axis] = at[axis];
    }
}

void awaitPosition(Execution& execution, std::uint8_t turned, bool ended) {
    if (turned != 0)
        execution.state.turning = {turned, ended};
}

/// AxisBits of those axes of `centre` for which the tool position is used but unknown; this is reported.
std::uint8_t centreUnknown(Execution& execution, const Word& word, std::uint8_t centre) {
    const MachineState& state = execution.state;
    const std::uint8_t mixed = state.frame.mixedAxes();
    const auto known = (state.known & mixed) == mixed ? state.known : state.known & ~unsigned{mixed};
    const auto unknown = static_cast<std::uint8_t>(centre & ~known);
    if (unknown != 0)
        execution.reporter.report(nc_message::kCentreUnknown, word, {nameOf(word), namesOfAxes(unknown)});
    return unknown;
}

} // namespace

void mirrorAxes(Execution& execution, const Word& word) {
    if (!execution.block.letters().any(kAxisWords)) {
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "X"});
        return;
    }
    Vec3 at(0);
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(letterOfAxis(axis)))
            at[axis] = execution.length(letterOfAxis(axis));
    }
    mirror(execution, word, at);
}

void mirrorAboutZero(Execution& execution, const Word& word) {
    if (execution.block.letters().any(kAxisWords))
        mirror(execution, word, Vec3(0));
    else
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "X"});
}

void endMirror(Execution& execution, const Word& word) {
    Transformation& now = transformation(execution);
    if (now.mirrored == 0)
        return;
    reportOrder(execution, word, true);
    const bool all = !execution.block.letters().any(kAxisWords);
    for (int axis = 0; axis < 3; ++axis) {
        if (all || execution.block.has(letterOfAxis(axis)))
            now.mirrored &= static_cast<std::uint8_t>(~axisBit(axis));
    }
}

void scaleCoordinates(Execution& execution, const Word& word) {
    const auto factors = factorsGiven(execution, word);
    if (!factors)
        return;
    reportOrder(execution, word, false);
    const MachineState& state = execution.state;
    Transformation& now = transformation(execution);
    // An axis without a word is scaled about the position of the tool.
    const Vec3 current = now.unturn(state.frame.toWork(state.position));
    Vec3 given(0);
    std::uint8_t aboutTool = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(letterOfAxis(axis)))
            given[axis] = execution.length(letterOfAxis(axis));
        else if ((*factors)[axis] != 1)
            aboutTool |= axisBit(axis);
    }
    now.scaleUnknown = centreUnknown(execution, word, aboutTool);
    given = now.mirror(given);
    for (int axis = 0; axis < 3; ++axis)
        now.scaleAt[axis] = execution.block.has(letterOfAxis(axis)) ? given[axis] : current[axis];
    now.factors = *factors;
    now.scaled = true;
}

void endScaling(Execution& execution, const Word& word) {
    if (!transformation(execution).scaled)
        return;
    reportOrder(execution, word, false);
    transformation(execution).scaled = false;
    transformation(execution).factors = Vec3(1);
}

void turnCoordinates(Execution& execution, const Word& word) {
    if (!execution.block.has('R')) {
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "R"});
        return;
    }
    const MachineState& state = execution.state;
    Transformation& now = transformation(execution);
    const PlaneAxes plane = axes(state.plane);
    Vec3 centre = state.frame.toWork(state.position);
    std::uint8_t aboutTool = 0;
    for (const int axis : {plane.first, plane.second}) {
        if (!execution.block.has(letterOfAxis(axis))) {
            aboutTool |= axisBit(axis);
            continue;
        }
        Vec3 given(0);
        given[axis] = execution.length(letterOfAxis(axis));
        centre[axis] = now.stretch(given)[axis];
    }
    const bool open = state.incremental && now.turned && now.degrees != 0;
    const bool adds = execution.dialect.rotationAdds && open;
    now.degrees = execution.angle('R') + (adds ? now.degrees : 0);
    if (open)
        execution.reporter.report(nc_message::kRotationSetting, word, {figures("{:.6g}", now.degrees)});
    now.turnUnknown = centreUnknown(execution, word, aboutTool);
    now.turned = true;
    now.plane = state.plane;
    now.turnAt = centre;
    awaitPosition(execution, now.mixedAxes(), false);
}

void endTurning(Execution& execution, const Word& /*word*/) {
    Transformation& now = transformation(execution);
    const std::uint8_t turned = now.mixedAxes();
    now.turned = false;
    now.degrees = 0;
    awaitPosition(execution, turned, true);
}

} // namespace proveout

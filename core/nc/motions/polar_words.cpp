// SPDX-License-Identifier: GPL-3.0-or-later
// Polar coordinates of Fanuc's dialect: G15, G16. Source: FANUC's operator's manuals, polar coordinate
// command.
#include "core/nc/motions/polar_words.h"

#include <cmath>
#include <numbers>
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/state/execution.h"

namespace proveout {

std::uint8_t readPolarWords(Execution& execution, std::uint8_t known, Vec3& program) {
    const PlaneAxes plane = axes(execution.state.plane);
    const char radius = static_cast<char>('X' + plane.first);
    const char angle = static_cast<char>('X' + plane.second);
    const Block& block = execution.block;
    if (!block.has(radius) && !block.has(angle))
        return 0;
    PolarMode& polar = execution.state.polar;
    const bool incremental = execution.state.incremental;
    const auto bits = static_cast<std::uint8_t>(1U << static_cast<unsigned>(plane.first) |
                                                1U << static_cast<unsigned>(plane.second));
    if (incremental && execution.dialect.polarAboutTool)
        execution.reporter.report(nc_message::kPolarArc, block.word(block.has(radius) ? radius : angle),
                                  {"G91"});
    if (block.has(radius)) {
        if (incremental && (known & bits) != bits) {
            execution.reporter.report(nc_message::kIncrementalUnknown, block.word(radius),
                                      {std::string(1, radius)});
            return 0;
        }
        if (!execution.dialect.polarAboutTool)
            polar.pole = incremental ? program : Vec3(0);
        polar.radius = execution.length(radius);
    }
    if (block.has(angle))
        polar.degrees = execution.angle(angle) + (incremental ? polar.degrees : 0);
    const double turn = polar.degrees * std::numbers::pi / 180;
    program[plane.first] = polar.pole[plane.first] + polar.radius * std::cos(turn);
    program[plane.second] = polar.pole[plane.second] + polar.radius * std::sin(turn);
    return bits;
}

void beginPolar(Execution& execution, const Word& /*word*/) {
    const MachineState& state = execution.state;
    const PlaneAxes plane = axes(state.plane);
    const Vec3 program = state.frame.toProgram(state.position);
    const double first = program[plane.first];
    const double second = program[plane.second];
    execution.state.polar = {true, Vec3(0), std::hypot(first, second),
                             std::atan2(second, first) * 180 / std::numbers::pi};
}

void endPolar(Execution& execution, const Word& /*word*/) {
    execution.state.polar = {};
}

} // namespace proveout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/simulation/programs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

#include "core/nc/run/interpreter.h"

namespace proveout {

std::shared_ptr<const Program> programOf(const std::string& text) {
    return interpret(NcText(text));
}

std::string randomProgram(std::uint_fast32_t seed, int blocks) {
    std::mt19937 random(seed);
    const auto between = [&random](double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random);
    };
    std::string text = "G21 G90 G17 G54\nT1 M6\nS8000 M3\nG0 X0 Y0 Z5\n";
    for (int block = 1; block < blocks; ++block) {
        switch (std::uniform_int_distribution<int>(0, 9)(random)) {
        case 0:
            text += "G0 Z2\n";
            break;
        case 1: {
            const double i = between(-3, 3);
            text += fmt::format("G3 I{:.3f} J{:.3f} F900\n", i, between(0.5, 3));
            break;
        }
        case 2:
            text += fmt::format("G1 Z{:.3f} F300\n", between(-8, 0.5));
            break;
        default:
            text += fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f} F1200\n", between(-3, 43), between(-3, 33),
                                between(-8, 0.5));
        }
    }
    return text + "M30\n";
}

std::shared_ptr<const Program> programOfOneLongBlock() {
    return programOf("T1 M6\nG0 X250 Y250 Z5\nG1 Z1 F100\nG83 Z-50 R1 Q0.002\nG80\nG0 Z5\nM2\n");
}

std::shared_ptr<const Setup> wideSetup() {
    auto setup = std::make_shared<Setup>();
    setup->stock = {Vec3(0), 500, 500, 60};
    setup->spacing = 0.25;
    setup->tools.set(1, parseCutter("cone:d=100,angle=90").value());
    return setup;
}

std::shared_ptr<const Setup> smallSetup(double spacing) {
    auto setup = std::make_shared<Setup>();
    setup->stock = {Vec3(0), 40, 30, 10};
    setup->spacing = spacing;
    setup->tools.set(1, parseCutter("ball:d=4,l=20").value());
    return setup;
}

std::shared_ptr<const Setup> setupWithTool(int number, const std::string& spec) {
    auto setup = std::make_shared<Setup>(*smallSetup());
    setup->tools.set(number, parseCutter(spec).value());
    return setup;
}

} // namespace proveout

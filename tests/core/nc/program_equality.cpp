// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/program_equality.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <tuple>
#include <variant>

namespace proveout::test {

namespace {

std::uint64_t bits(double value) {
    return std::bit_cast<std::uint64_t>(value);
}

auto bits(const Vec3& v) {
    return std::tuple(bits(v.x), bits(v.y), bits(v.z));
}

auto fields(const Motion& m) {
    return std::tuple(m.kind, m.plane, m.startKnown, m.endKnown, m.startAtReference, m.endAtReference,
                      m.unverified, m.tool, m.line, bits(m.start), bits(m.end), bits(m.centre), bits(m.sweep),
                      bits(m.feedMmPerMin), m.perRevolution, bits(m.spindleRpm), bits(m.orderedRpm));
}

struct DataText {
    std::string operator()(const ToolChange& e) const { return fmt::format("tool {}", e.tool); }
    std::string operator()(const ToolLengthOffset& e) const { return "length " + of(e.offset); }
    std::string operator()(const Dwell& e) const { return fmt::format("dwell {:a}", e.seconds); }
    std::string operator()(const CoolantSwitch& e) const {
        return fmt::format("coolant {} {}", static_cast<int>(e.coolant), e.on);
    }
    std::string operator()(const ProgramStop& e) const {
        return fmt::format("stop {}", static_cast<int>(e.kind));
    }
    std::string operator()(const ProgramEnd&) const { return "end"; }
    std::string operator()(const UnitsChange& e) const { return fmt::format("inch {}", e.inch); }
    std::string operator()(const WorkOffset& e) const {
        return fmt::format("G54+{} ", e.system) + of(e.offset);
    }

    static std::string of(const Vec3& v) { return fmt::format("{:a} {:a} {:a}", v.x, v.y, v.z); }
};

std::string text(const Event& event) {
    return fmt::format("{} {} ", event.beforeMotion, event.line) + std::visit(DataText{}, event.data);
}

std::string text(const ControlState& state) {
    std::string text = fmt::format("line {}\n", state.line);
    for (const auto& mode : state.modes)
        text += fmt::format("{} {} {}\n", mode.code, mode.name, mode.group);
    for (const auto& place : state.places)
        text += fmt::format("{} {} {}\n", place.name, DataText::of(place.value), place.known);
    for (const auto& quantity : state.quantities)
        text += fmt::format("{} {:a} {}\n", quantity.name, quantity.value, quantity.unit);
    for (const auto& variable : state.variables)
        text += fmt::format("{} {:a}\n", variable.name, variable.value);
    for (const auto& call : state.calls)
        text += fmt::format("{} {} {}\n", call.program, call.line, call.file);
    return text;
}

std::string differenceOfMotions(const Program& a, const Program& b) {
    if (a.motionCount() != b.motionCount())
        return fmt::format("{} motions, {}", a.motionCount(), b.motionCount());
    for (std::size_t i = 0; i < a.motionCount(); ++i) {
        if (fields(a.motion(i)) != fields(b.motion(i)) ||
            bits(a.programmedEnd(i)) != bits(b.programmedEnd(i)))
            return fmt::format("motion {} of line {}, {}", i, a.motion(i).line, b.motion(i).line);
    }
    return {};
}

std::string differenceOfBlocks(const Program& a, const Program& b) {
    if (a.blockCount() != b.blockCount() || a.sourceBlockCount() != b.sourceBlockCount())
        return fmt::format("{} blocks of {}, {} of {}", a.blockCount(), a.sourceBlockCount(), b.blockCount(),
                           b.sourceBlockCount());
    for (std::size_t i = 0; i < a.blockCount(); ++i) {
        const std::uint32_t line = a.blockLine(i);
        if (line != b.blockLine(i) || a.blockMotions(i).first != b.blockMotions(i).first ||
            a.blocksBeforeLine(line) != b.blocksBeforeLine(line) ||
            a.blocksAfterLine(line) != b.blocksAfterLine(line) ||
            a.blocksAfterLine(line + 1) != b.blocksAfterLine(line + 1))
            return fmt::format("block {}", i);
    }
    return {};
}

std::string differenceOfMessages(const Program& a, const Program& b) {
    for (std::size_t i = 0; i < std::min(a.diagnostics().size(), b.diagnostics().size()); ++i) {
        const Diagnostic& one = a.diagnostics()[i];
        const Diagnostic& other = b.diagnostics()[i];
        if (one != other || a.motionAfterDiagnostic(i) != b.motionAfterDiagnostic(i))
            return fmt::format("{} in line {}, {} in line {}", one.id, one.where.line, other.id,
                               other.where.line);
    }
    return a.diagnostics().size() == b.diagnostics().size() ? "" : "the number of messages";
}

std::string differenceOfEvents(const Program& a, const Program& b) {
    for (std::size_t i = 0; i < std::min(a.events().size(), b.events().size()); ++i) {
        if (text(a.events()[i]) != text(b.events()[i]))
            return text(a.events()[i]) + ", " + text(b.events()[i]);
    }
    return a.events().size() == b.events().size() ? "" : "the number of events";
}

std::string differenceOfTheWhole(const Program& a, const Program& b) {
    if (text(a.controlState()) != text(b.controlState()))
        return text(a.controlState()) + ", " + text(b.controlState());
    if (bits(a.bounds().lo) != bits(b.bounds().lo) || bits(a.bounds().hi) != bits(b.bounds().hi))
        return "the bounds";
    return a.unverified() == b.unverified() && a.asksForTools() == b.asksForTools() &&
                   a.dialect() == b.dialect()
               ? ""
               : "verified, asked for tools, or the dialect";
}

} // namespace

std::string difference(const Program& a, const Program& b) {
    for (const auto part : {differenceOfMotions, differenceOfBlocks, differenceOfMessages, differenceOfEvents,
                            differenceOfTheWhole}) {
        if (std::string found = part(a, b); !found.empty())
            return found;
    }
    return {};
}

} // namespace proveout::test

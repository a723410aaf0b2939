// SPDX-License-Identifier: GPL-3.0-or-later
// Haas's circular pockets: G12, G13. Down in the middle, out from circle to circle, and back to the middle.
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/figures_argument.h"
#include "core/nc/codes/handlers.h"
#include "core/nc/motions/arc_words.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

constexpr int kMostRepeats = 9999;

class CircularPocket {
public:
    CircularPocket(Execution& execution, const Word& word, bool clockwise)
        : m_execution(execution), m_word(word), m_plane(axes(execution.state.plane)),
          m_middle(execution.state.frame.toProgram(execution.state.position)), m_turn(clockwise ? -1 : 1) {}

    void mill() {
        if (!readRadii() || !readRepeats())
            return;
        const double ofPass = 2.0 * static_cast<double>(m_radii.size()) + 2;
        if (!m_execution.mayMake(m_repeats * ofPass, m_word))
            return;
        m_execution.reporter.report(nc_message::kPocketWay, m_word);
        reportMissingFeed(m_execution, m_word);
        reportUnknownStart(m_execution, motionFromHere(m_execution, MotionKind::feed), m_word);
        for (int pass = 0; pass < m_repeats && !m_execution.mustEnd(); ++pass) {
            plunge();
            if (!circles())
                return;
        }
    }

private:
    [[nodiscard]] const Block& block() const { return m_execution.block; }
    bool refuse(const FindingRow& message, const Word& word, std::vector<Argument> arguments = {}) {
        m_execution.reporter.report(message, word, std::move(arguments));
        return false;
    }
    [[nodiscard]] std::string name() const { return fmt::format("G{:g}", m_word.value); }

    /// Radii of the tool centre's path, growing: I alone, or from I by Q to K.
    bool readRadii() {
        if (!block().has('I'))
            return refuse(nc_message::kWordMissing, m_word, {name(), "I"});
        double radius = m_execution.length('I');
        const double last = block().has('K') ? m_execution.length('K') : radius;
        const double step = block().has('Q') ? m_execution.length('Q') : 0;
        if (last != radius && step <= 0)
            return refuse(nc_message::kWordMissing, m_word, {name(), "Q"});
        double tool = 0;
        if (!readTool(tool))
            return false;
        if (radius <= tool || last < radius)
            return refuse(nc_message::kPocketSmall, block().word('I'),
                          {figures("{:.6g}", radius), figures("{:.6g}", last), figures("{:.6g}", tool)});
        const double least = m_execution.leastLength();
        if ((last - radius) / std::max(step, least) > kMostRepeats)
            return refuse(nc_message::kNotInteger, block().word('Q'),
                          {"(K - I) / Q", "0", std::to_string(kMostRepeats)});
        for (; radius < last - least / 2; radius += step)
            m_radii.push_back(radius - tool);
        m_radii.push_back(last - tool);
        return true;
    }

    /// The radius by which the tool stays inside the pocket; 0 without D.
    bool readTool(double& radius) {
        if (!block().has('D') || block().value('D') == 0)
            return true;
        const Word& word = block().word('D');
        const ToolOffset* tool = word.value == std::round(word.value) && word.value > 0
                                     ? m_execution.tools.find(static_cast<int>(word.value))
                                     : nullptr;
        if (tool == nullptr)
            return refuse(nc_message::kOffsetUnknown, word, {fmt::format("{:g}", word.value)});
        radius = tool->diameter / 2;
        if (radius == 0)
            m_execution.reporter.report(nc_message::kCompensationNoDiameter, word,
                                        {fmt::format("D{:g}", word.value)});
        return true;
    }

    bool readRepeats() {
        if (!block().has('L'))
            return true;
        const Word& word = block().word('L');
        if (word.value < 1 || word.value > kMostRepeats || word.value != std::round(word.value))
            return refuse(nc_message::kNotInteger, word, {"L", "1", std::to_string(kMostRepeats)});
        m_repeats = static_cast<int>(word.value);
        return true;
    }

    void plunge() {
        const char letter = static_cast<char>('X' + m_plane.normal);
        if (!block().has(letter))
            return;
        const double level = m_execution.length(letter);
        m_middle[m_plane.normal] = level + (m_execution.state.incremental ? m_middle[m_plane.normal] : 0.0);
        Motion motion = motionFromHere(m_execution, MotionKind::feed);
        motion.end = m_execution.state.frame.toMachine(m_middle);
        if (!m_execution.state.incremental)
            motion.endKnown |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(m_plane.normal));
        motion.endAtReference = false;
        appendMotion(m_execution, motion);
    }

    /// Half circles lead from the middle to the first circle, from each to the next, and back.
    bool circles() {
        double side = 0; ///< position of the tool along the first axis, relative to the middle
        double sign = 1;
        for (const double radius : m_radii) {
            if (!turn(side, sign * radius, 1) || !turn(sign * radius, sign * radius, 2))
                return false;
            side = sign * radius;
            sign = -sign;
        }
        return turn(side, 0, 1);
    }

    /// An arc of half turns between two places on the first axis.
    bool turn(double from, double to, int halves) {
        const double about = halves == 2 ? 0 : (from + to) / 2;
        Motion motion = motionFromHere(m_execution, MotionKind::arc);
        motion.end = place(to);
        motion.centre = place(about);
        motion.sweep = m_turn * std::numbers::pi * halves;
        if (!planeKnown(motion) || !fitForSize(m_execution, m_word, motion))
            return false;
        appendMotion(m_execution, motion);
        return true;
    }

    [[nodiscard]] Vec3 place(double along) const {
        Vec3 program = m_middle;
        program[m_plane.first] += along;
        return m_execution.state.frame.toMachine(program);
    }

    Execution& m_execution;
    const Word& m_word;
    PlaneAxes m_plane;
    Vec3 m_middle; ///< program coordinates, at the current level
    double m_turn; ///< 1 counter-clockwise, -1 clockwise
    std::vector<double> m_radii;
    int m_repeats = 1;
};

} // namespace

void millPocketClockwise(Execution& execution, const Word& word) {
    CircularPocket(execution, word, true).mill();
}

void millPocketCounterClockwise(Execution& execution, const Word& word) {
    CircularPocket(execution, word, false).mill();
}

} // namespace proveout

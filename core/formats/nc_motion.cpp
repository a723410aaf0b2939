// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/nc_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <ostream>
#include <type_traits>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace proveout {

namespace {

constexpr std::size_t kFlushAt = 1 << 16;
constexpr std::size_t kLongestSource = 252;

/// Rounded to a picometre, as the format does; without "-0".
double rounded(double value) {
    if (std::abs(value) > 1e6)
        return value;
    const double result = std::round(value * 1e9) / 1e9;
    return result == 0 ? 0 : result;
}

std::string jsonString(std::string_view text) {
    return nlohmann::json(std::string(text)).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

class Writer {
public:
    Writer(std::ostream& out, const Program& program, const NcText& text)
        : m_out(out), m_program(program), m_text(text) {}

    void write(const NcMotionMeta& meta) {
        const Vec3 start = meta.start.value_or(Vec3(0));
        print(R"({{"k":"meta","format":"nc-motion/1","by":{},"file":{},"bytes":{},"block_delete":{},)"
              R"("start":{},"start_assumed":{},"resolution":1e-09}})",
              jsonString(meta.by), jsonString(meta.file), m_text.size(), meta.blockDelete, vector(start),
              !meta.start.has_value());
        for (std::size_t i = 0; i < m_program.motionCount(); ++i) {
            writeUpTo(i);
            writeMotion(m_program.motion(i));
        }
        writeUpTo(m_program.motionCount());
        writeSum();
        flush();
    }

private:
    template<class... Args>
    void print(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(m_buffer), format, std::forward<Args>(args)...);
        m_buffer.push_back('\n');
        if (m_buffer.size() >= kFlushAt)
            flush();
    }

    void flush() {
        m_out.write(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
        m_buffer.clear();
    }

    static std::string vector(const Vec3& v) {
        return fmt::format("[{},{},{}]", rounded(v.x), rounded(v.y), rounded(v.z));
    }

    /// Writes events and messages that come before motion `index`, ordered by line.
    void writeUpTo(std::size_t index) {
        const auto& events = m_program.events();
        const auto& messages = m_program.diagnostics();
        for (;;) {
            const bool event = m_event < events.size() && events[m_event].beforeMotion <= index;
            const bool message =
                m_message < messages.size() && m_program.motionAfterDiagnostic(m_message) <= index;
            if (!event && !message)
                return;
            if (message && (!event || isFirst(messages[m_message], events[m_event])))
                writeMessage(messages[m_message++]);
            else
                writeEvent(events[m_event++]);
        }
    }

    [[nodiscard]] bool isFirst(const Diagnostic& message, const Event& event) const {
        const std::size_t before = m_program.motionAfterDiagnostic(m_message);
        return before != event.beforeMotion ? before < event.beforeMotion
                                            : message.where.line < static_cast<int>(event.line);
    }

    void writeMotion(const Motion& motion) {
        const char* const kind = motion.probing                     ? "probe"
                                 : motion.kind == MotionKind::rapid ? "rapid"
                                 : motion.kind == MotionKind::feed  ? "feed"
                                                                    : "arc";
        ++m_counts[kind];
        m_lengths[static_cast<std::size_t>(motion.kind)] += pathLength(motion);
        if (motion.kind == MotionKind::arc)
            m_bounds.add(bounds(motion));
        else
            m_bounds.add(motion.end);
        const char* const unverified = motion.unverified ? R"(,"unverified":true)" : "";
        if (motion.kind == MotionKind::rapid) {
            print(R"({{"k":"rapid","l":{},"e":{}{}}})", motion.line, vector(motion.end), unverified);
            return;
        }
        const double turns = motion.perRevolution ? std::abs(motion.spindleRpm) : 1.0;
        print(R"({{"k":"{}","l":{},"e":{},"f":{},"fm":"{}","s":{},"d":{},"t":{}{}{}}})", kind, motion.line,
              vector(motion.end), static_cast<float>(turns > 0 ? motion.feedMmPerMin / turns : 0.0),
              motion.perRevolution ? "rev" : "min", motion.orderedRpm,
              (motion.spindleRpm > 0) - (motion.spindleRpm < 0), motion.tool, arcKeys(motion), unverified);
    }

    static std::string arcKeys(const Motion& motion) {
        if (motion.kind != MotionKind::arc)
            return {};
        Vec3 normal(0);
        normal[axes(motion.plane).normal] = 1;
        return fmt::format(R"(,"c":{},"n":{},"w":{},"r":{})", vector(motion.centre), vector(normal),
                           rounded(motion.sweep), rounded(arcRadius(motion)));
    }

    void writeEvent(const Event& event) {
        const auto [kind, keys] = std::visit([](const auto& data) { return describe(data); }, event.data);
        ++m_counts[kind];
        m_ended = m_ended || std::holds_alternative<ProgramEnd>(event.data);
        print(R"({{"k":"{}","l":{}{}}})", kind, event.line, keys);
    }

    struct EventKeys {
        const char* kind;
        std::string keys;
    };
    static EventKeys describe(const ToolChange& change) {
        return {"tool", fmt::format(R"(,"t":{})", change.tool)};
    }
    static EventKeys describe(const ToolLengthOffset& offset) {
        return {"tlo", fmt::format(R"(,"v":{})", vector(offset.offset))};
    }
    static EventKeys describe(const Dwell& dwell) {
        return {"dwell", fmt::format(R"(,"sec":{})", rounded(dwell.seconds))};
    }
    static EventKeys describe(const CoolantSwitch& coolant) {
        return {"coolant", fmt::format(R"(,"v":"{}_{}")", coolant.coolant == Coolant::mist ? "mist" : "flood",
                                       coolant.on ? "on" : "off")};
    }
    static EventKeys describe(const ProgramStop& stop) {
        return {"stop", fmt::format(R"(,"opt":{})", stop.kind == StopKind::optional)};
    }
    static EventKeys describe(const ProgramEnd& /*end*/) { return {"end", {}}; }
    static EventKeys describe(const UnitsChange& units) {
        return {"units", fmt::format(R"(,"u":"{}")", units.inch ? "inch" : "mm")};
    }
    static EventKeys describe(const WorkOffset& offset) {
        return {"offset", fmt::format(R"(,"wcs":{},"v":{})", offset.system, vector(offset.offset))};
    }

    void writeMessage(const Diagnostic& diagnostic) {
        const char* const kind = name(std::min(diagnostic.severity, Severity::error));
        ++m_counts[kind];
        print(R"({{"k":"{}","l":{},"col":{},"msg":{},"src":{},"cls":"{}"}})", kind, diagnostic.where.line,
              diagnostic.where.column, jsonString(message(diagnostic)),
              jsonString(source(diagnostic.where.line)), diagnostic.id);
    }

    [[nodiscard]] std::string_view source(int line) const {
        const auto index = static_cast<std::size_t>(line) - 1;
        return line > 0 && index < m_text.lineCount() ? m_text.line(index).substr(0, kLongestSource)
                                                      : std::string_view();
    }

    void writeSum() {
        std::string counts;
        for (const auto& [kind, count] : m_counts)
            fmt::format_to(std::back_inserter(counts), R"({}"{}":{})", counts.empty() ? "" : ",", kind,
                           count);
        print(R"({{"k":"sum","n":{{{}}},"lo":{},"hi":{},"len":{{"rapid":{:.6f},"feed":{:.6f},"arc":{:.6f}}},)"
              R"("ended":{}}})",
              counts, m_bounds.empty() ? "null" : vector(m_bounds.lo),
              m_bounds.empty() ? "null" : vector(m_bounds.hi), m_lengths[0], m_lengths[1], m_lengths[2],
              m_ended);
    }

    std::ostream& m_out;
    const Program& m_program;
    const NcText& m_text;
    fmt::memory_buffer m_buffer;
    std::size_t m_event = 0;
    std::size_t m_message = 0;
    std::map<std::string, std::size_t> m_counts;
    std::array<double, 3> m_lengths{};
    Box3 m_bounds;
    bool m_ended = false;
};

} // namespace

void writeNcMotion(std::ostream& out, const Program& program, const NcText& text, const NcMotionMeta& meta) {
    Writer(out, program, text).write(meta);
}

} // namespace proveout

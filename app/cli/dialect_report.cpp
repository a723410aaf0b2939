// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/dialect_report.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "core/nc/codes/dialects.h"
#include "core/nc/run/dialect_comparison.h"

namespace proveout::cli {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMostLines = 100'000;

double shown(double value) {
    return std::round(value * 1e6) / 1e6;
}

ordered_json pointOf(const Vec3& point) {
    return ordered_json::array({shown(point.x), shown(point.y), shown(point.z)});
}

ordered_json motionsOf(const std::vector<Motion>& motions) {
    auto list = ordered_json::array();
    for (const Motion& motion : motions) {
        const char* const kind = motion.kind == MotionKind::rapid  ? "rapid"
                                 : motion.kind == MotionKind::feed ? "feed"
                                                                   : "arc";
        ordered_json row{{"k", kind}, {"e", pointOf(motion.end)}};
        if (motion.kind == MotionKind::arc) {
            row["c"] = pointOf(motion.centre);
            row["sweep"] = shown(motion.sweep);
        }
        if (motion.kind != MotionKind::rapid)
            row["f"] = shown(motion.feedMmPerMin);
        list.push_back(std::move(row));
    }
    return list;
}

} // namespace

void writeDifferences(std::ostream& out, const NcText& text, InterpretOptions options, DialectId one,
                      DialectId other) {
    options.dialect = one;
    const auto first = interpret(text, options);
    options.dialect = other;
    const auto second = interpret(text, options);
    const auto lines = differentLines(*first, *second, kMostLines);
    const auto dump = [&out](const ordered_json& row) {
        out << row.dump(-1, ' ', true, ordered_json::error_handler_t::replace) << '\n';
    };
    for (const LineDifference& line : lines) {
        ordered_json row{{"k", "differs"},
                         {"l", line.line},
                         {"run", line.execution + 1},
                         {"src", std::string(text.line(line.line - 1))}};
        row[dialect(one).key] = motionsOf(line.one);
        row[dialect(other).key] = motionsOf(line.other);
        dump(row);
    }
    dump({{"k", "sum"},
          {"differs", lines.size()},
          {"unverified",
           {{dialect(one).key, first->unverified()}, {dialect(other).key, second->unverified()}}}});
}

} // namespace proveout::cli

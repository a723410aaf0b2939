// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/study_csv.h"

#include <fmt/format.h>
#include <iterator>

namespace proveout {

namespace {

/// Quoted according to RFC 4180.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

const char* keyOf(std::span<const Choice> choices, auto value) {
    return choices[static_cast<std::size_t>(value)].key;
}

} // namespace

std::string chartCsv(const Chart& chart) {
    std::string out = fmt::format(
        "curve,{},{}\n", quoted(chart.xLabel),
        quoted(chart.rightLabel.empty() ? chart.yLabel : chart.yLabel + " | " + chart.rightLabel));
    for (const Curve& curve : chart.curves)
        for (const Vec2& point : curve.points)
            fmt::format_to(std::back_inserter(out), "{},{:.8g},{:.8g}\n", quoted(curve.label), point.x,
                           point.y);
    return out;
}

std::string sweepCsv(std::span<const SweptPoint> points) {
    std::string out =
        "method,region,period,allowance,certify,borders,order,blocks,faces,regionsShown,moments,"
        "regionsDecimated,facesMade,cutSeconds,decimateSeconds,uploadSeconds,drawSeconds,"
        "otherSeconds,totalSeconds,spread\n";
    for (const SweptPoint& point : points) {
        const DecimationParameters& p = point.run.point.parameters;
        const WorkCount& n = point.run.count;
        const PhaseSeconds& t = point.run.seconds;
        fmt::format_to(
            std::back_inserter(out),
            "{},{},{},{},{},{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.3g}\n",
            keyOf(kMethodChoices, p.method), p.regionCells, p.period, p.allowance, p.certify ? 1 : 0,
            keyOf(kBorderChoices, p.borders), keyOf(kOrderChoices, p.order), n.frames, n.faces,
            n.regionsShown, n.moments, n.regionsDecimated, n.facesMade, t.cut, t.decimate, t.upload, t.draw,
            t.other, point.seconds.median, point.seconds.spread);
    }
    return out;
}

} // namespace proveout

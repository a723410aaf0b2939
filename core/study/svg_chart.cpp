// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/svg_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>

#include "core/base/markup.h"
#include "core/study/axis_ticks.h"
#include "core/study/curve_style.h"
#include "core/study/svg_text.h"

namespace proveout {

namespace {

constexpr int kLowPicture = 320; ///< if the picture is lower, the curves need the space of the title
constexpr int kTop = 72;
constexpr int kLowTop = 26;
constexpr int kBottom = 58;
constexpr int kLowBottom = 42;
constexpr int kLegendRow = 22;
constexpr int kLowLegendRow = 17;
constexpr int kLeastSide = 120; ///< of the frame and its margins, regardless of the requested size
constexpr int kLeft = 92;
constexpr int kLegendWidth = 214;   ///< at least
constexpr int kLegendEdge = 70;     ///< the part of it that is not text
constexpr int kRightAxisWidth = 78; ///< at least
constexpr int kRightAxisEdge = 40;  ///< the part of it that is not labels
constexpr double kHeadRoom = 0.04;  ///< as a part of the height, above the highest point

bool finite(const Vec2& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
}

struct Range {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -std::numeric_limits<double>::infinity();

    void add(double value) {
        lo = std::min(lo, value);
        hi = std::max(hi, value);
    }
    [[nodiscard]] bool empty() const { return lo > hi; }
};

class Drawing {
public:
    Drawing(const Chart& chart, int width, int height)
        : m_chart(chart), m_width(std::max(width, kLeft + kLegendWidth + kRightAxisWidth + kLeastSide)),
          m_height(std::max(height, kLeastSide)), m_low(height < kLowPicture), m_top(m_low ? kLowTop : kTop),
          m_bottom(m_height - (m_low ? kLowBottom : kBottom)) {
        layOut();
    }

    std::string document() {
        put("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
            "font-family=\"DejaVu Sans, Arial, sans-serif\" font-size=\"13\" fill=\"#222222\">\n",
            m_width, m_height);
        put("<title>{}</title>\n", escaped(m_chart.title));
        put("<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n", m_width, m_height);
        if (!m_low)
            title();
        axes();
        for (const bool faint : {true, false}) // points are drawn behind the curve that summarizes them
            for (const Curve& curve : m_chart.curves)
                if ((curve.look == CurveLook::faint) == faint)
                    draw(curve);
        legend();
        put("</svg>\n");
        return std::move(m_out);
    }

private:
    template<class... Arguments>
    void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(m_out), format, std::forward<Arguments>(arguments)...);
    }

    [[nodiscard]] bool usable(const Vec2& point) const {
        return finite(point) && (!m_chart.logarithmicX || point.x > 0);
    }

    void layOut() {
        for (const Curve& curve : m_chart.curves)
            if (curve.inLegend)
                m_legendWidth =
                    std::max(m_legendWidth, static_cast<int>(textWidth(curve.label)) + kLegendEdge);
        m_legendWidth = std::min(m_legendWidth, 2 * m_width / 5);
        Range x;
        std::array<Range, 2> y;
        for (const Curve& curve : m_chart.curves)
            for (const Vec2& point : curve.points)
                if (usable(point)) {
                    x.add(point.x);
                    y.at(curve.rightAxis ? 1 : 0).add(point.y);
                }
        if (x.empty())
            x = {m_chart.logarithmicX ? 1.0 : 0.0, m_chart.logarithmicX ? 10.0 : 1.0};
        m_x = m_chart.logarithmicX ? logarithmicTicks(x.lo, x.hi) : linearTicks(x.lo, x.hi, 8);
        if (!m_chart.logarithmicX) { // no empty margin beside the data, and marks only inside
            m_x.lo = std::min(m_x.hi, x.lo < x.hi ? x.lo : m_x.lo);
            m_x.hi = x.lo < x.hi ? x.hi : m_x.hi;
        }
        if (m_chart.topOfLeft > 0)
            y[0].hi = std::min(y[0].hi, m_chart.topOfLeft);
        for (std::size_t side = 0; side < y.size(); ++side) {
            if (y.at(side).empty())
                y.at(side) = {0, 1};
            const double lo = std::min(0.0, y.at(side).lo); // ratios and times start at zero
            m_y.at(side) = linearTicks(lo, y.at(side).hi + kHeadRoom * (y.at(side).hi - lo), m_low ? 3 : 6);
        }
        if (!m_chart.rightLabel.empty())
            m_rightAxisWidth = kRightAxisWidth;
        for (const std::string& label : m_y[1].labels)
            if (!m_chart.rightLabel.empty())
                m_rightAxisWidth =
                    std::max(m_rightAxisWidth, static_cast<int>(textWidth(label)) + kRightAxisEdge);
        m_right = m_width - m_legendWidth - m_rightAxisWidth;
    }

    [[nodiscard]] double px(double x) const {
        const auto place = [this](double value) { return m_chart.logarithmicX ? std::log(value) : value; };
        return kLeft + (m_right - kLeft) * (place(x) - place(m_x.lo)) / (place(m_x.hi) - place(m_x.lo));
    }
    [[nodiscard]] double py(double y, bool rightAxis) const {
        const AxisTicks& axis = m_y.at(rightAxis ? 1 : 0);
        return m_bottom - (m_bottom - m_top) * (y - axis.lo) / (axis.hi - axis.lo);
    }

    void title() {
        put("<text x=\"{}\" y=\"30\" font-size=\"18\" font-weight=\"bold\">{}</text>\n", kLeft,
            escaped(m_chart.title));
        put("<text x=\"{}\" y=\"52\" fill=\"#555555\">{}</text>\n", kLeft, escaped(m_chart.subtitle));
    }

    void axes() {
        const AxisTicks& left = m_y[0];
        for (std::size_t k = 0; k < left.places.size(); ++k) {
            const double y = py(left.places[k], false);
            put("<line x1=\"{}\" y1=\"{:.1f}\" x2=\"{}\" y2=\"{:.1f}\" stroke=\"#e2e2e2\"/>\n", kLeft, y,
                m_right, y);
            put("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", kLeft - 8, y + 4.5,
                left.labels[k]);
        }
        for (std::size_t k = 0; k < m_x.places.size(); ++k) {
            const double x = px(m_x.places[k]);
            if (x < kLeft - 0.5 || x > m_right + 0.5)
                continue;
            put("<line x1=\"{:.1f}\" y1=\"{}\" x2=\"{:.1f}\" y2=\"{}\" stroke=\"#e2e2e2\"/>\n", x, m_top, x,
                m_bottom);
            put("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", x,
                m_bottom + (m_low ? 17 : 20), m_x.labels[k]);
        }
        put("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#666666\"/>\n", kLeft,
            m_top, m_right - kLeft, m_bottom - m_top);
        put("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", (kLeft + m_right) / 2,
            m_height - (m_low ? 6 : 14), escaped(m_chart.xLabel));
        sideLabel(m_chart.yLabel, false);
        if (m_chart.rightLabel.empty())
            return;
        for (std::size_t k = 0; k < m_y[1].places.size(); ++k)
            put("<text x=\"{}\" y=\"{:.1f}\">{}</text>\n", m_right + 8, py(m_y[1].places[k], true) + 4.5,
                m_y[1].labels[k]);
        sideLabel(m_chart.rightLabel, true);
    }

    /// Along its axis; above it if the axis is shorter than the text.
    void sideLabel(const std::string& text, bool right) {
        if (m_low) {
            put("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", right ? m_right : kLeft, m_top - 9,
                right ? "end" : "start", escaped(text));
            return;
        }
        const int x = right ? m_right + m_rightAxisWidth - 8 : 20;
        put("<text x=\"{0}\" y=\"{1}\" text-anchor=\"middle\" transform=\"rotate(-90 {0} {1})\">{2}</text>\n",
            x, (m_top + m_bottom) / 2, escaped(text));
    }

    /// The points in the picture, clamped to the frame; of each column only the first, the lowest, the
    /// highest and the last.
    [[nodiscard]] std::vector<Vec2> pixels(const Curve& curve) const {
        std::vector<Vec2> all;
        for (const Vec2& point : curve.points)
            if (usable(point))
                all.emplace_back(px(point.x), std::max<double>(m_top, py(point.y, curve.rightAxis)));
        if (all.size() <= static_cast<std::size_t>(2 * m_width))
            return all;
        std::vector<Vec2> kept;
        const auto lower = [](const Vec2& a, const Vec2& b) { return a.y < b.y; };
        for (auto begin = all.begin(); begin != all.end();) {
            const double column = std::floor(begin->x);
            const auto end = std::find_if(
                begin, all.end(), [column](const Vec2& point) { return std::floor(point.x) != column; });
            auto [low, high] = std::minmax_element(begin, end, lower);
            if (high < low)
                std::swap(low, high);
            for (const auto& place : {begin, low, high, std::prev(end)})
                if (kept.empty() || kept.back() != *place)
                    kept.push_back(*place);
            begin = end;
        }
        return kept;
    }

    void draw(const Curve& curve) {
        const std::vector<Vec2> points = pixels(curve);
        const CurveStyle& look = style(curve);
        const bool faint = curve.look == CurveLook::faint;
        put("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\"{}\" "
            "stroke-dasharray=\"{}\" stroke-linejoin=\"round\" points=\"",
            look.colour, faint ? 0.7 : 1.8, faint ? 0.35 : 1.0, dashOf(curve));
        for (const Vec2& point : points)
            put("{:.1f},{:.1f} ", point.x, point.y);
        put("\"/>\n");
        if (curve.look == CurveLook::marked)
            for (const Vec2& point : points)
                marker(point, look);
    }

    void marker(const Vec2& at, const CurveStyle& look) {
        constexpr double kRadius = 4.5;
        if (look.corners == 0) {
            put("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>\n", at.x, at.y, kRadius - 0.5,
                look.colour);
            return;
        }
        put("<polygon fill=\"{}\" points=\"", look.colour);
        for (int k = 0; k < look.corners; ++k) {
            const double angle = 2 * 3.14159265358979 * k / look.corners;
            put("{:.1f},{:.1f} ", at.x + kRadius * std::sin(angle), at.y - kRadius * std::cos(angle));
        }
        put("\"/>\n");
    }

    void legend() {
        const int x = m_width - m_legendWidth + 22;
        int y = m_top + 12;
        for (const Curve& curve : m_chart.curves) {
            if (!curve.inLegend)
                continue;
            const CurveStyle& look = style(curve);
            put("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\" stroke-width=\"{}\" "
                "stroke-dasharray=\"{}\"/>\n",
                x, y - 4, x + 34, y - 4, look.colour, curve.look == CurveLook::faint ? 0.7 : 1.8,
                dashOf(curve));
            if (curve.look == CurveLook::marked)
                marker({x + 17, y - 4}, look);
            put("<text x=\"{}\" y=\"{}\">{}</text>\n", x + 42, y, escaped(curve.label));
            y += m_low ? kLowLegendRow : kLegendRow;
        }
    }

    const Chart& m_chart;
    std::string m_out;
    int m_width;
    int m_height;
    bool m_low;
    int m_top;    ///< of the frame
    int m_bottom; ///< of the frame
    int m_legendWidth = kLegendWidth;
    int m_rightAxisWidth = 0;
    int m_right = 0;
    AxisTicks m_x;
    std::array<AxisTicks, 2> m_y;
};

} // namespace

std::string svgChart(const Chart& chart, int width, int height) {
    return Drawing(chart, width, height).document();
}

} // namespace proveout

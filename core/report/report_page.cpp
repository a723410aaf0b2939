// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/markup.h"
#include "core/report/assets.h"
#include "core/report/base64.h"

namespace proveout {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMostIslands = 200;

std::string clockOf(double seconds) {
    const auto whole = static_cast<long long>(std::llround(seconds));
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

class Page {
public:
    Page(const ordered_json& checked, const ReportHead& head, const ReportPictures& pictures)
        : m_checked(checked), m_head(head), m_pictures(pictures) {}

    std::string take() {
        begin();
        addSummary();
        addPart();
        addFindings();
        addNotChecked();
        addTools();
        addRun();
        addInputs();
        end();
        return std::move(m_html);
    }

private:
    template<class... Values>
    void add(fmt::format_string<Values...> text, Values&&... values) {
        fmt::format_to(std::back_inserter(m_html), text, std::forward<Values>(values)...);
    }

    /// A number of the JSON with the pointer to it.
    [[nodiscard]] std::string number(const std::string& pointer, int decimals) const {
        return shown(pointer, fmt::format("{:.{}f}", at(pointer).get<double>(), decimals));
    }
    [[nodiscard]] std::string clock(const std::string& pointer) const {
        return shown(pointer, clockOf(at(pointer).get<double>()));
    }
    [[nodiscard]] std::string shown(const std::string& pointer, const std::string& text) const {
        return fmt::format("<data value=\"{}\" data-key=\"{}\">{}</data>", at(pointer).dump(), pointer, text);
    }
    [[nodiscard]] std::string text(const std::string& pointer) const {
        const ordered_json::json_pointer place(pointer);
        return m_checked.contains(place) ? escaped(at(pointer).get<std::string>()) : std::string();
    }
    [[nodiscard]] const ordered_json& at(const std::string& pointer) const {
        return m_checked.at(ordered_json::json_pointer(pointer));
    }
    [[nodiscard]] bool has(const std::string& pointer) const {
        return m_checked.contains(ordered_json::json_pointer(pointer));
    }

    void begin() {
        add("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data: blob:; "
            "style-src 'unsafe-inline'; script-src 'unsafe-inline'; connect-src data: blob:\">"
            "<title>{} – report</title>\n<style>{}</style></head>\n<body><main>\n",
            escaped(m_head.title), reportStyle());
        const std::string verdict = text("/verdict");
        add("<header><h1>{}</h1><span class=\"badge {}\">{}</span><span "
            "class=\"soft\">{}{}{}</span></header>\n",
            escaped(m_head.title), verdict, verdict, escaped(m_head.company),
            m_head.company.empty() ? "" : " · ", escaped(m_head.date));
    }

    void addSummary() {
        static constexpr std::array<std::pair<const char*, const char*>, 3> kMeanings{
            {{"safe",
              "All of the program was checked, but for what was accepted by name, and nothing was found."},
             {"faults", "The program would cause damage, or make a wrong part."},
             {"unverified", "A part of the program was not checked."}}};
        for (const auto& [verdict, meaning] : kMeanings)
            if (verdict == text("/verdict"))
                add("<p>{}</p>\n", meaning);
        if (!m_pictures.stockPng.empty() && m_pictures.deviationPng.empty())
            addPicture(m_pictures.stockPng, "The stock at the end of the program, from above.");
    }

    void addPicture(const std::string& png, const char* caption) {
        add("<figure><img alt=\"{}\" src=\"data:image/png;base64,{}\"><figcaption>{}</figcaption></figure>\n",
            caption, base64Of(png), caption);
    }

    void addPart() {
        if (!has("/part"))
            return;
        add("<h2>Part</h2>\n<p>Gouges: {}, excesses: {}. Allowed: −{} to +{} mm", number("/part/gouges", 0),
            number("/part/excesses", 0), number("/part/tolerance/below", 3),
            number("/part/tolerance/above", 3));
        if (at("/part/tolerance/allowance") != 0.0)
            add(" from an allowance of {} mm", number("/part/tolerance/allowance", 3));
        add(". Deviations from {} to {} mm at {} points, normal to the surface. Missing: {} mm³; left: {} "
            "mm³.</p>\n",
            number("/part/lowestMm", 3), number("/part/highestMm", 3), number("/part/points", 0),
            number("/part/missingMm3", 2), number("/part/leftMm3", 2));
        addView();
        add("<div class=\"pair\">\n");
        if (!m_pictures.deviationPng.empty())
            addPicture(m_pictures.deviationPng,
                       "Deviations from above; the colour of a pixel is that of its worst point.");
        addHistogram();
        add("</div>\n");
        addKey();
        addIslands();
    }

    void addView() {
        if (m_pictures.glb.empty() || threeScript().empty())
            return;
        add("<div id=\"view\" class=\"only-screen\" data-none=\"This browser shows no 3D.\"></div>\n"
            "<p class=\"soft only-screen\">The stock at the end: drag to turn, wheel to zoom, right button "
            "to move. "
            "The mesh is within {:.3f} mm of the simulated stock.</p>\n",
            m_pictures.glbErrorMm);
    }

    void addKey() {
        add("<p class=\"key\"><span><i style=\"background:#d55e00\"></i>missing</span>"
            "<span><i style=\"background:#cdd4cd\"></i>in tolerance</span>"
            "<span><i style=\"background:#0072b2\"></i>left</span></p>\n");
    }

    /// Bars on a logarithmic scale, because most points are in tolerance.
    void addHistogram() {
        constexpr double kWidth = 420;
        constexpr double kHeight = 200;
        const auto points = at("/part/histogram/points").get<std::vector<double>>();
        const double first = at("/part/histogram/firstMm").get<double>();
        const double width = at("/part/histogram/binMm").get<double>();
        const double below = at("/part/tolerance/below").get<double>();
        const double above = at("/part/tolerance/above").get<double>();
        const double highest = std::log1p(*std::ranges::max_element(points));
        const double step = kWidth / static_cast<double>(points.size());
        const auto xOf = [&](double mm) { return ((mm - first) / width + 0.5) * step; };
        add("<figure><svg viewBox=\"0 -4 {} {}\" role=\"img\" aria-label=\"Histogram of the deviations\">\n",
            kWidth, kHeight + 24);
        for (std::size_t bin = 0; bin < points.size(); ++bin) {
            if (points[bin] == 0)
                continue;
            const double middle = first + width * static_cast<double>(bin);
            const char* kind = middle < -below ? "low" : middle > above ? "high" : "in";
            const double height = kHeight * std::log1p(points[bin]) / highest;
            add("<rect class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>\n", kind,
                step * static_cast<double>(bin), kHeight - height, step - 1, height);
        }
        for (const double limit : {-below, above})
            add("<line class=\"limit\" x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"0\" y2=\"{1}\"/>"
                "<text x=\"{0:.2f}\" y=\"{2}\" text-anchor=\"middle\">{3:+g}</text>\n",
                xOf(limit), kHeight, kHeight + 16, limit);
        add("</svg><figcaption>How many points deviate by how much, mm (logarithmic "
            "scale).</figcaption></figure>\n");
    }

    void addIslands() {
        const std::size_t count = at("/part/islands").size();
        if (count == 0)
            return;
        add("<h2>Islands</h2>\n<div class=\"wide\"><table><tr><th>Kind</th><th class=\"n\">Depth, mm</th>"
            "<th class=\"n\">Area, mm²</th><th class=\"n\">Volume, mm³</th><th class=\"n\">X</th>"
            "<th class=\"n\">Y</th><th class=\"n\">Z</th><th>Made by</th></tr>\n");
        for (std::size_t k = 0; k < std::min(count, kMostIslands); ++k) {
            const std::string of = fmt::format("/part/islands/{}", k);
            add("<tr><td>{}</td>", text(of + "/kind"));
            for (const auto& [key, decimals] :
                 {std::pair("/depthMm", 3), std::pair("/areaMm2", 2), std::pair("/volumeMm3", 2),
                  std::pair("/place/0", 3), std::pair("/place/1", 3), std::pair("/place/2", 3)})
                add("<td class=\"n\">{}</td>", number(of + key, decimals));
            if (has(of + "/line"))
                add("<td>line {}, T{}</td></tr>\n", number(of + "/line", 0), number(of + "/tool", 0));
            else
                add("<td>{}</td></tr>\n",
                    at(of).value("uncut", false) ? "reached by no tool" : "not determined");
        }
        add("</table></div>\n");
        if (count > kMostIslands)
            add("<p class=\"soft\">The deepest {} of {} are listed; the JSON has all.</p>\n", kMostIslands,
                count);
    }

    void addFindings() {
        add("<h2>Findings</h2>\n");
        const std::size_t count = at("/findings").size();
        if (count == 0)
            return add("<p>Nothing was found.</p>\n");
        add("<div class=\"wide\"><table><tr><th>Severity</th><th "
            "class=\"n\">Line</th><th>Finding</th><th>Tool</th>"
            "<th>Waived</th></tr>\n");
        for (std::size_t k = 0; k < count; ++k) {
            const std::string of = fmt::format("/findings/{}", k);
            const std::string severity = text(of + "/severity");
            add("<tr><td class=\"{}\">{}</td><td class=\"n\">{}</td><td>{}<br><span class=\"soft\">{} "
                "[{}]</span></td>"
                "<td>{}</td><td>{}</td></tr>\n",
                severity, severity, has(of + "/line") ? number(of + "/line", 0) : std::string(),
                text(of + "/message"), text(of + "/hint"), text(of + "/id"),
                has(of + "/tool") ? fmt::format("T{}", number(of + "/tool", 0)) : std::string(),
                has(of + "/waived") ? text(of + "/waived/owner") + ": " + text(of + "/waived/reason")
                                    : std::string());
        }
        add("</table></div>\n");
    }

    void addNotChecked() {
        const std::size_t count = at("/notChecked").size();
        if (count == 0)
            return;
        add("<h2>Not checked</h2>\n<table><tr><th>What</th><th>Accepted</th></tr>\n");
        for (std::size_t k = 0; k < count; ++k) {
            const std::string of = fmt::format("/notChecked/{}", k);
            const std::string reason = text(of + "/reason");
            add("<tr><td>{}</td><td>{}{}{}</td></tr>\n", text(of + "/title"),
                at(of + "/accepted").get<bool>() ? "yes" : "no", reason.empty() ? "" : ": ", reason);
        }
        add("</table>\n");
    }

    void addTools() {
        if (!has("/run/tools"))
            return;
        add("<h2>Tools and cycle time</h2>\n<p>Cycle time {}: feed {}, rapid {}, dwell {}, tool changes "
            "{}{}</p>\n",
            clock("/run/machineSeconds/total"), clock("/run/machineSeconds/feed"),
            clock("/run/machineSeconds/rapid"), clock("/run/machineSeconds/dwell"),
            clock("/run/machineSeconds/toolChange"),
            at("/run/machineSeconds/assumed").get<bool>() ? " (default machine values)." : ".");
        add("<div class=\"wide\"><table><tr><th>Tool</th><th>Cutter</th><th class=\"n\">Feed</th><th "
            "class=\"n\">Rapid</th>"
            "<th class=\"n\">Path at feed, mm</th><th class=\"n\">Lowest Z</th></tr>\n");
        for (std::size_t k = 0; k < at("/run/tools").size(); ++k) {
            const std::string of = fmt::format("/run/tools/{}", k);
            add("<tr><td>T{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
                "class=\"n\">{}</td>"
                "<td class=\"n\">{}</td></tr>\n",
                number(of + "/tool", 0), text(of + "/cutter"), clock(of + "/feed"), clock(of + "/rapid"),
                number(of + "/feedLengthMm", 1),
                has(of + "/lowestZ") ? number(of + "/lowestZ", 3) : std::string());
        }
        add("</table></div>\n");
    }

    void addRun() {
        if (!has("/run/stock"))
            return;
        add("<h2>Stock and grid</h2>\n<table>\n");
        add("<tr><th>Stock</th><td>{} × {} × {} mm, least corner X{} Y{}, top Z{}</td></tr>\n",
            number("/run/stock/width", 3), number("/run/stock/depth", 3), number("/run/stock/height", 3),
            number("/run/stock/minX", 3), number("/run/stock/minY", 3), number("/run/stock/topZ", 3));
        add("<tr><th>Grid</th><td>{} × {} points, {} × {} mm apart</td></tr>\n", number("/run/grid/nx", 0),
            number("/run/grid/ny", 0), number("/run/grid/hx", 4), number("/run/grid/hy", 4));
        add("<tr><th>Removed</th><td>{} mm³</td></tr>\n</table>\n", number("/run/removedMm3", 1));
    }

    void addInputs() {
        add("<h2>Inputs</h2>\n<table><tr><th>File</th><th>SHA-256</th></tr>\n");
        for (std::size_t k = 0; k < at("/inputs").size(); ++k) {
            const std::string of = fmt::format("/inputs/{}", k);
            add("<tr><td>{}</td><td class=\"hash\">{}</td></tr>\n", text(of + "/file"), text(of + "/sha256"));
        }
        add("</table>\n<p class=\"soft\">{}</p>\n", escaped(m_head.generator));
    }

    void end() {
        add("</main>\n");
        if (!m_pictures.glb.empty() && !threeScript().empty()) {
            add("<script id=\"glb\" type=\"application/octet-stream;base64\">{}</script>\n"
                "<!-- three.js, OrbitControls and GLTFLoader: © three.js authors, MIT licence: permission is "
                "hereby "
                "granted, free of charge, to any person obtaining a copy of this software and associated "
                "documentation files, to deal in the software without restriction, provided that this notice "
                "is "
                "included in all copies. The software is provided as is, without warranty of any kind. -->\n",
                base64Of(m_pictures.glb));
            for (const std::string_view script :
                 {threeScript(), orbitScript(), loaderScript(), viewerScript()})
                add("<script>{}</script>\n", script);
        }
        add("</body></html>\n");
    }

    const ordered_json& m_checked;
    const ReportHead& m_head;
    const ReportPictures& m_pictures;
    std::string m_html;
};

} // namespace

std::string reportPage(const ordered_json& checked, const ReportHead& head, const ReportPictures& pictures) {
    return Page(checked, head, pictures).take();
}

} // namespace proveout

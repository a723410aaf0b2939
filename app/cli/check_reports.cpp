// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_reports.h"

#include <fmt/format.h>
#include <string_view>
#include <utility>

#include "app/cli/command.h"
#include "core/base/diagnostic.h"

namespace proveout::cli {

namespace {

using nlohmann::ordered_json;

std::string sarifLevel(const std::string& severity) {
    return severity == name(Severity::fault) ? name(Severity::error) : severity;
}

/// A URI reference (RFC 3986) to a file: everything but letters, digits and some marks is a percent code.
std::string uriOf(const std::string& file) {
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
    std::string uri = file.starts_with('/') ? "file://" : "";
    for (const char letter : file) {
        if (kPlain.find(letter) != std::string_view::npos)
            uri += letter;
        else
            uri += fmt::format("%{:02X}", static_cast<unsigned char>(letter));
    }
    return uri;
}

/// Text as XML 1.0 allows it: no control characters, and UTF-8.
std::string xmlOf(std::string_view text) {
    const std::string whole =
        ordered_json(text).dump(-1, ' ', false, ordered_json::error_handler_t::replace); // replaces bad UTF-8
    const std::string valid = ordered_json::parse(whole).get<std::string>();
    std::string xml;
    for (const char letter : valid) {
        switch (letter) {
        case '&':
            xml += "&amp;";
            break;
        case '<':
            xml += "&lt;";
            break;
        case '>':
            xml += "&gt;";
            break;
        case '"':
            xml += "&quot;";
            break;
        default:
            xml += static_cast<unsigned char>(letter) < ' ' && letter != '\n' ? ' ' : letter;
        }
    }
    return xml;
}

std::string textOf(const ordered_json& object, const char* key) {
    return object.value(key, std::string());
}

/// `FILE:LINE: severity: sentence [id]`
std::string lineOf(const ordered_json& finding) {
    const int line = finding.value("line", 0);
    return fmt::format("{}:{} {}: {} [{}]\n", textOf(finding, "file"),
                       line > 0 ? fmt::format("{}:", line) : "", textOf(finding, "severity"),
                       textOf(finding, "message"), textOf(finding, "id"));
}

} // namespace

void SarifReport::add(const ordered_json& checked) {
    for (const ordered_json& finding : checked["findings"]) {
        const std::string id = textOf(finding, "id");
        if (m_known.insert(id).second)
            m_rules.push_back({{"id", id}, {"shortDescription", {{"text", textOf(finding, "title")}}}});
        ordered_json place{{"artifactLocation", {{"uri", uriOf(textOf(finding, "file"))}}}};
        const int line = finding.value("line", 0);
        if (line > 0) {
            place["region"] = {{"startLine", line}};
            if (finding.value("lastLine", line) > line)
                place["region"]["endLine"] = finding["lastLine"];
        }
        ordered_json result{{"ruleId", id},
                            {"level", sarifLevel(textOf(finding, "severity"))},
                            {"message", {{"text", textOf(finding, "message")}}},
                            {"locations", ordered_json::array({{{"physicalLocation", std::move(place)}}})}};
        if (finding.value("count", 1) > 1)
            result["occurrenceCount"] = finding["count"];
        if (const auto waived = finding.find("waived"); waived != finding.end())
            result["suppressions"] =
                ordered_json::array({{{"kind", "external"},
                                      {"justification", fmt::format("{}: {}", textOf(*waived, "owner"),
                                                                    textOf(*waived, "reason"))}}});
        m_results.push_back(std::move(result));
    }
}

std::string SarifReport::text() const {
    const ordered_json report{
        {"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
        {"version", "2.1.0"},
        {"runs",
         ordered_json::array(
             {{{"tool",
                {{"driver", {{"name", "Proveout"}, {"version", PROVEOUT_VERSION}, {"rules", m_rules}}}}},
               {"columnKind", "utf16CodeUnits"},
               {"results", m_results}}})}};
    return report.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

void JunitReport::add(const ordered_json& checked) {
    const double seconds = checked.value("seconds", 0.0);
    ++m_tests;
    m_seconds += seconds;
    std::string sentences;
    for (const ordered_json& finding : checked["findings"])
        if (!finding.contains("waived"))
            sentences += lineOf(finding);
    for (const ordered_json& entry : checked["notChecked"])
        if (!entry.value("accepted", false))
            sentences += fmt::format("not checked: {} [{}]\n", textOf(entry, "title"), textOf(entry, "id"));
    m_cases += fmt::format("  <testcase classname=\"proveout.check\" name=\"{}\" time=\"{:.3f}\">",
                           xmlOf(textOf(checked, "program")), seconds);
    const auto exitCode = static_cast<ExitCode>(checked.value("exitCode", 0));
    if (exitCode != ExitCode::done) {
        const bool faults = exitCode == ExitCode::faults;
        ++(faults ? m_failures : m_errors);
        m_cases += fmt::format("\n    <{0} message=\"{1}\">{2}</{0}>\n  ", faults ? "failure" : "error",
                               exitCode == ExitCode::unusable ? "unusable" : textOf(checked, "verdict"),
                               xmlOf(sentences));
    }
    m_cases += "</testcase>\n";
}

std::string JunitReport::text() const {
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<testsuite name=\"proveout check\" tests=\"{}\" failures=\"{}\" errors=\"{}\" "
                       "time=\"{:.3f}\">\n{}</testsuite>\n",
                       m_tests, m_failures, m_errors, m_seconds, m_cases);
}

} // namespace proveout::cli

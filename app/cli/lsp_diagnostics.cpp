// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lsp_diagnostics.h"

#include <algorithm>
#include <fmt/format.h>

#include "core/nc/text/characters.h"

namespace proveout::cli {

namespace {

constexpr int kHint = 4; ///< the least severity

int lspSeverity(Severity severity) {
    switch (severity) {
    case Severity::fault:
    case Severity::error:
        return 1;
    case Severity::warning:
        return 2;
    case Severity::note:
        break;
    }
    return 3;
}

nlohmann::json startOfText() {
    const nlohmann::json start{{"line", 0}, {"character", 0}};
    return {{"start", start}, {"end", start}};
}

std::size_t lastLineOf(const NcText& text, int line) {
    return std::min(static_cast<std::size_t>(std::max(line, 1)) - 1, text.lineCount() - 1);
}

/// All of a line but the blanks before it.
nlohmann::json rangeOfLine(const LspSubject& subject, int line) {
    const NcText& text = subject.document.text();
    const std::size_t index = lastLineOf(text, line);
    const std::string_view content = text.line(index);
    return rangeInLine(text, index, skipBlanks(content, 0), content.size(), subject.encoding);
}

nlohmann::json rangeOf(const TextRange& where, const LspSubject& subject) {
    if (where.line <= 0)
        return startOfText();
    if (where.column <= 0)
        return rangeOfLine(subject, where.line);
    const NcText& text = subject.document.text();
    const std::size_t line = lastLineOf(text, where.line);
    const std::size_t mark = where.line == 1 ? subject.document.markBytes() : 0;
    const std::size_t begin = mark + static_cast<std::size_t>(where.column) - 1;
    return rangeInLine(text, line, begin, begin + static_cast<std::size_t>(std::max(where.length, 1)),
                       subject.encoding);
}

/// The place of a finding in another file.
nlohmann::json placeElsewhere(const Diagnostic& diagnostic) {
    const int line = std::max(diagnostic.where.line, 1) - 1;
    const nlohmann::json start{{"line", line}, {"character", 0}};
    return {{"uri", uriOfFile(diagnostic.file)}, {"range", {{"start", start}, {"end", start}}}};
}

nlohmann::json diagnosticOf(const CheckFinding& finding, const LspSubject& subject) {
    const Diagnostic& diagnostic = finding.diagnostic;
    const bool elsewhere = !diagnostic.file.empty() && diagnostic.file != subject.file;
    std::string text = message(diagnostic);
    auto related = nlohmann::json::array();
    if (elsewhere) {
        const std::string name = std::filesystem::path(diagnostic.file).filename().string();
        text = fmt::format("{}:{}: {}", name, std::max(diagnostic.where.line, 1), text);
        related.push_back({{"location", placeElsewhere(diagnostic)}, {"message", message(diagnostic)}});
    }
    if (*diagnostic.hint != '\0')
        text += "\n" + hintText(diagnostic);
    if (finding.waived)
        text += fmt::format("\nWaived by {}: {}", finding.waived->owner, finding.waived->reason);
    if (finding.count > 1) {
        text += fmt::format("\n{} blocks, the last one in line {}.", finding.count, finding.lastLine);
        related.push_back(
            {{"location", {{"uri", subject.uri}, {"range", rangeOfLine(subject, finding.lastLine)}}},
             {"message", fmt::format("Last of {} blocks", finding.count)}});
    }
    nlohmann::json out{{"range", elsewhere ? startOfText() : rangeOf(diagnostic.where, subject)},
                       {"severity", finding.waived ? kHint : lspSeverity(diagnostic.severity)},
                       {"code", diagnostic.id},
                       {"source", "proveout"},
                       {"message", std::move(text)}};
    if (subject.relatedInformation && !related.empty())
        out["relatedInformation"] = std::move(related);
    return out;
}

} // namespace

nlohmann::json diagnosticsOf(std::span<const CheckFinding> findings, const LspSubject& subject) {
    auto out = nlohmann::json::array();
    for (const CheckFinding& finding : findings)
        out.push_back(diagnosticOf(finding, subject));
    return out;
}

} // namespace proveout::cli

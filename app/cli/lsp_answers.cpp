// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lsp_answers.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/nc/codes/word_help.h"
#include "core/nc/flow/jump_target.h"
#include "core/nc/flow/outline.h"
#include "core/simulation/setup/tool_proposals.h"

namespace proveout::cli {

namespace {

/// The line of a question and the byte in it; nothing if there is no such line.
struct AskedPlace {
    std::string_view line;
    std::size_t byte;
};

std::optional<AskedPlace> placeOf(const LspQuestion& question) {
    const NcText& text = question.document.text();
    if (question.line >= text.lineCount())
        return {};
    const std::string_view line = text.line(question.line);
    return AskedPlace{line, byteOf(line, question.character, question.encoding)};
}

std::string escapedMarkdown(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (std::string_view("\\`*_{}[]<>()#+-.!|~&").find(c) != std::string_view::npos)
            out.push_back('\\');
        out.push_back(c);
    }
    return out;
}

std::string helpText(const std::vector<HelpSentence>& sentences, bool markdown) {
    std::string out;
    for (const HelpSentence& sentence : sentences) {
        std::vector<std::string> arguments;
        for (const Argument& argument : sentence.arguments) {
            const bool word = out.empty() && arguments.empty();
            arguments.push_back(!markdown ? argument.text()
                                : word    ? fmt::format("`{}`", argument.text())
                                          : escapedMarkdown(argument.text()));
        }
        out += (out.empty() ? "" : markdown ? "  \n" : "\n") + fillIn(sentence.text, arguments);
    }
    return out;
}

nlohmann::json locationOf(const std::string& uri, const NcText& text, const TextPlace& place,
                          PositionEncoding encoding) {
    return {{"uri", uri}, {"range", rangeInLine(text, place.line, place.begin, place.end, encoding)}};
}

/// The target in a file beside the program.
nlohmann::json definitionInFile(const LspQuestion& question, const JumpTarget& target) {
    const std::filesystem::path program = fileOfUri(question.uri);
    for (const std::string& name : filesOf(target, question.dialect)) {
        const std::filesystem::path file = program.parent_path() / name;
        std::error_code error;
        const bool beside = !program.empty() && name.find_first_of("/\\") == std::string::npos;
        if (!beside || !std::filesystem::is_regular_file(file, error))
            continue;
        const auto text = NcText::load(file);
        if (!text)
            return nullptr;
        const TextPlace place = findTarget(*text, 0, target, question.dialect).value_or(TextPlace());
        return locationOf(uriOfFile(file), *text, place, question.encoding);
    }
    return nullptr;
}

/// The numbers of SymbolKind, by SectionKind.
constexpr std::array kSymbolKinds{2 /* Module */, 12 /* Function */, 5 /* Class */, 6 /* Method */,
                                  20 /* Key */};

/// Builds the answer from the sections, which are in the order of a tree.
class SymbolList {
public:
    explicit SymbolList(const LspQuestion& question)
        : m_question(question), m_text(question.document.text()),
          m_sections(outlineOf(m_text, question.dialect)), m_tools(proposeTools(m_text)) {}

    nlohmann::json tree() {
        std::size_t next = 0;
        return childrenFrom(next, 0);
    }

    [[nodiscard]] nlohmann::json list() const {
        auto all = nlohmann::json::array();
        std::vector<std::string> within;
        for (const Section& section : m_sections) {
            within.resize(section.depth);
            nlohmann::json symbol{{"name", nameOf(section)},
                                  {"kind", kindOf(section)},
                                  {"location", {{"uri", m_question.uri}, {"range", rangeOf(section)}}}};
            if (!within.empty())
                symbol["containerName"] = within.back();
            within.push_back(nameOf(section));
            all.push_back(std::move(symbol));
        }
        return all;
    }

private:
    /// There are at most four levels but for subprograms, which programs do not nest deeply.
    nlohmann::json childrenFrom(std::size_t& next, std::size_t depth) {
        constexpr std::size_t kDeepest = 50;
        auto children = nlohmann::json::array();
        while (next < m_sections.size() && m_sections[next].depth >= depth) {
            const Section& section = m_sections[next++];
            nlohmann::json symbol{{"name", nameOf(section)},
                                  {"kind", kindOf(section)},
                                  {"range", rangeOf(section)},
                                  {"selectionRange", rangeInLine(m_text, section.line, section.begin,
                                                                 section.end, m_question.encoding)}};
            if (const std::string detail = detailOf(section); !detail.empty())
                symbol["detail"] = detail;
            if (depth < kDeepest)
                if (auto inner = childrenFrom(next, depth + 1); !inner.empty())
                    symbol["children"] = std::move(inner);
            children.push_back(std::move(symbol));
        }
        return children;
    }

    static int kindOf(const Section& section) { return kSymbolKinds[static_cast<std::size_t>(section.kind)]; }

    /// Editors refuse an empty name.
    static std::string nameOf(const Section& section) { return section.name.empty() ? "?" : section.name; }

    [[nodiscard]] std::string detailOf(const Section& section) const {
        const ToolOrigin* origin = section.kind == SectionKind::tool && section.tool >= 0
                                       ? m_tools.tools.unconfirmedOrigin(section.tool)
                                       : nullptr;
        return origin != nullptr && !origin->comment.empty() ? origin->comment : section.comment;
    }

    [[nodiscard]] nlohmann::json rangeOf(const Section& section) const {
        nlohmann::json range = rangeInLine(m_text, section.line, 0, 0, m_question.encoding);
        const std::size_t last = std::min(section.lastLine, m_text.lineCount() - 1);
        const std::size_t size = m_text.line(last).size();
        range["end"] = rangeInLine(m_text, last, size, size, m_question.encoding)["end"];
        return range;
    }

    const LspQuestion& m_question;
    const NcText& m_text;
    std::vector<Section> m_sections;
    ToolProposals m_tools;
};

} // namespace

nlohmann::json hoverIn(const LspQuestion& question, bool markdown) {
    const auto place = placeOf(question);
    const auto help = place ? helpAt(place->line, place->byte, question.dialect) : std::nullopt;
    if (!help)
        return nullptr;
    return {{"contents",
             {{"kind", markdown ? "markdown" : "plaintext"},
              {"value", helpText(helpSentences(*help, question.dialect), markdown)}}},
            {"range", rangeInLine(question.document.text(), question.line, help->begin, help->end,
                                  question.encoding)}};
}

nlohmann::json definitionIn(const LspQuestion& question) {
    const auto place = placeOf(question);
    const auto target = place ? jumpTargetAt(place->line, place->byte, question.dialect) : std::nullopt;
    if (!target)
        return nullptr;
    const NcText& text = question.document.text();
    if (const auto found = findTarget(text, question.line, *target, question.dialect))
        return locationOf(question.uri, text, *found, question.encoding);
    return definitionInFile(question, *target);
}

nlohmann::json symbolsIn(const LspQuestion& question, bool tree) {
    SymbolList symbols(question);
    return tree ? symbols.tree() : symbols.list();
}

} // namespace proveout::cli

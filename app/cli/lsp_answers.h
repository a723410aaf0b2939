// SPDX-License-Identifier: GPL-3.0-or-later
// What an editor asks about a text. Pure functions but for the files that definitionIn() looks for; any
// thread.
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json.hpp>

#include "app/cli/lsp_document.h"
#include "core/nc/text/dialect.h"

namespace proveout::cli {

/// A text, and how the editor wants answers.
struct LspQuestion {
    std::string uri;
    LspDocument document;
    DialectId dialect = DialectId::linuxcnc;
    PositionEncoding encoding = PositionEncoding::utf16;
    std::size_t line = 0; ///< the position, as the editor sent it
    std::size_t character = 0;
};

/// The meaning of the word there (Hover); null if there is no word.
[[nodiscard]] nlohmann::json hoverIn(const LspQuestion& question, bool markdown);
/// Where the jump, the call or the parameter there leads (Location); null if that is not known.
[[nodiscard]] nlohmann::json definitionIn(const LspQuestion& question);
/// The outline: a tree (DocumentSymbol), or a list (SymbolInformation).
[[nodiscard]] nlohmann::json symbolsIn(const LspQuestion& question, bool tree);

} // namespace proveout::cli

// SPDX-License-Identifier: GPL-3.0-or-later
// Findings in the form in which an editor shows them.
#pragma once

#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "app/cli/lsp_document.h"
#include "core/verification/check/check_report.h"

namespace proveout::cli {

/// What the findings are about, and how the editor wants them.
struct LspSubject {
    std::string uri;
    LspDocument document;
    std::string file; ///< as findings name it; they may also name none
    PositionEncoding encoding = PositionEncoding::utf16;
    bool relatedInformation = false; ///< the editor shows it
};

/// The array `diagnostics`, one per finding and in their order. A finding in another file is at the beginning
/// of the document.
[[nodiscard]] nlohmann::json diagnosticsOf(std::span<const CheckFinding> findings, const LspSubject& subject);

} // namespace proveout::cli

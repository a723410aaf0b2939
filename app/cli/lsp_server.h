// SPDX-License-Identifier: GPL-3.0-or-later
// A language server (LSP 3.17) on stdin and stdout.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/cli/lsp_analysis.h"
#include "app/cli/lsp_answers.h"
#include "app/cli/lsp_json.h"
#include "app/cli/lsp_transport.h"
#include "app/cli/lsp_worker.h"

namespace proveout::cli {

/// Answers one editor until it sends `exit` or closes the input. Hover is answered at once; what needs the
/// whole text, on threads.
class LspServer {
public:
    /// `options` must outlive it.
    explicit LspServer(const CheckOptions& options) : m_analysis(options, m_output) {}

    /// Returns 0 if the editor has sent `shutdown` before, otherwise 1, as the protocol demands.
    [[nodiscard]] int run();

private:
    using Json = nlohmann::json;
    struct Open {
        LspDocument document;
        std::optional<std::int64_t> version;
        std::shared_ptr<const KnownDialect> dialect;
    };
    enum class State : std::uint8_t { started, ready, shutDown, ended };

    void complain(const std::string& sentence);
    void handle(const Json& message);
    void request(const Json& id, const std::string& method, const Json& parameters);
    void notification(const std::string& method, const Json& parameters);

    void initialize(const Json& id, const Json& parameters);
    void open(const Json& parameters);
    void change(const Json& parameters);
    void save(const Json& parameters);
    void close(const Json& parameters);
    /// Answers with `answer` of the question, on a thread.
    void ask(const Json& id, const Json& parameters, bool atPosition,
             std::function<Json(const LspQuestion&)> answer);
    [[nodiscard]] LspQuestion questionOf(const Json& parameters, bool atPosition);
    void cancel(const Json& parameters);

    void reply(const Json& id, Json result);
    void refuse(const Json& id, LspError code, const std::string& sentence);

    LspOutput m_output;
    State m_state = State::started;
    bool m_wasShutDown = false;
    PositionEncoding m_encoding = PositionEncoding::utf16;
    bool m_markdown = false;
    bool m_symbolTree = false;
    std::map<std::string, Open> m_documents;
    LspAnalysis m_analysis;
    LspWorker m_questions;
};

} // namespace proveout::cli

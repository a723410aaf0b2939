// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lsp_server.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <unistd.h>
#include <utility>

#include "core/nc/codes/dialect_guess.h"

namespace proveout::cli {

namespace {

std::size_t readInput(char* bytes, std::size_t size) {
    while (true) {
        const ssize_t count = ::read(STDIN_FILENO, bytes, size);
        if (count >= 0)
            return static_cast<std::size_t>(count);
        if (errno != EINTR)
            return 0;
    }
}

/// A value within objects of capabilities; null if it is not there.
nlohmann::json within(const nlohmann::json& object, const char* pointer) {
    const nlohmann::json::json_pointer place(pointer);
    return object.contains(place) ? object[place] : nlohmann::json();
}

bool lists(const nlohmann::json& array, const char* value) {
    return array.is_array() && std::ranges::find(array, nlohmann::json(value)) != array.end();
}

const std::string& uriIn(const nlohmann::json& parameters) {
    return stringIn(objectIn(parameters, "textDocument"), "uri");
}

std::optional<std::int64_t> versionIn(const nlohmann::json& parameters) {
    const nlohmann::json version = within(parameters, "/textDocument/version");
    return version.is_number_integer() ? std::optional(version.get<std::int64_t>()) : std::nullopt;
}

} // namespace

int LspServer::run() {
    LspInput input(readInput, [this](const std::string& sentence) { complain(sentence); });
    while (m_state != State::ended && !m_output.failed()) {
        auto text = input.next();
        if (!text)
            break;
        try {
            const auto message = parseLspMessage(*std::move(text));
            if (message)
                handle(*message);
            else
                complain("A message is not JSON, or too large.");
        } catch (const std::exception& exception) {
            complain(fmt::format("A message was dropped: {}", exception.what()));
        }
    }
    return m_wasShutDown ? 0 : 1;
}

/// About bytes that are no message, so that there is nothing to answer.
void LspServer::complain(const std::string& sentence) {
    std::fputs(fmt::format("proveout-cli lsp: {}\n", sentence).c_str(), stderr);
    refuse(nullptr, LspError::parseError, sentence);
}

void LspServer::handle(const Json& message) {
    const bool request = message.is_object() && message.contains("id");
    const Json id = request ? message["id"] : Json();
    if (!message.is_object() || (request && !id.is_number_integer() && !id.is_string()))
        return refuse(nullptr, LspError::invalidRequest, "A message has no valid id.");
    if (!message.contains("method")) {
        if (!request)
            refuse(nullptr, LspError::invalidRequest, "A message has no method.");
        return; // the editor answers, but nothing was asked
    }
    const Json parameters = message.value("params", Json::object());
    try {
        const std::string& method = stringIn(message, "method");
        if (request)
            this->request(id, method, parameters);
        else
            notification(method, parameters);
    } catch (const InvalidParameter& error) {
        if (request)
            refuse(id, LspError::invalidParams, error.what());
        else
            complain(error.what());
    } catch (const std::exception& exception) {
        if (!request)
            throw;
        refuse(id, LspError::internalError, exception.what());
    }
}

void LspServer::request(const Json& id, const std::string& method, const Json& parameters) {
    if (m_state == State::shutDown)
        return refuse(id, LspError::invalidRequest, "The server was shut down.");
    if (method == "initialize")
        return initialize(id, parameters);
    if (m_state == State::started)
        return refuse(id, LspError::serverNotInitialized, "The server is not initialized.");
    if (method == "shutdown") {
        m_state = State::shutDown;
        m_wasShutDown = true;
        return reply(id, nullptr);
    }
    if (method == "textDocument/hover")
        return reply(id, hoverIn(questionOf(parameters, true), m_markdown));
    if (method == "textDocument/definition")
        return ask(id, parameters, true, definitionIn);
    if (method == "textDocument/documentSymbol")
        return ask(id, parameters, false,
                   [tree = m_symbolTree](const LspQuestion& question) { return symbolsIn(question, tree); });
    refuse(id, LspError::methodNotFound, fmt::format("There is no method {}.", method));
}

void LspServer::notification(const std::string& method, const Json& parameters) {
    if (method == "exit") {
        m_state = State::ended;
        return;
    }
    if (m_state != State::ready)
        return;
    if (method == "textDocument/didOpen")
        open(parameters);
    else if (method == "textDocument/didChange")
        change(parameters);
    else if (method == "textDocument/didSave")
        save(parameters);
    else if (method == "textDocument/didClose")
        close(parameters);
    else if (method == "$/cancelRequest")
        cancel(parameters);
}

void LspServer::initialize(const Json& id, const Json& parameters) {
    if (m_state != State::started)
        return refuse(id, LspError::invalidRequest, "The server is initialized already.");
    const Json capabilities = within(parameters, "/capabilities");
    const bool utf8 = lists(within(capabilities, "/general/positionEncodings"), "utf-8");
    m_encoding = utf8 ? PositionEncoding::utf8 : PositionEncoding::utf16;
    m_markdown = lists(within(capabilities, "/textDocument/hover/contentFormat"), "markdown");
    m_symbolTree =
        within(capabilities, "/textDocument/documentSymbol/hierarchicalDocumentSymbolSupport") == true;
    m_analysis.setForm(m_encoding,
                       within(capabilities, "/textDocument/publishDiagnostics/relatedInformation") == true);
    m_state = State::ready;
    constexpr int kIncremental = 2;
    reply(id, {{"capabilities",
                {{"positionEncoding", utf8 ? "utf-8" : "utf-16"},
                 {"textDocumentSync",
                  {{"openClose", true}, {"change", kIncremental}, {"save", {{"includeText", false}}}}},
                 {"hoverProvider", true},
                 {"definitionProvider", true},
                 {"documentSymbolProvider", true}}},
               {"serverInfo", {{"name", "proveout"}, {"version", PROVEOUT_VERSION}}}});
}

void LspServer::open(const Json& parameters) {
    const std::string& uri = uriIn(parameters);
    const std::string& text = stringIn(objectIn(parameters, "textDocument"), "text");
    Open opened{LspDocument(text, m_encoding), versionIn(parameters), {}};
    opened.dialect = m_analysis.judge(uri, opened.document, opened.version, LspAnalysis::Reason::opened);
    m_documents[uri] = std::move(opened);
}

void LspServer::change(const Json& parameters) {
    const auto found = m_documents.find(uriIn(parameters));
    if (found == m_documents.end() || !parameters.contains("contentChanges") ||
        !parameters["contentChanges"].is_array())
        throw InvalidParameter("The document is not open, or there are no changes.");
    Open& opened = found->second;
    for (const Json& change : parameters["contentChanges"])
        opened.document.change(change);
    opened.version = versionIn(parameters);
    m_analysis.judge(found->first, opened.document, opened.version, LspAnalysis::Reason::changed);
}

void LspServer::save(const Json& parameters) {
    const auto found = m_documents.find(uriIn(parameters));
    if (found != m_documents.end())
        m_analysis.judge(found->first, found->second.document, found->second.version,
                         LspAnalysis::Reason::saved);
}

void LspServer::close(const Json& parameters) {
    const std::string& uri = uriIn(parameters);
    m_documents.erase(uri);
    m_analysis.close(uri);
}

LspQuestion LspServer::questionOf(const Json& parameters, bool atPosition) {
    const auto found = m_documents.find(uriIn(parameters));
    if (found == m_documents.end())
        throw InvalidParameter("The document is not open.");
    const Open& opened = found->second;
    LspQuestion question{found->first, opened.document, {}, m_encoding};
    const auto known = opened.dialect->get();
    question.dialect = known ? *known : guessDialect(opened.document.text()).dialect;
    if (atPosition) {
        const Json& position = objectIn(parameters, "position");
        question.line = indexIn(position, "line");
        question.character = indexIn(position, "character");
    }
    return question;
}

void LspServer::ask(const Json& id, const Json& parameters, bool atPosition,
                    std::function<Json(const LspQuestion&)> answer) {
    m_questions.submit(id.dump(), std::chrono::milliseconds(0),
                       [this, id, question = questionOf(parameters, atPosition),
                        answer = std::move(answer)](const std::stop_token& stop) {
                           try {
                               Json result = answer(question);
                               if (stop.stop_requested())
                                   return refuse(id, LspError::requestCancelled,
                                                 "The request was cancelled.");
                               reply(id, std::move(result));
                           } catch (const std::exception& exception) {
                               refuse(id, LspError::internalError, exception.what());
                           }
                       });
}

void LspServer::cancel(const Json& parameters) {
    const Json id = within(parameters, "/id");
    if (m_questions.cancel(id.dump()))
        refuse(id, LspError::requestCancelled, "The request was cancelled.");
}

void LspServer::reply(const Json& id, Json result) {
    m_output.send({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

void LspServer::refuse(const Json& id, LspError code, const std::string& sentence) {
    m_output.send({{"jsonrpc", "2.0"},
                   {"id", id},
                   {"error", {{"code", static_cast<int>(code)}, {"message", sentence}}}});
}

} // namespace proveout::cli

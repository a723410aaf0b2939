// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/lsp_client.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <sys/wait.h>
#include <unistd.h>

namespace proveout {

namespace {

constexpr unsigned kPatienceSeconds = 120;

} // namespace

LspClient::LspClient(const std::string& arguments) {
    std::array<int, 2> in{};
    std::array<int, 2> out{};
    if (::pipe(in.data()) != 0 || ::pipe(out.data()) != 0)
        std::abort();
    std::signal(SIGPIPE, SIG_IGN);
    m_pid = ::fork();
    if (m_pid == 0) {
        ::dup2(in[0], STDIN_FILENO);
        ::dup2(out[1], STDOUT_FILENO);
        for (const int end : {in[0], in[1], out[0], out[1]})
            ::close(end);
        ::alarm(kPatienceSeconds); // inherited by the server
        const std::string line = "exec " PROVEOUT_CLI " lsp " + arguments + " 2>/dev/null";
        ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
        ::_exit(127);
    }
    ::close(in[0]);
    ::close(out[1]);
    m_to = ::fdopen(in[1], "w");
    m_from = ::fdopen(out[0], "r");
}

LspClient::~LspClient() {
    if (m_pid >= 0)
        finish();
    std::fclose(m_from);
}

void LspClient::sendBytes(const std::string& bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), m_to);
    std::fflush(m_to);
}

void LspClient::sendText(const std::string& json) {
    sendBytes("Content-Length: " + std::to_string(json.size()) + "\r\n\r\n" + json);
}

int LspClient::request(const std::string& method, const Json& parameters) {
    sendText(Json{{"jsonrpc", "2.0"}, {"id", ++m_lastId}, {"method", method}, {"params", parameters}}.dump());
    return m_lastId;
}

void LspClient::notify(const std::string& method, const Json& parameters) {
    sendText(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", parameters}}.dump());
}

LspClient::Json LspClient::next() {
    std::size_t length = 0;
    if (std::fscanf(m_from, "Content-Length: %zu\r\n\r\n", &length) != 1) // NOLINT(cert-err34-c)
        return nullptr;
    std::string text(length, '\0');
    if (std::fread(text.data(), 1, length, m_from) != length)
        return nullptr;
    return Json::parse(text, nullptr, false);
}

LspClient::Json LspClient::until(const std::function<bool(const Json&)>& fits) {
    Json message = next();
    while (!message.is_null() && !fits(message))
        message = next();
    return message;
}

LspClient::Json LspClient::answer(int id) {
    return until([&](const Json& message) { return message.contains("id") && message["id"] == id; });
}

LspClient::Json LspClient::initialize(const Json& capabilities) {
    const Json answer = ask("initialize", {{"processId", nullptr}, {"capabilities", capabilities}});
    notify("initialized", Json::object());
    return answer.is_object() ? answer["result"]["capabilities"] : Json();
}

void LspClient::open(const std::string& uri, const std::string& text, int version) {
    notify("textDocument/didOpen",
           {{"textDocument", {{"uri", uri}, {"languageId", "nc"}, {"version", version}, {"text", text}}}});
}

void LspClient::change(const std::string& uri, int version, const Json& changes) {
    notify("textDocument/didChange",
           {{"textDocument", {{"uri", uri}, {"version", version}}}, {"contentChanges", changes}});
}

LspClient::Json LspClient::diagnostics(int version) {
    const Json message = until([&](const Json& one) {
        return one.value("method", "") == "textDocument/publishDiagnostics" &&
               one["params"].value("version", -1) == version;
    });
    return message.is_null() ? message : message["params"]["diagnostics"];
}

int LspClient::finish() {
    std::fclose(m_to);
    while (!next().is_null()) {
    }
    int status = 0;
    ::waitpid(m_pid, &status, 0);
    m_pid = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace proveout
